//! The origin of a primitive of a library.

use serde::Serialize;
use vcgpdm::models::SequenceInfo;
use vcgpdm::models::library::{Origin, Relearned};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/**
 * The training that learned a primitive. For a primitive that was learned again, this is the later training.
 */
export interface PrimitiveOrigin {
    engine: string;
    seed: number;
    /** The bound that the training reached, in nats. */
    bound: number;
    iterations: number;
    note: string | null;
    /** The clips of the training. */
    clips: SequenceInfo[];
    /**
     * The primitive of another library from which this primitive was learned again. Null if this library
     * learned the primitive from clips.
     */
    relearned: RelearnedFrom | null;
}

/**
 * The source of the frames when a primitive is learned again. "clips": clips given by the caller;
 * "remembered": the poses of its training latents; "generated": rollouts of its movements in the other
 * library.
 */
export type ImportFrames = "clips" | "remembered" | "generated";

/** The source of a primitive that was learned again. */
export interface RelearnedFrom {
    /** The name of the primitive in the other library. */
    primitive: string;
    frames: ImportFrames;
    /** The clips of its training in the other library. */
    clips: SequenceInfo[];
}
"#;

/// The training that learned a primitive.
#[derive(Serialize)]
pub struct PrimitiveOrigin {
    engine: String,
    seed: u32,
    bound: f64,
    iterations: usize,
    note: Option<String>,
    clips: Vec<SequenceInfo>,
    relearned: Option<Relearned>,
}

impl From<Origin> for PrimitiveOrigin {
    fn from(Origin { training, clips, relearned }: Origin) -> Self {
        Self {
            seed: training.seed,
            bound: training.bound(),
            engine: training.engine,
            iterations: training.iterations,
            note: training.note,
            clips,
            relearned,
        }
    }
}
