//! Matrices and vectors in a golden file: an array of rows, each an array of numbers.

use nalgebra::{DMatrix, DVector};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use vcgpdm_core::json::rows::matrix_from_rows;

/// The rows of a matrix.
pub fn rows_of(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// For `#[serde(with = "rows::matrix")]`.
pub mod matrix {
    use super::*;

    pub fn serialize<S: Serializer>(matrix: &DMatrix<f64>, serializer: S) -> Result<S::Ok, S::Error> {
        rows_of(matrix).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<DMatrix<f64>, D::Error> {
        matrix_from_rows(&Vec::<Vec<f64>>::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

/// For `#[serde(with = "rows::vector")]`.
pub mod vector {
    use super::*;

    pub fn serialize<S: Serializer>(vector: &DVector<f64>, serializer: S) -> Result<S::Ok, S::Error> {
        vector.as_slice().serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<DVector<f64>, D::Error> {
        let values = Vec::<f64>::deserialize(deserializer)?;
        match values.iter().position(|v| !v.is_finite()) {
            Some(k) => {
                Err(D::Error::custom(format!("expected a finite number at place {k}, found {}", values[k])))
            }
            None => Ok(DVector::from_vec(values)),
        }
    }
}
