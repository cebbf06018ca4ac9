//! `vcgpdm recognise`: which primitive each part uses in a clip, moment by moment.

use crate::clips::{self, Up};
use crate::files;
use crate::library::{primitives_by_part, read};
use nalgebra::DMatrix;
use serde_json::{Map, Value, json};
use std::error::Error;
use std::path::PathBuf;
use vcgpdm_core::models::library::Segment;

/// Print which primitive of a library each part uses in clips, moment by moment, as one JSON object.
///
/// Every movement of the library is a model of each part of the clips. Several clips count as one recording, in
/// the order given; each begins where the one before ends. `segments` are the times in which one combination of
/// primitives is the likeliest, in seconds, with the mean of its probability; `movement` is the movement that uses
/// these primitives, and null where parts use primitives of several movements. `parts` has the share of the frames
/// in which each primitive of the part is the likeliest. `log_density` is the mean log density of the columns of a
/// part in a frame, in nats, of a balanced library with the noise of the weighted poses: under each primitive, and
/// in a segment under those of the segment, all parts together.
/// The library need not be trained on the clips.
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
    /// Write the probability of every primitive of each part in every frame to this file, and the log density of
    /// the part's columns under the primitive, in nats.
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
    let clips = clips::read_all_for(&arguments.clips, &arguments.up, &library.body.mapping)?;
    let found = library.recognise(&clips.iter().collect::<Vec<_>>())?;
    let (primitives, frame_time) = (&library.library.primitives, library.body.frame_time);
    let parts: Vec<&str> = library.body.layout.parts().iter().map(|part| part.name.as_str()).collect();
    let segment = |Segment { uses, frames, probability }: &Segment| {
        let movement = movements.iter().find(|movement| movement.uses == *uses);
        let used = uses.iter().enumerate().zip(&found.primitives);
        let density = used.filter_map(|((part, used), of_part)| {
            let place = of_part.iter().position(|a| a == used)?;
            Some(found.log_densities[part].column(place).rows(frames.start, frames.len()).mean())
        });
        json!({
            "movement": movement.map(|movement| &movement.name),
            "from": frames.start as f64 * frame_time,
            "to": frames.end as f64 * frame_time,
            "probability": probability,
            "log_density": density.sum::<f64>(),
            "primitives": primitives_by_part(&library, uses),
        })
    };
    let segments = found.segments();
    let frames = found.posterior.nrows();
    let mut columns: Vec<(String, Vec<f64>)> = Vec::new();
    let mut by_part = Map::new();
    for (part, of_part) in found.primitives.iter().enumerate() {
        let (posterior, densities) = (found.part_posterior(part), &found.log_densities[part]);
        let (mut shares, mut means) = (Map::new(), Map::new());
        for (place, &primitive) in of_part.iter().enumerate() {
            let name = &primitives[primitive].name;
            let used = segments.iter().filter(|segment| segment.uses[part] == primitive);
            let share = used.map(|segment| segment.frames.len()).sum::<usize>() as f64 / frames as f64;
            let density = densities.column(place);
            shares.insert(name.clone(), share.into());
            means.insert(name.clone(), density.mean().into());
            let column = format!("{} {name}", parts[part]);
            columns.push((column.clone(), posterior.column(place).iter().copied().collect()));
            columns.push((format!("{column} log density"), density.iter().copied().collect()));
        }
        by_part.insert(parts[part].to_owned(), json!({ "share": shares, "log_density": means }));
    }
    let summary = json!({
        "clips": clips.iter().map(|clip| clip.name.as_str()).collect::<Vec<_>>(),
        "seconds": frames as f64 * frame_time,
        "parts": by_part,
        "segments": segments.iter().map(segment).collect::<Vec<Value>>(),
    });
    if let Some(out) = &arguments.out {
        let table = DMatrix::from_fn(frames, columns.len(), |frame, column| columns[column].1[frame]);
        let heads: Vec<String> = columns.into_iter().map(|(head, _)| head).collect();
        files::write_text(out, &vcgpdm_core::series::write(&heads, &table, frame_time))?;
    }
    files::print_summary(&summary, &arguments.out.iter().map(PathBuf::as_path).collect::<Vec<_>>())
}
