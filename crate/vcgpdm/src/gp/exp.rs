//! An exponential that works on lanes, the same in native and wasm.

use crate::gp::lanes::{Narrow, Quad};

// ln 2 in two parts: n * LN2_HI is exact for every n that can occur.
const LN2_HI: f64 = f64::from_bits(0x3fe6_2e42_fee0_0000);
const LN2_LO: f64 = f64::from_bits(0x3dea_39ef_3579_3c76);
/// Adding it rounds to a whole number and leaves that number, and the bias of an exponent, in the low bits.
const ROUND: f64 = 6_755_399_441_055_744.0 + 1023.0; // 1.5 * 2^52 + 1023
/// e^-708 is near the smallest normal number; smaller exponents count as this one.
const LOWEST: f64 = -708.0;
const HIGHEST: f64 = 709.0;
/// The polynomial of degree 11 whose largest relative distance from e^r over |r| <= ln 2 / 2 is least:
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
    let x = if x > HIGHEST { HIGHEST } else { x };
    if x.is_nan() { x } else { exp_below(Narrow::splat(x)).to_array()[0] }
}

/// [`exp`] of four numbers that are at most 709 and not NaN.
///
/// Branch-free and made of plain multiplications and additions, so that native and wasm agree to the bit: 2^n
/// e^r with n = round(x / ln 2), and a polynomial for e^r, its even and odd powers apart.
#[inline(always)]
pub fn exp_below<Q: Quad>(x: Q) -> Q {
    let c = |k: usize| Q::splat(SERIES[k]);
    let x = x.at_least(LOWEST);
    let shifted = x * Q::splat(std::f64::consts::LOG2_E) + Q::splat(ROUND);
    let n = shifted - Q::splat(ROUND);
    let r = (x - n * Q::splat(LN2_HI)) - n * Q::splat(LN2_LO);
    let r2 = r * r;
    let even = ((((c(10) * r2 + c(8)) * r2 + c(6)) * r2 + c(4)) * r2 + c(2)) * r2 + c(0);
    let odd = ((((c(11) * r2 + c(9)) * r2 + c(7)) * r2 + c(5)) * r2 + c(3)) * r2 + c(1);
    (odd * r + even) * shifted.shifted()
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
    fn the_ends_are_tame() {
        assert_eq!(exp(0.0), 1.0);
        assert!(exp(-1e9) < 1e-300);
        assert!(exp(1e9).is_finite());
        assert!(exp(f64::NAN).is_nan());
    }
}
