//! A trained model of a body: the fitted vCGPDM with what turns its columns into poses, and where it came from.

use crate::gp::NumericsError;
use crate::json::rows;
use crate::models::body::Body;
use crate::models::dataset::Dataset;
use crate::models::rollout::{Poser, Roller, RolloutError};
use crate::models::settings::VariationalSettings;
use crate::models::variational::{BoundTerms, FittedModel, Reading, Trainer, coupling_weight_matrix};
use crate::motion::Clip;
use crate::motion::pose::PoseError;
use nalgebra::DMatrix;
use serde::Deserialize;

/// The program and its version, as documents and results name what made them.
pub const ENGINE: &str = concat!("vcgpdm ", env!("CARGO_PKG_VERSION"));

/// How a model was made.
#[derive(Clone, Debug, PartialEq)]
pub struct Provenance {
    /// The program and its version.
    pub engine: String,
    /// What training was asked to do.
    pub settings: VariationalSettings,
    /// The seed of everything random.
    pub seed: u32,
    /// The frame rate asked for.
    pub frames_per_second: f64,
    /// The final bound, in nats.
    pub bound: f64,
    /// Its terms.
    pub terms: BoundTerms,
    /// Optimiser iterations.
    pub iterations: usize,
    /// Evaluations of the bound with its gradient.
    pub evaluations: usize,
    /// Anything a person wants to say about it, such as an acknowledgement.
    pub note: Option<String>,
}

/// A trained model, ready to roll out; holds no training clip.
#[derive(Clone, Debug)]
pub struct MotionModel {
    /// The fitted model.
    pub fitted: FittedModel,
    /// What turns its columns into poses, and what it was trained on.
    pub body: Body,
    /// How the model was made.
    pub provenance: Provenance,
    poser: Poser,
}

/// What a rollout is asked for.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RolloutRequest {
    /// Frames in all, the start included.
    pub frames: usize,
    /// The training sequence whose start latents begin it, counted from 0.
    pub sequence: usize,
    /// Couplings [M x M], row the source; absent: as learned.
    #[serde(default, deserialize_with = "rows::optional_matrix")]
    pub alpha: Option<DMatrix<f64>>,
    /// What changed couplings do to the experts.
    #[serde(default)]
    pub reading: Reading,
}

/// A rolled-out motion.
#[derive(Clone, Debug)]
pub struct Rollout {
    /// The latent path of each part [frames x Q_i].
    pub latents: Vec<DMatrix<f64>>,
    /// All columns, means included [frames x D].
    pub y: DMatrix<f64>,
    /// The weights of the experts under its couplings [M x M], row the source; those into each part sum to 1.
    pub weights: DMatrix<f64>,
}

impl MotionModel {
    /// Puts a model together; fails when its pose maps cannot be solved for.
    pub fn new(fitted: FittedModel, body: Body, provenance: Provenance) -> Result<Self, NumericsError> {
        let poser = Poser::new(&fitted)?;
        Ok(Self { fitted, body, provenance, poser })
    }

    /// The best model of a training so far; `frames_per_second` is the rate that the data set was asked for.
    pub fn trained(
        dataset: &Dataset,
        trainer: &Trainer,
        frames_per_second: f64,
    ) -> Result<Self, NumericsError> {
        let progress = trainer.progress();
        let provenance = Provenance {
            engine: ENGINE.to_owned(),
            settings: trainer.settings().clone(),
            seed: trainer.seed(),
            frames_per_second,
            bound: progress.best,
            terms: progress.terms,
            iterations: progress.iteration,
            evaluations: progress.evaluations,
            note: None,
        };
        Self::new(trainer.model()?, Body::of(dataset), provenance)
    }

    /// The mean rollout from a training sequence's start latents.
    pub fn rollout(&self, request: &RolloutRequest) -> Result<Rollout, RolloutError> {
        let latent = self.fitted.parts.iter().map(|part| part.r.ncols()).sum();
        self.body.check_frames(request.frames, latent)?;
        let alpha = request.alpha.as_ref().unwrap_or(&self.fitted.alpha);
        let roller = Roller::new(&self.fitted, alpha, request.reading)?;
        let latents = roller.latents(self.fitted.start(request.sequence)?, request.frames)?;
        let y = self.columns_at(&latents);
        Ok(Rollout { latents, y, weights: coupling_weight_matrix(alpha) })
    }

    /// All columns at the latents of every part [frames x Q_i]; a part without rows stays at its mean pose.
    fn columns_at(&self, latents: &[DMatrix<f64>]) -> DMatrix<f64> {
        let parts = latents.iter().enumerate();
        self.body.columns(&parts.map(|(part, x)| self.poser.observations(part, x)).collect::<Vec<_>>())
    }

    /// The rollout as a clip, starting at the origin.
    pub fn clip(&self, rollout: &Rollout, name: &str) -> Result<Clip, PoseError> {
        self.body.clip(&rollout.y, name)
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, for a body 1.7 m tall.
    pub fn positions(&self, rollout: &Rollout) -> Result<Vec<f32>, PoseError> {
        self.body.positions(&rollout.y)
    }

    /// World positions of the figure's nodes [nodes x 3] with one part at a latent point and the others at their mean pose.
    pub fn pose(&self, part: usize, latent: &[f64]) -> Result<Vec<f32>, RolloutError> {
        let columns = self.fitted.parts.get(part).map_or(0, |p| p.r.ncols());
        if latent.len() != columns || columns == 0 {
            return Err(RolloutError::Start {
                part,
                rows: 1,
                columns,
                found_rows: 1,
                found_columns: latent.len(),
            });
        }
        let empty = |p: usize| DMatrix::zeros(0, self.fitted.parts[p].r.ncols());
        let mut latents: Vec<DMatrix<f64>> = (0..self.fitted.part_count()).map(empty).collect();
        latents[part] = DMatrix::from_row_slice(1, columns, latent);
        Ok(self.body.positions(&self.columns_at(&latents))?)
    }
}
