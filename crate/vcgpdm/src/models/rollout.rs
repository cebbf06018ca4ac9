//! Mean rollouts: latents and poses from a fitted model, couplings passed in.
//!
//! f^{ji}(x) = k(x, z^{ji}) K_zz^-1 E[u^{ji}]; x^i_t = sum_j w_{ji} f^{ji}(x^j_{-t}), all parts advancing together;
//! y^i_t = k(x^i_t, r^i) K_rr^-1 E[v^i] (Velychko et al. 2018, section 3.3 and appendix B).

use crate::gp::exp::exp;
use crate::gp::{Kernel, NumericsError};
use crate::models::variational::{FittedModel, Reading};
use crate::motion::pose::PoseError;
use nalgebra::DMatrix;
use thiserror::Error;

/// More frames than this would not be a motion but an accident.
pub const MOST_FRAMES: usize = 1_000_000;

/// Why a rollout could not be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RolloutError {
    /// The couplings do not fit the model.
    #[error("expected coupling variances for {parts} x {parts} parts, found {rows} x {columns}")]
    AlphaShape {
        /// M.
        parts: usize,
        /// Rows found.
        rows: usize,
        /// Columns found.
        columns: usize,
    },
    /// A coupling is not a variance.
    #[error(
        "expected a positive coupling variance from part {source_part} to part {target}, 1e-100 to 1e100, found {value:?}"
    )]
    Alpha {
        /// The source part, counted from 0.
        source_part: usize,
        /// The target part, counted from 0.
        target: usize,
        /// What stands there.
        value: f64,
    },
    /// There is no such training sequence.
    #[error("expected a training sequence from 0 to {}, found {found}", count - 1)]
    Sequence {
        /// How many there are.
        count: usize,
        /// The one asked for.
        found: usize,
    },
    /// Too many frames, or none.
    #[error("expected from 1 to {most} frames, found {found}")]
    Frames {
        /// The most there can be.
        most: usize,
        /// The number asked for.
        found: usize,
    },
    /// The start latents do not fit the model.
    #[error(
        "the start latents of part {part} must be {rows} x {columns} numbers, found {found_rows} x {found_columns}"
    )]
    Start {
        /// Counted from 0.
        part: usize,
        /// p.
        rows: usize,
        /// Q.
        columns: usize,
        /// Rows found.
        found_rows: usize,
        /// Columns found.
        found_columns: usize,
    },
    /// The columns cannot be turned into poses.
    #[error(transparent)]
    Pose(#[from] PoseError),
    /// A covariance could not be factorised.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

/// A weighted sum of kernels, ready to be evaluated often: f(x) = sum_a k(x, z_a) c_a.
#[derive(Clone, Debug)]
pub(crate) struct KernelSum {
    /// Inducing inputs divided by the lengthscales, one after the other [K x P].
    scaled: Vec<f64>,
    inverse_lengthscales: Vec<f64>,
    /// Coefficients times the signal variance, one inducing input after the other [K x C].
    coefficients: Vec<f64>,
    outputs: usize,
}

impl KernelSum {
    /// Inputs `z` [K x P], `coefficients` [K x C].
    pub fn new(z: &DMatrix<f64>, kernel: &Kernel, coefficients: &DMatrix<f64>) -> Self {
        let inverse_lengthscales: Vec<f64> = kernel.lambda.iter().map(|l| 1.0 / l.sqrt()).collect();
        let scaled = z
            .row_iter()
            .flat_map(|row| row.iter().zip(&inverse_lengthscales).map(|(z, i)| z * i).collect::<Vec<_>>());
        let scaled = scaled.collect();
        let values = coefficients.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>());
        let coefficients_flat = values.map(|c| c * kernel.variance).collect();
        Self { scaled, inverse_lengthscales, coefficients: coefficients_flat, outputs: coefficients.ncols() }
    }

    /// Adds f(x) to `out`; `scratch` holds at least P numbers.
    fn add_to(&self, x: &[f64], scratch: &mut [f64], out: &mut [f64]) {
        let dims = self.inverse_lengthscales.len();
        let scratch = &mut scratch[..dims];
        for ((s, x), i) in scratch.iter_mut().zip(x).zip(&self.inverse_lengthscales) {
            *s = x * i;
        }
        for (z, c) in self.scaled.chunks_exact(dims).zip(self.coefficients.chunks_exact(self.outputs)) {
            let d2: f64 = z.iter().zip(scratch.iter()).map(|(z, x)| (x - z) * (x - z)).sum();
            let k = exp(-0.5 * d2);
            for (out, c) in out.iter_mut().zip(c) {
                *out += k * c;
            }
        }
    }
}

