//! Probabilistic movement primitives (Paraschos, Daniel, Peters and Neumann 2013, NIPS 26).
//!
//! A trial is y_t = phi(s_t)' W + noise, with B basis functions phi of the phase s_t and weights W [B x D]. The
//! weights of the trials are Gaussian (their equation 1). Everything is closed form:
//!
//! - the weights of each trial by ridge regression, `W = (Phi'Phi + lambda I)^-1 Phi'Y`;
//! - the mean M of these weights, and their deviations from it divided by sqrt(n - 1): with standard Gaussian
//!   coordinates z [n], one for each trial, `M + sum_s z_s A_s` has the mean and the covariance of the weights,
//!   all columns together;
//! - the noise variance of each column from the residuals of the regressions;
//! - given the first frames, the posterior of z is Gaussian (their equation 6, in the coordinates z):
//!   `P = I + sum g g' / noise` and `E[z] = P^-1 sum g (y - phi'M) / noise`, over the given frames and all
//!   columns, where `g_s = phi(s_t)' A_s`.
//!
//! A rollout of a trial that was learned from would remember the trial: its own weights are among the n. It uses
//! the mean and the deviations of the others instead, so that rollouts on the training trials can choose B.
//!
//! The phase of a frame is that of the TMP and of the rhythmic DMP: a straight line for each trial, on a cycle
//! where the movement repeats itself, else from the start to the end. A trial of which only the first frames
//! are known has the mean rate. The basis functions are von Mises functions on a cycle, else Gaussians, and
//! their sum is 1 at every phase.

use crate::evaluation::predictor::{Forecast, Predictor};
use crate::evaluation::rivals::sequences::{Trials, check};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;
use vcgpdm_core::elementary::Elementary;
use vcgpdm_core::gp::linalg::Factor;
use vcgpdm_core::models::{Alignment, Movements, PhaseAxis, PhaseMap, RolloutError, TrainingError};

/// The ridge lambda, relative to the mean of the diagonal of Phi'Phi.
const RIDGE: f64 = 1e-4;
/// The smallest noise variance of a column, relative to the mean square of all columns.
const LEAST_NOISE: f64 = 1e-6;

/// The primitives of one movement.
pub(super) struct ProMp {
    axis: PhaseAxis,
    /// The weights of each whole trial [B x D].
    weights: Vec<DMatrix<f64>>,
    /// Noise variance of each column.
    noise: Vec<f64>,
    sequences: Vec<Given>,
}

/// A sequence whose first frames are given.
struct Given {
    map: PhaseMap,
    /// Its place among the whole trials, if it is one.
    own: Option<usize>,
    /// The posterior of the coordinates z: its mean [n] and covariance [n x n].
    mean: DVector<f64>,
    covariance: DMatrix<f64>,
}

impl ProMp {
    /// # Errors
    /// No sequence is a whole trial, or a regression fails.
    pub fn fit(movements: &Movements, bases: usize) -> Result<Self, TrainingError> {
        let given = Trials::new(movements, 1)?;
        let Alignment { axis, maps } = Alignment::new(&given.trials, None);
        let whole = || given.trials.iter().zip(&maps).filter(|(trial, _)| trial.whole);
        let columns = given.trials[0].y.ncols();
        let (mut weights, mut squares, mut freedom) = (Vec::new(), DVector::zeros(columns), 0.0);
        let (mut all_squares, mut all) = (0.0, 0.0);
        for (trial, map) in whole() {
            let phi = design(axis, bases, map, trial.y.nrows());
            let mut gram = phi.tr_mul(&phi);
            let ridge = RIDGE * gram.trace() / bases as f64;
            let plain = gram.clone();
            (0..bases).for_each(|b| gram[(b, b)] += ridge);
            let factor = Factor::new(&gram, "regression of a trial on its basis functions")?;
            let own = factor.solve(&phi.tr_mul(&trial.y));
            let residuals = &trial.y - &phi * &own;
            for (d, column) in residuals.column_iter().enumerate() {
                squares[d] += column.norm_squared();
            }
            // The parameters that the ridge leaves: the trace of the smoother.
            freedom += trial.y.nrows() as f64 - factor.solve(&plain).trace();
            all_squares += trial.y.norm_squared();
            all += trial.y.len() as f64;
            weights.push(own);
        }
        let least = (LEAST_NOISE * all_squares / all).max(f64::MIN_POSITIVE.sqrt());
        let noise = squares.iter().map(|squares: &f64| (squares / freedom.max(1.0)).max(least)).collect();
        let mut model = Self { axis, weights, noise, sequences: Vec::new() };
        let mut wholes = 0;
        for ((trial, start), map) in given.trials.iter().zip(given.starts()).zip(maps) {
            let own = trial.whole.then_some(wholes);
            wholes += usize::from(trial.whole);
            let given = model.given(&start, map, own)?;
            model.sequences.push(given);
        }
        Ok(model)
    }

