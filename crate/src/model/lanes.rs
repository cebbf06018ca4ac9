//! Eight numbers side by side: what the sums over rows are made of.

use super::exp::exp_below;
use wide::f64x2;

/// Rows that are worked on side by side.
pub const LANES: usize = 8;
/// Two numbers fill a register, native (SSE2) and in wasm (simd128).
const PAIRS: usize = LANES / 2;

/// One number for each of [`LANES`] rows.
#[derive(Clone, Copy, Debug)]
pub struct Lanes(pub [f64x2; PAIRS]);

impl Lanes {
    pub const ZERO: Self = Self([f64x2::ZERO; PAIRS]);

    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Self([f64x2::splat(value); PAIRS])
    }

    /// The first [`LANES`] of `rows`; zero past the end.
    #[inline(always)]
    pub fn load(rows: &[f64]) -> Self {
        match rows.first_chunk::<LANES>() {
            Some(full) => Self(std::array::from_fn(|k| f64x2::new([full[2 * k], full[2 * k + 1]]))),
            None => {
                let mut full = [0.0; LANES];
                for (to, from) in full.iter_mut().zip(rows) {
                    *to = *from;
                }
                Self::load(&full)
            }
        }
    }

    /// Into the first [`LANES`] of `rows`, as many as there are.
    #[inline(always)]
    pub fn store(self, rows: &mut [f64]) {
        match rows.first_chunk_mut::<LANES>() {
            Some(full) => {
                for k in 0..PAIRS {
                    [full[2 * k], full[2 * k + 1]] = self.0[k].to_array();
                }
            }
            None => {
                let mut full = [0.0; LANES];
                self.store(&mut full);
                for (to, from) in rows.iter_mut().zip(full) {
                    *to = from;
                }
            }
        }
    }

    #[inline(always)]
    pub fn map(self, f: impl Fn(f64x2) -> f64x2) -> Self {
        Self(self.0.map(f))
    }

    /// e to each of them; none may be above 709.
    #[inline(always)]
    pub fn exp(self) -> Self {
        self.map(exp_below)
    }

    /// self += x y.
    #[inline(always)]
    pub fn add_product(&mut self, x: Self, y: Self) {
        for k in 0..PAIRS {
            self.0[k] += x.0[k] * y.0[k];
        }
    }

    #[inline(always)]
    pub fn sum(self) -> f64 {
        let [a, b, c, d] = self.0;
        let [low, high] = ((a + c) + (b + d)).to_array();
        low + high
    }
}

macro_rules! lanewise {
    ($trait:ident, $method:ident, $op:tt) => {
        impl std::ops::$trait for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(std::array::from_fn(|k| self.0[k] $op other.0[k]))
            }
        }
    };
}
lanewise!(Add, add, +);
lanewise!(Sub, sub, -);
lanewise!(Mul, mul, *);
lanewise!(Div, div, /);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_what_there_is_and_stores_what_fits() {
        let rows: Vec<f64> = (1..=11).map(f64::from).collect();
        assert_eq!(Lanes::load(&rows).sum(), 36.0);
        assert_eq!(Lanes::load(&rows[8..]).sum(), 30.0);
        let mut out = [0.0; 3];
        (Lanes::load(&rows) + Lanes::splat(1.0)).store(&mut out);
        assert_eq!(out, [2.0, 3.0, 4.0]);
    }

    #[test]
    fn exponentials_are_those_of_single_numbers() {
        let rows: Vec<f64> = (0..8).map(|k| -3.7 * f64::from(k * k)).collect();
        let mut out = [0.0; 8];
        Lanes::load(&rows).exp().store(&mut out);
        for (x, e) in rows.iter().zip(out) {
            assert_eq!(super::super::exp::exp(*x), e);
        }
    }
}
