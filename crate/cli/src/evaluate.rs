//! `vcgpdm evaluate`: compares models by leave-one-trial-out cross-validation, in parallel and resumable.

use crate::clips::{self, Up};
use crate::numbers::{check_fps, whole};
use crate::progress::{Progress, say};
use crate::store::{Next, Store};
use crate::train::{parts, pose_weight, warn_of_cost, weight};
use crate::usage::usage;
use crate::{files, interrupt};
use serde_json::json;
use std::collections::HashMap;
use std::error::Error;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};
use vcgpdm::models::{
    MOST_BASES, MOST_DIMENSIONS, MOST_INDUCING, MOST_PRIMITIVES, PoseWeight, VariationalSettings,
};
use vcgpdm_lab::evaluation::{
    CandidateKind, ComparisonPlanError, Finished, Fold, Job, Plan, START_FRAMES, Setting, whole_cycles,
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
    let mut folds: HashMap<(usize, usize), Fold> = HashMap::new();
    for job in &jobs {
        let key = (job.held_out, job.training_trials);
        if let std::collections::hash_map::Entry::Vacant(entry) = folds.entry(key) {
            entry.insert(Fold::new(&clips, key.0, key.1, &parts, arguments.fps, start_frames)?);
        }
    }
    let share = share(arguments, jobs.len())?;
    let store = Store::open(&arguments.out, setting)?;
    let (done, open): (Vec<Job>, Vec<Job>) =
        share.map(|k| jobs[k].clone()).partition(|job| store.results().has_outcome(job));

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

/// How often a thread without a job looks whether another program has finished or given up one.
const POLL: Duration = Duration::from_secs(1);

/// Jobs that are shared among threads, and among programs that write the same file.
struct Work {
    /// Number of the jobs.
    jobs: usize,
    stopped: Arc<AtomicBool>,
    state: Mutex<State>,
}

/// How far the work is.
struct State {
    store: Store,
    /// Jobs that are neither finished nor computed by this program.
    open: Vec<Job>,
    progress: Progress,
    /// How far the job of each thread is, 0 to 1. A thread without a job has no entry.
    fractions: HashMap<usize, f64>,
    computed: usize,
    /// Each failed job with the reason.
    failures: Vec<String>,
    problem: Option<String>,
    waited: bool,
}

impl State {
    /// Says once that this program only waits for others.
    fn say_waiting(&mut self) {
        if self.fractions.is_empty() && !self.waited {
            self.waited = true;
            let jobs = self.open.len();
            self.progress.note(&format!("waiting for other programs, which compute {jobs} of the jobs"));
        }
    }

    /// Number of the jobs that are not finished.
    fn left(&self) -> usize {
        self.open.len() + self.fractions.len()
    }
}

impl Work {
    fn new(open: Vec<Job>, store: Store) -> Result<Self, Box<dyn Error>> {
        let stopped = interrupt::flag()?;
        let jobs = open.len();
        let state = State {
            store,
            open,
            progress: Progress::new("about"),
            fractions: HashMap::new(),
            computed: 0,
            failures: Vec::new(),
            problem: None,
            waited: false,
        };
        Ok(Self { jobs, stopped, state: Mutex::new(state) })
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// Computes one job after the other until none is left, or until Ctrl-C.
    fn compute(&self, thread: usize, folds: &HashMap<(usize, usize), Fold>) {
        while !self.is_stopped() {
            let mut state = self.state();
            let State { store, open, .. } = &mut *state;
            let job = match store.claim(open) {
                Ok(Next::Job(job)) => job,
                Ok(Next::Wait) => {
                    state.say_waiting();
                    drop(state);
                    thread::sleep(POLL);
                    continue;
                }
                Ok(Next::Done) => return,
                Err(error) => return self.fail(&mut state, error.as_ref()),
            };
            state.fractions.insert(thread, 0.0);
            drop(state);
            let Some(fold) = folds.get(&(job.held_out, job.training_trials)) else { return };
            let begin = Instant::now();
            let seconds = || begin.elapsed().as_secs_f64();
            let outcome = fold.evaluate(&job.candidate, job.seed, &seconds, &mut |progress| {
                self.show(thread, progress.fraction);
                !self.is_stopped()
            });
            let result = match outcome {
                Ok(Some(outcome)) => Ok(outcome),
                Ok(None) => return,
                Err(error) => Err(error.to_string()),
            };
            let mut state = self.state();
            let ending = match &result {
                Ok(_) => "done".to_owned(),
                Err(reason) => {
                    state.failures.push(format!("{job}: {reason}"));
                    format!("failed: {reason}")
                }
            };
            let (id, trial, seed) = (job.candidate.kind().id(), job.held_out + 1, job.seed);
            if let Err(error) = state.store.add(Finished::new(job, result)) {
                return self.fail(&mut state, error.as_ref());
            }
            state.fractions.remove(&thread);
            state.computed += 1;
            let (done, jobs) = (self.jobs - state.left(), self.jobs);
            state.progress.log(|| {
                let seconds = seconds();
                format!("{done} of {jobs} jobs: {id}, trial {trial} held out, seed {seed}, {ending} in {seconds:.1} s")
            });
            self.show_state(&mut state);
        }
    }

    /// Stops all threads because of an error of the results file.
    fn fail(&self, state: &mut State, error: &dyn Error) {
        state.problem = Some(error.to_string());
        self.stopped.store(true, Ordering::Relaxed);
    }

    fn show(&self, thread: usize, fraction: f64) {
        let mut state = self.state();
        state.fractions.insert(thread, fraction);
        self.show_state(&mut state);
    }

    fn show_state(&self, state: &mut State) {
        let (done, jobs) = (self.jobs - state.left(), self.jobs);
        let fraction = (done as f64 + state.fractions.values().sum::<f64>()) / jobs.max(1) as f64;
        state.progress.show(fraction, || format!("{done} of {jobs} jobs"));
    }
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
