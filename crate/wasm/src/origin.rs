//! Where a primitive of a library comes from.

use serde::Serialize;
use vcgpdm::models::SequenceInfo;
use vcgpdm::models::library::{Origin, Relearned};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/**
 * Where a primitive comes from: the training that it was learned in; of one that was learned again, that
 * training.
 */
export interface PrimitiveOrigin {
    engine: string;
    seed: number;
    /** The bound that the training reached, in nats. */
    bound: number;
    iterations: number;
    note: string | null;
    /** What it learned from. */
    clips: SequenceInfo[];
    /**
     * The primitive of another library that it was learned again from; null: it was learned from clips where
     * it stands.
     */
    relearned: RelearnedFrom | null;
}

/**
 * The frames that a primitive is learned again from: clips that somebody gave; the poses of the latents that
 * it had in training; or rollouts of the movements that it came with.
 */
export type ImportFrames = "clips" | "remembered" | "generated";

/** What a primitive was learned again from. */
export interface RelearnedFrom {
    /** Its name there. */
    primitive: string;
    frames: ImportFrames;
    /** What its training there learned from. */
    clips: SequenceInfo[];
}
"#;

/// Where a primitive comes from.
#[derive(Serialize)]
pub struct PrimitiveOrigin {
    engine: String,
    seed: u32,
    bound: f64,
    iterations: usize,
    note: Option<String>,
    clips: Vec<SequenceInfo>,
    relearned: Option<RelearnedFrom>,
}

#[derive(Serialize)]
struct RelearnedFrom {
    primitive: String,
    frames: &'static str,
    clips: Vec<SequenceInfo>,
}

impl From<Origin> for PrimitiveOrigin {
    fn from(Origin { training, clips, relearned }: Origin) -> Self {
        let from = |Relearned { primitive, clips, frames }: Relearned| RelearnedFrom {
            primitive,
            frames: frames.id(),
            clips,
        };
        Self {
            engine: training.engine,
            seed: training.seed,
            bound: training.objective,
            iterations: training.iterations,
            note: training.note,
            clips,
            relearned: relearned.map(from),
        }
    }
}
