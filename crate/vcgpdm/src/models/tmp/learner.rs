//! Learning temporal movement primitives, sweep by sweep, and their number.

use crate::gp::NumericsError;
use crate::models::learner::{Learner, LearningProgress, MovementModel, Movements};
use crate::models::phase::{Alignment, PhaseAxis, Trial};
use crate::models::tmp::Tmp;
use crate::models::tmp::posterior::Posterior;
use crate::models::trials::trials_of;
use crate::models::variational::trainer::TrainingError;

/// More would only be slow.
const MOST_PRIMITIVES: usize = 40;
const MOST_SWEEPS: usize = 10_000;
/// So many sweeps pass between two looks at lengthscale and phases.
const EVERY: usize = 5;
/// A number of primitives is done when [`EVERY`] sweeps have together gained less than this part of the bound.
const SMALL_GAIN: f64 = 2e-6;
/// The search for the number ends when so many in a row were worse than the best.
const WORSE_IN_A_ROW: usize = 2;
/// Places along the axis where a trial of which only the first frames are known is looked for.
const PLACES: usize = 32;
/// First step of the phases and factor of the lengthscale; both shrink.
const PHASE_STEP: f64 = 1.0 / 64.0;
const LENGTHSCALE_FACTOR: f64 = 1.4;

/// Which columns share a noise variance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseSharing {
    /// None: sigma_k^2 belongs to the column, as in Endres et al. (2013).
    Column,
    /// Those of a part, like beta of the vCGPDM: only then are the bounds of both on the same footing, because the bound of a
    /// column that hardly moves would otherwise grow without limit.
    Part,
}

/// What the learning of temporal movement primitives is asked to do.
#[derive(Clone, Debug, PartialEq)]
pub struct TmpSettings {
    /// Q; absent: chosen by the bound.
    pub primitives: Option<usize>,
    /// Where the search for Q ends at the latest.
    pub most_primitives: usize,
    /// Sweeps over all updates for each Q, at most.
    pub max_sweeps: usize,
    /// Which columns share a noise variance.
    pub noise: NoiseSharing,
    /// What the phase means; absent: a cycle when the movement repeats itself.
    pub axis: Option<PhaseAxis>,
}

impl Default for TmpSettings {
    fn default() -> Self {
        Self { primitives: None, most_primitives: 12, max_sweeps: 150, noise: NoiseSharing::Part, axis: None }
    }
}

/// A training of temporal movement primitives.
pub struct TmpLearner {
    trials: Vec<Trial>,
    columns: Vec<usize>,
    groups: Vec<usize>,
    alignment: Alignment,
    settings: TmpSettings,
    /// The number of primitives that is being tried.
    count: usize,
    current: Posterior,
    bound: f64,
    sweeps: usize,
    /// The bound [`EVERY`] sweeps ago.
    before: f64,
    relocated: bool,
    phase_step: f64,
    lengthscale_factor: f64,
    best: Option<(f64, Posterior)>,
    bounds: Vec<(usize, f64)>,
    iteration: usize,
    reason: Option<String>,
}

impl TmpLearner {
    /// Aligns the trials and starts with the smallest number of primitives.
    pub fn new(movements: &Movements, settings: TmpSettings) -> Result<Self, TrainingError> {
        let limits = [
            ("the number of primitives", settings.primitives.unwrap_or(1), MOST_PRIMITIVES),
            ("the largest number of primitives", settings.most_primitives, MOST_PRIMITIVES),
            ("the number of sweeps", settings.max_sweeps, MOST_SWEEPS),
        ];
        for (name, found, highest) in limits {
            if !(1..=highest).contains(&found) {
                return Err(TrainingError::Setting { name, lowest: 1, highest, found });
            }
        }
        let (trials, columns) = trials_of(movements)?;
        let alignment = Alignment::new(&trials, settings.axis);
        let count = settings.primitives.unwrap_or(1);
        let groups = match settings.noise {
            NoiseSharing::Column => vec![1; columns.iter().sum()],
            NoiseSharing::Part => columns.iter().copied().filter(|&width| width > 0).collect(),
        };
        let current = Posterior::start(&trials, &alignment, &groups, count)?;
        let bound = current.bound(&trials)?;
        Ok(Self {
            trials,
            columns,
            groups,
            alignment,
            settings,
            count,
            current,
            bound,
            sweeps: 0,
            before: bound,
            relocated: false,
            phase_step: PHASE_STEP,
            lengthscale_factor: LENGTHSCALE_FACTOR,
            best: None,
            bounds: Vec::new(),
            iteration: 0,
            reason: None,
        })
    }

