//! `vcgpdm primitives`: what a library holds, and primitives on their way from one library to another.

use crate::files;
use crate::numbers::whole;
use crate::train::train_steps;
use crate::usage::usage;
use serde_json::{Value, json};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;
use vcgpdm::models::SequenceInfo;
use vcgpdm::models::library::{
    ImportFrames, ImportRequest, ImportTrainer, LearnedMovement, MOST_ITERATIONS, Origin, TakeInError,
    TrainedLibrary,
};

/// Print the primitives of a library with where each comes from, save some as a file, or add those of a file.
///
/// A saved primitive is a library of its own, with the pose maps that its latents mean something under. It is
/// added as it is where the pose maps are the same, such as to another file of the same training. Otherwise
/// --relearn learns it again under the pose maps of this library: from clips, or from what the file keeps of
/// the movements that it was learned from.
#[derive(clap::Args)]
pub struct Arguments {
    /// A library that `vcgpdm train --movement` wrote.
    #[arg(value_name = "LIBRARY.json")]
    library: PathBuf,
    /// Save these primitives, each by its name or by that of a movement that uses it.
    #[arg(long, value_name = "PART=PRIMITIVE,...", conflicts_with = "add", requires = "out")]
    save: Option<String>,
    /// Add the primitives of this library.
    #[arg(long, value_name = "FILE.json", requires = "out")]
    add: Option<PathBuf>,
    /// Of the library that is added, only these.
    #[arg(long, value_name = "PART=PRIMITIVE,...", requires = "add")]
    only: Option<String>,
    /// Learn the added primitives again, under the pose maps of this library.
    #[arg(long, requires = "add")]
    relearn: bool,
    /// Learn from this clip of their movement, a BVH file or sample:ID; may be given several times.
    #[arg(long = "clip", value_name = "CLIP", requires = "relearn")]
    clips: Vec<PathBuf>,
    /// Learn from rollouts of the movements in the added file, in the place of the latents that it keeps of
    /// them.
    #[arg(long, requires = "relearn", conflicts_with = "clips")]
    generated: bool,
    /// The primitives of this library that take part for parts that bring none of their own.
    #[arg(long, value_name = "PART=PRIMITIVE,...", requires = "relearn")]
    with: Option<String>,
    /// Most iterations of learning again.
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = whole(1..=MOST_ITERATIONS))]
    max_iterations: usize,
    /// Seed of everything random in it.
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = whole(0..=u32::MAX))]
    seed: u32,
    /// Write the saved primitives, or the library with the added ones, to this file.
    #[arg(long, value_name = "LIBRARY.json")]
    out: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let library = read(&arguments.library)?;
    let Some(out) = &arguments.out else {
        return files::print_json(&listed(&library));
    };
    let read_places = [Some(&arguments.library), arguments.add.as_ref()].into_iter().flatten();
    let read_places = read_places.map(PathBuf::as_path).chain(arguments.clips.iter().map(PathBuf::as_path));
    files::check_writable(out, read_places)?;
    let (written, summary) = match (&arguments.save, &arguments.add) {
        (Some(save), _) => {
            let chosen = library.chosen(save).map_err(|error| usage(format!("--save: {error}")))?;
            let saved = library.select(&chosen)?;
            let summary = listed(&saved);
            (saved, summary)
        }
        (None, Some(add)) => added(arguments, library, add)?,
        (None, None) => return Err(usage("--out: expected --save or --add with it")),
    };
    files::write_text(out, &written.to_json()?)?;
    files::print_summary(&summary, &[out])
}

fn read(path: &Path) -> Result<TrainedLibrary, Box<dyn Error>> {
    TrainedLibrary::from_json(&files::read_text(path)?).map_err(|error| files::with_path(path, &error))
}

