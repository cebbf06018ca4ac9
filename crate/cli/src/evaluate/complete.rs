//! `vcgpdm evaluate --task complete`: each part of every trial held out is inferred from the other parts.

use crate::evaluate::arguments::{Arguments, folds};
use crate::files;
use crate::interrupt;
use crate::progress::{Progress, say};
use crate::report::completing::read;
use crate::store::lock;
use crate::train::weight;
use crate::usage::{first_given, usage};
use serde_json::json;
use std::error::Error;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use vcgpdm::models::{PoseWeight, VariationalSettings};
use vcgpdm::motion::Clip;
use vcgpdm::motion::parts::PartSpec;
use vcgpdm_lab::completing::{CompletedTrial, Completing, CompletingFold};
use vcgpdm_lab::evaluation::{START_FRAMES, Setting};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

pub fn run(arguments: &Arguments, clips: &[Clip], parts: &[PartSpec]) -> Result<()> {
    let (settings, seed) = settings(arguments)?;
    let setting = Setting::new(clips, parts, arguments.fps, START_FRAMES)?;
    let mut results = Completing::new(setting, settings.clone(), seed);
    let path = &arguments.out;
    if files::is_standard(path) {
        return Err(usage("--out -: expected a file, to which completed trials are added one by one"));
    }
    files::check_writable(path, [])?;
    {
        let _lock = lock(path)?;
        read_again(&mut results, path)?;
    }
    let mut asked = folds(&arguments.folds, clips.len())?;
    if asked.is_empty() {
        asked = (0..clips.len()).collect();
    }
    let known = asked.iter().filter(|held_out| results.has(**held_out)).count();
    asked.retain(|held_out| !results.has(*held_out));
    asked.sort_unstable();
    asked.dedup();
    // Making all folds first finds every unusable trial before anything is computed.
    let mut folds = Vec::with_capacity(asked.len());
    for &held_out in &asked {
        folds.push(CompletingFold::new(clips, held_out, parts, arguments.fps)?);
    }

    let cores = thread::available_parallelism().map_or(1, usize::from);
    let threads = arguments.threads.map_or(cores, usize::from).min(folds.len());
    let stopped = interrupt::flag()?;
    let work = Work {
        path,
        stopped: &stopped,
        next: AtomicUsize::new(0),
        state: Mutex::new(State {
            results,
            progress: Progress::new("about"),
            fractions: vec![0.0; folds.len()],
            computed: 0,
            elsewhere: 0,
            failures: Vec::new(),
        }),
    };
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| work.compute(&folds, &asked, &settings, seed));
        }
    });
    let state = work.state.into_inner().unwrap_or_else(PoisonError::into_inner);
    state.progress.finish();
    let failed = state.failures.len();
    files::print_json(&json!({
        "trials": known + folds.len(),
        "computed": state.computed,
        "known_before": known,
        "computed_elsewhere": state.elsewhere,
        "left": folds.len() - state.computed - state.elsewhere - failed,
        "failed": failed,
    }))?;
    let Some(first) = state.failures.first() else { return Ok(()) };
    let message = format!("{failed} of {} trials failed, first {first}", state.computed + failed);
    if state.computed + known == 0 {
        return Err(message.into());
    }
    say(&message);
    Ok(())
}

/// Takes what this program and others have written to the file. The file must be locked.
fn read_again(results: &mut Completing, path: &Path) -> Result<()> {
    if path.exists() {
        results.take(read(path)?).map_err(|error| files::with_path(path, &error))?;
    }
    Ok(())
}

