//! What the last steps tell of the curvature, and the direction that follows from it.

use crate::gp::tall::{add_product, add_tr_product};
use nalgebra::DMatrix;
use std::ops::Range;

/// Rows that are computed together: what is summed over rows is summed block by block, in their order,
/// whatever the number of threads.
const ROWS: usize = 256;
/// A thread gets at least so many blocks: for fewer it does not pay to wake it.
const FEWEST: usize = 64;
/// A pair is left out when step and change make a right angle, up to rounding: the cosine that it must have.
const LEAST_COSINE: f64 = f64::EPSILON;
/// The range of the diagonal.
const SMALLEST: f64 = 1e-8;
const LARGEST: f64 = 1e8;

/// The inverse of the Hessian matrix as the last pairs of steps s and changes y of the gradient have it
/// (Nocedal, "Updating quasi-Newton matrices with limited storage", 1980).
///
/// It begins with a diagonal D, which learns from every pair (Gilbert and Lemarechal, "Some numerical
/// experiments with variable-storage quasi-Newton algorithms", 1989, section 4.2): parameters of very
/// different curvature, such as a lengthscale and the noise variance, need steps of very different length.
pub struct Curvature {
    blocks: Vec<Block>,
    memory: usize,
    /// The columns of the pairs, oldest first.
    order: Vec<usize>,
    /// The newest pair, whose products with the others are not yet known.
    newest: Option<usize>,
    /// s_i^T y_j at (i, j), where pair i is not newer than j.
    products: DMatrix<f64>,
    threads: usize,
}

/// Some rows of all that has one for each parameter.
struct Block {
    /// The steps s, a column for each pair [rows x memory].
    steps: DMatrix<f64>,
    /// The changes y of the gradient.
    changes: DMatrix<f64>,
    /// The diagonal D [rows x 1].
    diagonal: DMatrix<f64>,
    /// The direction in the making, and the newest change beside it [rows x 2].
    beside: DMatrix<f64>,
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
    /// Of so many parameters; so many pairs are remembered.
    pub fn new(parameters: usize, memory: usize) -> Self {
        let blocks =
            (0..parameters.div_ceil(ROWS)).map(|k| Block::new(ROWS.min(parameters - k * ROWS), memory));
        Self {
            blocks: blocks.collect(),
            memory,
            order: Vec::with_capacity(memory),
            newest: None,
            products: DMatrix::zeros(memory, memory),
            threads: 1,
        }
    }

