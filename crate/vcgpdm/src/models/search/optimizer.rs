//! L-BFGS-B, one iteration at a time. The only file that names the optimiser crate.

use basin::{
    BoxBounds, ConstraintDescription, ConstraintSet, Constraints, CostFunction, Executor, FirstOrderState,
    Gradient, Lbfgsb, State, StepOutcome, Stepper,
};
use std::convert::Infallible;

/// Value and gradient of what is minimised, at a point.
pub type Evaluate = Box<dyn Fn(&[f64]) -> (f64, Vec<f64>) + Send>;

/// Correction pairs that L-BFGS-B keeps. More save some evaluations, but each costs time in every iteration.
const MEMORY: usize = 20;
/// Below this infinity norm the projected gradient counts as zero.
const GRADIENT_TOLERANCE: f64 = 1e-6;

struct Problem {
    evaluate: Evaluate,
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl Constraints for Problem {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;
    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.lower), Some(&self.upper)))
    }
}

impl CostFunction for Problem {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;
    fn cost(&self, x: &Vec<f64>) -> Result<f64, Infallible> {
        Ok((self.evaluate)(x).0)
    }
}

impl Gradient for Problem {
    type Gradient = Vec<f64>;
    fn gradient(&self, x: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        Ok((self.evaluate)(x).1)
    }
    fn cost_and_gradient(&self, x: &Vec<f64>) -> Result<(f64, Vec<f64>), Infallible> {
        Ok((self.evaluate)(x))
    }
}

type Search = Stepper<Problem, FirstOrderState<Vec<f64>>, Lbfgsb<Vec<f64>>>;

/// A minimisation inside a box that can be stopped after any iteration.
pub struct Optimizer {
    stepper: Option<Search>,
}

impl Optimizer {
    /// Starts at `x`; `boxes` holds the lower and upper end of every entry.
    pub fn new(x: Vec<f64>, boxes: impl Iterator<Item = (f64, f64)>, evaluate: Evaluate) -> Self {
        let (lower, upper) = boxes.unzip();
        let solver = Lbfgsb::new()
            .with_m_capacity(MEMORY)
            .with_absolute_projected_gradient_tolerance(GRADIENT_TOLERANCE)
            .with_relative_cost_reduction_tolerance(1e-13);
        let problem = Problem { evaluate, lower, upper };
        // It can fail only for boxes that do not fit the point; then there is nothing to optimise.
        // The executor's own limit of iterations is lifted: the trainer counts.
        let executor = Executor::new(problem, solver, FirstOrderState::new(x)).max_iter(u64::MAX);
        Self { stepper: executor.into_stepper().ok() }
    }

    /// One iteration. False when no further one can improve the point.
    pub fn step(&mut self) -> bool {
        match self.stepper.as_mut().map(Stepper::step) {
            Some(Ok(StepOutcome::Continue)) => true,
            Some(Ok(StepOutcome::Stopped(_))) | None => false,
            Some(Err(_)) => {
                self.stepper = None;
                false
            }
        }
    }

    /// The value at the point reached.
    pub fn value(&self) -> Option<f64> {
        self.stepper.as_ref().map(|s| s.state().cost())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::{Arc, Mutex};

    #[test]
    fn chained_rosenbrock_in_a_box() {
        let best = Arc::new(Mutex::new(vec![0.0; 6]));
        let seen = Arc::clone(&best);
        let mut optimizer = Optimizer::new(
            vec![-1.2; 6],
            std::iter::repeat_n((-2.0, 0.9), 6),
            Box::new(move |x| {
                let mut f = 0.0;
                let mut g = vec![0.0; x.len()];
                for k in 0..x.len() - 1 {
                    let (a, b) = (1.0 - x[k], x[k + 1] - x[k] * x[k]);
                    f += a * a + 100.0 * b * b;
                    g[k] += -2.0 * a - 400.0 * x[k] * b;
                    g[k + 1] += 200.0 * b;
                }
                *seen.lock().unwrap() = x.to_vec();
                (f, g)
            }),
        );
        let mut iterations = 0;
        while optimizer.step() && iterations < 500 {
            iterations += 1;
        }
        // The free minimum is at 1 in every coordinate; the box ends at 0.9 for the first, and the others follow its square.
        let x = best.lock().unwrap().clone();
        assert!(x.iter().all(|v| (-2.0..=0.9).contains(v)), "{x:?}");
        assert!(optimizer.value().unwrap() < 1.0 && iterations < 200, "{iterations} {:?}", optimizer.value());
    }
}
