// The messages about time series without a body. Types only.
import type { ModelInfo, TableInfo, TableTrainingSettings } from "vcgpdm";
import type { Couplings, ModelView, Reading, Report, TrainingOutcome } from "./protocol";

export type { TableInfo, TablePart } from "vcgpdm";
export type SeriesInfo = ModelInfo;

/** A file with columns. Each worker that trains on the file reads it. */
export interface TableSource {
  name: string;
  file: Blob;
  /** The columns that are left out. A name can begin or end with `*`, which stands for any letters. */
  without: string[];
}

export interface ReadTable {
  info: TableInfo;
  /** [rows x columns] */
  values: Float64Array;
}

export interface SeriesJob {
  /** At least one table. The columns of later tables may be in another order than those of the first. */
  tables: TableSource[];
  settings: TableTrainingSettings;
}

export interface TrainedSeries {
  /** The document of the model. */
  text: string;
  /** Latent means of the training rows of each part [rows x Q]. */
  latents: Float64Array[];
}

/** A model of columns that a worker has opened. */
export interface OpenedSeries extends Pick<ModelView, "poseInducing" | "dynamicsInducing"> {
  info: SeriesInfo;
}

export interface SeriesRequest {
  frames: number;
  /** The index of the training table from whose first rows the rollout starts. */
  sequence: number;
  /** Latents that begin the rollout in place of the table, `[part][frame][dimension]`; `sequence` is then 0. */
  start?: number[][][];
  /** Null: the learned couplings. */
  alpha: Couplings | null;
  reading: Reading;
  /** Numbers that are given [frames x columns], NaN for those to infer; null: the model goes on from its start. */
  observed: Float64Array | null;
}

export interface SeriesRollout {
  /** [frames x columns] */
  values: Float64Array;
  /** Latent path of each part [frames x Q]; empty for a kind without couplings. */
  latents: Float64Array[];
  /** w[source][target]; null for a kind of model without couplings. */
  weights: Couplings | null;
}

/** The calls of a worker for time series. The worker keeps one model open for rollouts. */
export interface SeriesWorker {
  readTable(source: TableSource): Promise<ReadTable>;
  /** The reason why these tables cannot be trained on together; empty if they can. */
  checkTables(tables: TableSource[]): Promise<string>;
  /** Opens a model and closes the earlier one. If the text is not a model of tables, throws the reason. */
  openSeries(text: string): OpenedSeries;
  /** A rollout of the open model. */
  rolloutSeries(request: SeriesRequest): SeriesRollout;
  /** Sampled rollouts of the seeds `seed`, `seed + 1`, and so on; nothing is given. */
  sampleSeries(request: SeriesRequest, count: number, seed: number): SeriesRollout[];
  /** A rollout of the open model as CSV: frame, time in seconds, and the columns of the model. */
  seriesCsv(request: SeriesRequest): string;
  trainSeries(job: SeriesJob, report: Report<TrainedSeries>, signal: AbortSignal): Promise<TrainingOutcome>;
}
