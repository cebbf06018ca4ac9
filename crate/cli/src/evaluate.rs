//! `vcgpdm evaluate`: models compared by leave-one-trial-out cross-validation, in parallel, resumable.

use crate::numbers::{check_fps, whole};
use crate::progress::{Progress, say};
use crate::results::Store;
use crate::train::{parts, warn_of_cost};
use crate::usage::usage;
use crate::{files, interrupt};
use serde_json::json;
use std::collections::HashMap;
use std::error::Error;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;
use vcgpdm::models::{
    MOST_BASES, MOST_DIMENSIONS, MOST_INDUCING, MOST_PRIMITIVES, ModelKind, VariationalSettings,
};
use vcgpdm::motion::Clip;
use vcgpdm_lab::evaluation::{
    ComparisonPlanError, Finished, Fold, Job, Plan, START_FRAMES, Setting, whole_cycles,
};

/// Compare models: train each on all trials but one, predict that one from its first frames, and keep how
/// well it went.
///
/// The exit status is 1 when all jobs failed. Some failures beside outcomes are results like others, and are
/// said at the end. Coupled models are left out for a body in one part.
#[derive(clap::Args)]
pub struct Arguments {
    /// BVH files, or sample:ID; each is a trial.
    #[arg(value_name = "CLIP", required = true)]
    clips: Vec<String>,
    /// Which models: all, or ids (vcgpdm, vgpdm, map-gpdm, map-cgpdm, tmp, dmp-discrete, dmp-rhythmic).
    #[arg(long, value_name = "all|ID,ID", default_value = "all")]
    models: String,
    /// How the coupled models split the body, as for `train`.
    #[arg(long, value_name = "lower,upper|FILE")]
    parts: String,
    /// Which trials are held out, one after the other: all, or numbers from 1.
    #[arg(long, value_name = "all|N,N", default_value = "all")]
    folds: String,
    /// Seeds of the models that have some.
    #[arg(long, value_name = "S,S", value_delimiter = ',', default_values_t = [0], value_parser = whole(0..=u32::MAX))]
    seeds: Vec<u32>,
    /// Inducing points of every dynamics map of the variational models, and of every pose map where
    /// --pose-ips is absent: one number, or several to compare.
    #[arg(long, value_name = "K,K", value_delimiter = ',', default_values_t = [12], value_parser = whole(1..=MOST_INDUCING))]
    ips: Vec<usize>,
    /// Inducing points of every pose map: each number with each of --ips.
    #[arg(long, value_name = "L,L", value_delimiter = ',', value_parser = whole(1..=MOST_INDUCING))]
    pose_ips: Vec<usize>,
    /// The TMP's primitives over normalised time, with weights that all trials share, as in the papers.
    #[arg(long)]
    normalised_time: bool,
    /// Numbers of primitives of the TMP: "bound" chooses by the bound.
    #[arg(long, value_name = "bound|N,N", value_delimiter = ',', default_values_t = ["bound".to_owned()])]
    primitives: Vec<String>,
    /// Basis functions of every column of the DMPs.
    #[arg(long, value_name = "B,B", value_delimiter = ',', default_values_t = [20], value_parser = whole(1..=MOST_BASES))]
    bases: Vec<usize>,
    /// How many of the other trials are trained on, to see how time grows; absent: all.
    #[arg(long, value_name = "N,N", value_delimiter = ',', value_parser = whole::<usize>(1..))]
    training_trials: Vec<usize>,
    /// Latent dimensions of every part.
    #[arg(long, value_name = "Q", default_value_t = VariationalSettings::default().latent, value_parser = whole(1..=MOST_DIMENSIONS))]
    latent: usize,
    /// Frames of history that the dynamics see.
    #[arg(long, value_name = "P", default_value_t = VariationalSettings::default().order, value_parser = whole(1..=MOST_DIMENSIONS))]
    order: usize,
    /// Most iterations of the optimiser.
    #[arg(long, value_name = "N", default_value_t = VariationalSettings::default().max_iterations, value_parser = whole::<usize>(0..))]
    max_iterations: usize,
    /// Balance the dynamics of the MAP models against their many columns.
    #[arg(long)]
    balanced: bool,
    /// The MAP models have a linear term in the kernels of their dynamics (Wang et al. 2008).
    #[arg(long)]
    linear: bool,
    /// Resample the clips to about so many frames a second.
    #[arg(long, value_name = "F", default_value_t = 30.0)]
    fps: f64,
    /// Predict from so many first frames of the trial held out.
    #[arg(long, value_name = "N", default_value_t = START_FRAMES as u16, value_parser = whole(1..=u16::MAX))]
    start_frames: u16,
    /// Cut all trials to equally many whole cycles, from the same place in the cycle, as the papers do for
    /// the discrete DMP.
    #[arg(long)]
    whole_cycles: bool,
    /// Only the K-th of N equal shares of the jobs, for a scheduler that runs the others elsewhere.
    #[arg(long, num_args = 3, value_names = ["K", "of", "N"])]
    job: Option<Vec<String>>,
    /// Jobs at a time; absent: as many as there are cores.
    #[arg(long, value_name = "T", value_parser = whole(1..=u16::MAX))]
    threads: Option<u16>,
    /// Keep the results in this file; jobs that have an outcome in it are not computed again, those that
    /// failed are.
    #[arg(long, value_name = "RESULTS.json")]
    out: PathBuf,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    check_fps(arguments.fps)?;
    let mut clips: Vec<Clip> =
        arguments.clips.iter().map(|place| files::read_clip(place)).collect::<Result<_, _>>()?;
    if arguments.whole_cycles {
        clips = whole_cycles(&clips, arguments.fps)?.0;
    }
    let parts = parts(&arguments.parts, &clips[0].skeleton)?;
    let start_frames = usize::from(arguments.start_frames);
    let setting = Setting::new(&clips, &parts, arguments.fps, start_frames)?;
    let asked = jobs(arguments, clips.len(), parts.len())?;
    // Whatever cannot be used is found before anything is computed.
    let mut folds: HashMap<(usize, usize), Fold> = HashMap::new();
    for job in &asked {
        let key = (job.held_out, job.training_trials);
        if let std::collections::hash_map::Entry::Vacant(entry) = folds.entry(key) {
            entry.insert(Fold::new(&clips, key.0, key.1, &parts, arguments.fps, start_frames)?);
        }
    }
    let share = share(arguments, asked.len())?;
    let store = Store::open(&arguments.out, setting)?;
    let (known, open): (Vec<Job>, Vec<Job>) =
        share.map(|k| asked[k].clone()).partition(|job| store.results().has_outcome(job));

