//! What is known about experts from rows, and what is left of it when some of the experts are not there.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use crate::models::rollout::couplings::coupling_weights;
use crate::models::variational::{DynamicsSums, Elsewhere, stack_offsets};
use nalgebra::DMatrix;
use std::ops::Range;

/// What is known about a stack of experts from rows: A - K and b / n.
pub(super) struct Known {
    pub precision: DMatrix<f64>,
    pub b: DMatrix<f64>,
}

impl Known {
    /// Of a stack of this height about `latent` dimensions: nothing.
    pub fn nothing(height: usize, latent: usize) -> Self {
        Self { precision: DMatrix::zeros(height, height), b: DMatrix::zeros(height, latent) }
    }

    /// Adds what the rows of a movement say, whose own sources start at `places` in the stack.
    pub fn add(&mut self, sums: &DynamicsSums, alpha: &[f64], places: &[Range<usize>]) {
        let (noise, weights) = coupling_weights(alpha);
        let own = stack_offsets(places.iter().map(Range::len));
        let (psi2, b) = sums.weighted(&weights, &own);
        for (j, to) in places.iter().enumerate() {
            for (k, other) in places.iter().enumerate() {
                let shape = (to.len(), other.len());
                let mut block = self.precision.view_mut((to.start, other.start), shape);
                block += psi2.view((own[j], own[k]), shape) / noise;
            }
            let mut rows = self.b.rows_mut(to.start, to.len());
            rows += b.rows(own[j], to.len()) / noise;
        }
    }

    /// What is known about the rows `used` of the stack when the rows `rest` are integrated out, which have
    /// the covariance `k` with the others of the stack.
    pub fn about(
        &self,
        used: &[usize],
        rest: &[usize],
        k: impl FnOnce() -> DMatrix<f64>,
    ) -> Result<Known, NumericsError> {
        let precision = pick(&self.precision, used, used);
        let b = self.b.select_rows(used);
        let between = pick(&self.precision, used, rest);
        if between.iter().all(|v| *v == 0.0) {
            return Ok(Known { precision, b });
        }
        let inner = pick(&(k() + &self.precision), rest, rest);
        let factor = Factor::new(&inner, "covariance of the data at the dynamics inducing points")?;
        let of_rest = self.b.select_rows(rest);
        Ok(Known {
            precision: symmetric(precision - &between * factor.solve(&between.transpose())),
            b: b - between * factor.solve(&of_rest),
        })
    }

    /// What the rest of the stack learns from the rows when the outputs of its first experts stay as they
    /// are, with the `coefficients` K^-1 m [H x Q_i]: what these leave over.
    pub fn beside(&self, coefficients: &DMatrix<f64>) -> Known {
        let (first, height) = (coefficients.nrows(), self.b.nrows());
        let others = height - first;
        let cross = self.precision.view((first, 0), (others, first));
        Known {
            precision: self.precision.view((first, first), (others, others)).into_owned(),
            b: self.b.rows(first, others) - cross * coefficients,
        }
    }

    /// As an expert keeps it; `None` where it is nothing.
    pub fn kept(self) -> Option<Elsewhere> {
        let Self { precision, b } = self;
        let nothing = precision.iter().chain(&b).all(|v| *v == 0.0);
        (!nothing).then_some(Elsewhere { precision, b })
    }
}

fn pick(m: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
    m.select_rows(rows).select_columns(columns)
}
