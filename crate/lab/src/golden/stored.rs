//! Stored inducing outputs in golden cases.

use crate::golden::error::CaseError;
use crate::golden::rows;
use crate::golden::shapes::shape;
use nalgebra::DMatrix;
use serde::Deserialize;
use vcgpdm_core::gp::linalg::{Factor, block_diagonal};
use vcgpdm_core::gp::stored_outputs::StoredOutputs;
use vcgpdm_core::models::variational::{Params, StoredMaps};

/// Inducing outputs of the pose maps and of the first primitives; later primitives are new.
#[derive(Deserialize)]
pub(super) struct StoredJson {
    primitives: usize,
    kin: Vec<OutputsJson>,
    #[serde(rename = "dyn")]
    dynamics: Vec<OutputsJson>,
}

/// N(mean, cov), mean [K x C].
#[derive(Deserialize)]
struct OutputsJson {
    #[serde(with = "rows::matrix")]
    mean: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    cov: DMatrix<f64>,
}

impl OutputsJson {
    /// The outputs with the prior covariance `k`.
    fn outputs(&self, k: &DMatrix<f64>, columns: usize, path: &str) -> Result<StoredOutputs, CaseError> {
        let points = k.nrows();
        shape(format!("{path}.mean"), (points, columns), self.mean.shape())?;
        shape(format!("{path}.cov"), (points, points), self.cov.shape())?;
        let coefficients = Factor::new(k, "covariance of the inducing points")?.solve(&self.mean);
        // S = K A^-1 K.
        let a = k * Factor::new(&self.cov, "covariance of the stored outputs")?.solve(k);
        Ok(StoredOutputs::new(k, &a, coefficients)?)
    }
}

impl StoredJson {
    /// Number of stored primitives.
    pub(super) fn primitives(&self) -> usize {
        self.primitives
    }

    /// The outputs of the maps with these parameters.
    pub(super) fn maps(
        &self,
        params: &Params,
        y: &[DMatrix<f64>],
        jitter: f64,
    ) -> Result<StoredMaps, CaseError> {
        let m = params.part_count();
        let wrong = |name: &str, expected: String, found: usize| {
            let path = format!("input.stored.{name}");
            Err(CaseError::Shape { path, expected, found: found.to_string() })
        };
        if self.primitives > params.experts.len() {
            return wrong("primitives", format!("at most {}", params.experts.len()), self.primitives);
        }
        for (name, found) in [("kin", self.kin.len()), ("dyn", self.dynamics.len())] {
            if found != m {
                return wrong(name, format!("{m} (one for each part)"), found);
            }
        }
        let kinematics = self.kin.iter().zip(&params.parts).zip(y).enumerate().map(|(i, ((q, part), y))| {
            let k = part.kernel.inducing_covariance(&part.r, jitter);
            q.outputs(&k, y.ncols(), &format!("input.stored.kin[{i}]"))
        });
        let dynamics = self.dynamics.iter().zip(&params.parts).enumerate().map(|(i, (q, part))| {
            let experts = params.experts[..self.primitives].iter().map(|row| &row[i]);
            let blocks: Vec<_> = experts.map(|e| e.kernel.inducing_covariance(&e.z, jitter)).collect();
            let columns = part.latents.mean.ncols();
            q.outputs(&block_diagonal(&blocks), columns, &format!("input.stored.dyn[{i}]"))
        });
        Ok(StoredMaps {
            kinematics: kinematics.collect::<Result<_, _>>()?,
            dynamics: dynamics.collect::<Result<_, _>>()?,
        })
    }
}
