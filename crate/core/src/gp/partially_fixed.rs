//! The bound of a stack of processes of which some inducing outputs are fixed: those of the first processes
//! are stored ones, all others are optimal for the rows.

use crate::gp::bound::{BoundAdjoint, BoundWorkspace, SparseGp};
use crate::gp::linalg::NumericsError;
use crate::gp::stored_outputs::StoredOutputs;
use nalgebra::DMatrix;

/// The bound of a stack of two blocks, with memory for it: the outputs of block h are fixed, N(m, S), block f
/// is collapsed.
///
/// Block f explains what q(u_h) = N(m, S) leaves of the rows, b' = b_f - Psi2_fh K_hh^-1 m. With A = K_ff +
/// Psi2_ff / n, and the symbols of [`crate::gp::bound`], the optimal q(u_f) gives
///
/// F = G_h + C/2 ( log|K_ff| - log|A| ) + tr( b'^T A^-1 b' ) / (2 n^2) + C tr( K_ff^-1 Psi2_ff ) / (2n),
///
/// where G_h is the bound of the stored block with all of psi0, c2 and the rows ([`StoredOutputs`]); the rest
/// is the collapsed bound of block f for b' with none of them.
pub struct PartiallyFixed {
    stored: StoredOutputs,
    free: BoundWorkspace,
    /// Blocks of K, Psi2 and b.
    stored_blocks: Blocks,
    free_blocks: Blocks,
    pub(super) adjoint: BoundAdjoint,
}

/// One block of the stack.
struct Blocks {
    k: DMatrix<f64>,
    psi2: DMatrix<f64>,
    b: DMatrix<f64>,
}

impl Blocks {
    fn zeros(points: usize, columns: usize) -> Self {
        let square = || DMatrix::zeros(points, points);
        Self { k: square(), psi2: square(), b: DMatrix::zeros(points, columns) }
    }

    /// Copies the block of the stack that starts at `at`.
    fn copy_from(&mut self, gp: &SparseGp<'_>, at: usize) {
        let points = self.b.nrows();
        self.k.copy_from(&gp.k.view((at, at), (points, points)));
        self.psi2.copy_from(&gp.psi2.view((at, at), (points, points)));
        self.b.copy_from(&gp.b.rows(at, points));
    }

    fn gp<'a>(&'a self, whole: &SparseGp<'a>) -> SparseGp<'a> {
        SparseGp { k: &self.k, psi2: &self.psi2, b: &self.b, ..*whole }
    }
}

impl PartiallyFixed {
    /// For a stack of `points` inducing points with C = `columns` target columns, of which the first are
    /// stored.
    pub fn new(stored: StoredOutputs, points: usize, columns: usize) -> Self {
        let first = stored.points();
        let others = points.saturating_sub(first);
        Self {
            free: BoundWorkspace::new(others, columns),
            stored_blocks: Blocks::zeros(first, columns),
            free_blocks: Blocks::zeros(others, columns),
            adjoint: BoundAdjoint::zeros(points, columns),
            stored,
        }
    }

    /// The adjoint of the last [`bound_and_adjoint`](Self::bound_and_adjoint).
    pub fn adjoint(&self) -> &BoundAdjoint {
        &self.adjoint
    }

    /// Copies both blocks, with b' in place of b_f.
    fn divide(&mut self, gp: &SparseGp<'_>) {
        let first = self.stored.points();
        self.stored_blocks.copy_from(gp, 0);
        self.free_blocks.copy_from(gp, first);
        let cross = gp.psi2.view((first, 0), (self.free_blocks.b.nrows(), first));
        // By columns, because a product of larger matrices differs between processors.
        for (mut b, m) in self.free_blocks.b.column_iter_mut().zip(self.stored.coefficients().column_iter()) {
            b.gemv(-1.0, &cross, &m, 1.0);
        }
    }

    /// The bound, in nats.
    pub fn bound(&mut self, gp: &SparseGp<'_>) -> Result<f64, NumericsError> {
        self.divide(gp);
        let Self { stored, free, stored_blocks, free_blocks, .. } = self;
        let rest = SparseGp { rows: 0, psi0: 0.0, second_moment: 0.0, ..free_blocks.gp(gp) };
        Ok(stored.bound(&stored_blocks.gp(gp)) + rest.bound(free)?)
    }

