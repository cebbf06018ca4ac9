// The types of the npm package that no Rust struct has: options, and errors. All others are those of the structs
// (src/types.rs); scripts/package.mjs joins both.

/** The subject of a `VcgpdmError`. */
export type ErrorCode =
  | "clip"
  | "clips"
  | "bones"
  | "parts"
  | "settings"
  | "training"
  | "model"
  | "rollout"
  | "comparison"
  | "results"
  | "study"
  | "table"
  | "numerics"
  | "argument"
  | "freed";

/**
 * Every function throws this error when it fails; the message says what was expected and what was found.
 * The code is "argument" for an argument of another class, and "freed" for an object that is used after its
 * `free()`.
 */
export interface VcgpdmError extends Error {
  name: "VcgpdmError";
  code: ErrorCode;
}

/** A candidate that a caller gives: absent fields are the defaults of its model. */
export type CandidateOptions = Partial<Candidate>;

/**
 * A job that a caller gives. Each field has a default: the first trial held out, all others trained on, and the
 * seed 0.
 */
export interface JobOptions extends Partial<Omit<Job, "candidate">> {
  /** Absent: a vCGPDM. */
  candidate?: CandidateOptions;
}

/** How a vCGPDM, a vGPDM or a library was made. */
export interface Provenance extends Omit<ModelProvenance, "settings" | "terms"> {
  settings: TrainingSettings;
  terms: BoundTerms;
}

/** Settings of a training; those of the model itself only of a vCGPDM or vGPDM. */
export type ModelSettings = Omit<TrainingSettings, keyof VariationalSettings> & Partial<VariationalSettings>;

/** A part of a model; latent dimensions and pose inducing points only of a vCGPDM or vGPDM. */
export interface ModelPart extends Pick<PartInfo, "name">, Partial<Pick<PartInfo, "latent" | "poseIps">> {
  /** Of a model of tables, the places of its columns. */
  joints: number[];
}

/** `ModelInfo` of a vCGPDM or vGPDM of a body. */
export type CoupledModelInfo = {
  [Field in Exclude<keyof ModelInfo, "parts" | "provenance">]: NonNullable<ModelInfo[Field]>;
} & {
  parts: PartInfo[];
  provenance: Provenance;
};

/** The options of the analysis. An absent option has the default value of the terminal program. */
export type PerceptionOptions = Partial<UsedOptions>;

/** The settings of a training that a caller gives. Each has a default. */
export interface TrainingOptions {
  /**
   * How the body is split: a preset by its id or the names of its parts ("lower-upper", "lower,upper",
   * "whole"), or a list of parts. Absent: lower and upper body, or the whole body if no legs were found.
   */
  parts?: string | NamedPart[];
  /** Latent dimensions Q of every part; absent: 3. */
  latent?: number;
  /** Dynamics inducing points K of every expert; absent: 12, or 30 if a clip has 8 seconds or more (a library: 12). */
  dynamicsIps?: number;
  /** Pose inducing points L of every part; absent: as for the dynamics. */
  poseIps?: number;
  /** Order p of the dynamics; absent: 2. */
  order?: number;
  /** Most iterations of the optimiser; absent: 250. */
  maxIterations?: number;
  /** As in `VariationalSettings`; absent: "balanced" for clips, 1 for tables and libraries. */
  poseWeight?: number | "balanced";
  /** As in `VariationalSettings`. */
  uncoupled?: boolean;
  /** As in `VariationalSettings`; absent: yes for clips and libraries. */
  ownRollouts?: boolean;
  /** Train as in the papers: with `poseWeight` 1 and `ownRollouts` false, whatever these options are. */
  asInPapers?: boolean;
  /** The clips are brought to about this rate; absent: 30. */
  framesPerSecond?: number;
  /** The seed of everything random, a whole number from 0 to 4294967295; absent: 0. */
  seed?: number;
}

/** The settings of a training on tables. */
export interface TableTrainingSettings extends Omit<TrainingSettings, "parts"> {
  parts: TablePart[];
  /** Rows a second, if the tables have no column of times. */
  framesPerSecond: number;
}

/** The settings of a training on tables that a caller gives. Each has a default. */
export interface TableTrainingOptions extends Omit<TrainingOptions, "parts"> {
  /** Absent: one part with all columns. */
  parts?: TablePart[];
  /** Rows a second, if the tables have no column of times; absent: 30. */
  framesPerSecond?: number;
}

/** Why training ended: the objective no longer rises, or all iterations are used. */
export type EndReason = "settled" | "iterations";
