//! The origin of a primitive of a library.

use serde::Serialize;
use vcgpdm::models::SequenceInfo;
use vcgpdm::models::library::{Origin, Relearned};

/// The training that learned a primitive. For a primitive that was learned again, this is the later training.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PrimitiveOrigin {
    engine: String,
    seed: u32,
    /// The bound that the training reached, in nats.
    bound: f64,
    iterations: usize,
    note: Option<String>,
    /// The clips of the training.
    clips: Vec<SequenceInfo>,
    /// The primitive of another library from which this primitive was learned again. Null if this library
    /// learned the primitive from clips.
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
