//! The quasi-Newton method of limited memory (L-BFGS) inside a box, one iteration at a time.
//!
//! Entries that stand at an end of their box, and would leave it, are held; the others move together, and stop at the ends that they
//! reach (projection with two metrics: Bertsekas, "Projected Newton methods for optimization problems with simple constraints", 1982).

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
/// An iteration that gains less, relative to the value, is the last.
const SMALLEST_GAIN: f64 = 1e-13;

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
}

impl Optimizer {
    /// Starts at `x`; `boxes` holds the lower and upper end of every entry.
    pub fn new(x: Vec<f64>, boxes: impl Iterator<Item = (f64, f64)>, evaluate: Evaluate) -> Self {
        let curvature = Curvature::new(x.len(), MEMORY);
        let (lower, upper) = boxes.unzip();
        Self { evaluate, lower, upper, start: Some(x), point: None, curvature }
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
        let free = point.gradient.iter().zip(&held).filter(|(_, held)| !**held);
        if free.fold(0.0, |largest: f64, (g, _)| largest.max(g.abs())) < GRADIENT_TOLERANCE {
            return (point, false);
        }
        loop {
            let direction = self.curvature.direction(&point.gradient, &held);
            if let Some(next) = self.along(&direction, &point) {
                self.curvature.learn(&minus(&next.x, &point.x), &minus(&next.gradient, &point.gradient));
                let gain = point.value - next.value;
                let goes_on = gain > SMALLEST_GAIN * point.value.abs().max(1.0);
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

    /// Whether each entry stands at an end of its box, and would leave it downhill.
    fn held(&self, point: &Point) -> Vec<bool> {
        let boxes = self.lower.iter().zip(&self.upper);
        let entries = point.x.iter().zip(&point.gradient).zip(boxes);
        entries.map(|((x, g), (low, high))| (x <= low && *g > 0.0) || (x >= high && *g < 0.0)).collect()
    }
}

fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
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