    /// Works in so many threads from now on, if the library has threads, and to the same bits.
    pub fn use_threads(&mut self, threads: usize) {
        self.threads = threads.max(1);
    }

    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        self.order.is_empty()
    }

    /// Knows nothing, as at the beginning.
    pub fn forget(&mut self) {
        self.order.clear();
        self.newest = None;
        self.products.fill(0.0);
        for block in &mut self.blocks {
            *block = Block::new(block.rows(), self.memory);
        }
    }

    /// Learns from the step `s`, in which the gradient has changed by `y`, if it curves upwards. A direction
    /// must be asked for before the next.
    pub fn learn(&mut self, s: &[f64], y: &[f64]) {
        debug_assert!(self.newest.is_none());
        self.each(|rows, block| block.sum(&s[rows.clone()], &y[rows]));
        let mut sums = self.blocks.iter().fold(Sums::default(), |sums, block| sums + block.sums);
        let curves = sums.sy > LEAST_COSINE * (sums.ss * sums.yy).sqrt();
        if !curves {
            return;
        }
        // The first pair says how large D is.
        let first = self.is_empty().then_some((sums.sy / sums.yy).clamp(SMALLEST, LARGEST));
        if let Some(scale) = first {
            (sums.ydy, sums.sds) = (scale * sums.yy, sums.ss / scale);
        }
        let column = if self.order.len() < self.memory { self.order.len() } else { self.order.remove(0) };
        self.order.push(column);
        self.newest = Some(column);
        self.each(|rows, block| {
            if let Some(scale) = first {
                block.diagonal.fill(scale);
            }
            block.learn(column, (&s[rows.clone()], &y[rows]), sums);
        });
    }

    /// Minus the inverse of the Hessian matrix times the gradient, where the entries that are held are left
    /// out of both: they go the way that they are held with.
    pub fn direction(&mut self, gradient: &[f64], held: &[Option<f64>]) -> Vec<f64> {
        let newest = self.newest.take();
        self.each(|rows, block| block.begin(&gradient[rows.clone()], &held[rows], newest));
        let with_steps = self.sum(2, |block| &block.with_steps);
        if let Some(newest) = newest {
            self.products.set_column(newest, &with_steps.column(1));
        }
        // The two loops of Nocedal (1980) need of the vectors only their products.
        let mut a = DMatrix::zeros(self.memory, 1);
        for (place, i) in self.order.iter().enumerate().rev() {
            let newer: f64 = self.order[place + 1..].iter().map(|j| a[*j] * self.products[(*i, *j)]).sum();
            a[*i] = (with_steps[(*i, 0)] - newer) / self.products[(*i, *i)];
        }
        let minus_a = -&a;
        self.each(|_, block| block.scale(&minus_a));
        let with_changes = self.sum(1, |block| &block.with_changes);
        for (place, i) in self.order.iter().enumerate() {
            let older: f64 = self.order[..place].iter().map(|j| a[*j] * self.products[(*j, *i)]).sum();
            a[*i] -= (with_changes[*i] + older) / self.products[(*i, *i)];
        }
        self.each(|rows, block| block.end(&a, &held[rows]));
        let mut direction = Vec::with_capacity(gradient.len());
        self.blocks.iter().for_each(|block| direction.extend_from_slice(block.direction.as_slice()));
        direction
    }

    fn sum(&self, columns: usize, of: impl Fn(&Block) -> &DMatrix<f64>) -> DMatrix<f64> {
        self.blocks.iter().fold(DMatrix::zeros(self.memory, columns), |sum, block| sum + of(block))
    }

    /// Does the work for every block and its rows.
    fn each(&mut self, work: impl Fn(Range<usize>, &mut Block) + Sync) {
        let some = |first: usize, blocks: &mut [Block]| {
            for (k, block) in blocks.iter_mut().enumerate() {
                let begin = (first + k) * ROWS;
                work(begin..begin + block.rows(), block);
            }
        };
        let threads = self.threads.min(self.blocks.len() / FEWEST);
        if cfg!(feature = "threads") && threads > 1 {
            let share = self.blocks.len().div_ceil(threads);
            let mut shares = self.blocks.chunks_mut(share).enumerate();
            let own = shares.next();
            std::thread::scope(|scope| {
                for (k, blocks) in shares {
                    scope.spawn(move || some(k * share, blocks));
                }
                own.into_iter().for_each(|(_, blocks)| some(0, blocks));
            });
        } else {
            some(0, &mut self.blocks);
        }
    }
}

impl Block {
    fn new(rows: usize, memory: usize) -> Self {
        Self {
            steps: DMatrix::zeros(rows, memory),
            changes: DMatrix::zeros(rows, memory),
            diagonal: DMatrix::from_element(rows, 1, 1.0),
            beside: DMatrix::zeros(rows, 2),
            direction: DMatrix::zeros(rows, 1),
            with_steps: DMatrix::zeros(memory, 2),
            with_changes: DMatrix::zeros(memory, 1),
            sums: Sums::default(),
        }
    }

    fn rows(&self) -> usize {
        self.steps.nrows()
    }

    /// The sums over the rows of a pair.
    fn sum(&mut self, s: &[f64], y: &[f64]) {
        let rows = s.iter().zip(y).zip(self.diagonal.as_slice());
        self.sums = rows.fold(Sums::default(), |sums, ((s, y), d)| {
            sums + Sums { sy: s * y, ss: s * s, yy: y * y, ydy: d * y * y, sds: s * s / d }
        });
    }

    /// Keeps a pair; D becomes the diagonal of what the direct BFGS update makes of D^-1, scaled to fit the
    /// pair.
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

