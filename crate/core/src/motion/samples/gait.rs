//! Normal gait: joint angles over the gait cycle as Fourier series.
//!
//! The curves of hip, knee and ankle have the published shapes (Winter, *The Biomechanics and Motor Control
//! of Human Gait*, 1991; Perry and Burnfield, *Gait Analysis*, 2010). They are Fourier series of low order,
//! fitted to the landmarks of those curves (hip 25 to 30 degrees flexed at contact and 10 to 15 extended
//! before toe-off, knee 18 degrees at loading and 60 to 65 in swing, ankle 10 degrees dorsiflexed in late
//! stance and 18 plantarflexed at toe-off) under the condition that the sole of the foot does not move during
//! the stance.
//!
//! Phases count gait cycles: 0 is the heel contact of that leg, about 0.6 its toe-off, 1 the next contact.
//! Angles are in degrees.

use crate::elementary::Elementary;
use std::f64::consts::TAU;

/// A periodic curve `a_0 + sum_k a_k cos(2 pi k phase) + b_k sin(2 pi k phase)`, stored as `a_0, a_1, b_1,
/// a_2, b_2, ...`.
struct Series<const N: usize>([f64; N]);

impl<const N: usize> Series<N> {
    fn at(&self, phase: f64) -> f64 {
        let pairs = self.0[1..].chunks_exact(2).zip(1..);
        let waves = pairs.map(|(ab, k)| {
            let (sine, cosine) = (TAU * f64::from(k) * phase).sine_cosine();
            ab[0] * cosine + ab[1] * sine
        });
        self.0[0] + waves.sum::<f64>()
    }
}

const HIP: Series<11> = Series([9.71, 22.28, -7.16, -5.16, -3.83, -2.73, 0.42, -0.88, 1.16, 0.33, 0.12]);
const KNEE: Series<13> =
    Series([23.67, -3.61, -21.0, -14.91, 8.18, 0.14, 4.47, 0.41, 0.31, 0.02, -0.6, -0.15, 0.26]);
const ANKLE: Series<15> =
    Series([1.9, -1.96, 4.43, 0.62, -7.58, -3.71, 2.01, 3.54, 0.86, 0.79, -2.77, -0.66, -0.01, -0.1, 0.27]);
const TOES: Series<11> = Series([11.33, -14.41, -12.15, 1.58, 10.26, 2.06, -2.1, 0.33, -0.67, -0.53, -0.46]);

/// The angles of one leg in the sagittal plane, degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Leg {
    /// Thigh against the vertical, positive forward (flexion).
    pub hip: f64,
    /// Flexion.
    pub knee: f64,
    /// Dorsiflexion.
    pub ankle: f64,
    /// Extension of the toes against the foot.
    pub toes: f64,
}

impl Leg {
    /// The foot against the ground, positive with the toes up.
    pub fn foot_pitch(&self) -> f64 {
        self.hip - self.knee + self.ankle
    }
}

/// One leg at a phase of its own cycle.
pub(super) fn leg(phase: f64) -> Leg {
    Leg { hip: HIP.at(phase), knee: KNEE.at(phase), ankle: ANKLE.at(phase), toes: TOES.at(phase) }
}

/// Turns of pelvis and trunk against the walking direction, degrees; phases are those of the left leg.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Girdle {
    /// About the vertical, positive with the right side forward.
    pub yaw: f64,
    /// About the walking direction, positive with the left side up.
    pub obliquity: f64,
    /// About the sideways axis, positive forward.
    pub tilt: f64,
}

/// The pelvis: the side of the leg that lands is forward; the side of the swinging leg drops.
pub(super) fn pelvis(phase: f64) -> Girdle {
    Girdle {
        yaw: -4.5 * wave(phase, 0.02),
        obliquity: 3.5 * wave(phase, 0.16),
        tilt: 4.0 + 1.0 * wave(2.0 * phase, 0.15),
    }
}

/// The chest: turns against the pelvis and stays nearly upright.
pub(super) fn chest(phase: f64) -> Girdle {
    Girdle {
        yaw: 4.0 * wave(phase, 0.03),
        obliquity: -1.2 * wave(phase, 0.22),
        tilt: 4.5 + 1.2 * wave(2.0 * phase, 0.05),
    }
}

