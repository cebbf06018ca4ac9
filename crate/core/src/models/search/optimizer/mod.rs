//! The quasi-Newton method of limited memory (L-BFGS) inside a box, one iteration at a time.
//!
//! A parameter at a bound, or very near to it, whose step would cross the bound is fixed and moved to the
//! bound. The others move together, and each stops at the bound that it reaches (projection with two metrics:
//! Bertsekas, "Projected Newton methods for optimization problems with simple constraints", 1982).

mod curvature;
mod line_search;

use curvature::Curvature;
use line_search::{Line, Probe, line_search};
use std::mem::swap;

/// Correction pairs that are stored. More save some evaluations, but each costs time in every iteration.
const MEMORY: usize = 20;
/// Below this infinity norm the projected gradient counts as zero.
const GRADIENT_TOLERANCE: f64 = 1e-6;
/// The search ends after two successive iterations that each gain less than this, relative to the value.
const SMALLEST_GAIN: f64 = 1e-13;
/// A parameter is near to a bound within this part of the width of its box. Otherwise a parameter that moves
/// with the others towards its bound would stop them all there (Bertsekas, section 2).
const NEAR: f64 = 1e-3;

#[derive(Clone)]
struct Point {
    x: Vec<f64>,
    value: f64,
    gradient: Vec<f64>,
}

/// A minimisation inside a box that can be stopped after any iteration. An iteration allocates no memory.
pub struct Optimizer {
    lower: Vec<f64>,
    upper: Vec<f64>,
    /// The point reached.
    point: Point,
    /// Whether the function was computed at `point`.
    computed: bool,
    /// The point that the line search computed last, and its best one.
    trial: Point,
    better: Point,
    /// For a fixed parameter the step to its bound.
    fixed: Vec<Option<f64>>,
    direction: Vec<f64>,
    /// The direction without the parameters that have reached a bound.
    projected: Vec<f64>,
    /// Change of the parameters, and of the gradient, in an iteration.
    step: Vec<f64>,
    change: Vec<f64>,
    curvature: Curvature,
    /// Whether the last iteration gained next to nothing.
    stalled: bool,
}

impl Optimizer {
    /// Starts at `x`; `boxes` holds the lower and upper bound of every parameter.
    pub fn new(x: Vec<f64>, boxes: impl Iterator<Item = (f64, f64)>) -> Self {
        let count = x.len();
        let (lower, upper) = boxes.unzip();
        let point = Point { x, value: f64::NAN, gradient: vec![0.0; count] };
        let zeros = || vec![0.0; count];
        Self {
            lower,
            upper,
            trial: point.clone(),
            better: point.clone(),
            point,
            computed: false,
            fixed: vec![None; count],
            direction: zeros(),
            projected: zeros(),
            step: zeros(),
            change: zeros(),
            curvature: Curvature::new(count, MEMORY),
            stalled: false,
        }
    }

    /// Computes directions in `threads` threads from now on. The result is the same to the last bit.
    pub fn use_threads(&mut self, threads: usize) {
        self.curvature.use_threads(threads);
    }

    /// One iteration on `f`, which writes its gradient at a point and returns its value. False when no
    /// further iteration can improve the point.
    pub fn step(&mut self, f: &mut impl FnMut(&[f64], &mut [f64]) -> f64) -> bool {
        if !self.computed {
            self.point.value = f(&self.point.x, &mut self.point.gradient);
            self.computed = true;
        }
        self.fix_parameters();
        if self.at_minimum() {
            return false;
        }
        loop {
            self.curvature.direction_into(&self.point.gradient, &self.fixed, &mut self.direction);
            if self.search_along_direction(f) {
                return self.accept();
            }
            // Old pairs can mislead: the search tries once more without them.
            if self.curvature.is_empty() {
                return false;
            }
            self.curvature.forget();
        }
    }

    /// The value at the point reached; `None` before the first iteration.
    pub fn value(&self) -> Option<f64> {
        self.computed.then_some(self.point.value)
    }

    /// Whether the free parameters have no gradient and the fixed ones are at their bounds.
    fn at_minimum(&self) -> bool {
        let free = self.point.gradient.iter().zip(&self.fixed).filter(|(_, fixed)| fixed.is_none());
        let largest = free.fold(0.0, |largest: f64, (g, _)| largest.max(g.abs()));
        largest < GRADIENT_TOLERANCE
            && self.fixed.iter().all(|to_bound| to_bound.is_none_or(|way| way == 0.0))
    }

