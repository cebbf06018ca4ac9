//! Dynamic movement primitives around a centre: their regression, and the starts of partial trials.

use crate::gp::NumericsError;
use crate::models::data::phase::{Alignment, PhaseAxis, Trial};
use crate::models::dmp::model::{Canonical, Dmp, DmpStart};
use crate::models::dmp::spring::{Curve, OVERLAP, integrate, regress};
use crate::models::rollout::request::Handles;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// The smallest and largest amplitude of a partial trial.
const AMPLITUDES: (f64, f64) = (0.5, 2.0);
/// Number of phases around the cycle that are tried as the start of a sequence.
const PLACES: usize = 256;

impl Dmp {
    /// Learns `bases` weights for each column. The period is that of the autocorrelation over all columns;
    /// starts and rates of the trials come from an alignment to their mean cycle. A movement without a period
    /// has one cycle, as long as the longest trial.
    ///
    /// # Errors
    ///
    /// When the regression cannot be solved.
    pub fn rhythmic(trials: &[Trial], columns: &[usize], bases: usize) -> Result<Self, NumericsError> {
        let alignment = Alignment::new(trials, Some(PhaseAxis::Cycle));
        let d = trials.first().map_or(0, |t| t.y.ncols());
        let mut model = Self {
            canonical: Canonical::Rhythmic { concentration: (bases as f64 / (TAU * OVERLAP)).powi(2) },
            goal: alignment.template(trials).row_mean().transpose(),
            weights: DMatrix::zeros(bases, d),
            starts: trials.iter().zip(&alignment.maps).map(DmpStart::new).collect(),
            columns: columns.to_vec(),
        };
        let (mut gram, mut moment) = (DMatrix::zeros(bases, bases), DMatrix::zeros(bases, d));
        for (trial, map) in trials.iter().zip(&alignment.maps).filter(|(trial, _)| trial.whole) {
            let curve = Curve::new(&trial.y);
            let target = curve.forces(&model.goal, 1.0 / (TAU * map.rate));
            let features = model.features_along(&curve, map);
            gram += features.tr_mul(&features);
            moment += features.tr_mul(&target);
        }
        model.weights = regress(&gram, &moment)?;
        let cycle = model.limit_cycle();
        for (start, trial) in model.starts.iter_mut().zip(trials) {
            start.fit(&cycle, &model.goal, trial);
        }
        Ok(model)
    }

    /// The limit cycle of amplitude 1 around 0 at [`PLACES`] phases from 0 on [PLACES x D], the same for all
    /// rates.
    fn limit_cycle(&self) -> DMatrix<f64> {
        // Time is in places instead of frames. After one cycle, the effect of the start has decayed.
        let tau = PLACES as f64 / TAU;
        let zero = DVector::zeros(self.goal.len());
        let y = integrate(&zero, &zero, &zero, tau, 2 * PLACES, &Handles::default(), |t, out| {
            out.copy_from(&self.weights.tr_mul(&self.features(t / PLACES as f64)));
        });
        y.rows(PLACES, PLACES).into_owned()
    }
}

impl DmpStart {
    /// Sets the amplitude, and the phase of a partial trial, to those at which `cycle` is nearest to the
    /// frames.
    fn fit(&mut self, cycle: &DMatrix<f64>, centre: &DVector<f64>, trial: &Trial) {
        let places = cycle.nrows();
        let centred: Vec<DVector<f64>> = trial.y.row_iter().map(|row| row.transpose() - centre).collect();
        let cycle = cycle.transpose();
        let mut least = f64::INFINITY;
        let tried = if trial.whole { 1 } else { places };
        for place in 0..tried {
            let start = if trial.whole { self.map.start } else { place as f64 / places as f64 };
            let (mut product, mut energy, mut all) = (0.0, 0.0, 0.0);
            for (t, row) in centred.iter().enumerate() {
                let phase = start + self.map.rate * t as f64;
                let at = ((phase - phase.floor()) * places as f64).round() as usize % places;
                product += cycle.column(at).dot(row);
                energy += cycle.column(at).norm_squared();
                all += row.norm_squared();
            }
            let free = if energy > 0.0 { product / energy } else { 1.0 };
            let amplitude = free.clamp(AMPLITUDES.0, AMPLITUDES.1);
            let error = all - 2.0 * amplitude * product + amplitude * amplitude * energy;
            if error < least {
                least = error;
                (self.map.start, self.amplitude) = (start, amplitude);
            }
        }
    }
}