    /// The mean M of the weights [B x D] and the deviations A_s, without those of one trial if there are others.
    fn prior(&self, without: Option<usize>) -> (DMatrix<f64>, Vec<DMatrix<f64>>) {
        let is_used = |(k, _): &(usize, &DMatrix<f64>)| Some(*k) != without || self.weights.len() == 1;
        let used: Vec<&DMatrix<f64>> =
            self.weights.iter().enumerate().filter(is_used).map(|(_, w)| w).collect();
        let count = used.len() as f64;
        let mean = used.iter().copied().sum::<DMatrix<f64>>() / count;
        let deviations = match used.len() {
            1 => Vec::new(),
            _ => used.iter().map(|own| (*own - &mean) / (count - 1.0).sqrt()).collect(),
        };
        (mean, deviations)
    }

    /// A sequence with the first frames `y` [k x D].
    fn given(&self, y: &DMatrix<f64>, map: PhaseMap, own: Option<usize>) -> Result<Given, TrainingError> {
        let (mean, deviations) = self.prior(own);
        let n = deviations.len();
        let phi = design(self.axis, mean.nrows(), &map, y.nrows());
        let apart = y - &phi * &mean;
        let effects: Vec<DMatrix<f64>> = deviations.iter().map(|a| &phi * a).collect();
        let inner = |a: &DMatrix<f64>, b: &DMatrix<f64>| {
            let of_column = |(d, noise): (usize, &f64)| a.column(d).dot(&b.column(d)) / noise;
            self.noise.iter().enumerate().map(of_column).sum::<f64>()
        };
        let precision =
            DMatrix::from_fn(n, n, |i, j| inner(&effects[i], &effects[j]) + if i == j { 1.0 } else { 0.0 });
        let right = DMatrix::from_fn(n, 1, |i, _| inner(&effects[i], &apart));
        let factor = Factor::new(&precision, "precision of the weights, given first frames")?;
        let mean = factor.solve(&right).column(0).into_owned();
        Ok(Given { map, own, mean, covariance: factor.inverse() })
    }
}

impl Predictor for ProMp {
    fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        check(self.sequences.len(), sequence, frames)?;
        let given = &self.sequences[sequence];
        let (mut weights, deviations) = self.prior(given.own);
        for (a, z) in deviations.iter().zip(given.mean.iter()) {
            weights += a * *z;
        }
        Ok(vec![design(self.axis, weights.nrows(), &given.map, frames) * weights])
    }

    fn forecast(&self, sequence: usize, frames: usize) -> Result<Option<Forecast>, RolloutError> {
        let means = self.rollout(sequence, frames)?;
        let Given { map, own, covariance, .. } = &self.sequences[sequence];
        let (mean, deviations) = self.prior(*own);
        let phi = design(self.axis, mean.nrows(), map, frames);
        let effects: Vec<DMatrix<f64>> = deviations.iter().map(|a| &phi * a).collect();
        let variance = |t: usize, d: usize| {
            let g = DVector::from_iterator(effects.len(), effects.iter().map(|effect| effect[(t, d)]));
            g.dot(&(covariance * &g)).max(0.0) + self.noise[d]
        };
        let variances = DMatrix::from_fn(frames, self.noise.len(), variance);
        Ok(Some(Forecast { means, variances: vec![variances] }))
    }

    /// The mean, the deviations and the noise; of the sequence, the two numbers of its phase and E[z].
    fn stored_numbers(&self) -> usize {
        let (mean, deviations) = self.prior(None);
        let n = deviations.len();
        mean.len() * (1 + n) + self.noise.len() + 2 + n
    }
}

