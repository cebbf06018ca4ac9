//! Eight numbers side by side, on which the sums over rows are computed.

use crate::gp::exp::exp_below;
use wide::f64x2;

/// Rows that are computed side by side.
pub const LANES: usize = 8;
/// Two numbers fill a register, natively (SSE2) and in wasm (simd128).
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
            Some(full) => Self::from_array(full),
            None => Self::load_end(rows),
        }
    }

    #[inline(always)]
    pub fn from_array([a, b, c, d, e, f, g, h]: &[f64; LANES]) -> Self {
        Self([f64x2::new([*a, *b]), f64x2::new([*c, *d]), f64x2::new([*e, *f]), f64x2::new([*g, *h])])
    }

    #[inline(never)]
    fn load_end(rows: &[f64]) -> Self {
        let mut full = [0.0; LANES];
        for (to, from) in full.iter_mut().zip(rows) {
            *to = *from;
        }
        Self::from_array(&full)
    }

    /// Into the first [`LANES`] of `rows`, as many as there are.
    #[inline(always)]
    pub fn store(self, rows: &mut [f64]) {
        let [a, b, c, d] = self.0;
        let (a, b, c, d) = (a.to_array(), b.to_array(), c.to_array(), d.to_array());
        let full = [a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]];
        match rows.first_chunk_mut::<LANES>() {
            Some(rows) => *rows = full,
            None => Self::store_end(&full, rows),
        }
    }

    #[inline(never)]
    fn store_end(full: &[f64; LANES], rows: &mut [f64]) {
        for (to, from) in rows.iter_mut().zip(full) {
            *to = *from;
        }
    }

    #[inline(always)]
    pub fn map(self, f: impl Fn(f64x2) -> f64x2) -> Self {
        // Written out: `array::map` is a call where little is inlined, as in the wasm package.
        let [a, b, c, d] = self.0;
        Self([f(a), f(b), f(c), f(d)])
    }

    /// The exponential of each number; all must be at most 709.
    #[inline(always)]
    pub fn exp(self) -> Self {
        let [a, b, c, d] = self.0;
        let low: [f64x2; 2] = bytemuck::cast(exp_below(bytemuck::cast([a, b])));
        let high: [f64x2; 2] = bytemuck::cast(exp_below(bytemuck::cast([c, d])));
        Self([low[0], low[1], high[0], high[1]])
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
                let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
                Self([a $op e, b $op f, c $op g, d $op h])
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
            assert_eq!(crate::gp::exp::exp(*x), e);
        }
    }
}
