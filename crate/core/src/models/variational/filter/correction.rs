//! The correction of a belief by the observed columns of a frame.

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetrise};
use crate::models::variational::filter::pose_process::{PoseProcess, Tangent};
use crate::models::variational::moments::{Belief, select};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Gauss-Newton steps at most; three are usual.
const MOST_STEPS: usize = 20;
/// A step that is shorter than this share of a standard deviation is the last one.
const SHORT: f64 = 1e-4;
/// A step that does not lower the objective is halved so often.
const MOST_HALVINGS: usize = 12;

/// A part with observed columns.
pub(super) struct Observed<'a> {
    pub(super) map: &'a PoseProcess,
    /// The power of the likelihood.
    pub(super) weight: f64,
    /// The places of its latents in the belief `[Q_i]`.
    pub(super) places: Vec<usize>,
    /// The observed columns, and their numbers.
    pub(super) columns: Vec<usize>,
    pub(super) values: Vec<f64>,
}

/// The Gaussian of some latents s in a belief: s = mean + L u with u ~ N(0, I).
struct Prior {
    mean: DVector<f64>,
    /// L, lower triangular.
    root: DMatrix<f64>,
    /// cov(h, s) L^-T: the whole belief changes by this matrix times the change of u.
    reach: DMatrix<f64>,
}

impl Prior {
    fn new(belief: &Belief, places: &[usize]) -> Result<Self, NumericsError> {
        let factor = Factor::new(&select(&belief.covariance, places), "covariance of the predicted latents")?;
        // cov(s, h), then L^-1 cov(s, h).
        let mut reach =
            DMatrix::from_fn(places.len(), belief.mean.len(), |a, h| belief.covariance[(places[a], h)]);
        factor.solve_lower_mut(&mut reach);
        let mean = DVector::from_fn(places.len(), |a, _| belief.mean[places[a]]);
        Ok(Self { mean, root: factor.lower(), reach: reach.transpose() })
    }

    /// Replaces u ~ N(0, I) in the belief by N(u, I - `known`).
    fn condition(&self, belief: &mut Belief, u: &DVector<f64>, known: &DMatrix<f64>) {
        belief.mean += &self.reach * u;
        belief.covariance -= &self.reach * known * self.reach.transpose();
        symmetrise(&mut belief.covariance);
        for k in 0..belief.covariance.nrows() {
            belief.covariance[(k, k)] = belief.covariance[(k, k)].max(0.0);
        }
    }
}

/// Corrects the belief by these parts, and returns log p(y), in nats, by Laplace's method.
pub(super) fn correct(belief: &mut Belief, parts: &[Observed]) -> Result<f64, NumericsError> {
    let places: Vec<usize> = parts.iter().flat_map(|part| part.places.clone()).collect();
    if places.is_empty() {
        return Ok(0.0);
    }
    let prior = Prior::new(belief, &places)?;
    let mut u = DVector::zeros(places.len());
    let mut at = Linearised::new(parts, &prior, &u);
    for _ in 0..MOST_STEPS {
        let precision = at.precision(&prior);
        let factor = Factor::new(&precision, "precision of the corrected latents")?;
        let mut step = DMatrix::from_column_slice(u.len(), 1, (&at.pull - &u).as_slice());
        factor.solve_mut(&mut step);
        let step = step.column(0).into_owned();
        // In standard deviations of the corrected latents.
        let length = (&precision * &step).dot(&step).sqrt();
        let before = at.misfit(&at, &u);
        let mut share = 1.0;
        let mut next = Linearised::new(parts, &prior, &(&u + &step));
        for _ in 0..MOST_HALVINGS {
            if at.misfit(&next, &(&u + share * &step)) <= before {
                break;
            }
            share *= 0.5;
            next = Linearised::new(parts, &prior, &(&u + share * &step));
        }
        u += share * step;
        at = next;
        if share * length < SHORT {
            break;
        }
    }
    let mut precision = at.precision(&prior);
    let factor = Factor::new(&precision, "precision of the corrected latents")?;
    let evidence = at.log_likelihood() - 0.5 * (u.norm_squared() + factor.log_determinant());
    factor.inverse_into(&mut precision);
    let known = DMatrix::identity(u.len(), u.len()) - precision;
    prior.condition(belief, &u, &known);
    Ok(evidence)
}

/// Gives latents of the belief these values: what the others have to do with them follows.
pub(super) fn clamp(belief: &mut Belief, places: &[usize], values: &[f64]) -> Result<(), NumericsError> {
    let prior = Prior::new(belief, places)?;
    let mut u = DMatrix::from_fn(places.len(), 1, |k, _| values[k] - prior.mean[k]);
    // The diagonal of a Cholesky factor is positive: there is no division by zero.
    prior.root.solve_lower_triangular_unchecked_mut(&mut u);
    let n = places.len();
    prior.condition(belief, &u.column(0).into_owned(), &DMatrix::identity(n, n));
    for (k, &place) in places.iter().enumerate() {
        belief.mean[place] = values[k];
        belief.covariance.row_mut(place).fill(0.0);
        belief.covariance.column_mut(place).fill(0.0);
    }
    Ok(())
}

/// The pose maps of the observed parts near a point u.
struct Linearised {
    /// Sum of the squared errors of each part, its variance, and the number of its columns.
    errors: Vec<(f64, f64, usize)>,
    /// G R^-1 G^T in the coordinates s, block-diagonal.
    information: DMatrix<f64>,
    /// L^T G R^-1 (y - g).
    pull: DVector<f64>,
}

impl Linearised {
    fn new(parts: &[Observed], prior: &Prior, u: &DVector<f64>) -> Self {
        let s = &prior.mean + &prior.root * u;
        let size = s.len();
        let (mut information, mut pull) = (DMatrix::zeros(size, size), DVector::zeros(size));
        let mut errors = Vec::with_capacity(parts.len());
        let mut at = 0;
        for part in parts {
            let q = part.places.len();
            let Tangent { values, slopes, variance } =
                part.map.tangent(&s.as_slice()[at..at + q], &part.columns);
            let variance = variance / part.weight;
            let error = DVector::from_fn(values.len(), |c, _| part.values[c] - values[c]);
            information.view_mut((at, at), (q, q)).copy_from(&(&slopes * slopes.transpose() / variance));
            pull.rows_mut(at, q).copy_from(&(&slopes * &error / variance));
            errors.push((error.norm_squared(), variance, values.len()));
            at += q;
        }
        Self { errors, information, pull: prior.root.tr_mul(&pull) }
    }

    /// I + L^T G R^-1 G^T L.
    fn precision(&self, prior: &Prior) -> DMatrix<f64> {
        let mut precision = prior.root.tr_mul(&(&self.information * &prior.root));
        symmetrise(&mut precision);
        for k in 0..precision.nrows() {
            precision[(k, k)] += 1.0;
        }
        precision
    }

    /// The objective of a step: the errors of `other` at its point u under the variances here.
    fn misfit(&self, other: &Linearised, u: &DVector<f64>) -> f64 {
        let errors = self.errors.iter().zip(&other.errors);
        errors.map(|(here, there)| there.0 / here.1).sum::<f64>() + u.norm_squared()
    }

    /// log N(y; g, R).
    fn log_likelihood(&self) -> f64 {
        let part = |&(error, variance, columns): &(f64, f64, usize)| {
            error / variance + columns as f64 * (TAU * variance).logarithm()
        };
        -0.5 * self.errors.iter().map(part).sum::<f64>()
    }
}
