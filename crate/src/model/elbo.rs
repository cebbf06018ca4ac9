//! The evidence lower bound of the vCGPDM and its gradient (Velychko et al. 2018, appendix A).
//!
//! ELBO = sum_i kinematics_i + sum_i dynamics_i + initial + entropy. Each GP term is the collapsed bound of [`super::bound`]
//! fed with the statistics of [`super::psi`]; the gradient is the same path walked backwards.

use super::bound::{InducingPosterior, SparseGp};
use super::kernel::KernelAdjoint;
use super::params::Params;
use super::psi::{Gaussians, PsiAdjoint, PsiStatistics, Purpose, psi_adjoint, psi_statistics};
use super::sequences::Sequences;
use crate::linalg::NumericsError;
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// The terms of the bound, in nats.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BoundTerms {
    /// The pose map of each part [M].
    pub kinematics: Vec<f64>,
    /// The dynamics into each part [M].
    pub dynamics: Vec<f64>,
    /// The prior of the first p frames of every sequence.
    pub initial: f64,
    /// The entropy of q(x) over all frames.
    pub entropy: f64,
}

impl BoundTerms {
    /// The bound.
    pub fn total(&self) -> f64 {
        self.kinematics.iter().sum::<f64>() + self.dynamics.iter().sum::<f64>() + self.initial + self.entropy
    }
}

/// What the bound is computed on: centred observations and how they divide into sequences.
#[derive(Clone, Debug)]
pub struct Objective {
    y: Vec<DMatrix<f64>>,
    second_moments: Vec<f64>,
    sequences: Sequences,
    jitter: f64,
}

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

/// The optimal posteriors of all inducing outputs.
#[derive(Clone, Debug)]
pub struct Posteriors {
    /// q(v^i) [M].
    pub kinematics: Vec<InducingPosterior>,
    /// q(u) into each target, its sources stacked in order [M].
    pub dynamics: Vec<InducingPosterior>,
    /// What q(u) was computed from [M].
    pub sums: Vec<DynamicsSums>,
}

/// alpha^i = 1 / sum_j (1 / alpha^{ji}) and w_{ji} = alpha^i / alpha^{ji} for the column `alpha` of one target.
pub fn coupling_weights(alpha: &[f64]) -> (f64, Vec<f64>) {
    let combined = 1.0 / alpha.iter().map(|a| 1.0 / a).sum::<f64>();
    (combined, alpha.iter().map(|a| combined / a).collect())
}

/// The kinematics of one part, ready for the collapsed bound.
struct Kinematics {
    k: DMatrix<f64>,
    statistics: PsiStatistics,
    b: DMatrix<f64>,
}

/// The dynamics into one part, ready for the collapsed bound: sources stacked, weights applied.
struct Dynamics {
    noise: f64,
    weights: Vec<f64>,
    /// Where each source starts in the stack.
    offsets: Vec<usize>,
    k_blocks: Vec<DMatrix<f64>>,
    statistics: Vec<PsiStatistics>,
    target_mean: DMatrix<f64>,
    second_moment: f64,
    sums: DynamicsSums,
    k: DMatrix<f64>,
    psi2: DMatrix<f64>,
    b: DMatrix<f64>,
    psi0: f64,
}

impl Objective {
    /// `y[i]` are the centred observations of part i [N x D_i]; `jitter` times its signal variance is added to the diagonal of
    /// every inducing covariance. The matrices must have as many rows as the sequences have frames.
    pub fn new(y: Vec<DMatrix<f64>>, sequences: Sequences, jitter: f64) -> Self {
        let second_moments = y.iter().map(|y| y.norm_squared()).collect();
        Self { y, second_moments, sequences, jitter }
    }

    /// The sequences.
    pub fn sequences(&self) -> &Sequences {
        &self.sequences
    }

    /// The centred observations of each part [N x D_i].
    pub fn observations(&self) -> &[DMatrix<f64>] {
        &self.y
    }

    /// The factor of the signal variance on the diagonal of every inducing covariance.
    pub fn jitter(&self) -> f64 {
        self.jitter
    }

    /// The terms of the bound at `params`.
    pub fn terms(&self, params: &Params) -> Result<BoundTerms, NumericsError> {
        let histories = self.histories(params);
        let mut terms = self.free_terms(params, None);
        for i in 0..params.part_count() {
            terms.kinematics.push(self.kinematics(params, i, Purpose::Value).gp(self, params, i).bound()?);
            terms.dynamics.push(self.dynamics(params, &histories, i, Purpose::Value).gp().bound()?);
        }
        finite(terms)
    }

