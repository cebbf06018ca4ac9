//! The log posterior density of point latents and hyperparameters, up to a constant, and its gradient.
//!
//! log p = sum_i log N(Y^i; 0, K^i + beta^i I) + sum_i log N(x^i_t, t >= p; 0, sum_j w_ji^2 K^{ji} + alpha^i
//! I) + sum over t < p of log N(x^i_t; 0, I)
//!
//! Wang et al. (2008, 9 to 11) with the product of experts of Velychko et al. (2018, equations 1 and 2): the
//! functions f^{ji} are marginalised, so the covariances of the experts into a part add up to one over all
//! frames with a history. The prior of the hyperparameters is flat inside their boxes; that of Wang et al. is
//! 1 / theta, a difference of a few nats in thousands.
//!
//! Wang et al. add a linear term to the kernel of the dynamics, theta^{ji} x^j_{-t} . x^j_{-t'}.
//!
//! A part has many more observed columns than latent ones, so its pose map may dominate its dynamics. The
//! balanced GPDM (Urtasun, Fleet & Fua 2006) raises the density of the dynamics into part i to the power D_i
//! / Q_i.

use crate::elementary::Elementary;
use crate::gp::linalg::Factor;
use crate::gp::{Kernel, NumericsError};
use crate::models::data::sequences::Sequences;
use crate::models::map::exact_gp::{log_density, log_density_and_adjoint};
use crate::models::map::params::MapParams;
use crate::models::rollout::couplings::coupling_weights;
use nalgebra::DMatrix;
use std::f64::consts::TAU;

const POSES: &str = "covariance of the poses";
const DYNAMICS: &str = "covariance of the dynamics";

/// The terms of the log density, in nats.
#[derive(Clone, Debug, PartialEq)]
pub struct MapTerms {
    /// The pose map of each part `[M]`.
    pub kinematics: Vec<f64>,
    /// The dynamics into each part `[M]`, balanced if the settings say so.
    pub dynamics: Vec<f64>,
    /// The prior of the first p frames of every sequence.
    pub initial: f64,
}

impl MapTerms {
    /// The log density.
    pub fn total(&self) -> f64 {
        self.kinematics.iter().sum::<f64>() + self.dynamics.iter().sum::<f64>() + self.initial
    }
}

/// The log density of given observations: centred columns, divided into sequences.
#[derive(Clone, Debug)]
pub struct LogDensity {
    y: Vec<DMatrix<f64>>,
    sequences: Sequences,
    balanced: bool,
}

/// The dynamics of a model.
pub(super) struct Dynamics<'a> {
    /// Kernels `kernels[source][target]`.
    pub kernels: &'a [Vec<Kernel>],
    /// Variances of the linear terms [M x M], or [0 x 0].
    pub linear: &'a DMatrix<f64>,
    /// Coupling variances [M x M].
    pub alpha: &'a DMatrix<f64>,
}

impl<'a> From<&'a MapParams> for Dynamics<'a> {
    fn from(params: &'a MapParams) -> Self {
        Self { kernels: &params.dynamics, linear: &params.linear, alpha: &params.alpha }
    }
}

impl Dynamics<'_> {
    /// C_i^-1 x^i of every part [R x Q_i], C_i the covariance of the dynamics into it.
    pub fn coefficients(
        &self,
        sequences: &Sequences,
        latents: &[&DMatrix<f64>],
    ) -> Result<Vec<DMatrix<f64>>, NumericsError> {
        let histories: Vec<DMatrix<f64>> = latents.iter().map(|x| sequences.windows(x)).collect();
        let solve = |(i, x): (usize, &&DMatrix<f64>)| {
            let covariance = self.covariance(&histories, i).covariance;
            Ok(Factor::of_large(&covariance, DYNAMICS)?.solve(&sequences.lagged(x, 0)))
        };
        latents.iter().enumerate().map(solve).collect()
    }

    fn covariance(&self, histories: &[DMatrix<f64>], i: usize) -> DynamicsCovariance {
        let (noise, weights) = coupling_weights(self.alpha.column(i).as_slice());
        let rows = histories[0].nrows();
        let mut covariance = DMatrix::zeros(rows, rows);
        add_to_diagonal(&mut covariance, noise);
        let kernels: Vec<DMatrix<f64>> =
            histories.iter().zip(self.kernels).map(|(h, k)| k[i].inducing_covariance(h, 0.0)).collect();
        for (j, (k, w)) in kernels.iter().zip(&weights).enumerate() {
            covariance.zip_apply(k, |c, k| *c += w * w * k);
            if let Some(theta) = self.linear.get((j, i)) {
                covariance.gemm(w * w * theta, &histories[j], &histories[j].transpose(), 1.0);
            }
        }
        DynamicsCovariance { weights, noise, kernels, covariance }
    }
}

