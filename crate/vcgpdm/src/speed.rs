//! What one bound with its gradient has to compute, and how fast this machine computes such things (feature
//! `speed`).

use crate::gp::lanes::{LANES, Lanes, Quad, Stored, in_widest_registers};
use crate::models::variational::{Objective, Params};
use std::hint::black_box;
use std::time::Instant;

/// The loops over rows of one bound with its gradient, counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// One for every row and inducing input (psi1), and one for every row and pair of them (psi2).
    pub exponentials: usize,
    /// Multiplications with an addition, outside the exponentials.
    pub multiply_adds: usize,
}

impl Work {
    /// The work of the bound and its gradient at `params`.
    pub fn new(objective: &Objective, params: &Params) -> Self {
        let mut work = Self::default();
        let (frames, transitions) = (objective.sequences().frames(), objective.sequences().transitions());
        for (part, y) in params.parts.iter().zip(objective.observations()) {
            work.add_psi(frames, part.r.shape());
            // b = psi1^T Y, and dF/dpsi1 = Y dF/db^T.
            work.multiply_adds += 2 * frames * part.r.nrows() * y.ncols();
        }
        for (i, part) in params.parts.iter().enumerate() {
            for (j, row) in params.experts.iter().enumerate() {
                let ips = row[i].z.nrows();
                work.add_psi(transitions, row[i].z.shape());
                // psi1^T mu, and its adjoints for psi1 and for mu.
                work.multiply_adds += 3 * transitions * ips * part.latents.mean.ncols();
                for (l, other) in params.experts.iter().enumerate().filter(|(l, _)| *l != j) {
                    // psi1^T psi1 once for two sources, its adjoint for each.
                    let products = if l < j { 2 } else { 1 };
                    work.multiply_adds += products * transitions * ips * other[i].z.nrows();
                }
            }
        }
        work
    }

    fn add_psi(&mut self, rows: usize, (ips, dims): (usize, usize)) {
        let pairs = ips * (ips + 1) / 2;
        self.exponentials += rows * (ips + pairs);
        let exponents = ips * 4 * dims + pairs * dims;
        let adjoint = ips * ips * (1 + dims) + 2 * ips * 3 * dims;
        self.multiply_adds += rows * (exponents + adjoint);
    }
}

/// How fast one thread of this machine is with operands at hand, in the registers that the sums over rows are
/// computed in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// Exponentials a second.
    pub exponentials: f64,
    /// Multiplications with an addition, a second.
    pub multiply_adds: f64,
}

impl Rates {
    /// Measures for about a fifth of a second.
    pub fn measure() -> Self {
        in_widest_registers!(Q => Self::of::<Q>())
    }

    fn of<Q: Quad>() -> Self {
        const ROWS: usize = 512;
        const TIMES: usize = 2_000;
        let x: Vec<Stored> = (0..ROWS).map(|k| Stored([-0.01 * k as f64; LANES])).collect();
        let mut out = x.clone();
        let count = (LANES * ROWS * TIMES) as f64;
        let seconds = best_of(&mut || {
            Q::run(|| {
                for _ in 0..TIMES {
                    for (out, x) in out.iter_mut().zip(black_box(&x)) {
                        *out = Stored(Lanes::<Q>::from_array(&x.0).exp().to_array());
                    }
                    black_box(&mut out);
                }
            });
        });
        let exponentials = count / seconds;
        let factor = black_box([0.999, 0.5]).map(Lanes::<Q>::splat);
        let seconds = best_of(&mut || {
            Q::run(|| {
                for _ in 0..TIMES {
                    // Two sums are enough registers to hide an addition's latency.
                    let mut sums = [Lanes::zero(); 2];
                    for x in black_box(&x) {
                        let x = Lanes::from_array(&x.0);
                        sums[0].add_product(x, factor[0]);
                        sums[1].add_product(x, factor[1]);
                    }
                    black_box(&sums);
                }
            });
        });
        Self { exponentials, multiply_adds: 2.0 * count / seconds }
    }
}

fn best_of(work: &mut dyn FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..5 {
        let begin = Instant::now();
        work();
        best = best.min(begin.elapsed().as_secs_f64());
    }
    best
}
