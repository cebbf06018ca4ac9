//! `vcgpdm primitives`: lists the primitives of a library, saves some, or adds those of another library.

use crate::clips::{self, Up};
use crate::files;
use crate::library::{primitives_by_part, read};
use crate::numbers::whole;
use crate::train::{objective, train_steps};
use crate::usage::usage;
use serde_json::{Value, json};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;
use vcgpdm::models::SequenceInfo;
use vcgpdm::models::library::{
    ImportFrames, ImportRequest, ImportTrainer, MOST_ITERATIONS, MergeError, Origin, TrainedLibrary,
};

/// Print the primitives of a library with their origins, save some as a file, or add those of a file.
///
/// A saved primitive is a library of its own, with the pose maps to which its latents belong. It is added
/// unchanged if the pose maps are the same, such as to another file of the same training. Otherwise --relearn
/// learns it again under the pose maps of this library: from clips, or from the latents that the file stores
/// of the movements from which it was learned.
#[derive(clap::Args)]
pub struct Arguments {
    /// A library that `vcgpdm train --movement` wrote.
    #[arg(value_name = "LIBRARY.json")]
    library: PathBuf,
    /// Save these primitives, each by its name or by the name of a movement that uses it.
    #[arg(long, value_name = "PART=PRIMITIVE,...", conflicts_with = "add", requires = "out")]
    save: Option<String>,
    /// Add the primitives of this library.
    #[arg(long, value_name = "FILE.json", requires = "out")]
    add: Option<PathBuf>,
    /// Add only these primitives.
    #[arg(long, value_name = "PART=PRIMITIVE,...", requires = "add")]
    only: Option<String>,
    /// Learn the added primitives again, under the pose maps of this library.
    #[arg(long, requires = "add")]
    relearn: bool,
    /// Learn from this clip of their movement, a BVH file or sample:ID; may be given several times.
    #[arg(long = "clip", value_name = "CLIP", requires = "relearn")]
    clips: Vec<PathBuf>,
    #[command(flatten)]
    up: Up,
    /// Learn from rollouts of the movements in the added file, not from the latents that the file stores.
    #[arg(long, requires = "relearn", conflicts_with = "clips")]
    generated: bool,
    /// The primitives of this library for parts of which no primitive is added.
    #[arg(long, value_name = "PART=PRIMITIVE,...", requires = "relearn")]
    with: Option<String>,
    /// Most iterations of --relearn.
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = whole(1..=MOST_ITERATIONS))]
    max_iterations: usize,
    /// Seed of --relearn.
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = whole(0..=u32::MAX))]
    seed: u32,
    /// Write the saved primitives, or the library with the added ones, to this file.
    #[arg(long, value_name = "LIBRARY.json")]
    out: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    arguments.up.check(!arguments.clips.is_empty(), "--clip")?;
    let library = read(&arguments.library)?;
    let Some(out) = &arguments.out else {
        return files::print_json(&summary(&library));
    };
    let read_places = [Some(&arguments.library), arguments.add.as_ref()].into_iter().flatten();
    let read_places = read_places.map(PathBuf::as_path).chain(arguments.clips.iter().map(PathBuf::as_path));
    files::check_writable(out, read_places)?;
    let (written, summary) = match (&arguments.save, &arguments.add) {
        (Some(save), _) => {
            let chosen = library.read_primitives(save).map_err(|error| usage(format!("--save: {error}")))?;
            let saved = library.select(&chosen)?;
            let summary = summary(&saved);
            (saved, summary)
        }
        (None, Some(path)) => add(arguments, library, path)?,
        (None, None) => return Err(usage("--out: expected --save or --add with it")),
    };
    files::write_text(out, &written.to_json()?)?;
    files::print_summary(&summary, &[out])
}

