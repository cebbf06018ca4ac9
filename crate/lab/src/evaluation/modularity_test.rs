//! The modularity test on the sample trials: docs/modularity.md has all trials, the page computes one.

use crate::evaluation::cross_validation::START_FRAMES;
use crate::evaluation::error::EvaluationError;
use crate::evaluation::modularity::{LibraryFold, LibraryOutcome, MovementTrials};
use vcgpdm_core::models::Progress;
use vcgpdm_core::models::VariationalSettings;
use vcgpdm_core::models::library::{LibraryTrainer, TrainedLibrary};
use vcgpdm_core::motion::parts::{PartSpec, presets};
use vcgpdm_core::motion::samples;

/// The movements: their names here, and in the list of samples.
const MOVEMENTS: [(&str, &str); 2] = [("walk", "walk"), ("wave", "walk and wave")];
/// The preset of the body, and the parts with one primitive for all movements.
const PRESET: &str = "lower-upper";
const SHARED: [&str; 1] = ["lower"];
/// The seed with the highest bound is taken, a choice without the trial held out.
const SEEDS: [u32; 2] = [1, 2];
/// The sample trials have very little noise, and need more iterations than recordings.
const ITERATIONS: usize = 600;

/// Movements of which some parts use the same primitive, compared with models of each movement alone
/// (Velychko et al. 2018, section 5.5 and figure 7).
#[derive(Clone, Debug)]
pub struct ModularityTest {
    /// The movements with their trials.
    pub movements: Vec<MovementTrials>,
    /// The parts of the body.
    pub parts: Vec<PartSpec>,
    /// The names of the parts that have one primitive for all movements.
    pub shared: Vec<String>,
    /// The clips are resampled to about this rate.
    pub frames_per_second: f64,
    /// Settings of each training.
    pub settings: VariationalSettings,
    /// Seeds of the trainings.
    pub seeds: Vec<u32>,
}

/// The model of a fold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trained {
    /// A library of all movements.
    Together,
    /// A model of the movement of the trial held out.
    Alone,
}

impl ModularityTest {
    /// The test on the samples of walking and of walking with waving: Q = 3, 25 pose inducing points for each
    /// part, 16 dynamics inducing points for each expert.
    pub fn on_samples() -> Self {
        let trials = |movement: &str| {
            let own = samples::list().into_iter().filter(|sample| sample.movement == movement);
            own.filter_map(|sample| samples::clip(sample.id)).collect::<Vec<_>>()
        };
        let movements: Vec<_> = MOVEMENTS
            .iter()
            .map(|(name, movement)| MovementTrials { name: (*name).to_owned(), trials: trials(movement) })
            .collect();
        let first = movements.first().and_then(|movement| movement.trials.first());
        let presets = first.map(|clip| presets(&clip.skeleton)).unwrap_or_default();
        let preset = presets.into_iter().find(|preset| preset.id == PRESET);
        Self {
            movements,
            parts: preset.map(|preset| preset.parts).unwrap_or_default(),
            shared: SHARED.map(str::to_owned).to_vec(),
            frames_per_second: 30.0,
            settings: VariationalSettings {
                latent: 3,
                dynamics_ips: 16,
                pose_ips: 25,
                max_iterations: ITERATIONS,
                ..VariationalSettings::default()
            },
            seeds: SEEDS.to_vec(),
        }
    }

    /// The movement of a sample and its trial, both counted from 0; `None` for other samples.
    pub fn place_of(sample: &str) -> Option<(usize, usize)> {
        let samples = samples::list();
        MOVEMENTS.iter().enumerate().find_map(|(m, (_, movement))| {
            let mut own = samples.iter().filter(|info| info.movement == *movement);
            own.position(|info| info.id == sample).map(|trial| (m, trial))
        })
    }

    /// The training of a fold before its first step. The trial of the movement, both counted from 0, is held
    /// out.
    ///
    /// # Errors
    /// The trial does not exist, or the trials cannot be trained on.
    pub fn training(
        &self,
        (movement, trial): (usize, usize),
        trained: Trained,
    ) -> Result<FoldTraining, EvaluationError> {
        let (rate, parts) = (self.frames_per_second, &self.parts);
        let fold = match (trained, self.movements.get(movement)) {
            (Trained::Alone, Some(own)) => {
                let own = std::slice::from_ref(own);
                LibraryFold::new(own, (0, trial), parts, &[], rate, START_FRAMES)?
            }
            _ => {
                LibraryFold::new(&self.movements, (movement, trial), parts, &self.shared, rate, START_FRAMES)?
            }
        };
        FoldTraining::new(fold, self.settings.clone(), self.seeds.clone())
    }
}

/// The training of one fold, one step at a time, with one seed after the other. The model with the highest
/// bound stays.
pub struct FoldTraining {
    fold: LibraryFold,
    settings: VariationalSettings,
    seeds: Vec<u32>,
    /// Number of finished seeds.
    over: usize,
    trainer: LibraryTrainer,
    best: Option<(LibraryOutcome, TrainedLibrary)>,
}

