//! The psi statistics of all rows, and their adjoints.

use crate::gp::gaussians::Gaussians;
use crate::gp::kernel::{Kernel, KernelAdjoint};
use crate::gp::lanes::{LANES, Level, Simd, Stored, dispatch};
use crate::gp::psi::block::{BLOCK, Block, PullBack};
use nalgebra::DMatrix;

/// Upper limit for the cached terms of psi2 (32 MB); above it the backward pass computes them again.
const MOST_CACHED: usize = 4 << 20;

/// The psi statistics at K inducing inputs, with the memory to compute them again.
pub struct PsiStatistics {
    /// Sum over rows of psi0.
    pub psi0: f64,
    /// psi1 [N x K].
    pub psi1: DMatrix<f64>,
    /// Sum over rows of psi2 [K x K], symmetric.
    pub psi2: DMatrix<f64>,
    /// - sum_q (z_aq - z_bq)^2 / (4 lambda_q) of every pair b <= a.
    spread: Vec<f64>,
    passes: Box<dyn Passes>,
}

/// Both passes over all rows, for one level of instructions.
trait Passes: Send + Sync {
    /// Computes psi1 and psi2.
    fn forward(
        &mut self,
        arguments: (&Gaussians, &DMatrix<f64>, &Kernel),
        spread: &[f64],
        psi1: &mut DMatrix<f64>,
        psi2: &mut DMatrix<f64>,
        workspace: &mut PairWorkspace,
    );

    /// Adds the adjoints that depend on the rows.
    fn backward(
        &mut self,
        arguments: (&Gaussians, &Kernel),
        statistics: (&DMatrix<f64>, &[f64]),
        adjoint: &PsiAdjoint,
        workspace: &mut PairWorkspace,
        into_x: &mut Gaussians,
        into_kernel: &mut KernelAdjoint,
    );
}

/// Scratch memory for a block of rows.
struct BlockBuffers<S: Simd> {
    block: Block<S>,
    pull: PullBack<S>,
}

/// Memory for the terms of psi2. Several [`PsiStatistics`] can use it in turn, but not between
/// [`PsiStatistics::compute`] and its [`PsiStatistics::pull_back`].
#[derive(Default)]
pub struct PairWorkspace {
    /// The terms, a chunk of rows after the other, and in each chunk pair after pair.
    values: Vec<Stored>,
    /// Whether the terms of all rows are stored, not only those of the last block.
    whole: bool,
}

/// What the statistics are computed for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Only for their values.
    Value,
    /// For a gradient: [`PsiStatistics::pull_back`] follows.
    Gradient,
}

/// dF with respect to the psi statistics, where F is any function of them.
pub struct PsiAdjoint<'a> {
    /// dF/dpsi0.
    pub psi0: f64,
    /// dF/dpsi1 [N x K].
    pub psi1: &'a DMatrix<f64>,
    /// dF/dpsi2 [K x K], symmetric, every entry counted once.
    pub psi2: &'a DMatrix<f64>,
}

impl PsiStatistics {
    /// For N = `rows` inputs and K = `ips` inducing inputs of P = `dims` dimensions.
    pub fn new(rows: usize, ips: usize, dims: usize) -> Self {
        Self::with_level(Level::new(), rows, ips, dims)
    }

    /// [`new`](Self::new) for one level of instructions; all levels give the same bits.
    pub(super) fn with_level(level: Level, rows: usize, ips: usize, dims: usize) -> Self {
        Self {
            psi0: 0.0,
            psi1: DMatrix::zeros(rows, ips),
            psi2: DMatrix::zeros(ips, ips),
            spread: vec![0.0; ips * (ips + 1) / 2],
            passes: dispatch!(level, simd => passes(simd, ips, dims)),
        }
    }

    /// Computes psi0, psi1 and psi2 of the inputs `x` [N x P] at the inducing inputs `z` [K x P].
    pub fn compute(
        &mut self,
        x: &Gaussians,
        z: &DMatrix<f64>,
        kernel: &Kernel,
        purpose: Purpose,
        workspace: &mut PairWorkspace,
    ) {
        let (rows, ips, pairs) = (x.mean.nrows(), z.nrows(), self.spread.len());
        let mut spread = self.spread.iter_mut();
        for a in 0..ips {
            for (b, spread) in (0..=a).zip(&mut spread) {
                let square = |q: usize| (z[(a, q)] - z[(b, q)]).powi(2) / kernel.lambda[q];
                *spread = -0.25 * (0..z.ncols()).map(square).sum::<f64>();
            }
        }
        workspace.whole = purpose == Purpose::Gradient && (rows + LANES) * pairs <= MOST_CACHED;
        let chunks = if workspace.whole { rows.div_ceil(LANES) } else { BLOCK / LANES };
        workspace.values.resize(chunks * pairs, Stored::default());
        self.psi0 = rows as f64 * kernel.variance;
        self.passes.forward((x, z, kernel), &self.spread, &mut self.psi1, &mut self.psi2, workspace);
    }