/// The basis functions at the phases of the first `frames` frames [frames x B].
fn design(axis: PhaseAxis, bases: usize, map: &PhaseMap, frames: usize) -> DMatrix<f64> {
    let count = bases as f64;
    let value = |phase: f64, b: usize| match axis {
        // As wide as the distance of two centres.
        PhaseAxis::Cycle => {
            let concentration = (count / TAU) * (count / TAU);
            (concentration * ((TAU * (phase - b as f64 / count)).cosine() - 1.0)).exponential()
        }
        PhaseAxis::Trial => {
            let apart = phase * (count - 1.0) - b as f64;
            (-0.5 * apart * apart).exponential()
        }
    };
    let mut phi = DMatrix::from_fn(frames, bases, |t, b| {
        let phase = map.at(t);
        // Beyond the movement, a trial keeps its last pose.
        value(if axis == PhaseAxis::Trial { phase.clamp(0.0, 1.0) } else { phase }, b)
    });
    for mut row in phi.row_iter_mut() {
        let sum = row.sum();
        row /= sum;
    }
    phi
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::rivals::testing::{movements, noise};
    use approx::assert_relative_eq;

    /// Walks of two columns: the second differs from trial to trial by its size.
    fn walk(frames: usize, period: f64, start: f64, size: f64) -> DMatrix<f64> {
        DMatrix::from_fn(frames, 2, |t, d| {
            let phase = TAU * (t as f64 / period + start);
            if d == 0 { phase.sin() } else { size * (phase + 0.7).cos() + 0.2 * (2.0 * phase).sin() }
        })
    }

    fn walks() -> Vec<(DMatrix<f64>, bool)> {
        let truth = [(100, 0.0, 1.0), (90, 0.3, 1.3), (110, 0.6, 0.7), (95, 0.8, 1.1), (105, 0.4, 0.8)];
        let mut trials: Vec<_> = truth.map(|(frames, s, a)| (walk(frames, 32.0, s, a), true)).into();
        trials.push((walk(6, 32.0, 0.5, 1.25), false));
        trials.iter_mut().enumerate().for_each(|(k, (y, _))| *y += noise(y.nrows(), 2, k as u64) * 0.02);
        trials
    }

    /// The joint Gaussian of given and predicted frames, all columns in one vector, conditioned by brute force.
    #[test]
    fn conditions_as_the_joint_gaussian_does() {
        let trials = walks();
        let model = ProMp::fit(&movements(&trials), 6).unwrap();
        let (last, frames, given) = (trials.len() - 1, 40, 6);
        let (mean, deviations) = model.prior(None);
        let phi = design(model.axis, 6, &model.sequences[last].map, frames);
        let stacked = |m: &DMatrix<f64>| DVector::from_column_slice((&phi * m).as_slice());
        let mean = stacked(&mean);
        let mut covariance = DMatrix::<f64>::zeros(2 * frames, 2 * frames);
        for a in &deviations {
            let effect = stacked(a);
            covariance += &effect * effect.transpose();
        }
        (0..2 * frames).for_each(|k| covariance[(k, k)] += model.noise[k / frames]);
        let seen: Vec<usize> = (0..2 * frames).filter(|k| k % frames < given).collect();
        let y =
            DVector::from_iterator(seen.len(), seen.iter().map(|k| trials[last].0[(k % frames, k / frames)]));
        let gain = covariance.select_columns(&seen)
            * covariance.select_rows(&seen).select_columns(&seen).try_inverse().unwrap();
        let expected = &mean + &gain * (y - mean.select_rows(&seen));
        let left = &covariance - &gain * covariance.select_rows(&seen);
        let found = model.forecast(last, frames).unwrap().unwrap();
        for t in given..frames {
            for d in 0..2 {
                let k = d * frames + t;
                assert_relative_eq!(found.means[0][(t, d)], expected[k], epsilon = 1e-9);
                assert_relative_eq!(found.variances[0][(t, d)], left[(k, k)], epsilon = 1e-9);
            }
        }
    }

    #[test]
    fn first_frames_tell_the_size_of_a_walk() {
        let trials = walks();
        let model = ProMp::fit(&movements(&trials), 8).unwrap();
        assert_eq!(model.axis, PhaseAxis::Cycle);
        let made = model.rollout(5, 90).unwrap().swap_remove(0);
        let truth = walk(90, 32.0, 0.5, 1.25);
        let error = |y: &DMatrix<f64>| (y - &truth).norm_squared() / truth.norm_squared();
        assert!(error(&made) < 0.02, "{}", error(&made));
        // The mean weights alone know nothing of this trial.
        let mean = design(model.axis, 8, &model.sequences[5].map, 90) * model.prior(None).0;
        assert!(error(&mean) > 1.5 * error(&made), "{} {}", error(&mean), error(&made));
    }

    #[test]
    fn reaches_have_phases_from_start_to_end() {
        let reach = |frames: usize, height: f64| {
            DMatrix::from_fn(frames, 1, |t, _| {
                let phase = t as f64 / (frames - 1) as f64;
                height * (6.0 * (phase - 0.5)).tanh()
            })
        };
        let mut trials: Vec<_> =
            [(50, 1.0), (60, 1.2), (55, 0.9)].map(|(frames, height)| (reach(frames, height), true)).into();
        trials.push((reach(55, 1.1).rows(0, 12).into_owned(), false));
        let model = ProMp::fit(&movements(&trials), 10).unwrap();
        assert_eq!(model.axis, PhaseAxis::Trial);
        let made = model.rollout(3, 55).unwrap().swap_remove(0);
        let error = (&made - reach(55, 1.1)).norm_squared() / made.norm_squared();
        assert!(error < 0.05, "{error}");
    }

    #[test]
    fn one_trial_has_no_deviations() {
        let trials = &walks()[..1];
        let model = ProMp::fit(&movements(trials), 8).unwrap();
        assert!(model.prior(None).1.is_empty());
        let found = model.forecast(0, 100).unwrap().unwrap();
        assert!((&found.means[0] - &trials[0].0).norm() < 0.1 * trials[0].0.norm());
        assert!(model.rollout(1, 5).is_err() && model.rollout(0, 0).is_err());
    }

    #[test]
    fn a_trial_trained_on_is_predicted_from_the_others() {
        let mut trials = walks();
        for t in 50..60 {
            trials[0].0[(t, 0)] += 2.0;
        }
        let model = ProMp::fit(&movements(&trials), 30).unwrap();
        let made = model.rollout(0, 100).unwrap().swap_remove(0);
        let plain = &walks()[0].0;
        assert!((made[(55, 0)] - plain[(55, 0)]).abs() < 0.3, "{} {}", made[(55, 0)], plain[(55, 0)]);
    }
}
