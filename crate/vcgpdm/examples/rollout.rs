//! Rolls out a model to a new walk and writes it as a BVH file:
//!
//! ```sh
//! cargo run --example train -- FOLDER
//! cargo run --example rollout -- FOLDER
//! ```

use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm::{Model, RolloutRequest, write_bvh};

fn main() -> Result<(), Box<dyn Error>> {
    run(&std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from))
}

/// Reads FOLDER/model.json and writes FOLDER/new-walk.bvh.
pub fn run(folder: &Path) -> Result<(), Box<dyn Error>> {
    let path = folder.join("model.json");
    let document = std::fs::read_to_string(&path)
        .map_err(|error| format!("{}: {error}; run the example train first", path.display()))?;

    // The document has all that a rollout needs: the body, the mapping to poses and the model, but no
    // training clip.
    let model = Model::from_json(&document)?;
    let trained = model.coupled().ok_or("expected a model with couplings")?;

    // The mean rollout begins at the start of the first training sequence and lasts ten seconds.
    let frames = (10.0 / trained.body.frame_time).round() as usize;
    let rollout = trained.rollout(&RolloutRequest { frames, sequence: 0, ..RolloutRequest::default() })?;

    // A rollout has the latents of each part and the columns of all parts. The body turns columns into poses.
    for (part, latents) in trained.body.layout.parts().iter().zip(&rollout.latents) {
        println!("{}: latents [{} x {}]", part.name, latents.nrows(), latents.ncols());
    }
    let clip = trained.clip(&rollout, "new-walk.bvh")?;
    let path = folder.join("new-walk.bvh");
    std::fs::write(&path, write_bvh(&clip))?;
    println!("{} frames of {:.4} s are in {}", clip.frames(), clip.frame_time, path.display());
    Ok(())
}
