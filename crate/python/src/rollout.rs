//! New movements of a model.

use crate::arrays::{array, dict, positions};
use crate::clip::Clip;
use crate::coupled;
use crate::refused;
use crate::trained::{Trained, by_part, without_couplings};
use numpy::{PyArray2, PyArray3};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use vcgpdm_core::models::Coupled;
use vcgpdm_core::models::RolloutRequest;

/// A new movement: columns, latents and weights; of a body also positions and a clip.
#[pyclass(module = "vcgpdm", frozen)]
pub struct Rollout {
    trained: Arc<Trained>,
    request: RolloutRequest,
    rollout: vcgpdm_core::models::Rollout,
}

impl Rollout {
    pub fn new(
        trained: Arc<Trained>,
        request: RolloutRequest,
        rollout: vcgpdm_core::models::Rollout,
    ) -> Self {
        Self { trained, request, rollout }
    }

    fn body(&self) -> PyResult<Coupled<'_>> {
        let Trained::Body(model) = &*self.trained else {
            return Err(refused("expected a model of a body, found one of arrays, which has no positions"));
        };
        model.coupled().ok_or_else(|| without_couplings(model.kind().id()))
    }
}

#[pymethods]
impl Rollout {
    /// All columns [frames x D]: of arrays, their units; of a body, the rates of the root in leg lengths and
    /// radians a frame, and the rotation vectors of the joints in radians.
    #[getter]
    fn y<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        array(py, &self.rollout.y)
    }

    /// The latents of each part: a dict of the parts with arrays [frames x Q].
    #[getter]
    fn latents<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        by_part(py, &self.trained, self.rollout.latents.iter().map(|part| array(py, part)))
    }

    /// The weights of the experts [M x M], source by target; those into each part sum to 1.
    #[getter]
    fn weights<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        array(py, &self.rollout.weights)
    }

    /// Seconds from one frame to the next.
    #[getter]
    fn frame_time(&self) -> PyResult<f64> {
        coupled!(&self.trained, model => Ok(model.body.frame_time))
    }

    /// Positions of the joints and of the ends of the limbs [frames x nodes x 3], in metres for a body 1.7 m
    /// tall, y up.
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let model = self.body()?;
        let all = model.positions(&self.rollout).map_err(refused)?;
        positions(py, all, model.body.mapping.skeleton().node_count())
    }

    /// The movement as a clip, which `write` makes a BVH file of.
    #[pyo3(signature = (name="rollout.bvh"))]
    fn clip(&self, name: &str) -> PyResult<Clip> {
        Ok(Clip { clip: self.body()?.clip(&self.rollout, name).map_err(refused)? })
    }

    /// How the movement of a body ends: a dict with the `state` ("moves-on", "stands-still", ...), since
    /// when in seconds (`from`), its speed beside that of its clips and the share of steps that turn back (`pace`),
    /// and for each part this and the share of the poses of its clips that it visits (`parts`).
    fn health<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let model = self.body()?;
        let positions = model.positions(&self.rollout).map_err(refused)?;
        dict(py, &model.health(&self.rollout, &self.request, &positions).map_err(refused)?)
    }

    fn __len__(&self) -> usize {
        self.rollout.y.nrows()
    }

    fn __repr__(&self) -> String {
        let (frames, columns) = self.rollout.y.shape();
        format!("Rollout({frames} frames, {columns} columns)")
    }
}
