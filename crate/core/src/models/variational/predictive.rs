//! The prediction of each expert with its uncertainty, and the product of experts (Velychko et al. 2018,
//! equations 1 and 2).

use crate::gp::exp::exp;
use crate::gp::linalg::Factor;
use crate::gp::{Kernel, NumericsError};
use crate::models::rollout::couplings::{Reading, check_couplings, coupling_weights};
use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::rollout::request::RolloutError;
use crate::models::variational::model::Vcgpdm;
use nalgebra::DMatrix;

/// A Gaussian about the next latents of a part, with the same variance in all dimensions.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Prediction {
    /// Its mean `[Q_i]`.
    pub mean: Vec<f64>,
    /// Its variance.
    pub variance: f64,
}

/// Predictions about the next latents of one part.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PartPredictions {
    /// The prediction of each source alone `[M]`: the mean of f^{ji}, and alpha^{ji} plus its own variance.
    pub experts: Vec<Prediction>,
    /// Their product under the couplings: mean sum_j w_{ji} f^{ji}, and alpha^i plus the variance of that
    /// sum.
    pub product: Prediction,
}

/// One expert, prepared for predictions.
#[derive(Clone, Debug)]
pub(super) struct ExpertFunction {
    /// Inducing inputs [K x pQ_j].
    pub(super) z: DMatrix<f64>,
    pub(super) kernel: Kernel,
    /// K^-1 `E[u]` [K x Q_i]: f(x) = k(x, z) times these.
    pub(super) coefficients: DMatrix<f64>,
}

/// All experts about one part.
#[derive(Clone, Debug)]
pub(super) struct TargetDynamics {
    /// alpha^i.
    pub(super) noise: f64,
    /// alpha^{ji} of each source `[M]`.
    alpha: Vec<f64>,
    /// w_{ji} of each source `[M]`.
    pub(super) weights: Vec<f64>,
    pub(super) experts: Vec<ExpertFunction>,
    /// K^-1 - K^-1 cov(u) K^-1, K blockwise [sum K x sum K]: the reduction of a variance of 1 by
    /// observed inducing outputs.
    pub(super) certainty: DMatrix<f64>,
    /// The place where each source starts in the stack, then its height.
    pub(super) offsets: Vec<usize>,
}

/// The dynamics of all parts under given couplings as distributions; `LatentDynamics` has only their means.
#[derive(Clone, Debug)]
pub struct PredictiveDynamics {
    pub(super) order: usize,
    /// Latent dimensions Q_i of each part.
    pub(super) latent: Vec<usize>,
    pub(super) targets: Vec<TargetDynamics>,
}

impl Vcgpdm {
    /// The dynamics with their variances, under the couplings `alpha` [M x M], row the source.
    ///
    /// # Errors
    ///
    /// When the couplings do not fit the model, or a covariance cannot be factorised.
    pub fn predictive_dynamics(
        &self,
        alpha: &DMatrix<f64>,
        reading: Reading,
    ) -> Result<PredictiveDynamics, RolloutError> {
        check_couplings(alpha, self.part_count())?;
        let mut targets = Vec::with_capacity(self.part_count());
        for target in 0..self.part_count() {
            targets.push(self.target_dynamics(target, alpha.column(target).as_slice(), reading)?);
        }
        Ok(PredictiveDynamics { order: self.order, latent: self.latent_dimensions(), targets })
    }

    fn target_dynamics(
        &self,
        target: usize,
        alpha: &[f64],
        reading: Reading,
    ) -> Result<TargetDynamics, NumericsError> {
        let (noise, weights) = coupling_weights(alpha);
        let offsets = self.offsets(target);
        let height = offsets[self.part_count()];
        let mut k = DMatrix::zeros(height, height);
        let mut stacked = DMatrix::zeros(height, self.parts[target].r().ncols());
        for (row, &at) in self.experts.iter().zip(&offsets) {
            let (block, mean) = (row[target].k(), row[target].mean());
            k.view_mut((at, at), block.shape()).copy_from(block);
            stacked.rows_mut(at, mean.nrows()).copy_from(mean);
        }
        let factor = Factor::new(&k, "covariance of the dynamics inducing points")?;
        let mut certainty = k;
        factor.inverse_into(&mut certainty);
        // cov(u) = K A^-1 K, so K^-1 - K^-1 cov(u) K^-1 = K^-1 - A^-1. As learned, A is that of the learned
        // couplings; from the sums it is more exact than from a covariance with few digits in a file.
        let inferred = match reading {
            Reading::AsLearned => {
                factor.solve_mut(&mut stacked);
                let (noise, weights) = coupling_weights(self.alpha.column(target).as_slice());
                self.infer(target, noise, &weights)?
            }
            Reading::ReInferred => {
                let inferred = self.infer(target, noise, &weights)?;
                stacked.copy_from(&inferred.coefficients);
                inferred
            }
        };
        let mut taken = DMatrix::zeros(height, height);
        inferred.factor.inverse_into(&mut taken);
        certainty -= taken;
        let experts = self.experts.iter().zip(&offsets).map(|(row, &at)| ExpertFunction {
            z: row[target].z().clone(),
            kernel: row[target].kernel().clone(),
            coefficients: stacked.rows(at, row[target].z().nrows()).into_owned(),
        });
        let experts = experts.collect();
        Ok(TargetDynamics { noise, alpha: alpha.to_vec(), weights, experts, certainty, offsets })
    }
}

