// For tests: small documents of each kind of model, which the tests of the library read too; motions, and plain
// values of a training.
import type { Health, TrainingProgress } from "./protocol";

const FOLDER = "../../../crate/vcgpdm/tests/library/documents";
const TEXTS = import.meta.glob<string>("../../../crate/vcgpdm/tests/library/documents/*.json", {
  query: "?raw",
  import: "default",
  eager: true,
});

interface Document {
  provenance: { settings: { seed: number } };
  sequences: { clip: string; sha256: string }[];
}

type Part = { name: string; columns: number[] };
type TmpOfColumns = Record<"centre" | "scale" | "noise", unknown[]> & { trials: { weights: unknown[] }[] };

/** The text of one of these documents, such as "map-cgpdm". */
export function documentText(name: string): string {
  const text = TEXTS[`${FOLDER}/${name}.json`];
  if (!text) throw new Error(`there is no document ${name}`);
  return text;
}

const parsed = <Kind>(name: string) => JSON.parse(documentText(name)) as Kind & Document;

/** The sequences of a document, all from the same start. Their hashes are their names. */
const named = ([first]: Document["sequences"], names: readonly string[]) =>
  names.map((name) => ({ ...first, clip: name, sha256: name }));

/** A vCGPDM of order 1, of a lower and an upper body: another document for each seed. */
export function modelText(seed: number, sequences = 1, framesPerSecond = 2): string {
  const document = parsed<{ frame_time: number }>("vcgpdm");
  document.frame_time = 1 / framesPerSecond;
  document.provenance.settings.seed = seed;
  document.sequences = named(
    document.sequences,
    Array.from({ length: sequences }, (_, i) => `walk ${i}`),
  );
  return JSON.stringify(document);
}

/** A model of tables with these hashes: the part one has x and y, the part two z. */
export function seriesText(tables: readonly string[]): string {
  const document = parsed("series");
  return JSON.stringify({ ...document, sequences: named(document.sequences, tables) });
}

/** A TMP of the columns x, y and z, which has no couplings. */
export function seriesTmpText(): string {
  const { pose: _, model, ...rest } = parsed<{ pose: unknown; model: TmpOfColumns }>("tmp");
  const { columns, column_means, parts } = parsed<{
    columns: unknown[];
    column_means: number[];
    parts: Part[];
  }>("series");
  const first = (values: unknown[]) => values.slice(0, columns.length);
  const trials = model.trials.map((trial) => ({ ...trial, weights: first(trial.weights) }));
  const [centre, scale, noise] = [model.centre, model.scale, model.noise].map(first);
  return JSON.stringify({
    ...rest,
    ...{ version: 3, columns, column_means, parts: parts.map(({ name, columns }) => ({ name, columns })) },
    model: { ...model, centre, scale, noise, trials },
  });
}

/** A BVH of joints one above the other, whose bones have this length. */
export function bvhText(joints: readonly string[] = ["Hips", "Chest"], bone = 50, frames = 60): string {
  const places = "Xposition Yposition Zposition ";
  const tree = joints.reduceRight(
    (above, name, joint) => `${joint ? "JOINT" : "ROOT"} ${name}
{ OFFSET 0 ${joint && bone} 0 CHANNELS ${joint ? "3 " : `6 ${places}`}Zrotation Xrotation Yrotation
${above} }`,
    `End Site { OFFSET 0 ${bone} 0 }`,
  );
  const row = (frame: number) =>
    Array.from({ length: 3 + 3 * joints.length }, (_, channel) => 9 * Math.sin(frame / 5 + channel));
  const rows = Array.from({ length: frames }, (_, frame) => row(frame).join(" "));
  return [`HIERARCHY\n${tree}\nMOTION\nFrames: ${frames}\nFrame Time: ${1 / 30}`, ...rows, ""].join("\n");
}

/** The progress of a training after an iteration. */
export const progress = (iteration: number, bound = 0): TrainingProgress => ({
  ...{ iteration, bound, best: bound, evaluations: iteration, maxIterations: 100, fraction: iteration / 100 },
  terms: { kinematics: [], dynamics: [], initial: 0, entropy: 0 },
  setbacks: { jittered: 0, turnedBack: 0 },
  ...{ phase: "everything", done: false, reason: null },
});

const ENDLESS = { from: null, part: null, pace: null, parts: [] };
export const MOVES_ON: Health = { ...ENDLESS, state: "moves-on", rank: 3 };
export const STANDS_STILL: Health = { ...ENDLESS, state: "stands-still", from: 2.4, rank: 1 };
