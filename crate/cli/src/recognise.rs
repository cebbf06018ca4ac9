//! `vcgpdm recognise`: which movement of a library a clip shows, moment by moment.

use crate::clips::{self, Up};
use crate::files;
use crate::library::{primitives_by_part, read};
use nalgebra::DMatrix;
use serde_json::{Value, json};
use std::error::Error;
use std::path::PathBuf;
use vcgpdm::models::library::Segment;

/// Print which movement of a library clips show, moment by moment, as one JSON object.
///
/// Every movement of the library is a model of the clips. Several clips count as one recording, in the order
/// given; each begins where the one before ends. `segments` are the times in which one movement is
/// the likeliest, in seconds, with the primitives of its parts and the mean of its probability; `share` is
/// the share of the frames that each movement has. `log_density` is the mean log density of a frame, in nats:
/// under each movement, and in a segment under its own. The library need not be trained on the clips.
#[derive(clap::Args)]
pub struct Arguments {
    /// A library that `vcgpdm train --movement` wrote, of two movements or more.
    #[arg(value_name = "LIBRARY.json")]
    library: PathBuf,
    /// BVH files of the same body, or sample:ID.
    #[arg(value_name = "CLIP", required = true)]
    clips: Vec<PathBuf>,
    #[command(flatten)]
    up: Up,
    /// Write the probability of every movement in every frame to this file, and the log density of the frame
    /// under the movement, in nats.
    #[arg(long, value_name = "OUT.csv")]
    out: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let library = read(&arguments.library)?;
    let movements = &library.library.movements;
    if movements.len() < 2 {
        let (path, found) = (arguments.library.display(), movements.len());
        return Err(format!("{path}: expected a library of two movements or more, found {found}").into());
    }
    let read = std::iter::once(&arguments.library).chain(&arguments.clips).map(PathBuf::as_path);
    files::check_outs(arguments.out.iter().map(|out| ("--out", out)), read)?;
    let clips = clips::read_all(&arguments.clips, &arguments.up)?;
    let found = library.recognise(&clips.iter().collect::<Vec<_>>())?;
    let names: Vec<&str> = movements.iter().map(|movement| movement.name.as_str()).collect();
    let frame_time = library.body.frame_time;
    let segments = found.segments();
    let segment = |Segment { movement, frames, probability }: &Segment| {
        let densities = found.log_densities.rows(frames.start, frames.len());
        json!({
            "movement": names[*movement],
            "from": frames.start as f64 * frame_time,
            "to": frames.end as f64 * frame_time,
            "probability": probability,
            "log_density": densities.column(*movement).mean(),
            "primitives": primitives_by_part(&library, &movements[*movement]),
        })
    };
    let by_movement = |numbers: Vec<f64>| -> serde_json::Map<String, Value> {
        names.iter().zip(numbers).map(|(name, number)| ((*name).to_owned(), number.into())).collect()
    };
    let densities = found.log_densities.column_iter().map(|column| column.mean());
    let summary = json!({
        "clips": clips.iter().map(|clip| clip.name.as_str()).collect::<Vec<_>>(),
        "seconds": found.posterior.nrows() as f64 * frame_time,
        "share": by_movement(found.shares()),
        "log_density": by_movement(densities.collect()),
        "segments": segments.iter().map(segment).collect::<Vec<_>>(),
    });
    if let Some(out) = &arguments.out {
        let densities = names.iter().map(|name| format!("{name} log density"));
        let columns: Vec<String> = names.iter().map(|name| (*name).to_owned()).chain(densities).collect();
        let count = names.len();
        let table = DMatrix::from_fn(found.posterior.nrows(), columns.len(), |frame, column| {
            if column < count {
                found.posterior[(frame, column)]
            } else {
                found.log_densities[(frame, column - count)]
            }
        });
        files::write_text(out, &vcgpdm::series::write(&columns, &table, frame_time))?;
    }
    files::print_summary(&summary, &arguments.out.iter().map(PathBuf::as_path).collect::<Vec<_>>())
}