    /// The terms of the bound at `params` and the gradient of their sum with respect to the natural parameters.
    ///
    /// The gradient's entries for the signal variances of the dynamics kernels are given, though those are held at 1.
    pub fn terms_and_gradient(&self, params: &Params) -> Result<(BoundTerms, Params), NumericsError> {
        let mut gradient = params.zeros_like();
        let histories = self.histories(params);
        let mut histories_adjoint: Vec<Gaussians> =
            histories.iter().map(|h| Gaussians::zeros(h.mean.nrows(), h.mean.ncols())).collect();
        let mut terms = self.free_terms(params, Some(&mut gradient));
        for i in 0..params.part_count() {
            terms.kinematics.push(self.kinematics_gradient(params, i, &mut gradient)?);
            terms.dynamics.push(self.dynamics_gradient(
                params,
                &histories,
                i,
                &mut gradient,
                &mut histories_adjoint,
            )?);
        }
        for (part, adjoint) in gradient.parts.iter_mut().zip(&histories_adjoint) {
            self.sequences.add_histories_adjoint(adjoint, &mut part.latents);
        }
        Ok((finite(terms)?, gradient))
    }

    /// The optimal posteriors at `params`.
    pub fn posteriors(&self, params: &Params) -> Result<Posteriors, NumericsError> {
        let histories = self.histories(params);
        let mut out = Posteriors { kinematics: Vec::new(), dynamics: Vec::new(), sums: Vec::new() };
        for i in 0..params.part_count() {
            out.kinematics.push(self.kinematics(params, i, Purpose::Value).gp(self, params, i).posterior()?);
            let dynamics = self.dynamics(params, &histories, i, Purpose::Value);
            out.dynamics.push(dynamics.gp().posterior()?);
            out.sums.push(dynamics.sums);
        }
        Ok(out)
    }

    fn histories(&self, params: &Params) -> Vec<Gaussians> {
        params.parts.iter().map(|part| self.sequences.histories(&part.latents)).collect()
    }

    /// The terms that need no GP: the prior of the initial states and the entropy.
    fn free_terms(&self, params: &Params, mut gradient: Option<&mut Params>) -> BoundTerms {
        let (mut initial, mut entropy) = (0.0, 0.0);
        for (i, part) in params.parts.iter().enumerate() {
            let Gaussians { mean, variance } = &part.latents;
            entropy += variance.iter().map(|s| 0.5 * (TAU.ln() + 1.0 + s.ln())).sum::<f64>();
            for t in self.sequences.initial_frames() {
                for q in 0..mean.ncols() {
                    initial -= 0.5 * (TAU.ln() + mean[(t, q)].powi(2) + variance[(t, q)]);
                }
            }
            if let Some(gradient) = gradient.as_deref_mut() {
                let into = &mut gradient.parts[i].latents;
                into.variance.zip_apply(variance, |g, s| *g += 0.5 / s);
                for t in self.sequences.initial_frames() {
                    for q in 0..mean.ncols() {
                        into.mean[(t, q)] -= mean[(t, q)];
                        into.variance[(t, q)] -= 0.5;
                    }
                }
            }
        }
        BoundTerms { kinematics: Vec::new(), dynamics: Vec::new(), initial, entropy }
    }

    fn kinematics(&self, params: &Params, i: usize, purpose: Purpose) -> Kinematics {
        let part = &params.parts[i];
        let k = part.kernel.inducing_covariance(&part.r, self.jitter);
        let statistics = psi_statistics(&part.latents, &part.r, &part.kernel, purpose);
        let b = statistics.psi1.tr_mul(&self.y[i]);
        Kinematics { k, statistics, b }
    }

