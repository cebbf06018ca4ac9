//! The steps of a training.

use crate::task::{Task, say};
use std::error::Error;
use vcgpdm_core::models::{ColumnMapping, Dataset, Progress, Settings, TrainingCost};

/// Above these seconds and bytes a warning comes before the training: half an hour, and the memory of a small
/// machine.
const LONG: f64 = 1800.0;
const LARGE: f64 = 4e9;

/// Warns, before a training on a data set, that it would take long or much memory.
pub fn warn_of_training<S: ColumnMapping>(settings: &Settings, dataset: &Dataset<S>) {
    let columns: Vec<usize> = dataset.y.iter().map(|y| y.ncols()).collect();
    let less = match settings {
        Settings::Vcgpdm(_) | Settings::Vgpdm(_) => "a lower --fps, fewer inducing points or iterations",
        _ => "a lower --fps or fewer iterations",
    };
    warn_of_cost(settings.cost(dataset.lengths().iter().sum(), &columns), 1, less);
}

/// Warns, before trainings of which `threads` run at the same time, that they would take long or much memory.
/// `less` names what would need less.
pub fn warn_of_cost(cost: TrainingCost, threads: usize, less: &str) {
    let (seconds, bytes) = (cost.seconds / threads as f64, cost.bytes * threads as f64);
    if seconds > LONG || bytes > LARGE {
        let cores = if threads == 1 { "one core".to_owned() } else { format!("{threads} cores") };
        let memory =
            if bytes > LARGE { format!(", and {:.1} GB of memory", bytes / 1e9) } else { String::new() };
        say(&format!("up to about {:.1} hours on {cores}{memory}; {less} need less", seconds / 3600.0));
    }
}

/// Writes the warnings of a training to stderr, without those that were said when its clips were read.
pub fn say_others(warnings: &[String], said: &[String]) {
    warnings.iter().filter(|warning| !said.contains(warning)).for_each(|warning| say(warning));
}

/// Trains to the end, or until Ctrl-C or SIGTERM, which keep the best so far. Returns why the training ended.
pub fn train_steps(mut step: impl FnMut() -> Progress, objective: &str) -> Result<String, Box<dyn Error>> {
    let task = Task::new("at most")?;
    loop {
        let progress = step();
        // Not the share of the iterations: a search for the number of primitives may end long before the
        // largest number.
        task.show(progress.fraction, || {
            let phase = progress.phase.map_or(String::new(), |phase| format!(", {phase}"));
            let (iteration, most, best) = (progress.iteration, progress.max_iterations, progress.best);
            format!("{iteration}/{most}  {objective} {best:.1}{phase}")
        });
        if progress.done || task.is_stopped() {
            task.finish();
            if progress.setbacks.any() {
                task.note(&progress.setbacks.to_string());
            }
            return Ok(progress.reason.map_or_else(|| "stopped".to_owned(), |reason| reason.to_string()));
        }
    }
}
