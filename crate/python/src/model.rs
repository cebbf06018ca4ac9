//! Trained models.

use crate::arrays::{Count, array, dict, matrix, stacked};
use crate::coupled;
use crate::data::{Data, data};
use crate::fit::{Run, train};
use crate::refused;
use crate::rollout::Rollout;
use crate::trained::{Trained, after_observed, by_part, part_names};
use nalgebra::DMatrix;
use numpy::PyArray2;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;
use vcgpdm_core::document::Document;
use vcgpdm_core::models::{
    BALANCED, ColumnMapping, Coupled, MOST_SAMPLES, PoseWeight, Reading, RolloutRequest, Settings,
    VariationalSettings, check_couplings, coupling_weight_matrix,
};
use vcgpdm_lab::evaluation::dtw_mse;

/// A coupled Gaussian process dynamical model (Velychko, Knopp and Endres 2017-2020). With one part, a vGPDM.
#[pyclass(module = "vcgpdm")]
pub struct Vcgpdm {
    trained: Arc<Trained>,
    alpha: Py<PyArray2<f64>>,
}

impl Vcgpdm {
    fn new(py: Python<'_>, trained: Trained) -> PyResult<Self> {
        let alpha = coupled!(&trained, model => Ok(array(py, model.alpha()).unbind()))?;
        Ok(Self { trained: Arc::new(trained), alpha })
    }

    /// A mean rollout of `frames` frames from frame `frame` of the trial `sequence`, under these couplings.
    fn request(
        &self,
        py: Python<'_>,
        [frames, sequence, frame]: [Count; 3],
        alpha: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<RolloutRequest> {
        let alpha = Some(self.couplings(py, alpha)?);
        let [frames, sequence, frame] = [frames.0, sequence.0, frame.0];
        Ok(RolloutRequest { frames, sequence, frame, alpha, ..RolloutRequest::default() })
    }

    /// The couplings of an argument, or else those of the model, after a check.
    fn couplings(&self, py: Python<'_>, given: Option<&Bound<'_, PyAny>>) -> PyResult<DMatrix<f64>> {
        let alpha = matrix(given.unwrap_or(self.alpha.bind(py)), "alpha")?;
        coupled!(&self.trained, model => check_couplings(&alpha, model.model.parts.len()).map_err(refused))?;
        Ok(alpha)
    }

    /// The names of the parts, with a value for each.
    fn by_part<'py, T: IntoPyObject<'py>>(
        &self,
        py: Python<'py>,
        values: impl Iterator<Item = T>,
    ) -> PyResult<Bound<'py, PyDict>> {
        by_part(py, &self.trained, values)
    }
}