impl TargetDynamics {
    /// Predictions from the histories `[p Q_j]` of all parts.
    pub(super) fn predict<'a>(&self, history: &dyn Fn(usize) -> &'a [f64]) -> PartPredictions {
        let latent = self.experts.first().map_or(0, |expert| expert.coefficients.ncols());
        let mut product = Prediction { mean: vec![0.0; latent], variance: self.noise };
        let mut experts = Vec::with_capacity(self.experts.len());
        // k(x^j, z) of all sources, weighted and stacked.
        let mut stack = Vec::with_capacity(self.certainty.nrows());
        let mut prior = 0.0;
        for (j, expert) in self.experts.iter().enumerate() {
            let (at, w) = (self.offsets[j], self.weights[j]);
            let k = expert.kernels(history(j));
            let mean: Vec<f64> = expert.coefficients.column_iter().map(|c| dot(c.as_slice(), &k)).collect();
            product.mean.iter_mut().zip(&mean).for_each(|(sum, mean)| *sum += w * mean);
            let variance = self.alpha[j] + (1.0 - self.explained(at, &k)).max(0.0);
            prior += w * w;
            stack.extend(k.iter().map(|k| w * k));
            experts.push(Prediction { mean, variance });
        }
        product.variance += (prior - self.explained(0, &stack)).max(0.0);
        PartPredictions { experts, product }
    }

    /// k^T C k, where C is the block of the certainty that begins at `at`.
    fn explained(&self, at: usize, k: &[f64]) -> f64 {
        let columns = self.certainty.column_iter().skip(at);
        k.iter().zip(columns).map(|(kb, column)| kb * dot(&column.as_slice()[at..], k)).sum()
    }
}

