//! The dynamics into one part: the collapsed bound of all experts about it, stacked and weighted by the couplings.

use crate::gp::bound::{BoundWorkspace, InducingPosterior, SparseGp};
use crate::gp::kernel::KernelAdjoint;
use crate::gp::psi::{PairWorkspace, PsiAdjoint, PsiStatistics, Purpose};
use crate::gp::tall::{add_product, add_tr_product};
use crate::gp::{Gaussians, NumericsError};
use crate::models::couplings::coupling_weights_into;
use crate::models::variational::elbo::objective::Objective;
use crate::models::variational::params::Params;
use nalgebra::DMatrix;

/// The sums over t that q(u) of one target part needs, under any coupling: psi2 blocks and psi1^T mu without weights.
///
/// The dynamics of a target stack the sources in order.
#[derive(Clone, Debug, PartialEq)]
pub struct DynamicsSums {
    /// psi2^{jj} on the diagonal, psi1^{jT} psi1^k off it [sum K x sum K].
    pub psi2: DMatrix<f64>,
    /// psi1^{jT} mu_t [sum K x Q_i].
    pub psi1_mu: DMatrix<f64>,
}

/// Where blocks of these heights start when stacked; one entry more than there are blocks.
pub fn stack_offsets(sizes: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut offsets = vec![0];
    for size in sizes {
        offsets.push(offsets[offsets.len() - 1] + size);
    }
    offsets
}

impl DynamicsSums {
    /// Psi2 and b of the stacked sources under the coupling weights w: blocks w_j w_k psi2^{jk} and w_j psi1^{jT} mu.
    /// `offsets` says where each source starts in the stack, and ends with its height.
    pub fn weighted(&self, weights: &[f64], offsets: &[usize]) -> (DMatrix<f64>, DMatrix<f64>) {
        let mut out = (self.psi2.clone(), self.psi1_mu.clone());
        self.weighted_into(weights, offsets, &mut out.0, &mut out.1);
        out
    }

    /// As [`weighted`](Self::weighted), into matrices that are there.
    fn weighted_into(
        &self,
        weights: &[f64],
        offsets: &[usize],
        psi2: &mut DMatrix<f64>,
        b: &mut DMatrix<f64>,
    ) {
        for (j, w_j) in weights.iter().enumerate() {
            let (at, size) = (offsets[j], offsets[j + 1] - offsets[j]);
            for (k, w_k) in weights.iter().enumerate() {
                let (place, shape) = ((at, offsets[k]), (size, offsets[k + 1] - offsets[k]));
                psi2.view_mut(place, shape)
                    .zip_apply(&self.psi2.view(place, shape), |out, v| *out = w_j * w_k * v);
            }
            b.rows_mut(at, size).zip_apply(&self.psi1_mu.rows(at, size), |out, v| *out = w_j * v);
        }
    }
}

/// What belongs to one source of the target.
struct SourceRoom {
    k: DMatrix<f64>,
    statistics: PsiStatistics,
    /// dF/dK, dF/dpsi2 [K x K].
    k_adjoint: DMatrix<f64>,
    psi2_adjoint: DMatrix<f64>,
    /// dF/dpsi1 [R x K].
    psi1_adjoint: DMatrix<f64>,
    /// dF/db, weighted, and its transpose [K x Q], [Q x K].
    b: DMatrix<f64>,
    b_transposed: DMatrix<f64>,
    /// With every source: a block off the diagonal of the stack [K_source x K].
    cross: Vec<DMatrix<f64>>,
    kernel_adjoint: KernelAdjoint,
}

/// What the bound of the dynamics into one target is made of, with the room for it and its adjoints.
pub struct Dynamics {
    target: usize,
    noise: f64,
    weights: Vec<f64>,
    /// dF/dw.
    weights_adjoint: Vec<f64>,
    /// Where each source starts in the stack.
    offsets: Vec<usize>,
    sources: Vec<SourceRoom>,
    target_mean: DMatrix<f64>,
    target_variance: DMatrix<f64>,
    second_moment: f64,
    sums: DynamicsSums,
    k: DMatrix<f64>,
    psi2: DMatrix<f64>,
    b: DMatrix<f64>,
    psi0: f64,
    room: BoundWorkspace,
}

