//! Recorded motions.

use crate::arrays::{Count, array, positions};
use crate::refused;
use numpy::{PyArray2, PyArray3};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::fs;
use std::path::PathBuf;
use vcgpdm_core::motion::Clip as Motion;
use vcgpdm_core::motion::bvh::read_at;
use vcgpdm_core::motion::bvh::write as write_bvh;
use vcgpdm_core::motion::parts::presets;
use vcgpdm_core::motion::samples::{clip as sample_clip, list as sample_clips};
use vcgpdm_core::motion::stage::UpAxis;

/// A recorded motion of a body. A clip never changes: `cut`, `resample` and the others return new clips.
#[pyclass(module = "vcgpdm", frozen)]
pub struct Clip {
    pub clip: Motion,
}

#[pymethods]
impl Clip {
    /// Reads a BVH file. A leading T-pose is left out; `warnings` says so. `root` names the joint that becomes
    /// the root: of several bodies in one file, the one to read. `fps` replaces the frame time of the file where
    /// it is wrong.
    #[staticmethod]
    #[pyo3(signature = (path, root=None, fps=None))]
    fn read(path: PathBuf, root: Option<&str>, fps: Option<f64>) -> PyResult<Self> {
        let bytes = fs::read(&path)?;
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let recording = read_at(&name, &bytes, fps).map_err(refused)?;
        Ok(Self { clip: recording.of_root(root).map_err(refused)?.into_clip() })
    }

    /// One of the clips that the project makes itself; `samples()` lists their names.
    #[staticmethod]
    fn sample(name: &str) -> PyResult<Self> {
        let clip = sample_clip(name).ok_or_else(|| {
            let names: Vec<&str> = sample_clips().iter().map(|sample| sample.id).collect();
            refused(format!("expected one of the samples {}, found {name:?}", names.join(", ")))
        })?;
        Ok(Self { clip })
    }

    /// The names of the sample clips.
    #[staticmethod]
    fn samples() -> Vec<String> {
        sample_clips().iter().map(|sample| sample.id.to_owned()).collect()
    }

    /// The name of its file.
    #[getter]
    fn name(&self) -> &str {
        &self.clip.name
    }

    /// The number of frames T.
    #[getter]
    fn frames(&self) -> usize {
        self.clip.frames()
    }

    /// Seconds from one frame to the next.
    #[getter]
    fn frame_time(&self) -> f64 {
        self.clip.frame_time
    }

    /// The names of the joints, the root first.
    #[getter]
    fn joints(&self) -> Vec<String> {
        self.clip.skeleton.joints.iter().map(|joint| joint.name.clone()).collect()
    }

    /// The usual splits of this body: for each, the names of its parts with the names of their joints.
    #[getter]
    fn presets<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let splits = PyDict::new(py);
        for preset in presets(&self.clip.skeleton) {
            let parts = PyDict::new(py);
            for part in preset.parts {
                let joint = |&joint: &usize| self.clip.skeleton.joints[joint].name.as_str();
                parts.set_item(part.name, part.joints.iter().map(joint).collect::<Vec<_>>())?;
            }
            splits.set_item(preset.id, parts)?;
        }
        Ok(splits)
    }

    /// For each node of `positions()`, the node where its bone begins; -1 for the root.
    #[getter]
    fn parents(&self) -> Vec<i64> {
        let place = |parent: Option<usize>| parent.map_or(-1, |node| node as i64);
        self.clip.skeleton.figure().iter().map(|node| place(node.parent)).collect()
    }

    /// What was unusual about the file, as sentences.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.clip.warnings.clone()
    }

    /// The channel values of the file [frames x channels], in degrees and in the units of the file.
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        array(py, &self.clip.values)
    }

    /// Positions of the joints and of the ends of the limbs [frames x nodes x 3], in metres for a body 1.7 m
    /// tall, y up, the lowest point of the clip at 0.
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        positions(py, self.clip.stage_positions(), self.clip.skeleton.node_count())
    }

    /// The frames from `first` up to but not including `end`.
    fn cut(&self, first: Count, end: Count) -> PyResult<Self> {
        Ok(Self { clip: self.clip.cut(first.0, end.0).map_err(refused)? })
    }

    /// The same motion at about `fps` frames a second.
    fn resample(&self, fps: f64) -> PyResult<Self> {
        Ok(Self { clip: self.clip.resample(fps).map_err(refused)? })
    }

    /// The same motion with the bones of `other`, whose joints must be the same.
    fn with_bones_of(&self, other: &Self) -> PyResult<Self> {
        let clip = vcgpdm_core::models::with_bones_of(&self.clip, &other.clip).map_err(refused)?;
        Ok(Self { clip })
    }

    /// The clip in which `axis` points up ("x", "y", "z", "-x", "-y" or "-z"), where another was found.
    fn with_up(&self, axis: &str) -> PyResult<Self> {
        let up = UpAxis::from_name(axis)
            .ok_or_else(|| refused(format!("axis: expected x, y, z, -x, -y or -z, found {axis:?}")))?;
        Ok(Self { clip: self.clip.with_up(up) })
    }

    /// The text of a BVH file.
    fn to_bvh(&self) -> String {
        write_bvh(&self.clip)
    }

    /// Writes a BVH file.
    fn write(&self, path: PathBuf) -> PyResult<()> {
        Ok(fs::write(path, self.to_bvh())?)
    }

    fn __repr__(&self) -> String {
        let (name, frames, fps) = (&self.clip.name, self.clip.frames(), 1.0 / self.clip.frame_time);
        format!("Clip({name:?}, {frames} frames, {fps:.1} frames a second)")
    }

    fn __len__(&self) -> usize {
        self.clip.frames()
    }
}