/// A fitted model under given couplings, ready to roll out.
#[derive(Clone, Debug)]
pub struct Roller {
    order: usize,
    latent: Vec<usize>,
    /// `dynamics[target][source]`.
    dynamics: Vec<Vec<KernelSum>>,
}

/// The pose maps of a fitted model, ready to be evaluated often. They do not depend on the couplings.
#[derive(Clone, Debug)]
pub struct Poser {
    maps: Vec<KernelSum>,
}

/// Checks that so many frames can be rolled out.
pub fn check_frames(frames: usize) -> Result<(), RolloutError> {
    if (1..=MOST_FRAMES).contains(&frames) {
        return Ok(());
    }
    Err(RolloutError::Frames { most: MOST_FRAMES, found: frames })
}

/// Checks that `alpha` holds a positive coupling variance for each pair of `m` parts.
pub fn check_couplings(alpha: &DMatrix<f64>, m: usize) -> Result<(), RolloutError> {
    if alpha.shape() != (m, m) {
        return Err(RolloutError::AlphaShape { parts: m, rows: alpha.nrows(), columns: alpha.ncols() });
    }
    for target in 0..m {
        for source_part in 0..m {
            let value = alpha[(source_part, target)];
            // The ends keep 1 / alpha and its sums away from infinities.
            if !(1e-100..=1e100).contains(&value) {
                return Err(RolloutError::Alpha { source_part, target, value });
            }
        }
    }
    Ok(())
}

impl Roller {
    /// `alpha` [M x M] replaces the learned couplings.
    pub fn new(model: &FittedModel, alpha: &DMatrix<f64>, reading: Reading) -> Result<Self, RolloutError> {
        let m = model.part_count();
        check_couplings(alpha, m)?;
        let dynamics = (0..m).map(|i| {
            let coefficients = model.dynamics_coefficients(i, alpha, reading)?;
            let experts = model.experts.iter().zip(&coefficients);
            Ok(experts.map(|(row, c)| KernelSum::new(&row[i].z, &row[i].kernel, c)).collect())
        });
        Ok(Self {
            order: model.order,
            latent: model.parts.iter().map(|p| p.r.ncols()).collect(),
            dynamics: dynamics.collect::<Result<_, NumericsError>>()?,
        })
    }

    /// Of dynamics that are sums of kernels, `dynamics[target][source]`; `latent` dimensions of each part.
    pub(crate) fn of_sums(order: usize, latent: Vec<usize>, dynamics: Vec<Vec<KernelSum>>) -> Self {
        Self { order, latent, dynamics }
    }

    /// The latent path of every part [frames x Q]: the `start` [p x Q] of each part, then the mean dynamics.
    pub fn latents(&self, start: &[DMatrix<f64>], frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        let p = self.order;
        for (part, &columns) in self.latent.iter().enumerate() {
            let (found_rows, found_columns) = start.get(part).map_or((0, 0), |s| s.shape());
            if (found_rows, found_columns) != (p, columns) {
                return Err(RolloutError::Start { part, rows: p, columns, found_rows, found_columns });
            }
        }
        // One row after the other, so that a history is a slice.
        let mut paths: Vec<Vec<f64>> = Vec::new();
        for (start, q) in start.iter().zip(&self.latent) {
            let mut path = vec![0.0; frames.max(p) * q];
            for (k, value) in path[..p * q].iter_mut().enumerate() {
                *value = start[(k / q, k % q)];
            }
            paths.push(path);
        }
        let widest = self.latent.iter().max().copied().unwrap_or(0);
        let mut scratch = vec![0.0; p * widest];
        let mut next = vec![0.0; widest];
        for t in p..frames {
            for (i, &q) in self.latent.iter().enumerate() {
                let next = &mut next[..q];
                next.fill(0.0);
                for (j, sum) in self.dynamics[i].iter().enumerate() {
                    let qj = self.latent[j];
                    sum.add_to(&paths[j][(t - p) * qj..t * qj], &mut scratch, next);
                }
                paths[i][t * q..(t + 1) * q].copy_from_slice(next);
            }
        }
        let shapes = paths.iter().zip(&self.latent);
        Ok(shapes.map(|(path, &q)| DMatrix::from_row_slice(frames, q, &path[..frames * q])).collect())
    }
}

