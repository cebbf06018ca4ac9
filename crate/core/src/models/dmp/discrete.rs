//! Dynamic movement primitives towards a goal.

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::models::data::phase::{Alignment, PhaseAxis, PhaseMap, Trial};
use crate::models::dmp::spring::{ALPHA_Z, Curve, OVERLAP, SpringStart, integrate, regress};
use crate::models::rollout::request::{Handles, RolloutError, check_frames};
use nalgebra::{DMatrix, DVector};

/// A column is scaled by g - y(0) only if that is at least this share of its range in every whole trial, with
/// the same sign in all.
const CLEAR_WAY: f64 = 0.25;
/// Decay rate of x: alpha_z / 3, as in Ijspeert et al.
const ALPHA_X: f64 = ALPHA_Z / 3.0;

/// Start of a sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct DiscreteStart {
    /// t / tau of the first frame, and its change from frame to frame.
    pub map: PhaseMap,
    /// The springs at the first frame.
    pub spring: SpringStart,
}

/// Fitted discrete dynamic movement primitives.
#[derive(Clone, Debug, PartialEq)]
pub struct DmpDiscrete {
    /// Goal g `[D]`: the mean of the last frames of the whole trials.
    pub goal: DVector<f64>,
    /// Decay rate of x: x = exp(-alpha_x t / tau), where t / tau is the phase of the trial.
    pub alpha_x: f64,
    /// Centres of the bases, in x `[B]`.
    pub centres: Vec<f64>,
    /// psi_b(x) = exp(-widths_b (x - centres_b)^2) `[B]`.
    pub widths: Vec<f64>,
    /// Weights w of the basis functions [B x D].
    pub weights: DMatrix<f64>,
    /// Whether the column's force is scaled by g - y(0) `[D]`.
    pub scaled: Vec<bool>,
    /// The start of each training sequence.
    pub starts: Vec<DiscreteStart>,
    /// Numbers of columns D_i of the parts, in order.
    pub columns: Vec<usize>,
}

impl DmpDiscrete {
    /// Learns `bases` weights for each column. The trials are aligned first: recordings of one movement start
    /// at different phases, and forces of different phases must not be averaged.
    ///
    /// # Errors
    ///
    /// When the regression cannot be solved.
    pub fn fit(trials: &[Trial], columns: &[usize], bases: usize) -> Result<Self, NumericsError> {
        let alpha_x = ALPHA_X;
        // The distances are equal in time, and so they shrink in x.
        let centre = |b: usize| (-alpha_x * b as f64 / bases.saturating_sub(1).max(1) as f64).exponential();
        let centres: Vec<f64> = (0..bases).map(centre).collect();
        let width = |b: usize| {
            let distance = if b + 1 < bases {
                centre(b) - centre(b + 1)
            } else {
                centre(b.saturating_sub(1)) - centre(b)
            };
            0.5 / (OVERLAP * if distance > 0.0 { distance } else { 1.0 }).powi(2)
        };
        let widths: Vec<f64> = (0..bases).map(width).collect();
        let alignment = Alignment::new(trials, Some(PhaseAxis::Trial));
        let start = |(trial, map): (&Trial, &PhaseMap)| DiscreteStart {
            map: *map,
            spring: SpringStart::at_first_frame(&trial.y),
        };
        let whole: Vec<&DMatrix<f64>> = trials.iter().filter(|t| t.whole).map(|t| &t.y).collect();
        let d = trials.first().map_or(0, |t| t.y.ncols());
        let count = whole.len().max(1) as f64;
        let end = |y: &DMatrix<f64>| y.row(y.nrows() - 1).transpose();
        let mut model = Self {
            goal: whole.iter().map(|y| end(y)).fold(DVector::zeros(d), |sum, g| sum + g) / count,
            alpha_x,
            centres,
            widths,
            weights: DMatrix::zeros(bases, d),
            scaled: (0..d).map(|k| clear_way(&whole, k)).collect(),
            starts: trials.iter().zip(&alignment.maps).map(start).collect(),
            columns: columns.to_vec(),
        };

        let mut plain = (DMatrix::zeros(bases, bases), DMatrix::zeros(bases, d));
        let mut scaled: Vec<_> =
            (0..d).map(|_| (DMatrix::zeros(bases, bases), DMatrix::zeros(bases, 1))).collect();
        for (trial, map) in trials.iter().zip(&alignment.maps).filter(|(trial, _)| trial.whole) {
            let y = &trial.y;
            // A scaled column has the goal of its trial, any other column the goal of the rollout.
            let own = end(y);
            let goal = DVector::from_fn(d, |k, _| if model.scaled[k] { own[k] } else { model.goal[k] });
            let curve = Curve::new(y);
            let target = curve.forces(&goal, 1.0 / map.rate);
            let phases = curve.times().into_iter().map(|t| map.start + map.rate * t);
            let rows: Vec<_> = phases.map(|phase| model.features(phase).transpose()).collect();
            let features = DMatrix::from_rows(&rows);
            let (gram, moment) = (features.tr_mul(&features), features.tr_mul(&target));
            for k in (0..d).filter(|&k| model.scaled[k]) {
                let s = goal[k] - y[(0, k)];
                scaled[k].0 += &gram * (s * s);
                scaled[k].1 += moment.column(k) * s;
            }
            plain.0 += gram;
            plain.1 += moment;
        }
        model.weights = regress(&plain.0, &plain.1)?;
        for k in (0..d).filter(|&k| model.scaled[k]) {
            model.weights.set_column(k, &regress(&scaled[k].0, &scaled[k].1)?.column(0));
        }
        Ok(model)
    }