/// The angles of the pelvis, and of the chest, of a person who stands still.
pub(super) fn standing() -> Girdle {
    Girdle { yaw: 0.0, obliquity: 0.0, tilt: 4.3 }
}

/// Sideways lean of both legs, which moves the body over the standing foot; degrees, positive with the feet
/// to the left.
pub(super) fn sway(phase: f64) -> f64 {
    -1.3 * wave(phase, 0.30)
}

/// One arm: (flexion of the shoulder, flexion of the elbow), degrees, at a phase of the leg on the same side:
/// furthest back when that leg lands.
pub(super) fn arm(phase: f64) -> (f64, f64) {
    let shoulder = -5.0 - 17.0 * wave(phase, 0.02) + 2.0 * wave(2.0 * phase, 0.05);
    let elbow = 24.0 - 10.5 * wave(phase, 0.07) + 2.5 * wave(2.0 * phase, 0.10);
    (shoulder, elbow)
}

/// A cosine with its top at the phase `top`.
pub(super) fn wave(phase: f64, top: f64) -> f64 {
    (TAU * (phase - top)).cosine()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cycle(f: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..1000).map(|k| f(f64::from(k) / 1000.0)).collect()
    }

    fn top(curve: &[f64]) -> (f64, f64) {
        let (k, value) = curve.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).unwrap();
        (k as f64 / 1000.0, *value)
    }

    fn bottom(curve: &[f64]) -> (f64, f64) {
        let (k, value) = top(&curve.iter().map(|v| -v).collect::<Vec<_>>());
        (k, -value)
    }

    #[test]
    fn the_hip_is_flexed_at_contact_and_extended_before_toe_off() {
        let hip = cycle(|p| leg(p).hip);
        assert!((22.0..33.0).contains(&hip[0]), "{}", hip[0]);
        let (when, most) = bottom(&hip);
        assert!((0.45..0.58).contains(&when) && (-17.0..-9.0).contains(&most), "{when} {most}");
    }

    #[test]
    fn the_knee_yields_at_loading_and_bends_in_swing() {
        let knee = cycle(|p| leg(p).knee);
        let (when, most) = top(&knee);
        assert!((0.68..0.77).contains(&when) && (57.0..69.0).contains(&most), "{when} {most}");
        let (when, most) = top(&knee[..400]);
        assert!((0.10..0.20).contains(&when) && (14.0..21.0).contains(&most), "{when} {most}");
        assert!(bottom(&knee[300..500]).1 < 9.0 && bottom(&knee).1 > 0.0, "the knee never overstretches");
    }

    #[test]
    fn the_ankle_gives_at_contact_and_pushes_off() {
        let ankle = cycle(|p| leg(p).ankle);
        assert!((-8.0..-3.0).contains(&bottom(&ankle[..200]).1));
        let (when, most) = top(&ankle[200..600]);
        assert!((0.15..0.30).contains(&when) && (8.0..14.0).contains(&most), "{when} {most}");
        let (when, most) = bottom(&ankle);
        assert!((0.60..0.70).contains(&when) && (-22.0..-14.0).contains(&most), "{when} {most}");
    }

    #[test]
    fn the_foot_is_flat_in_mid_stance() {
        for phase in [0.12, 0.2, 0.3, 0.38] {
            assert!(leg(phase).foot_pitch().abs() < 4.0, "{phase}: {}", leg(phase).foot_pitch());
        }
        assert!(leg(0.0).foot_pitch() > 12.0, "the heel lands first");
    }

    #[test]
    fn arm_and_leg_of_a_side_swing_against_each_other() {
        let (arms, legs) = (cycle(|p| arm(p).0), cycle(|p| leg(p).hip));
        let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
        let (a, l) = (mean(&arms), mean(&legs));
        let product: f64 = arms.iter().zip(&legs).map(|(x, y)| (x - a) * (y - l)).sum();
        let size = |v: &[f64], m: f64| v.iter().map(|x| (x - m) * (x - m)).sum::<f64>().sqrt();
        assert!(product / (size(&arms, a) * size(&legs, l)) < -0.8);
    }
}
