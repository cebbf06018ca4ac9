//! Matrices in JSON: an array of rows, each an array of numbers.

use nalgebra::DMatrix;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

/// The matrix of rows of equal width, or a message that names the wrong row.
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

/// For `#[serde(deserialize_with = "rows::optional_matrices")]`: a list of matrices; both an absent field and
/// `null` become `None`.
pub fn optional_matrices<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Option<Vec<DMatrix<f64>>>, D::Error> {
    let all = Option::<Vec<Vec<Vec<f64>>>>::deserialize(deserializer)?;
    let matrix = |(k, rows): (usize, &Vec<Vec<f64>>)| {
        matrix_from_rows(rows).map_err(|reason| D::Error::custom(format_args!("matrix {k}: {reason}")))
    };
    all.map(|all| all.iter().enumerate().map(matrix).collect()).transpose()
}

/// For `#[serde(deserialize_with = "rows::optional_matrix")]`: both an absent field and `null` become `None`.
pub fn optional_matrix<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<DMatrix<f64>>, D::Error> {
    let rows = Option::<Vec<Vec<f64>>>::deserialize(deserializer)?;
    rows.map(|rows| matrix_from_rows(&rows).map_err(D::Error::custom)).transpose()
}

/// For `#[serde(serialize_with = "rows::serialize")]`.
pub fn serialize<S: Serializer>(matrix: &DMatrix<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(matrix.row_iter().map(|row| row.iter().copied().collect::<Vec<f64>>()))
}
