//! Dynamic movement primitives around a centre.

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::models::data::phase::{Alignment, PhaseAxis, PhaseMap, Trial};
use crate::models::dmp::spring::{Curve, OVERLAP, SpringStart, integrate, regress};
use crate::models::rollout::request::{Handles, RolloutError, check_frames};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// The smallest and largest amplitude of a partial trial.
const AMPLITUDES: (f64, f64) = (0.5, 2.0);
/// Number of phases around the cycle that are tried as the start of a sequence.
const PLACES: usize = 256;

/// Phase and amplitude of a sequence on the limit cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct RhythmicStart {
    /// Phase of the first frame and its change from frame to frame, in cycles.
    pub map: PhaseMap,
    /// Amplitude r of the movement; 1 in the training trials.
    pub amplitude: f64,
    /// The springs at the first frame.
    pub spring: SpringStart,
}

/// Fitted rhythmic dynamic movement primitives.
#[derive(Clone, Debug, PartialEq)]
pub struct DmpRhythmic {
    /// Centre g of the movement `[D]`: the mean of the cycle.
    pub centre: DVector<f64>,
    /// psi_b(phi) = exp(concentration (cos(phi - 2 pi b / B) - 1)).
    pub concentration: f64,
    /// Weights w of the basis functions [B x D].
    pub weights: DMatrix<f64>,
    /// The start of each training sequence.
    pub starts: Vec<RhythmicStart>,
    /// Numbers of columns D_i of the parts, in order.
    pub columns: Vec<usize>,
}

impl DmpRhythmic {
    /// Learns `bases` weights for each column. The period is that of the autocorrelation over all columns;
    /// starts and rates of the trials come from an alignment to their mean cycle. A movement without a period
    /// has one cycle, as long as the longest trial.
    ///
    /// # Errors
    ///
    /// When the regression cannot be solved.
    pub fn fit(trials: &[Trial], columns: &[usize], bases: usize) -> Result<Self, NumericsError> {
        let alignment = Alignment::new(trials, Some(PhaseAxis::Cycle));
        let d = trials.first().map_or(0, |t| t.y.ncols());
        let start = |(trial, map): (&Trial, &PhaseMap)| RhythmicStart {
            map: *map,
            amplitude: 1.0,
            spring: SpringStart::at_first_frame(&trial.y),
        };
        let mut model = Self {
            centre: alignment.template(trials).row_mean().transpose(),
            concentration: (bases as f64 / (TAU * OVERLAP)).powi(2),
            weights: DMatrix::zeros(bases, d),
            starts: trials.iter().zip(&alignment.maps).map(start).collect(),
            columns: columns.to_vec(),
        };
        let (mut gram, mut moment) = (DMatrix::zeros(bases, bases), DMatrix::zeros(bases, d));
        for (trial, map) in trials.iter().zip(&alignment.maps).filter(|(trial, _)| trial.whole) {
            let curve = Curve::new(&trial.y);
            let target = curve.forces(&model.centre, 1.0 / (TAU * map.rate));
            let phases = curve.times().into_iter().map(|t| map.start + map.rate * t);
            let rows: Vec<_> = phases.map(|phase| model.features(phase).transpose()).collect();
            let features = DMatrix::from_rows(&rows);
            gram += features.tr_mul(&features);
            moment += features.tr_mul(&target);
        }
        model.weights = regress(&gram, &moment)?;
        let cycle = model.limit_cycle();
        for (start, trial) in model.starts.iter_mut().zip(trials) {
            start.fit(&cycle, &model.centre, trial);
        }
        Ok(model)
    }

    /// psi_b / sum psi at a phase in cycles `[B]`.
    fn features(&self, phase: f64) -> DVector<f64> {
        let bases = self.weights.nrows();
        let value = |b: usize| {
            (self.concentration * ((TAU * (phase - b as f64 / bases as f64)).cosine() - 1.0)).exponential()
        };
        let psi = DVector::from_fn(bases, |b, _| value(b));
        let sum = psi.sum();
        psi / sum
    }

    /// The limit cycle of amplitude 1 around 0 at [`PLACES`] phases from 0 on [PLACES x D], the same for all
    /// rates.
    fn limit_cycle(&self) -> DMatrix<f64> {
        // Time is in places instead of frames. After one cycle, the effect of the start has decayed.
        let tau = PLACES as f64 / TAU;
        let zero = DVector::zeros(self.centre.len());
        let y = integrate(&zero, &zero, &zero, tau, 2 * PLACES, &Handles::default(), |t, out| {
            out.copy_from(&self.weights.tr_mul(&self.features(t / PLACES as f64)));
        });
        y.rows(PLACES, PLACES).into_owned()
    }

    /// The movement from the start of a training sequence, under `handles` of centred columns in the order of the
    /// parts: all columns, centred [frames x D].
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the number of frames is out of its range.
    pub fn path(
        &self,
        sequence: usize,
        frames: usize,
        handles: &Handles,
    ) -> Result<DMatrix<f64>, RolloutError> {
        check_frames(frames)?;
        let count = self.starts.len();
        let start = self.starts.get(sequence).ok_or(RolloutError::Sequence { count, found: sequence })?;
        let rate = start.map.rate * handles.tempo;
        let (tau, amplitude) = (1.0 / (TAU * rate), start.amplitude);
        let spring = &start.spring;
        Ok(integrate(
            &spring.position,
            &(&spring.velocity * handles.tempo),
            &handles.moved(&self.centre),
            tau,
            frames,
            handles,
            |t, out| {
                out.copy_from(&self.weights.tr_mul(&self.features(start.map.start + rate * t)));
                *out *= amplitude;
            },
        ))
    }

    /// The number of stored numbers from which one sequence can be rolled out: weights, centre, y(0) and
    /// y'(0) of one sequence, its start, rate and amplitude, and the concentration.
    pub fn stored_numbers(&self) -> usize {
        self.weights.len() + 3 * self.centre.len() + 4
    }
}

impl RhythmicStart {
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
