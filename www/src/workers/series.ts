// Time series that are no body: reads tables, trains on them, keeps a model open for rollouts. No DOM.
import { AnyModel, type AnyRollout, Table, TableTrainer } from "vcgpdm";
import { MAX_PARTS } from "../engine/limits";
import type {
  SeriesInfo,
  SeriesJob,
  SeriesRequest,
  SeriesWorker,
  TableSource,
} from "../engine/series-protocol";
import { follow } from "./follow";
import { transfer } from "./transfer";
import { using } from "./using";

let open: { model: AnyModel; parts: number } | null = null;

function openModel(text: string): SeriesInfo {
  const model = AnyModel.fromJson(text);
  const info = model.info();
  const { body, parts } = info;
  if (body || parts.length > MAX_PARTS) {
    model.free();
    throw new Error(
      body
        ? "expected a model of columns, found one of a body"
        : `expected a model of ${MAX_PARTS} parts at most, found ${parts.length}`,
    );
  }
  open?.model.free();
  open = { model, parts: parts.length };
  return info;
}

async function read({ name, file }: TableSource): Promise<Table> {
  return Table.read(name, new Uint8Array(await file.arrayBuffer()));
}

/** Gives the tables to a training one after the other. */
async function addAll(trainer: TableTrainer, tables: readonly TableSource[]): Promise<void> {
  for (const source of tables) using(await read(source), (table) => trainer.add(table));
}

/** Settings for a training that only checks its tables. */
const ANY_SETTINGS: SeriesJob["settings"] = {
  ...{ parts: [], latent: 1, dynamicsIps: 2, poseIps: 2, order: 1 },
  ...{ framesPerSecond: 30, seed: 0, maxIterations: 1 },
};

function withRollout<Found>(
  request: SeriesRequest,
  look: (rollout: AnyRollout, parts: number) => Found,
): Found {
  if (!open) throw new Error("There is no model yet: open one.");
  const { model, parts } = open;
  return using(model.rollout(request), (rollout) => look(rollout, parts));
}

export const seriesWorker: SeriesWorker = {
  readTable: async (source) =>
    using(await read(source), (table) => {
      const [info, values] = [table.info(), table.values()];
      return transfer({ info, values }, values);
    }),
  checkTables: (tables) =>
    using(new TableTrainer(ANY_SETTINGS), (trainer) =>
      addAll(trainer, tables).then(
        () => "",
        (problem: unknown) => (problem instanceof Error ? problem.message : String(problem)),
      ),
    ),
  openSeries: openModel,
  rolloutSeries: (request) =>
    withRollout(request, (rollout, parts) => {
      const weights = rollout.weights();
      const latents = weights ? Array.from({ length: parts }, (_, part) => rollout.latents(part)) : [];
      const values = rollout.values();
      return transfer({ values, latents, weights }, values, ...latents);
    }),
  seriesCsv: (request) => withRollout(request, (rollout) => rollout.toCsv()),
  trainSeries: ({ tables, settings }, report, signal) =>
    using(new TableTrainer(settings), async (trainer) => {
      await addAll(trainer, tables);
      const training = {
        step: () => trainer.step(),
        notices: () => trainer.notices(),
        find: () => ({
          text: using(trainer.model(), (model) => model.toJson()),
          latents: settings.parts.map((_, part) => trainer.latents(part)),
        }),
      };
      return await follow(training, report, signal);
    }),
};
