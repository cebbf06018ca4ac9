//! The dynamics into one part: the bound of all primitives' experts about it, stacked, over the rows of all movements.
//!
//! The inducing outputs of an expert are one set of random numbers, seen through the rows of every movement that uses it. Movements
//! differ in their noise alpha^i, so their statistics are pooled in units of the noise n of the first one: with shares n / n_m,
//!
//! F = F( n, sum_m (n / n_m) (Psi2_m, b_m, psi0_m, c2_m) ) - C/2 sum_m R_m log(n_m / n)
//!
//! is the collapsed bound of A = K + sum_m Psi2_m / n_m. An expert that no movement uses adds exactly nothing.

use crate::elementary::Elementary;
use crate::gp::bound::{InducingPosterior, SparseGp};
use crate::gp::outputs::Outputs;
use crate::gp::psi::{PairWorkspace, Purpose};
use crate::gp::stored_outputs::StoredOutputs;
use crate::gp::{Gaussians, NumericsError};
use crate::models::variational::elbo::expert_room::ExpertRoom;
use crate::models::variational::elbo::objective::Objective;
use crate::models::variational::elbo::rows::MovementRows;
use crate::models::variational::elbo::sums::{DynamicsSums, stack_offsets};
use crate::models::variational::params::Params;
use nalgebra::DMatrix;

/// What the bound of the dynamics into one target is made of, with the room for it and its adjoints.
pub struct Dynamics {
    target: usize,
    /// Where each primitive's expert starts in the stack.
    offsets: Vec<usize>,
    experts: Vec<ExpertRoom>,
    movements: Vec<MovementRows>,
    k: DMatrix<f64>,
    psi2: DMatrix<f64>,
    b: DMatrix<f64>,
    psi0: f64,
    second_moment: f64,
    outputs: Outputs,
}

impl Dynamics {
    pub fn new(objective: &Objective, params: &Params, target: usize) -> Self {
        let latent = params.parts[target].latents.mean.ncols();
        let shapes = || params.experts.iter().map(|row| row[target].z.shape());
        let experts = shapes().map(|(ips, dims)| ExpertRoom::new(ips, dims));
        let offsets = stack_offsets(shapes().map(|(ips, _)| ips));
        let total = offsets[offsets.len() - 1];
        let movements = 0..objective.repertoire.movements().len();
        let movements = movements.map(|m| MovementRows::new(objective, params, m, target, &offsets));
        Self {
            target,
            experts: experts.collect(),
            movements: movements.collect(),
            offsets,
            k: DMatrix::zeros(total, total),
            psi2: DMatrix::zeros(total, total),
            b: DMatrix::zeros(total, latent),
            psi0: 0.0,
            second_moment: 0.0,
            outputs: objective.outputs(|stored| &stored.dynamics[target], (total, latent)),
        }
    }

    /// n, the noise that the others are counted in.
    fn noise(&self) -> f64 {
        self.movements.first().map_or(1.0, |rows| rows.noise)
    }

    /// The statistics of all movements, pooled. `histories` and `rooms` hold one for each movement and part.
    pub fn compute(
        &mut self,
        objective: &Objective,
        params: &Params,
        histories: &[Vec<Gaussians>],
        purpose: Purpose,
        rooms: &mut [Vec<PairWorkspace>],
    ) {
        for ((room, row), at) in self.experts.iter_mut().zip(&params.experts).zip(&self.offsets) {
            let expert = &row[self.target];
            expert.kernel.inducing_covariance_into(&expert.z, objective.jitter, &mut room.k);
            self.k.view_mut((*at, *at), room.k.shape()).copy_from(&room.k);
        }
        for ((rows, histories), rooms) in self.movements.iter_mut().zip(histories).zip(rooms) {
            rows.compute(objective, params, histories, purpose, rooms);
        }
        self.psi2.fill(0.0);
        self.b.fill(0.0);
        (self.psi0, self.second_moment) = (0.0, 0.0);
        let noise = self.noise();
        for rows in &self.movements {
            let share = noise / rows.noise;
            rows.add_to(share, &mut self.psi2, &mut self.b);
            self.psi0 += share * rows.psi0;
            self.second_moment += share * rows.second_moment;
        }
    }

