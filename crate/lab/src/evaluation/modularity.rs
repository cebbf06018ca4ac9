//! The modularity test (Velychko et al. 2018, section 5.5 and figure 7): are movements that share a primitive
//! predicted as well as by separate models?

use crate::evaluation::error::EvaluationError;
use nalgebra::DMatrix;
use serde::Serialize;
use vcgpdm_core::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement, TrainedLibrary};
use vcgpdm_core::models::{Dataset, Score, Source, VariationalSettings, score_and_columns};
use vcgpdm_core::motion::Clip;
use vcgpdm_core::motion::parts::PartSpec;

/// The trials of one movement.
#[derive(Clone, Debug)]
pub struct MovementTrials {
    /// Its name.
    pub name: String,
    /// Its trials.
    pub trials: Vec<Clip>,
}

/// One trial of one movement held out: a library is trained on all other trials of all movements and on the
/// first frames of that one.
#[derive(Clone, Debug)]
pub struct LibraryFold {
    dataset: Dataset,
    plan: LibraryPlan,
    /// The movement of the trial held out, and the index of its first frames among the movement's sequences.
    movement: usize,
    sequence: usize,
    /// All columns of the trial held out [T x D].
    actual: DMatrix<f64>,
}

/// The outcome of a library in a fold.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LibraryOutcome {
    /// The error of the prediction.
    pub score: Score,
    /// The bound of the library, in nats.
    pub bound: f64,
    /// Numbers that rollouts of all its movements need, each from one sequence.
    pub stored_numbers: usize,
    /// Number of training frames.
    pub frames: usize,
}

impl LibraryOutcome {
    /// Whether this seed represents its fold better than another seed: its bound is higher.
    pub fn is_better_seed(&self, other: &LibraryOutcome) -> bool {
        self.bound > other.bound
    }
}

impl LibraryFold {
    /// The trial `held_out` of the movement `movement`, both counted from 0, predicted from its first
    /// `start_frames`. The parts named in `shared` use the same primitive in all movements.
    ///
    /// # Errors
    /// The trial does not exist, or the trials cannot be trained on together.
    pub fn new(
        movements: &[MovementTrials],
        (movement, held_out): (usize, usize),
        parts: &[PartSpec],
        shared: &[String],
        frames_per_second: f64,
        start_frames: usize,
    ) -> Result<Self, EvaluationError> {
        let count = movements.get(movement).map_or(0, |trials| trials.trials.len());
        if held_out >= count || count < 2 {
            return Err(EvaluationError::Trial { count, found: held_out });
        }
        let (mut sources, mut planned) = (Vec::new(), Vec::new());
        for (m, own) in movements.iter().enumerate() {
            let before = sources.len();
            let training = own.trials.iter().enumerate().filter(|(k, _)| m != movement || *k != held_out);
            sources.extend(training.map(|(_, clip)| Source { clip, first_frames: None }));
            if m == movement {
                sources.push(Source { clip: &own.trials[held_out], first_frames: Some(start_frames) });
            }
            planned.push(PlannedMovement { name: own.name.clone(), sequences: sources.len() - before });
        }
        let sequence = planned[movement].sequences - 1;
        let shared = parts.iter().map(|part| shared.contains(&part.name)).collect();
        let plan = LibraryPlan::new(planned, shared)?;
        let dataset = Dataset::new(&sources, parts, frames_per_second)?;
        let trial = movements[movement].trials[held_out].resample(1.0 / dataset.frame_time)?;
        let actual = dataset.mapping.encode(&trial)?.y;
        Ok(Self { dataset, plan, movement, sequence, actual })
    }

    /// The training of the library, before its first step.
    ///
    /// # Errors
    /// A setting is out of its range, or a trial is too short.
    pub fn trainer(
        &self,
        settings: &VariationalSettings,
        seed: u32,
    ) -> Result<LibraryTrainer, EvaluationError> {
        Ok(LibraryTrainer::new(&self.dataset, &self.plan, settings, seed)?)
    }

    /// The outcome of the library in this fold.
    ///
    /// # Errors
    /// The prediction cannot be made or scored.
    pub fn outcome(&self, trained: &TrainedLibrary) -> Result<LibraryOutcome, EvaluationError> {
        let model = trained.library.movement(self.movement)?;
        let predicted = model.rollout(self.sequence, self.actual.nrows())?;
        let (score, _) = score_and_columns(&trained.body.columns(&predicted), &self.actual)?;
        Ok(LibraryOutcome {
            score,
            bound: trained.provenance.bound(),
            stored_numbers: trained.library.stored_numbers(),
            frames: self.dataset.sequences.iter().map(|info| info.frames).sum(),
        })
    }
}
