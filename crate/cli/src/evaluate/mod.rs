//! `vcgpdm evaluate`: compares models by leave-one-trial-out cross-validation, in parallel and resumable.

mod folds;
mod work;

use crate::clips::{self, Up};
use crate::evaluate::folds::Folds;
use crate::evaluate::work::Work;
use crate::files;
use crate::numbers::{check_fps, whole};
use crate::progress::say;
use crate::store::Store;
use crate::train::{parts, pose_weight, warn_of_cost, weight};
use crate::usage::usage;
use serde_json::json;
use std::collections::HashMap;
use std::error::Error;
use std::path::PathBuf;
use std::thread;
use vcgpdm::models::{
    MOST_BASES, MOST_DIMENSIONS, MOST_INDUCING, MOST_PRIMITIVES, PoseWeight, VariationalSettings,
};
use vcgpdm_lab::evaluation::{
    CandidateKind, ComparisonPlanError, Fold, Job, ObservedFold, Plan, START_FRAMES, Setting, whole_cycles,
};

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
    clips: Vec<PathBuf>,
    /// The models: all, or ids (vcgpdm, vgpdm, map-gpdm, map-cgpdm, tmp, dmp-discrete, dmp-rhythmic, promp,
    /// ar).
    ///
    /// promp: probabilistic movement primitives; ar: an autoregression on principal components. These two are
    /// only compared: they cannot be saved.
    #[arg(long, value_name = "all|ID,ID", default_value = "all")]
    models: String,
    /// How the coupled models split the body, as for `train`.
    #[arg(long, value_name = "lower,upper|FILE")]
    parts: String,
    /// The trials that are held out, one after the other: all, or numbers from 1.
    #[arg(long, value_name = "all|N,N", default_value = "all")]
    folds: String,
    /// Seeds of the models that have a seed.
    #[arg(long, value_name = "S,S", value_delimiter = ',', default_values_t = [0], value_parser = whole(0..=u32::MAX))]
    seeds: Vec<u32>,
    /// Inducing points of every dynamics map of the variational models, and of every pose map if --pose-ips
    /// is absent: one number, or several to compare.
    #[arg(long, value_name = "K,K", value_delimiter = ',', default_values_t = [12], value_parser = whole(1..=MOST_INDUCING))]
    ips: Vec<usize>,
    /// Inducing points of every pose map: each number with each of --ips.
    #[arg(long, value_name = "L,L", value_delimiter = ',', value_parser = whole(1..=MOST_INDUCING))]
    pose_ips: Vec<usize>,
    /// Primitives of the TMP over normalised time, with weights that all trials share, as in the papers.
    #[arg(long)]
    normalised_time: bool,
    /// Numbers of primitives of the TMP: "bound" chooses by the bound.
    #[arg(long, value_name = "bound|N,N", value_delimiter = ',', default_values_t = ["bound".to_owned()])]
    primitives: Vec<String>,
    /// Basis functions of every column of the DMPs and the ProMP.
    #[arg(long, value_name = "B,B", value_delimiter = ',', default_values_t = [20], value_parser = whole(1..=MOST_BASES))]
    bases: Vec<usize>,
    /// Principal components of the autoregression.
    #[arg(long, value_name = "C,C", value_delimiter = ',', default_values_t = [6], value_parser = whole(1..=MOST_DIMENSIONS))]
    components: Vec<usize>,
    /// Numbers of trials to train on, to see how the time grows; absent: all trials but the one held out.
    #[arg(long, value_name = "N,N", value_delimiter = ',', value_parser = whole::<usize>(1..))]
    training_trials: Vec<usize>,
    /// Latent dimensions of every part.
    #[arg(long, value_name = "Q", default_value_t = VariationalSettings::default().latent, value_parser = whole(1..=MOST_DIMENSIONS))]
    latent: usize,
    /// Frames of history that the dynamics and the autoregression see.
    #[arg(long, value_name = "P", default_value_t = VariationalSettings::default().order, value_parser = whole(1..=MOST_DIMENSIONS))]
    order: usize,
    /// Most iterations of the optimiser.
    #[arg(long, value_name = "N", default_value_t = VariationalSettings::default().max_iterations, value_parser = whole::<usize>(0..))]
    max_iterations: usize,
    /// Give dynamics and poses of the GPDMs the same weight: balance latent dimensions against the many columns.
    #[arg(long)]
    balanced: bool,
    /// Multiply the pose terms in the objective of the variational models by this number.
    #[arg(long, value_name = "W", conflicts_with = "balanced", value_parser = pose_weight)]
    pose_weight: Option<PoseWeight>,
    /// Keep the couplings between the parts of the vCGPDM off.
    #[arg(long)]
    uncoupled: bool,
    /// The MAP models have a linear term in the kernels of their dynamics (Wang et al. 2008).
    #[arg(long)]
    linear: bool,
    /// Resample the clips to about this number of frames a second.
    #[arg(long, value_name = "F", default_value_t = 30.0)]
    fps: f64,
    #[command(flatten)]
    up: Up,
    /// Predict from this number of first frames of the trial held out.
    #[arg(long, value_name = "N", default_value_t = START_FRAMES as u16, value_parser = whole(1..=u16::MAX))]
    start_frames: u16,
    /// Also predict with a variational model that was trained without the trial held out and observes its first
    /// frames.
    #[arg(long)]
    observed_start: bool,
    /// Cut all trials to the same number of whole cycles, from the same phase of the cycle, as the papers do
    /// for the discrete DMP.
    #[arg(long)]
    whole_cycles: bool,
    /// Compute only the K-th of N equal shares of the jobs, for a scheduler that distributes the shares.
    #[arg(long, num_args = 3, value_names = ["K", "of", "N"])]
    job: Option<Vec<String>>,
    /// Jobs at the same time; absent: one for each core.
    #[arg(long, value_name = "T", value_parser = whole(1..=u16::MAX))]
    threads: Option<u16>,
    /// Store the results in this file. Jobs with an outcome in the file are not computed again; jobs that
    /// failed are.
    #[arg(long, value_name = "RESULTS.json")]
    out: PathBuf,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    check_fps(arguments.fps)?;
    let mut clips = clips::read_all(&arguments.clips, &arguments.up)?;
    if arguments.whole_cycles {
        clips = whole_cycles(&clips, arguments.fps)?.0;
    }
    let parts = parts(&arguments.parts, &clips[0].skeleton)?;
    let start_frames = usize::from(arguments.start_frames);
    let setting = Setting::new(&clips, &parts, arguments.fps, start_frames)?;
    let jobs = jobs(arguments, clips.len(), parts.len())?;
    // Making all folds first finds every unusable trial before anything is computed.
    let mut folds: HashMap<(usize, usize), Folds> = HashMap::new();
    for job in &jobs {
        let (held_out, count) = (job.held_out, job.training_trials);
        if let std::collections::hash_map::Entry::Vacant(entry) = folds.entry((held_out, count)) {
            let trained = Fold::new(&clips, held_out, count, &parts, arguments.fps, start_frames)?;
            let observed = || ObservedFold::new(&clips, held_out, count, &parts, arguments.fps);
            let observed = arguments.observed_start.then(observed).transpose()?;
            entry.insert(Folds { trained, observed, start_frames });
        }
    }
    let share = share(arguments, jobs.len())?;
    let store = Store::open(&arguments.out, setting, arguments.observed_start)?;
    let (done, open): (Vec<Job>, Vec<Job>) =
        share.map(|k| jobs[k].clone()).partition(|job| store.is_complete(job));

    let cores = thread::available_parallelism().map_or(1, usize::from);
    let threads = arguments.threads.map_or(cores, usize::from).min(open.len());
    let cost = open.iter().map(|job| job.cost(&clips, &parts, arguments.fps)).sum();
    let work = Work::new(open, store)?;
    warn_of_cost(
        cost,
        threads.max(1),
        "fewer models, folds, seeds or sizes, a lower --fps or fewer iterations",
    );
    thread::scope(|scope| {
        for thread in 0..threads {
            let (work, folds) = (&work, &folds);
            scope.spawn(move || work.compute(thread, folds));
        }
    });
    let state = work.state();
    state.progress.finish();
    if let Some(problem) = &state.problem {
        return Err(problem.clone().into());
    }
    let (computed, failed) = (state.computed, state.failures.len());
    let elsewhere = work.jobs - computed - state.left();
    files::print_json(&json!({
        "jobs": done.len() + work.jobs,
        "computed": computed,
        "known_before": done.len(),
        "computed_elsewhere": elsewhere,
        "left": state.left(),
        "failed": failed,
    }))?;
    let Some(first) = state.failures.first() else { return Ok(()) };
    let message = format!("{failed} of {computed} jobs failed, first {first}");
    if failed == computed && done.len() + elsewhere == 0 {
        return Err(message.into());
    }
    // A workflow goes on with the outcomes: some failures are results like others.
    say(&message);
    Ok(())
}