    /// The bound, in nats. Its adjoint is then [`adjoint`](Self::adjoint).
    pub fn bound_and_adjoint(&mut self, gp: &SparseGp<'_>) -> Result<f64, NumericsError> {
        self.divide(gp);
        let Self { stored, free, stored_blocks, free_blocks, adjoint } = self;
        let rest = SparseGp { rows: 0, psi0: 0.0, second_moment: 0.0, ..free_blocks.gp(gp) };
        let bound = stored.bound_and_adjoint(&stored_blocks.gp(gp)) + rest.bound_and_adjoint(free)?;
        let (stored_adjoint, free_adjoint) = (stored.adjoint(), free.adjoint());
        let (first, others) = (stored_adjoint.b.nrows(), free_adjoint.b.nrows());
        adjoint.k.view_mut((first, first), (others, others)).copy_from(&free_adjoint.k);
        adjoint.psi2.view_mut((0, 0), (first, first)).copy_from(&stored_adjoint.psi2);
        adjoint.psi2.view_mut((first, first), (others, others)).copy_from(&free_adjoint.psi2);
        adjoint.b.rows_mut(0, first).copy_from(&stored_adjoint.b);
        adjoint.b.rows_mut(first, others).copy_from(&free_adjoint.b);
        // Psi2_fh is in the stack twice, as itself and transposed: each copy gets half of its adjoint.
        for h in 0..first {
            for f in 0..others {
                let product: f64 = free_adjoint.b.row(f).dot(&stored.coefficients().row(h));
                adjoint.psi2[(first + f, h)] = -0.5 * product;
                adjoint.psi2[(h, first + f)] = -0.5 * product;
            }
        }
        (adjoint.psi0, adjoint.second_moment) = (stored_adjoint.psi0, stored_adjoint.second_moment);
        adjoint.noise = stored_adjoint.noise + free_adjoint.noise;
        Ok(bound)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gp::testing::{Example, scalars_agree};
    use approx::assert_relative_eq;

    /// Six inducing points, of which the first `FIRST` are stored.
    const FIRST: usize = 2;

    /// Sets the entries between both blocks to zero.
    fn separate(m: &mut DMatrix<f64>) {
        for h in 0..FIRST {
            for f in FIRST..6 {
                (m[(h, f)], m[(f, h)]) = (0.0, 0.0);
            }
        }
    }

    /// Two independent processes.
    fn example() -> Example {
        let mut e = Example::new(6);
        separate(&mut e.k);
        e
    }

    /// With the stored outputs that are optimal for the first block alone.
    fn partially_fixed(e: &Example) -> PartiallyFixed {
        let mut blocks = Blocks::zeros(FIRST, 3);
        blocks.copy_from(&e.gp(), 0);
        PartiallyFixed::new(StoredOutputs::best(&blocks.gp(&e.gp())).unwrap(), 6, 3)
    }

    fn divergence(mean: &DMatrix<f64>, covariance: &DMatrix<f64>, k: &DMatrix<f64>) -> f64 {
        let inverse = k.clone().try_inverse().unwrap();
        let (points, columns) = mean.shape();
        0.5 * columns as f64
            * ((k.determinant() / covariance.determinant()).ln() - points as f64
                + (&inverse * covariance).trace())
            + 0.5 * mean.dot(&(&inverse * mean))
    }

    #[test]
    fn independent_blocks_give_the_collapsed_bound_of_both() {
        let mut e = example();
        separate(&mut e.psi2);
        let collapsed = e.gp().bound(&mut BoundWorkspace::new(6, 3)).unwrap();
        let mut blocks = Blocks::zeros(FIRST, 3);
        blocks.copy_from(&e.gp(), 0);
        let best = blocks.gp(&e.gp()).posterior().unwrap();
        let divergence = divergence(&best.mean, &best.covariance, &blocks.k);
        let bound = partially_fixed(&e).bound(&e.gp()).unwrap();
        assert_relative_eq!(bound - divergence, collapsed, max_relative = 1e-10);
    }

    /// The collapsed bound of both blocks is larger, because it optimises all outputs together.
    #[test]
    fn stored_outputs_are_worse_than_optimal_ones() {
        let e = example();
        let collapsed = e.gp().bound(&mut BoundWorkspace::new(6, 3)).unwrap();
        let mut blocks = Blocks::zeros(FIRST, 3);
        blocks.copy_from(&e.gp(), 0);
        let best = blocks.gp(&e.gp()).posterior().unwrap();
        let divergence = divergence(&best.mean, &best.covariance, &blocks.k);
        assert!(partially_fixed(&e).bound(&e.gp()).unwrap() - divergence < collapsed - 1e-3);
    }

    #[test]
    fn without_stored_outputs_it_is_the_collapsed_bound() {
        let e = example();
        let none = DMatrix::zeros(0, 0);
        let stored = StoredOutputs::new(&none, &none, DMatrix::zeros(0, 3)).unwrap();
        let collapsed = e.gp().bound(&mut BoundWorkspace::new(6, 3)).unwrap();
        let bound = PartiallyFixed::new(stored, 6, 3).bound(&e.gp()).unwrap();
        assert_relative_eq!(bound, collapsed, max_relative = 1e-12);
    }

    #[test]
    fn adjoint_agrees_with_differences() {
        let e = example();
        let mut stack = partially_fixed(&e);
        let value = stack.bound_and_adjoint(&e.gp()).unwrap();
        assert_relative_eq!(value, stack.bound(&e.gp()).unwrap(), max_relative = 1e-14);
        let adjoint = stack.adjoint.clone();
        let mut difference = |change: &dyn Fn(&mut Example, f64)| {
            let mut bound = |h: f64| {
                let mut moved = e.clone();
                change(&mut moved, h);
                stack.bound(&moved.gp()).unwrap()
            };
            (bound(1e-6) - bound(-1e-6)) / 2e-6
        };
        for i in 0..6 {
            for j in 0..=i {
                // K and Psi2 are symmetric: both entries move.
                let both = |m: &DMatrix<f64>| if i == j { m[(i, j)] } else { m[(i, j)] + m[(j, i)] };
                let d = difference(&|e, h| {
                    e.psi2[(i, j)] += h;
                    e.psi2[(j, i)] = e.psi2[(i, j)];
                });
                assert_relative_eq!(both(&adjoint.psi2), d, epsilon = 1e-5, max_relative = 1e-5);
                if j >= FIRST {
                    let d = difference(&|e, h| {
                        e.k[(i, j)] += h;
                        e.k[(j, i)] = e.k[(i, j)];
                    });
                    assert_relative_eq!(both(&adjoint.k), d, epsilon = 1e-5, max_relative = 1e-5);
                } else {
                    assert_eq!(both(&adjoint.k), 0.0);
                }
            }
            for c in 0..3 {
                let d = difference(&|e, h| e.b[(i, c)] += h);
                assert_relative_eq!(adjoint.b[(i, c)], d, epsilon = 1e-6, max_relative = 1e-6);
            }
        }
        scalars_agree(&adjoint, difference);
    }
}
