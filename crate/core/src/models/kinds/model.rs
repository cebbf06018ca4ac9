//! Trained models: the fitted numbers with the body or table that they predict, and the provenance.

use crate::models::data::column_mapping::ColumnMapping;
use crate::models::kinds::body::Body;
use crate::models::kinds::coupled::Coupled;
use crate::models::kinds::fitted_model::FittedModel;
use crate::models::rollout::request::{Handles, RolloutError};
use crate::models::training::kind::ModelKind;
use crate::models::training::provenance::Provenance;
use crate::motion::pose::PoseMapping;
use crate::series::Columns;
use nalgebra::DMatrix;

/// A trained model of any kind, ready to roll out. It holds no training clip.
///
/// `S` is the meaning of its columns: the poses of a body, or the columns of tables ([`SeriesModel`]).
#[derive(Clone, Debug)]
pub struct Model<S = PoseMapping> {
    /// The fitted numbers.
    #[doc(hidden)]
    pub fitted: FittedModel,
    /// From columns to poses, and the sequences that the model was trained on.
    pub body: Body<S>,
    /// Settings, seed and results of the training.
    pub provenance: Provenance,
}

/// A trained model of tables.
pub type SeriesModel = Model<Columns>;

impl<S: ColumnMapping> Model<S> {
    /// The kind of model.
    pub fn kind(&self) -> ModelKind {
        self.fitted.kind()
    }

    /// The model with its couplings and latents; `None` for all kinds but vCGPDM and vGPDM.
    pub fn coupled(&self) -> Option<Coupled<'_, S>> {
        match &self.fitted {
            FittedModel::Vcgpdm(model) => Some(Coupled::new(model, &self.body, &self.provenance)),
            FittedModel::Map(_) | FittedModel::Tmp(_) | FittedModel::Dmp(_) => None,
        }
    }

    /// A MAP CGPDM with other coupling variances [M x M], row the source, column the target; `None` for all
    /// other kinds. A vCGPDM takes them in each [`RolloutRequest`](crate::models::RolloutRequest).
    ///
    /// # Errors
    ///
    /// When `alpha` is not [M x M] and positive, or a covariance cannot be factorised.
    pub fn with_alpha(&self, alpha: DMatrix<f64>) -> Option<Result<Self, RolloutError>>
    where
        S: Clone,
    {
        let FittedModel::Map(model) = &self.fitted else { return None };
        let with = |model| Self { fitted: FittedModel::Map(Box::new(model)), ..self.clone() };
        (self.kind() == ModelKind::MapCgpdm).then(|| model.with_alpha(alpha).map(with))
    }

    /// All columns, means included [frames x D], starting as the training sequence `sequence` starts, counted
    /// from 0.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the number of frames is 0 or too large.
    pub fn rollout(&self, sequence: usize, frames: usize) -> Result<DMatrix<f64>, RolloutError> {
        self.rollout_with(sequence, frames, &Handles::default())
    }

    /// As [`rollout`](Self::rollout), of a TMP or DMP with handles.
    ///
    /// # Errors
    ///
    /// As [`rollout`](Self::rollout), and when the handles do not fit the model or its columns.
    pub fn rollout_with(
        &self,
        sequence: usize,
        frames: usize,
        handles: &Handles,
    ) -> Result<DMatrix<f64>, RolloutError> {
        match self.coupled() {
            Some(coupled) => coupled.check_frames(frames)?,
            None => self.body.check_frames(frames, 0)?,
        }
        handles.check(frames, self.body.column_means.len())?;
        let handles = self.body.handles_of_parts(handles);
        let mut y = self.body.columns(&self.fitted.rollout_with(sequence, frames, &handles)?);
        self.body.scale_rates(&mut y, handles.tempo);
        Ok(y)
    }
}
