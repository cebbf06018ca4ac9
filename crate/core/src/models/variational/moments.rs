//! Moment matching: the distribution of the latents in every frame of a rollout, as a Gaussian with a full
//! covariance over all parts (Velychko et al. 2018, appendix B).

use crate::gp::NumericsError;
use crate::gp::moments::{Basis, expected_kernels, expected_products};
use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::rollout::request::RolloutError;
use crate::models::variational::predictive::{ExpertFunction, PredictiveDynamics};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;

/// Means and covariances of the latents of all parts over time.
#[derive(Clone, Debug)]
pub struct LatentMoments {
    /// Means [frames x Q_i] of each part.
    pub means: Vec<DMatrix<f64>>,
    /// Covariances [Q_i x Q_i] of each part, frame by frame: `covariances[part][frame]`.
    pub covariances: Vec<Vec<DMatrix<f64>>>,
}

/// A Gaussian about the last p latents of all parts, the history of the next frame.
#[derive(Clone, Debug)]
pub struct Belief {
    /// The mean `[sum p Q_i]`, part by part, oldest frame first.
    pub mean: DVector<f64>,
    /// The covariance [sum p Q_i x sum p Q_i].
    pub covariance: DMatrix<f64>,
}

impl PredictiveDynamics {
    /// The moments of the latents from a certain `start` [frames x Q_i] of each part on. A step is exact for a
    /// Gaussian history; its result is replaced by a Gaussian with the same mean and covariance. The cost of
    /// a frame grows with the pairs of dynamics inducing points of all experts.
    ///
    /// # Errors
    ///
    /// When the start latents are not p or more frames of Q_i numbers for each part, or a covariance cannot be
    /// factorised.
    pub fn moments(&self, start: &[DMatrix<f64>], frames: usize) -> Result<LatentMoments, RolloutError> {
        let paths = LatentPaths::new(start, self.order, &self.latent)?;
        let mut means: Vec<Vec<f64>> = Vec::new();
        let mut covariances: Vec<Vec<DMatrix<f64>>> = Vec::new();
        let given = frames.min(paths.frames());
        for (start, &q) in paths.matrices(0..given).iter().zip(&self.latent) {
            means.push(start.transpose().as_slice().to_vec());
            covariances.push(vec![DMatrix::zeros(q, q); given]);
        }
        let history: Vec<f64> =
            (0..self.latent.len()).flat_map(|part| paths.history(part).to_vec()).collect();
        let size = history.len();
        let mut belief = Belief { mean: DVector::from_vec(history), covariance: DMatrix::zeros(size, size) };
        for _ in paths.frames()..frames {
            belief = self.advanced(&self.joint(&belief)?);
            for (part, &q) in self.latent.iter().enumerate() {
                let newest = self.inputs(part).end - q;
                means[part].extend(belief.mean.rows(newest, q).iter());
                covariances[part].push(belief.covariance.view((newest, newest), (q, q)).into_owned());
            }
        }
        let means = means.iter().zip(&self.latent);
        let means = means.map(|(mean, &q)| DMatrix::from_row_slice(mean.len() / q.max(1), q, mean)).collect();
        Ok(LatentMoments { means, covariances })
    }