/// The covariance of the dynamics into one part.
struct DynamicsCovariance {
    /// w_ji.
    weights: Vec<f64>,
    /// alpha^i.
    noise: f64,
    /// K^{ji} by source [R x R].
    kernels: Vec<DMatrix<f64>>,
    /// sum_j w_ji^2 K^{ji} + alpha^i I [R x R].
    covariance: DMatrix<f64>,
}

impl LogDensity {
    /// `y[i]` are the centred observations of part i [N x D_i], with as many rows as the sequences have
    /// frames. `balanced`: the log density of the dynamics into part i is multiplied by D_i / Q_i.
    pub fn new(y: Vec<DMatrix<f64>>, sequences: Sequences, balanced: bool) -> Self {
        Self { y, sequences, balanced }
    }

    /// The factor of the log density of the dynamics into part i.
    fn balance(&self, params: &MapParams, i: usize) -> f64 {
        if self.balanced { self.y[i].ncols() as f64 / params.parts[i].latents.ncols() as f64 } else { 1.0 }
    }

    /// The sequences.
    pub fn sequences(&self) -> &Sequences {
        &self.sequences
    }

    /// The centred observations of each part [N x D_i].
    pub fn observations(&self) -> &[DMatrix<f64>] {
        &self.y
    }

    /// The terms of the log density at `params`.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised, or the density is not finite.
    pub fn terms(&self, params: &MapParams) -> Result<MapTerms, NumericsError> {
        let histories = self.histories(params);
        let (mut kinematics, mut dynamics) = (Vec::new(), Vec::new());
        for (i, part) in params.parts.iter().enumerate() {
            kinematics.push(log_density(&self.poses(params, i), &self.y[i], POSES)?);
            let targets = self.sequences.lagged(&part.latents, 0);
            let covariance = Dynamics::from(params).covariance(&histories, i).covariance;
            dynamics.push(self.balance(params, i) * log_density(&covariance, &targets, DYNAMICS)?);
        }
        finite(MapTerms { kinematics, dynamics, initial: self.initial(params) })
    }

    /// The terms at `params` and the gradient of their sum with respect to the natural parameters.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised, or the density is not finite.
    pub fn terms_and_gradient(&self, params: &MapParams) -> Result<(MapTerms, MapParams), NumericsError> {
        let mut gradient = params.zeros_like();
        let histories = self.histories(params);
        let (mut kinematics, mut dynamics) = (Vec::new(), Vec::new());
        for i in 0..params.part_count() {
            kinematics.push(self.poses_gradient(params, i, &mut gradient)?);
            dynamics.push(self.dynamics_gradient(params, &histories, i, &mut gradient)?);
        }
        for (into, part) in gradient.parts.iter_mut().zip(&params.parts) {
            for t in self.sequences.initial_frames() {
                let mut row = into.latents.row_mut(t);
                row -= part.latents.row(t);
            }
        }
        Ok((finite(MapTerms { kinematics, dynamics, initial: self.initial(params) })?, gradient))
    }

    /// (K^i + beta^i I)^-1 Y^i of every part [N x D_i]: the coefficients of the poses.
    pub(super) fn pose_coefficients(&self, params: &MapParams) -> Result<Vec<DMatrix<f64>>, NumericsError> {
        let solve = |i| Factor::of_large(&self.poses(params, i), POSES).map(|f| f.solve(&self.y[i]));
        (0..params.part_count()).map(solve).collect()
    }

    fn histories(&self, params: &MapParams) -> Vec<DMatrix<f64>> {
        params.parts.iter().map(|part| self.sequences.windows(&part.latents)).collect()
    }

    fn initial(&self, params: &MapParams) -> f64 {
        let rows =
            params.parts.iter().flat_map(|part| self.sequences.initial_frames().map(|t| part.latents.row(t)));
        rows.map(|row| -0.5 * (row.len() as f64 * TAU.logarithm() + row.norm_squared())).sum()
    }