impl ExpertFunction {
    /// k(x, z) `[K]` at a history x `[pQ_j]`.
    fn kernels(&self, x: &[f64]) -> Vec<f64> {
        let distance = |a: usize| -> f64 {
            let dimensions = x.iter().zip(&self.kernel.lambda).enumerate();
            dimensions.map(|(q, (x, lambda))| (x - self.z[(a, q)]).powi(2) / lambda).sum()
        };
        (0..self.z.nrows()).map(|a| exp(-0.5 * distance(a))).collect()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl PredictiveDynamics {
    /// Predictions about each part in frame `t` of a latent path of all parts [frames x Q_i]; `t` is at
    /// least p.
    ///
    /// # Errors
    ///
    /// When the path has other dimensions than the model, or does not reach from frame t - p to frame t - 1.
    pub fn predict(&self, path: &[DMatrix<f64>], t: usize) -> Result<Vec<PartPredictions>, RolloutError> {
        let p = self.order;
        let first = t.checked_sub(p).ok_or(RolloutError::History { least: p, found: t })?;
        let rows = |x: &DMatrix<f64>| {
            let until = x.nrows().min(t);
            x.rows(first.min(until), until.saturating_sub(first)).into_owned()
        };
        let histories: Vec<_> = path.iter().map(rows).collect();
        Ok(self.next(&LatentPaths::new(&histories, p, &self.latent)?))
    }

    /// Predictions about each part in the frame after the last one of `paths`.
    pub(super) fn next(&self, paths: &LatentPaths) -> Vec<PartPredictions> {
        let histories: Vec<_> = (0..self.latent.len()).map(|part| paths.history(part)).collect();
        let history = |part: usize| &*histories[part];
        self.targets.iter().map(|target| target.predict(&history)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::variational::testing::fitted;
    use approx::assert_relative_eq;
    use nalgebra::DVector;

    #[test]
    fn the_mean_of_the_product_is_the_step_of_the_rollout() {
        for reading in [Reading::AsLearned, Reading::ReInferred] {
            let model = fitted(3);
            let mut alpha = model.alpha.clone();
            alpha[(1, 0)] *= 3.0;
            let path =
                model.dynamics(&alpha, reading).unwrap().path(&model.start(1, 0).unwrap(), 12).unwrap();
            let dynamics = model.predictive_dynamics(&alpha, reading).unwrap();
            for t in model.order..12 {
                for (part, predictions) in dynamics.predict(&path, t).unwrap().iter().enumerate() {
                    let taken = path[part].row(t).transpose();
                    assert_relative_eq!(
                        DVector::from_row_slice(&predictions.product.mean),
                        taken,
                        epsilon = 1e-9,
                        max_relative = 1e-8
                    );
                }
            }
        }
    }

    #[test]
    fn the_product_is_the_weighted_sum_of_the_experts() {
        let model = fitted(1);
        let dynamics = model.predictive_dynamics(&model.alpha, Reading::AsLearned).unwrap();
        let start = &model.start(0, 0).unwrap();
        for (i, predictions) in dynamics.predict(start, model.order).unwrap().iter().enumerate() {
            let (noise, weights) = coupling_weights(model.alpha.column(i).as_slice());
            for q in 0..predictions.product.mean.len() {
                let sum: f64 = predictions.experts.iter().zip(&weights).map(|(e, w)| w * e.mean[q]).sum();
                assert_relative_eq!(predictions.product.mean[q], sum, epsilon = 1e-12);
            }
            assert!(predictions.product.variance >= noise);
            for (expert, alpha) in predictions.experts.iter().zip(model.alpha.column(i).iter()) {
                assert!(expert.variance >= *alpha && expert.variance <= alpha + 1.0 + 1e-9);
            }
        }
    }

    #[test]
    fn far_from_all_inducing_points_an_expert_predicts_its_prior() {
        let model = fitted(1);
        let dynamics = model.predictive_dynamics(&model.alpha, Reading::AsLearned).unwrap();
        let far: Vec<_> = model.start(0, 0).unwrap().iter().map(|x| x.map(|_| 1e3)).collect();
        for (i, predictions) in dynamics.predict(&far, model.order).unwrap().iter().enumerate() {
            for (j, expert) in predictions.experts.iter().enumerate() {
                assert_relative_eq!(expert.variance, model.alpha[(j, i)] + 1.0, epsilon = 1e-12);
                assert!(expert.mean.iter().all(|x| x.abs() < 1e-12));
            }
        }
    }

    #[test]
    fn re_inferred_under_the_learned_couplings_the_variances_are_as_learned() {
        let model = fitted(3);
        let start = &model.start(0, 0).unwrap();
        let predictions = |reading| {
            model.predictive_dynamics(&model.alpha, reading).unwrap().predict(start, model.order).unwrap()
        };
        for (a, b) in predictions(Reading::AsLearned).iter().zip(&predictions(Reading::ReInferred)) {
            assert_relative_eq!(a.product.variance, b.product.variance, epsilon = 1e-8);
            for (a, b) in a.experts.iter().zip(&b.experts) {
                assert_relative_eq!(a.variance, b.variance, epsilon = 1e-8);
            }
        }
    }

    #[test]
    fn certainties_agree_with_the_stored_covariance() {
        let model = fitted(1);
        // Other couplings do not change what the experts have learned.
        let dynamics = model.predictive_dynamics(&(&model.alpha * 3.0), Reading::AsLearned).unwrap();
        for (target, dynamics) in dynamics.targets.iter().enumerate() {
            let height = dynamics.certainty.nrows();
            let mut k = DMatrix::zeros(height, height);
            for (row, &at) in model.experts.iter().zip(&dynamics.offsets) {
                let block = row[target].k();
                k.view_mut((at, at), block.shape()).copy_from(block);
            }
            let covariance = &k - &k * &dynamics.certainty * &k;
            let stored = &model.dynamics_covariance[target];
            assert_relative_eq!(&covariance, stored, epsilon = 1e-8, max_relative = 1e-6);
        }
    }

    #[test]
    fn refuses_a_frame_without_a_history() {
        let model = fitted(1);
        let dynamics = model.predictive_dynamics(&model.alpha, Reading::AsLearned).unwrap();
        let start = &model.start(0, 0).unwrap();
        assert_eq!(
            dynamics.predict(start, 1).unwrap_err().to_string(),
            "expected at least 2 frames before the predicted one, found 1"
        );
        assert!(dynamics.predict(start, 3).is_err());
    }
}
