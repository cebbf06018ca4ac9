//! Four numbers in one register, on processors of the x86 family that have such (AVX2).
//!
//! No multiplication is fused with an addition (FMA): a model would then depend on the processor that trained
//! it.
#![allow(unsafe_code)]

use crate::gp::lanes::quad::Quad;
use std::arch::x86_64::{
    __m256d, _mm256_add_pd, _mm256_castpd_si256, _mm256_castsi256_pd, _mm256_div_pd, _mm256_max_pd,
    _mm256_mul_pd, _mm256_slli_epi64, _mm256_sqrt_pd, _mm256_sub_pd,
};
use std::ops::{Add, Div, Mul, Sub};

/// Four numbers in one register.
#[derive(Clone, Copy, Debug)]
pub struct Avx(__m256d);

impl Avx {
    /// Whether this processor has such registers; without, nothing may be computed in them.
    pub fn is_there() -> bool {
        is_x86_feature_detected!("avx2")
    }
}

/// For each function: SAFETY: whoever computes with [`Avx`] has asked whether it [`is_there`](Avx::is_there).
impl Quad for Avx {
    type Number = __m256d;
    const NARROW: bool = false;

    #[inline(always)]
    fn number(value: f64) -> __m256d {
        bytemuck::cast([value; 4])
    }

    #[inline(always)]
    fn of(number: __m256d) -> Self {
        Self(number)
    }

    #[inline(always)]
    fn from_array(values: [f64; 4]) -> Self {
        Self(bytemuck::cast(values))
    }

    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        bytemuck::cast(self.0)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn at_least(self, least: f64) -> Self {
        Self(unsafe { _mm256_max_pd(self.0, Self::number(least)) })
    }

    #[inline(always)]
    fn shifted(self) -> Self {
        Self(unsafe { _mm256_castsi256_pd(_mm256_slli_epi64::<52>(_mm256_castpd_si256(self.0))) })
    }

    #[inline(always)]
    fn run<T>(work: impl FnOnce() -> T) -> T {
        #[target_feature(enable = "avx2")]
        fn with_avx<T>(work: impl FnOnce() -> T) -> T {
            work()
        }
        debug_assert!(Self::is_there());
        unsafe { with_avx(work) }
    }
}

macro_rules! lanewise {
    ($trait:ident, $method:ident, $instruction:ident) => {
        impl $trait for Avx {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $instruction(self.0, other.0) })
            }
        }
    };
}
lanewise!(Add, add, _mm256_add_pd);
lanewise!(Sub, sub, _mm256_sub_pd);
lanewise!(Mul, mul, _mm256_mul_pd);
lanewise!(Div, div, _mm256_div_pd);