    /// The Gaussian about a history and, after it, the next latents of all parts `[Q_i]`, part by part.
    pub(super) fn joint(&self, belief: &Belief) -> Result<Belief, NumericsError> {
        let (m, width) = (self.latent.len(), self.latent.iter().sum::<usize>());
        let size = belief.mean.len();
        // The history, then the next latents of all parts.
        let mut mean = belief.mean.clone().resize_vertically(size + width, 0.0);
        let mut covariance = belief.covariance.clone().resize(size + width, size + width, 0.0);
        let next: Vec<usize> = (0..m).map(|i| size + self.latent[..i].iter().sum::<usize>()).collect();
        for (i, target) in self.targets.iter().enumerate() {
            for (j, expert) in target.experts.iter().enumerate() {
                let inputs = self.inputs(j);
                let spread = select(&belief.covariance, &inputs.clone().collect::<Vec<_>>());
                let input = belief.mean.rows(inputs.start, inputs.len()).into_owned();
                let expected = expected_kernels(expert.basis(), &input, &spread)?;
                for q in 0..self.latent[i] {
                    // psi1 times K^-1 E[u]; along the pulls this is the slope of the expert.
                    let mut terms = expert.coefficients.column(q).component_mul(&expected.psi1);
                    terms *= target.weights[j];
                    let column = next[i] + q;
                    mean[column] += terms.sum();
                    for (slope, row) in expected.pulls.row_iter().zip(inputs.clone()) {
                        let slope: f64 = slope.iter().zip(terms.iter()).map(|(a, b)| a * b).sum();
                        for h in 0..size {
                            covariance[(h, column)] += belief.covariance[(h, row)] * slope;
                        }
                    }
                }
            }
        }
        for i in 0..m {
            for other in i..m {
                let second = self.second_moment(belief, i, other)?;
                for (q, r) in (0..self.latent[i]).flat_map(|q| (0..self.latent[other]).map(move |r| (q, r))) {
                    let (row, column) = (next[i] + q, next[other] + r);
                    covariance[(row, column)] = second[(q, r)] - mean[row] * mean[column];
                }
            }
        }
        covariance.fill_lower_triangle_with_upper_triangle();
        // Rounding can make a variance negative.
        for k in size..size + width {
            covariance[(k, k)] = covariance[(k, k)].max(0.0);
        }
        Ok(Belief { mean, covariance })
    }

    /// The history of the next frame in the [`joint`](Self::joint) Gaussian.
    pub(super) fn advanced(&self, joint: &Belief) -> Belief {
        let places = self.advanced_places();
        let mean = DVector::from_fn(places.len(), |k, _| joint.mean[places[k]]);
        Belief { mean, covariance: select(&joint.covariance, &places) }
    }

    /// The places of the next history among those of a history and the next latents: the next frame of each
    /// part replaces its oldest one.
    pub(super) fn advanced_places(&self) -> Vec<usize> {
        let mut next = self.latent.iter().sum::<usize>() * self.order;
        let mut places = Vec::with_capacity(next);
        for (i, &q) in self.latent.iter().enumerate() {
            let inputs = self.inputs(i);
            places.extend(inputs.start + q..inputs.end);
            places.extend(next..next + q);
            next += q;
        }
        places
    }

    /// `E[x x'^T]` [Q_i x Q_i'] of the next latents of the parts i and i'.
    fn second_moment(&self, belief: &Belief, i: usize, other: usize) -> Result<DMatrix<f64>, NumericsError> {
        let (target, other_target) = (&self.targets[i], &self.targets[other]);
        let mut second = DMatrix::zeros(self.latent[i], self.latent[other]);
        // The variance of the functions, and of the noise around them, is the part's own.
        let mut variance = target.noise + target.weights.iter().map(|w| w * w).sum::<f64>();
        for (j, a) in target.experts.iter().enumerate() {
            // Of two experts about the same part, the products in one order are those in the other.
            let first = if i == other { j } else { 0 };
            for (l, b) in other_target.experts.iter().enumerate().skip(first) {
                let places: Vec<usize> = self.inputs(j).chain(self.inputs(l)).collect();
                let mean =
                    |part| belief.mean.rows(self.inputs(part).start, self.inputs(part).len()).into_owned();
                let (first, last) = ((a.basis(), &mean(j)), (b.basis(), &mean(l)));
                let mut products = expected_products(first, last, &select(&belief.covariance, &places))?;
                products *= target.weights[j] * other_target.weights[l];
                for (q, r) in (0..self.latent[i]).flat_map(|q| (0..self.latent[other]).map(move |r| (q, r))) {
                    let (a, b) = (a.coefficients.column(q), b.coefficients.column(r));
                    let columns = products.column_iter().zip(b.iter());
                    let product = columns.map(|(column, b)| b * column.dot(&a)).sum::<f64>();
                    second[(q, r)] += product;
                    if i == other && j != l {
                        second[(r, q)] += product;
                    }
                }
                if i == other {
                    let place = (target.offsets[j], target.offsets[l]);
                    let explained = target.certainty.view(place, products.shape()).dot(&products);
                    variance -= if j == l { explained } else { 2.0 * explained };
                }
            }
        }
        if i == other {
            for q in 0..self.latent[i] {
                second[(q, q)] += variance.max(0.0);
            }
        }
        Ok(second)
    }