impl Dynamics {
    pub fn new(objective: &Objective, params: &Params, target: usize) -> Self {
        let (m, rows) = (params.part_count(), objective.sequences.transitions());
        let latent = params.parts[target].latents.mean.ncols();
        let experts = || params.experts.iter().map(|row| &row[target].z);
        let sources = experts().map(|z| {
            let (ips, dims) = z.shape();
            SourceRoom {
                k: DMatrix::zeros(ips, ips),
                statistics: PsiStatistics::new(rows, ips, dims),
                k_adjoint: DMatrix::zeros(ips, ips),
                psi2_adjoint: DMatrix::zeros(ips, ips),
                psi1_adjoint: DMatrix::zeros(rows, ips),
                b: DMatrix::zeros(ips, latent),
                b_transposed: DMatrix::zeros(latent, ips),
                cross: experts().map(|other| DMatrix::zeros(other.nrows(), ips)).collect(),
                kernel_adjoint: KernelAdjoint::zeros(ips, dims),
            }
        });
        let offsets = stack_offsets(experts().map(|z| z.nrows()));
        let total = offsets[m];
        Self {
            target,
            noise: 0.0,
            weights: vec![0.0; m],
            weights_adjoint: vec![0.0; m],
            sources: sources.collect(),
            offsets,
            target_mean: DMatrix::zeros(rows, latent),
            target_variance: DMatrix::zeros(rows, latent),
            second_moment: 0.0,
            sums: DynamicsSums { psi2: DMatrix::zeros(total, total), psi1_mu: DMatrix::zeros(total, latent) },
            k: DMatrix::zeros(total, total),
            psi2: DMatrix::zeros(total, total),
            b: DMatrix::zeros(total, latent),
            psi0: 0.0,
            room: BoundWorkspace::new(total, latent),
        }
    }

