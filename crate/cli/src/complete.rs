//! `vcgpdm complete`: infers the parts of a clip that are not given.

use crate::clips::{self, Names, Up};
use crate::files;
use crate::numbers::check_within;
use crate::rollout;
use crate::usage::usage;
use serde_json::json;
use std::collections::BTreeMap;
use std::error::Error;
use std::path::PathBuf;
use vcgpdm_core::models::{Body, Model, PartCompletion, RolloutRequest};

/// Infer the other parts of a clip from the given ones, and print their errors as one JSON object.
///
/// The model observes the given parts in all frames; the other parts of the clip are only compared with what
/// the model infers. For each of them: the mean squared error over all frames and columns, that of the mean
/// pose of the training clips, the share of the numbers within the 95 % band, and the mean log density of a
/// frame, in nats. The band and the density are those of the columns that changed in training. With --until,
/// these are the numbers until then, and after_cut has those from there on.
#[derive(clap::Args)]
pub struct Arguments {
    /// A trained vcgpdm model of a body.
    #[arg(value_name = "MODEL.json")]
    model: PathBuf,
    /// The clip: a BVH file of the same body, or sample:ID.
    #[arg(value_name = "CLIP")]
    clip: PathBuf,
    /// The parts that are observed, by name or number, from 0.
    #[arg(long, value_name = "PART,...", required = true, value_delimiter = ',')]
    given: Vec<String>,
    /// Observe the given parts until this time of the clip, in seconds; from there on the model goes on by
    /// itself.
    #[arg(long, value_name = "SECONDS")]
    until: Option<f64>,
    /// Write the completed motion to this file: the given parts as recorded, the others as inferred.
    #[arg(long, value_name = "OUT.bvh")]
    out: Option<PathBuf>,
    #[command(flatten)]
    names: Names,
    #[command(flatten)]
    up: Up,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let model = rollout::read_model(&arguments.model)?;
    let Some(coupled) = model.coupled() else {
        let (path, kind) = (arguments.model.display(), model.kind().id());
        return Err(format!("{path}: expected a vcgpdm model, found a {kind} model").into());
    };
    let given = given(&arguments.given, &model.body)?;
    let read = [arguments.model.as_path(), arguments.clip.as_path()];
    files::check_outs(arguments.out.iter().map(|out| ("--out", out)), read)?;
    let clip = clips::read_for(&arguments.clip, &arguments.up, &model.body.mapping)?;
    let columns = model.body.encode(&clip)?;
    let cut = arguments.until.map(|until| frame_of(until, &model, columns.nrows())).transpose()?;
    let completed = coupled
        .complete(&RolloutRequest::default(), &columns, &given, cut)
        .map_err(|error| format!("{}: {error}", clip.name))?;
    let parts = model.body.layout.parts();
    let names: Vec<&str> = given.iter().map(|&part| parts[part].name.as_str()).collect();
    if let Some(out) = &arguments.out {
        let clip = model.body.clip(&completed.y, &files::name_of(out))?;
        files::write_text(out, &arguments.names.bvh(clip))?;
    }
    let scores: BTreeMap<&str, PartCompletion> =
        completed.parts.iter().map(|(part, score)| (parts[*part].name.as_str(), *score)).collect();
    let summary = json!({
        "clip": clip.name,
        "frames": completed.y.nrows(),
        "given": names,
        "parts": scores,
    });
    files::print_summary(&summary, &arguments.out.iter().map(PathBuf::as_path).collect::<Vec<_>>())
}

/// The frame of this time of a clip of `frames` frames.
fn frame_of(until: f64, model: &Model, frames: usize) -> Result<usize, Box<dyn Error>> {
    let step = model.body.frame_time;
    let order = model.coupled().map_or(0, |coupled| coupled.order());
    check_within("--until", "seconds", order as f64 * step..=(frames - 1) as f64 * step, until)?;
    Ok((until / step).round() as usize)
}

/// The numbers of the parts with these names.
fn given(words: &[String], body: &Body) -> Result<Vec<usize>, Box<dyn Error>> {
    let names = rollout::part_names(body);
    let mut given = Vec::new();
    for word in words {
        let part = rollout::part_index(word, &names).ok_or_else(|| {
            usage(format!("--given {word}: expected one of the parts {}", names.join(", ")))
        })?;
        if !given.contains(&part) {
            given.push(part);
        }
    }
    if given.len() == names.len() {
        let found = names.join(", ");
        return Err(usage(format!(
            "--given: expected a part of the model that is not given, found all: {found}"
        )));
    }
    Ok(given)
}
