//! Trainings, with progress and Ctrl-C.

use crate::refused;
use pyo3::exceptions::{PyKeyboardInterrupt, PyStopIteration, PyUserWarning};
use pyo3::prelude::*;
use std::ffi::CString;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};
use vcgpdm_core::models::{ColumnMapping, Dataset, Model, Progress as State, Settings, Trainer};

/// Without a progress function, Ctrl-C is looked for this often.
const PATIENCE: Duration = Duration::from_millis(50);

/// How far a training is.
#[pyclass(module = "vcgpdm", frozen, get_all)]
pub struct Progress {
    /// Iterations so far.
    iteration: usize,
    /// The most iterations.
    max_iterations: usize,
    /// What training maximises, at this iteration, in nats: the bound, or the sum of its terms with weighted poses.
    objective: f64,
    /// The highest objective so far, in nats.
    best: f64,
    /// The bound on the log evidence where the objective was highest, in nats.
    bound: Option<f64>,
    /// "couplings, kernels and inducing points", "everything together" or "learning from its own rollouts".
    phase: Option<String>,
    /// Share of the iterations used, 0 to 1.
    fraction: f64,
}

#[pymethods]
impl Progress {
    fn __repr__(&self) -> String {
        let Self { iteration, max_iterations, best, .. } = self;
        format!("Progress(iteration {iteration} of {max_iterations}, best {best:.1})")
    }
}

impl From<&State> for Progress {
    fn from(state: &State) -> Self {
        Self {
            iteration: state.iteration,
            max_iterations: state.max_iterations,
            objective: state.objective,
            best: state.best,
            bound: state.terms.as_ref().map(|terms| terms.total()),
            phase: state.phase.map(|phase| phase.to_string()),
            fraction: state.fraction,
        }
    }
}

/// How a training runs.
pub struct Run {
    pub settings: Settings,
    pub seed: u32,
    pub threads: usize,
    pub progress: Option<Py<PyAny>>,
}

/// The model of a training, and the interrupt that ended it, if one did. Other Python programs run meanwhile.
pub fn train<S>(py: Python<'_>, dataset: &Dataset<S>, run: &Run) -> PyResult<(Model<S>, Option<PyErr>)>
where
    S: ColumnMapping + Send + Sync,
{
    py.detach(|| {
        let mut trainer = Trainer::new(dataset, &run.settings, run.seed).map_err(refused)?;
        trainer.use_threads(run.threads);
        Python::attach(|py| warn(py, trainer.warnings()))?;
        let (mut asked, mut end) = (Instant::now(), None);
        trainer.run_with(|state| {
            if run.progress.is_none() && asked.elapsed() < PATIENCE {
                return ControlFlow::Continue(());
            }
            asked = Instant::now();
            match Python::attach(|py| report(py, run.progress.as_ref(), state)) {
                Ok(()) => ControlFlow::Continue(()),
                Err(error) => {
                    end = Some(error);
                    ControlFlow::Break(())
                }
            }
        });
        let stopped = |error: &PyErr| Python::attach(|py| error.is_instance_of::<PyStopIteration>(py));
        let interrupted =
            |error: &PyErr| Python::attach(|py| error.is_instance_of::<PyKeyboardInterrupt>(py));
        let interrupt = match end {
            Some(error) if interrupted(&error) => Some(error),
            Some(error) if !stopped(&error) => return Err(error),
            _ => None,
        };
        Ok((trainer.finish().map_err(refused)?, interrupt))
    })
}

fn report(py: Python<'_>, progress: Option<&Py<PyAny>>, state: &State) -> PyResult<()> {
    py.check_signals()?;
    if let Some(progress) = progress {
        progress.call1(py, (Progress::from(state),))?;
    }
    Ok(())
}

fn warn(py: Python<'_>, sentences: Vec<String>) -> PyResult<()> {
    for sentence in sentences {
        PyErr::warn(py, &py.get_type::<PyUserWarning>(), &CString::new(sentence)?, 1)?;
    }
    Ok(())
}
