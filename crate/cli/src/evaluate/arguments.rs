//! The arguments of `vcgpdm evaluate`.

use crate::clips::Up;
use crate::numbers::whole;
use crate::train::pose_weight;
use crate::usage::usage;
use std::error::Error;
use std::path::PathBuf;
use vcgpdm_core::models::{MOST_BASES, MOST_DIMENSIONS, MOST_INDUCING, PoseWeight, VariationalSettings};
use vcgpdm_lab::evaluation::{CandidateKind, START_FRAMES};

/// Compare models: train each on all trials but one, predict this trial from its first frames, and store the
/// error.
///
/// The exit status is 1 when all jobs failed. If only some failed, the first failure is printed at the end.
/// Coupled models are left out for a body in one part. Several programs can work on one file of results: a
/// job that one of them computes is not computed by another.
#[derive(clap::Args)]
pub struct Arguments {
    /// BVH files, or sample:ID; each is a trial.
    #[arg(value_name = "CLIP", required = true)]
    pub clips: Vec<PathBuf>,
    /// The models: all, or ids (vcgpdm, vgpdm, map-gpdm, map-cgpdm, tmp, dmp-discrete, dmp-rhythmic, promp,
    /// ar).
    ///
    /// promp: probabilistic movement primitives; ar: an autoregression on principal components. These two are
    /// only compared: they cannot be saved.
    #[arg(long, value_name = "all|ID,ID", default_value = "all")]
    pub models: String,
    /// How the coupled models split the body, as for `train`.
    #[arg(long, value_name = "lower,upper|FILE")]
    pub parts: String,
    /// The trials that are held out, one after the other: all, or numbers from 1.
    #[arg(long, value_name = "all|N,N", default_value = "all")]
    pub folds: String,
    /// Seeds of the models that have a seed.
    #[arg(long, value_name = "S,S", value_delimiter = ',', default_values_t = [0], value_parser = whole(0..=u32::MAX))]
    pub seeds: Vec<u32>,
    /// Inducing points of every dynamics map of the variational models, and of every pose map if --pose-ips
    /// is absent: one number, or several to compare.
    #[arg(long, value_name = "K,K", value_delimiter = ',', default_values_t = [12], value_parser = whole(1..=MOST_INDUCING))]
    pub ips: Vec<usize>,
    /// Inducing points of every pose map: each number with each of --ips.
    #[arg(long, value_name = "L,L", value_delimiter = ',', value_parser = whole(1..=MOST_INDUCING))]
    pub pose_ips: Vec<usize>,
    /// Primitives of the TMP over normalised time, with weights that all trials share, nearer to the papers.
    #[arg(long)]
    pub normalised_time: bool,
    /// Numbers of primitives of the TMP: "bound" chooses by the bound.
    #[arg(long, value_name = "bound|N,N", value_delimiter = ',', default_values_t = ["bound".to_owned()])]
    pub primitives: Vec<String>,
    /// Basis functions of every column of the DMPs and the ProMP.
    #[arg(long, value_name = "B,B", value_delimiter = ',', default_values_t = [20], value_parser = whole(1..=MOST_BASES))]
    pub bases: Vec<usize>,
    /// Principal components of the autoregression.
    #[arg(long, value_name = "C,C", value_delimiter = ',', default_values_t = [6], value_parser = whole(1..=MOST_DIMENSIONS))]
    pub components: Vec<usize>,
    /// Numbers of trials to train on, to see how the time grows; absent: all trials but the one held out.
    #[arg(long, value_name = "N,N", value_delimiter = ',', value_parser = whole::<usize>(1..))]
    pub training_trials: Vec<usize>,
    /// Latent dimensions of every part.
    #[arg(long, value_name = "Q", default_value_t = VariationalSettings::default().latent, value_parser = whole(1..=MOST_DIMENSIONS))]
    pub latent: usize,
    /// Frames of history that the dynamics and the autoregression see.
    #[arg(long, value_name = "P", default_value_t = VariationalSettings::default().order, value_parser = whole(1..=MOST_DIMENSIONS))]
    pub order: usize,
    /// Most iterations of the optimiser.
    #[arg(long, value_name = "N", default_value_t = VariationalSettings::default().max_iterations, value_parser = whole::<usize>(0..))]
    pub max_iterations: usize,
    /// Give dynamics and poses of the GPDMs the same weight: balance latent dimensions against the many
    /// columns.
    #[arg(long)]
    pub balanced: bool,
    /// Multiply the pose terms in the objective of the variational models by this number.
    #[arg(long, value_name = "W", conflicts_with = "balanced", value_parser = pose_weight)]
    pub pose_weight: Option<PoseWeight>,
    /// Keep the couplings between the parts of the vCGPDM off.
    #[arg(long)]
    pub uncoupled: bool,
    /// The MAP models have a linear term in the kernels of their dynamics (Wang et al. 2008).
    #[arg(long)]
    pub linear: bool,
    /// Resample the clips to about this number of frames a second.
    #[arg(long, value_name = "F", default_value_t = 30.0)]
    pub fps: f64,
    #[command(flatten)]
    pub up: Up,
    /// Predict from this number of first frames of the trial held out.
    #[arg(long, value_name = "N", default_value_t = START_FRAMES as u16, value_parser = whole(1..=u16::MAX))]
    pub start_frames: u16,
    /// Cut all trials to the same number of whole cycles, from the same phase of the cycle, as the papers do
    /// for the discrete DMP.
    #[arg(long)]
    pub whole_cycles: bool,
    /// Compute only the K-th of N equal shares of the jobs, for a scheduler that distributes the shares.
    #[arg(long, num_args = 3, value_names = ["K", "of", "N"])]
    pub job: Option<Vec<String>>,
    /// Jobs at the same time; absent: one for each core.
    #[arg(long, value_name = "T", value_parser = whole(1..=u16::MAX))]
    pub threads: Option<u16>,
    /// Store the results in this file. Jobs with an outcome in the file are not computed again; jobs that
    /// failed are.
    #[arg(long, value_name = "RESULTS.json")]
    pub out: PathBuf,
}

/// The trials of `--folds`, which counts from 1, counted from 0; for "all" an empty list.
pub fn folds(text: &str, trials: usize) -> Result<Vec<usize>, Box<dyn Error>> {
    if text == "all" {
        return Ok(Vec::new());
    }
    let trial = |word: &str| word.trim().parse::<usize>().ok()?.checked_sub(1).filter(|k| *k < trials);
    text.split(',').map(trial).collect::<Option<_>>().ok_or_else(|| {
        usage(format!("--folds {text}: expected all, or numbers from 1 to {trials} with commas between"))
    })
}

/// The kinds of `--models`.
pub fn models(text: &str) -> Result<Vec<CandidateKind>, Box<dyn Error>> {
    if text == "all" {
        return Ok(CandidateKind::all().collect());
    }
    let kind = |word: &str| {
        CandidateKind::from_id(word.trim()).ok_or_else(|| {
            let ids: Vec<&str> = CandidateKind::all().map(CandidateKind::id).collect();
            usage(format!("--models {word}: expected all, or some of {}", ids.join(", ")))
        })
    };
    text.split(',').map(kind).collect()
}
