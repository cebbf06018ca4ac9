//! Gaussian process over phase with inducing phases.

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::gp::exp::exp;
use crate::gp::linalg::Factor;
use crate::models::data::phase::PhaseAxis;
use nalgebra::DMatrix;
use std::f64::consts::PI;

/// Distance between inducing phases in lengthscales. A squared exponential has almost no power above the
/// frequency that this resolves.
const SPACING: f64 = 0.7;
/// The most inducing phases on a cycle and on a whole movement. This limits the lengthscale from below.
const MOST_INDUCING: [usize; 2] = [30, 48];
const FEWEST_INDUCING: usize = 5;
/// Added to the diagonal of the inducing covariance.
const JITTER: f64 = 1e-8;

/// A squared exponential of variance 1 over phase, with regularly spaced inducing phases.
///
/// On [`PhaseAxis::Trial`], k(p, p') = exp(-(p - p')^2 / (2 l^2)). On [`PhaseAxis::Cycle`] the same of the
/// chord between the two places on a circle of circumference 1: (p - p') becomes sin(pi (p - p')) / pi.
#[derive(Clone, Debug)]
pub struct PhaseKernel {
    /// Meaning of the phase.
    pub axis: PhaseAxis,
    /// l, in units of phase.
    pub lengthscale: f64,
    /// Inducing phases `[R]`.
    pub inducing: Vec<f64>,
    factor: Factor,
}

impl PhaseKernel {
    /// A kernel for phases in `range` (0 to 1 on a cycle).
    pub fn new(axis: PhaseAxis, lengthscale: f64, range: (f64, f64)) -> Result<Self, NumericsError> {
        let inducing: Vec<f64> = match axis {
            PhaseAxis::Cycle => {
                let count = ((1.0 / (SPACING * lengthscale)).ceil() as usize).max(FEWEST_INDUCING);
                (0..count).map(|r| r as f64 / count as f64).collect()
            }
            PhaseAxis::Trial => {
                // One beyond each end, where the data are on one side only.
                let step = SPACING * lengthscale;
                let count = (((range.1 - range.0) / step).ceil() as usize + 3).max(FEWEST_INDUCING);
                let first = 0.5 * (range.0 + range.1 - step * (count - 1) as f64);
                (0..count).map(|r| first + step * r as f64).collect()
            }
        };
        Self::with_inducing(axis, lengthscale, inducing)
    }

    /// A kernel with these inducing phases.
    fn with_inducing(axis: PhaseAxis, lengthscale: f64, inducing: Vec<f64>) -> Result<Self, NumericsError> {
        let n = inducing.len();
        let k = DMatrix::from_fn(n, n, |a, b| {
            covariance(axis, lengthscale, inducing[a] - inducing[b]) + if a == b { JITTER } else { 0.0 }
        });
        let factor = Factor::new(&k, "covariance of the inducing phases")?;
        Ok(Self { axis, lengthscale, inducing, factor })
    }

    /// The smallest lengthscale that the inducing phases can follow.
    pub fn shortest(axis: PhaseAxis, range: (f64, f64)) -> f64 {
        let length = if axis == PhaseAxis::Cycle { 1.0 } else { range.1 - range.0 };
        length / (SPACING * (MOST_INDUCING[usize::from(axis == PhaseAxis::Trial)] - 3) as f64)
    }

    /// P = K_pz L^-T [T x R] with K_zz = L L^T: the process at `phases` is P v plus a residual, v ~ N(0, I).
    pub fn features(&self, phases: &[f64]) -> DMatrix<f64> {
        let cross = DMatrix::from_fn(self.inducing.len(), phases.len(), |r, t| {
            covariance(self.axis, self.lengthscale, self.inducing[r] - phases[t])
        });
        self.factor.solve_lower(&cross).transpose()
    }

    /// K_zz^-1 L v = L^-T v: the factors of the covariances with the inducing phases in a prediction [R x Q].
    pub fn coefficients(&self, v: &DMatrix<f64>) -> DMatrix<f64> {
        self.factor.solve_upper(v)
    }
}

/// k at a difference of phases.
pub fn covariance(axis: PhaseAxis, lengthscale: f64, difference: f64) -> f64 {
    let d = match axis {
        PhaseAxis::Trial => difference,
        PhaseAxis::Cycle => (PI * difference).sine() / PI,
    };
    exp(-0.5 * (d / lengthscale).powi(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inducing_phases_reproduce_the_kernel() {
        for (axis, lengthscale) in
            [(PhaseAxis::Trial, 0.05), (PhaseAxis::Cycle, 0.05), (PhaseAxis::Cycle, 0.15)]
        {
            let kernel = PhaseKernel::new(axis, lengthscale, (-0.1, 1.1)).unwrap();
            let phases: Vec<f64> = (0..97).map(|t| -0.1 + 1.2 * f64::from(t) / 96.0).collect();
            let p = kernel.features(&phases);
            let k = DMatrix::from_fn(97, 97, |a, b| covariance(axis, lengthscale, phases[a] - phases[b]));
            let worst = (&p * p.transpose() - k).amax();
            assert!(worst < 2e-3, "{axis:?} {lengthscale}: {worst} with {}", kernel.inducing.len());
        }
    }

    #[test]
    fn coefficients_and_features_give_the_same_prediction() {
        let kernel = PhaseKernel::new(PhaseAxis::Cycle, 0.1, (0.0, 1.0)).unwrap();
        let v = DMatrix::from_fn(kernel.inducing.len(), 2, |r, q| ((r * 2 + q) as f64).sin());
        let phases = [0.03, 0.4, 1.2];
        let cross = DMatrix::from_fn(3, kernel.inducing.len(), |t, r| {
            covariance(PhaseAxis::Cycle, 0.1, phases[t] - kernel.inducing[r])
        });
        let difference = cross * kernel.coefficients(&v) - kernel.features(&phases) * &v;
        assert!(difference.amax() < 1e-8, "{difference}");
    }

    #[test]
    fn the_shortest_lengthscale_needs_at_most_the_most_inducing_phases() {
        for (axis, range, most) in [
            (PhaseAxis::Cycle, (0.0, 1.0), 30),
            (PhaseAxis::Trial, (0.0, 1.0), 48),
            (PhaseAxis::Trial, (-0.5, 1.5), 48),
        ] {
            let kernel = PhaseKernel::new(axis, PhaseKernel::shortest(axis, range), range).unwrap();
            let count = kernel.inducing.len();
            assert!(count <= most && count + 4 > most, "{axis:?} {range:?}: {count}");
        }
    }
}