/// The jobs that the arguments ask for, on `trials` trials of a body in `parts` parts.
fn jobs(arguments: &Arguments, trials: usize, parts: usize) -> Result<Vec<Job>, Box<dyn Error>> {
    let plan = Plan {
        models: models(&arguments.models)?,
        latent: arguments.latent,
        order: arguments.order,
        max_iterations: arguments.max_iterations,
        ips: arguments.ips.clone(),
        pose_ips: arguments.pose_ips.clone(),
        primitives: primitives(&arguments.primitives)?,
        normalised_time: arguments.normalised_time,
        bases: arguments.bases.clone(),
        components: arguments.components.clone(),
        balanced: arguments.balanced,
        pose_weight: weight(arguments.balanced, arguments.pose_weight, PoseWeight::default()),
        uncoupled: arguments.uncoupled,
        linear: arguments.linear,
        held_out: folds(&arguments.folds, trials)?,
        seeds: arguments.seeds.clone(),
        training_trials: arguments.training_trials.clone(),
        growth: false,
    };
    let plan = if parts > 1 { plan } else { without_coupled(plan, &arguments.parts)? };
    plan.jobs(trials).map_err(|error| match error {
        ComparisonPlanError::TrainingTrials { most, found } => {
            usage(format!("--training-trials {found}: expected from 1 to {most} trials"))
        }
        error => error.into(),
    })
}

