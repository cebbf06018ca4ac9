//! Transformation system of all dynamic movement primitives, and the regression of its force.

use crate::gp::NumericsError;
use crate::gp::linalg::Factor;
use crate::models::rollout::request::Handles;
use nalgebra::{DMatrix, DVector};

/// alpha_z and beta_z = alpha_z / 4 of Ijspeert et al. (2013): critically damped.
pub const ALPHA_Z: f64 = 25.0;
const BETA_Z: f64 = ALPHA_Z / 4.0;
/// Ridge of the regression, relative to the mean energy of a basis: large enough to solve, too small to
/// smooth.
const RIDGE: f64 = 1e-6;
/// The largest step of the integration as a share of tau; the time constant of the spring is tau / 12.5.
const LARGEST_STEP: f64 = 0.02;
/// The smallest and largest tau, in frames, so that a frame takes at most 500 steps.
const SHORTEST: f64 = 0.1;
const LONGEST: f64 = 1e6;
/// Number of times from frame to frame at which forces are learned.
const BETWEEN: usize = 4;
/// Width of the bases as a share of the distance between neighbours.
pub const OVERLAP: f64 = 0.65;

/// Position and velocity at the first frame of a sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct SpringStart {
    /// y(0) `[D]`.
    pub position: DVector<f64>,
    /// y'(0), per frame `[D]`.
    pub velocity: DVector<f64>,
}

impl SpringStart {
    /// The springs at the first frame of `y` [T x D].
    pub(super) fn at_first_frame(y: &DMatrix<f64>) -> Self {
        Self { position: y.row(0).transpose(), velocity: Curve::new(y).first_velocity() }
    }
}

/// tau z' = alpha_z (beta_z (g - y) - z) + f, tau y' = z, for all columns, by the classic fourth order
/// Runge-Kutta method with several steps a frame.
///
/// `force(t, out)` fills in f of all columns at time `t`, in frames. `handles` push y. Returns y at 0, 1, ..., frames - 1
/// [frames x D]; `velocity` is y' at 0, per frame.
pub fn integrate(
    start: &DVector<f64>,
    velocity: &DVector<f64>,
    goal: &DVector<f64>,
    tau: f64,
    frames: usize,
    handles: &Handles,
    mut force: impl FnMut(f64, &mut DVector<f64>),
) -> DMatrix<f64> {
    let tau = tau.clamp(SHORTEST, LONGEST);
    let steps = (1.0 / (LARGEST_STEP * tau)).ceil().max(1.0);
    let h = 1.0 / steps;
    let columns = start.len();
    let (mut y, mut z) = (start.clone(), velocity * tau);
    let mut out = DMatrix::zeros(frames, columns);
    let mut forces = [(); 3].map(|()| DVector::zeros(columns));
    for frame in 0..frames {
        if let Some(by) = handles.push_at(frame) {
            y += by;
        }
        out.set_row(frame, &y.transpose());
        if frame + 1 == frames {
            break;
        }
        for step in 0..steps as usize {
            let t = frame as f64 + h * step as f64;
            for (k, out) in forces.iter_mut().enumerate() {
                force(t + 0.5 * h * k as f64, out);
            }
            for k in 0..columns {
                let slope =
                    |y: f64, z: f64, f: f64| (z / tau, (ALPHA_Z * (BETA_Z * (goal[k] - y) - z) + f) / tau);
                let (y1, z1) = slope(y[k], z[k], forces[0][k]);
                let (y2, z2) = slope(y[k] + 0.5 * h * y1, z[k] + 0.5 * h * z1, forces[1][k]);
                let (y3, z3) = slope(y[k] + 0.5 * h * y2, z[k] + 0.5 * h * z2, forces[1][k]);
                let (y4, z4) = slope(y[k] + h * y3, z[k] + h * z3, forces[2][k]);
                y[k] += h / 6.0 * (y1 + 2.0 * y2 + 2.0 * y3 + y4);
                z[k] += h / 6.0 * (z1 + 2.0 * z2 + 2.0 * z3 + z4);
            }
        }
    }
    out
}

