//! Matrices in JSON: an array of rows, each an array of numbers.

use nalgebra::{DMatrix, DVector};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A matrix with `rows` rows of equal width, or a sentence that says which row is odd.
pub fn matrix_from_rows(rows: &[Vec<f64>]) -> Result<DMatrix<f64>, String> {
    let width = rows.first().map_or(0, Vec::len);
    for (k, row) in rows.iter().enumerate() {
        if row.len() != width {
            return Err(format!("expected rows of {width} numbers, found {} in row {k}", row.len()));
        }
        if let Some(c) = row.iter().position(|v| !v.is_finite()) {
            return Err(format!("expected a finite number in row {k}, column {c}, found {}", row[c]));
        }
    }
    Ok(DMatrix::from_fn(rows.len(), width, |i, j| rows[i][j]))
}

/// The rows of a matrix.
pub fn rows_of(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// For `#[serde(deserialize_with = "rows::optional_matrix")]`: both an absent field and `null` become `None`.
pub fn optional_matrix<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<DMatrix<f64>>, D::Error> {
    let rows = Option::<Vec<Vec<f64>>>::deserialize(deserializer)?;
    rows.map(|rows| matrix_from_rows(&rows).map_err(D::Error::custom)).transpose()
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
