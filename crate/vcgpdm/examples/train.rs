//! Trains a small model on three sample walks and writes it as a JSON document:
//!
//! ```sh
//! cargo run --example train -- FOLDER
//! ```
//!
//! Without FOLDER it writes to the folder for temporary files. The examples `rollout` and `couplings` read
//! the document.

use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm::{
    Clip, Dataset, Source, Trainer, VariationalSettings, coupling_weight_matrix, part_presets, sample_clip,
};

fn main() -> Result<(), Box<dyn Error>> {
    run(&std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from))
}

/// Trains and writes FOLDER/model.json.
pub fn run(folder: &Path) -> Result<(), Box<dyn Error>> {
    // Your own clips come from BVH files: read_bvh("walk.bvh", &std::fs::read(path)?)?.into_clip().
    let clips: Vec<Clip> = ["walk-1", "walk-2", "walk-3"].into_iter().filter_map(sample_clip).collect();

    // Split the body into two parts, each with its own latents.
    let presets = part_presets(&clips[0].skeleton);
    let split = presets.into_iter().find(|preset| preset.id == "lower-upper").ok_or("no legs were found")?;

    // Each clip becomes a sequence at 20 frames a second. The data set has the mapping from poses to columns,
    // and the columns of each part.
    let sources: Vec<Source> = clips.iter().map(Source::from).collect();
    let dataset = Dataset::new(&sources, &split.parts, 20.0)?;

    // Few iterations, so that the example takes seconds. The default is 250.
    let settings = VariationalSettings { max_iterations: 60, ..VariationalSettings::default() };
    let seed = 1;
    let mut trainer = Trainer::new(&dataset, &settings.into(), seed)?;
    let progress = trainer.run();
    println!("{} iterations: the bound is {:.0} nats", progress.iteration, progress.best);

    let model = trainer.finish()?;
    let coupled = model.coupled().ok_or("a vCGPDM has couplings")?;
    let weights = coupling_weight_matrix(coupled.alpha());
    for (target, target_part) in split.parts.iter().enumerate() {
        for (source, source_part) in split.parts.iter().enumerate() {
            println!(
                "the {} part drives the {} part with weight {:.2}",
                source_part.name,
                target_part.name,
                weights[(source, target)]
            );
        }
    }

    let path = folder.join("model.json");
    std::fs::write(&path, model.to_json()?)?;
    println!("the model is in {}", path.display());
    Ok(())
}
