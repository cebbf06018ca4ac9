//! Trained vCGPDMs and vGPDMs: rollouts under other couplings, sampled rollouts, poses of latents.

use crate::models::data::column_mapping::ColumnMapping;
use crate::models::kinds::body::Body;
use crate::models::rollout::couplings::coupling_weight_matrix;
use crate::models::rollout::request::{Rollout, RolloutError, RolloutRequest};
use crate::models::training::provenance::Provenance;
use crate::models::variational::{LatentMoments, PredictiveDynamics, Vcgpdm};
use crate::motion::Clip;
use crate::motion::pose::{PoseError, PoseMapping};
use nalgebra::DMatrix;

/// A trained model whose couplings can be changed: a borrowed view of a [`Model`](crate::models::Model).
#[derive(Debug)]
pub struct Coupled<'a, S = PoseMapping> {
    /// Pose maps, experts and couplings.
    #[doc(hidden)]
    pub model: &'a Vcgpdm,
    /// From columns to poses, and the sequences that the model was trained on.
    pub body: &'a Body<S>,
    /// Settings, seed and results of the training.
    pub provenance: &'a Provenance,
}

// A derived `Clone` would require `S: Clone`, which a reference does not need.
impl<S> Clone for Coupled<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for Coupled<'_, S> {}

impl<'a, S: ColumnMapping> Coupled<'a, S> {
    pub(crate) fn new(model: &'a Vcgpdm, body: &'a Body<S>, provenance: &'a Provenance) -> Self {
        Self { model, body, provenance }
    }

    /// The learned couplings `alpha[(source, target)]` [M x M]: the variance of the source part's prediction
    /// about the target part.
    pub fn alpha(&self) -> &DMatrix<f64> {
        &self.model.alpha
    }

    /// The order p of the dynamics: frames of history that the experts see.
    pub fn order(&self) -> usize {
        self.model.order
    }

    /// Checks that a rollout can have `frames` frames.
    ///
    /// # Errors
    ///
    /// When the number of frames is 0 or too large.
    pub fn check_frames(&self, frames: usize) -> Result<(), RolloutError> {
        self.body.check_frames(frames, self.model.latent_dimensions().iter().sum())
    }

    /// The mean rollout from a training sequence's start or from the start latents of the request, under the
    /// learned couplings or others.
    ///
    /// # Errors
    ///
    /// When the couplings or the start latents do not fit the model, there is no such sequence, or the number of
    /// frames is 0 or too large.
    pub fn rollout(&self, request: &RolloutRequest) -> Result<Rollout, RolloutError> {
        self.check_frames(request.frames)?;
        Ok(self.rollout_along(self.model.path(request)?, request))
    }

    /// Sampled rollouts, one for each of `seeds`. The latents of every frame are drawn from the predictive
    /// distribution of the experts; the poses are the mean poses at these latents. A request with cuts or
    /// pushes is refused.
    ///
    /// # Errors
    ///
    /// As [`Coupled::rollout`].
    pub fn sampled_rollouts<'r>(
        self,
        request: &'r RolloutRequest,
        seeds: impl IntoIterator<Item = u64> + 'r,
    ) -> Result<impl Iterator<Item = Result<Rollout, RolloutError>> + 'r, RolloutError>
    where
        'a: 'r,
    {
        self.check_frames(request.frames)?;
        let dynamics = self.predictive_dynamics(request)?;
        let start = self.model.start_of(request)?;
        Ok(seeds
            .into_iter()
            .map(move |seed| Ok(self.rollout_along(dynamics.sample(&start, request.frames, seed)?, request))))
    }

    /// The moments of the latents in every frame of a rollout, in a Gaussian approximation. A request with
    /// cuts or pushes is refused.
    ///
    /// # Errors
    ///
    /// As [`Coupled::rollout`], when the request has cuts or pushes, or when a covariance cannot be
    /// factorised.
    pub fn moments(&self, request: &RolloutRequest) -> Result<LatentMoments, RolloutError> {
        self.check_frames(request.frames)?;
        self.predictive_dynamics(request)?.moments(&self.model.start_of(request)?, request.frames)
    }

    /// The dynamics with their variances under the couplings of a request.
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

impl Coupled<'_> {
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

    /// World positions of the figure's nodes [nodes x 3] with every part at a latent point: the points `[Q_i]`
    /// of all parts, one after the other.
    ///
    /// # Errors
    ///
    /// When the points do not have the latent dimensions of the parts.
    pub fn body_pose(&self, latents: &[f64]) -> Result<Vec<f32>, RolloutError> {
        let columns = self.model.latent_dimensions();
        let (expected, found) = (columns.iter().sum::<usize>(), latents.len());
        if found != expected {
            let part = columns.len() - 1;
            let found_columns = (columns[part] + found).saturating_sub(expected);
            return Err(RolloutError::Start {
                part,
                rows: 1,
                columns: columns[part],
                found_rows: 1,
                found_columns,
            });
        }
        let mut left = latents;
        let mut points = Vec::with_capacity(columns.len());
        for q in columns {
            let (point, rest) = left.split_at(q);
            points.push(DMatrix::from_row_slice(1, q, point));
            left = rest;
        }
        let y = self.body.columns(&self.model.observations(&points));
        Ok(self.body.positions(&y)?)
    }
}
