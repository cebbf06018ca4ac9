//! Changes one coupling of a model, and prints the weights and the swing of the left hand:
//!
//! ```sh
//! cargo run --example train -- FOLDER
//! cargo run --example couplings -- FOLDER
//! ```
//!
//! A coupling `alpha[source][target]` is a variance: the larger it is, the less the source part influences
//! the target part.

use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm::{Coupled, Model, Reading, RolloutRequest};

fn main() -> Result<(), Box<dyn Error>> {
    run(&std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from))
}

/// Reads FOLDER/model.json and prints a table.
pub fn run(folder: &Path) -> Result<(), Box<dyn Error>> {
    let path = folder.join("model.json");
    let document = std::fs::read_to_string(&path)
        .map_err(|error| format!("{}: {error}; run the example train first", path.display()))?;
    let model = Model::from_json(&document)?;
    let trained = model.coupled().ok_or("expected a model with couplings")?;
    let (lower, upper) = (0, 1); // the order of the parts in the training

    println!("factor  weight lower to upper  weight upper to upper  swing of the left hand, cm");
    for factor in [0.1, 1.0, 10.0, 100.0] {
        let mut alpha = trained.alpha().clone();
        alpha[(lower, upper)] *= factor;
        let request = RolloutRequest {
            frames: 120,
            sequence: 0,
            alpha: Some(alpha),
            // The experts stay as learned. Reading::ReInferred would infer them again from the same data
            // under the new couplings.
            reading: Reading::AsLearned,
            ..RolloutRequest::default()
        };
        let rollout = trained.rollout(&request)?;
        println!(
            "{factor:6}  {:21.2}  {:21.2}  {:26.0}",
            rollout.weights[(lower, upper)],
            rollout.weights[(upper, upper)],
            100.0 * swing(trained, &trained.positions(&rollout)?)?,
        );
    }
    Ok(())
}

/// The range of the left hand's forward position relative to the hips, in metres. `positions` are [frames x
/// nodes x 3].
fn swing(trained: Coupled, positions: &[f32]) -> Result<f32, Box<dyn Error>> {
    let skeleton = trained.body.mapping.skeleton();
    let hand = skeleton
        .joints
        .iter()
        .position(|joint| joint.name == "LeftHand")
        .ok_or("the body has no LeftHand")?;
    // A rollout starts facing z; the hips are joint 0.
    let ahead =
        positions.chunks_exact(3 * skeleton.figure().len()).map(|frame| frame[3 * hand + 2] - frame[2]);
    let (back, front) = ahead.fold((f32::MAX, f32::MIN), |(low, high), z| (low.min(z), high.max(z)));
    Ok(front - back)
}