    /// All updates once; the bound after them.
    fn sweep(&mut self) -> Result<f64, NumericsError> {
        let (current, trials) = (&mut self.current, &self.trials);
        current.update_primitives()?;
        current.update_weights()?;
        current.update_hyperparameters(trials)?;
        if self.sweeps % EVERY == EVERY - 1 {
            if !current.update_lengthscale(trials, self.lengthscale_factor)? {
                self.lengthscale_factor = self.lengthscale_factor.sqrt();
            }
            current.update_phases(trials, self.phase_step);
            self.phase_step = (self.phase_step * 0.7).max(1e-4);
        }
        self.sweeps += 1;
        current.bound(trials)
    }

    /// One sweep, and what follows when this number of primitives is done.
    fn advance(&mut self) -> Result<(), NumericsError> {
        self.bound = self.sweep()?;
        let look = self.sweeps.is_multiple_of(EVERY);
        let small = look && self.bound - self.before < SMALL_GAIN * self.bound.abs();
        if look {
            self.before = self.bound;
        }
        // Late enough for the primitives to be about right, early enough for them to follow.
        let late = 2 * self.sweeps > self.settings.max_sweeps;
        if !self.relocated && (small || late) && self.sweeps < self.settings.max_sweeps {
            self.current.relocate(&self.trials, PLACES)?;
            self.bound = self.current.bound(&self.trials)?;
            (self.relocated, self.before) = (true, f64::NEG_INFINITY);
            return Ok(());
        }
        if self.sweeps < self.settings.max_sweeps && !small {
            return Ok(());
        }
        self.bounds.push((self.count, self.bound));
        if self.best.as_ref().is_none_or(|(best, _)| self.bound > *best) {
            self.best = Some((self.bound, self.current.clone()));
        }
        let best = self.best.as_ref().map_or(self.count, |(_, p)| p.primitives());
        if self.settings.primitives.is_some() {
            self.reason = Some("the bound no longer rises".into());
        } else if self.count >= best + WORSE_IN_A_ROW {
            self.reason = Some(format!("more than {best} primitives lower the bound"));
        } else if self.count >= self.settings.most_primitives {
            self.reason = Some(format!("the most primitives are tried; {best} are best"));
        } else {
            self.count += 1;
            self.current = Posterior::start(&self.trials, &self.alignment, &self.groups, self.count)?;
            self.bound = self.current.bound(&self.trials)?;
            (self.sweeps, self.before, self.relocated) = (0, self.bound, false);
            (self.phase_step, self.lengthscale_factor) = (PHASE_STEP, LENGTHSCALE_FACTOR);
        }
        Ok(())
    }
}

impl Learner for TmpLearner {
    fn step(&mut self) -> LearningProgress {
        if self.reason.is_none() {
            self.iteration += 1;
            if let Err(error) = self.advance() {
                self.reason = Some(format!("stopped with {} primitives: {error}", self.count));
            }
        }
        self.progress()
    }

    fn progress(&self) -> LearningProgress {
        let counts = if self.settings.primitives.is_some() { 1 } else { self.settings.most_primitives };
        let best = self.best.as_ref().map_or(f64::NEG_INFINITY, |(best, _)| *best).max(self.bound);
        let within = self.sweeps as f64 / self.settings.max_sweeps as f64;
        let share = (self.bounds.len() as f64 + within.min(1.0)) / counts as f64;
        let done = self.reason.is_some();
        LearningProgress {
            iteration: self.iteration,
            max_iterations: counts * self.settings.max_sweeps,
            objective: self.bound,
            best,
            done,
            reason: self.reason.clone(),
            fraction: if done { 1.0 } else { share.min(1.0) },
        }
    }

    fn model(&self) -> Result<Box<dyn MovementModel>, NumericsError> {
        Ok(Box::new(self.fitted()?))
    }
}

impl TmpLearner {
    /// The best model so far, with all that is known of it.
    pub fn fitted(&self) -> Result<Tmp, NumericsError> {
        let best = match &self.best {
            Some((bound, posterior)) if *bound >= self.bound => posterior,
            _ => &self.current,
        };
        Tmp::new(best, &self.trials, &self.columns, &self.bounds)
    }
}
