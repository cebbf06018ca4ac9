//! A trained model of a body: the fitted model with what turns its columns into poses, and how it was made.

use crate::gp::NumericsError;
use crate::models::data::dataset::Dataset;
use crate::models::data::observed::Observed;
use crate::models::fitted::body::Body;
use crate::models::fitted::model::Model;
use crate::models::fitted::provenance::{ENGINE, Provenance};
use crate::models::rollout::couplings::coupling_weight_matrix;
use crate::models::rollout::request::{Rollout, RolloutError, RolloutRequest};
use crate::models::training::kind::ModelKind;
use crate::models::training::learner::Learner;
use crate::models::training::settings::{ModelSettings, VariationalSettings};
use crate::models::variational::{LatentMoments, PredictiveDynamics, Trainer, Vcgpdm};
use crate::motion::Clip;
use crate::motion::pose::{PoseError, PoseMapping};
use crate::series::Columns;
use nalgebra::DMatrix;
use std::fmt::Debug;

/// A fitted model that names the type of its settings.
pub trait Fitted {
    /// What its training is asked for.
    type Settings: Clone + Debug + PartialEq;
}

impl Fitted for Model {
    type Settings = ModelSettings;
}

impl Fitted for Vcgpdm {
    type Settings = VariationalSettings;
}

/// A trained model with the body that it moves, ready to roll out. It holds no training clip.
///
/// `TrainedModel` alone is of any kind and rolls out as it was learned; a `TrainedModel<Vcgpdm>` has
/// couplings that can be changed, and latents to show. `S` is what its columns are: poses, or the columns of
/// tables (a [`SeriesModel`]).
#[derive(Clone, Debug)]
pub struct TrainedModel<M: Fitted = Model, S = PoseMapping> {
    /// The fitted model.
    pub model: M,
    /// What turns its columns into poses, and what it was trained on.
    pub body: Body<S>,
    /// How the model was made.
    pub provenance: Provenance<M::Settings>,
}

/// A trained model of time series that are no body.
pub type SeriesModel<M = Model> = TrainedModel<M, Columns>;

impl<S: Observed> TrainedModel<Model, S> {
    /// The best model of a training so far; `settings`, `seed` and `frames_per_second` are what the training
    /// and the data set were asked for.
    ///
    /// # Errors
    ///
    /// When a covariance of the model cannot be factorised.
    pub fn trained(
        dataset: &Dataset<S>,
        learner: &dyn Learner,
        settings: ModelSettings,
        seed: u32,
        frames_per_second: f64,
    ) -> Result<Self, NumericsError> {
        let progress = learner.progress();
        let provenance = Provenance {
            engine: ENGINE.to_owned(),
            seed: if settings.is_random() { seed } else { 0 },
            settings,
            frames_per_second,
            objective: progress.best,
            iterations: progress.iteration,
            evaluations: progress.evaluations,
            note: None,
        };
        Ok(Self { model: learner.model()?, body: Body::new(dataset), provenance })
    }

    /// The kind of model.
    pub fn kind(&self) -> ModelKind {
        self.model.kind()
    }

    /// All columns, means included [frames x D], starting as the training sequence `sequence` starts.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the number of frames is 0 or too large.
    pub fn rollout(&self, sequence: usize, frames: usize) -> Result<DMatrix<f64>, RolloutError> {
        let width = match &self.model {
            Model::Vcgpdm(model) => latent_columns(model),
            Model::Map(_) | Model::Tmp(_) | Model::DmpDiscrete(_) | Model::DmpRhythmic(_) => 0,
        };
        self.body.check_frames(frames, width)?;
        Ok(self.body.columns(&self.model.rollout(sequence, frames)?))
    }

    /// The same as a model whose couplings can be changed; a model of another kind is given back.
    ///
    /// # Errors
    ///
    /// The model itself, when it has no such couplings.
    #[expect(clippy::result_large_err, reason = "the error is the model itself, given back")]
    pub fn into_vcgpdm(self) -> Result<TrainedModel<Vcgpdm, S>, Self> {
        let Self { model, body, provenance } = self;
        match (model, provenance.settings.clone()) {
            (Model::Vcgpdm(model), ModelSettings::Vcgpdm(settings) | ModelSettings::Vgpdm(settings)) => {
                let provenance = provenance.with_settings(|_| settings);
                Ok(TrainedModel { model: *model, body, provenance })
            }
            (model, _) => Err(Self { model, body, provenance }),
        }
    }
}

impl<S> From<TrainedModel<Vcgpdm, S>> for TrainedModel<Model, S> {
    fn from(trained: TrainedModel<Vcgpdm, S>) -> Self {
        let TrainedModel { model, body, provenance } = trained;
        let one_part = model.part_count() == 1;
        let any = if one_part { ModelSettings::Vgpdm } else { ModelSettings::Vcgpdm };
        Self { model: Model::Vcgpdm(Box::new(model)), body, provenance: provenance.with_settings(any) }
    }
}

