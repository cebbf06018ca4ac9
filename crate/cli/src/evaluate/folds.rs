//! The folds in which a job trains and predicts.

use std::error::Error;
use vcgpdm::models::Progress;
use vcgpdm_lab::evaluation::{Fold, Job, ObservedFold, Outcome};

/// The folds of the jobs with one trial held out and one number of training trials.
pub struct Folds {
    /// The first frames of the trial held out are trained on.
    pub trained: Fold,
    /// They are observed, if this was asked for.
    pub observed: Option<ObservedFold>,
    pub start_frames: usize,
}

impl Folds {
    /// The outcome of a job, of which a part can be known already. `watch` gets the share that is done; if it
    /// returns false, there is no outcome.
    pub fn evaluate(
        &self,
        job: &Job,
        known: Option<Outcome>,
        seconds: &dyn Fn() -> f64,
        watch: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Option<Outcome>, Box<dyn Error>> {
        let Job { candidate, seed, .. } = job;
        let observed = self.observed.as_ref().filter(|_| candidate.observes());
        let share = if observed.is_some() && known.is_none() { 0.5 } else { 1.0 };
        let mut first = |progress: &Progress| watch(share * progress.fraction);
        let outcome = match known {
            Some(outcome) => Some(outcome),
            None => self.trained.evaluate(candidate, *seed, seconds, &mut first)?,
        };
        let (Some(mut outcome), Some(fold), Some(settings)) =
            (outcome.clone(), observed, candidate.settings())
        else {
            return Ok(outcome);
        };
        let mut second = |progress: &Progress| watch(1.0 - share + share * progress.fraction);
        let Some(model) = fold.train(settings, *seed, &mut second)? else { return Ok(None) };
        outcome.observed_start = Some(fold.observed_start(&model, self.start_frames, seconds)?);
        Ok(Some(outcome))
    }
}
