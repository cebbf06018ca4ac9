//! The transformation system that every dynamic movement primitive shares, and the regression of its forcing term.

use crate::linalg::{Factor, NumericsError};
use nalgebra::{DMatrix, DVector};

/// alpha_z and beta_z = alpha_z / 4 of Ijspeert et al. (2013): critically damped.
pub const ALPHA_Z: f64 = 25.0;
pub const BETA_Z: f64 = ALPHA_Z / 4.0;
/// Of the regression, relative to the mean energy of a basis: enough to keep it solvable, too little to smooth.
const RIDGE: f64 = 1e-8;
/// A step of the integration is at most this part of tau; the spring's own time is tau / 12.5.
const LARGEST_STEP: f64 = 0.02;

/// tau z' = alpha_z (beta_z (g - y) - z) + f, tau y' = z, for all columns, by the classic fourth order
/// Runge-Kutta method with several steps a frame.
///
/// `force(t, out)` fills in f of all columns at time `t`, in frames. Returns y at 0, 1, ..., frames - 1 [frames x D]; `velocity` is
/// y' at 0, per frame.
pub fn integrate(
    start: &DVector<f64>,
    velocity: &DVector<f64>,
    goal: &DVector<f64>,
    tau: f64,
    frames: usize,
    mut force: impl FnMut(f64, &mut DVector<f64>),
) -> DMatrix<f64> {
    let steps = (1.0 / (LARGEST_STEP * tau)).ceil().max(1.0);
    let h = 1.0 / steps;
    let columns = start.len();
    let (mut y, mut z) = (start.clone(), velocity * tau);
    let mut out = DMatrix::zeros(frames, columns);
    let mut forces = [(); 3].map(|()| DVector::zeros(columns));
    for frame in 0..frames {
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

/// The forcing term that would have made the system follow the trajectory `y` [T x D]:
/// tau^2 y'' - alpha_z (beta_z (g - y) - tau y'), with differences between neighbouring frames; at the ends one-sided.
pub fn forcing_target(y: &DMatrix<f64>, goal: &DVector<f64>, tau: f64) -> DMatrix<f64> {
    let last = y.nrows().saturating_sub(1);
    DMatrix::from_fn(y.nrows(), y.ncols(), |t, k| {
        // The second difference in the middle of the three frames that are nearest.
        let m = t.clamp(1, last.saturating_sub(1).max(1)).min(last);
        let (a, b, c) = (y[(m.saturating_sub(1), k)], y[(m, k)], y[((m + 1).min(last), k)]);
        let acceleration = a - 2.0 * b + c;
        let velocity = 0.5 * (c - a) + (t as f64 - m as f64) * acceleration;
        tau * tau * acceleration - ALPHA_Z * (BETA_Z * (goal[k] - y[(t, k)]) - tau * velocity)
    })
}

/// y' at the first frame, per frame: the slope there of the parabola through at most the first five frames [D].
pub fn first_velocity(y: &DMatrix<f64>) -> DVector<f64> {
    let count = y.nrows().min(5);
    let degree = count.saturating_sub(1).min(2);
    if degree == 0 {
        return DVector::zeros(y.ncols());
    }
    let powers = DMatrix::from_fn(count, degree + 1, |t, p| (t as f64).powi(p as i32));
    match Factor::new(&powers.tr_mul(&powers), "frames at the start") {
        Ok(factor) => factor.solve(&powers.tr_mul(&y.rows(0, count))).row(1).transpose(),
        Err(_) => (y.row(1) - y.row(0)).transpose(),
    }
}

/// The weights [B x D] of `gram` w = `moment`, sums over frames of the basis functions' products [B x B] and of their products with
/// the targets [B x D]: ridge regression, each basis measured by its own energy, so that those of little effect are learned as well.
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
        let y = integrate(&dvector![1.0], &dvector![0.0], &dvector![3.0], tau, 60, |_, f| f.fill(0.0));
        for t in 0..60 {
            let s = rate * t as f64 / tau;
            let exact = 3.0 - 2.0 * (1.0 + s) * (-s).exp();
            assert!((y[(t, 0)] - exact).abs() < 1e-5, "{t}: {} {exact}", y[(t, 0)]);
        }
    }

    #[test]
    fn the_target_force_of_a_parabola_is_exact() {
        let y = DMatrix::from_fn(9, 1, |t, _| 1.0 + 0.2 * t as f64 - 0.03 * (t as f64).powi(2));
        let found = forcing_target(&y, &dvector![0.5], 8.0);
        for t in 0..9 {
            let (velocity, acceleration) = (0.2 - 0.06 * t as f64, -0.06);
            let exact = 64.0 * acceleration - ALPHA_Z * (BETA_Z * (0.5 - y[(t, 0)]) - 8.0 * velocity);
            assert!((found[(t, 0)] - exact).abs() < 1e-9, "{t}");
        }
        assert!((first_velocity(&y)[0] - 0.2).abs() < 1e-9);
        assert_eq!(first_velocity(&y.rows(0, 1).into_owned())[0], 0.0);
        assert!((first_velocity(&y.rows(0, 2).into_owned())[0] - 0.17).abs() < 1e-9);
    }
}