impl<S: Observed> TrainedModel<Vcgpdm, S> {
    /// The best model of a training so far; `frames_per_second` is the rate that the data set was asked for.
    ///
    /// # Errors
    ///
    /// When a covariance of the model cannot be factorised.
    pub fn trained(
        dataset: &Dataset<S>,
        trainer: &Trainer,
        frames_per_second: f64,
    ) -> Result<Self, NumericsError> {
        let provenance = trainer.provenance(frames_per_second);
        Ok(Self { model: trainer.model()?, body: Body::new(dataset), provenance })
    }

    /// Whether so many frames can be rolled out.
    ///
    /// # Errors
    ///
    /// When they are none or too many.
    pub fn check_frames(&self, frames: usize) -> Result<(), RolloutError> {
        self.body.check_frames(frames, latent_columns(&self.model))
    }

    /// The mean rollout from a training sequence's start latents, under the learned couplings or others.
    ///
    /// # Errors
    ///
    /// When the couplings do not fit the model, there is no such sequence, or the number of frames is 0 or
    /// too large.
    pub fn rollout(&self, request: &RolloutRequest) -> Result<Rollout, RolloutError> {
        self.check_frames(request.frames)?;
        Ok(self.rollout_along(self.model.path(request)?, request))
    }

    /// Sampled rollouts, one for each of `seeds`, made one after the other: every frame is drawn from what
    /// the experts predict, with their variances. The poses are the mean poses at the sampled latents. Cuts
    /// and pushes are for mean rollouts alone.
    ///
    /// # Errors
    ///
    /// As [`TrainedModel::rollout`].
    pub fn sampled_rollouts<'a>(
        &'a self,
        request: &'a RolloutRequest,
        seeds: impl IntoIterator<Item = u64> + 'a,
    ) -> Result<impl Iterator<Item = Result<Rollout, RolloutError>> + 'a, RolloutError> {
        self.check_frames(request.frames)?;
        let dynamics = self.predictive_dynamics(request)?;
        let start = self.model.start(request.sequence, request.frame)?;
        Ok(seeds
            .into_iter()
            .map(move |seed| Ok(self.rollout_along(dynamics.sample(&start, request.frames, seed)?, request))))
    }

    /// The moments of the latents in every frame of a rollout, as far as Gaussians can say. Cuts and pushes
    /// are for mean rollouts alone.
    ///
    /// # Errors
    ///
    /// As [`TrainedModel::rollout`], and when a covariance cannot be factorised.
    pub fn moments(&self, request: &RolloutRequest) -> Result<LatentMoments, RolloutError> {
        self.check_frames(request.frames)?;
        self.predictive_dynamics(request)?
            .moments(&self.model.start(request.sequence, request.frame)?, request.frames)
    }

    /// The dynamics with their variances under the couplings that a request asks for.
    ///
    /// # Errors
    ///
    /// When the couplings do not fit the model, the request has cuts or pushes, or a covariance cannot be
    /// factorised.
    pub fn predictive_dynamics(&self, request: &RolloutRequest) -> Result<PredictiveDynamics, RolloutError> {
        if !request.cuts.is_empty() || !request.pushes.is_empty() {
            return Err(RolloutError::Disturbed);
        }
        self.model.predictive_dynamics(request.alpha_or(&self.model.alpha), request.reading)
    }

    fn rollout_along(&self, latents: Vec<DMatrix<f64>>, request: &RolloutRequest) -> Rollout {
        let y = self.body.columns(&self.model.observations(&latents));
        Rollout { latents, y, weights: coupling_weight_matrix(request.alpha_or(&self.model.alpha)) }
    }
}

impl TrainedModel<Vcgpdm> {
    /// The rollout as a clip, starting at the origin.
    ///
    /// # Errors
    ///
    /// When its columns cannot be turned into poses.
    pub fn clip(&self, rollout: &Rollout, name: &str) -> Result<Clip, PoseError> {
        self.body.clip(&rollout.y, name)
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, for a body 1.7 m tall.
    ///
    /// # Errors
    ///
    /// When its columns cannot be turned into poses.
    pub fn positions(&self, rollout: &Rollout) -> Result<Vec<f32>, PoseError> {
        self.body.positions(&rollout.y)
    }

    /// World positions of the figure's nodes [nodes x 3] with one part at a latent point `[Q_i]` and the
    /// others at their mean pose.
    ///
    /// # Errors
    ///
    /// When there is no such part, or the point does not have its latent dimensions.
    pub fn pose(&self, part: usize, latent: &[f64]) -> Result<Vec<f32>, RolloutError> {
        let parts = &self.model.parts;
        let columns = parts.get(part).map_or(0, |p| p.r().ncols());
        if latent.len() != columns || columns == 0 {
            return Err(RolloutError::Start {
                part,
                rows: 1,
                columns,
                found_rows: 1,
                found_columns: latent.len(),
            });
        }
        let mut latents: Vec<DMatrix<f64>> = parts.iter().map(|p| DMatrix::zeros(0, p.r().ncols())).collect();
        latents[part] = DMatrix::from_row_slice(1, columns, latent);
        let y = self.body.columns(&self.model.observations(&latents));
        Ok(self.body.positions(&y)?)
    }
}

/// Latent dimensions of all parts together.
fn latent_columns(model: &Vcgpdm) -> usize {
    model.latent_dimensions().iter().sum()
}