    /// Goes to the better point. False when it is the second in succession that gains next to nothing.
    fn accept(&mut self) -> bool {
        change_into(&mut self.step, &self.better.x, &self.point.x, &self.fixed);
        change_into(&mut self.change, &self.better.gradient, &self.point.gradient, &self.fixed);
        self.curvature.learn(&self.step, &self.change);
        let gain = self.point.value - self.better.value;
        let stalled = gain <= SMALLEST_GAIN * self.point.value.abs().max(1.0);
        let goes_on = !(stalled && self.stalled);
        if stalled {
            self.curvature.forget();
        }
        self.stalled = stalled;
        swap(&mut self.point, &mut self.better);
        goes_on
    }

    /// Whether there is a better point in the direction; it is then in `better`.
    fn search_along_direction(&mut self, f: &mut impl FnMut(&[f64], &mut [f64]) -> f64) -> bool {
        let slope = dot(&self.direction, &self.point.gradient);
        let downhill = slope < 0.0;
        if !downhill {
            return false;
        }
        // Without a pair the curvature is unknown, and the length of a step is a guess.
        let guess = (1.0 / dot(&self.direction, &self.direction).sqrt()).min(1.0);
        let first = if self.curvature.is_empty() { guess } else { 1.0 };
        let start = Probe { value: self.point.value, slope };
        line_search(start, first, &mut ProjectedLine { optimizer: self, f })
    }

    /// Fixes every parameter that is near to a bound and that a step downhill would move across it.
    fn fix_parameters(&mut self) {
        let Point { x, gradient, .. } = &self.point;
        let parameters = || x.iter().zip(gradient).zip(self.lower.iter().zip(&self.upper));
        // Close to the minimum the limit is smaller.
        let steps = parameters().map(|((x, g), (low, high))| (x - (x - g).max(*low).min(*high)).abs());
        let longest = steps.fold(0.0, f64::max);
        for (fixed, ((x, g), (low, high))) in self.fixed.iter_mut().zip(parameters()) {
            let to_bound = if *g > 0.0 { low - x } else { high - x };
            let near = to_bound.abs() <= longest.min(NEAR * (high - low));
            *fixed = (*g != 0.0 && near).then_some(to_bound);
        }
    }
}

/// The function along the direction of the optimiser, projected onto the box.
struct ProjectedLine<'a, F> {
    optimizer: &'a mut Optimizer,
    f: &'a mut F,
}

impl<F: FnMut(&[f64], &mut [f64]) -> f64> Line for ProjectedLine<'_, F> {
    fn probe(&mut self, t: f64) -> Probe {
        let Optimizer { lower, upper, point, trial, direction, projected, .. } = &mut *self.optimizer;
        let parameters = trial.x.iter_mut().zip(&point.x).zip(projected.iter_mut().zip(&*direction));
        for (((to, from), (projected, direction)), (low, high)) in
            parameters.zip(lower.iter().zip(upper.iter()))
        {
            let unbounded = from + t * direction;
            *projected = if unbounded > *low && unbounded < *high { *direction } else { 0.0 };
            *to = unbounded.max(*low).min(*high);
        }
        trial.value = (self.f)(&trial.x, &mut trial.gradient);
        Probe { value: trial.value, slope: dot(projected, &trial.gradient) }
    }

    fn store(&mut self) {
        swap(&mut self.optimizer.trial, &mut self.optimizer.better);
    }
}

/// a - b of the free parameters, 0 for the fixed ones.
fn change_into(out: &mut [f64], a: &[f64], b: &[f64], fixed: &[Option<f64>]) {
    for ((out, (a, b)), fixed) in out.iter_mut().zip(a.iter().zip(b)).zip(fixed) {
        *out = if fixed.is_none() { a - b } else { 0.0 };
    }
}

/// a^T b, in several sums: an addition then need not wait for the previous one.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_end), (b, b_end)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (a, b) in a.iter().zip(b) {
        for k in 0..8 {
            sums[k] += a[k] * b[k];
        }
    }
    let end = a_end.iter().zip(b_end).map(|(a, b)| a * b);
    sums.into_iter().chain(end).sum()
}

#[cfg(test)]
mod tests;
