//! The rows of one movement as data of the dynamics into one part: statistics of all sources, stacked and
//! weighted by the couplings.

use crate::gp::Gaussians;
use crate::gp::bound::BoundAdjoint;
use crate::gp::kernel::KernelAdjoint;
use crate::gp::psi::{PairWorkspace, PsiAdjoint, PsiStatistics, Purpose};
use crate::gp::tall::{add_product, add_tr_product};
use crate::models::rollout::couplings::coupling_weights_into;
use crate::models::variational::elbo::objective::Objective;
use crate::models::variational::elbo::sums::{DynamicsSums, stack_offsets};
use crate::models::variational::params::{Expert, Params};
use nalgebra::DMatrix;

/// The statistics of one source, a part with its primitive, and their adjoints.
pub struct SourceStatistics {
    pub primitive: usize,
    statistics: PsiStatistics,
    /// dF/dpsi0.
    psi0_adjoint: f64,
    /// dF/dpsi2 [K x K].
    psi2_adjoint: DMatrix<f64>,
    /// dF/dpsi1 [R x K].
    psi1_adjoint: DMatrix<f64>,
    /// dF/db, weighted, and its transpose [K x Q], [Q x K].
    b: DMatrix<f64>,
    b_transposed: DMatrix<f64>,
    /// For every source, a block off the diagonal of the stack [K_source x K].
    cross: Vec<DMatrix<f64>>,
}

/// The rows of one movement as data of the dynamics into one target, with memory for statistics and adjoints.
pub struct MovementRows {
    movement: usize,
    target: usize,
    /// alpha^i.
    pub noise: f64,
    weights: Vec<f64>,
    /// dF/dw.
    weights_adjoint: Vec<f64>,
    /// dF/dalpha^i for fixed weights.
    noise_adjoint: f64,
    /// The place where each source starts in the stack of this movement.
    offsets: Vec<usize>,
    /// The place where each source starts in the stack of all primitives.
    places: Vec<usize>,
    sources: Vec<SourceStatistics>,
    target_mean: DMatrix<f64>,
    target_variance: DMatrix<f64>,
    /// c2.
    pub second_moment: f64,
    /// Without weights.
    pub sums: DynamicsSums,
    psi2: DMatrix<f64>,
    b: DMatrix<f64>,
    /// psi0, weighted.
    pub psi0: f64,
}

impl MovementRows {
    /// `places` are the places where the primitives start in the stack of all.
    pub fn new(
        objective: &Objective,
        params: &Params,
        movement: usize,
        target: usize,
        places: &[usize],
    ) -> Self {
        let in_use = &objective.repertoire.movements()[movement];
        let rows = in_use.sequences().transitions();
        let latent = params.parts[target].latents.mean.ncols();
        let experts = || in_use.uses().iter().map(|a| &params.experts[*a][target].z);
        let sources = in_use.uses().iter().zip(experts()).map(|(primitive, z)| {
            let (ips, dims) = z.shape();
            SourceStatistics {
                primitive: *primitive,
                psi0_adjoint: 0.0,
                statistics: PsiStatistics::new(rows, ips, dims),
                psi2_adjoint: DMatrix::zeros(ips, ips),
                psi1_adjoint: DMatrix::zeros(rows, ips),
                b: DMatrix::zeros(ips, latent),
                b_transposed: DMatrix::zeros(latent, ips),
                cross: experts().map(|other| DMatrix::zeros(other.nrows(), ips)).collect(),
            }
        });
        let offsets = stack_offsets(experts().map(|z| z.nrows()));
        let m = in_use.uses().len();
        let total = offsets[m];
        Self {
            movement,
            target,
            noise: 0.0,
            weights: vec![0.0; m],
            weights_adjoint: vec![0.0; m],
            noise_adjoint: 0.0,
            sources: sources.collect(),
            offsets,
            places: in_use.uses().iter().map(|a| places[*a]).collect(),
            target_mean: DMatrix::zeros(rows, latent),
            target_variance: DMatrix::zeros(rows, latent),
            second_moment: 0.0,
            sums: DynamicsSums::zeros(total, latent),
            psi2: DMatrix::zeros(total, total),
            b: DMatrix::zeros(total, latent),
            psi0: 0.0,
        }
    }

