//! The filter of one part with a linear pose map and linear dynamics against the textbook's Kalman filter and
//! smoother (Kalman 1960; Rauch, Tung and Striebel 1965).
//!
//! No squared exponential kernel makes an exactly linear map. Eight inducing points on a circle of two
//! lengthscales L make one whose terms of second, third and fourth order in x / L are zero; that of fifth order
//! is 0.04 (|x| / L)^4 of the linear one. With L = 300 this is less than 1e-8 where |x| < 6, and the rounding
//! errors, which grow with L^2, are less than 1e-10. So the filters agree to 1e-7, not to the last digits.
//!
//! With the covariance K of the prior, the inducing outputs take away no variance: each map has the same
//! variance everywhere, its signal variance.

use crate::gp::Kernel;
use crate::models::rollout::couplings::Reading;
use crate::models::training::pose_weight::PoseWeight;
use crate::models::training::progress::BoundTerms;
use crate::models::variational::elbo::DynamicsSums;
use crate::models::variational::maps::{FittedExpert, PoseMap};
use crate::models::variational::model::Vcgpdm;
use crate::models::variational::moments::{Belief, LatentMoments};
use approx::assert_abs_diff_eq;
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::{E, PI, TAU};

const LENGTHSCALE: f64 = 300.0;
const TOLERANCE: f64 = 1e-7;

/// x_{t+1} = a x_t + N(0, q I) and y_t = c x_t + N(0, r I).
struct LinearSystem {
    a: DMatrix<f64>,
    c: DMatrix<f64>,
    q: f64,
    r: f64,
}

/// Inducing inputs, kernel, and means and covariance of the inducing outputs of a map that is nearly x -> m x.
fn linear_map(m: &DMatrix<f64>, variance: f64) -> (DMatrix<f64>, Kernel, DMatrix<f64>, DMatrix<f64>) {
    let directions = DMatrix::from_fn(8, 2, |k, axis| (0.25 * PI * k as f64 - 0.5 * PI * axis as f64).cos());
    let z = &directions * (2.0 * LENGTHSCALE);
    let kernel = Kernel { lambda: DVector::from_element(2, LENGTHSCALE.powi(2)), variance };
    let k = kernel.inducing_covariance(&z, 0.0);
    let coefficients = directions * m.transpose() * (LENGTHSCALE * E.powi(2) / (8.0 * variance));
    (z, kernel, &k * coefficients, k)
}

impl LinearSystem {
    /// A damped rotation, seen in three columns.
    fn new() -> Self {
        let (sin, cos) = 0.4_f64.sin_cos();
        let a = 0.8 * DMatrix::from_row_slice(2, 2, &[cos, -sin, sin, cos]);
        let c = DMatrix::from_row_slice(3, 2, &[1.0, 0.2, -0.5, 0.7, 0.3, 0.9]);
        // The signal variance of an expert is 1, and 0.05 is the coupling; the pose map has 0.3 + 0.1.
        Self { a, c, q: 1.05, r: 0.4 }
    }

    /// The same system as a model of one part.
    fn model(&self) -> Vcgpdm {
        let (r, kernel, mean, covariance) = linear_map(&self.c, 0.3);
        let pose_map = PoseMap::new(r, kernel, 0.1, mean, covariance, 0.0).unwrap();
        let (z, kernel, mean, covariance) = linear_map(&self.a, 1.0);
        let nothing = DynamicsSums { psi2: DMatrix::zeros(8, 8), psi1_mu: DMatrix::zeros(8, 2) };
        Vcgpdm {
            order: 1,
            jitter: 0.0,
            parts: vec![pose_map],
            experts: vec![vec![FittedExpert::new(z, kernel, mean, 0.0).unwrap()]],
            dynamics_covariance: vec![covariance],
            sums: vec![nothing],
            external: Vec::new(),
            alpha: DMatrix::from_element(1, 1, 0.05),
            starts: vec![vec![DMatrix::zeros(1, 2)]],
            terms: BoundTerms { kinematics: vec![0.0], dynamics: vec![0.0], initial: 0.0, entropy: 0.0 },
        }
    }