    /// x psi_b(x) / sum psi at `phase` = t / tau `[B]`.
    fn features(&self, phase: f64) -> DVector<f64> {
        let x = (-self.alpha_x * phase).exponential();
        let exponents =
            DVector::from_fn(self.centres.len(), |b, _| -self.widths[b] * (x - self.centres[b]).powi(2));
        // The largest exponent is subtracted first, so that the ratio is finite far from all centres.
        let largest = exponents.max();
        let psi = exponents.map(|e| (e - largest).exponential());
        let sum = psi.sum();
        psi * (x / sum)
    }

    /// The movement from the start of a training sequence, under `handles` of centred columns in the order of the
    /// parts: all columns, centred [frames x D].
    ///
    /// Its speed is the mean speed of the training trials; after their end it stays at the goal.
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
        let goal = &handles.moved(&self.goal);
        let rate = start.map.rate * handles.tempo;
        let spring = &start.spring;
        // y(0), from which the way is measured; the integration pushes it, too.
        let way = goal - &spring.position - handles.push_at(0).unwrap_or(DVector::zeros(goal.len()));
        let scale = DVector::from_fn(goal.len(), |k, _| if self.scaled[k] { way[k] } else { 1.0 });
        Ok(integrate(
            &spring.position,
            &(&spring.velocity * handles.tempo),
            goal,
            1.0 / rate,
            frames,
            handles,
            |t, out| {
                let phase = start.map.start + rate * t;
                if phase > 1.0 {
                    // After the end of all trials, no force is known; the spring alone goes to the goal.
                    return out.fill(0.0);
                }
                out.copy_from(&self.weights.tr_mul(&self.features(phase)));
                out.component_mul_assign(&scale);
            },
        ))
    }

    /// The number of stored numbers from which one sequence can be rolled out: weights, goal, y(0), y'(0),
    /// start and rate of one sequence, which columns are scaled, and alpha_x.
    pub fn stored_numbers(&self) -> usize {
        self.weights.len() + 4 * self.goal.len() + 3
    }
}

/// Whether column `k` goes the same way by a clear part of its range in all trials.
fn clear_way(trials: &[&DMatrix<f64>], k: usize) -> bool {
    let way = |y: &DMatrix<f64>| y[(y.nrows() - 1, k)] - y[(0, k)];
    let clear = |y: &DMatrix<f64>| {
        let range = y.column(k).max() - y.column(k).min();
        range > 0.0 && way(y).abs() >= CLEAR_WAY * range
    };
    trials.iter().all(|y| clear(y) && (way(y) > 0.0) == (way(trials[0]) > 0.0))
}
