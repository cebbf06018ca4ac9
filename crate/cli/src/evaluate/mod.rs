//! `vcgpdm evaluate`: compares models by leave-one-trial-out cross-validation, in parallel and resumable.

mod arguments;
mod work;

use crate::clips;
pub use crate::evaluate::arguments::{Arguments, folds, models};
use crate::evaluate::work::Work;
use crate::files;
use crate::numbers::check_fps;
use crate::store::Store;
use crate::task::say;
use crate::train::{parts, warn_of_cost, weight};
use crate::usage::usage;
use serde_json::json;
use std::collections::HashMap;
use std::error::Error;
use std::thread;
use vcgpdm_core::models::{MOST_PRIMITIVES, PoseWeight};
use vcgpdm_core::motion::pose::PoseMapping;
use vcgpdm_lab::evaluation::{ComparisonPlanError, Fold, Job, Plan, Setting, whole_cycles};

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    check_fps(arguments.fps)?;
    let mut clips = clips::read_all(&arguments.clips, &arguments.up)?;
    if let Some((first, others)) = clips.split_first() {
        let mapping = PoseMapping::new(first);
        others.iter().for_each(|clip| clips::say_differences(clip, &mapping));
    }
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
        let (held_out, count) = (job.held_out, job.training_trials);
        if let std::collections::hash_map::Entry::Vacant(entry) = folds.entry((held_out, count)) {
            entry.insert(Fold::new(&clips, held_out, count, &parts, arguments.fps, start_frames)?);
        }
    }
    let share = share(arguments, jobs.len())?;
    let store = Store::open(&arguments.out, setting)?;
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
    work.task.finish();
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