impl Poser {
    /// Solves for the coefficients of every pose map.
    pub fn new(model: &FittedModel) -> Result<Self, NumericsError> {
        let maps = model.parts.iter().enumerate();
        let maps = maps.map(|(i, map)| Ok(KernelSum::new(&map.r, &map.kernel, &model.pose_coefficients(i)?)));
        Ok(Self { maps: maps.collect::<Result<_, NumericsError>>()? })
    }

    /// Of pose maps that are sums of kernels, one for each part.
    pub(crate) fn of_sums(maps: Vec<KernelSum>) -> Self {
        Self { maps }
    }

    /// The observed columns of one part at its latents [frames x Q]: [frames x D], without the column means.
    pub fn observations(&self, part: usize, latents: &DMatrix<f64>) -> DMatrix<f64> {
        let map = &self.maps[part];
        let mut x = vec![0.0; latents.ncols()];
        let mut scratch = x.clone();
        let mut y = vec![0.0; map.outputs];
        let mut out = DMatrix::zeros(latents.nrows(), map.outputs);
        for t in 0..latents.nrows() {
            for (x, value) in x.iter_mut().zip(latents.row(t).iter()) {
                *x = *value;
            }
            y.fill(0.0);
            map.add_to(&x, &mut scratch, &mut y);
            for (c, value) in y.iter().enumerate() {
                out[(t, c)] = *value;
            }
        }
        out
    }
}

impl FittedModel {
    /// The start latents of a training sequence, counted from 0.
    pub fn start(&self, sequence: usize) -> Result<&[DMatrix<f64>], RolloutError> {
        self.starts
            .get(sequence)
            .map(Vec::as_slice)
            .ok_or(RolloutError::Sequence { count: self.starts.len(), found: sequence })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::variational::testing::random_case;
    use approx::assert_relative_eq;

    #[test]
    fn re_inferred_under_the_learned_couplings_is_as_learned() {
        let (params, objective) = random_case(3);
        let model = FittedModel::fit(&objective, &params).unwrap();
        let roll = |alpha: &DMatrix<f64>, reading| {
            Roller::new(&model, alpha, reading).unwrap().latents(model.start(1).unwrap(), 30).unwrap()
        };
        for (a, b) in
            roll(&model.alpha, Reading::AsLearned).iter().zip(&roll(&model.alpha, Reading::ReInferred))
        {
            assert_relative_eq!(a, b, epsilon = 1e-9);
        }
        let mut other = model.alpha.clone();
        other[(1, 0)] *= 5.0;
        let (kept, inferred) = (roll(&other, Reading::AsLearned), roll(&other, Reading::ReInferred));
        assert!((&kept[0] - &inferred[0]).amax() > 1e-6);
    }

    #[test]
    fn re_inferred_agrees_with_a_fit_under_the_other_couplings() {
        let (mut params, objective) = random_case(1);
        let model = FittedModel::fit(&objective, &params).unwrap();
        params.alpha[(0, 1)] *= 7.0;
        params.alpha[(1, 1)] *= 0.3;
        let refitted = FittedModel::fit(&objective, &params).unwrap();
        for i in 0..2 {
            let a = model.dynamics_coefficients(i, &params.alpha, Reading::ReInferred).unwrap();
            let b = refitted.dynamics_coefficients(i, &params.alpha, Reading::AsLearned).unwrap();
            for (a, b) in a.iter().zip(&b) {
                assert_relative_eq!(a, b, epsilon = 1e-8, max_relative = 1e-8);
            }
        }
    }

    #[test]
    fn bad_requests_are_refused_in_words() {
        let (params, objective) = random_case(1);
        let model = FittedModel::fit(&objective, &params).unwrap();
        let mut alpha = model.alpha.clone();
        alpha[(0, 1)] = -1.0;
        let error = Roller::new(&model, &alpha, Reading::AsLearned).unwrap_err().to_string();
        assert_eq!(
            error,
            "expected a positive coupling variance from part 0 to part 1, 1e-100 to 1e100, found -1.0"
        );
        alpha[(0, 1)] = 1e-308;
        let error = Roller::new(&model, &alpha, Reading::AsLearned).unwrap_err().to_string();
        assert!(error.ends_with("found 1e-308"), "{error}");
        assert_eq!(
            model.start(9).unwrap_err().to_string(),
            "expected a training sequence from 0 to 1, found 9"
        );
        let roller = Roller::new(&model, &model.alpha, Reading::AsLearned).unwrap();
        assert!(roller.latents(&[], 10).is_err());
    }
}
