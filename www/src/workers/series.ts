// Time series that are no body: reads tables, trains on them, keeps a model open for rollouts. No DOM.
import { Model, type Rollout, Table, Trainer, TrainingSet } from "vcgpdm";
import { MAX_PARTS } from "../engine/limits";
import type { ModelInfo } from "../engine/protocol";
import type {
  OpenedSeries,
  SeriesRequest,
  SeriesRollout,
  SeriesWorker,
  TableSource,
} from "../engine/series-protocol";
import { follow } from "./follow";
import { inducingOf } from "./inducing";
import { transfer, using } from "./using";

let open: Model | null = null;

function openModel(text: string): OpenedSeries {
  const model = Model.fromJson(text);
  const info = model.info();
  const { figure, parts } = info;
  if (figure || parts.length > MAX_PARTS) {
    model.free();
    throw new Error(
      figure
        ? "expected a model of columns, found one of a body"
        : `expected a model of ${MAX_PARTS} parts at most, found ${parts.length}`,
    );
  }
  open?.free();
  open = model;
  // Other kinds of models have no inducing points.
  const inducing = info.alpha
    ? inducingOf(model, info as ModelInfo)
    : { poseInducing: [], dynamicsInducing: [] };
  return { info, ...inducing };
}

async function read({ name, file, without }: TableSource): Promise<Table> {
  return using(Table.read(name, new Uint8Array(await file.arrayBuffer())), (table) => table.without(without));
}

/** The tables as a set for a training. Throws the reason when they do not go together. */
async function setOf(tables: readonly TableSource[]): Promise<TrainingSet> {
  const set = new TrainingSet();
  try {
    for (const source of tables) using(await read(source), (table) => set.addTable(table));
    return set;
  } catch (problem) {
    set.free();
    throw problem;
  }
}

function opened() {
  if (!open) throw new Error("There is no model yet: open one.");
  return open;
}

function rolled({ observed, ...options }: SeriesRequest): Rollout {
  const model = opened();
  return observed ? model.fill(observed, options) : model.rollout(options);
}

function columnsOf(rollout: Rollout): SeriesRollout {
  const [values, all] = [rollout.values(), rollout.weights()];
  if (all.length === 0) return { values, latents: [], weights: null };
  return { values, latents: all.map((_, part) => rollout.latents(part)), weights: all };
}

export const seriesWorker: SeriesWorker = {
  readTable: async (source) =>
    using(await read(source), (table) => {
      const [info, values] = [table.info(), table.values()];
      return transfer({ info, values }, values);
    }),
  checkTables: (tables) =>
    setOf(tables).then(
      (set) => using(set, () => ""),
      (problem: unknown) => (problem instanceof Error ? problem.message : String(problem)),
    ),
  openSeries: openModel,
  rolloutSeries(request) {
    const found = using(rolled(request), columnsOf);
    return transfer(found, found.values, ...found.latents);
  },
  sampleSeries: ({ observed: _, ...options }, count, seed) =>
    opened()
      .sampledRollouts(options, count, seed)
      .map((rollout) => using(rollout, columnsOf)),
  seriesCsv: (request) => using(rolled(request), (rollout) => rollout.toCsv()),
  trainSeries: async ({ tables, settings }, report, signal) =>
    using(
      using(await setOf(tables), (set) => new Trainer(set, settings)),
      (trainer) => {
        const training = {
          step: () => trainer.step(),
          notices: () => trainer.notices(),
          find: () => ({
            text: using(trainer.model(), (model) => model.toJson()),
            latents: settings.parts.map((_, part) => trainer.latents(part)),
          }),
        };
        return follow(training, report, signal);
      },
    ),
};
