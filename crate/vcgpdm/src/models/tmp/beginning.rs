//! Where a trial lies of which only the first frames are known: the maximum of the posterior of its start,
//! its weights integrated out.
//!
//! Its rate is the one that the whole trials lead to expect, their mean. A few frames tell how fast a
//! movement is just then, which is not how fast it is on the whole: from five frames, the periods of ten
//! walks of one person came out up to 15 % wrong, while the walks themselves differ by 2 %.
//!
//! What the primitives leave of a movement is no white noise: it goes on from frame to frame, so that five
//! frames in a row tell little more than one or two. So the noise of these frames has the correlations from
//! frame to frame that the whole trials show, and both are whitened: the rest is as for a whole trial.

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use crate::models::data::phase::{Alignment, PhaseAxis, PhaseMap, Trial};
use crate::models::tmp::posterior::Posterior;
use crate::models::tmp::view::View;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// What is known before any trial was seen: clips are cut roughly alike. The standard deviation of the start,
/// in movements, worth so many trials.
const CUT: f64 = 0.05;
const PRIOR_TRIALS: f64 = 2.0;
/// What of the noise's variance is white at least.
const WHITE: f64 = 1e-3;
/// Places that are looked at first.
const PLACES: usize = 64;
/// The range of the starts that are looked at on a movement that is no cycle, in scales of their prior to
/// either side.
const START_REACH: f64 = 6.0;
/// Steps of the search are halved so often.
const HALVINGS: usize = 7;

/// A Student t distribution: the next value after some that were seen, under the conjugate prior of a normal
/// distribution.
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
    /// The frames, whitened.
    whitened: Trial,
    /// A root of the correlations of the noise from frame to frame.
    noise: Factor,
    rate: f64,
    /// Absent on a cycle: a recording begins anywhere.
    start: Option<Next>,
    /// Mean of the weights of every column `[Q]`, and a root of their covariance [Q x Q].
    weights: Vec<(DVector<f64>, DMatrix<f64>)>,
}

impl<'a> Beginning<'a> {
    /// Of the `begun` trial, after the `trials` that the `posterior` has seen.
    pub fn new(posterior: &'a Posterior, trials: &[Trial], begun: &Trial) -> Result<Self, NumericsError> {
        let correlations = posterior.residual_correlations(trials, begun.y.nrows());
        let frames = begun.y.nrows();
        let correlation = DMatrix::from_fn(frames, frames, |a, b| {
            correlations[a.abs_diff(b)] + if a == b { WHITE } else { 0.0 }
        });
        let noise = Factor::new(&correlation, "correlations of the noise")?;
        let whitened = Trial { y: noise.solve_lower(&begun.y), whole: false };
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
        let start = movement.then(|| Next::after(&starts, CUT));
        Ok(Self { posterior, whitened, noise, rate, start, weights })
    }

    /// The log density of start and frames, the weights integrated out; without what does not depend on the
    /// start.
    fn value(&self, map: &PhaseMap) -> Result<f64, NumericsError> {
        let mut value = self.start.map_or(0.0, |start| start.log_density(map.start));
        let posterior = self.posterior;
        let (trial, view) = (&self.whitened, self.view(map));
        let (energy, seen) = (posterior.energy(&view), posterior.v.tr_mul(&view.projected));
        let frames = trial.y.nrows() as f64;
        for (k, (mean, root)) in self.weights.iter().enumerate() {
            let noise = posterior.noise[k];
            // w = mean + root z, z ~ N(0, I).
            let off = (seen.column(k) - &energy * mean) / noise;
            let squares = trial.y.column(k).norm_squared() - 2.0 * seen.column(k).dot(mean)
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

    /// What the frames look like at `map`.
    pub fn view(&self, map: &PhaseMap) -> View {
        View::whitened(&self.posterior.kernel, &self.whitened, &self.noise, map)
    }

    /// The frames as [`Self::view`] has them.
    pub fn whitened(&self) -> &Trial {
        &self.whitened
    }

    /// What the bound of the whitened frames has more than that of the frames: the log-determinant of the
    /// whitening, in nats.
    pub fn stretch(&self) -> f64 {
        0.5 * self.noise.log_determinant() * self.whitened.y.ncols() as f64
    }

    /// Where the posterior of the start is highest.
    pub fn find(&self) -> Result<PhaseMap, NumericsError> {
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
