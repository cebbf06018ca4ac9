// `npm run lab -- drawings FILE.csv ...`: whether models of people's drawings go on as they were drawn. A file has a
// drawing, with the columns x, y and seconds, and line_number for each stroke.
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { runnerImport } from "vite";
import { builtPackage } from "../package.mjs";
import { at } from "../run.mjs";

/** The seconds after which a model must still go on. */
const SECONDS = 20;
/** The width of a drawing on the pad, and the middle of the pad: hundredths of the pad's width. */
const SIZE = 60;
const MIDDLE = /** @type {const} */ ([50, 66]);

/** A module of the view Draw. */
export const drawingModule = async (/** @type {string} */ name) =>
  /** @type {any} */ ((await runnerImport(at(`www/src/drawing/${name}.ts`), { configFile: false })).module);

/** Learns a drawing with the npm package `vc`: each pad is a part. */
export function modelOf(
  /** @type {any} */ vc,
  /** @type {any} */ settings,
  /** @type {any} */ { rows, rate },
) {
  const set = new vc.TrainingSet();
  const names = ["x", "y", "x2", "y2"].slice(0, rows[0].length);
  set.addTable(vc.Table.of("drawing", names, new Float64Array(rows.flat()), 1 / rate));
  const parts = names.flatMap((name, i) => (i % 2 ? [{ name, columns: names.slice(i - 1, i + 1) }] : []));
  const trainer = new vc.Trainer(set, { ...settings, framesPerSecond: rate, parts });
  while (!trainer.step().done);
  return trainer.model();
}

/** Learns what a hand drew: how the rollout compares with the drawing; null: too little. */
export async function learner(/** @type {typeof import("vcgpdm")} */ vcgpdm) {
  const [{ drawingOf, DRAWING_SETTINGS }, { goesOn }] = await Promise.all(
    ["hand", "goes-on"].map(drawingModule),
  );
  return (/** @type {any} */ strokes) => {
    const drawing = drawingOf([strokes]);
    if (!drawing) return null;
    const { rows, rate, lap } = drawing;
    const frames = Math.max(Math.round(SECONDS * rate), 3 * lap);
    const values = modelOf(vcgpdm, DRAWING_SETTINGS, drawing).rollout({ frames }).values();
    const path = Array.from({ length: frames }, (_, i) => [values[2 * i], values[2 * i + 1]]);
    return { ...drawing, ...goesOn(rows, path, lap) };
  };
}

/** The strokes of a file on a pad, in their first seconds. */
function strokesIn(/** @type {string} */ file, /** @type {number} */ longest) {
  const [head = "", ...lines] = readFileSync(file, "utf8").trim().split(/\r?\n/);
  const places = ["line_number", "seconds", "x", "y"].map((name) => head.split(",").indexOf(name));
  const samples = lines
    .map((line) => places.map((place) => Number(line.split(",")[place] ?? 0)))
    .filter(([, seconds = 0]) => seconds <= longest);
  const ends = [2, 3].map((k) => {
    const values = samples.map((sample) => sample[k] ?? 0);
    return { low: Math.min(...values), high: Math.max(...values) };
  });
  const scale = SIZE / Math.max(...ends.map(({ low, high }) => high - low));
  const put = (/** @type {number} */ value, /** @type {0 | 1} */ axis) => {
    const { low = 0, high = 0 } = ends[axis] ?? {};
    return MIDDLE[axis] + scale * (value - (low + high) / 2);
  };
  const strokes = new Map(samples.map(([line]) => [line, /** @type {object[]} */ ([])]));
  for (const [line, seconds = 0, x = 0, y = 0] of samples)
    strokes.get(line)?.push({ seconds, x: put(x, 0), y: put(y, 1) });
  return [...strokes.values()];
}

export async function drawings(/** @type {string[]} */ ...files) {
  const learn = await learner(builtPackage());
  const { LONGEST } = await drawingModule("hand");
  console.log("| drawing | rows a lap | visited, % | speed, times | goes on |\n|---|---|---|---|---|");
  for (const file of files) {
    const found = learn(strokesIn(file, LONGEST));
    const { lap, visited, speed, goesOn } = found ?? { lap: 0, visited: 0, speed: 0, goesOn: false };
    const cells = [
      lap,
      Math.round(100 * visited),
      speed.toFixed(2),
      found ? (goesOn ? "yes" : "no") : "too little",
    ];
    console.log(`| ${basename(file, ".csv")} | ${cells.join(" | ")} |`);
  }
}