/// The plan without its coupled models, which have nothing to couple in one part. `split` is the value of
/// `--parts`.
fn without_coupled(plan: Plan, split: &str) -> Result<Plan, Box<dyn Error>> {
    let coupled = plan.models.iter().filter(|kind| kind.is_coupled());
    let coupled = coupled.map(|kind| kind.id()).collect::<Vec<_>>().join(", ");
    let plan = plan.without_coupled();
    if plan.models.is_empty() {
        return Err(usage(format!("--parts {split}: expected two parts or more for {coupled}, found 1")));
    }
    if !coupled.is_empty() {
        say(&format!("--parts {split} is one part: {coupled} left out, which have nothing to couple"));
    }
    Ok(plan)
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

fn primitives(words: &[String]) -> Result<Vec<Option<usize>>, Box<dyn Error>> {
    let number = |word: &String| match (word.trim(), word.trim().parse()) {
        ("bound", _) => Ok(None),
        (_, Ok(count)) if (1..=MOST_PRIMITIVES).contains(&count) => Ok(Some(count)),
        _ => Err(usage(format!(
            "--primitives {word}: expected bound, or a number from 1 to {MOST_PRIMITIVES}"
        ))),
    };
    words.iter().map(number).collect()
}

/// The jobs of the share `--job K of N`: every N-th, so that all shares take about the same time.
fn share(arguments: &Arguments, jobs: usize) -> Result<impl Iterator<Item = usize> + use<>, Box<dyn Error>> {
    let (k, n) = match arguments.job.as_deref() {
        None => (1, 1),
        Some(words) => match (words[0].parse::<usize>(), words[1].as_str(), words[2].parse::<usize>()) {
            (Ok(k), "of", Ok(n)) if k >= 1 && k <= n => (k, n),
            _ => return Err(usage(format!("--job {}: expected K of N with K from 1 to N", words.join(" ")))),
        },
    };
    Ok((k - 1..jobs).step_by(n))
}
