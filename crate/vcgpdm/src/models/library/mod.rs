//! A library of primitives: the dynamics of each part learned once, and coupled in new ways (Velychko et al. 2018, section 5.5).
//!
//! A *primitive* belongs to one part and holds what that part predicts about every part. A *movement* uses one primitive of each
//! part under couplings of its own; the pose map of a part is one for all. [`LibraryTrainer`] learns a library from clips of
//! several movements; [`Library::combination`] is a [`Vcgpdm`](crate::models::variational::Vcgpdm) of any primitives, one of each
//! part, whether it was ever recorded or not; [`CouplingTrainer`] learns the couplings of a combination from a clip, while the
//! primitives stay as they are.

mod combination;
mod coupling;
mod nearest;
mod plan;
mod trained;
mod trainer;
mod walk;

use crate::gp::NumericsError;
use crate::gp::linalg::symmetric;
use crate::models::variational::{
    BoundTerms, DynamicsSums, Elsewhere, FittedExpert, Objective, Params, PoseMap, stack_offsets,
};
use nalgebra::DMatrix;

pub use combination::CombinationError;
pub use coupling::CouplingTrainer;
pub use plan::{LibraryPlan, PlanError, PlannedMovement};
pub use trained::{LibraryError, ObservedClip, TrainedLibrary};
pub use trainer::LibraryTrainer;
pub use walk::{LatentWalk, LibraryWalk, TEMPOS, WalkError, WalkFrames};

/// What a primitive predicts about one part.
#[derive(Clone, Debug, PartialEq)]
pub struct LibraryExpert {
    /// Inducing inputs, kernel, and the mean of the inducing outputs.
    pub fitted: FittedExpert,
    /// Covariance of every column of its inducing outputs [K x K].
    pub covariance: DMatrix<f64>,
    /// What it has learned from rows of another library; `None`: nothing.
    pub elsewhere: Option<Elsewhere>,
}

/// A primitive: the dynamics of one part, as they are seen by all parts.
#[derive(Clone, Debug, PartialEq)]
pub struct Primitive {
    /// Its name; no other primitive of its part has it.
    pub name: String,
    /// The part that it belongs to, counted from 0.
    pub part: usize,
    /// Its predictions about each part `[M]`.
    pub experts: Vec<LibraryExpert>,
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
    /// What its rows say about the experts in use `[M]`, the sources stacked in order; `None` where only its couplings were learned.
    pub sums: Option<Vec<DynamicsSums>>,
    /// The latent means of its sequences, `starts[sequence][part]` [T x Q_i].
    pub starts: Vec<Vec<DMatrix<f64>>>,
    /// Where its couplings come from.
    pub couplings: CouplingsFrom,
}

/// Where the couplings of a movement come from.
#[derive(Clone, Debug, PartialEq)]
pub enum CouplingsFrom {
    /// They were learned together with the primitives.
    Training,
    /// They were fitted to clips, while the primitives stayed: the bound of these clips, in nats, and iterations.
    Clips {
        /// The bound under the stored primitives.
        bound: f64,
        /// Iterations of the fit.
        iterations: usize,
    },
    /// They were taken from the movement of this name; from several, each source's from one, their names are joined with "+".
    Movement(String),
    /// Nothing was known about them: 1 each.
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
    /// Sum over rows of psi2 of each pose map [L_i x L_i] `[M]`: with it, its inducing outputs can be kept for new rows.
    pub pose_sums: Vec<DMatrix<f64>>,
    /// The primitives.
    pub primitives: Vec<Primitive>,
    /// The movements.
    pub movements: Vec<LearnedMovement>,
    /// The terms of the bound that training reached, in nats.
    pub terms: BoundTerms,
}

impl Library {
    /// The library with the optimal posteriors at `params`, where the bound has these `terms`; the plan names what there is.
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
        let mut parts = Vec::with_capacity(params.part_count());
        for (part, v) in params.parts.iter().zip(posteriors.kinematics) {
            let (r, kernel) = (part.r.clone(), part.kernel.clone());
            parts.push(PoseMap::new(r, kernel, part.beta, v.mean, v.covariance, jitter)?);
        }
        let mut primitives = Vec::new();
        for (a, (planned, row)) in plan.primitives().into_iter().zip(&params.experts).enumerate() {
            let mut experts = Vec::with_capacity(row.len());
            for (i, expert) in row.iter().enumerate() {
                let at: usize = params.experts[..a].iter().map(|row| row[i].z.nrows()).sum();
                let (u, points) = (&posteriors.dynamics[i], expert.z.nrows());
                let mean = u.mean.rows(at, points).into_owned();
                let covariance = symmetric(u.covariance.view((at, at), (points, points)).into_owned());
                let fitted = FittedExpert::new(expert.z.clone(), expert.kernel.clone(), mean, jitter)?;
                experts.push(LibraryExpert { fitted, covariance, elsewhere: None });
            }
            primitives.push(Primitive { name: planned.name, part: planned.part, experts });
        }
        let ranges: Vec<_> = objective.sequences().ranges().collect();
        let learned = objective.repertoire().movements().iter().zip(plan.movements());
        let learned = learned.zip(posteriors.sums).zip(&params.alpha);
        let movements = learned.map(|(((movement, planned), sums), alpha)| {
            let start = |range: &std::ops::Range<usize>| {
                let latents = params.parts.iter().map(|part| &part.latents.mean);
                latents.map(|x| x.rows(range.start, range.len()).into_owned()).collect()
            };
            LearnedMovement {
                name: planned.name.clone(),
                uses: movement.uses().to_vec(),
                alpha: alpha.clone(),
                sums: Some(sums),
                starts: ranges[movement.which()].iter().map(start).collect(),
                couplings: CouplingsFrom::Training,
            }
        });
        let movements = movements.collect();
        let pose_sums = posteriors.pose_sums;
        Ok(Self { order, jitter, parts, pose_sums, primitives, movements, terms })
    }

    /// Number of parts M.
    pub fn part_count(&self) -> usize {
        self.parts.len()
    }

    /// Latent dimensions Q of each part `[M]`.
    pub fn latent_dimensions(&self) -> Vec<usize> {
        self.parts.iter().map(|part| part.r().ncols()).collect()
    }

    /// How many numbers must be kept to roll out every movement, each from one sequence: pose maps and primitives once, couplings
    /// and a start for each movement. Of each map its inducing inputs, their posterior mean and its kernel.
    pub fn stored_numbers(&self) -> usize {
        let pose = |map: &PoseMap| map.r().len() + map.mean().len() + map.kernel().lambda.len() + 1;
        let expert = |e: &FittedExpert| e.z().len() + e.mean().len() + e.kernel().lambda.len();
        let experts = self.primitives.iter().flat_map(|primitive| &primitive.experts);
        let start: usize = self.latent_dimensions().iter().map(|q| self.order * q).sum();
        self.parts.iter().map(pose).sum::<usize>()
            + experts.map(|known| expert(&known.fitted)).sum::<usize>()
            + self.movements.len() * (self.part_count() * self.part_count() + start)
    }

    /// Where each primitive's expert about part `i` starts in the stack of all; last its height.
    pub(super) fn offsets(&self, i: usize) -> Vec<usize> {
        stack_offsets(self.primitives.iter().map(|primitive| primitive.experts[i].fitted.z().nrows()))
    }
}

#[cfg(test)]
mod tests;