impl FoldTraining {
    /// The training before its first step. Without a seed it has seed 1.
    ///
    /// # Errors
    /// A setting is out of its range, or a trial is too short.
    pub fn new(
        fold: LibraryFold,
        settings: VariationalSettings,
        mut seeds: Vec<u32>,
    ) -> Result<Self, EvaluationError> {
        if seeds.is_empty() {
            seeds.push(1);
        }
        let trainer = fold.trainer(&settings, seeds[0])?;
        Ok(Self { fold, settings, seeds, over: 0, trainer, best: None })
    }

    /// Makes one iteration of the optimiser. The progress is that of all seeds together; its bound is that of
    /// the current seed. After the end it does nothing.
    ///
    /// # Errors
    /// A model cannot be fitted, rolled out or scored, or the training with the next seed cannot begin.
    pub fn step(&mut self) -> Result<Progress, EvaluationError> {
        let count = self.seeds.len();
        if self.over == count {
            return Ok(self.progress(count - 1, self.trainer.progress()));
        }
        let progress = self.trainer.step();
        let at = self.over;
        if progress.done {
            let library = self.trainer.finish()?;
            let outcome = self.fold.outcome(&library)?;
            if self.best.as_ref().is_none_or(|(best, _)| outcome.is_better_seed(best)) {
                self.best = Some((outcome, library));
            }
            self.over += 1;
            if let Some(seed) = self.seeds.get(self.over) {
                self.trainer = self.fold.trainer(&self.settings, *seed)?;
            }
        }
        Ok(self.progress(at, progress))
    }

    /// The progress of all seeds, given the progress of the seed with index `at`.
    fn progress(&self, at: usize, progress: Progress) -> Progress {
        let (count, most) = (self.seeds.len(), progress.max_iterations);
        let fraction = if progress.done { 1.0 } else { progress.fraction };
        Progress {
            iteration: at * most + progress.iteration,
            max_iterations: count * most,
            fraction: (at as f64 + fraction) / count as f64,
            done: progress.done && self.over == count,
            ..progress
        }
    }

    /// Number of seeds.
    pub fn seeds(&self) -> usize {
        self.seeds.len()
    }

    /// The outcome and the library of the best finished seed; `None` before the first has finished.
    pub fn best(&self) -> Option<&(LibraryOutcome, TrainedLibrary)> {
        self.best.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::Fold;
    use vcgpdm_core::models::Settings;

    fn test(iterations: usize) -> ModularityTest {
        let mut test = ModularityTest::on_samples();
        test.settings.max_iterations = iterations;
        for movement in &mut test.movements {
            movement.trials.truncate(2);
        }
        test
    }

    #[test]
    fn has_the_sample_trials() {
        let test = ModularityTest::on_samples();
        let trials: Vec<_> = test.movements.iter().map(|m| (m.name.as_str(), m.trials.len())).collect();
        assert_eq!(trials, [("walk", 6), ("wave", 4)]);
        assert_eq!(test.parts.len(), 2);
        assert!(test.shared.iter().all(|name| test.parts.iter().any(|part| part.name == *name)));
        assert_eq!(ModularityTest::place_of("walk-3"), Some((0, 2)));
        assert_eq!(ModularityTest::place_of("walk-wave-1"), Some((1, 0)));
        assert_eq!(ModularityTest::place_of("run-1"), None);
        for place in [(2, 0), (0, 6)] {
            assert!(test.training(place, Trained::Alone).is_err());
            assert!(test.training(place, Trained::Together).is_err());
        }
    }

    /// A library of one movement is the plain model: trained, rolled out and scored as in all other
    /// comparisons.
    #[test]
    fn trains_the_plain_model_of_one_movement() {
        let test = test(12);
        let mut training = test.training((1, 1), Trained::Alone).unwrap();
        let mut fractions = vec![0.0];
        loop {
            let progress = training.step().unwrap();
            assert!(progress.fraction >= fractions[fractions.len() - 1]);
            fractions.push(progress.fraction);
            if progress.done {
                break;
            }
        }
        assert_eq!(fractions.last(), Some(&1.0));
        assert!(training.step().unwrap().done);
        let (found, _) = training.best().unwrap();
        let fold = Fold::new(&test.movements[1].trials, 1, 1, &test.parts, 30.0, START_FRAMES).unwrap();
        let plain = test.seeds.iter().map(|seed| {
            let candidate = Settings::Vcgpdm(test.settings.clone()).into();
            fold.evaluate(&candidate, *seed, &|| 0.0, &mut |_| true).unwrap().unwrap()
        });
        // A fold of a library keeps the seed with the highest bound.
        let plain = plain.reduce(|a, b| if b.objective > a.objective { b } else { a }).unwrap();
        assert_eq!((found.bound, found.frames), (plain.objective, plain.frames));
        assert_eq!(found.score, plain.score);
        assert_eq!(found.stored_numbers, plain.stored_numbers);
    }

    #[test]
    fn trains_one_library_of_all_movements() {
        let mut training = test(3).training((0, 0), Trained::Together).unwrap();
        assert!(training.best().is_none());
        while !training.step().unwrap().done {}
        let (outcome, library) = training.best().unwrap();
        assert!(outcome.score.dtw_mse > 0.0);
        let uses: Vec<_> = library.library.movements.iter().map(|movement| movement.uses.clone()).collect();
        assert_eq!(uses[0][0], uses[1][0]);
        assert_ne!(uses[0][1], uses[1][1]);
        assert_eq!(training.seeds(), 2);
    }
}
