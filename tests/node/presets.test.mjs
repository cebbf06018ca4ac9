// What docs/couplings.md says about the presets of the model that the page opens with, measured on that model.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { coupledInfo } from "./package.mjs";

/**
 * @typedef {"swing" | "period" | "locking"} Measure
 * @typedef {{ source: string, target: string, factor: number }} Change
 * @typedef {{ id: string, reading: import("vcgpdm").Reading, couplings: Change[] }} Preset
 * @typedef {{ lower?: Ranges, upper?: Ranges, still?: string[], state: string }} Effect
 * @typedef {Partial<Record<Measure, [number, number]>>} Ranges
 */

const SECONDS = 20;
/** Until then a motion finds its new pace. */
const SETTLED = 5;

/**
 * The effect of each preset: least and largest swing and period as multiples of the learned ones, and the
 * locking; the parts that keep one pose; the health.
 * @type {Record<string, Effect>}
 */
const EFFECTS = {
  "as-learned": { upper: { swing: [0.95, 1.05], locking: [0.95, 1] }, state: "moves-on" },
  "arms-go": {
    lower: { swing: [0.9, 1.1] },
    upper: { swing: [0.7, 1], locking: [0, 0.3], period: [1.15, 1.5] },
    state: "moves-on",
  },
  // The arms do not hang: they keep the mean pose.
  "arms-hang": { lower: { swing: [0.9, 1.1] }, still: ["upper"], state: "moves-on" },
  "arms-follow": { upper: { swing: [0.9, 1.1], locking: [0.95, 1] }, state: "moves-on" },
  "arms-lead": {
    lower: { swing: [0.9, 1], period: [1.1, 1.3] },
    upper: { locking: [0.95, 1] },
    state: "moves-on",
  },
  "untrained-advice": { lower: { swing: [0.6, 0.9], period: [1.05, 1.3] }, state: "moves-on" },
  // The figure goes on at 1.2 m/s, so that it does not stand.
  "legs-lost": { lower: { swing: [0, 0.05] }, still: ["lower", "upper"], state: "keeps-one-pose" },
};

/** @type {Preset[]} */
const presets = JSON.parse(readFileSync(at("www/first/presets.json"), "utf8"));
// As it is sent, with fewer digits.
const text = readFileSync(at("www/public/first/model.json"), "utf8");

const vcgpdm = builtPackage();
/** @type {import("vcgpdm").Model} */
let model;
/** @type {import("vcgpdm").CoupledModelInfo} */
let info;
/** @type {import("vcgpdm").Measures} */
let learned;
const frames = (/** @type {number} */ seconds) => Math.round(seconds / info.frameTime);

before(async () => {
  model = vcgpdm.Model.fromJson(text);
  info = coupledInfo(model);
  learned = roll(model, "as-learned", null).measures(frames(SETTLED));
});

function roll(
  /** @type {import("vcgpdm").Model} */ model,
  /** @type {import("vcgpdm").Reading} */ reading,
  /** @type {number[][] | null} */ alpha,
) {
  return model.rollout({ frames: frames(SECONDS), sequence: 0, alpha, reading });
}

function place(/** @type {string | undefined} */ name) {
  const part = info.parts.findIndex((part) => part.name === name);
  assert.ok(part >= 0, `a part ${name}`);
  return part;
}

/** The learned couplings with those of the preset changed. */
function couplings(/** @type {Preset} */ { couplings }) {
  const alpha = info.alpha.map((row) => [...row]);
  for (const { source, target, factor } of couplings) {
    const row = alpha[place(source)];
    assert.ok(row);
    row[place(target)] = (row[place(target)] ?? 0) * factor;
  }
  return alpha;
}

describe("a preset of the first model has the effect of the documentation:", () => {
  for (const preset of presets)
    it(preset.id, () => {
      const effect = EFFECTS[preset.id];
      assert.ok(effect);
      const rollout = roll(model, preset.reading, couplings(preset));
      const measures = rollout.measures(frames(SETTLED));
      const { state, parts } = rollout.health();
      assert.equal(state, effect.state);
      for (const [name, ranges] of Object.entries({ lower: effect.lower, upper: effect.upper }))
        for (const [key, [least, largest]] of Object.entries(ranges ?? {})) {
          const measure = /** @type {Measure} */ (key);
          const now = Number(measures.parts[place(name)]?.[measure]);
          const before = measure === "locking" ? 1 : Number(learned.parts[place(name)]?.[measure]);
          const found = now / before;
          assert.ok(
            found >= least && found <= largest,
            `${name}, ${measure}: ${least} to ${largest}, found ${found}`,
          );
        }
      const still = info.parts.flatMap(({ name }, part) => (parts[part]?.stillFrom == null ? [] : [name]));
      assert.deepEqual(still, effect.still ?? []);
    });
});

describe("arms that were let go", () => {
  it("are back in step soon after the legs are heard again, whenever that is", () => {
    const preset = presets.find(({ id }) => id === "arms-go");
    assert.ok(preset);
    const apart = roll(model, preset.reading, couplings(preset));
    // For as long as the arms need to be early and late by all shares of a cycle.
    for (let seconds = 5; seconds <= 10.25; seconds += 0.25) {
      const document = JSON.parse(text);
      // The model begins where the other motion is at that time.
      const end = frames(seconds);
      document.sequences[0].start = info.parts.map(({ latent }, part) => {
        const path = apart.latents(part);
        return Array.from({ length: info.order }, (_, k) =>
          Array.from(path.subarray((end - info.order + k) * latent, (end - info.order + k + 1) * latent)),
        );
      });
      const again = roll(vcgpdm.Model.fromJson(JSON.stringify(document)), "re-inferred", null);
      const { limbs } = again.measures(frames(2));
      for (const { limb, locking, ahead } of limbs) {
        const usual = learned.limbs.find((other) => other.limb === limb)?.ahead ?? Number.NaN;
        const late = Math.abs(Number(ahead) - usual);
        assert.ok(
          Number(locking) > 0.95 && late < 0.03,
          `${limb} from ${seconds} s: ${locking}, ${ahead} for ${usual}`,
        );
      }
    }
  });
});
