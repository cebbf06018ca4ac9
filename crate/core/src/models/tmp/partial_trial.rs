//! Partial trials, of which only the first frames are known: the start that maximises the posterior, with the
//! weights integrated out.
//!
//! The rate is the mean rate of the whole trials. A few frames show the speed of the movement at that moment,
//! not its mean speed: from five frames, the periods of ten walks of one person had errors of up to 15 %,
//! while the periods differ by 2 %.
//!
//! The residual of the primitives is not white noise: neighbouring frames are correlated, so five frames have
//! little more information than one or two. So the noise of a partial trial has the correlations of the
//! residuals of the whole trials; the frames are whitened and then treated as those of a whole trial.

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use crate::models::data::phase::{Alignment, PhaseAxis, PhaseMap, Trial};
use crate::models::tmp::posterior::Posterior;
use crate::models::tmp::trial_features::TrialFeatures;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// Prior standard deviation of the start, in movements, and its weight, in trials: clips are cut at similar
/// places.
const PRIOR_DEVIATION: f64 = 0.05;
const PRIOR_TRIALS: f64 = 2.0;
/// The least share of white noise in the variance of the noise.
const WHITE: f64 = 1e-3;
/// Number of starts that are tried first.
const PLACES: usize = 64;
/// In a movement that is not a cycle, the range of the starts that are tried, in scales of their prior.
const START_REACH: f64 = 6.0;
/// How often the steps of the search are halved.
const HALVINGS: usize = 7;

/// A Student t distribution: the predictive distribution of a normal variable under its conjugate prior.
#[derive(Clone, Copy, Debug)]
struct StudentT {
    centre: f64,
    scale: f64,
    freedom: f64,
}

impl StudentT {
    /// The distribution of the next value after `values`, with a prior standard deviation of `deviation`.
    fn new(values: &[f64], deviation: f64) -> Self {
        let n = values.len().max(1) as f64;
        let centre = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|v| (v - centre).powi(2)).sum();
        let freedom = PRIOR_TRIALS + n - 1.0;
        let variance = (PRIOR_TRIALS * deviation * deviation + squares) / freedom;
        Self { centre, scale: (variance * (1.0 + 1.0 / n)).sqrt(), freedom }
    }

    /// The log density, without terms that do not depend on `value`.
    fn log_density(&self, value: f64) -> f64 {
        let off = (value - self.centre) / self.scale;
        -0.5 * (self.freedom + 1.0) * (1.0 + off * off / self.freedom).logarithm()
    }
}

/// A partial trial under the posterior of the whole trials.
pub struct PartialTrial<'a> {
    posterior: &'a Posterior,
    /// The frames, whitened.
    whitened: Trial,
    /// A root of the correlations of the noise from frame to frame.
    noise: Factor,
    rate: f64,
    /// The prior of the start; absent on a cycle, where a recording starts anywhere.
    start: Option<StudentT>,
    /// Mean of the weights of every column `[Q]`, and a root of their covariance [Q x Q].
    weights: Vec<(DVector<f64>, DMatrix<f64>)>,
}

impl<'a> PartialTrial<'a> {
    /// The `partial` trial under the `posterior` of the whole `trials`.
    pub fn new(posterior: &'a Posterior, trials: &[Trial], partial: &Trial) -> Result<Self, NumericsError> {
        let correlations = posterior.residual_correlations(trials, partial.y.nrows());
        let frames = partial.y.nrows();
        let correlation = DMatrix::from_fn(frames, frames, |a, b| {
            correlations[a.abs_diff(b)] + if a == b { WHITE } else { 0.0 }
        });
        let noise = Factor::new(&correlation, "correlations of the noise")?;
        let whitened = Trial { y: noise.solve_lower(&partial.y), whole: false };
        let maps = &posterior.maps;
        let starts: Vec<f64> = maps.iter().map(|map| map.start).collect();
        let movement = posterior.kernel.axis == PhaseAxis::Trial;
        let mut weights = Vec::with_capacity(posterior.weights.len());
        for (w, scale) in posterior.weights.iter().zip(posterior.scale.iter()) {
            let centre = &w.centre_second - &w.centre * w.centre.transpose();
            let covariance = symmetric(centre + &posterior.spread * *scale);
            let factor = Factor::new(&covariance, "covariance of the weights of a new trial")?;
            weights.push((w.centre.clone(), factor.lower()));
        }
        let rate = Alignment::mean_rate(trials, maps);
        let start = movement.then(|| StudentT::new(&starts, PRIOR_DEVIATION));
        Ok(Self { posterior, whitened, noise, rate, start, weights })
    }