fn add(
    arguments: &Arguments,
    mut library: TrainedLibrary,
    path: &Path,
) -> Result<(TrainedLibrary, Value), Box<dyn Error>> {
    let mut other = read(path)?;
    if let Some(only) = &arguments.only {
        let chosen = other.read_primitives(only).map_err(|error| usage(format!("--only: {error}")))?;
        other = other.select(&chosen)?;
    }
    let (primitives, movements) = (library.library.primitives.len(), library.library.movements.len());
    let mut relearned = Value::Null;
    if arguments.relearn {
        (library, relearned) = relearn(arguments, &library, &other)?;
    } else {
        library.merge(&other).map_err(|error| match &error {
            MergeError::Misfit(misfit) if misfit.can_be_relearned() => format!(
                "{}: {error} (--relearn learns them again under those of this library)",
                path.display()
            )
            .into(),
            _ => files::with_path(path, &error),
        })?;
    }
    let added = (primitives..library.library.primitives.len()).map(|index| primitive(&library, index));
    let learned = library.library.movements[movements..].iter().map(|movement| movement.name.clone());
    let summary = json!({
        "added": added.collect::<Vec<_>>(),
        "movements": learned.collect::<Vec<_>>(),
        "relearned": relearned,
    });
    Ok((library, summary))
}

/// Learns the primitives again. Returns the library with them, and a summary of the training.
fn relearn(
    arguments: &Arguments,
    library: &TrainedLibrary,
    other: &TrainedLibrary,
) -> Result<(TrainedLibrary, Value), Box<dyn Error>> {
    let mut companions = library.companions(other);
    if let Some(with) = &arguments.with {
        for index in library.read_primitives(with).map_err(|error| usage(format!("--with: {error}")))? {
            companions[library.library.primitives[index].part] = Some(index);
        }
    }
    let mut clips = Vec::new();
    for clip in clips::read_all_for(&arguments.clips, &arguments.up, &library.body.mapping)? {
        clips.push(library.encode(&clip)?);
    }
    let frames = match (clips.is_empty(), arguments.generated) {
        (false, _) => ImportFrames::Clips(&clips),
        (true, true) => ImportFrames::Generated,
        (true, false) => other.import_frames(),
    };
    let request =
        ImportRequest { companions, max_iterations: arguments.max_iterations, seed: arguments.seed };
    let begin = Instant::now();
    let mut trainer = ImportTrainer::new(library, other, frames, &request)?;
    let reason = train_steps(|| trainer.step(), objective(&library.provenance.settings))?;
    let progress = trainer.progress();
    let parts = library.body.layout.parts().iter().map(|part| part.name.clone());
    let lost: serde_json::Map<String, Value> =
        parts.zip(trainer.lost().into_iter().map(Value::from)).collect();
    let summary = json!({
        "bound": progress.terms.map(|terms| terms.total()),
        "iterations": progress.iteration,
        "lost": lost,
        "seconds": begin.elapsed().as_secs_f64(),
        "reason": reason,
    });
    Ok((trainer.finish()?, summary))
}

/// The primitives with their origins, and the movements.
fn summary(library: &TrainedLibrary) -> Value {
    let parts = library.body.layout.parts();
    let primitives: Vec<Value> =
        (0..library.library.primitives.len()).map(|index| primitive(library, index)).collect();
    let movements = library.library.movements.iter().map(|movement| {
        let uses = primitives_by_part(library, &movement.uses);
        json!({ "name": movement.name, "uses": uses, "learned": movement.sums.is_some() })
    });
    json!({
        "parts": parts.iter().map(|part| &part.name).collect::<Vec<_>>(),
        "primitives": primitives,
        "movements": movements.collect::<Vec<_>>(),
    })
}

fn primitive(library: &TrainedLibrary, index: usize) -> Value {
    let primitive = &library.library.primitives[index];
    let names = |clips: &[SequenceInfo]| clips.iter().map(|clip| clip.name.clone()).collect::<Vec<_>>();
    let Origin { training, clips, relearned } = library.origin(index);
    let relearned = relearned.map(|relearned| {
        json!({
            "primitive": relearned.primitive,
            "frames": relearned.frames.id(),
            "clips": names(&relearned.clips),
        })
    });
    json!({
        "part": library.body.layout.parts()[primitive.part].name,
        "name": primitive.name,
        "origin": {
            "engine": training.engine,
            "seed": training.seed,
            "bound": training.bound(),
            "iterations": training.iterations,
            "clips": names(&clips),
            "relearned": relearned,
            "note": training.note,
        },
    })
}