fn added(
    arguments: &Arguments,
    mut library: TrainedLibrary,
    add: &Path,
) -> Result<(TrainedLibrary, Value), Box<dyn Error>> {
    let mut other = read(add)?;
    if let Some(only) = &arguments.only {
        let chosen = other.chosen(only).map_err(|error| usage(format!("--only: {error}")))?;
        other = other.select(&chosen)?;
    }
    let (primitives, movements) = (library.library.primitives.len(), library.library.movements.len());
    let mut relearned = Value::Null;
    if arguments.relearn {
        (library, relearned) = relearn(arguments, &library, &other)?;
    } else {
        library.take_in(&other).map_err(|error| match &error {
            TakeInError::Misfit(misfit) if misfit.can_be_relearned() => format!(
                "{}: {error} (--relearn learns them again under those of this library)",
                add.display()
            )
            .into(),
            _ => files::with_path(add, &error),
        })?;
    }
    let new = (primitives..library.library.primitives.len()).map(|a| primitive(&library, a));
    let learned = library.library.movements[movements..].iter().map(|movement| movement.name.clone());
    let summary = json!({
        "added": new.collect::<Vec<_>>(),
        "movements": learned.collect::<Vec<_>>(),
        "relearned": relearned,
    });
    Ok((library, summary))
}

/// The library with the primitives learned again, and how that went.
fn relearn(
    arguments: &Arguments,
    library: &TrainedLibrary,
    other: &TrainedLibrary,
) -> Result<(TrainedLibrary, Value), Box<dyn Error>> {
    let mut companions = library.companions(other);
    if let Some(with) = &arguments.with {
        for a in library.chosen(with).map_err(|error| usage(format!("--with: {error}")))? {
            companions[library.library.primitives[a].part] = Some(a);
        }
    }
    let mut clips = Vec::new();
    for clip in files::read_clips(&arguments.clips)? {
        clips.push(library.observed(&clip)?);
    }
    let frames = match (clips.is_empty(), arguments.generated) {
        (false, _) => ImportFrames::Clips(&clips),
        (true, true) => ImportFrames::Generated,
        (true, false) => other.own_frames(),
    };
    let request =
        ImportRequest { companions, max_iterations: arguments.max_iterations, seed: arguments.seed };
    let begin = Instant::now();
    let mut trainer = ImportTrainer::new(library, other, frames, &request)?;
    let reason = train_steps(|| trainer.step(), "bound")?;
    let progress = trainer.progress();
    let parts = library.body.layout.parts().iter().map(|part| part.name.clone());
    let lost: serde_json::Map<String, Value> =
        parts.zip(trainer.lost().into_iter().map(Value::from)).collect();
    let summary = json!({
        "bound": progress.best,
        "iterations": progress.iteration,
        "lost": lost,
        "seconds": begin.elapsed().as_secs_f64(),
        "reason": reason,
    });
    Ok((trainer.finish()?, summary))
}

/// Primitives with where they come from, and movements.
fn listed(library: &TrainedLibrary) -> Value {
    let parts = library.body.layout.parts();
    let primitives: Vec<Value> =
        (0..library.library.primitives.len()).map(|a| primitive(library, a)).collect();
    let movements = library.library.movements.iter().map(|movement| {
        let uses = by_part(library, movement);
        json!({ "name": movement.name, "uses": uses, "learned": movement.sums.is_some() })
    });
    json!({
        "parts": parts.iter().map(|part| &part.name).collect::<Vec<_>>(),
        "primitives": primitives,
        "movements": movements.collect::<Vec<_>>(),
    })
}

/// The primitive of each part in a movement, by their names.
pub fn by_part(library: &TrainedLibrary, movement: &LearnedMovement) -> serde_json::Map<String, Value> {
    let parts = library.body.layout.parts().iter().zip(&movement.uses);
    parts.map(|(part, a)| (part.name.clone(), library.library.primitives[*a].name.clone().into())).collect()
}

fn primitive(library: &TrainedLibrary, a: usize) -> Value {
    let known = &library.library.primitives[a];
    let names = |clips: &[SequenceInfo]| clips.iter().map(|clip| clip.name.clone()).collect::<Vec<_>>();
    let Origin { training, clips, relearned } = library.origin(a);
    let relearned = relearned.map(|relearned| {
        json!({
            "primitive": relearned.primitive,
            "frames": relearned.frames.id(),
            "clips": names(&relearned.clips),
        })
    });
    json!({
        "part": library.body.layout.parts()[known.part].name,
        "name": known.name,
        "origin": {
            "engine": training.engine,
            "seed": training.seed,
            "bound": training.objective,
            "iterations": training.iterations,
            "clips": names(&clips),
            "relearned": relearned,
            "note": training.note,
        },
    })
}
