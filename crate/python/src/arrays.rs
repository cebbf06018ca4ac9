//! Between matrices and numpy arrays, and between values and Python objects.

use crate::refused;
use nalgebra::DMatrix;
use numpy::ndarray::{Array2, Array3};
use numpy::{AllowTypeChange, IntoPyArray, PyArray2, PyArray3, PyArrayLikeDyn, PyUntypedArrayMethods};
use pyo3::Borrowed;
use pyo3::prelude::*;
use serde::Serialize;

/// A matrix as a new array.
pub fn array<'py>(py: Python<'py>, matrix: &DMatrix<f64>) -> Bound<'py, PyArray2<f64>> {
    Array2::from_shape_fn(matrix.shape(), |at| matrix[at]).into_pyarray(py)
}

/// Matrices of one shape, one for each frame, as a new array.
pub fn stacked<'py>(py: Python<'py>, matrices: &[DMatrix<f64>]) -> Bound<'py, PyArray3<f64>> {
    let (rows, columns) = matrices.first().map_or((0, 0), DMatrix::shape);
    Array3::from_shape_fn((matrices.len(), rows, columns), |(t, i, j)| matrices[t][(i, j)]).into_pyarray(py)
}

/// Positions [frames x nodes x 3] as a new array.
pub fn positions(py: Python<'_>, all: Vec<f32>, nodes: usize) -> PyResult<Bound<'_, PyArray3<f32>>> {
    let frames = all.len() / (3 * nodes.max(1));
    Ok(Array3::from_shape_vec((frames, nodes, 3), all).map_err(refused)?.into_pyarray(py))
}

/// The matrix in an array, or in a list of rows. `name` is its name in an error.
pub fn matrix(value: &Bound<'_, PyAny>, name: &str) -> PyResult<DMatrix<f64>> {
    let array: PyArrayLikeDyn<f64, AllowTypeChange> = value.extract()?;
    let &[rows, columns] = array.shape() else {
        let found = array.ndim();
        return Err(refused(format!("{name}: expected an array of two dimensions, found {found}")));
    };
    let view = array.as_array();
    Ok(DMatrix::from_fn(rows, columns, |i, j| view[[i, j]]))
}

/// A whole number of 0 or more.
#[derive(Clone, Copy)]
pub struct Count(pub usize);

impl<'a, 'py> FromPyObject<'a, 'py> for Count {
    type Error = PyErr;

    fn extract(value: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        let number: i64 = value.extract()?;
        let count = usize::try_from(number);
        count.map(Count).map_err(|_| refused(format!("expected a number of 0 or more, found {number}")))
    }
}

impl Count {
    /// The number as a seed.
    pub fn seed(self) -> PyResult<u32> {
        let refusal = || refused(format!("seed: expected a number up to {}, found {}", u32::MAX, self.0));
        u32::try_from(self.0).map_err(|_| refusal())
    }
}

/// A value as the dict that `json.loads` makes of it.
pub fn dict<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let text = serde_json::to_string(value).map_err(refused)?;
    py.import("json")?.call_method1("loads", (text,))
}
