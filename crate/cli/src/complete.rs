//! `vcgpdm complete`: infers the parts of a clip that are not given.

use crate::files;
use crate::rollout;
use crate::usage::usage;
use nalgebra::DMatrix;
use serde_json::{Map, json};
use std::error::Error;
use std::path::PathBuf;
use vcgpdm::models::{Body, Coupled, RolloutRequest};
use vcgpdm::motion::bvh;

/// Infer the other parts of a clip from the given ones, and print their errors as one JSON object.
///
/// The model observes the given parts in all frames; the other parts of the clip are only compared with what
/// the model infers. For each of them: the mean squared error over all frames and columns, that of the mean
/// pose of the training clips, the share of the numbers within the 95 % band, and the mean log density of a
/// frame, in nats. The band and the density are those of the columns that changed in training.
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
    /// Write the completed motion to this file: the given parts as recorded, the others as inferred.
    #[arg(long, value_name = "OUT.bvh")]
    out: Option<PathBuf>,
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
    let clip = files::read_clip(&arguments.clip)?;
    let columns = rollout::columns(&model.body, &arguments.model, &clip)?;
    let completed = complete(coupled, &clip.name, &columns, &given)?;
    let parts = model.body.layout.parts();
    let names: Vec<&str> = given.iter().map(|&part| parts[part].name.as_str()).collect();
    if let Some(out) = &arguments.out {
        files::write_text(out, &bvh::write(&model.body.clip(&completed.y, &files::name_of(out))?))?;
    }
    let summary = json!({
        "clip": clip.name,
        "frames": completed.y.nrows(),
        "given": names,
        "parts": completed.scores,
    });
    files::print_summary(&summary, &arguments.out.iter().map(PathBuf::as_path).collect::<Vec<_>>())
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

/// A completed clip.
struct Completed {
    /// All columns [frames x D].
    y: DMatrix<f64>,
    /// The scores of the parts that were not given, by name.
    scores: Map<String, serde_json::Value>,
}

/// Completes the recorded columns [frames x D] of a clip.
fn complete(
    model: Coupled,
    clip: &str,
    columns: &DMatrix<f64>,
    given: &[usize],
) -> Result<Completed, Box<dyn Error>> {
    let body = model.body;
    let recorded = body.centred(columns);
    let mut observed = recorded.clone();
    let mut shown = recorded.clone();
    let others: Vec<usize> = (0..recorded.len()).filter(|part| !given.contains(part)).collect();
    for &part in &others {
        observed[part].fill(f64::NAN);
    }
    let filter = model.filter(&RolloutRequest::default())?;
    let latents = model.infer(&filter, &observed).map_err(|error| format!("{clip}: {error}"))?;
    let mut scores = Map::new();
    for &part in &others {
        shown[part] = filter.mean_columns(part, &latents)?;
        let score = filter.score(part, &latents, &recorded[part])?;
        scores.insert(body.layout.parts()[part].name.clone(), serde_json::to_value(score)?);
    }
    Ok(Completed { y: body.columns(&shown), scores })
}
