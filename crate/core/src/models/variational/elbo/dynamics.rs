//! The dynamics into one part: the bound of the stacked experts of all primitives about it, over the rows of
//! all movements.
//!
//! All movements that use an expert share its inducing outputs. Movements differ in their noise alpha^i, so
//! their statistics are pooled in units of the noise n of the first movement: with shares n / n_m,
//!
//! F = F( n, sum_m (n / n_m) (Psi2_m, b_m, psi0_m, c2_m) ) - C/2 sum_m R_m log(n_m / n)
//!
//! is the collapsed bound of A = K + sum_m Psi2_m / n_m. An expert that no movement uses adds
//! exactly 0.

use crate::elementary::Elementary;
use crate::gp::bound::{InducingPosterior, SparseGp};
use crate::gp::outputs::Outputs;
use crate::gp::psi::{PairWorkspace, Purpose};
use crate::gp::stored_outputs::StoredOutputs;
use crate::gp::{Gaussians, NumericsError};
use crate::models::variational::elbo::objective::Objective;
use crate::models::variational::elbo::rows::MovementRows;
#[cfg(feature = "threads")]
use crate::models::variational::elbo::rows::SourceStatistics;
use crate::models::variational::elbo::sums::ExpertCovariance;
use crate::models::variational::elbo::sums::{DynamicsSums, stack_offsets};
use crate::models::variational::params::Params;
use nalgebra::DMatrix;

/// The statistics of the dynamics into one target, with memory for their bound and adjoints.
pub struct Dynamics {
    target: usize,
    /// The place in the stack where the expert of each primitive starts.
    offsets: Vec<usize>,
    experts: Vec<ExpertCovariance>,
    movements: Vec<MovementRows>,
    k: DMatrix<f64>,
    psi2: DMatrix<f64>,
    b: DMatrix<f64>,
    psi0: f64,
    second_moment: f64,
    outputs: Outputs,
}

/// The experts and rows of one source part for one target in all movements; different source parts can be
/// pulled back at the same time.
#[cfg(feature = "threads")]
pub struct SourceRows<'a> {
    target: usize,
    /// The experts of the part's primitives, by primitive.
    experts: Vec<(usize, &'a mut ExpertCovariance)>,
    /// One for each movement.
    rows: Vec<(&'a mut SourceStatistics, &'a mut PairWorkspace)>,
}

