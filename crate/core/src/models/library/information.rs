//! Information matrix of the experts about one part, and its marginal over a subset of them.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use crate::models::rollout::couplings::coupling_weights;
use crate::models::variational::{DynamicsSums, ExternalEvidence, stack_offsets};
use nalgebra::DMatrix;
use std::ops::Range;

/// What rows say about the inducing outputs of a stack of experts of height H, in all.
pub(super) struct Information {
    /// A - K [H x H].
    pub precision: DMatrix<f64>,
    /// b / alpha^i [H x Q_i].
    pub b: DMatrix<f64>,
}

impl Information {
    /// No information: a stack of this `height` H about a part of `latent` dimensions Q_i.
    pub fn zeros(height: usize, latent: usize) -> Self {
        Self { precision: DMatrix::zeros(height, height), b: DMatrix::zeros(height, latent) }
    }

    /// Adds the information in the rows of a movement. `ranges[source]` are the rows of the stack that belong
    /// to the expert of each source part; `alpha` are the couplings into the part `[M]`.
    pub fn add(&mut self, sums: &DynamicsSums, alpha: &[f64], ranges: &[Range<usize>]) {
        let (noise, weights) = coupling_weights(alpha);
        let own = stack_offsets(ranges.iter().map(Range::len));
        let (psi2, b) = sums.weighted(&weights, &own);
        for (j, to) in ranges.iter().enumerate() {
            for (k, other) in ranges.iter().enumerate() {
                let shape = (to.len(), other.len());
                let mut block = self.precision.view_mut((to.start, other.start), shape);
                block += psi2.view((own[j], own[k]), shape) / noise;
            }
            let mut rows = self.b.rows_mut(to.start, to.len());
            rows += b.rows(own[j], to.len()) / noise;
        }
    }

    /// The information about the rows `chosen` of the stack when the rows `others` are integrated out. `k`
    /// gives the prior covariance of the whole stack [H x H].
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn marginal(
        &self,
        chosen: &[usize],
        others: &[usize],
        k: impl FnOnce() -> DMatrix<f64>,
    ) -> Result<Information, NumericsError> {
        let precision = submatrix(&self.precision, chosen, chosen);
        let b = self.b.select_rows(chosen);
        let between = submatrix(&self.precision, chosen, others);
        if between.iter().all(|v| *v == 0.0) {
            return Ok(Information { precision, b });
        }
        let inner = submatrix(&(k() + &self.precision), others, others);
        let factor = Factor::new(&inner, "covariance of the data at the dynamics inducing points")?;
        let b_of_others = self.b.select_rows(others);
        Ok(Information {
            precision: symmetric(precision - &between * factor.solve(&between.transpose())),
            b: b - between * factor.solve(&b_of_others),
        })
    }

    /// As an expert stores it; `None` where all entries are 0.
    pub fn nonzero(self) -> Option<ExternalEvidence> {
        let Self { precision, b } = self;
        let is_zero = precision.iter().chain(&b).all(|v| *v == 0.0);
        (!is_zero).then_some(ExternalEvidence { precision, b })
    }
}

fn submatrix(m: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
    m.select_rows(rows).select_columns(columns)
}
