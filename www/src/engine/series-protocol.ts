// The messages about time series without a body. Types only.
import type { ModelInfo, TableInfo, TableTrainingSettings } from "vcgpdm";
import type { Couplings, Reading, Report, TrainingOutcome } from "./protocol";

export type { TableInfo, TablePart } from "vcgpdm";
export type SeriesInfo = ModelInfo;

/** A file of columns: every worker that trains on it reads it for itself. */
export interface TableSource {
  name: string;
  file: Blob;
}

export interface ReadTable {
  info: TableInfo;
  /** [rows x columns] */
  values: Float64Array;
}

export interface SeriesJob {
  /** At least one; the columns of the others may stand in another order than those of the first. */
  tables: TableSource[];
  settings: TableTrainingSettings;
}

export interface TrainedSeries {
  /** The model's document. */
  text: string;
  /** Latent means of the training rows of each part [rows x Q]. */
  latents: Float64Array[];
}

export interface SeriesRequest {
  frames: number;
  /** The training table whose start begins it. */
  sequence: number;
  /** Null: as learned. */
  alpha: Couplings | null;
  reading: Reading;
}

export interface SeriesRollout {
  /** [frames x columns] */
  values: Float64Array;
  /** Latent path of each part [frames x Q]; empty for a kind without couplings. */
  latents: Float64Array[];
  /** w[source][target]; null as latents. */
  weights: Couplings | null;
}

/** Time series. The worker keeps one model open, for rollouts. */
export interface SeriesWorker {
  readTable(source: TableSource): Promise<ReadTable>;
  /** Why these tables cannot be trained on together; empty when they can. */
  checkTables(tables: TableSource[]): Promise<string>;
  /**
   * Keeps the model open in the place of the one before. Throws with the reason when the text is no model of
   * tables.
   */
  openSeries(text: string): SeriesInfo;
  /** A rollout of the open model. */
  rolloutSeries(request: SeriesRequest): SeriesRollout;
  /** A rollout of the open model as CSV: frame, time in seconds, and a column for each. */
  seriesCsv(request: SeriesRequest): string;
  trainSeries(job: SeriesJob, report: Report<TrainedSeries>, signal: AbortSignal): Promise<TrainingOutcome>;
}
