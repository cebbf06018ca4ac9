// `npm run lab -- samples FILE.bvh ...`: what sampled rollouts visit of their clip, beside the mean. A model of each
// clip from the first seed; 20 seconds of the mean and of three samples. The table goes to the terminal.
// `npm run lab -- samples FOLDER ...`: whether samples differ more from their clip than a person's trials differ from
// each other. A folder has the clips of one person.
import { readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { basename } from "node:path";
import { at, Failure } from "../run.mjs";
import { subject } from "./subjects.mjs";

const SECONDS = 20;
const SAMPLES = 3;
/** Quantiles of Student's t for 95 % on both sides, from 1 degree of freedom on. */
const T = [12.71, 4.3, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26];

/** A model of a clip, its mean and its samples. */
async function modelOf(/** @type {string} */ file) {
  /** @type {typeof import("vcgpdm")} */
  const { Clip, train } = createRequire(import.meta.url)(at("crate/wasm/pkg/node/vcgpdm.cjs"));
  const clip = Clip.read(basename(file), readFileSync(file));
  const model = await train(clip, { parts: "lower,upper" });
  const { frameTime } = model.info();
  const frames = Math.round(SECONDS / frameTime);
  const samples = model.sampledRollouts({ frames }, SAMPLES, 1);
  return { clip: clip.resample(1 / frameTime), frameTime, mean: model.rollout({ frames }), samples };
}

export async function samples(/** @type {string[]} */ ...files) {
  const [first] = files;
  if (!first) throw new Failure("expected BVH files or folders of them, found none");
  if (statSync(first).isDirectory()) return people(files);
  console.log(
    "| clip | the mean | visits, % | turns back, % | samples | visit, % | turn back, % |\n|---|---|---|---|---|---|---|",
  );
  for (const file of files) {
    const { mean, samples } = await modelOf(file);
    const found = [mean, ...samples].map((rollout) => rollout.health());
    const percent = (/** @type {number} */ share) => `${Math.round(100 * share)}`;
    // The part that visits the fewest poses decides.
    const visited = found.map(({ parts }) => percent(Math.min(...parts.map(({ visited }) => visited ?? 0))));
    const back = found.map(({ pace }) => percent(pace?.turnsBack ?? Number.NaN));
    const [now, ...drawn] = found.map(({ state }) => state);
    const rest = (/** @type {string[]} */ all) => all.slice(1).join(", ");
    console.log(
      `| ${basename(file, ".bvh")} | ${now} | ${visited[0]} | ${back[0]} | ${drawn.join(", ")} | ${rest(visited)} | ${rest(back)} |`,
    );
  }
}

/** Steps that turn back, %; speed relative to the root, log of m/s; speed of the lowest node, % of that of the root. */
function measured(
  /** @type {{ positions(): Float32Array }} */ motion,
  /** @type {number} */ nodes,
  /** @type {number} */ frameTime,
) {
  const all = motion.positions();
  const place = (/** @type {number} */ t, /** @type {number} */ node) =>
    all.subarray(3 * (t * nodes + node), 3 * (t * nodes + node + 1));
  const frames = all.length / nodes / 3;
  let [back, pairs, way, slid, walked] = [0, 0, 0, 0, 0];
  /** @type {number[]} */
  let before = [];
  for (let t = 1; t < frames; t++) {
    const step = Array.from({ length: 3 * nodes }, (_, i) => {
      const relative = (/** @type {number} */ frame) =>
        (all[3 * frame * nodes + i] ?? 0) - (place(frame, 0)[i % 3] ?? 0);
      return relative(t) - relative(t - 1);
    });
    way += Math.hypot(...step);
    if (before.length > 0) {
      const turn = Math.min(Math.hypot(...step), Math.hypot(...before));
      pairs += turn;
      if (step.reduce((sum, x, i) => sum + x * (before[i] ?? 0), 0) < 0) back += turn;
    }
    before = step;
    const low = [...Array(nodes).keys()].reduce((a, b) =>
      (place(t, b)[1] ?? 0) < (place(t, a)[1] ?? 0) ? b : a,
    );
    const over = (/** @type {number} */ node) => {
      const [[x = 0, , z = 0], [a = 0, , b = 0]] = [place(t, node), place(t - 1, node)];
      return Math.hypot(x - a, z - b);
    };
    slid += over(low);
    walked += over(0);
  }
  const speed = way / Math.sqrt(nodes) / (frames - 1) / frameTime;
  return [(100 * back) / pairs, Math.log(speed), (100 * slid) / walked];
}

const mean = (/** @type {number[]} */ all) => all.reduce((sum, value) => sum + value, 0) / all.length;

/** The differences of samples from their clip beside those between trials. The person is the unit. */
async function people(/** @type {string[]} */ folders) {
  const names = [
    "steps that turn back, percentage points",
    "speed, %",
    "speed of the lower foot, percentage points of the root's",
  ];
  /**
   * For each person, and each measure: between trials, from a clip to the mean of its model, and to its samples.
   * @type {number[][][]}
   */
  const found = [];
  for (const folder of folders) {
    /** @type {{ own: number[], middle: number[], drawn: number[][] }[]} */
    const trials = [];
    for (const file of subject(folder, 2).clips) {
      const { clip, frameTime, mean, samples } = await modelOf(file);
      const nodes = clip.info().figure.nodes.length;
      const of = (/** @type {any} */ motion) => measured(motion, nodes, frameTime);
      trials.push({ own: of(clip), middle: of(mean), drawn: [...samples].map(of) });
    }
    found.push(
      names.map((name, k) => {
        const apart = (/** @type {number[]} */ a, /** @type {number[]} */ b) => {
          const by = Math.abs((a[k] ?? 0) - (b[k] ?? 0));
          return name.startsWith("speed") ? 100 * (Math.exp(by) - 1) : by;
        };
        const between = trials.flatMap(({ own }, i) =>
          trials.slice(i + 1).map((other) => apart(own, other.own)),
        );
        return [
          mean(between),
          mean(trials.map(({ own, middle }) => apart(own, middle))),
          mean(trials.flatMap(({ own, drawn }) => drawn.map((sample) => apart(own, sample)))),
        ];
      }),
    );
  }
  const columns = folders.map((folder) => `${basename(folder)}: trials, mean, samples`).join(" | ");
  console.log(
    `| difference in | ${columns} | samples less trials (95 %) |\n|---|${"---|".repeat(folders.length + 1)}`,
  );
  names.forEach((name, k) => {
    const pairs = found.map((person) => person[k] ?? []);
    const effects = pairs.map(([trials = 0, , samples = 0]) => samples - trials);
    const middle = mean(effects);
    const spread = Math.sqrt(
      effects.reduce((sum, effect) => sum + (effect - middle) ** 2, 0) / (effects.length - 1),
    );
    const half = ((T[effects.length - 2] ?? 1.96) * spread) / Math.sqrt(effects.length);
    const ends = [middle - half, middle + half].map((end) => end.toFixed(1)).join(" to ");
    const cells = pairs.map((pair) => pair.map((value) => value.toFixed(1)).join(", ")).join(" | ");
    console.log(
      `| ${name} | ${cells} | ${middle.toFixed(1)} (${ends}): ${Math.abs(middle) > half ? "decided" : "undecided"} |`,
    );
  });
}