/// The settings of both models and the seed.
fn settings(arguments: &Arguments) -> Result<(VariationalSettings, u32)> {
    let refused = first_given([
        ("--models", arguments.models != "all"),
        ("--observed-start", arguments.observed_start),
        ("--training-trials", !arguments.training_trials.is_empty()),
        ("--uncoupled", arguments.uncoupled),
        ("--job", arguments.job.is_some()),
    ]);
    if let Some(option) = refused {
        return Err(usage(format!("{option}: expected --task predict with it")));
    }
    let one = |option: &str, numbers: &[usize]| match numbers {
        [number] => Ok(*number),
        _ => {
            Err(usage(format!("{option}: expected one number with --task complete, found {}", numbers.len())))
        }
    };
    let dynamics_ips = one("--ips", &arguments.ips)?;
    let pose_ips = if arguments.pose_ips.is_empty() { &arguments.ips } else { &arguments.pose_ips };
    let [seed] = arguments.seeds[..] else {
        return Err(usage(format!(
            "--seeds: expected one seed with --task complete, found {}",
            arguments.seeds.len()
        )));
    };
    let settings = VariationalSettings {
        latent: arguments.latent,
        order: arguments.order,
        dynamics_ips,
        pose_ips: one("--pose-ips", pose_ips)?,
        max_iterations: arguments.max_iterations,
        pose_weight: weight(arguments.balanced, arguments.pose_weight, PoseWeight::default()),
        uncoupled: false,
        own_rollouts: false,
    };
    Ok((settings, seed))
}

/// Trials that the threads complete one after the other.
struct Work<'a> {
    path: &'a Path,
    stopped: &'a AtomicBool,
    /// The place of the next fold.
    next: AtomicUsize,
    state: Mutex<State>,
}

struct State {
    results: Completing,
    progress: Progress,
    /// The share of each fold that is done.
    fractions: Vec<f64>,
    computed: usize,
    /// Trials that other programs computed meanwhile.
    elsewhere: usize,
    /// Each failed trial with the reason.
    failures: Vec<String>,
}

impl Work<'_> {
    fn compute(
        &self,
        folds: &[CompletingFold],
        held_out: &[usize],
        settings: &VariationalSettings,
        seed: u32,
    ) {
        while !self.stopped.load(Ordering::Relaxed) {
            let place = self.next.fetch_add(1, Ordering::Relaxed);
            let Some(fold) = folds.get(place) else { return };
            if self.is_known(place, held_out[place]) {
                continue;
            }
            let result = fold.evaluate(settings, seed, &mut |fraction| {
                self.show(place, fraction);
                !self.stopped.load(Ordering::Relaxed)
            });
            let trial = held_out[place] + 1;
            match result {
                Ok(Some(completed)) => self.add(place, completed),
                Ok(None) => return,
                Err(reason) => self.fail(&format!("trial {trial} held out: {reason}")),
            }
        }
    }

    fn with_state(&self, change: impl FnOnce(&mut State)) {
        change(&mut self.state.lock().unwrap_or_else(PoisonError::into_inner));
    }

    fn show(&self, place: usize, fraction: f64) {
        self.with_state(|state| {
            state.fractions[place] = fraction;
            let (all, trials) = (state.fractions.iter().sum::<f64>(), state.fractions.len());
            state.progress.show(all / trials as f64, || format!("{all:.1} of {trials} trials"));
        });
    }

    /// Whether another program has added the trial meanwhile.
    fn is_known(&self, place: usize, held_out: usize) -> bool {
        let mut known = false;
        self.with_state(|state| {
            let read = lock(self.path).and_then(|_lock| read_again(&mut state.results, self.path));
            // An error of the file stops the program when the next trial is added.
            known = read.is_ok() && state.results.has(held_out);
            if known {
                state.fractions[place] = 1.0;
                state.elsewhere += 1;
            }
        });
        known
    }

    /// Adds a completed trial to the file, where other programs may have added trials.
    fn add(&self, place: usize, completed: CompletedTrial) {
        self.with_state(|state| {
            let trial = completed.held_out + 1;
            state.fractions[place] = 1.0;
            let write = || {
                let _lock = lock(self.path)?;
                read_again(&mut state.results, self.path)?;
                if !state.results.has(completed.held_out) {
                    state.results.trials.push(completed);
                    state.results.trials.sort_by_key(|trial| trial.held_out);
                }
                files::write_text(self.path, &(state.results.to_json()? + "\n"))
            };
            match write() {
                Ok(()) => {
                    state.computed += 1;
                    state.progress.log(|| format!("trial {trial} held out and completed"));
                }
                Err(error) => {
                    state.failures.push(error.to_string());
                    self.stopped.store(true, Ordering::Relaxed);
                }
            }
        });
    }

    fn fail(&self, message: &str) {
        self.with_state(|state| state.failures.push(message.to_owned()));
    }
}