    fn kinematics_gradient(
        &self,
        params: &Params,
        i: usize,
        gradient: &mut Params,
    ) -> Result<f64, NumericsError> {
        let part = &params.parts[i];
        let kinematics = self.kinematics(params, i, Purpose::Gradient);
        let (bound, adjoint) = kinematics.gp(self, params, i).bound_and_adjoint()?;
        let into = &mut gradient.parts[i];
        into.beta += adjoint.noise;
        let mut kernel = KernelAdjoint::zeros(part.r.nrows(), part.r.ncols());
        part.kernel.inducing_covariance_adjoint(&part.r, &kinematics.k, self.jitter, &adjoint.k, &mut kernel);
        let psi1 = &self.y[i] * adjoint.b.transpose();
        psi_adjoint(
            &part.latents,
            &part.r,
            &part.kernel,
            &kinematics.statistics,
            &PsiAdjoint { psi0: adjoint.psi0, psi1: &psi1, psi2: &adjoint.psi2 },
            &mut into.latents,
            &mut kernel,
        );
        add_kernel_adjoint(kernel, &mut into.r, &mut into.kernel.lambda, &mut into.kernel.variance);
        Ok(bound)
    }

    fn dynamics(&self, params: &Params, histories: &[Gaussians], i: usize, purpose: Purpose) -> Dynamics {
        let m = params.part_count();
        let (noise, weights) = coupling_weights(params.alpha.column(i).as_slice());
        let statistics: Vec<PsiStatistics> = (0..m)
            .map(|j| {
                psi_statistics(&histories[j], &params.experts[j][i].z, &params.experts[j][i].kernel, purpose)
            })
            .collect();
        let k_blocks: Vec<DMatrix<f64>> = (0..m)
            .map(|j| params.experts[j][i].kernel.inducing_covariance(&params.experts[j][i].z, self.jitter))
            .collect();
        let offsets: Vec<usize> = stack_offsets(k_blocks.iter().map(|k| k.nrows()));
        let total = offsets[m];
        let target_mean = self.sequences.lagged(&params.parts[i].latents.mean, 0);
        let target_variance = self.sequences.lagged(&params.parts[i].latents.variance, 0);

        let mut sums = DynamicsSums {
            psi2: DMatrix::zeros(total, total),
            psi1_mu: DMatrix::zeros(total, target_mean.ncols()),
        };
        let mut k = DMatrix::zeros(total, total);
        let mut psi0 = 0.0;
        for j in 0..m {
            let (at, size) = (offsets[j], k_blocks[j].nrows());
            k.view_mut((at, at), (size, size)).copy_from(&k_blocks[j]);
            sums.psi2.view_mut((at, at), (size, size)).copy_from(&statistics[j].psi2);
            for l in 0..j {
                let cross = statistics[j].psi1.tr_mul(&statistics[l].psi1);
                sums.psi2.view_mut((offsets[l], at), (cross.ncols(), size)).copy_from(&cross.transpose());
                sums.psi2.view_mut((at, offsets[l]), (size, cross.ncols())).copy_from(&cross);
            }
            sums.psi1_mu.rows_mut(at, size).copy_from(&statistics[j].psi1.tr_mul(&target_mean));
            psi0 += weights[j] * weights[j] * statistics[j].psi0;
        }
        let (psi2, b) = sums.weighted(&weights, &offsets);
        let second_moment = target_mean.norm_squared() + target_variance.sum();
        Dynamics {
            noise,
            weights,
            offsets,
            k_blocks,
            statistics,
            target_mean,
            second_moment,
            sums,
            k,
            psi2,
            b,
            psi0,
        }
    }