/// Cubic spline through the frames of a trial, with parabolas at both ends.
///
/// The derivatives of a spline belong to one curve, so the integrated system reproduces the frames.
/// Differences of neighbouring frames are too small: by a tenth for six waves in a cycle of 34 frames.
pub struct Curve<'a> {
    y: &'a DMatrix<f64>,
    /// y'' at the frames [T x D].
    bends: DMatrix<f64>,
}

impl<'a> Curve<'a> {
    /// The spline through the rows of `y` [T x D], T at least 1.
    pub fn new(y: &'a DMatrix<f64>) -> Self {
        let (frames, columns) = y.shape();
        let mut bends = DMatrix::zeros(frames, columns);
        if frames > 2 {
            // bends_{i-1} + 4 bends_i + bends_{i+1} = 6 (y_{i-1} - 2 y_i + y_{i+1}), the first two and the
            // last two equal.
            let inner = frames - 2;
            let mut diagonal = vec![4.0; inner];
            diagonal[0] += 1.0;
            diagonal[inner - 1] += 1.0;
            for i in 1..inner {
                diagonal[i] -= 1.0 / diagonal[i - 1];
            }
            for k in 0..columns {
                let mut right: Vec<f64> =
                    (1..=inner).map(|i| 6.0 * (y[(i - 1, k)] - 2.0 * y[(i, k)] + y[(i + 1, k)])).collect();
                for i in 1..inner {
                    right[i] -= right[i - 1] / diagonal[i - 1];
                }
                let mut next = 0.0;
                for i in (0..inner).rev() {
                    next = (right[i] - next) / diagonal[i];
                    bends[(i + 1, k)] = next;
                }
                bends[(0, k)] = bends[(1, k)];
                bends[(frames - 1, k)] = bends[(frames - 2, k)];
            }
        }
        Self { y, bends }
    }

    /// Times, in frames, at which forces are learned: several between any two frames, so that narrow bases
    /// are determined too.
    pub fn times(&self) -> Vec<f64> {
        let count = (self.y.nrows() - 1) * BETWEEN + 1;
        (0..count).map(|i| i as f64 / BETWEEN as f64).collect()
    }

    /// y, y' and y'' of column `k` at time `t`, in frames.
    fn at(&self, t: f64, k: usize) -> (f64, f64, f64) {
        let last = self.y.nrows() - 1;
        if last == 0 {
            return (self.y[(0, k)], 0.0, 0.0);
        }
        let i = (t as usize).min(last - 1);
        let (s, r) = (t - i as f64, 1.0 - (t - i as f64));
        let (y0, y1, b0, b1) =
            (self.y[(i, k)], self.y[(i + 1, k)], self.bends[(i, k)], self.bends[(i + 1, k)]);
        (
            r * y0 + s * y1 + ((r * r * r - r) * b0 + (s * s * s - s) * b1) / 6.0,
            y1 - y0 + ((1.0 - 3.0 * r * r) * b0 + (3.0 * s * s - 1.0) * b1) / 6.0,
            r * b0 + s * b1,
        )
    }

    /// y' at the first frame, per frame `[D]`.
    pub fn first_velocity(&self) -> DVector<f64> {
        DVector::from_fn(self.y.ncols(), |k, _| self.at(0.0, k).1)
    }

    /// The force with which the system follows the curve, tau^2 y'' - alpha_z (beta_z (g - y) - tau
    /// y'), at [`Self::times`] [times x D].
    pub fn forces(&self, goal: &DVector<f64>, tau: f64) -> DMatrix<f64> {
        let times = self.times();
        DMatrix::from_fn(times.len(), self.y.ncols(), |i, k| {
            let (y, velocity, acceleration) = self.at(times[i], k);
            tau * tau * acceleration - ALPHA_Z * (BETA_Z * (goal[k] - y) - tau * velocity)
        })
    }
}

