// What the page says about the presets of the model that it opens with, measured on that model.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, describe, it } from "node:test";
import { at } from "../../scripts/run.mjs";
import { coupledInfo, installPackage } from "./package.mjs";

/**
 * @typedef {{ what: string, part?: string, side?: string, from?: number, to?: number, is?: string }} Claim
 * @typedef {{ source: string, target: string, factor: number }} Change
 * @typedef {{ id: string, reading: import("vcgpdm").Reading, couplings: Change[], holds: Claim[] }} Preset
 */

const SECONDS = 20;
/** Until then a motion finds its new pace. */
const SETTLED = 5;

/** @type {Preset[]} */
const presets = JSON.parse(readFileSync(at("www/first/presets.json"), "utf8"));
// As it is sent, with fewer digits.
const text = readFileSync(at("www/public/first/model.json"), "utf8");

/** @type {Awaited<ReturnType<typeof installPackage>>} */
let installed;
/** @type {import("vcgpdm").Model} */
let model;
/** @type {import("vcgpdm").CoupledModelInfo} */
let info;
/** @type {import("vcgpdm").Measures} */
let learned;
before(async () => {
  installed = await installPackage();
  model = installed.vcgpdm.Model.fromJson(text);
  info = coupledInfo(model);
  learned = roll(model, "as-learned", null).measures(frames(SETTLED));
});
after(() => installed?.remove());

const frames = (/** @type {number} */ seconds) => Math.round(seconds / info.frameTime);

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

/** The number that a claim is about; swing, period and speed as a multiple of the learned ones. */
function measured(/** @type {Claim} */ { what, part }, /** @type {import("vcgpdm").Measures} */ measures) {
  const of = (/** @type {import("vcgpdm").Measures} */ { parts }) => parts[place(part)];
  const share = (
    /** @type {number | null | undefined} */ now,
    /** @type {number | null | undefined} */ before,
  ) => Number(now ?? Number.NaN) / Number(before ?? Number.NaN);
  switch (what) {
    case "swing":
      return share(of(measures)?.swing, of(learned)?.swing);
    case "period":
      return share(of(measures)?.period, of(learned)?.period);
    case "locking":
      return of(measures)?.locking ?? Number.NaN;
    case "walkingSpeed":
      return share(measures.walkingSpeed, learned.walkingSpeed);
    default:
      throw new Error(`no measure ${what}`);
  }
}

/** The least and the largest bend of an elbow after it has settled, in degrees; 0: the arm is straight. */
function elbow(/** @type {string | undefined} */ side, /** @type {import("vcgpdm").Rollout} */ rollout) {
  const positions = rollout.positions();
  const { nodes } = info.figure;
  const places = ["Arm", "ForeArm", "Hand"].map((name) =>
    nodes.findIndex(({ joint, endSite }) => !endSite && info.joints[joint]?.name === `${side}${name}`),
  );
  assert.ok(
    places.every((node) => node >= 0),
    `an arm ${side}`,
  );
  const bends = [];
  for (let frame = frames(SETTLED); frame < frames(SECONDS); frame++) {
    const [shoulder, elbow, hand] = places.map((node) => 3 * (frame * nodes.length + node));
    const line = (/** @type {number} */ from, /** @type {number} */ to) =>
      [0, 1, 2].map((k) => (positions[to + k] ?? 0) - (positions[from + k] ?? 0));
    const [upper, lower] = [line(shoulder ?? 0, elbow ?? 0), line(elbow ?? 0, hand ?? 0)];
    const dot = upper.reduce((sum, value, k) => sum + value * (lower[k] ?? 0), 0);
    bends.push((Math.acos(dot / Math.hypot(...upper) / Math.hypot(...lower)) * 180) / Math.PI);
  }
  return [Math.min(...bends), Math.max(...bends)];
}

describe("a preset of the first model does what its sentence says:", () => {
  for (const preset of presets)
    it(preset.id, () => {
      const rollout = roll(model, preset.reading, couplings(preset));
      const measures = rollout.measures(frames(SETTLED));
      assert.ok(preset.holds.length > 0, "its sentence is measured");
      for (const claim of preset.holds) {
        if (claim.what === "health") {
          assert.equal(rollout.health().state, claim.is);
          continue;
        }
        const { from = Number.NaN, to = Number.NaN } = claim;
        const all = claim.what === "elbow" ? elbow(claim.side, rollout) : [measured(claim, measures)];
        for (const found of all)
          assert.ok(
            found >= from && found <= to,
            `${claim.what} ${claim.part ?? ""}: ${from} to ${to}, found ${found}`,
          );
      }
    });
});

describe("arms that were let go", () => {
  it("are back in step soon after the legs are heard again, whenever that is", () => {
    const preset = presets.find(({ id }) => id === "arms-go");
    assert.ok(preset);
    const apart = roll(model, preset.reading, couplings(preset));
    for (const seconds of [6, 6.4, 6.8, 7.2, 12]) {
      const document = JSON.parse(text);
      // The model begins where the other motion is at that time.
      const end = frames(seconds);
      document.sequences[0].start = info.parts.map(({ latent }, part) => {
        const path = apart.latents(part);
        return Array.from({ length: info.order }, (_, k) =>
          Array.from(path.subarray((end - info.order + k) * latent, (end - info.order + k + 1) * latent)),
        );
      });
      const again = roll(installed.vcgpdm.Model.fromJson(JSON.stringify(document)), "re-inferred", null);
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
