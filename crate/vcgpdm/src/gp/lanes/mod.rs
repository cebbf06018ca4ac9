//! Eight numbers side by side, on which the sums over rows are computed, in the widest registers that the
//! processor has.

/// Addition, subtraction, multiplication and division of a pair, each half on its own.
macro_rules! by_halves {
    ([$($bounds:tt)*] $pair:ty) => {
        by_halves!([$($bounds)*] $pair, Add add +);
        by_halves!([$($bounds)*] $pair, Sub sub -);
        by_halves!([$($bounds)*] $pair, Mul mul *);
        by_halves!([$($bounds)*] $pair, Div div /);
    };
    ([$($bounds:tt)*] $pair:ty, $trait:ident $method:ident $op:tt) => {
        impl<$($bounds)*> std::ops::$trait for $pair {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // Written out: `array::map` is a call where little is inlined, as in the wasm package.
                let ([a, b], [c, d]) = (self.0, other.0);
                Self([a $op c, b $op d])
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
mod avx;
mod quad;

#[cfg(target_arch = "x86_64")]
pub use avx::Avx;
pub use quad::{Narrow, Quad};

use crate::gp::exp::exp_below;

/// Does the work with the name standing for the widest registers that this processor has.
macro_rules! in_widest_registers {
    ($quad:ident => $work:expr) => {{
        #[cfg(target_arch = "x86_64")]
        if $crate::gp::lanes::Avx::is_there() {
            type $quad = $crate::gp::lanes::Avx;
            $work
        } else {
            type $quad = $crate::gp::lanes::Narrow;
            $work
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            type $quad = $crate::gp::lanes::Narrow;
            $work
        }
    }};
}
pub(crate) use in_widest_registers;

/// Rows that are computed side by side.
pub const LANES: usize = 8;

/// One number for each of [`LANES`] rows in memory, where no register crosses a line of the cache.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub struct Stored(pub [f64; LANES]);

/// One number for each of [`LANES`] rows.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<Q>(pub [Q; 2]);

impl<Q: Quad> Lanes<Q> {
    #[inline(always)]
    pub fn zero() -> Self {
        Self::splat(0.0)
    }

    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Self([Q::splat(value); 2])
    }

    /// Eight times this number.
    #[inline(always)]
    pub fn of(number: Q::Number) -> Self {
        Self([Q::of(number); 2])
    }

    /// The first [`LANES`] of `rows`; zero past the end.
    #[inline(always)]
    pub fn load(rows: &[f64]) -> Self {
        match rows.first_chunk::<LANES>() {
            Some(full) => Self::from_array(full),
            None => Self::from_array(&load_end(rows)),
        }
    }

    #[inline(always)]
    pub fn from_array(rows: &[f64; LANES]) -> Self {
        let [low, high] = bytemuck::cast::<_, [[f64; 4]; 2]>(*rows);
        Self([Q::from_array(low), Q::from_array(high)])
    }

    #[inline(always)]
    pub fn to_array(self) -> [f64; LANES] {
        bytemuck::cast([self.0[0].to_array(), self.0[1].to_array()])
    }

    /// Into the first [`LANES`] of `rows`, as many as there are.
    #[inline(always)]
    pub fn store(self, rows: &mut [f64]) {
        let full = self.to_array();
        match rows.first_chunk_mut::<LANES>() {
            Some(rows) => *rows = full,
            None => store_end(&full, rows),
        }
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self([self.0[0].sqrt(), self.0[1].sqrt()])
    }

    /// The exponential of each number; all must be at most 709.
    #[inline(always)]
    pub fn exp(self) -> Self {
        Self([exp_below(self.0[0]), exp_below(self.0[1])])
    }

    /// self += x y.
    #[inline(always)]
    pub fn add_product(&mut self, x: Self, y: Self) {
        for k in 0..2 {
            self.0[k] = self.0[k] + x.0[k] * y.0[k];
        }
    }

    #[inline(always)]
    pub fn sum(self) -> f64 {
        let [a, b, c, d] = (self.0[0] + self.0[1]).to_array();
        (a + c) + (b + d)
    }
}

#[inline(never)]
fn load_end(rows: &[f64]) -> [f64; LANES] {
    let mut full = [0.0; LANES];
    for (to, from) in full.iter_mut().zip(rows) {
        *to = *from;
    }
    full
}

#[inline(never)]
fn store_end(full: &[f64; LANES], rows: &mut [f64]) {
    for (to, from) in rows.iter_mut().zip(full) {
        *to = *from;
    }
}

by_halves!([Q: Quad] Lanes<Q>);

#[cfg(test)]
mod tests {
    use super::*;

    type Eight = Lanes<Narrow>;

    #[test]
    fn loads_what_there_is_and_stores_what_fits() {
        let rows: Vec<f64> = (1..=11).map(f64::from).collect();
        assert_eq!(Eight::load(&rows).sum(), 36.0);
        assert_eq!(Eight::load(&rows[8..]).sum(), 30.0);
        let mut out = [0.0; 3];
        (Eight::load(&rows) + Eight::splat(1.0)).store(&mut out);
        assert_eq!(out, [2.0, 3.0, 4.0]);
    }

    #[test]
    fn exponentials_are_those_of_single_numbers() {
        let rows: Vec<f64> = (0..8).map(|k| -3.7 * f64::from(k * k)).collect();
        let mut out = [0.0; 8];
        Eight::load(&rows).exp().store(&mut out);
        for (x, e) in rows.iter().zip(out) {
            assert_eq!(crate::gp::exp::exp(*x), e);
        }
    }

    /// Everything that lanes can do, once.
    #[cfg(target_arch = "x86_64")]
    fn everything<Q: Quad>(x: &[f64; LANES], y: &[f64; LANES]) -> Vec<f64> {
        Q::run(|| {
            let (a, b) = (Lanes::<Q>::from_array(x), Lanes::<Q>::from_array(y));
            let mut sum = a - b;
            sum.add_product(a / b, Lanes::of(Q::number(0.3)));
            let all = [a + b, a * b, sum, (b * b).sqrt(), a.exp(), Lanes([b.0[0].at_least(0.1); 2])];
            all.iter().flat_map(|lanes| lanes.to_array()).chain([sum.sum()]).collect()
        })
    }

    #[cfg(target_arch = "x86_64")]
    #[test]
    fn wide_registers_compute_the_same_bits() {
        assert!(Avx::is_there(), "this processor has no AVX2: leave the test out with --skip wide_registers");
        let x = std::array::from_fn(|k| (1.7 * k as f64).sin() - 2.0 * k as f64);
        let y = std::array::from_fn(|k| (0.9 * k as f64).cos() * 3.0);
        let bits = |all: Vec<f64>| all.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(bits(everything::<Avx>(&x, &y)), bits(everything::<Narrow>(&x, &y)));
    }
}
