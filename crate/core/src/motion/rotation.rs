//! Euler angles in any order and rotation vectors, both without jumps in time.

use crate::elementary::Elementary;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};

/// The rotation by `|r|` radians about `r` (the exponential map).
pub fn exp(r: &Vector3<f64>) -> UnitQuaternion<f64> {
    // This runs for every joint of every frame. nalgebra's norm calls libm's square root, which takes many
    // instructions in wasm; the processor's square root gives the same bits.
    let half = 0.5 * r.norm_squared().sqrt();
    let (sine, cosine) = half.sine_cosine();
    // sin(half) / |r|. Below 1e-4 the next term of the series is of order 1e-18.
    let factor = if half < 1e-4 { 0.5 * (1.0 - half * half / 6.0) } else { 0.5 * sine / half };
    let q = Quaternion::from_parts(cosine, r * factor);
    UnitQuaternion::new_unchecked(q / q.norm_squared().sqrt())
}

/// The rotation vector of the shorter way round, radians, `|r| <= pi` (the logarithm).
pub fn log(q: &UnitQuaternion<f64>) -> Vector3<f64> {
    let (vector, scalar) =
        if q.scalar() < 0.0 { (-q.vector(), -q.scalar()) } else { (q.vector().into_owned(), q.scalar()) };
    let sine = vector.norm();
    if sine < 1e-12 {
        return vector * 2.0;
    }
    vector * (2.0 * sine.arctangent(scalar) / sine)
}

/// Of all rotation vectors of one rotation, `r (1 + 2 pi k / |r|)`, the one nearest to `previous`.
pub fn log_near(q: &UnitQuaternion<f64>, previous: &Vector3<f64>) -> Vector3<f64> {
    let r = log(q);
    let angle = r.norm();
    // A rotation by zero has no axis: any whole number of turns about the previous axis is the same rotation.
    let axis =
        if angle > 1e-9 { r / angle } else { previous.try_normalize(1e-9).unwrap_or_else(Vector3::zeros) };
    let turns = ((axis.dot(previous) - angle) / TAU).round();
    r + axis * (TAU * turns)
}

/// The angle between two rotations, radians, 0 to pi.
pub fn angle_between(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    log(&(a.inverse() * b)).norm()
}

/// The rotation by an angle in radians about one axis (0, 1, 2 for x, y, z).
pub fn about_axis(axis: usize, angle: f64) -> UnitQuaternion<f64> {
    let (sine, cosine) = (0.5 * angle).sine_cosine();
    let mut vector = Vector3::zeros();
    vector[axis] = sine;
    UnitQuaternion::new_unchecked(Quaternion::from_parts(cosine, vector))
}

/// `angle + 2 pi k` nearest to `previous`.
pub fn angle_near(angle: f64, previous: f64) -> f64 {
    angle + TAU * ((previous - angle) / TAU).round()
}

/// An angle brought into `[-pi, pi]`.
pub fn wrapped(angle: f64) -> f64 {
    angle_near(angle, 0.0)
}

/// Angles a, b, c (radians) with `R = R_i(a) R_j(b) R_k(c)` for the axes `i, j, k`, all different.
///
/// Of the two solutions, (a, b, c) and (a + pi, pi - b, c + pi), and all full turns, the one nearest to
/// `previous`. In gimbal lock, where the first and the last axis coincide, a does not change.
pub fn euler_near(q: &UnitQuaternion<f64>, axes: [usize; 3], previous: [f64; 3]) -> [f64; 3] {
    let [i, j, k] = axes;
    let sign = parity(i, j);
    let m = q.to_rotation_matrix();
    let (sine, cosine) = (-sign * m[(j, k)], m[(k, k)]);
    let a = if sine.hypotenuse(cosine) < 1e-12 { previous[0] } else { sine.arctangent(cosine) };
    // b and c are computed after removing R_i(a), so c corrects an inaccurate a and the product is exact.
    let rest = about_axis(i, -a).to_rotation_matrix() * m;
    let b = (sign * rest[(i, k)]).arctangent(rest[(k, k)]);
    let c = (sign * rest[(j, i)]).arctangent(rest[(j, j)]);
    let near = |angles: [f64; 3]| -> [f64; 3] { std::array::from_fn(|n| angle_near(angles[n], previous[n])) };
    let distance = |angles: &[f64; 3]| -> f64 { (0..3).map(|n| (angles[n] - previous[n]).powi(2)).sum() };
    let (first, second) = (near([a, b, c]), near([a + PI, PI - b, c + PI]));
    if distance(&second) < distance(&first) { second } else { first }
}

