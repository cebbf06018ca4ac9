// A model on the picture of loops and couplings: of a body, or of columns. Types only.
import type { ModelView } from "../engine/protocol";
import type { Observed } from "../ui/store";
import type { CouplingsStore } from "./couplings-store";

/** What the picture draws of a model. */
export type LatentModel = Pick<ModelView, "info" | "poseInducing" | "dynamicsInducing" | "trainingLatents">;

/** The paths of a rollout. */
export interface LatentPaths {
  /** Latent path of each part [frames x Q]. */
  latents: Float64Array[];
  /** w[source][target]; null for a kind of model without couplings. */
  weights: number[][] | null;
}

/** The store of such a model: the couplings now, and the rollouts under them and as learned. */
export interface Coupled extends Observed {
  readonly couplings: CouplingsStore;
  readonly model: LatentModel | null;
  readonly rollout: LatentPaths | null;
  readonly learned: LatentPaths | null;
}
