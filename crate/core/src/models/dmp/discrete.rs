//! Dynamic movement primitives towards a goal: their regression.

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::models::data::phase::{Alignment, PhaseAxis, Trial};
use crate::models::dmp::model::{Canonical, Dmp, DmpStart};
use crate::models::dmp::spring::{ALPHA_Z, Curve, OVERLAP, regress};
use nalgebra::{DMatrix, DVector};

/// A column is scaled by g - y(0) only if that is at least this share of its range in every whole trial, with
/// the same sign in all.
const CLEAR_WAY: f64 = 0.25;
/// Decay rate of x: alpha_z / 3, as in Ijspeert et al.
const ALPHA_X: f64 = ALPHA_Z / 3.0;

impl Dmp {
    /// Learns `bases` weights for each column. The trials are aligned first: recordings of one movement start
    /// at different phases, and forces of different phases must not be averaged.
    ///
    /// # Errors
    ///
    /// When the regression cannot be solved.
    pub fn discrete(trials: &[Trial], columns: &[usize], bases: usize) -> Result<Self, NumericsError> {
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
        let whole: Vec<&DMatrix<f64>> = trials.iter().filter(|t| t.whole).map(|t| &t.y).collect();
        let d = trials.first().map_or(0, |t| t.y.ncols());
        let count = whole.len().max(1) as f64;
        let end = |y: &DMatrix<f64>| y.row(y.nrows() - 1).transpose();
        let scaled: Vec<bool> = (0..d).map(|k| clear_way(&whole, k)).collect();
        let mut model = Self {
            canonical: Canonical::Discrete { alpha_x, centres, widths, scaled: scaled.clone() },
            goal: whole.iter().map(|y| end(y)).fold(DVector::zeros(d), |sum, g| sum + g) / count,
            weights: DMatrix::zeros(bases, d),
            starts: trials.iter().zip(&alignment.maps).map(DmpStart::new).collect(),
            columns: columns.to_vec(),
        };

        let mut plain = (DMatrix::zeros(bases, bases), DMatrix::zeros(bases, d));
        let mut of_scaled: Vec<_> =
            (0..d).map(|_| (DMatrix::zeros(bases, bases), DMatrix::zeros(bases, 1))).collect();
        for (trial, map) in trials.iter().zip(&alignment.maps).filter(|(trial, _)| trial.whole) {
            let y = &trial.y;
            // A scaled column has the goal of its trial, any other column the goal of the rollout.
            let own = end(y);
            let goal = DVector::from_fn(d, |k, _| if scaled[k] { own[k] } else { model.goal[k] });
            let curve = Curve::new(y);
            let target = curve.forces(&goal, 1.0 / map.rate);
            let features = model.features_along(&curve, map);
            let (gram, moment) = (features.tr_mul(&features), features.tr_mul(&target));
            for k in (0..d).filter(|&k| scaled[k]) {
                let s = goal[k] - y[(0, k)];
                of_scaled[k].0 += &gram * (s * s);
                of_scaled[k].1 += moment.column(k) * s;
            }
            plain.0 += gram;
            plain.1 += moment;
        }
        model.weights = regress(&plain.0, &plain.1)?;
        for k in (0..d).filter(|&k| scaled[k]) {
            model.weights.set_column(k, &regress(&of_scaled[k].0, &of_scaled[k].1)?.column(0));
        }
        Ok(model)
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
