//! `vcgpdm score`: the error of a rollout compared with a whole trial.

use crate::clips::{self, Up};
use crate::files;
use crate::numbers::whole;
use std::error::Error;
use std::path::PathBuf;
use vcgpdm_lab::evaluation::dtw_mse;

/// Print the error of a rollout compared with a whole trial, after dynamic time warping, as one JSON object.
#[derive(clap::Args)]
pub struct Arguments {
    /// A trained model of a body, of any kind.
    #[arg(value_name = "MODEL.json")]
    model: PathBuf,
    /// The trial: a BVH file of the same body, or sample:ID.
    #[arg(value_name = "CLIP")]
    clip: PathBuf,
    #[command(flatten)]
    up: Up,
    /// Start where this training sequence starts, counted from 0 in the order of the training.
    #[arg(long, value_name = "SEQUENCE", default_value_t = 0, value_parser = whole::<usize>(0..))]
    from: usize,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let model = crate::rollout::read_model(&arguments.model)?;
    let body = &model.body;
    let clip = clips::read_for(&arguments.clip, &arguments.up, &body.mapping)?;
    let actual = body.encode(&clip)?;
    let predicted = model.rollout(arguments.from, actual.nrows())?;
    files::print_json(&dtw_mse(&predicted, &actual)?)
}