    /// R, the number of rows.
    pub fn count(&self) -> usize {
        self.target_mean.nrows()
    }

    /// Computes the statistics of all sources, stacks and weights them. `histories` and `workspaces` have one
    /// entry for each part.
    pub fn compute(
        &mut self,
        objective: &Objective,
        params: &Params,
        histories: &[Gaussians],
        purpose: Purpose,
        workspaces: &mut [PairWorkspace],
    ) {
        let i = self.target;
        let movement = &objective.repertoire.movements()[self.movement];
        self.noise =
            coupling_weights_into(params.alpha[self.movement].column(i).as_slice(), &mut self.weights);
        let latents = &params.parts[i].latents;
        movement.sequences().lagged_into(&latents.mean, 0, &mut self.target_mean);
        movement.sequences().lagged_into(&latents.variance, 0, &mut self.target_variance);
        self.second_moment = self.target_mean.norm_squared() + self.target_variance.sum();
        self.psi0 = 0.0;
        for (j, primitive) in movement.uses().iter().enumerate() {
            let (before, rest) = self.sources.split_at_mut(j);
            let (source, expert) = (&mut rest[0], &params.experts[*primitive][i]);
            source.statistics.compute(&histories[j], &expert.z, &expert.kernel, purpose, &mut workspaces[j]);
            let (at, shape) = (self.offsets[j], source.statistics.psi2.shape());
            self.sums.psi2.view_mut((at, at), shape).copy_from(&source.statistics.psi2);
            for (l, other) in before.iter().enumerate() {
                let cross = &mut source.cross[l];
                cross.fill(0.0);
                add_tr_product(&other.statistics.psi1, &source.statistics.psi1, cross);
                let to = self.offsets[l];
                self.sums.psi2.view_mut((to, at), cross.shape()).copy_from(cross);
                for a in 0..cross.nrows() {
                    for b in 0..cross.ncols() {
                        self.sums.psi2[(at + b, to + a)] = cross[(a, b)];
                    }
                }
            }
            source.b.fill(0.0);
            add_tr_product(&source.statistics.psi1, &self.target_mean, &mut source.b);
            self.sums.psi1_mu.rows_mut(at, shape.0).copy_from(&source.b);
            self.psi0 += self.weights[j] * self.weights[j] * source.statistics.psi0;
        }
        self.sums.weighted_into(&self.weights, &self.offsets, &mut self.psi2, &mut self.b);
    }

    /// Adds Psi2 and b, times `share`, to those of the stack of all primitives.
    pub fn add_to(&self, share: f64, psi2: &mut DMatrix<f64>, b: &mut DMatrix<f64>) {
        for (j, place) in self.places.iter().enumerate() {
            let (at, size) = (self.offsets[j], self.offsets[j + 1] - self.offsets[j]);
            for (k, other) in self.places.iter().enumerate() {
                let shape = (size, self.offsets[k + 1] - self.offsets[k]);
                let own = self.psi2.view((at, self.offsets[k]), shape);
                psi2.view_mut((*place, *other), shape).zip_apply(&own, |out, v| *out += share * v);
            }
            b.rows_mut(*place, size).zip_apply(&self.b.rows(at, size), |out, v| *out += share * v);
        }
    }

    /// dF with respect to the share of these rows in the pooled statistics, from the adjoint of the pool.
    pub fn share_adjoint(&self, adjoint: &BoundAdjoint) -> f64 {
        let mut sum = adjoint.psi0 * self.psi0 + adjoint.second_moment * self.second_moment;
        for (j, place) in self.places.iter().enumerate() {
            let (at, size) = (self.offsets[j], self.offsets[j + 1] - self.offsets[j]);
            for (k, other) in self.places.iter().enumerate() {
                let shape = (size, self.offsets[k + 1] - self.offsets[k]);
                let own = self.psi2.view((at, self.offsets[k]), shape);
                sum += adjoint.psi2.view((*place, *other), shape).dot(&own);
            }
            sum += adjoint.b.rows(*place, size).dot(&self.b.rows(at, size));
        }
        sum
    }