    /// The pooled process, and the place where its bound is computed, apart.
    fn gp(&mut self) -> (SparseGp<'_>, &mut Outputs) {
        let gp = SparseGp {
            noise: self.noise(),
            k: &self.k,
            psi2: &self.psi2,
            b: &self.b,
            psi0: self.psi0,
            second_moment: self.second_moment,
            rows: self.movements.iter().map(MovementRows::count).sum(),
        };
        (gp, &mut self.outputs)
    }

    /// - C/2 sum_m R_m log(n_m / n).
    fn other_noises(&self) -> f64 {
        let noise = self.noise();
        let log = |rows: &MovementRows| rows.count() as f64 * (rows.noise / noise).logarithm();
        -0.5 * self.b.ncols() as f64 * self.movements.iter().skip(1).map(log).sum::<f64>()
    }

    /// The bound, in nats.
    pub fn bound(&mut self) -> Result<f64, NumericsError> {
        let (gp, outputs) = self.gp();
        Ok(outputs.bound(&gp)? + self.other_noises())
    }

    /// q(u) of the stacked experts of all primitives.
    pub fn posterior(&mut self) -> Result<InducingPosterior, NumericsError> {
        self.gp().0.posterior()
    }

    /// The best inducing outputs of the stacked experts, to be kept.
    pub fn stored(&mut self) -> Result<StoredOutputs, NumericsError> {
        StoredOutputs::best(&self.gp().0)
    }

    /// What q(u) is computed from, movement by movement.
    pub fn into_sums(self) -> impl Iterator<Item = DynamicsSums> {
        self.movements.into_iter().map(|rows| rows.sums)
    }

    /// The bound, in nats; its gradient is added to `gradient` and, for the histories, to `histories_adjoint`.
    pub fn gradient(
        &mut self,
        objective: &Objective,
        params: &Params,
        histories: &[Vec<Gaussians>],
        rooms: &mut [Vec<PairWorkspace>],
        gradient: &mut Params,
        histories_adjoint: &mut [Vec<Gaussians>],
    ) -> Result<f64, NumericsError> {
        let (gp, outputs) = self.gp();
        let bound = outputs.bound_and_adjoint(&gp)? + self.other_noises();
        let (noise, columns) = (self.noise(), self.b.ncols() as f64);
        let Self { target, offsets, experts, movements, outputs, .. } = self;
        let adjoint = outputs.adjoint();
        for ((room, row), at) in experts.iter_mut().zip(&params.experts).zip(offsets.iter()) {
            let ExpertRoom { k, k_adjoint, kernel_adjoint } = room;
            let expert = &row[*target];
            k_adjoint.copy_from(&adjoint.k.view((*at, *at), k.shape()));
            kernel_adjoint.set_zero();
            expert.kernel.inducing_covariance_adjoint(
                &expert.z,
                k,
                objective.jitter,
                k_adjoint,
                kernel_adjoint,
            );
        }
        // The first noise counts for its own rows, and as the unit of all others.
        let mut first_noise = adjoint.noise;
        for rows in movements.iter().skip(1) {
            let lost = 0.5 * columns * rows.count() as f64 / noise;
            first_noise += rows.share_adjoint(adjoint) / rows.noise + lost;
        }
        let places = histories.iter().zip(rooms).zip(histories_adjoint);
        for (m, (rows, ((histories, rooms), into))) in movements.iter_mut().zip(places).enumerate() {
            let share = noise / rows.noise;
            let noise_adjoint = if m == 0 {
                first_noise
            } else {
                let own = 0.5 * columns * rows.count() as f64;
                -(rows.share_adjoint(adjoint) * share + own) / rows.noise
            };
            let given = (adjoint, share, noise_adjoint);
            rows.add_gradient(objective, params, given, histories, rooms, experts, gradient, into);
        }
        for (room, row) in experts.iter().zip(&mut gradient.experts) {
            let into = &mut row[*target];
            room.kernel_adjoint.add_to(&mut into.z, &mut into.kernel);
        }
        Ok(bound)
    }
}
