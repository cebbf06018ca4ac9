//! `vcgpdm primitives`: lists the primitives of a library, saves some, or adds those of another library.

use crate::files;
use crate::library::{primitives_by_part, read};
use crate::usage::usage;
use serde_json::{Value, json};
use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm_core::models::SequenceInfo;
use vcgpdm_core::models::library::{Origin, TrainedLibrary};

/// Print the primitives of a library with their origins, save some as a file, or add those of a file.
///
/// A saved primitive is a library of its own, with the pose maps to which its latents belong. It is added
/// if the pose maps are the same, such as to another file of the same training.
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
    /// Write the saved primitives, or the library with the added ones, to this file.
    #[arg(long, value_name = "LIBRARY.json")]
    out: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let library = read(&arguments.library)?;
    let Some(out) = &arguments.out else {
        return files::print_json(&summary(&library));
    };
    let read_places = [Some(&arguments.library), arguments.add.as_ref()].into_iter().flatten();
    files::check_writable(out, read_places.map(PathBuf::as_path))?;
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
    library.merge(&other).map_err(|error| files::with_path(path, &error))?;
    let added = (primitives..library.library.primitives.len()).map(|index| primitive(&library, index));
    let learned = library.library.movements[movements..].iter().map(|movement| movement.name.clone());
    let summary = json!({
        "added": added.collect::<Vec<_>>(),
        "movements": learned.collect::<Vec<_>>(),
    });
    Ok((library, summary))
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