impl Dynamics {
    pub fn new(objective: &Objective, params: &Params, target: usize) -> Self {
        let latent = params.parts[target].latents.mean.ncols();
        let shapes = || params.experts.iter().map(|row| row[target].z.shape());
        let experts = shapes().map(|(ips, dims)| ExpertCovariance::new(ips, dims));
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

    /// n, the unit of the noises of all movements.
    fn noise(&self) -> f64 {
        self.movements.first().map_or(1.0, |rows| rows.noise)
    }

    /// Computes the statistics of all movements and pools them. `histories` and `workspaces` have one entry
    /// for each movement and part.
    pub fn compute(
        &mut self,
        objective: &Objective,
        params: &Params,
        histories: &[Vec<Gaussians>],
        purpose: Purpose,
        workspaces: &mut [Vec<PairWorkspace>],
    ) {
        for ((covariance, row), at) in self.experts.iter_mut().zip(&params.experts).zip(&self.offsets) {
            let expert = &row[self.target];
            expert.kernel.inducing_covariance_into(&expert.z, objective.jitter, &mut covariance.k);
            self.k.view_mut((*at, *at), covariance.k.shape()).copy_from(&covariance.k);
        }
        for ((rows, histories), workspaces) in self.movements.iter_mut().zip(histories).zip(workspaces) {
            rows.compute(objective, params, histories, purpose, workspaces);
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

    /// The pooled process and its inducing outputs, borrowed separately.
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

    /// The optimal inducing outputs of the stacked experts, to be stored.
    pub fn stored(&mut self) -> Result<StoredOutputs, NumericsError> {
        StoredOutputs::best(&self.gp().0)
    }

    /// The sums of each movement from which q(u) is computed.
    pub fn into_sums(self) -> impl Iterator<Item = DynamicsSums> {
        self.movements.into_iter().map(|rows| rows.sums)
    }

    /// The bound, in nats. [`pull_back`](Self::pull_back) and [`add_gradient`](Self::add_gradient) then add
    /// its gradient.
    pub fn adjoint(&mut self, objective: &Objective, params: &Params) -> Result<f64, NumericsError> {
        let (gp, outputs) = self.gp();
        let bound = outputs.bound_and_adjoint(&gp)? + self.other_noises();
        let (noise, columns) = (self.noise(), self.b.ncols() as f64);
        let Self { target, offsets, experts, movements, outputs, .. } = self;
        let adjoint = outputs.adjoint();
        for ((covariance, row), at) in experts.iter_mut().zip(&params.experts).zip(offsets.iter()) {
            let ExpertCovariance { k, k_adjoint, kernel_adjoint } = covariance;
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
        // The first noise is that of its own rows, and the unit of all others.
        let mut first_noise = adjoint.noise;
        for rows in movements.iter().skip(1) {
            let unit_adjoint = 0.5 * columns * rows.count() as f64 / noise;
            first_noise += rows.share_adjoint(adjoint) / rows.noise + unit_adjoint;
        }
        for (m, rows) in movements.iter_mut().enumerate() {
            let share = noise / rows.noise;
            let noise_adjoint = if m == 0 {
                first_noise
            } else {
                let own = 0.5 * columns * rows.count() as f64;
                -(rows.share_adjoint(adjoint) * share + own) / rows.noise
            };
            rows.adjoint(adjoint, share, noise_adjoint);
        }
        Ok(bound)
    }

    /// Adds the gradient with respect to the histories of all movements and parts to `into`. That with
    /// respect to the experts is added by [`add_gradient`](Self::add_gradient). `workspaces` are those of
    /// [`compute`](Self::compute).
    pub fn pull_back(
        &mut self,
        params: &Params,
        histories: &[Vec<Gaussians>],
        workspaces: &mut [Vec<PairWorkspace>],
        into: &mut [Vec<Gaussians>],
    ) {
        let places = histories.iter().zip(workspaces).zip(into);
        for (rows, ((histories, workspaces), into)) in self.movements.iter_mut().zip(places) {
            for (((source, histories), workspace), into) in
                rows.sources_mut().zip(histories).zip(workspaces).zip(into)
            {
                let expert = &params.experts[source.primitive][self.target];
                let kernel = &mut self.experts[source.primitive].kernel_adjoint;
                source.pull_back(histories, expert, workspace, into, kernel);
            }
        }
    }

    /// The source parts, each with its own [`SourceRows::pull_back`]; together they do the same as
    /// [`pull_back`](Self::pull_back).
    #[cfg(feature = "threads")]
    pub fn by_source<'a>(
        &'a mut self,
        objective: &Objective,
        workspaces: &'a mut [Vec<PairWorkspace>],
    ) -> Vec<SourceRows<'a>> {
        let target = self.target;
        let parts = workspaces.first().map_or(0, Vec::len);
        let empty = |_| SourceRows { target, experts: Vec::new(), rows: Vec::new() };
        let mut sources: Vec<SourceRows> = (0..parts).map(empty).collect();
        let primitives = objective.repertoire.primitives().iter().zip(&mut self.experts);
        for (primitive, (part, covariance)) in primitives.enumerate() {
            sources[*part].experts.push((primitive, covariance));
        }
        for (rows, workspaces) in self.movements.iter_mut().zip(workspaces) {
            for ((source, workspace), into) in rows.sources_mut().zip(workspaces).zip(&mut sources) {
                into.rows.push((source, workspace));
            }
        }
        sources
    }

    /// Adds the rest of the gradient: with respect to experts, targets and couplings.
    pub fn add_gradient(&self, objective: &Objective, params: &Params, gradient: &mut Params) {
        for rows in &self.movements {
            rows.add_gradient(objective, params, gradient);
        }
        for (covariance, row) in self.experts.iter().zip(&mut gradient.experts) {
            let into = &mut row[self.target];
            covariance.kernel_adjoint.add_to(&mut into.z, &mut into.kernel);
        }
    }
}

#[cfg(feature = "threads")]
impl SourceRows<'_> {
    /// Adds the gradient with respect to the histories of this part in all movements to `into`, and stores
    /// that with respect to its experts.
    pub fn pull_back(
        &mut self,
        params: &Params,
        part: usize,
        histories: &[Vec<Gaussians>],
        into: &mut [&mut Gaussians],
    ) {
        for (((source, workspace), histories), into) in self.rows.iter_mut().zip(histories).zip(into) {
            let expert = &params.experts[source.primitive][self.target];
            let own = self.experts.iter_mut().find(|(primitive, _)| *primitive == source.primitive);
            if let Some((_, ExpertCovariance { kernel_adjoint, .. })) = own {
                source.pull_back(&histories[part], expert, workspace, into, kernel_adjoint);
            }
        }
    }
}
