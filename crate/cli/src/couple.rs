//! `vcgpdm couple`: combines primitives of a library in a new way.

use crate::clips::Up;
use crate::numbers::whole;
use crate::train::{objective, train_steps};
use crate::usage::usage;
use crate::{clips, files, library};
use serde_json::json;
use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm_core::models::library::{CouplingTrainer, CouplingsFrom, MOST_ITERATIONS};

/// Combine primitives of a library into a model, and print its couplings as one JSON object.
///
/// The primitives stay as they were learned. With clips, the couplings are fitted to the clips. Without
/// clips, the coupling from one part to another comes from a trained movement that uses the primitives of
/// both. Primitives that never met get the largest variance, so that their parts hardly listen to each other.
#[derive(clap::Args)]
pub struct Arguments {
    /// A library that `vcgpdm train --movement` wrote.
    #[arg(value_name = "LIBRARY.json")]
    library: PathBuf,
    /// The primitive of each part, by its name or by the name of a movement that uses it.
    #[arg(long = "use", value_name = "PART=PRIMITIVE,...")]
    uses: String,
    /// Fit the couplings to this clip, a BVH file or sample:ID; may be given several times.
    #[arg(long = "clip", value_name = "CLIP")]
    clips: Vec<PathBuf>,
    #[command(flatten)]
    up: Up,
    /// Most iterations of the fit.
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = whole(1..=MOST_ITERATIONS))]
    max_iterations: usize,
    /// Write the model of the combination to this file.
    #[arg(long, value_name = "MODEL.json")]
    out: PathBuf,
    /// Write the library with the combination as a movement of this name.
    #[arg(long, value_name = "NAME", requires = "library_out")]
    name: Option<String>,
    /// Where to write that library.
    #[arg(long, value_name = "LIBRARY.json", requires = "name")]
    library_out: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    arguments.up.check(!arguments.clips.is_empty(), "--clip")?;
    let mut trained = library::read(&arguments.library)?;
    let uses = trained.read_uses(&arguments.uses).map_err(|error| usage(format!("--use: {error}")))?;
    let read = arguments.clips.iter().map(PathBuf::as_path).chain([arguments.library.as_path()]);
    let library_out = arguments.library_out.as_deref().map(|path| ("--library-out", path));
    files::check_outs([Some(("--out", arguments.out.as_path())), library_out].into_iter().flatten(), read)?;
    // Without a name the combination is not stored in a library.
    let name = arguments.name.as_deref().unwrap_or_default();
    trained.check_name(name).map_err(|error| usage(format!("--name: {error}")))?;
    let begin = Instant::now();
    let mut reason = None;
    // The library already has a combination that was recorded, with its data.
    let recorded = trained
        .library
        .recorded_movement(&uses)
        .filter(|_| arguments.clips.is_empty() && arguments.name.is_none());
    if recorded.is_none() {
        if arguments.clips.is_empty() {
            let sequences = trained.start_infos(&uses);
            trained.add(trained.library.nearest_combination(name, &uses)?, sequences)?;
        } else {
            let mut clips = Vec::new();
            for clip in clips::read_all_for(&arguments.clips, &arguments.up, &trained.body.mapping)? {
                clips.push(trained.encode(&clip)?);
            }
            let mut trainer = CouplingTrainer::new(&trained, &uses, &clips, arguments.max_iterations)?;
            reason = Some(train_steps(|| trainer.step(), objective(&trained.provenance.settings))?);
            trained = trainer.finish(name)?;
        }
    }
    let seconds = begin.elapsed().as_secs_f64();
    let index = recorded.unwrap_or(trained.library.movements.len() - 1);
    let movement = &trained.library.movements[index];
    let mut from = serde_json::to_value(&movement.couplings)?;
    if let CouplingsFrom::Clips { .. } = movement.couplings {
        from["reason"] = json!(reason);
    }
    let alpha = files::rows(&movement.alpha);
    let model = trained.movement(index)?;
    files::write_text(&arguments.out, &model.to_json()?)?;
    let mut outs = vec![arguments.out.as_path()];
    if let Some(path) = &arguments.library_out {
        files::write_text(path, &trained.to_json()?)?;
        outs.push(path);
    }
    let summary = json!({ "uses": arguments.uses, "alpha": alpha, "couplings": from, "seconds": seconds });
    files::print_summary(&summary, &outs)
}
