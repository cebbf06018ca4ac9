//! The inverse Hessian matrix from the last steps, and the direction that follows from it.

use crate::gp::tall::{add_product, add_tr_product};
use nalgebra::DMatrix;
use std::ops::Range;

/// Rows of a block. Sums over rows are added block by block, so that they do not depend on the number of
/// threads.
const ROWS: usize = 256;
/// Fewest blocks for a thread: starting a thread for fewer takes longer than it saves.
const FEWEST_BLOCKS: usize = 64;
/// Least cosine between step and change: a pair at a right angle, up to rounding, is left out.
const LEAST_COSINE: f64 = f64::EPSILON;
/// The range of the diagonal.
const SMALLEST: f64 = 1e-8;
const LARGEST: f64 = 1e8;

/// The inverse of the Hessian matrix from the last pairs of steps s and changes y of the gradient (Nocedal,
/// "Updating quasi-Newton matrices with limited storage", 1980).
///
/// The initial matrix is a diagonal D, which is updated with every pair (Gilbert and Lemarechal, "Some
/// numerical experiments with variable-storage quasi-Newton algorithms", 1989, section 4.2): parameters of
/// very different curvature, such as a lengthscale and the noise variance, need steps of very different
/// length.
pub struct Curvature {
    blocks: Vec<Block>,
    memory: usize,
    /// The columns of the pairs, oldest first.
    order: Vec<usize>,
    /// The newest pair, if its products with the others are not yet computed.
    newest: Option<usize>,
    /// s_i^T y_j at (i, j), where pair i is not newer than j.
    products: DMatrix<f64>,
    /// Coefficients of the steps, those of the changes, and the sums of the blocks they follow from.
    of_steps: DMatrix<f64>,
    of_changes: DMatrix<f64>,
    with_steps: DMatrix<f64>,
    with_changes: DMatrix<f64>,
    threads: usize,
}

/// Some rows of everything that has one row for each parameter.
struct Block {
    /// The steps s, a column for each pair [rows x memory].
    steps: DMatrix<f64>,
    /// The changes y of the gradient.
    changes: DMatrix<f64>,
    /// The diagonal D [rows x 1].
    diagonal: DMatrix<f64>,
    /// The negative gradient and the newest change [rows x 2].
    gradient_and_change: DMatrix<f64>,
    /// [rows x 1].
    direction: DMatrix<f64>,
    /// This block's part of the sums over rows [memory x 2] and [memory x 1].
    with_steps: DMatrix<f64>,
    with_changes: DMatrix<f64>,
    sums: Sums,
}

/// Sums over rows.
#[derive(Clone, Copy, Default)]
struct Sums {
    /// s^T y.
    sy: f64,
    /// s^T s.
    ss: f64,
    /// y^T y.
    yy: f64,
    /// y^T D y.
    ydy: f64,
    /// s^T D^-1 s.
    sds: f64,
}

impl std::ops::Add for Sums {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            sy: self.sy + other.sy,
            ss: self.ss + other.ss,
            yy: self.yy + other.yy,
            ydy: self.ydy + other.ydy,
            sds: self.sds + other.sds,
        }
    }
}

impl Curvature {
    /// Without pairs, for this number of `parameters`; stores at most `memory` pairs.
    pub fn new(parameters: usize, memory: usize) -> Self {
        let blocks =
            (0..parameters.div_ceil(ROWS)).map(|k| Block::new(ROWS.min(parameters - k * ROWS), memory));
        Self {
            blocks: blocks.collect(),
            memory,
            order: Vec::with_capacity(memory),
            newest: None,
            products: DMatrix::zeros(memory, memory),
            of_steps: DMatrix::zeros(memory, 1),
            of_changes: DMatrix::zeros(memory, 1),
            with_steps: DMatrix::zeros(memory, 2),
            with_changes: DMatrix::zeros(memory, 1),
            threads: 1,
        }
    }

    /// Uses `threads` threads from now on, if the library has threads. The result is the same to the last
    /// bit.
    pub fn use_threads(&mut self, threads: usize) {
        self.threads = threads.max(1);
    }