    /// The backward pass of [`compute`](Self::compute): from dF with respect to the statistics to dF with
    /// respect to the arguments, which must be the same as then. It is added to `into_x` and `into_kernel`.
    pub fn pull_back(
        &mut self,
        (x, z, kernel): (&Gaussians, &DMatrix<f64>, &Kernel),
        adjoint: &PsiAdjoint,
        workspace: &mut PairWorkspace,
        into_x: &mut Gaussians,
        into_kernel: &mut KernelAdjoint,
    ) {
        into_kernel.variance += x.mean.nrows() as f64 * adjoint.psi0;
        let statistics = (&self.psi1, self.spread.as_slice());
        self.passes.backward((x, kernel), statistics, adjoint, workspace, into_x, into_kernel);
        // The factors that do not depend on the row: sigma^2 and sigma^4, and the distance of a pair.
        let psi1_total = adjoint.psi1.dot(&self.psi1);
        let psi2_total = adjoint.psi2.dot(&self.psi2);
        into_kernel.variance += (psi1_total + 2.0 * psi2_total) / kernel.variance;
        for q in 0..z.ncols() {
            let lambda = kernel.lambda[q];
            into_kernel.lambda[q] += 0.5 * (psi1_total + psi2_total) / lambda;
            for a in 0..z.nrows() {
                for b in 0..a {
                    let h = 2.0 * adjoint.psi2[(a, b)] * self.psi2[(a, b)];
                    let d = (z[(a, q)] - z[(b, q)]) / lambda;
                    into_kernel.lambda[q] += 0.25 * h * d * d;
                    into_kernel.z[(a, q)] -= 0.5 * h * d;
                    into_kernel.z[(b, q)] += 0.5 * h * d;
                }
            }
        }
    }
}

fn passes<S: Simd>(simd: S, ips: usize, dims: usize) -> Box<dyn Passes> {
    Box::new(BlockBuffers { block: Block::new(simd, ips, dims), pull: PullBack::new(simd, ips, dims) })
}

impl<S: Simd> Passes for BlockBuffers<S> {
    fn forward(
        &mut self,
        (x, z, kernel): (&Gaussians, &DMatrix<f64>, &Kernel),
        spread: &[f64],
        psi1: &mut DMatrix<f64>,
        psi2: &mut DMatrix<f64>,
        workspace: &mut PairWorkspace,
    ) {
        let (rows, block) = (x.mean.nrows(), &mut self.block);
        block.set_inducing_inputs(z);
        for start in (0..rows).step_by(BLOCK) {
            let len = BLOCK.min(rows - start);
            block.load(x, start, len, kernel, 1.0);
            for a in 0..z.nrows() {
                block.psi1(a, &mut psi1.as_mut_slice()[a * rows + start..][..len]);
            }
            block.load(x, start, len, kernel, 2.0);
            block.split_exponent();
            block.psi2(spread, workspace.block_mut(start, spread.len()), true);
        }
        block.psi2_sums(psi2);
    }

    fn backward(
        &mut self,
        (x, kernel): (&Gaussians, &Kernel),
        (psi1, spread): (&DMatrix<f64>, &[f64]),
        adjoint: &PsiAdjoint,
        workspace: &mut PairWorkspace,
        into_x: &mut Gaussians,
        into_kernel: &mut KernelAdjoint,
    ) {
        let rows = x.mean.nrows();
        let (block, pull) = (&mut self.block, &mut self.pull);
        for start in (0..rows).step_by(BLOCK) {
            let len = BLOCK.min(rows - start);
            block.load(x, start, len, kernel, 1.0);
            pull.psi1(block, psi1, adjoint.psi1, start, len);
            pull.scatter(block, start, len, into_x, into_kernel);
            block.load(x, start, len, kernel, 2.0);
            if !workspace.whole {
                block.split_exponent();
                block.psi2(spread, workspace.block_mut(start, spread.len()), false);
            }
            pull.psi2(block, adjoint.psi2, workspace.block_mut(start, spread.len()));
            pull.scatter(block, start, len, into_x, into_kernel);
        }
    }
}

impl PairWorkspace {
    /// The terms of the block that begins at row `start`.
    fn block_mut(&mut self, start: usize, pairs: usize) -> &mut [Stored] {
        let from = if self.whole { start / LANES * pairs } else { 0 };
        let end = self.values.len().min(from + BLOCK / LANES * pairs);
        &mut self.values[from..end]
    }
}