    fn dynamics_gradient(
        &self,
        params: &Params,
        histories: &[Gaussians],
        i: usize,
        gradient: &mut Params,
        histories_adjoint: &mut [Gaussians],
    ) -> Result<f64, NumericsError> {
        let m = params.part_count();
        let d = self.dynamics(params, histories, i, Purpose::Gradient);
        let (bound, adjoint) = d.gp().bound_and_adjoint()?;
        let mut target = &d.target_mean * (2.0 * adjoint.second_moment);
        let mut weights = vec![0.0; m];
        for j in 0..m {
            let expert = &params.experts[j][i];
            let (at, size, w) = (d.offsets[j], d.k_blocks[j].nrows(), d.weights[j]);
            let b = adjoint.b.rows(at, size);
            let own = adjoint.psi2.view((at, at), (size, size));
            target += &d.statistics[j].psi1 * b * w;
            let mut psi1 = &d.target_mean * b.transpose() * w;
            weights[j] += b.dot(&d.sums.psi1_mu.rows(at, size))
                + 2.0 * w * own.dot(&d.statistics[j].psi2)
                + 2.0 * w * adjoint.psi0 * d.statistics[j].psi0;
            for l in (0..m).filter(|l| *l != j) {
                let (other, w_other) = ((d.offsets[l], d.k_blocks[l].nrows()), d.weights[l]);
                let cross = adjoint.psi2.view((other.0, at), (other.1, size));
                psi1 += &d.statistics[l].psi1 * cross * (2.0 * w * w_other);
                weights[j] += 2.0 * w_other * cross.dot(&d.sums.psi2.view((other.0, at), (other.1, size)));
            }
            let own_weighted = own * (w * w);
            let mut kernel = KernelAdjoint::zeros(size, expert.z.ncols());
            let df_dk = adjoint.k.view((at, at), (size, size)).into_owned();
            expert.kernel.inducing_covariance_adjoint(
                &expert.z,
                &d.k_blocks[j],
                self.jitter,
                &df_dk,
                &mut kernel,
            );
            psi_adjoint(
                &histories[j],
                &expert.z,
                &expert.kernel,
                &d.statistics[j],
                &PsiAdjoint { psi0: w * w * adjoint.psi0, psi1: &psi1, psi2: &own_weighted },
                &mut histories_adjoint[j],
                &mut kernel,
            );
            let into = &mut gradient.experts[j][i];
            add_kernel_adjoint(kernel, &mut into.z, &mut into.kernel.lambda, &mut into.kernel.variance);
        }
        let into = &mut gradient.parts[i].latents;
        self.sequences.add_targets_adjoint(&target, &mut into.mean);
        target.fill(adjoint.second_moment);
        self.sequences.add_targets_adjoint(&target, &mut into.variance);
        // d alpha^i / d alpha^{ji} = w_j^2 and d w_k / d alpha^{ji} = w_k w_j^2 / alpha^i - [j = k] w_j / alpha^{ji}.
        let shared: f64 = weights.iter().zip(&d.weights).map(|(g, w)| g * w).sum();
        for j in 0..m {
            let w = d.weights[j];
            gradient.alpha[(j, i)] +=
                w * w * (adjoint.noise + shared / d.noise) - weights[j] * w / params.alpha[(j, i)];
        }
        Ok(bound)
    }
}

impl Kinematics {
    fn gp<'a>(&'a self, objective: &Objective, params: &Params, i: usize) -> SparseGp<'a> {
        SparseGp {
            k: &self.k,
            psi2: &self.statistics.psi2,
            b: &self.b,
            psi0: self.statistics.psi0,
            second_moment: objective.second_moments[i],
            rows: objective.y[i].nrows(),
            noise: params.parts[i].beta,
        }
    }
}

impl Dynamics {
    fn gp(&self) -> SparseGp<'_> {
        SparseGp {
            k: &self.k,
            psi2: &self.psi2,
            b: &self.b,
            psi0: self.psi0,
            second_moment: self.second_moment,
            rows: self.target_mean.nrows(),
            noise: self.noise,
        }
    }
}

impl DynamicsSums {
    /// Psi2 and b of the stacked sources under the coupling weights w: blocks w_j w_k psi2^{jk} and w_j psi1^{jT} mu.
    /// `offsets` says where each source starts in the stack, and ends with its height.
    pub fn weighted(&self, weights: &[f64], offsets: &[usize]) -> (DMatrix<f64>, DMatrix<f64>) {
        let mut row_weights = DVector::<f64>::zeros(self.psi2.nrows());
        for (j, w) in weights.iter().enumerate() {
            row_weights.rows_mut(offsets[j], offsets[j + 1] - offsets[j]).fill(*w);
        }
        let psi2 = self.psi2.map_with_location(|a, b, v| v * row_weights[a] * row_weights[b]);
        let b = self.psi1_mu.map_with_location(|a, _, v| v * row_weights[a]);
        (psi2, b)
    }
}

/// Where blocks of these heights start when stacked; one entry more than there are blocks.
pub fn stack_offsets(sizes: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut offsets = vec![0];
    for size in sizes {
        offsets.push(offsets[offsets.len() - 1] + size);
    }
    offsets
}

fn add_kernel_adjoint(
    from: KernelAdjoint,
    ips: &mut DMatrix<f64>,
    lambda: &mut DVector<f64>,
    variance: &mut f64,
) {
    *ips += from.z;
    *lambda += from.lambda;
    *variance += from.variance;
}

fn finite(terms: BoundTerms) -> Result<BoundTerms, NumericsError> {
    if terms.total().is_finite() { Ok(terms) } else { Err(NumericsError::NotFinite { what: "bound" }) }
}

#[cfg(test)]
mod tests;