    /// Whether no pair is stored.
    pub fn is_empty(&self) -> bool {
        self.order.is_empty()
    }

    /// Forgets all pairs and the diagonal.
    pub fn forget(&mut self) {
        self.order.clear();
        self.newest = None;
        self.products.fill(0.0);
        self.blocks.iter_mut().for_each(Block::forget);
    }

    /// Stores the step `s`, in which the gradient has changed by `y`, if it curves upwards. The next call
    /// must be one of [`direction_into`](Self::direction_into).
    pub fn learn(&mut self, s: &[f64], y: &[f64]) {
        debug_assert!(self.newest.is_none());
        for_each_block(&mut self.blocks, self.threads, |rows, block| block.sum(&s[rows.clone()], &y[rows]));
        let mut sums = self.blocks.iter().fold(Sums::default(), |sums, block| sums + block.sums);
        let curves = sums.sy > LEAST_COSINE * (sums.ss * sums.yy).sqrt();
        if !curves {
            return;
        }
        // The first pair sets the scale of D.
        let first = self.is_empty().then_some((sums.sy / sums.yy).clamp(SMALLEST, LARGEST));
        if let Some(scale) = first {
            (sums.ydy, sums.sds) = (scale * sums.yy, sums.ss / scale);
        }
        let column = if self.order.len() < self.memory { self.order.len() } else { self.order.remove(0) };
        self.order.push(column);
        self.newest = Some(column);
        for_each_block(&mut self.blocks, self.threads, |rows, block| {
            if let Some(scale) = first {
                block.diagonal.fill(scale);
            }
            block.learn(column, (&s[rows.clone()], &y[rows]), sums);
        });
    }

    /// Minus the inverse of the Hessian matrix times the `gradient`, without the `fixed` parameters, into
    /// `out`. A fixed parameter gets its own step.
    pub fn direction_into(&mut self, gradient: &[f64], fixed: &[Option<f64>], out: &mut [f64]) {
        let newest = self.newest.take();
        let Self { blocks, order, products, of_steps, of_changes, with_steps, with_changes, threads, .. } =
            self;
        for_each_block(blocks, *threads, |rows, block| {
            block.begin(&gradient[rows.clone()], &fixed[rows], newest);
        });
        with_steps.fill(0.0);
        blocks.iter().for_each(|block| *with_steps += &block.with_steps);
        if let Some(newest) = newest {
            products.set_column(newest, &with_steps.column(1));
        }
        // The two loops of Nocedal (1980) need only products of the vectors.
        let a = of_steps;
        a.fill(0.0);
        for (place, i) in order.iter().enumerate().rev() {
            let newer: f64 = order[place + 1..].iter().map(|j| a[*j] * products[(*i, *j)]).sum();
            a[*i] = (with_steps[(*i, 0)] - newer) / products[(*i, *i)];
        }
        of_changes.zip_apply(a, |out, a| *out = -a);
        for_each_block(blocks, *threads, |_, block| block.scale(of_changes));
        with_changes.fill(0.0);
        blocks.iter().for_each(|block| *with_changes += &block.with_changes);
        for (place, i) in order.iter().enumerate() {
            let older: f64 = order[..place].iter().map(|j| a[*j] * products[(*j, *i)]).sum();
            a[*i] -= (with_changes[*i] + older) / products[(*i, *i)];
        }
        for_each_block(blocks, *threads, |rows, block| block.end(a, &fixed[rows]));
        for (out, block) in out.chunks_mut(ROWS).zip(blocks) {
            out.copy_from_slice(block.direction.as_slice());
        }
    }
}

/// Calls `work` for every block and its rows.
fn for_each_block(blocks: &mut [Block], threads: usize, work: impl Fn(Range<usize>, &mut Block) + Sync) {
    let some = |first: usize, blocks: &mut [Block]| {
        for (k, block) in blocks.iter_mut().enumerate() {
            let begin = (first + k) * ROWS;
            work(begin..begin + block.rows(), block);
        }
    };
    let threads = threads.min(blocks.len() / FEWEST_BLOCKS);
    if cfg!(feature = "threads") && threads > 1 {
        let share = blocks.len().div_ceil(threads);
        let mut shares = blocks.chunks_mut(share).enumerate();
        let own = shares.next();
        std::thread::scope(|scope| {
            for (k, blocks) in shares {
                scope.spawn(move || some(k * share, blocks));
            }
            own.into_iter().for_each(|(_, blocks)| some(0, blocks));
        });
    } else {
        some(0, blocks);
    }
}