    /// The log density of start and frames, with the weights integrated out and without terms that do not
    /// depend on the start.
    pub fn value(&self, map: &PhaseMap) -> Result<f64, NumericsError> {
        let mut value = self.start.map_or(0.0, |start| start.log_density(map.start));
        let (posterior, trial, features) = (self.posterior, &self.whitened, self.features(map));
        let energy = posterior.energy(&features);
        let projection = posterior.v.tr_mul(&features.projected);
        let frames = trial.y.nrows() as f64;
        for (k, (mean, root)) in self.weights.iter().enumerate() {
            let noise = posterior.noise[k];
            // w = mean + root z, z ~ N(0, I).
            let off = (projection.column(k) - &energy * mean) / noise;
            let squares = trial.y.column(k).norm_squared() - 2.0 * projection.column(k).dot(mean)
                + mean.dot(&(&energy * mean));
            let precision =
                DMatrix::identity(mean.len(), mean.len()) + symmetric(root.tr_mul(&(&energy * root)) / noise);
            let factor = Factor::new(&precision, "weights of a new trial")?;
            let pull = factor.solve_lower(&DMatrix::from_columns(&[root.tr_mul(&off)]));
            value -= 0.5 * (frames * (2.0 * PI * noise).logarithm() + squares / noise);
            value += 0.5 * (pull.norm_squared() - factor.log_determinant());
        }
        Ok(value)
    }

    /// The features of the whitened frames at `map`.
    pub fn features(&self, map: &PhaseMap) -> TrialFeatures {
        TrialFeatures::whitened(&self.posterior.kernel, &self.whitened, &self.noise, map)
    }

    /// The whitened frames.
    pub fn whitened(&self) -> &Trial {
        &self.whitened
    }

    /// The difference between the bound of the whitened frames and that of the frames, in nats: the
    /// log-determinant of the whitening.
    pub fn log_determinant(&self) -> f64 {
        0.5 * self.noise.log_determinant() * self.whitened.y.ncols() as f64
    }

    /// The map with the highest posterior of the start.
    pub fn best_map(&self) -> Result<PhaseMap, NumericsError> {
        let starts: Vec<f64> = match self.start {
            None => (0..PLACES).map(|k| k as f64 / PLACES as f64).collect(),
            Some(start) => {
                let places = (PLACES / 2) as i32;
                let step = |k: i32| START_REACH * start.scale * f64::from(k) / f64::from(places);
                (-places..=places).map(|k| start.centre + step(k)).collect()
            }
        };
        let at = |start: f64| PhaseMap { start, rate: self.rate };
        let mut best = at(starts[starts.len() / 2]);
        let mut most = f64::NEG_INFINITY;
        for &start in &starts {
            let value = self.value(&at(start))?;
            if value > most {
                (best, most) = (at(start), value);
            }
        }
        let mut step = self.start.map_or(1.0, |start| 2.0 * START_REACH * start.scale) / PLACES as f64;
        for _ in 0..HALVINGS {
            step *= 0.5;
            for shift in [step, -step] {
                let map = at(best.start + shift);
                let value = self.value(&map)?;
                if value > most {
                    (best, most) = (map, value);
                }
            }
        }
        Ok(best)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_start_of_a_trial_is_predicted_from_those_of_the_others_and_two_at_the_prior_deviation() {
        let t = StudentT::new(&[0.1, 0.3], 0.05);
        // The squares 2 * 0.05^2 + 2 * 0.1^2 = 0.025 have 2 + 2 - 1 degrees of freedom.
        assert_eq!((t.centre, t.freedom), (0.2, 3.0));
        assert!((t.scale - (0.025_f64 / 3.0 * 1.5).sqrt()).abs() < 1e-12, "{t:?}");
        assert!((t.log_density(0.2 + 2.0 * t.scale) + 2.0 * (7.0_f64 / 3.0).ln()).abs() < 1e-12);
    }
}
