//! Eight numbers that are computed together, in the widest registers of the processor.
//!
//! Every level of instructions computes each number by the same additions and multiplications, none of them
//! fused (FMA): otherwise a model would depend on the processor that trained it.

use fearless_simd::prelude::*;
pub use fearless_simd::{Level, Simd, dispatch, f64x8};

/// Rows that are computed together.
pub const LANES: usize = 8;

/// One number for each of [`LANES`] rows.
pub type Lanes<S> = f64x8<S>;

/// One number for each of [`LANES`] rows in memory, aligned to a line of the cache.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub struct Stored(pub [f64; LANES]);

/// The same number in every lane.
#[inline(always)]
pub fn splat<S: Simd>(simd: S, value: f64) -> Lanes<S> {
    f64x8::splat(simd, value)
}

/// The first [`LANES`] of `rows`; zero past the end.
#[inline(always)]
pub fn load<S: Simd>(simd: S, rows: &[f64]) -> Lanes<S> {
    match rows.first_chunk::<LANES>() {
        Some(full) => f64x8::from_slice(simd, full),
        None => f64x8::from_slice(simd, &load_end(rows)),
    }
}

/// Writes the lanes into the first [`LANES`] of `rows`, or into all when there are fewer.
#[inline(always)]
pub fn store<S: Simd>(lanes: Lanes<S>, rows: &mut [f64]) {
    match rows.first_chunk_mut::<LANES>() {
        Some(rows) => lanes.store_slice(rows),
        None => {
            let mut full = [0.0; LANES];
            lanes.store_slice(&mut full);
            store_end(&full, rows);
        }
    }
}

/// The sum of all lanes.
#[inline(always)]
pub fn sum<S: Simd>(lanes: Lanes<S>) -> f64 {
    let (low, high) = lanes.split();
    let mut sums = [0.0; 4];
    (low + high).store_slice(&mut sums);
    let [a, b, c, d] = sums;
    (a + c) + (b + d)
}

// Out of line: otherwise the code for the last rows would be copied into every loop.
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

/// All levels of instructions of this processor.
#[cfg(test)]
pub fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let narrower = [
        best.as_sse2().map(Level::Sse2),
        best.as_sse4_2().map(Level::Sse4_2),
        best.as_avx2().map(Level::Avx2),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let narrower: [Option<Level>; 0] = [];
    narrower.into_iter().flatten().chain([best]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gp::exp::{exp, exp_lanes};

    /// All operations on lanes, with every level.
    fn results(level: Level, x: &[f64; LANES], y: &[f64; LANES]) -> Vec<f64> {
        fn all<S: Simd>(simd: S, x: &[f64; LANES], y: &[f64; LANES]) -> Vec<f64> {
            let (a, b) = (load(simd, x), load(simd, y));
            let all =
                [a + b, a - b, a * b, a / b, (b * b).sqrt(), exp_lanes(a), a - b + a * splat(simd, 0.3)];
            let mut out = vec![0.0; all.len() * LANES];
            for (lanes, out) in all.iter().zip(out.chunks_exact_mut(LANES)) {
                store(*lanes, out);
            }
            out.push(sum(a * b));
            out
        }
        dispatch!(level, simd => all(simd, x, y))
    }

    #[test]
    fn loads_and_stores_fewer_rows_than_lanes() {
        fn check<S: Simd>(simd: S) {
            let rows: Vec<f64> = (1..=11).map(f64::from).collect();
            assert_eq!(sum(load(simd, &rows)), 36.0);
            assert_eq!(sum(load(simd, &rows[8..])), 30.0);
            let mut out = [0.0; 3];
            store(load(simd, &rows) + splat(simd, 1.0), &mut out);
            assert_eq!(out, [2.0, 3.0, 4.0]);
        }
        dispatch!(Level::new(), simd => check(simd));
    }

    #[test]
    fn every_level_computes_the_same_bits() {
        let x = std::array::from_fn(|k| (1.7 * k as f64).sin() - 90.0 * k as f64);
        let y = std::array::from_fn(|k| (0.9 * k as f64).cos() * 3.0);
        let bits = |level| results(level, &x, &y).into_iter().map(f64::to_bits).collect::<Vec<_>>();
        let expected = bits(Level::new());
        for level in levels() {
            assert_eq!(bits(level), expected, "{level:?}");
        }
        let exponentials = &results(Level::new(), &x, &y)[5 * LANES..6 * LANES];
        assert_eq!(exponentials, x.map(exp));
    }
}