impl Block {
    fn new(rows: usize, memory: usize) -> Self {
        Self {
            steps: DMatrix::zeros(rows, memory),
            changes: DMatrix::zeros(rows, memory),
            diagonal: DMatrix::from_element(rows, 1, 1.0),
            gradient_and_change: DMatrix::zeros(rows, 2),
            direction: DMatrix::zeros(rows, 1),
            with_steps: DMatrix::zeros(memory, 2),
            with_changes: DMatrix::zeros(memory, 1),
            sums: Sums::default(),
        }
    }

    fn rows(&self) -> usize {
        self.steps.nrows()
    }

    fn forget(&mut self) {
        self.steps.fill(0.0);
        self.changes.fill(0.0);
        self.diagonal.fill(1.0);
    }

    /// The sums over the rows of a pair.
    fn sum(&mut self, s: &[f64], y: &[f64]) {
        let rows = s.iter().zip(y).zip(self.diagonal.as_slice());
        self.sums = rows.fold(Sums::default(), |sums, ((s, y), d)| {
            sums + Sums { sy: s * y, ss: s * s, yy: y * y, ydy: d * y * y, sds: s * s / d }
        });
    }

    /// Stores a pair, and updates D: D^-1 is scaled to fit the pair, and becomes the diagonal of its direct
    /// BFGS update.
    fn learn(&mut self, column: usize, (s, y): (&[f64], &[f64]), sums: Sums) {
        self.steps.column_mut(column).copy_from_slice(s);
        self.changes.column_mut(column).copy_from_slice(y);
        let scale = sums.ydy / sums.sy;
        for ((d, s), y) in self.diagonal.as_mut_slice().iter_mut().zip(s).zip(y) {
            let own = s / *d;
            let inverse = scale / *d + y * y / sums.sy - scale * own * own / sums.sds;
            if inverse > 0.0 {
                *d = (1.0 / inverse).clamp(SMALLEST, LARGEST);
            }
        }
    }

    /// The first pass: products of the steps with the negative gradient q and with the newest change.
    fn begin(&mut self, gradient: &[f64], fixed: &[Option<f64>], newest: Option<usize>) {
        let mut negative = self.gradient_and_change.column_mut(0);
        for (q, (g, fixed)) in negative.iter_mut().zip(gradient.iter().zip(fixed)) {
            *q = if fixed.is_some() { 0.0 } else { -g };
        }
        if let Some(newest) = newest {
            self.gradient_and_change.set_column(1, &self.changes.column(newest));
        }
        self.with_steps.fill(0.0);
        add_tr_product(&self.steps, &self.gradient_and_change, &mut self.with_steps);
    }

    /// The second pass: D (q - Y a), and its products with the changes.
    fn scale(&mut self, minus_a: &DMatrix<f64>) {
        self.direction.copy_from(&self.gradient_and_change.columns(0, 1));
        add_product(&self.changes, minus_a, &mut self.direction);
        self.direction.component_mul_assign(&self.diagonal);
        self.with_changes.fill(0.0);
        add_tr_product(&self.changes, &self.direction, &mut self.with_changes);
    }