    /// The first pass: downhill, and its products with the steps; beside them those of the newest change.
    fn begin(&mut self, gradient: &[f64], held: &[Option<f64>], newest: Option<usize>) {
        for (q, (g, held)) in self.beside.column_mut(0).iter_mut().zip(gradient.iter().zip(held)) {
            *q = if held.is_some() { 0.0 } else { -g };
        }
        if let Some(newest) = newest {
            self.beside.set_column(1, &self.changes.column(newest));
        }
        self.with_steps.fill(0.0);
        add_tr_product(&self.steps, &self.beside, &mut self.with_steps);
    }

    /// The second pass: D (q - Y a), and its products with the changes.
    fn scale(&mut self, minus_a: &DMatrix<f64>) {
        self.direction.copy_from(&self.beside.columns(0, 1));
        add_product(&self.changes, minus_a, &mut self.direction);
        self.direction.component_mul_assign(&self.diagonal);
        self.with_changes.fill(0.0);
        add_tr_product(&self.changes, &self.direction, &mut self.with_changes);
    }

    /// The third pass: plus S c.
    fn end(&mut self, c: &DMatrix<f64>, held: &[Option<f64>]) {
        add_product(&self.steps, c, &mut self.direction);
        for (d, held) in self.direction.iter_mut().zip(held) {
            *d = held.unwrap_or(*d);
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

    fn hessian(n: usize) -> DMatrix<f64> {
        let b = DMatrix::from_fn(n, n, |i, j| ((i * 5 + j * 3) as f64).cos());
        &b * b.transpose() + DMatrix::from_diagonal(&DVector::from_fn(n, |i, _| 1.0 + i as f64))
    }

    /// The BFGS updates written out, from D on (Nocedal and Wright, equation 6.17): with fewer pairs than are
    /// remembered, and with more.
    #[test]
    fn directions_are_those_of_the_updates_written_out() {
        let (n, memory) = (9, 4);
        let a = hessian(n);
        let gradient = DVector::from_fn(n, |i, _| (i as f64 * 0.7).cos());
        let held: Vec<Option<f64>> = (0..n).map(|i| (i == 2 || i == 5).then_some(0.1 * i as f64)).collect();
        let mut curvature = Curvature::new(n, memory);
        let all = pairs(&a, 7);
        for (k, (s, y)) in all.iter().enumerate() {
            curvature.learn(s.as_slice(), y.as_slice());
            let found = curvature.direction(gradient.as_slice(), &held);
            let diagonal = curvature.blocks[0].diagonal.as_slice();
            let mut inverse = DMatrix::from_diagonal(&DVector::from_row_slice(diagonal));
            for (s, y) in &all[(k + 1).saturating_sub(memory)..=k] {
                let rho = 1.0 / s.dot(y);
                let v = DMatrix::identity(n, n) - y * s.transpose() * rho;
                inverse = v.tr_mul(&inverse) * &v + s * s.transpose() * rho;
            }
            let masked = DVector::from_fn(n, |i, _| if held[i].is_some() { 0.0 } else { gradient[i] });
            let expected =
                DVector::from_fn(n, |i, _| held[i].unwrap_or_else(|| -(inverse.row(i) * &masked)[0]));
            assert_relative_eq!(DVector::from_vec(found), expected, max_relative = 1e-9, epsilon = 1e-12);
        }
    }

    /// The diagonal of the direct update, written out: of D^-1 times y^T D y / s^T y.
    #[test]
    fn the_diagonal_learns() {
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
            curvature.direction(s.as_slice(), &[None; 6]);
            let found = DVector::from_row_slice(curvature.blocks[0].diagonal.as_slice());
            assert_relative_eq!(found, diagonal, max_relative = 1e-10);
        }
    }

    #[test]
    fn a_pair_that_curves_downwards_is_left_out() {
        let mut curvature = Curvature::new(2, 3);
        curvature.learn(&[1.0, 0.0], &[-1.0, 0.0]);
        curvature.learn(&[1.0, 0.0], &[f64::NAN, 0.0]);
        assert!(curvature.is_empty());
        assert_eq!(curvature.direction(&[1.0, -2.0], &[None; 2]), vec![-1.0, 2.0]);
    }
}