    /// Computes the adjoints of these rows, whose share in the pool is `share`, from the `adjoint` of the
    /// pool. `noise_adjoint` is dF/dalpha^i for fixed weights. After [`compute`](Self::compute).
    pub fn adjoint(&mut self, adjoint: &BoundAdjoint, share: f64, noise_adjoint: f64) {
        self.noise_adjoint = noise_adjoint;
        for j in 0..self.sources.len() {
            let (at, place, w) = (self.offsets[j], self.places[j], self.weights[j]);
            let (before, rest) = self.sources.split_at_mut(j);
            let Some((source, after)) = rest.split_first_mut() else { break };
            let shape = source.psi2_adjoint.shape();
            let b = adjoint.b.rows(place, shape.0);
            let own = adjoint.psi2.view((place, place), shape);
            let mut weight_adjoint = b.dot(&self.sums.psi1_mu.rows(at, shape.0))
                + 2.0 * w * own.dot(&source.statistics.psi2)
                + 2.0 * w * adjoint.psi0 * source.statistics.psi0;
            source.b.zip_apply(&b, |out, b| *out = share * w * b);
            source.b.transpose_to(&mut source.b_transposed);
            source.psi1_adjoint.fill(0.0);
            add_product(&self.target_mean, &source.b_transposed, &mut source.psi1_adjoint);
            for (l, other) in before.iter().enumerate().chain((j + 1..).zip(after.iter())) {
                let (to, w_other, cross) = (self.offsets[l], self.weights[l], &mut source.cross[l]);
                let block = adjoint.psi2.view((self.places[l], place), cross.shape());
                weight_adjoint += 2.0 * w_other * block.dot(&self.sums.psi2.view((to, at), cross.shape()));
                cross.zip_apply(&block, |out, v| *out = 2.0 * share * w * w_other * v);
                add_product(&other.statistics.psi1, cross, &mut source.psi1_adjoint);
            }
            source.psi0_adjoint = share * w * w * adjoint.psi0;
            source.psi2_adjoint.zip_apply(&own, |out, v| *out = share * w * w * v);
            self.weights_adjoint[j] = share * weight_adjoint;
        }
        // All sources have used the targets: their memory now stores the adjoint.
        let second_moment = share * adjoint.second_moment;
        self.target_mean *= 2.0 * second_moment;
        for source in &self.sources {
            add_product(&source.statistics.psi1, &source.b, &mut self.target_mean);
        }
        self.target_variance.fill(second_moment);
    }

    /// The sources in the order of their parts, to pull their adjoints back.
    pub fn sources_mut(&mut self) -> impl Iterator<Item = &mut SourceStatistics> {
        self.sources.iter_mut()
    }

    /// Adds the gradient with respect to targets and couplings. After [`adjoint`](Self::adjoint).
    pub fn add_gradient(&self, objective: &Objective, params: &Params, gradient: &mut Params) {
        let i = self.target;
        let sequences = objective.repertoire.movements()[self.movement].sequences();
        let into = &mut gradient.parts[i].latents;
        sequences.add_targets_adjoint(&self.target_mean, &mut into.mean);
        sequences.add_targets_adjoint(&self.target_variance, &mut into.variance);
        // d alpha^i / d alpha^{ji} = w_j^2 and d w_k / d alpha^{ji} = w_k w_j^2 / alpha^i - [j = k] w_j /
        // alpha^{ji}.
        let alpha = &params.alpha[self.movement];
        let shared: f64 = self.weights_adjoint.iter().zip(&self.weights).map(|(g, w)| g * w).sum();
        for (j, (w, g)) in self.weights.iter().zip(&self.weights_adjoint).enumerate() {
            gradient.alpha[self.movement][(j, i)] +=
                w * w * (self.noise_adjoint + shared / self.noise) - g * w / alpha[(j, i)];
        }
    }
}

impl SourceStatistics {
    /// Adds the gradient with respect to the histories to `into` and with respect to the expert to `kernel`.
    /// After [`MovementRows::adjoint`], with the `workspace` of [`MovementRows::compute`].
    pub fn pull_back(
        &mut self,
        histories: &Gaussians,
        expert: &Expert,
        workspace: &mut PairWorkspace,
        into: &mut Gaussians,
        kernel: &mut KernelAdjoint,
    ) {
        let psi = PsiAdjoint { psi0: self.psi0_adjoint, psi1: &self.psi1_adjoint, psi2: &self.psi2_adjoint };
        self.statistics.pull_back((histories, &expert.z, &expert.kernel), &psi, workspace, into, kernel);
    }
}
