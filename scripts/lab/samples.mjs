// `npm run lab -- samples FILE.bvh ...`: what sampled rollouts visit of their clip, beside the mean. A model of each
// clip from the first seed; 20 seconds of the mean and of three samples. The table goes to the terminal.
// `npm run lab -- samples FOLDER ...`: whether samples differ more from their clip than a person's trials differ from
// each other. A folder has the clips of one person.
import { readFileSync, statSync } from "node:fs";
import { basename } from "node:path";
import { builtPackage } from "../package.mjs";
import { Failure } from "../run.mjs";
import { subject } from "./subjects.mjs";

const SECONDS = 20;
const SAMPLES = 3;
/** Quantiles of Student's t for 95 % on both sides, from 1 degree of freedom on; for more people the last is wide. */
const T = [12.71, 4.3, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26];

/** A model of a clip, its mean and its samples. */
async function modelOf(/** @type {string} */ file) {
  const { Clip, train } = builtPackage();
  const clip = Clip.read(basename(file), readFileSync(file));
  const model = await train(clip, { parts: "lower,upper" });
  const { frameTime } = model.info();
  const frames = Math.round(SECONDS / frameTime);
  const samples = model.sampledRollouts({ frames }, SAMPLES, 1);
  return { clip: clip.resample(1 / frameTime), mean: model.rollout({ frames }), samples };
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

/** What is measured of a motion; of the speed the difference is a ratio. */
const MEASURES = ["steps that turn back, %", "speed, %", "speed of the lower foot, % of the root's"];

/**
 * Steps that turn back, %; the speed of the nodes relative to the root; the speed of the lowest node, % of the root's.
 * @type {(motion: { positions(): Float32Array }, nodes: number) => number[]}
 */
function measured(motion, nodes) {
  const all = motion.positions();
  const value = (/** @type {number} */ frame, /** @type {number} */ i) => all[3 * nodes * frame + i] ?? 0;
  let [back, pairs, way, slid, walked] = [0, 0, 0, 0, 0];
  /** @type {number[]} */
  let before = [];
  for (let t = 1; t < all.length / nodes / 3; t++) {
    const step = Array.from({ length: 3 * nodes }, (_, i) => value(t, i) - value(t - 1, i));
    const own = step.map((by, i) => by - (step[i % 3] ?? 0));
    way += Math.hypot(...own);
    const turn = Math.min(Math.hypot(...own), Math.hypot(...before));
    pairs += turn;
    if (own.reduce((sum, by, i) => sum + by * (before[i] ?? 0), 0) < 0) back += turn;
    before = own;
    const heights = Array.from({ length: nodes }, (_, node) => value(t, 3 * node + 1));
    const low = 3 * heights.indexOf(Math.min(...heights));
    slid += Math.hypot(step[low] ?? 0, step[low + 2] ?? 0);
    walked += Math.hypot(step[0] ?? 0, step[2] ?? 0);
  }
  return [(100 * back) / pairs, way / (all.length / nodes / 3 - 1), (100 * slid) / walked];
}

const mean = (/** @type {number[]} */ all) => all.reduce((sum, value) => sum + value, 0) / all.length;

/** The differences between a person's trials, from a clip to its mean, and to its samples, by measure. */
async function person(/** @type {string} */ folder) {
  /** @type {{ own: number[], middle: number[], drawn: number[][] }[]} */
  const trials = [];
  for (const file of subject(folder, 2).clips) {
    const { clip, mean, samples } = await modelOf(file);
    const of = (/** @type {any} */ motion) => measured(motion, clip.info().figure.nodes.length);
    trials.push({ own: of(clip), middle: of(mean), drawn: [...samples].map(of) });
  }
  return MEASURES.map((name, k) => {
    const apart = (/** @type {number[]} */ { [k]: a = 0 }, /** @type {number[]} */ { [k]: b = 0 }) =>
      name.startsWith("speed, ") ? 100 * (Math.max(a / b, b / a) - 1) : Math.abs(a - b);
    return [
      mean(trials.flatMap(({ own }, i) => trials.slice(i + 1).map((other) => apart(own, other.own)))),
      mean(trials.map(({ own, middle }) => apart(own, middle))),
      mean(trials.flatMap(({ own, drawn }) => drawn.map((sample) => apart(own, sample)))),
    ];
  });
}

/** What samples differ from their clip, less what trials differ. The person is the unit. */
async function people(/** @type {string[]} */ folders) {
  if (folders.length < 2) throw new Failure("expected folders of at least 2 people, found 1");
  /** @type {number[][][]} */
  const found = [];
  for (const folder of folders) found.push(await person(folder));
  const columns = folders.map((folder) => `${basename(folder)}: trials, mean, samples`).join(" | ");
  console.log(
    `| difference in | ${columns} | samples less trials (95 %) |\n|---|${"---|".repeat(folders.length + 1)}`,
  );
  MEASURES.forEach((name, k) => {
    const all = found.map((person) => person[k] ?? []);
    const effects = all.map(([trials = 0, , samples = 0]) => samples - trials);
    const [count, middle] = [effects.length, mean(effects)];
    const variance = (mean(effects.map((effect) => (effect - middle) ** 2)) * count) / (count - 1);
    const half = (T[count - 2] ?? T.at(-1) ?? Number.NaN) * Math.sqrt(variance / count);
    const ends = [middle - half, middle + half].map((end) => end.toFixed(1)).join(" to ");
    const cells = all.map((numbers) => numbers.map((number) => number.toFixed(1)).join(", ")).join(" | ");
    const verdict = Math.abs(middle) > half ? (middle > 0 ? "more" : "less") : "undecided";
    console.log(`| ${name} | ${cells} | ${middle.toFixed(1)} (${ends}): ${verdict} |`);
  });
}