    fn poses(&self, params: &MapParams, i: usize) -> DMatrix<f64> {
        let part = &params.parts[i];
        let mut covariance = part.kernel.inducing_covariance(&part.latents, 0.0);
        add_to_diagonal(&mut covariance, part.beta);
        covariance
    }

    fn poses_gradient(
        &self,
        params: &MapParams,
        i: usize,
        gradient: &mut MapParams,
    ) -> Result<f64, NumericsError> {
        let part = &params.parts[i];
        let mut covariance = self.poses(params, i);
        let (value, mut adjoint) = log_density_and_adjoint(&covariance, &self.y[i], POSES)?;
        add_to_diagonal(&mut covariance, -part.beta);
        let into = &mut gradient.parts[i];
        into.beta += adjoint.covariance.trace();
        let kernel = part.kernel.covariance_adjoint(&part.latents, &covariance, &mut adjoint.covariance);
        into.latents += kernel.z;
        into.kernel.lambda += kernel.lambda;
        into.kernel.variance += kernel.variance;
        Ok(value)
    }

    fn dynamics_gradient(
        &self,
        params: &MapParams,
        histories: &[DMatrix<f64>],
        i: usize,
        gradient: &mut MapParams,
    ) -> Result<f64, NumericsError> {
        let DynamicsCovariance { weights, noise, kernels, covariance } =
            Dynamics::from(params).covariance(histories, i);
        let targets = self.sequences.lagged(&params.parts[i].latents, 0);
        let (value, mut adjoint) = log_density_and_adjoint(&covariance, &targets, DYNAMICS)?;
        let balance = self.balance(params, i);
        adjoint.covariance *= balance;
        adjoint.targets *= balance;
        self.sequences.add_targets_adjoint(&adjoint.targets, &mut gradient.parts[i].latents);
        let mut weights_adjoint = Vec::new();
        for (j, w) in weights.iter().enumerate() {
            let kernel: &Kernel = &params.dynamics[j][i];
            let mut df_dk = &adjoint.covariance * (w * w);
            // dF/dtheta and dF/dx of the linear term, before `covariance_adjoint` overwrites dF/dk.
            let linear = params.linear_term(j, i).map(|theta| {
                let pull = &df_dk * &histories[j];
                (theta, histories[j].dot(&pull), pull)
            });
            let from = kernel.covariance_adjoint(&histories[j], &kernels[j], &mut df_dk);
            // The sum of dF/dk k is the derivative with respect to the logarithm of the signal variance; w^2
            // scales the kernel in the same way.
            weights_adjoint.push(2.0 * from.variance * kernel.variance / w);
            self.sequences.add_windows_adjoint(&from.z, &mut gradient.parts[j].latents);
            if let Some((theta, slope, pull)) = linear {
                gradient.linear[(j, i)] += slope;
                weights_adjoint[j] += 2.0 * theta * slope / w;
                self.sequences.add_windows_adjoint(&(pull * (2.0 * theta)), &mut gradient.parts[j].latents);
            }
            gradient.dynamics[j][i].lambda += from.lambda;
        }
        let noise_adjoint = adjoint.covariance.trace();
        // d alpha^i / d alpha^{ji} = w_j^2 and d w_k / d alpha^{ji} = w_k w_j^2 / alpha^i - [j = k] w_j /
        // alpha^{ji}.
        let shared: f64 = weights_adjoint.iter().zip(&weights).map(|(g, w)| g * w).sum();
        for (j, (w, g)) in weights.iter().zip(&weights_adjoint).enumerate() {
            gradient.alpha[(j, i)] += w * w * (noise_adjoint + shared / noise) - g * w / params.alpha[(j, i)];
        }
        Ok(balance * value)
    }
}

fn add_to_diagonal(matrix: &mut DMatrix<f64>, value: f64) {
    for k in 0..matrix.nrows() {
        matrix[(k, k)] += value;
    }
}

fn finite(terms: MapTerms) -> Result<MapTerms, NumericsError> {
    if terms.total().is_finite() { Ok(terms) } else { Err(NumericsError::NotFinite { what: "log density" }) }
}

#[cfg(test)]
pub(super) mod tests;