/// Angles of a joint's rotation channels (radians, in the order of `axes`, 0 to 3 different axes), nearest to
/// `previous`. With fewer than three axes: the part of the rotation that those axes can express.
pub fn angles_near(q: &UnitQuaternion<f64>, axes: &[usize], previous: &[f64]) -> [f64; 3] {
    match *axes {
        [i, j, k] => euler_near(q, [i, j, k], [previous[0], previous[1], previous[2]]),
        [i, j] => {
            let (k, sign) = (3 - i - j, parity(i, j));
            let m = q.to_rotation_matrix();
            // In R_i(a) R_j(b) the direction of axis j depends on a alone.
            let a = (sign * m[(k, j)]).arctangent(m[(j, j)]);
            let rest = about_axis(i, -a).to_rotation_matrix() * m;
            let b = (sign * rest[(i, k)]).arctangent(rest[(k, k)]);
            [angle_near(a, previous[0]), angle_near(b, previous[1]), 0.0]
        }
        [i] => [angle_near(2.0 * q.vector()[i].arctangent(q.scalar()), previous[0]), 0.0, 0.0],
        _ => [0.0; 3],
    }
}

/// 1 where the axis after `i` is `j` (x to y, y to z, z to x), else -1.
fn parity(i: usize, j: usize) -> f64 {
    if (i + 1) % 3 == j { 1.0 } else { -1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;

    fn product(axes: &[usize], angles: &[f64]) -> UnitQuaternion<f64> {
        axes.iter()
            .zip(angles)
            .fold(UnitQuaternion::identity(), |q, (&axis, &angle)| q * about_axis(axis, angle))
    }

    fn orders() -> [[usize; 3]; 6] {
        [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]]
    }

    #[test]
    fn exp_turns_as_the_right_hand_rule_says() {
        let turned = exp(&Vector3::new(0.0, 0.0, PI / 2.0)) * Vector3::x();
        assert_abs_diff_eq!(turned, Vector3::y(), epsilon = 1e-15);
        assert_abs_diff_eq!(about_axis(2, PI / 2.0) * Vector3::x(), Vector3::y(), epsilon = 1e-15);
    }

    #[test]
    fn a_rotation_vector_goes_through_a_whole_turn_without_a_jump() {
        let mut previous = Vector3::zeros();
        for step in 0..100 {
            let r = Vector3::new(0.6, 0.0, 0.8) * (0.1 * f64::from(step));
            previous = log_near(&exp(&r), &previous);
            assert_abs_diff_eq!(previous, r, epsilon = 1e-12);
        }
    }

    #[test]
    fn the_vector_of_a_tiny_turn_is_its_angle() {
        for angle in [1e-13, 1e-11] {
            assert!((log(&about_axis(0, angle)).x / angle - 1.0).abs() < 1e-9, "{angle}");
        }
    }

    #[test]
    fn euler_angles_stay_exact_in_gimbal_lock() {
        for axes in orders() {
            for middle in [PI / 2.0, -PI / 2.0, PI / 2.0 - 1e-9, PI / 2.0 + 1e-13] {
                let q = product(&axes, &[0.4, middle, -1.1]);
                let angles = euler_near(&q, axes, [0.1, 0.0, 0.0]);
                assert!(angle_between(&q, &product(&axes, &angles)) < 1e-11, "{axes:?} {middle}");
            }
        }
    }

    #[test]
    fn euler_angles_follow_a_turn_through_gimbal_lock() {
        let mut previous = [0.3, 0.0, -0.2];
        for step in 0..400 {
            let truth = [0.3, 0.05 * f64::from(step), -0.2];
            previous = euler_near(&product(&[1, 0, 2], &truth), [1, 0, 2], previous);
            for n in 0..3 {
                assert_abs_diff_eq!(previous[n], truth[n], epsilon = 1e-9);
            }
        }
    }

    proptest! {
        #[test]
        fn log_inverts_exp(x in -1.8..1.8, y in -1.8..1.8, z in -1.8..1.8) {
            let r = Vector3::new(x, y, z);
            prop_assert!((log(&exp(&r)) - r).norm() < 1e-13);
            prop_assert!((log(&exp(&(r * 1e-7))) - r * 1e-7).norm() < 1e-20);
        }

        #[test]
        fn log_near_keeps_the_rotation(x in -9.0..9.0, y in -9.0..9.0, z in -9.0..9.0, px in -9.0..9.0, py in -9.0..9.0) {
            let q = exp(&Vector3::new(x, y, z));
            let r = log_near(&q, &Vector3::new(px, py, 1.0));
            prop_assert!(angle_between(&exp(&r), &q) < 1e-13);
        }

        #[test]
        fn euler_angles_in_any_order_reproduce_the_rotation(x in -3.0..3.0, y in -3.0..3.0, z in -3.0..3.0, p in -9.0..9.0) {
            let q = exp(&Vector3::new(x, y, z));
            for axes in orders() {
                let angles = euler_near(&q, axes, [p, -p, 0.5 * p]);
                prop_assert!(angle_between(&q, &product(&axes, &angles)) < 1e-12);
            }
        }

        #[test]
        fn angles_of_one_or_two_axes_are_recovered(a in -3.0..3.0, b in -3.0..3.0) {
            for [i, j, _] in orders() {
                let q = product(&[i, j], &[a, b]);
                let found = angles_near(&q, &[i, j], &[a, b]);
                prop_assert!((found[0] - a).abs() < 1e-12 && (found[1] - b).abs() < 1e-12);
            }
            let found = angles_near(&about_axis(1, a), &[1], &[a]);
            prop_assert!((found[0] - a).abs() < 1e-12);
        }
    }
}
