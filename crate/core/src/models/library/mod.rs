//! A library of primitives: the dynamics of each part learned once, and coupled in new ways (Velychko et al.
//! 2018, section 5.5).
//!
//! A *primitive* belongs to one part and holds the predictions of that part about every part. A *movement*
//! uses one primitive of each part under couplings of its own. All movements share the pose maps.
//! [`LibraryTrainer`] learns a library from clips of several movements; [`Library::combination`] is a
//! [`Vcgpdm`](crate::models::variational::Vcgpdm) of any primitives, one of each part, recorded or not;
//! [`CouplingTrainer`] learns the couplings of a combination from clips, while the primitives stay as they
//! are.

mod combination;
mod coupling_trainer;
mod information;
mod library_trainer;
mod merge;
mod movement_chain;
mod new_combination;
mod origin;
mod own_rollouts;
mod part_motion;
mod plan;
mod recognition;
mod selection;
mod trained_library;
mod training_start;
mod walk;

use crate::gp::NumericsError;
use crate::gp::linalg::symmetric;
use crate::models::variational::{
    BoundTerms, DynamicsSums, ExternalEvidence, FittedExpert, FittedMaps, Objective, Params, PoseMap,
    expert_offsets, stack_offsets,
};
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

pub use crate::models::errors::{CombinationError, PlanError};
pub use coupling_trainer::{CouplingTrainer, MOST_ITERATIONS};
pub use library_trainer::LibraryTrainer;
pub use merge::{MergeError, Misfit};
pub use origin::{Excerpt, FramesFrom, Origin, Relearned};
pub use part_motion::{Leader, PartMotion};
pub use plan::{LibraryPlan, PlannedMovement};
pub use recognition::{Recogniser, Recognition, RecognitionError, Segment};
pub use trained_library::{EncodedClip, LibraryError, TrainedLibrary};
pub use walk::WalkError;

/// The predictions of a primitive about one part.
#[derive(Clone, Debug, PartialEq)]
pub struct LibraryExpert {
    /// Inducing inputs, kernel, and the mean of the inducing outputs.
    pub fitted: FittedExpert,
    /// Covariance of every column of its inducing outputs [K x K].
    pub covariance: DMatrix<f64>,
    /// Evidence from rows that are not in a movement of the library; `None`: no such rows.
    pub external: Option<ExternalEvidence>,
}

/// A primitive: the predictions of one part about all parts.
#[derive(Clone, Debug, PartialEq)]
pub struct Primitive {
    /// Its name; no other primitive of its part has it.
    pub name: String,
    /// The part that the primitive belongs to, counted from 0.
    pub part: usize,
    /// Its predictions about each part `[M]`.
    pub experts: Vec<LibraryExpert>,
    /// Its origin; `None`: the training of its library.
    pub origin: Option<Box<Origin>>,
    /// Excerpts of movements that used the primitive but are not in its library.
    pub excerpts: Vec<Excerpt>,
}

/// A movement of a library: one primitive of each part, under couplings of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct LearnedMovement {
    /// Its name; no other movement has it.
    pub name: String,
    /// The primitive that each part uses `[M]`.
    pub uses: Vec<usize>,
    /// Coupling variances [M x M], row the source, column the target.
    pub alpha: DMatrix<f64>,
    /// Sums over its rows for the experts about each part `[M]`, with the sources stacked in order; `None`
    /// when the primitives did not learn from the movement.
    pub sums: Option<Vec<DynamicsSums>>,
    /// The latent means of its sequences, `starts[sequence][part]` [T x Q_i].
    pub starts: Vec<Vec<DMatrix<f64>>>,
    /// The origin of its couplings.
    pub couplings: CouplingsFrom,
    /// The number of rounds of rollouts of the movement whose rows its sums have; 0: recorded rows alone. See
    /// [`TrainedLibrary::learn_from_own_rollouts`].
    pub rollout_rounds: usize,
}

/// The origin of a movement's couplings: learned with the primitives, fitted to clips, taken from another
/// movement, chosen by the user, or all equal to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "from", rename_all = "lowercase", deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum CouplingsFrom {
    /// They were learned together with the primitives.
    Training,
    /// They were fitted to clips, while the primitives stayed as they were.
    Clips {
        /// The bound of the clips under the stored primitives, in nats.
        bound: f64,
        /// Iterations of the fit.
        iterations: usize,
    },
    /// They were taken from another movement.
    Movement {
        /// Its name. The names of several movements are joined with "+".
        movement: String,
    },
    /// A user chose them.
    Hand,
    /// No movement uses the primitives: the couplings are 1.
    Nothing,
}