    let work = Work::new(open, store)?;
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = arguments.threads.map_or(cores, usize::from).min(work.jobs.len());
    let cost = work.jobs.iter().map(|job| job.cost(&clips, &parts, arguments.fps)).sum();
    warn_of_cost(
        cost,
        threads.max(1),
        "fewer models, folds, seeds or sizes, a lower --fps or fewer iterations",
    );
    std::thread::scope(|scope| {
        for thread in 0..threads {
            let (work, folds) = (&work, &folds);
            scope.spawn(move || work.go_on(thread, folds));
        }
    });
    let progress = work.standing();
    progress.shown.finish();
    if let Some(problem) = &progress.problem {
        return Err(problem.clone().into());
    }
    let (computed, failed) = (progress.done, progress.failures.len());
    files::print_json(&json!({
        "jobs": known.len() + work.jobs.len(),
        "computed": computed,
        "known_before": known.len(),
        "left": work.jobs.len() - computed,
        "failed": failed,
    }))?;
    let Some(first) = progress.failures.first() else { return Ok(()) };
    let words = format!("{failed} of {computed} jobs failed, first {first}");
    if failed == computed && known.is_empty() {
        return Err(words.into());
    }
    // A failure beside outcomes is one of the results: whoever computes shares goes on to put them together.
    say(&words);
    Ok(())
}

/// Jobs that are shared out to threads, and where they stand.
struct Work {
    jobs: Vec<Job>,
    next: AtomicUsize,
    stopped: Arc<AtomicBool>,
    standing: Mutex<Standing>,
}

/// What came of the work so far.
struct Standing {
    store: Store,
    shown: Progress,
    /// How far the job of each thread is, 0 to 1.
    fractions: HashMap<usize, f64>,
    done: usize,
    /// Why jobs failed, each with its job.
    failures: Vec<String>,
    problem: Option<String>,
}

impl Work {
    fn new(jobs: Vec<Job>, store: Store) -> Result<Self, Box<dyn Error>> {
        let stopped = interrupt::flag()?;
        let shown = Progress::new("about");
        let standing = Standing {
            store,
            shown,
            fractions: HashMap::new(),
            done: 0,
            failures: Vec::new(),
            problem: None,
        };
        Ok(Self { jobs, next: AtomicUsize::new(0), stopped, standing: Mutex::new(standing) })
    }

