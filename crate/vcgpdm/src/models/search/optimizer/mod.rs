//! The quasi-Newton method of limited memory (L-BFGS) inside a box, one iteration at a time.
//!
//! Entries that stand at an end of their box or close to it, and would leave it, are held: they go to that
//! end on their own. The others move together, and stop at the ends that they reach (projection with two
//! metrics: Bertsekas, "Projected Newton methods for optimization problems with simple constraints", 1982).

mod curvature;
mod line_search;

use curvature::Curvature;
use line_search::{Found, line_search};

/// Value and gradient of what is minimised, at a point.
pub type Evaluate = Box<dyn Fn(&[f64]) -> (f64, Vec<f64>) + Send>;

/// Correction pairs that are kept. More save some evaluations, but each costs time in every iteration.
const MEMORY: usize = 20;
/// Below this infinity norm the projected gradient counts as zero.
const GRADIENT_TOLERANCE: f64 = 1e-6;
/// When two iterations in a row gain less, relative to the value, they were the last.
const SMALLEST_GAIN: f64 = 1e-13;
/// Entries are close to an end of their box within this part of its width. Without it one that moves with the
/// others towards an end would have all of them stop there, however short the way (Bertsekas, section 2).
const CLOSE: f64 = 1e-3;

struct Point {
    x: Vec<f64>,
    value: f64,
    gradient: Vec<f64>,
}

/// A minimisation inside a box that can be stopped after any iteration.
pub struct Optimizer {
    evaluate: Evaluate,
    lower: Vec<f64>,
    upper: Vec<f64>,
    start: Option<Vec<f64>>,
    point: Option<Point>,
    curvature: Curvature,
    /// Whether the last iteration gained next to nothing.
    stalled: bool,
}

impl Optimizer {
    /// Starts at `x`; `boxes` holds the lower and upper end of every entry.
    pub fn new(x: Vec<f64>, boxes: impl Iterator<Item = (f64, f64)>, evaluate: Evaluate) -> Self {
        let curvature = Curvature::new(x.len(), MEMORY);
        let (lower, upper) = boxes.unzip();
        Self { evaluate, lower, upper, start: Some(x), point: None, curvature, stalled: false }
    }

    /// Computes directions in so many threads from now on, and to the same bits.
    pub fn use_threads(&mut self, threads: usize) {
        self.curvature.use_threads(threads);
    }

    /// One iteration. False when no further one can improve the point.
    pub fn step(&mut self) -> bool {
        if let Some(x) = self.start.take() {
            let (value, gradient) = (self.evaluate)(&x);
            self.point = Some(Point { x, value, gradient });
        }
        let Some(point) = self.point.take() else { return false };
        let (next, moved) = self.improve(point);
        self.point = Some(next);
        moved
    }

    /// The value at the point reached.
    pub fn value(&self) -> Option<f64> {
        self.point.as_ref().map(|point| point.value)
    }

    /// The next point, and whether it is worth to go on.
    fn improve(&mut self, point: Point) -> (Point, bool) {
        let held = self.held(&point);
        let free = point.gradient.iter().zip(&held).filter(|(_, held)| held.is_none());
        let largest = free.fold(0.0, |largest: f64, (g, _)| largest.max(g.abs()));
        if largest < GRADIENT_TOLERANCE && held.iter().all(|to_end| to_end.is_none_or(|way| way == 0.0)) {
            return (point, false);
        }
        loop {
            let direction = self.curvature.direction(&point.gradient, &held);
            if let Some(next) = self.along(&direction, &point) {
                let s = change(&next.x, &point.x, &held);
                let y = change(&next.gradient, &point.gradient, &held);
                self.curvature.learn(&s, &y);
                let gain = point.value - next.value;
                let stalled = gain <= SMALLEST_GAIN * point.value.abs().max(1.0);
                let goes_on = !(stalled && self.stalled);
                if stalled {
                    self.curvature.forget();
                }
                self.stalled = stalled;
                return (next, goes_on);
            }
            // What is remembered of far away can mislead: once more without it.
            if self.curvature.is_empty() {
                return (point, false);
            }
            self.curvature.forget();
        }
    }

    /// A better point in this direction.
    fn along(&self, direction: &[f64], from: &Point) -> Option<Point> {
        let slope = dot(direction, &from.gradient);
        let downhill = slope < 0.0;
        if !downhill {
            return None;
        }
        // Before anything is known of the curvature, the length of a step is a guess.
        let guess = (1.0 / dot(direction, direction).sqrt()).min(1.0);
        let first = if self.curvature.is_empty() { guess } else { 1.0 };
        let found = line_search((from.value, slope), first, |t| {
            // Entries that have reached the end of their box do not go on.
            let (mut x, mut going) = (from.x.clone(), direction.to_vec());
            let boxes = self.lower.iter().zip(&self.upper);
            for ((x, going), (low, high)) in x.iter_mut().zip(&mut going).zip(boxes) {
                let to = *x + t * *going;
                *going = if to > *low && to < *high { *going } else { 0.0 };
                *x = to.max(*low).min(*high);
            }
            let (value, gradient) = (self.evaluate)(&x);
            Found { value, slope: dot(&going, &gradient), at: (x, gradient) }
        })?;
        let (x, gradient) = found.at;
        Some(Point { x, value: found.value, gradient })
    }

    /// The way to the end of its box for every entry that is close to it and would leave it downhill; `None`
    /// for the others.
    fn held(&self, point: &Point) -> Vec<Option<f64>> {
        let entries = || point.x.iter().zip(&point.gradient).zip(self.lower.iter().zip(&self.upper));
        // Nearer to the minimum less counts as close.
        let ways = entries().map(|((x, g), (low, high))| (x - (x - g).max(*low).min(*high)).abs());
        let longest = ways.fold(0.0, f64::max);
        let held = |((x, g), (low, high)): ((&f64, &f64), (&f64, &f64))| {
            let way = if *g > 0.0 { low - x } else { high - x };
            let close = way.abs() <= longest.min(CLOSE * (high - low));
            (*g != 0.0 && close).then_some(way)
        };
        entries().map(held).collect()
    }
}

/// From `b` to `a`, where nothing is held.
fn change(a: &[f64], b: &[f64], held: &[Option<f64>]) -> Vec<f64> {
    let entries = a.iter().zip(b).zip(held);
    entries.map(|((a, b), held)| if held.is_none() { a - b } else { 0.0 }).collect()
}

/// In several sums: one addition need not wait for the one before.
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
