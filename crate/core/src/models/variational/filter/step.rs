//! One step of the filter: predict, correct, clamp.

use crate::gp::NumericsError;
use crate::models::rollout::couplings::Reading;
use crate::models::rollout::request::RolloutError;
use crate::models::training::pose_weight::PoseWeight;
use crate::models::variational::filter::correction::{Observed, clamp, correct};
use crate::models::variational::filter::error::ObservationError;
use crate::models::variational::filter::pose_process::{ColumnMoments, PoseProcess};
use crate::models::variational::model::Vcgpdm;
use crate::models::variational::moments::{Belief, select};
use crate::models::variational::predictive::PredictiveDynamics;
use nalgebra::{DMatrix, DVector};
use std::ops::Range;

/// A trained model that infers latents from observed columns. Columns are centred, and a missing number is
/// NaN.
#[derive(Clone, Debug)]
pub struct Filter {
    pub(super) dynamics: PredictiveDynamics,
    pub(super) poses: Vec<PoseProcess>,
    /// The power of the likelihood of each part's columns `[M]`.
    pub(super) weights: Vec<f64>,
    /// Latent paths [frames x Q_i] of each part where the model moved in training.
    pub(super) references: Vec<Vec<DMatrix<f64>>>,
}

impl Vcgpdm {
    /// The model as a filter under the couplings `alpha` [M x M], row the source. The likelihood of the
    /// columns has the same power as the pose terms had in training: their `weight`.
    ///
    /// # Errors
    ///
    /// When the couplings do not fit the model, or a covariance cannot be factorised.
    pub fn filter(
        &self,
        alpha: &DMatrix<f64>,
        reading: Reading,
        weight: PoseWeight,
    ) -> Result<Filter, RolloutError> {
        let dynamics = self.predictive_dynamics(alpha, reading)?;
        let poses = self.parts.iter().map(|map| PoseProcess::new(map, self.jitter));
        let poses = poses.collect::<Result<Vec<_>, _>>()?;
        let weights = poses.iter().map(|map| weight.factor(map.latent(), map.columns())).collect();
        Ok(Filter { dynamics, poses, weights, references: reference_paths(self)? })
    }
}

impl Filter {
    /// Order p of the dynamics.
    pub fn order(&self) -> usize {
        self.dynamics.order
    }

    /// The numbers of columns D_i of the parts `[M]`.
    pub fn columns(&self) -> Vec<usize> {
        self.poses.iter().map(PoseProcess::columns).collect()
    }

    /// The belief about the next frame, before it is observed.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn predict(&self, belief: &Belief) -> Result<Belief, NumericsError> {
        Ok(self.dynamics.advanced(&self.dynamics.joint(belief)?))
    }

    /// Corrects a belief by the columns `[D_i]` of each part in the frame `lag` frames before the newest one.
    /// Returns the log density of the numbers under the belief, in nats; with
    /// weighted pose terms, that of their power.
    ///
    /// # Errors
    ///
    /// When the row does not fit the model, or a covariance cannot be factorised.
    pub fn correct(
        &self,
        belief: &mut Belief,
        lag: usize,
        row: &[Vec<f64>],
    ) -> Result<f64, ObservationError> {
        if row.len() != self.poses.len() {
            return Err(ObservationError::Parts { expected: self.poses.len(), found: row.len() });
        }
        let mut parts = Vec::new();
        for (part, (map, row)) in self.poses.iter().zip(row).enumerate() {
            if row.len() != map.columns() {
                let (expected, found) = (map.columns(), row.len());
                return Err(ObservationError::Columns { part, expected, found });
            }
            let columns: Vec<usize> = (0..row.len()).filter(|&c| !row[c].is_nan()).collect();
            if !columns.is_empty() {
                let values = columns.iter().map(|&c| row[c]).collect();
                let weight = self.weights[part];
                parts.push(Observed {
                    map,
                    weight,
                    places: self.places(part, lag).collect(),
                    columns,
                    values,
                });
            }
        }
        Ok(correct(belief, &parts)?)
    }

    /// Gives a part these newest latents `[Q_i]` for certain: somebody moves it by hand.
    ///
    /// # Errors
    ///
    /// When the latents do not fit the part, or a covariance cannot be factorised.
    pub fn clamp(&self, belief: &mut Belief, part: usize, latents: &[f64]) -> Result<(), ObservationError> {
        let expected = self.poses.get(part).map_or(0, PoseProcess::latent);
        if latents.len() != expected || expected == 0 {
            return Err(ObservationError::Columns { part, expected, found: latents.len() });
        }
        let places: Vec<usize> = self.places(part, 0).collect();
        Ok(clamp(belief, &places, latents)?)
    }

    /// The columns of a part under Gaussian latents with this `mean` `[Q_i]` and `covariance` [Q_i x Q_i].
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn column_moments(
        &self,
        part: usize,
        mean: &DVector<f64>,
        covariance: &DMatrix<f64>,
    ) -> Result<ColumnMoments, NumericsError> {
        self.poses[part].moments(mean, covariance)
    }

    /// Mean and covariance of the latents of a part in the frame `lag` frames before the newest one.
    pub fn latents(&self, belief: &Belief, part: usize, lag: usize) -> (DVector<f64>, DMatrix<f64>) {
        let places: Vec<usize> = self.places(part, lag).collect();
        let mean = DVector::from_fn(places.len(), |k, _| belief.mean[places[k]]);
        (mean, select(&belief.covariance, &places))
    }

    /// The places of the latents of a part in a belief, `lag` frames before the newest frame.
    pub(super) fn places(&self, part: usize, lag: usize) -> Range<usize> {
        let q = self.poses[part].latent();
        let end = self.dynamics.inputs(part).end - lag * q;
        end - q..end
    }
}

/// The length of a rollout that replaces the latents of a sequence, where the model stores only the first frames.
const ROLLED_OUT: usize = 120;

/// A latent path [frames x Q_i] of each part for every training sequence: the trained latents, or, of a model
/// that stores only the first ones, a rollout from them.
pub(super) fn reference_paths(model: &Vcgpdm) -> Result<Vec<Vec<DMatrix<f64>>>, RolloutError> {
    let dynamics = model.dynamics(&model.alpha, Reading::AsLearned)?;
    let path = |start: &Vec<DMatrix<f64>>| {
        let stored = start.first().map_or(0, DMatrix::nrows);
        if stored > model.order { Ok(start.clone()) } else { dynamics.path(start, ROLLED_OUT) }
    };
    model.starts.iter().map(path).collect()
}