    /// Columns [frames x 3] drawn from the system. One frame is missing, and some single numbers.
    fn columns(&self, frames: usize) -> DMatrix<f64> {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let mut noise = |n: usize, variance: f64| {
            DVector::from_fn(n, |_, _| {
                let value: f64 = StandardNormal.sample(&mut rng);
                value * variance.sqrt()
            })
        };
        let mut x = noise(2, 1.0);
        let mut y = DMatrix::zeros(frames, 3);
        for t in 0..frames {
            y.set_row(t, &(&self.c * &x + noise(3, self.r)).transpose());
            x = &self.a * x + noise(2, self.q);
        }
        y.row_mut(7).fill(f64::NAN);
        y[(0, 1)] = f64::NAN;
        y[(12, 0)] = f64::NAN;
        y[(12, 2)] = f64::NAN;
        y
    }

    /// Beliefs after each frame and after all frames, and the log density of the columns.
    fn kalman(&self, y: &DMatrix<f64>) -> (Vec<Belief>, Vec<Belief>, f64) {
        let mut predicted = vec![Belief { mean: DVector::zeros(2), covariance: DMatrix::identity(2, 2) }];
        let mut filtered: Vec<Belief> = Vec::new();
        let mut evidence = 0.0;
        for t in 0..y.nrows() {
            let Belief { mean, covariance } = predicted[t].clone();
            let seen: Vec<usize> = (0..3).filter(|&c| !y[(t, c)].is_nan()).collect();
            let c = self.c.select_rows(&seen);
            let error = DVector::from_fn(seen.len(), |k, _| y[(t, seen[k])]) - &c * &mean;
            let s = &c * &covariance * c.transpose() + DMatrix::identity(seen.len(), seen.len()) * self.r;
            let inverse = s.clone().try_inverse().unwrap();
            evidence -= 0.5 * (error.dot(&(&inverse * &error)) + (s * TAU).determinant().ln());
            let gain = &covariance * c.transpose() * inverse;
            let (mean, covariance) = (mean + &gain * error, &covariance - &gain * c * &covariance);
            let next = &self.a * &covariance * self.a.transpose() + DMatrix::identity(2, 2) * self.q;
            predicted.push(Belief { mean: &self.a * &mean, covariance: next });
            filtered.push(Belief { mean, covariance });
        }
        let mut smoothed = filtered.clone();
        for t in (0..y.nrows() - 1).rev() {
            let (here, next) = (&filtered[t], &predicted[t + 1]);
            let gain = &here.covariance * self.a.transpose() * next.covariance.clone().try_inverse().unwrap();
            smoothed[t] = Belief {
                mean: &here.mean + &gain * (&smoothed[t + 1].mean - &next.mean),
                covariance: &here.covariance
                    + &gain * (&smoothed[t + 1].covariance - &next.covariance) * gain.transpose(),
            };
        }
        (filtered, smoothed, evidence)
    }
}

fn assert_same(found: &LatentMoments, expected: &[Belief]) {
    for (t, belief) in expected.iter().enumerate() {
        let mean = found.means[0].row(t).transpose();
        assert_abs_diff_eq!(mean, belief.mean, epsilon = TOLERANCE);
        assert_abs_diff_eq!(found.covariances[0][t], belief.covariance, epsilon = TOLERANCE);
    }
}

#[test]
fn of_a_linear_system_it_is_the_kalman_filter() {
    let system = LinearSystem::new();
    let model = system.model();
    let y = system.columns(40);
    // The weight of the poses divides the variance of the columns.
    for weight in [1.0, 0.5, 3.0] {
        let filter = model.filter(&model.alpha, Reading::AsLearned, PoseWeight::Fixed(weight)).unwrap();
        let run = filter.run(filter.unknown(), std::slice::from_ref(&y)).unwrap();
        let weighted = LinearSystem { r: system.r / weight, ..LinearSystem::new() };
        let (filtered, smoothed, evidence) = weighted.kalman(&y);
        assert_same(&filter.filtered(&run), &filtered);
        assert_same(&filter.smoothed(&run).unwrap(), &smoothed);
        assert_abs_diff_eq!(run.evidence(), evidence, epsilon = 40.0 * TOLERANCE);
    }
}
