// For tests: a worker that reads tables and takes texts for models of two parts, and computes nothing.
import type { Calls } from "./calls";
import type { PendingTraining } from "./library.fake";
import type { Couplings } from "./protocol";
import type {
  ReadTable,
  SeriesInfo,
  SeriesJob,
  SeriesRequest,
  SeriesWorker,
  TableSource,
  TrainedSeries,
} from "./series-protocol";

const LEARNED: Couplings = [
  [1, 2],
  [3, 4],
];

/** A model's document: of tables with these names, or of another kind without couplings. */
export const seriesText = (tables: readonly string[], { coupled = true } = {}) =>
  JSON.stringify({ tables, coupled });

function infoOf(text: string): SeriesInfo {
  const { tables, coupled } = JSON.parse(text) as { tables: string[]; coupled: boolean };
  return {
    kind: coupled ? "vcgpdm" : "tmp",
    parts: [
      { name: "arm", joints: [0, 1] },
      { name: "leg", joints: [2] },
    ],
    columns: ["arm_x", "arm_y", "leg_x"],
    frameTime: 0.1,
    sequences: tables.map((name) => ({
      ...{ name, sha256: name, frames: 10, restsFrom: null, piece: null, bonesOf: null, whole: true },
    })),
    alpha: coupled ? LEARNED : null,
    joints: null,
    figure: null,
    order: coupled ? 2 : null,
    startFrames: null,
    dynamicsIps: null,
    dynamicsElbo: null,
    provenance: { settings: { seed: 1 } } as SeriesInfo["provenance"],
  };
}

async function read({ name, file, without }: TableSource): Promise<ReadTable> {
  const [head = "", ...rows] = (await file.text()).trim().split("\n");
  if (rows.length < 2) throw new Error(`${name}, line 1: expected at least two rows of numbers`);
  const columns = head.split(",");
  const unknown = without.find((column) => !columns.includes(column));
  if (unknown)
    throw new Error(`${name}: expected some of the columns ${columns.join(", ")}, found ${unknown}`);
  const kept = columns.filter((column) => !without.includes(column));
  const numbers = (row: string) => row.split(",").filter((_, place) => kept.includes(columns[place] ?? ""));
  const values = Float64Array.from(rows.flatMap((row) => numbers(row).map(Number)));
  return {
    info: { name, sha256: name, columns: kept, rows: rows.length, frameTime: 0.1, warnings: [] },
    values,
  };
}

export class FakeSeries {
  /** All rollouts that were asked for. */
  readonly rollouts: SeriesRequest[] = [];
  readonly trainings: PendingTraining<SeriesJob, TrainedSeries>[] = [];
  /** Why tables do not go together; empty when they do. */
  clash = "";

  /** The documents that were opened, in order. */
  readonly opened: string[] = [];

  /** A worker that has just started: no model is open. */
  worker(): Calls<SeriesWorker> {
    let open = "";
    return {
      readTable: read,
      checkTables: async () => this.clash,
      openSeries: async (text) => {
        const info = infoOf(text);
        this.opened.push(text);
        open = text;
        return { info, poseInducing: [], dynamicsInducing: [] };
      },
      rolloutSeries: async (asked) => {
        this.rollouts.push(asked);
        const { alpha } = infoOf(open);
        const values = new Float64Array(3 * asked.frames).fill(asked.alpha?.[0]?.[1] ?? 0);
        const latents = alpha ? [new Float64Array(2 * asked.frames), new Float64Array(asked.frames)] : [];
        return { values, latents, weights: alpha && (asked.alpha ?? alpha) };
      },
      sampleSeries: async ({ frames }, count, seed) =>
        Array.from({ length: count }, (_, k) => ({
          values: new Float64Array(3 * frames).fill(seed + k),
          latents: [new Float64Array(2 * frames).fill(seed + k), new Float64Array(frames)],
          weights: null,
        })),
      seriesCsv: async ({ alpha }) => `csv of ${JSON.stringify(alpha)}`,
      trainSeries: (job, report, signal) =>
        new Promise((end) => {
          this.trainings.push({ job, report, end });
          signal.addEventListener("abort", () => end({ cancelled: true, reason: null }), { once: true });
        }),
    };
  }
}
