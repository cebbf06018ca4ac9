// What a worker does for time series that are no body: reads tables, trains on them, rolls their models out.
// No DOM.
import { AnyModel, type AnyRollout, Table, TableTrainer } from "vcgpdm";
import { MAX_PARTS } from "../engine/limits";
import type { LibraryReport } from "../engine/library-protocol";
import type { TrainingOutcome } from "../engine/protocol";
import type {
  SeriesJob,
  SeriesRequest,
  SeriesWorker,
  TableSource,
  TrainedSeries,
} from "../engine/series-protocol";
import { follow } from "./follow";
import { handOver } from "./hand-over";
import { OneTask, type Task } from "./slices";
import { using } from "./using";

const training = new OneTask();

/** The model that was asked about last: a slider asks about the same again and again. */
let held: { text: string; model: AnyModel; parts: number } | null = null;

function modelOf(text: string): NonNullable<typeof held> {
  if (held?.text === text) return held;
  const model = AnyModel.fromJson(text);
  const { body, parts } = model.info();
  if (body || parts.length > MAX_PARTS) {
    model.free();
    throw new Error(
      body
        ? "expected a model of columns, found one of a body"
        : `expected a model of ${MAX_PARTS} parts at most, found ${parts.length}`,
    );
  }
  held?.model.free();
  held = { text, model, parts: parts.length };
  return held;
}

async function read({ name, file }: TableSource): Promise<Table> {
  return Table.read(name, new Uint8Array(await file.arrayBuffer()));
}

/** Gives the tables to a training one after the other. */
async function addAll(trainer: TableTrainer, tables: readonly TableSource[]): Promise<void> {
  for (const source of tables) using(await read(source), (table) => trainer.add(table));
}

const NO_SETTINGS: SeriesJob["settings"] = {
  ...{ parts: [], latent: 1, dynamicsIps: 2, poseIps: 2, order: 1 },
  ...{ framesPerSecond: 30, seed: 0, maxIterations: 1 },
};

async function train(
  { tables, settings }: SeriesJob,
  report: (report: LibraryReport<TrainedSeries>) => void,
  task: Task,
): Promise<TrainingOutcome> {
  const trainer = new TableTrainer(settings);
  try {
    await addAll(trainer, tables);
    const find = () => ({
      text: using(trainer.model(), (model) => model.toJson()),
      latents: settings.parts.map((_, part) => trainer.latents(part)),
    });
    return await follow({ trainer, find }, report, task);
  } finally {
    trainer.free();
  }
}

function withRollout<Found>(
  { text, ...options }: SeriesRequest,
  look: (rollout: AnyRollout, parts: number) => Found,
): Found {
  const { model, parts } = modelOf(text);
  return using(model.rollout(options), (rollout) => look(rollout, parts));
}

export const seriesWorker: SeriesWorker = {
  async readTable(source) {
    const { info, values } = using(await read(source), (table) => ({
      info: table.info(),
      values: table.values(),
    }));
    return handOver({ info, values }, values);
  },
  async checkTables(tables) {
    const trainer = new TableTrainer(NO_SETTINGS);
    try {
      await addAll(trainer, tables);
      return "";
    } catch (problem) {
      return problem instanceof Error ? problem.message : String(problem);
    } finally {
      trainer.free();
    }
  },
  openSeries: (text) => modelOf(text).model.info(),
  rolloutSeries: (request) =>
    withRollout(request, (rollout, parts) => {
      const weights = rollout.weights();
      const latents = weights ? Array.from({ length: parts }, (_, part) => rollout.latents(part)) : [];
      const values = rollout.values();
      return handOver({ values, latents, weights }, values, ...latents);
    }),
  seriesCsv: (request) => withRollout(request, (rollout) => rollout.toCsv()),
  trainSeries: (job, report) => training.run((task) => train(job, report, task)),
  cancelSeries: () => training.cancel(),
};
