//! The Python package `vcgpdm`: numpy arrays and clips in, models and rollouts out.

mod arrays;
mod clip;
mod data;
mod fit;
mod model;
mod rollout;
mod trained;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::fmt::Display;

/// An error in the words of the library.
fn refused(reason: impl Display) -> PyErr {
    PyValueError::new_err(reason.to_string())
}

/// The classes that `vcgpdm/__init__.py` offers.
#[pymodule]
fn _vcgpdm(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<clip::Clip>()?;
    module.add_class::<fit::Progress>()?;
    module.add_class::<model::Vcgpdm>()?;
    module.add_class::<rollout::Rollout>()
}