/// Pose maps, primitives and movements, without the data they were learned from.
#[derive(Clone, Debug, PartialEq)]
pub struct Library {
    /// Order p of the dynamics.
    pub order: usize,
    /// The factor of the signal variance on the diagonal of every inducing covariance.
    pub jitter: f64,
    /// The pose map of each part `[M]`.
    pub parts: Vec<PoseMap>,
    /// Sum over rows of psi2 of each pose map [L_i x L_i] `[M]`, to fix its inducing outputs for new rows.
    pub pose_sums: Vec<DMatrix<f64>>,
    /// The primitives.
    pub primitives: Vec<Primitive>,
    /// The movements.
    pub movements: Vec<LearnedMovement>,
    /// The terms of the bound that training reached, in nats.
    pub terms: BoundTerms,
}

impl Library {
    /// The library with the optimal posteriors at `params`, where the bound has these `terms`. The plan gives
    /// the names.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub(crate) fn fit(
        objective: &Objective,
        params: &Params,
        terms: BoundTerms,
        plan: &LibraryPlan,
    ) -> Result<Self, NumericsError> {
        let posteriors = objective.posteriors(params)?;
        let (order, jitter) = (objective.sequences().order(), objective.jitter());
        let maps = FittedMaps::new(params, &posteriors, objective)?;
        let offsets: Vec<_> = (0..params.part_count()).map(|i| expert_offsets(params, i)).collect();
        let named = plan.primitives().into_iter().zip(maps.experts).enumerate();
        let primitives = named.map(|(a, (planned, fitted))| {
            let experts = fitted.into_iter().enumerate().map(|(i, fitted)| {
                let (at, points) = (offsets[i][a], fitted.z().nrows());
                let covariance = &posteriors.dynamics[i].covariance;
                let covariance = symmetric(covariance.view((at, at), (points, points)).into_owned());
                LibraryExpert { fitted, covariance, external: None }
            });
            let (name, part, experts) = (planned.name, planned.part, experts.collect());
            Primitive { name, part, experts, origin: None, excerpts: Vec::new() }
        });
        let primitives = primitives.collect();
        let learned = objective.repertoire().movements().iter().zip(plan.movements());
        let learned = learned.zip(posteriors.sums).zip(&params.alpha);
        let movements = learned.map(|(((movement, planned), sums), alpha)| LearnedMovement {
            name: planned.name.clone(),
            uses: movement.uses().to_vec(),
            alpha: alpha.clone(),
            sums: Some(sums),
            starts: movement.sequences().ranges().map(|range| params.latent_means(&range)).collect(),
            couplings: CouplingsFrom::Training,
            rollout_rounds: 0,
        });
        let movements = movements.collect();
        let pose_sums = posteriors.pose_sums;
        Ok(Self { order, jitter, parts: maps.parts, pose_sums, primitives, movements, terms })
    }

    /// Number of parts M.
    pub fn part_count(&self) -> usize {
        self.parts.len()
    }

    /// Latent dimensions Q of each part `[M]`.
    pub fn latent_dimensions(&self) -> Vec<usize> {
        self.parts.iter().map(|part| part.r().ncols()).collect()
    }

    /// The number of stored numbers from which every movement can be rolled out, each from one sequence: pose
    /// maps and primitives once, couplings and a start for each movement. A map has its inducing inputs,
    /// their posterior mean and its kernel.
    pub fn stored_numbers(&self) -> usize {
        let experts = self.primitives.iter().flat_map(|primitive| &primitive.experts);
        let start: usize = self.latent_dimensions().iter().map(|q| self.order * q).sum();
        self.parts.iter().map(PoseMap::stored_numbers).sum::<usize>()
            + experts.map(|expert| expert.fitted.stored_numbers()).sum::<usize>()
            + self.movements.len() * (self.part_count() * self.part_count() + start)
    }

    /// The first row of each primitive's expert about part `i` in the stack of all; last, the height of the
    /// stack.
    pub(super) fn offsets(&self, i: usize) -> Vec<usize> {
        stack_offsets(self.primitives.iter().map(|primitive| primitive.experts[i].fitted.z().nrows()))
    }
}

#[cfg(test)]
mod tests;