/// Ridge regression: the weights w [B x D] with `gram` w = `moment`. These are the sums over frames of the
/// basis functions' products [B x B] and of their products with the targets [B x D]. Each basis is divided by
/// its own energy, so that bases with a small effect are learned too.
pub fn regress(gram: &DMatrix<f64>, moment: &DMatrix<f64>) -> Result<DMatrix<f64>, NumericsError> {
    let largest = gram.diagonal().max();
    let scale = gram.diagonal().map(|e| if e > 1e-200 * largest && e > 0.0 { 1.0 / e.sqrt() } else { 0.0 });
    let n = gram.nrows();
    let scaled =
        DMatrix::from_fn(n, n, |a, b| gram[(a, b)] * scale[a] * scale[b] + if a == b { RIDGE } else { 0.0 });
    let right = DMatrix::from_fn(n, moment.ncols(), |a, k| moment[(a, k)] * scale[a]);
    let mut w = Factor::new(&scaled, "products of the basis functions")?.solve(&right);
    for (mut row, scale) in w.row_iter_mut().zip(scale.iter()) {
        row *= *scale;
    }
    Ok(w)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dvector;

    #[test]
    fn without_force_the_goal_is_approached_as_a_critically_damped_spring_does() {
        let (tau, rate) = (40.0, ALPHA_Z / 2.0);
        let y = integrate(
            &dvector![1.0],
            &dvector![0.0],
            &dvector![3.0],
            tau,
            60,
            &Handles::default(),
            |_, f| f.fill(0.0),
        );
        for t in 0..60 {
            let s = rate * t as f64 / tau;
            let exact = 3.0 - 2.0 * (1.0 + s) * (-s).exp();
            assert!((y[(t, 0)] - exact).abs() < 5e-5, "{t}: {} {exact}", y[(t, 0)]);
        }
    }

    #[test]
    fn the_target_force_of_a_parabola_is_exact() {
        let y = DMatrix::from_fn(9, 1, |t, _| 1.0 + 0.2 * t as f64 - 0.03 * (t as f64).powi(2));
        let curve = Curve::new(&y);
        let found = curve.forces(&dvector![0.5], 8.0);
        for (i, t) in curve.times().into_iter().enumerate() {
            let (position, velocity) = (1.0 + 0.2 * t - 0.03 * t * t, 0.2 - 0.06 * t);
            let exact = 64.0 * -0.06 - ALPHA_Z * (BETA_Z * (0.5 - position) - 8.0 * velocity);
            assert!((found[(i, 0)] - exact).abs() < 1e-9, "{t}");
        }
        assert!((curve.first_velocity()[0] - 0.2).abs() < 1e-9);
        let first = |frames: usize| Curve::new(&y.rows(0, frames).into_owned()).first_velocity()[0];
        assert_eq!(first(1), 0.0);
        assert!((first(2) - 0.17).abs() < 1e-9 && (first(3) - 0.2).abs() < 1e-9);
    }

    #[test]
    fn a_spline_has_the_derivatives_of_a_wave() {
        let y = DMatrix::from_fn(40, 1, |t, _| (0.6 * t as f64).sin());
        let curve = Curve::new(&y);
        for t in [6.0, 12.25, 20.5, 30.75] {
            let (position, velocity, acceleration) = curve.at(t, 0);
            assert!((position - (0.6 * t).sin()).abs() < 1e-3, "{t}");
            assert!((velocity - 0.6 * (0.6 * t).cos()).abs() < 2e-3, "{t}");
            assert!((acceleration + 0.36 * (0.6 * t).sin()).abs() < 0.02, "{t}");
        }
    }

    #[test]
    fn a_basis_with_next_to_no_energy_has_no_weight() {
        let gram = DMatrix::from_diagonal(&dvector![1.0, 1e-10, 1e-210]);
        let weights = regress(&gram, &DMatrix::from_column_slice(3, 1, &[1.0, 1e-10, 1e-210])).unwrap();
        assert!((weights[0] - 1.0).abs() < 2e-6 && (weights[1] - 1.0).abs() < 2e-6, "{weights}");
        assert_eq!(weights[2], 0.0);
    }
}
