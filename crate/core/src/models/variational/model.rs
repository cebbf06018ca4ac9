//! The fitted model, for rollouts, plots and files, without its training data.

use crate::gp::linalg::Factor;
use crate::gp::{KernelSum, NumericsError};
use crate::models::rollout::couplings::{Reading, check_couplings, coupling_weights};
use crate::models::rollout::latent_dynamics::LatentDynamics;
use crate::models::rollout::request::{Handles, RolloutError, RolloutRequest, check_frames};
use crate::models::training::kind::ModelKind;
use crate::models::training::progress::BoundTerms;
use crate::models::variational::elbo::{DynamicsSums, Objective, stack_offsets};
use crate::models::variational::maps::{FittedExpert, FittedMaps, PoseMap};
use crate::models::variational::params::Params;
use nalgebra::DMatrix;

/// Information that the experts about one target have from other data sets, such as other movements with the
/// same primitives. The sources are stacked in order.
#[derive(Clone, Debug, PartialEq)]
pub struct ExternalEvidence {
    /// Term of the precision A - K of the inducing outputs [sum K x sum K].
    pub precision: DMatrix<f64>,
    /// Term of b / n [sum K x Q_i].
    pub b: DMatrix<f64>,
}

/// The posterior of the inducing outputs u of all experts about one target, stacked.
pub(in crate::models) struct Inferred {
    /// A = K + Psi2 / n.
    pub(in crate::models) factor: Factor,
    /// K^-1 `E[u]` = A^-1 b / n [sum K x Q_i].
    pub(super) coefficients: DMatrix<f64>,
    /// The place where each source starts in the stack, then its height.
    pub(super) offsets: Vec<usize>,
}

/// A fitted vCGPDM (or, of one part, vGPDM), without the data it was trained on.
#[derive(Clone, Debug, PartialEq)]
pub struct Vcgpdm {
    /// Order p of the dynamics.
    pub order: usize,
    /// The factor of the signal variance on the diagonal of every inducing covariance.
    pub jitter: f64,
    /// The pose map of each part `[M]`.
    pub parts: Vec<PoseMap>,
    /// Experts by source and target: `experts[j][i]` is j's prediction about i.
    pub experts: Vec<Vec<FittedExpert>>,
    /// Covariance of every column of u into each target, its sources stacked in order `[M]`.
    pub dynamics_covariance: Vec<DMatrix<f64>>,
    /// The sums from which the experts into each target can be inferred again under other couplings `[M]`.
    pub sums: Vec<DynamicsSums>,
    /// Information of the experts into each target from other data sets `[M]`; empty without any.
    pub external: Vec<ExternalEvidence>,
    /// Learned coupling variances [M x M], row the source, column the target.
    pub alpha: DMatrix<f64>,
    /// The latent means of the first frames of every training sequence, p or more: `starts[sequence][part]`
    /// [T x Q_i]. A training stores all frames; older files have p.
    pub starts: Vec<Vec<DMatrix<f64>>>,
    /// The terms of the bound that training reached, in nats.
    pub terms: BoundTerms,
}

