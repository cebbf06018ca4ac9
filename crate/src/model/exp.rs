//! An exponential that vectorises, the same in native and wasm.

// ln 2 in two parts: n * LN2_HI is exact for every n that can occur.
const LN2_HI: f64 = f64::from_bits(0x3fe6_2e42_fee0_0000);
const LN2_LO: f64 = f64::from_bits(0x3dea_39ef_3579_3c76);
/// Adding it rounds to a whole number and leaves that number in the low bits.
const ROUND: f64 = 6_755_399_441_055_744.0; // 1.5 * 2^52
/// e^-708 is the last normal number: what is smaller counts as this.
const LOWEST: f64 = -708.0;
const HIGHEST: f64 = 709.0;

/// e^x to about one unit in the last place for x in [-708, 709]; outside, the value at the nearer end. NaN stays NaN.
///
/// Branch-free and made of plain multiplications and additions, so a loop over a slice compiles to vector instructions and
/// native and wasm agree to the bit. 2^n e^r with n = round(x / ln 2) and the Taylor series of e^r, |r| <= 0.347, to r^13
/// (remainder below 5e-18), summed pairwise.
#[inline(always)]
pub fn exp(x: f64) -> f64 {
    let x = if x < LOWEST { LOWEST } else { x };
    let x = if x > HIGHEST { HIGHEST } else { x };
    let shifted = x * std::f64::consts::LOG2_E + ROUND;
    let n = shifted - ROUND;
    let r = (x - n * LN2_HI) - n * LN2_LO;
    let r2 = r * r;
    let r4 = r2 * r2;
    let r8 = r4 * r4;
    let c01 = 1.0 + r;
    let c23 = 0.5 + r * (1.0 / 6.0);
    let c45 = 1.0 / 24.0 + r * (1.0 / 120.0);
    let c67 = 1.0 / 720.0 + r * (1.0 / 5_040.0);
    let c89 = 1.0 / 40_320.0 + r * (1.0 / 362_880.0);
    let c1011 = 1.0 / 3_628_800.0 + r * (1.0 / 39_916_800.0);
    let c1213 = 1.0 / 479_001_600.0 + r * (1.0 / 6_227_020_800.0);
    let series = (c01 + c23 * r2) + (c45 + c67 * r2) * r4 + ((c89 + c1011 * r2) + c1213 * r4) * r8;
    let two_to_n = f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
    series * two_to_n
}

#[cfg(test)]
mod tests {
    use super::exp;
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
