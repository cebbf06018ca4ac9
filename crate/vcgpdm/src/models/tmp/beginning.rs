//! Where a trial lies of which only the first frames are known: the maximum of the posterior of its start and rate, its weights
//! integrated out.

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use crate::models::phase::{PhaseAxis, PhaseMap, Trial};
use crate::models::tmp::posterior::Posterior;
use crate::models::tmp::view::View;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// What is known before any trial was seen: people repeat a movement at about the same pace, and clips are cut roughly alike.
/// Standard deviations of the logarithm of the rate and of the start (in movements), worth so many trials.
const PACE: f64 = 0.1;
const CUT: f64 = 0.05;
const PRIOR_TRIALS: f64 = 2.0;
/// Places along a cycle, paces and places on a movement that are looked at first.
const PLACES: usize = 48;
const PACES: i32 = 4;
/// The ranges of the paces and starts that are looked at, in scales of their priors to either side.
const PACE_REACH: f64 = 2.5;
const START_REACH: f64 = 6.0;
/// Steps of the search are halved so often.
const HALVINGS: usize = 7;

/// A Student t distribution: the next value after some that were seen, under the conjugate prior of a normal distribution.
#[derive(Clone, Copy, Debug)]
struct Next {
    centre: f64,
    scale: f64,
    freedom: f64,
}

impl Next {
    /// After `values`, when before them a standard deviation of `before` was expected.
    fn after(values: &[f64], before: f64) -> Self {
        let n = values.len().max(1) as f64;
        let centre = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|v| (v - centre).powi(2)).sum();
        let freedom = PRIOR_TRIALS + n - 1.0;
        let variance = (PRIOR_TRIALS * before * before + squares) / freedom;
        Self { centre, scale: (variance * (1.0 + 1.0 / n)).sqrt(), freedom }
    }

    /// The log density, without what does not depend on `value`.
    fn log_density(&self, value: f64) -> f64 {
        let off = (value - self.centre) / self.scale;
        -0.5 * (self.freedom + 1.0) * (1.0 + off * off / self.freedom).logarithm()
    }
}

/// What the whole trials say about the next one.
pub struct Beginning<'a> {
    posterior: &'a Posterior,
    rate: Next,
    /// Absent on a cycle: a recording begins anywhere.
    start: Option<Next>,
    /// Mean of the weights of every column `[Q]`, and a root of their covariance [Q x Q].
    weights: Vec<(DVector<f64>, DMatrix<f64>)>,
}

impl<'a> Beginning<'a> {
    /// After the trials that the `posterior` has seen.
    pub fn new(posterior: &'a Posterior) -> Result<Self, NumericsError> {
        let maps = &posterior.maps;
        let rates: Vec<f64> = maps.iter().map(|map| map.rate.logarithm()).collect();
        let starts: Vec<f64> = maps.iter().map(|map| map.start).collect();
        let movement = posterior.kernel.axis == PhaseAxis::Trial;
        let mut weights = Vec::with_capacity(posterior.weights.len());
        for (w, scale) in posterior.weights.iter().zip(posterior.scale.iter()) {
            let centre = &w.centre_second - &w.centre * w.centre.transpose();
            let covariance = symmetric(centre + &posterior.spread * *scale);
            let factor = Factor::new(&covariance, "covariance of the weights of a new trial")?;
            weights.push((w.centre.clone(), factor.lower()));
        }
        let rate = Next::after(&rates, PACE);
        let start = movement.then(|| Next::after(&starts, CUT));
        Ok(Self { posterior, rate, start, weights })
    }

    /// The log density of start, rate and frames, the weights integrated out; without what does not depend on start and rate.
    fn value(&self, trial: &Trial, map: &PhaseMap) -> Result<f64, NumericsError> {
        if map.rate <= 0.0 {
            return Ok(f64::NEG_INFINITY);
        }
        let start = self.start.map_or(0.0, |start| start.log_density(map.start));
        let mut value = self.rate.log_density(map.rate.logarithm()) + start;
        let posterior = self.posterior;
        let view = View::new(&posterior.kernel, trial, map);
        let (energy, seen) = (posterior.energy(&view), posterior.v.tr_mul(&view.projected));
        let frames = trial.y.nrows() as f64;
        for (k, (mean, root)) in self.weights.iter().enumerate() {
            let noise = posterior.noise[k];
            // w = mean + root z, z ~ N(0, I).
            let off = (seen.column(k) - &energy * mean) / noise;
            let squares = trial.y.column(k).norm_squared() - 2.0 * seen.column(k).dot(mean)
                + mean.dot(&(&energy * mean));
            let precision = DMatrix::identity(mean.len(), mean.len())
                + symmetric(root.tr_mul(&(&energy * root)) / noise);
            let factor = Factor::new(&precision, "weights of a new trial")?;
            let pull = factor.solve_lower(&DMatrix::from_columns(&[root.tr_mul(&off)]));
            value -= 0.5 * (frames * (2.0 * PI * noise).logarithm() + squares / noise);
            value += 0.5 * (pull.norm_squared() - factor.log_determinant());
        }
        Ok(value)
    }

    /// Where the posterior of start and rate is highest.
    pub fn find(&self, trial: &Trial) -> Result<PhaseMap, NumericsError> {
        let pace = self.rate.centre.exponential();
        let starts: Vec<f64> = match self.start {
            None => (0..PLACES).map(|k| k as f64 / PLACES as f64).collect(),
            Some(start) => {
                let places = (PLACES / 2) as i32;
                let step = |k: i32| START_REACH * start.scale * f64::from(k) / f64::from(places);
                (-places..=places).map(|k| start.centre + step(k)).collect()
            }
        };
        let stretch = |k: f64| (PACE_REACH * self.rate.scale * k / f64::from(PACES)).exponential();
        let mut best = PhaseMap { start: starts[starts.len() / 2], rate: pace };
        let mut most = f64::NEG_INFINITY;
        for k in -PACES..=PACES {
            for &start in &starts {
                let map = PhaseMap { start, rate: pace * stretch(f64::from(k)) };
                let value = self.value(trial, &map)?;
                if value > most {
                    (best, most) = (map, value);
                }
            }
        }
        let step = self.start.map_or(1.0, |start| 2.0 * START_REACH * start.scale) / PLACES as f64;
        let (mut shift, mut pace) = (step, 1.0);
        for _ in 0..HALVINGS {
            (shift, pace) = (0.5 * shift, 0.5 * pace);
            for (shift, pace) in [(shift, 0.0), (-shift, 0.0), (0.0, pace), (0.0, -pace)] {
                let map = PhaseMap { start: best.start + shift, rate: best.rate * stretch(pace) };
                let value = self.value(trial, &map)?;
                if value > most {
                    (best, most) = (map, value);
                }
            }
        }
        Ok(best)
    }
}