    fn standing(&self) -> MutexGuard<'_, Standing> {
        self.standing.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes job after job until there is none left, or Ctrl-C.
    fn go_on(&self, thread: usize, folds: &HashMap<(usize, usize), Fold>) {
        while let Some(job) = self.jobs.get(self.next.fetch_add(1, Ordering::Relaxed)) {
            let Some(fold) = folds.get(&(job.held_out, job.training_trials)) else { continue };
            let begin = Instant::now();
            let seconds = || begin.elapsed().as_secs_f64();
            let outcome = fold.evaluate(&job.candidate, job.seed, &seconds, &mut |progress| {
                self.show(thread, progress.fraction);
                !self.stopped.load(Ordering::Relaxed)
            });
            let result = match outcome {
                Ok(Some(outcome)) => Ok(outcome),
                Ok(None) => return,
                Err(error) => Err(error.to_string()),
            };
            let mut standing = self.standing();
            standing.failures.extend(result.as_ref().err().map(|why| format!("{job}: {why}")));
            let came_of_it =
                result.as_ref().map_or_else(|why| format!("failed: {why}"), |_| "done".to_owned());
            if let Err(problem) = standing.store.add(Finished::new(job.clone(), result)) {
                standing.problem = Some(problem.to_string());
                self.stopped.store(true, Ordering::Relaxed);
                return;
            }
            standing.done += 1;
            let done = standing.done;
            standing.shown.ended(|| {
                let (id, trial, seed) = (job.candidate.kind().id(), job.held_out, job.seed);
                let of = self.jobs.len();
                format!(
                    "{done} of {of} jobs: {id}, trial {trial} held out, seed {seed}, {came_of_it} in {:.1} s",
                    seconds()
                )
            });
            drop(standing);
            self.show(thread, 0.0);
            if self.stopped.load(Ordering::Relaxed) {
                return;
            }
        }
    }

    fn show(&self, thread: usize, fraction: f64) {
        let mut standing = self.standing();
        standing.fractions.insert(thread, fraction);
        let under_way: f64 = standing.fractions.values().sum();
        let (done, jobs) = (standing.done, self.jobs.len());
        let fraction = (done as f64 + under_way) / jobs.max(1) as f64;
        standing.shown.show(fraction, || format!("{done} of {jobs} jobs"));
    }
}

/// The jobs that the arguments ask for on so many trials of a body in so many parts.
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
        balanced: arguments.balanced,
        linear: arguments.linear,
        held_out: folds(&arguments.folds, trials)?,
        seeds: arguments.seeds.clone(),
        training_trials: arguments.training_trials.clone(),
        growth: false,
    };
    let plan = if parts > 1 { plan } else { of_one_part(plan, &arguments.parts)? };
    plan.jobs(trials).map_err(|error| match error {
        ComparisonPlanError::TrainingTrials { most, found } => {
            usage(format!("--training-trials {found}: expected from 1 to {most} trials"))
        }
        error => error.into(),
    })
}

/// The plan without the coupled models that it asks for, which have nothing to couple in one part: what
/// became of them would say nothing about them. `split` is what `--parts` says.
fn of_one_part(plan: Plan, split: &str) -> Result<Plan, Box<dyn Error>> {
    let coupled = plan.models.iter().filter(|kind| kind.is_coupled());
    let coupled = coupled.map(|kind| kind.id()).collect::<Vec<_>>().join(", ");
    let plan = plan.without_coupled();
    if plan.models.is_empty() {
        return Err(usage(format!("--parts {split}: expected two parts or more for {coupled}, found 1")));
    }
    if !coupled.is_empty() {
        say(&format!("--parts {split} is one part: {coupled} left out, which would have nothing to couple"));
    }
    Ok(plan)
}

/// The trials held out, counted from 1; none named: each in turn.
pub fn folds(asked: &str, trials: usize) -> Result<Vec<usize>, Box<dyn Error>> {
    if asked == "all" {
        return Ok(Vec::new());
    }
    let number = |word: &str| word.trim().parse().ok().filter(|n| (1..=trials).contains(n));
    asked.split(',').map(number).collect::<Option<_>>().ok_or_else(|| {
        usage(format!("--folds {asked}: expected all, or numbers from 1 to {trials} with commas between"))
    })
}

pub fn models(asked: &str) -> Result<Vec<ModelKind>, Box<dyn Error>> {
    if asked == "all" {
        return Ok(ModelKind::ALL.to_vec());
    }
    let kind = |word: &str| {
        ModelKind::from_id(word.trim()).ok_or_else(|| {
            let known: Vec<&str> = ModelKind::ALL.iter().map(|kind| kind.id()).collect();
            usage(format!("--models {word}: expected all, or some of {}", known.join(", ")))
        })
    };
    asked.split(',').map(kind).collect()
}

fn primitives(asked: &[String]) -> Result<Vec<Option<usize>>, Box<dyn Error>> {
    let number = |word: &String| match (word.trim(), word.trim().parse()) {
        ("bound", _) => Ok(None),
        (_, Ok(count)) if (1..=MOST_PRIMITIVES).contains(&count) => Ok(Some(count)),
        _ => Err(usage(format!(
            "--primitives {word}: expected bound, or a number from 1 to {MOST_PRIMITIVES}"
        ))),
    };
    asked.iter().map(number).collect()
}

/// The places of the jobs that `--job K of N` asks for: every N-th, so that all shares take about as long.
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