    /// The statistics of all sources, stacked and weighted. `rooms` holds one for each source.
    pub fn compute(
        &mut self,
        objective: &Objective,
        params: &Params,
        histories: &[Gaussians],
        purpose: Purpose,
        rooms: &mut [PairWorkspace],
    ) {
        let i = self.target;
        self.noise = coupling_weights_into(params.alpha.column(i).as_slice(), &mut self.weights);
        let latents = &params.parts[i].latents;
        objective.sequences.lagged_into(&latents.mean, 0, &mut self.target_mean);
        objective.sequences.lagged_into(&latents.variance, 0, &mut self.target_variance);
        self.second_moment = self.target_mean.norm_squared() + self.target_variance.sum();
        self.psi0 = 0.0;
        for j in 0..self.sources.len() {
            let (before, rest) = self.sources.split_at_mut(j);
            let (source, expert) = (&mut rest[0], &params.experts[j][i]);
            source.statistics.compute(&histories[j], &expert.z, &expert.kernel, purpose, &mut rooms[j]);
            expert.kernel.inducing_covariance_into(&expert.z, objective.jitter, &mut source.k);
            let (at, shape) = (self.offsets[j], source.k.shape());
            self.k.view_mut((at, at), shape).copy_from(&source.k);
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

    /// The bound and the room to compute it in, apart.
    fn gp(&mut self) -> (SparseGp<'_>, &mut BoundWorkspace) {
        let gp = SparseGp {
            k: &self.k,
            psi2: &self.psi2,
            b: &self.b,
            psi0: self.psi0,
            second_moment: self.second_moment,
            rows: self.target_mean.nrows(),
            noise: self.noise,
        };
        (gp, &mut self.room)
    }

    /// The bound, in nats.
    pub fn bound(&mut self) -> Result<f64, NumericsError> {
        let (gp, room) = self.gp();
        gp.bound(room)
    }

    /// q(u) of the stacked sources.
    pub fn posterior(&mut self) -> Result<InducingPosterior, NumericsError> {
        self.gp().0.posterior()
    }

    /// What q(u) is computed from.
    pub fn into_sums(self) -> DynamicsSums {
        self.sums
    }

    /// The bound, in nats; its gradient is added to `gradient` and, for the histories, to `histories_adjoint`.
    pub fn gradient(
        &mut self,
        objective: &Objective,
        params: &Params,
        histories: &[Gaussians],
        rooms: &mut [PairWorkspace],
        gradient: &mut Params,
        histories_adjoint: &mut [Gaussians],
    ) -> Result<f64, NumericsError> {
        let (i, m) = (self.target, self.sources.len());
        let (gp, room) = self.gp();
        let bound = gp.bound_and_adjoint(room)?;
        let adjoint = self.room.adjoint();
        // From here on the targets' means hold their adjoint, once every source has used them.
        for j in 0..m {
            let (at, w) = (self.offsets[j], self.weights[j]);
            let (before, rest) = self.sources.split_at_mut(j);
            let Some((source, after)) = rest.split_first_mut() else { break };
            let size = source.k.nrows();
            let b = adjoint.b.rows(at, size);
            let own = adjoint.psi2.view((at, at), (size, size));
            self.weights_adjoint[j] = b.dot(&self.sums.psi1_mu.rows(at, size))
                + 2.0 * w * own.dot(&source.statistics.psi2)
                + 2.0 * w * adjoint.psi0 * source.statistics.psi0;
            source.b.zip_apply(&b, |out, b| *out = w * b);
            source.b.transpose_to(&mut source.b_transposed);
            source.psi1_adjoint.fill(0.0);
            add_product(&self.target_mean, &source.b_transposed, &mut source.psi1_adjoint);
            for (l, other) in before.iter().enumerate().chain((j + 1..).zip(after.iter())) {
                let (to, w_other, cross) = (self.offsets[l], self.weights[l], &mut source.cross[l]);
                let block = adjoint.psi2.view((to, at), cross.shape());
                self.weights_adjoint[j] +=
                    2.0 * w_other * block.dot(&self.sums.psi2.view((to, at), cross.shape()));
                cross.zip_apply(&block, |out, v| *out = 2.0 * w * w_other * v);
                add_product(&other.statistics.psi1, cross, &mut source.psi1_adjoint);
            }
        }
        self.target_mean *= 2.0 * adjoint.second_moment;
        for (j, source) in self.sources.iter_mut().enumerate() {
            let (at, w, expert) = (self.offsets[j], self.weights[j], &params.experts[j][i]);
            let shape = source.k.shape();
            add_product(&source.statistics.psi1, &source.b, &mut self.target_mean);
            source.k_adjoint.copy_from(&adjoint.k.view((at, at), shape));
            source.psi2_adjoint.zip_apply(&adjoint.psi2.view((at, at), shape), |out, v| *out = w * w * v);
            let kernel = &mut source.kernel_adjoint;
            kernel.set_zero();
            expert.kernel.inducing_covariance_adjoint(
                &expert.z,
                &source.k,
                objective.jitter,
                &source.k_adjoint,
                kernel,
            );
            let psi = PsiAdjoint {
                psi0: w * w * adjoint.psi0,
                psi1: &source.psi1_adjoint,
                psi2: &source.psi2_adjoint,
            };
            let inputs = (&histories[j], &expert.z, &expert.kernel);
            source.statistics.pull_back(inputs, &psi, &mut rooms[j], &mut histories_adjoint[j], kernel);
            let into = &mut gradient.experts[j][i];
            kernel.add_to(&mut into.z, &mut into.kernel);
        }
        let into = &mut gradient.parts[i].latents;
        objective.sequences.add_targets_adjoint(&self.target_mean, &mut into.mean);
        self.target_variance.fill(adjoint.second_moment);
        objective.sequences.add_targets_adjoint(&self.target_variance, &mut into.variance);
        // d alpha^i / d alpha^{ji} = w_j^2 and d w_k / d alpha^{ji} = w_k w_j^2 / alpha^i - [j = k] w_j / alpha^{ji}.
        let shared: f64 = self.weights_adjoint.iter().zip(&self.weights).map(|(g, w)| g * w).sum();
        for (j, (w, g)) in self.weights.iter().zip(&self.weights_adjoint).enumerate() {
            gradient.alpha[(j, i)] +=
                w * w * (adjoint.noise + shared / self.noise) - g * w / params.alpha[(j, i)];
        }
        Ok(bound)
    }
}
