//! A model of any kind with the body that it moves: what a page or a program needs to show it.

use crate::gp::NumericsError;
use crate::models::body::Body;
use crate::models::kind::ModelKind;
use crate::models::learner::{Learner, MovementModel};
use crate::models::motion_model::{ENGINE, MotionModel, RolloutRequest};
use crate::models::rollout::RolloutError;
use nalgebra::DMatrix;

/// A model of any kind.
pub enum AnyModel {
    /// The vCGPDM or vGPDM, which has couplings to change and latents to show.
    Variational(Box<MotionModel>),
    /// Any other model; it only rolls out.
    Baseline(Box<BaselineModel>),
}

/// A model that only rolls out, with its body.
pub struct BaselineModel {
    /// What turns its columns into poses, and what it was trained on.
    pub body: Body,
    /// The fitted model.
    pub model: Box<dyn MovementModel>,
    /// How it was made.
    pub record: Record,
}

/// How a baseline was made.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// The program and its version.
    pub engine: String,
    /// Names and values of what training was asked to do, the seed included; yes is 1.
    pub settings: Vec<(String, f64)>,
    /// The frame rate asked for.
    pub frames_per_second: f64,
    /// What was maximised, at its best.
    pub objective: f64,
    /// Iterations.
    pub iterations: usize,
    /// Anything a person wants to say about it, such as an acknowledgement.
    pub note: Option<String>,
}

impl BaselineModel {
    /// The best model of a training so far; `settings` are names and values of what it was asked to do, and
    /// `frames_per_second` is the rate that the data set of the `body` was asked for.
    pub fn trained(
        body: Body,
        learner: &dyn Learner,
        settings: Vec<(String, f64)>,
        frames_per_second: f64,
    ) -> Result<Self, NumericsError> {
        let progress = learner.progress();
        let record = Record {
            engine: ENGINE.to_owned(),
            settings,
            frames_per_second,
            objective: progress.best,
            iterations: progress.iteration,
            note: None,
        };
        Ok(Self { body, model: learner.model()?, record })
    }
}

impl AnyModel {
    /// Which kind of model it is.
    pub fn kind(&self) -> ModelKind {
        match self {
            AnyModel::Variational(model) if model.fitted.part_count() == 1 => ModelKind::Vgpdm,
            AnyModel::Variational(_) => ModelKind::Vcgpdm,
            AnyModel::Baseline(baseline) => baseline.model.kind(),
        }
    }

    /// What turns its columns into poses, positions and clips.
    pub fn body(&self) -> &Body {
        match self {
            AnyModel::Variational(model) => &model.body,
            AnyModel::Baseline(baseline) => &baseline.body,
        }
    }

    /// All columns, means included [frames x D], continuing as the training sequence `sequence` starts.
    pub fn rollout(&self, sequence: usize, frames: usize) -> Result<DMatrix<f64>, RolloutError> {
        match self {
            AnyModel::Variational(model) => {
                let request = RolloutRequest { frames, sequence, ..RolloutRequest::default() };
                Ok(model.rollout(&request)?.y)
            }
            AnyModel::Baseline(baseline) => {
                let BaselineModel { body, model, .. } = &**baseline;
                body.check_frames(frames, 0)?;
                Ok(body.columns(&model.rollout(sequence, frames)?))
            }
        }
    }
}