    /// The place of the history of a part among those of all parts.
    pub(super) fn inputs(&self, part: usize) -> Range<usize> {
        let begin = self.latent[..part].iter().sum::<usize>() * self.order;
        begin..begin + self.latent[part] * self.order
    }
}

/// The rows and columns of a symmetric matrix at these places.
pub(super) fn select(matrix: &DMatrix<f64>, places: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(places.len(), places.len(), |row, column| matrix[(places[row], places[column])])
}

impl ExpertFunction {
    fn basis(&self) -> Basis<'_> {
        Basis { z: &self.z, kernel: &self.kernel }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::Reading;
    use crate::models::variational::testing::fitted;
    use approx::assert_relative_eq;

    /// Compares the moments with the means and variances of `draws` sampled futures: means within `shift`
    /// standard deviations, standard deviations within a factor 1 + `factor`, both plus four standard errors.
    fn assert_moments_agree(seed: u64, frames: usize, draws: u64, (shift, factor): (f64, f64)) {
        let model = fitted(seed);
        let dynamics = model.predictive_dynamics(&model.alpha, Reading::AsLearned).unwrap();
        let start = &model.start(0, 0).unwrap();
        let moments = dynamics.moments(start, frames).unwrap();
        let futures: Vec<_> = (0..draws).map(|seed| dynamics.sample(start, frames, seed).unwrap()).collect();
        let count = draws as f64;
        for (part, means) in moments.means.iter().enumerate() {
            for t in model.order..frames {
                for q in 0..means.ncols() {
                    let values: Vec<f64> = futures.iter().map(|future| future[part][(t, q)]).collect();
                    let mean = values.iter().sum::<f64>() / count;
                    let variance = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / count;
                    let expected = moments.covariances[part][t][(q, q)];
                    let apart = (mean - means[(t, q)]).abs() / expected.sqrt();
                    let ratio = (variance / expected).sqrt();
                    let found = format!("model {seed}, part {part}, frame {t}, {q}: {apart} {ratio}");
                    assert!(apart < shift + 4.0 / count.sqrt(), "{found}");
                    assert!((ratio - 1.0).abs() < factor + 4.0 * (0.5 / count).sqrt(), "{found}");
                }
            }
        }
    }

    #[test]
    fn agree_with_many_futures_after_two_steps() {
        for seed in [1, 2, 3] {
            let frames = fitted(seed).order + 2;
            assert_moments_agree(seed, frames, 20_000, (0.0, 0.0));
        }
    }

    #[test]
    fn agree_with_many_futures_for_sixty_frames_of_a_nearly_gaussian_model() {
        for seed in [1, 2, 3] {
            assert_moments_agree(seed, 60, 2000, (0.03, 0.03));
        }
    }

    #[test]
    fn agree_with_the_prediction_after_one_step() {
        let model = fitted(3);
        let dynamics = model.predictive_dynamics(&model.alpha, Reading::ReInferred).unwrap();
        let start = &model.start(1, 0).unwrap();
        let t = model.order;
        let moments = dynamics.moments(start, t + 1).unwrap();
        for (part, predictions) in dynamics.predict(start, t).unwrap().iter().enumerate() {
            let mean = DVector::from_row_slice(&predictions.product.mean);
            assert_relative_eq!(moments.means[part].row(t).transpose(), mean, epsilon = 1e-9);
            for q in 0..mean.len() {
                let variance = moments.covariances[part][t][(q, q)];
                assert_relative_eq!(variance, predictions.product.variance, epsilon = 1e-8);
            }
            assert!(moments.covariances[part][t - 1].iter().all(|v| *v == 0.0));
        }
    }
}