    /// The third pass: plus S c.
    fn end(&mut self, c: &DMatrix<f64>, fixed: &[Option<f64>]) {
        add_product(&self.steps, c, &mut self.direction);
        for (d, fixed) in self.direction.iter_mut().zip(fixed) {
            *d = fixed.unwrap_or(*d);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::DVector;

    /// Steps and changes of a quadratic function with the Hessian matrix `a`.
    fn pairs(a: &DMatrix<f64>, count: usize) -> Vec<(DVector<f64>, DVector<f64>)> {
        let n = a.nrows();
        let step = |k: usize| DVector::from_fn(n, |i, _| ((i * 7 + k * 13 + 1) as f64).sin());
        (0..count).map(|k| (step(k), a * step(k))).collect()
    }

    fn direction(curvature: &mut Curvature, gradient: &[f64], fixed: &[Option<f64>]) -> DVector<f64> {
        let mut out = DVector::zeros(gradient.len());
        curvature.direction_into(gradient, fixed, out.as_mut_slice());
        out
    }

    fn hessian(n: usize) -> DMatrix<f64> {
        let b = DMatrix::from_fn(n, n, |i, j| ((i * 5 + j * 3) as f64).cos());
        &b * b.transpose() + DMatrix::from_diagonal(&DVector::from_fn(n, |i, _| 1.0 + i as f64))
    }

    /// BFGS updates of D by matrices (Nocedal and Wright, equation 6.17), with fewer pairs than are stored
    /// and with more.
    #[test]
    fn directions_agree_with_updates_of_the_whole_matrix() {
        let (n, memory) = (9, 4);
        let a = hessian(n);
        let gradient = DVector::from_fn(n, |i, _| (i as f64 * 0.7).cos());
        let fixed: Vec<Option<f64>> = (0..n).map(|i| (i == 2 || i == 5).then_some(0.1 * i as f64)).collect();
        let mut curvature = Curvature::new(n, memory);
        let all = pairs(&a, 7);
        for (k, (s, y)) in all.iter().enumerate() {
            curvature.learn(s.as_slice(), y.as_slice());
            let found = direction(&mut curvature, gradient.as_slice(), &fixed);
            let diagonal = curvature.blocks[0].diagonal.as_slice();
            let mut inverse = DMatrix::from_diagonal(&DVector::from_row_slice(diagonal));
            for (s, y) in &all[(k + 1).saturating_sub(memory)..=k] {
                let rho = 1.0 / s.dot(y);
                let v = DMatrix::identity(n, n) - y * s.transpose() * rho;
                inverse = v.tr_mul(&inverse) * &v + s * s.transpose() * rho;
            }
            let masked = DVector::from_fn(n, |i, _| if fixed[i].is_some() { 0.0 } else { gradient[i] });
            let expected =
                DVector::from_fn(n, |i, _| fixed[i].unwrap_or_else(|| -(inverse.row(i) * &masked)[0]));
            assert_relative_eq!(found, expected, max_relative = 1e-9, epsilon = 1e-12);
        }
    }

    /// The update of D^-1 times y^T D y / s^T y by matrices.
    #[test]
    fn the_diagonal_agrees_with_the_update_of_the_whole_matrix() {
        let n = 6;
        let a = hessian(n);
        let all = pairs(&a, 5);
        let mut curvature = Curvature::new(n, 3);
        let mut diagonal = DVector::zeros(n);
        for (k, (s, y)) in all.iter().enumerate() {
            if k == 0 {
                diagonal.fill(s.dot(y) / y.dot(y));
            }
            let scale = diagonal.component_mul(y).dot(y) / s.dot(y);
            let b = DMatrix::from_diagonal(&diagonal.map(|d| scale / d));
            let bs = &b * s;
            let updated = &b - &bs * bs.transpose() / s.dot(&bs) + y * y.transpose() / s.dot(y);
            diagonal = updated.diagonal().map(|b| 1.0 / b);
            curvature.learn(s.as_slice(), y.as_slice());
            direction(&mut curvature, s.as_slice(), &[None; 6]);
            let found = DVector::from_row_slice(curvature.blocks[0].diagonal.as_slice());
            assert_relative_eq!(found, diagonal, max_relative = 1e-10);
        }
    }

    #[test]
    fn leaves_out_a_pair_that_curves_downwards() {
        let mut curvature = Curvature::new(2, 3);
        curvature.learn(&[1.0, 0.0], &[-1.0, 0.0]);
        curvature.learn(&[1.0, 0.0], &[f64::NAN, 0.0]);
        curvature.learn(&[1.0, 0.0], &[0.0, 0.0]);
        assert!(curvature.is_empty());
        assert_eq!(direction(&mut curvature, &[1.0, -2.0], &[None; 2]).as_slice(), [-1.0, 2.0]);
    }
}
