//! `vcgpdm recognise`: which movement of a library a clip shows, moment by moment.

use crate::clips::{self, Up};
use crate::files;
use crate::library::{primitives_by_part, read};
use serde_json::{Value, json};
use std::error::Error;
use std::path::PathBuf;
use vcgpdm::models::library::Segment;

/// Print which movement of a library clips show, moment by moment, as one JSON object.
///
/// Every movement of the library is a model of the clips. Several clips count as one recording, in the order
/// given; each begins where the one before ends. `segments` are the times in which one movement is
/// the likeliest, in seconds, with the primitives of its parts and the mean of its probability; `share` is
/// the share of the frames that each movement has. The library need not be trained on the clips.
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
    /// Write the probability of every movement in every frame to this file.
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
        json!({
            "movement": names[*movement],
            "from": frames.start as f64 * frame_time,
            "to": frames.end as f64 * frame_time,
            "probability": probability,
            "primitives": primitives_by_part(&library, &movements[*movement]),
        })
    };
    let shares = names.iter().zip(found.shares()).map(|(name, share)| ((*name).to_owned(), share.into()));
    let shares: serde_json::Map<String, Value> = shares.collect();
    let summary = json!({
        "clips": clips.iter().map(|clip| clip.name.as_str()).collect::<Vec<_>>(),
        "seconds": found.posterior.nrows() as f64 * frame_time,
        "share": shares,
        "segments": segments.iter().map(segment).collect::<Vec<_>>(),
    });
    let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    if let Some(out) = &arguments.out {
        files::write_text(out, &vcgpdm::series::write(&names, &found.posterior, frame_time))?;
    }
    files::print_summary(&summary, &arguments.out.iter().map(PathBuf::as_path).collect::<Vec<_>>())
}
