//! A training, one step after the other.

use crate::interrupt;
use crate::progress::Progress;
use std::error::Error;
use std::sync::atomic::Ordering;
use vcgpdm::models::LearningProgress;

/// Trains to the end, or until Ctrl-C or SIGTERM: then the best so far is kept. Says why it ended.
pub fn train_steps(
    mut step: impl FnMut() -> LearningProgress,
    objective: &str,
) -> Result<String, Box<dyn Error>> {
    let stopped = interrupt::flag()?;
    let mut shown = Progress::new("at most");
    loop {
        let progress = step();
        // Not the iterations: a search for the number of primitives may end long before the most there can be.
        shown.show(progress.fraction, || {
            let phase = progress.phase.map_or(String::new(), |phase| format!(", {phase}"));
            let (iteration, most, best) = (progress.iteration, progress.max_iterations, progress.best);
            format!("{iteration}/{most}  {objective} {best:.1}{phase}")
        });
        if progress.done || stopped.load(Ordering::Relaxed) {
            shown.finish();
            return Ok(progress.reason.map_or_else(|| "stopped".to_owned(), |reason| reason.to_string()));
        }
    }
}
