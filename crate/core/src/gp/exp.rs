//! An exponential that gives the same bits natively and in wasm, for single numbers and for lanes.

use crate::gp::lanes::{Lanes, Simd, splat};
use fearless_simd::prelude::*;
use fearless_simd::u64x8;
use std::f64::consts::LOG2_E;
use std::ops::{Add, Mul, Sub};

// ln 2 in two parts: n * LN2_HI is exact for every n in the range.
const LN2_HI: f64 = f64::from_bits(0x3fe6_2e42_fee0_0000);
const LN2_LO: f64 = f64::from_bits(0x3dea_39ef_3579_3c76);
/// Adding this rounds to a whole number; the low bits of the sum are this number plus the bias of an
/// exponent.
const ROUND: f64 = 6_755_399_441_055_744.0 + 1023.0; // 1.5 * 2^52 + 1023
/// e^-708 is near the smallest normal number; smaller arguments are replaced by -708.
const LOWEST: f64 = -708.0;
const HIGHEST: f64 = 709.0;
/// Coefficients of the polynomial of degree 11 with the smallest relative error for e^r over |r| <= ln 2 / 2,
/// 3.1e-18 (Remez).
const SERIES: [f64; 12] = [
    1.0,
    1.0,
    0.500_000_000_000_001_8,
    0.166_666_666_666_661_66,
    0.041_666_666_666_492_075,
    0.008_333_333_333_560_157,
    0.001_388_888_895_141_009_3,
    0.000_198_412_694_314_900_3,
    2.480_148_632_073_879_5e-5,
    2.755_762_310_547_520_6e-6,
    2.763_236_797_042_51e-7,
    2.499_425_709_266_684_5e-8,
];

/// e^x to about one unit in the last place for x in [-708, 709]; outside, the value at the nearer end. NaN
/// stays NaN.
#[inline]
pub fn exp(x: f64) -> f64 {
    if x.is_nan() {
        return x;
    }
    let (power, shifted) = power_and_exponent(x.clamp(LOWEST, HIGHEST), |value| value);
    power * f64::from_bits(shifted.to_bits() << 52)
}

/// [`exp`] of numbers that are at most 709 and not NaN.
#[inline(always)]
pub fn exp_lanes<S: Simd>(x: Lanes<S>) -> Lanes<S> {
    let simd = x.simd;
    let lowest = splat(simd, LOWEST);
    // Faster in wasm than `max`, which has to treat NaN.
    let x = lowest.simd_lt(x).select(x, lowest);
    let (power, shifted) = power_and_exponent(x, |value| splat(simd, value));
    let scale: Lanes<S> = (shifted.bitcast::<u64x8<S>>() << 52).bitcast();
    power * scale
}

/// With n = round(x / ln 2) and r = x - n ln 2: e^r, and a number whose lowest bits are the exponent of 2^n.
///
/// Without branches, and only additions and multiplications, so that all platforms agree to the last bit. The
/// even and the odd powers of the polynomial are summed separately, which shortens the chain of operations.
#[inline(always)]
fn power_and_exponent<V>(x: V, splat: impl Fn(f64) -> V) -> (V, V)
where
    V: Copy + Add<Output = V> + Sub<Output = V> + Mul<Output = V>,
{
    let c = |k: usize| splat(SERIES[k]);
    let shifted = x * splat(LOG2_E) + splat(ROUND);
    let n = shifted - splat(ROUND);
    let r = (x - n * splat(LN2_HI)) - n * splat(LN2_LO);
    let r2 = r * r;
    let even = ((((c(10) * r2 + c(8)) * r2 + c(6)) * r2 + c(4)) * r2 + c(2)) * r2 + c(0);
    let odd = ((((c(11) * r2 + c(9)) * r2 + c(7)) * r2 + c(5)) * r2 + c(3)) * r2 + c(1);
    (odd * r + even, shifted)
}

#[cfg(test)]
mod tests {
    use crate::gp::exp::exp;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn agrees_with_the_standard_library(x in -707.9f64..700.0) {
            let expected = x.exp();
            prop_assert!(((exp(x) - expected) / expected).abs() < 4.0 * f64::EPSILON);
        }
    }

    #[test]
    fn stays_finite_outside_its_range() {
        assert_eq!(exp(0.0), 1.0);
        assert!(exp(-1e9) < 1e-300);
        assert!(exp(1e9).is_finite());
        assert!(exp(f64::NAN).is_nan());
    }
}
