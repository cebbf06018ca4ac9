//! Four numbers in as many registers as they need.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Sub};
use wide::{f64x2, u64x2};

/// Four numbers that are computed side by side. Every kind computes each of them by the same operations, so
/// that the results are the same to the bit.
pub trait Quad:
    Copy + Debug + Send + Sync + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// A number as it is kept where four of it will be needed again and again.
    type Number: Copy + Debug + Send + Sync;
    /// Whether four numbers need two registers: fewer sums fit then.
    const NARROW: bool;

    fn number(value: f64) -> Self::Number;
    /// Four times this number.
    fn of(number: Self::Number) -> Self;
    fn from_array(values: [f64; 4]) -> Self;
    fn to_array(self) -> [f64; 4];
    fn sqrt(self) -> Self;
    /// The larger of each number and `least`.
    fn at_least(self, least: f64) -> Self;
    /// The bits of each number 52 places higher: its lowest twelve become sign and exponent.
    fn shifted(self) -> Self;

    /// Does `work` with the instructions that these registers need.
    fn run<T>(work: impl FnOnce() -> T) -> T;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self::of(Self::number(value))
    }
}

/// Two numbers a register: what every machine has, natively (SSE2, NEON) and in wasm (simd128).
#[derive(Clone, Copy, Debug)]
pub struct Narrow([f64x2; 2]);

impl Quad for Narrow {
    type Number = f64x2;
    const NARROW: bool = true;

    #[inline(always)]
    fn number(value: f64) -> f64x2 {
        f64x2::splat(value)
    }

    #[inline(always)]
    fn of(number: f64x2) -> Self {
        Self([number; 2])
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
        Self([self.0[0].sqrt(), self.0[1].sqrt()])
    }

    #[inline(always)]
    fn at_least(self, least: f64) -> Self {
        let least = f64x2::splat(least);
        Self([self.0[0].fast_max(least), self.0[1].fast_max(least)])
    }

    #[inline(always)]
    fn shifted(self) -> Self {
        let bits: [u64x2; 2] = bytemuck::cast(self.0);
        Self(bytemuck::cast([bits[0] << 52_u32, bits[1] << 52_u32]))
    }

    #[inline(always)]
    fn run<T>(work: impl FnOnce() -> T) -> T {
        work()
    }
}

by_halves!([] Narrow);