#[pymethods]
impl Vcgpdm {
    /// Trains a model.
    ///
    /// `data` is a clip, an array [frames x columns], or a list of them: each is a trial. `parts` splits a
    /// body by a preset ("lower,upper", "whole"; `Clip.presets` lists them) or by a dict of names with lists
    /// of joints, and the columns of arrays by a dict of names with lists of columns. Without it, a body has
    /// the parts lower and upper, and arrays have one part. The same seed gives the same model.
    ///
    /// `latent` (Q), `order` (p), `dynamics_ips` (K) and `pose_ips` (L) are the sizes of the model. Without
    /// them, K and L are 12, or 30 if a clip has 8 seconds or more.
    /// `pose_weight` multiplies the pose terms of the bound: a number, or "balanced" for Q_i / D_i; without
    /// it, "balanced" for clips and 1 for arrays. Clips are brought to about `fps` frames a second, and
    /// arrays have `fps` rows a second; `columns` are the names of their columns.
    ///
    /// A model of clips whose motion would come to rest learns from its own rollouts at the end, unless
    /// `own_rollouts` is False. With `as_in_papers`, training has the pose weight 1 and no own rollouts.
    ///
    /// `progress` is called with a `Progress` after every iteration. When it raises StopIteration, the best
    /// model so far is returned. Ctrl-C raises KeyboardInterrupt, whose attribute `model` is the best model
    /// so far. Warnings about the data arrive as UserWarning, and errors as ValueError.
    #[staticmethod]
    #[pyo3(signature = (
        data, parts=None, *, latent=Count(3), order=Count(2), dynamics_ips=None, pose_ips=None,
        max_iterations=Count(250), pose_weight=None, uncoupled=false, own_rollouts=true, as_in_papers=false,
        fps=30.0, columns=None, seed=Count(0), threads=Count(1), progress=None
    ), text_signature = "(data, parts=None, *, latent=3, order=2, dynamics_ips=None, pose_ips=None, \
        max_iterations=250, pose_weight=None, uncoupled=False, own_rollouts=True, as_in_papers=False, \
        fps=30.0, columns=None, seed=0, threads=1, progress=None)")]
    #[allow(clippy::too_many_arguments)]
    fn fit(
        py: Python<'_>,
        data: &Bound<'_, PyAny>,
        parts: Option<&Bound<'_, PyAny>>,
        latent: Count,
        order: Count,
        dynamics_ips: Option<Count>,
        pose_ips: Option<Count>,
        max_iterations: Count,
        pose_weight: Option<&Bound<'_, PyAny>>,
        uncoupled: bool,
        own_rollouts: bool,
        as_in_papers: bool,
        fps: f64,
        columns: Option<Vec<String>>,
        seed: Count,
        threads: Count,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let data = self::data(data, parts, columns, fps)?;
        let usual = match &data {
            Data::Body(dataset) => VariationalSettings::for_dataset(dataset),
            Data::Series(dataset) => VariationalSettings::for_dataset(dataset),
        };
        let settings = VariationalSettings {
            latent: latent.0,
            order: order.0,
            dynamics_ips: dynamics_ips.map_or(usual.dynamics_ips, |count| count.0),
            pose_ips: pose_ips.map_or(usual.pose_ips, |count| count.0),
            max_iterations: max_iterations.0,
            pose_weight: pose_weight.map_or(Ok(usual.pose_weight), read_weight)?,
            uncoupled,
            own_rollouts: usual.own_rollouts && own_rollouts,
        };
        let settings = Settings::Vcgpdm(if as_in_papers { settings.as_in_papers() } else { settings });
        let run = Run { settings, seed: seed.seed()?, threads: threads.0.max(1), progress };
        let (trained, interrupt) = match &data {
            Data::Body(dataset) => {
                let (model, interrupt) = train(py, dataset, &run)?;
                (Trained::Body(model), interrupt)
            }
            Data::Series(dataset) => {
                let (model, interrupt) = train(py, dataset, &run)?;
                (Trained::Series(model), interrupt)
            }
        };
        let model = Self::new(py, trained)?;
        match interrupt {
            None => Ok(model),
            Some(interrupt) => {
                interrupt.value(py).setattr("model", Py::new(py, model)?)?;
                Err(interrupt)
            }
        }
    }

    /// Reads a model of the terminal program, of the page or of `save`.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let text = fs::read_to_string(&path)?;
        Self::from_json(py, &text)
            .map_err(|error| refused(format!("{}: {}", path.display(), error.value(py))))
    }

    /// Writes the model as learned to a file, which the terminal program and the page read. Couplings that
    /// were set are not in the file.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        Ok(fs::write(path, self.to_json()?)?)
    }

    /// The model of a JSON document.
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str) -> PyResult<Self> {
        let trained = match Document::from_json(text).map_err(refused)? {
            Document::Body(model) => Trained::Body(*model),
            Document::Series(model) => Trained::Series(*model),
        };
        Self::new(py, trained)
    }

    /// The JSON document of the model as learned: the text that `save` writes.
    fn to_json(&self) -> PyResult<String> {
        match &*self.trained {
            Trained::Body(model) => model.to_json().map_err(refused),
            Trained::Series(model) => model.to_json().map_err(refused),
        }
    }

    /// The coupling variances `alpha[source, target]` [M x M] of rollouts; at first as learned. A large
    /// variance is a weak coupling. `model.alpha[0, 1] *= 10` changes one, `model.alpha = array` all.
    #[getter]
    fn alpha(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.alpha.clone_ref(py)
    }

    #[setter]
    fn set_alpha(&mut self, py: Python<'_>, alpha: &Bound<'_, PyAny>) -> PyResult<()> {
        self.alpha = array(py, &self.couplings(py, Some(alpha))?).unbind();
        Ok(())
    }

    /// The coupling variances as learned [M x M], a new array.
    #[getter]
    fn learned_alpha<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        coupled!(&self.trained, model => Ok(array(py, model.alpha())))
    }

    /// The weights of the experts [M x M] under `alpha`, source by target; those into each part sum to 1.
    #[getter]
    fn weights<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        Ok(array(py, &coupling_weight_matrix(&self.couplings(py, None)?)))
    }

    /// The latent means of the training frames: for each trial, a dict of the parts with arrays [frames x Q].
    /// Files of earlier versions have the first frames only.
    #[getter]
    fn latents<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        coupled!(&self.trained, model => {
            let trials = PyList::empty(py);
            for trial in &model.model.starts {
                trials.append(self.by_part(py, trial.iter().map(|part| array(py, part)))?)?;
            }
            Ok(trials)
        })
    }

    /// The bound on the log evidence that training reached, in nats.
    #[getter]
    fn bound(&self) -> PyResult<f64> {
        coupled!(&self.trained, model => Ok(model.provenance.bound()))
    }

    /// The highest value of what training maximised, in nats: the bound, or the sum of its terms
    /// with weighted poses.
    #[getter]
    fn objective(&self) -> PyResult<f64> {
        coupled!(&self.trained, model => Ok(model.provenance.objective))
    }

    /// Iterations of the training.
    #[getter]
    fn iterations(&self) -> PyResult<usize> {
        coupled!(&self.trained, model => Ok(model.provenance.iterations))
    }

    /// The names of the parts, in the order of the rows of `alpha`.
    #[getter]
    fn parts(&self) -> PyResult<Vec<String>> {
        part_names(&self.trained)
    }

    /// The names of the columns, in the order of `Rollout.y`.
    #[getter]
    fn columns(&self) -> PyResult<Vec<String>> {
        fn names<S: ColumnMapping>(model: Coupled<S>) -> Vec<String> {
            let mapping = &model.body.mapping;
            (0..mapping.column_count()).map(|column| mapping.column_name(column)).collect()
        }
        coupled!(&self.trained, model => Ok(names(model)))
    }

    /// Seconds from one frame to the next.
    #[getter]
    fn frame_time(&self) -> PyResult<f64> {
        coupled!(&self.trained, model => Ok(model.body.frame_time))
    }

    /// A new movement of `frames` frames, the start included.
    ///
    /// It starts at frame `frame` of the trial `sequence`; or it goes on from the observed frames `after`: a
    /// clip or an array [frames x columns], which need not be of the training. `alpha` [M x M] are the
    /// couplings of this rollout alone. `reading` says how the experts respond to changed couplings:
    /// "as-learned", or "re-inferred" from the training data. The result is the mean rollout; with `samples`,
    /// a list of this number of sampled rollouts, the first with the seed `seed`, the next with `seed` + 1.
    #[pyo3(signature = (
        frames=Count(300), *, sequence=Count(0), frame=Count(0), after=None, alpha=None, reading="as-learned",
        samples=None, seed=Count(0)
    ), text_signature = "($self, frames=300, *, sequence=0, frame=0, after=None, alpha=None, \
        reading='as-learned', samples=None, seed=0)")]
    #[allow(clippy::too_many_arguments)]
    fn rollout<'py>(
        &self,
        py: Python<'py>,
        frames: Count,
        sequence: Count,
        frame: Count,
        after: Option<&Bound<'py, PyAny>>,
        alpha: Option<&Bound<'py, PyAny>>,
        reading: &str,
        samples: Option<Count>,
        seed: Count,
    ) -> PyResult<Bound<'py, PyAny>> {
        let request = RolloutRequest {
            reading: read_reading(reading)?,
            ..self.request(py, [frames, sequence, frame], alpha)?
        };
        let rollout = |rollout: vcgpdm_core::models::Rollout| {
            Bound::new(py, Rollout::new(Arc::clone(&self.trained), request.clone(), rollout))
        };
        if let Some(after) = after {
            if samples.is_some() || sequence.0 > 0 || frame.0 > 0 {
                return Err(refused("after: expected no samples, sequence and frame with it"));
            }
            let observed = self.trained.rows(after)?;
            let mean = coupled!(&self.trained, model => after_observed(model, &observed, &request))?;
            return Ok(rollout(mean)?.into_any());
        }
        let Some(Count(samples)) = samples else {
            let mean = coupled!(&self.trained, model => {
                py.detach(|| model.rollout(&request)).map_err(refused)
            })?;
            return Ok(rollout(mean)?.into_any());
        };
        if samples > MOST_SAMPLES as usize {
            return Err(refused(format!("samples: expected at most {MOST_SAMPLES}, found {samples}")));
        }
        let first = u64::from(seed.seed()?);
        let seeds = first..first + samples as u64;
        let all = PyList::empty(py);
        coupled!(&self.trained, model => {
            for sample in model.sampled_rollouts(&request, seeds).map_err(refused)? {
                py.check_signals()?;
                all.append(rollout(sample.map_err(refused)?)?)?;
            }
            Ok(all.into_any())
        })
    }

    /// Means [frames x Q] and covariances [frames x Q x Q] of the latents of each part in a rollout, by
    /// moment matching: a dict of the parts with pairs of arrays.
    #[pyo3(signature = (frames=Count(300), *, sequence=Count(0), frame=Count(0), alpha=None),
        text_signature = "($self, frames=300, *, sequence=0, frame=0, alpha=None)")]
    fn moments<'py>(
        &self,
        py: Python<'py>,
        frames: Count,
        sequence: Count,
        frame: Count,
        alpha: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let request = self.request(py, [frames, sequence, frame], alpha)?;
        let moments = coupled!(&self.trained, model => {
            py.detach(|| model.moments(&request)).map_err(refused)
        })?;
        let pairs = moments.means.iter().zip(&moments.covariances);
        self.by_part(py, pairs.map(|(means, covariances)| (array(py, means), stacked(py, covariances))))
    }

    /// The error of a rollout compared with a whole trial, a clip or an array [frames x columns]: a dict of
    /// the mean squared error after dynamic time warping (`dtw_mse`) and frame by frame (`mse`), and the
    /// variance of the trial (`variance`), in squared units of the columns.
    #[pyo3(signature = (trial, *, sequence=Count(0)), text_signature = "($self, trial, *, sequence=0)")]
    fn score<'py>(
        &self,
        py: Python<'py>,
        trial: &Bound<'py, PyAny>,
        sequence: Count,
    ) -> PyResult<Bound<'py, PyAny>> {
        let actual = self.trained.rows(trial)?;
        let request = self.request(py, [Count(actual.nrows()), sequence, Count(0)], None)?;
        let predicted = coupled!(&self.trained, model => model.rollout(&request).map_err(refused))?.y;
        dict(py, &py.detach(|| dtw_mse(&predicted, &actual)).map_err(refused)?)
    }

    fn __repr__(&self) -> PyResult<String> {
        let parts = part_names(&self.trained)?.join(", ");
        let (latent, bound) = coupled!(&self.trained, model => {
            Ok((model.model.latent_dimensions(), model.provenance.bound()))
        })?;
        Ok(format!("Vcgpdm(parts {parts}; latent dimensions {latent:?}; bound {bound:.1} nats)"))
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, (String,), Bound<'py, PyAny>)> {
        let model = slf.borrow();
        let alpha = model.alpha.bind(slf.py()).call_method0("copy")?;
        Ok((slf.get_type().getattr("from_json")?, (model.to_json()?,), alpha))
    }

    fn __setstate__(&mut self, py: Python<'_>, alpha: &Bound<'_, PyAny>) -> PyResult<()> {
        self.set_alpha(py, alpha)
    }
}

fn read_reading(text: &str) -> PyResult<Reading> {
    match text {
        "as-learned" => Ok(Reading::AsLearned),
        "re-inferred" => Ok(Reading::ReInferred),
        _ => Err(refused(format!("reading: expected as-learned or re-inferred, found {text:?}"))),
    }
}

fn read_weight(given: &Bound<'_, PyAny>) -> PyResult<PoseWeight> {
    if let Ok(text) = given.extract::<String>() {
        if text == BALANCED {
            return Ok(PoseWeight::Balanced);
        }
        return Err(refused(format!("pose_weight: expected a number or {BALANCED}, found {text:?}")));
    }
    let number = given.extract().map_err(|_| {
        let found = given.get_type();
        PyTypeError::new_err(format!("pose_weight: expected a number or {BALANCED:?}, found {found}"))
    })?;
    Ok(PoseWeight::Fixed(number))
}