impl Vcgpdm {
    /// The model with the optimal posteriors at `params`, where the bound of one movement has these `terms`.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn at_optimum(
        objective: &Objective,
        params: &Params,
        terms: BoundTerms,
    ) -> Result<Self, NumericsError> {
        let posteriors = objective.posteriors(params)?;
        let (order, jitter) = (objective.sequences().order(), objective.jitter());
        let FittedMaps { parts, experts } = FittedMaps::new(params, &posteriors, objective)?;
        let starts = objective.sequences().ranges().map(|range| params.latent_means(&range));
        Ok(Self {
            order,
            jitter,
            parts,
            experts,
            starts: starts.collect(),
            dynamics_covariance: posteriors.dynamics.into_iter().map(|u| u.covariance).collect(),
            sums: posteriors.sums.into_iter().next().unwrap_or_default(),
            external: Vec::new(),
            alpha: params.alpha.first().cloned().unwrap_or_default(),
            terms,
        })
    }

    /// Number of parts M.
    pub fn part_count(&self) -> usize {
        self.parts.len()
    }

    /// Latent dimensions Q of each part `[M]`.
    pub fn latent_dimensions(&self) -> Vec<usize> {
        self.parts.iter().map(|part| part.r().ncols()).collect()
    }

    /// The kind of model: a vCGPDM, or a vGPDM if it has one part.
    pub fn kind(&self) -> ModelKind {
        if self.part_count() == 1 { ModelKind::Vgpdm } else { ModelKind::Vcgpdm }
    }

    /// The bound on the log evidence that training reached, in nats.
    pub fn bound(&self) -> f64 {
        self.terms.total()
    }

    /// From how many frames of a training sequence, counted from 0, a rollout can start; 0 where there is no
    /// such sequence.
    pub fn start_frames(&self, sequence: usize) -> usize {
        let stored = self.starts.get(sequence).and_then(|start| start.first()).map_or(0, DMatrix::nrows);
        (stored + 1).saturating_sub(self.order)
    }

    /// The latent means of p frames of a training sequence from `frame` on, both counted from 0: [p x Q_i] of
    /// each part.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the model does not have these frames.
    pub fn start(&self, sequence: usize, frame: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        let Some(stored) = self.starts.get(sequence) else {
            return Err(RolloutError::Sequence { count: self.starts.len(), found: sequence });
        };
        let frames = self.start_frames(sequence);
        if frame >= frames {
            return Err(RolloutError::StartFrame { most: frames.saturating_sub(1), found: frame });
        }
        Ok(stored.iter().map(|x| x.rows(frame, self.order).into_owned()).collect())
    }

    /// The latents [frames x Q_i] of each part that the rollout of a request starts with: p frames of a training
    /// sequence, or the start latents of the request.
    ///
    /// # Errors
    ///
    /// As [`start`](Self::start), and when the request has two starts, or start latents of other parts.
    pub fn start_of(&self, request: &RolloutRequest) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        if request.handles != Handles::default() {
            return Err(RolloutError::Handles { found: self.kind().id() });
        }
        let (sequence, frame) = (request.sequence, request.frame);
        let Some(given) = &request.start else { return self.start(sequence, frame) };
        if sequence > 0 || frame > 0 {
            return Err(RolloutError::TwoStarts { sequence, frame });
        }
        if given.len() != self.part_count() {
            return Err(RolloutError::StartParts { expected: self.part_count(), found: given.len() });
        }
        Ok(given.clone())
    }

    /// The mean dynamics under the couplings `alpha` [M x M], row the source, column the target. As learned,
    /// only the weights of the experts depend on the couplings; re-inferred, the experts into every part are
    /// solved for again.
    ///
    /// # Errors
    ///
    /// When the couplings do not fit the model, or a covariance cannot be factorised.
    pub fn dynamics(&self, alpha: &DMatrix<f64>, reading: Reading) -> Result<LatentDynamics, RolloutError> {
        let m = self.part_count();
        check_couplings(alpha, m)?;
        let mut experts = Vec::with_capacity(m);
        for target in 0..m {
            let (noise, weights) = coupling_weights(alpha.column(target).as_slice());
            experts.push(match reading {
                Reading::AsLearned => self.reweighted(target, &weights),
                Reading::ReInferred => self.re_inferred(target, noise, &weights)?,
            });
        }
        Ok(LatentDynamics::new(self.order, self.latent_dimensions(), experts))
    }

    /// w_j f^{ji} of every source j about the target i.
    fn reweighted(&self, i: usize, weights: &[f64]) -> Vec<KernelSum> {
        self.experts.iter().zip(weights).map(|(row, w)| row[i].sum().weighted(*w)).collect()
    }

    /// w_j f^{ji} of every source j about the target i, inferred from the same data under weights w and noise
    /// variance alpha^i.
    fn re_inferred(&self, i: usize, noise: f64, weights: &[f64]) -> Result<Vec<KernelSum>, NumericsError> {
        let inferred = self.infer(i, noise, weights)?;
        let sources = self.experts.iter().zip(weights).zip(&inferred.offsets);
        let sums = sources.map(|((row, w), offset)| {
            let expert = &row[i];
            let coefficients = inferred.coefficients.rows(*offset, expert.k().nrows()) * *w;
            KernelSum::new(expert.z(), expert.kernel(), &coefficients)
        });
        Ok(sums.collect())
    }

    /// The place where each source starts in the stack of the sources into the target i, then its height.
    pub(super) fn offsets(&self, i: usize) -> Vec<usize> {
        stack_offsets(self.experts.iter().map(|row| row[i].k().nrows()))
    }

    /// The inducing outputs of all experts about the target i, inferred again under weights w and noise
    /// variance alpha^i: the mean of (A36), Velychko et al. 2018.
    pub(in crate::models) fn infer(
        &self,
        i: usize,
        noise: f64,
        weights: &[f64],
    ) -> Result<Inferred, NumericsError> {
        let offsets = self.offsets(i);
        let (psi2, b) = self.sums[i].weighted(weights, &offsets);
        let mut a = psi2 / noise;
        for (row, offset) in self.experts.iter().zip(&offsets) {
            let k = row[i].k();
            let mut block = a.view_mut((*offset, *offset), k.shape());
            block += k;
        }
        let external = self.external.get(i);
        if let Some(external) = external {
            a += &external.precision;
        }
        let factor = Factor::new(&a, "covariance of the data at the dynamics inducing points")?;
        let mut coefficients = factor.solve(&b) / noise;
        if let Some(external) = external {
            coefficients += factor.solve(&external.b);
        }
        Ok(Inferred { factor, coefficients, offsets })
    }

    /// Centred columns of each part [frames x D_i] at the latents of each part [frames x Q_i].
    pub fn observations(&self, latents: &[DMatrix<f64>]) -> Vec<DMatrix<f64>> {
        self.parts.iter().zip(latents).map(|(part, x)| part.observations(x)).collect()
    }

    /// Centred columns of each part [frames x D_i] under the learned couplings, starting as the training
    /// sequence `sequence` starts.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the number of frames is 0 or too large.
    pub fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        check_frames(frames)?;
        let dynamics = self.dynamics(&self.alpha, Reading::AsLearned)?;
        Ok(self.observations(&dynamics.path(&self.start(sequence, 0)?, frames)?))
    }

    /// Count of numbers needed for a rollout from one sequence: inducing inputs, posterior means and
    /// kernels of all maps, couplings, and one start.
    pub fn stored_numbers(&self) -> usize {
        let poses = self.parts.iter().map(PoseMap::stored_numbers);
        let experts = self.experts.iter().flatten().map(FittedExpert::stored_numbers);
        let start = self.latent_dimensions().into_iter().map(|q| self.order * q);
        poses.sum::<usize>() + experts.sum::<usize>() + self.alpha.len() + start.sum::<usize>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::variational::testing::{fitted, random_case};
    use approx::assert_relative_eq;

    #[test]
    fn re_inferred_under_the_learned_couplings_is_as_learned() {
        let model = fitted(3);
        let path = |alpha: &DMatrix<f64>, reading| {
            model.dynamics(alpha, reading).unwrap().path(&model.start(1, 0).unwrap(), 30).unwrap()
        };
        for (a, b) in
            path(&model.alpha, Reading::AsLearned).iter().zip(&path(&model.alpha, Reading::ReInferred))
        {
            assert_relative_eq!(a, b, epsilon = 1e-9);
        }
        let mut other = model.alpha.clone();
        other[(1, 0)] *= 5.0;
        let (learned, inferred) = (path(&other, Reading::AsLearned), path(&other, Reading::ReInferred));
        assert!((&learned[0] - &inferred[0]).amax() > 1e-6);
    }

    #[test]
    fn re_inferred_agrees_with_a_fit_under_the_other_couplings() {
        let (mut params, objective) = random_case(1);
        let model = fitted(1);
        params.alpha[0][(0, 1)] *= 7.0;
        params.alpha[0][(1, 1)] *= 0.3;
        let terms = objective.terms(&params).unwrap();
        let refitted = Vcgpdm::at_optimum(&objective, &params, terms).unwrap();
        let step = |model: &Vcgpdm, reading| {
            let dynamics = model.dynamics(&params.alpha[0], reading).unwrap();
            dynamics.path(&model.start(0, 0).unwrap(), model.order + 1).unwrap()
        };
        for (a, b) in step(&model, Reading::ReInferred).iter().zip(&step(&refitted, Reading::AsLearned)) {
            assert_relative_eq!(a, b, epsilon = 1e-8, max_relative = 1e-8);
        }
    }

    #[test]
    fn a_rollout_starts_from_any_stored_frame() {
        let (params, objective) = random_case(1);
        let model = fitted(1);
        let ranges: Vec<_> = objective.sequences().ranges().collect();
        for (sequence, range) in ranges.iter().enumerate() {
            let frames = range.len() + 1 - model.order;
            assert_eq!(model.start_frames(sequence), frames);
            for frame in [0, frames - 1] {
                let request = RolloutRequest { frames: 9, sequence, frame, ..RolloutRequest::default() };
                for (path, part) in model.path(&request).unwrap().iter().zip(&params.parts) {
                    let trained = part.latents.mean.rows(range.start + frame, model.order);
                    assert_eq!(path.rows(0, model.order), trained);
                }
            }
            let error = model.start(sequence, frames).unwrap_err().to_string();
            let most = frames - 1;
            assert_eq!(
                error,
                format!("expected a frame of the sequence from 0 to {most} to start from, found {frames}")
            );
        }
        assert_eq!(model.start_frames(ranges.len()), 0);
    }

    #[test]
    fn refuses_bad_requests() {
        let model = fitted(1);
        let mut alpha = model.alpha.clone();
        alpha[(0, 1)] = -1.0;
        let error = model.dynamics(&alpha, Reading::AsLearned).unwrap_err().to_string();
        assert_eq!(
            error,
            "expected a positive coupling variance from part 0 to part 1, 1e-100 to 1e100, found -1.0"
        );
        let error = model.start(9, 0).unwrap_err().to_string();
        assert_eq!(error, "expected a training sequence from 0 to 1, found 9");
        let dynamics = model.dynamics(&model.alpha, Reading::AsLearned).unwrap();
        assert!(dynamics.path(&[], 10).is_err());
    }
}
