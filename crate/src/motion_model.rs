//! A trained model of a body: the fitted vCGPDM with what turns its columns into poses, and where it came from.

use crate::bvh::MAX_VALUES;
use crate::clip::Clip;
use crate::dataset::{Dataset, SequenceInfo};
use crate::linalg::NumericsError;
use crate::model::{BoundTerms, FittedModel, Reading};
use crate::parts::PartsLayout;
use crate::pose::{PoseError, PoseMapping, RootStart};
use crate::rollout::{MOST_FRAMES, Poser, Roller, RolloutError};
use crate::training::{Trainer, TrainingSettings};
use nalgebra::DMatrix;

/// How a model was made.
#[derive(Clone, Debug, PartialEq)]
pub struct Provenance {
    /// The program and its version.
    pub engine: String,
    /// What training was asked to do, the seed included.
    pub settings: TrainingSettings,
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
    /// From columns to joint rotations.
    pub mapping: PoseMapping,
    /// Which columns belong to which part.
    pub layout: PartsLayout,
    /// The mean of every column [D].
    pub column_means: Vec<f64>,
    /// Seconds from one frame to the next.
    pub frame_time: f64,
    /// The training sequences one can start from.
    pub sequences: Vec<SequenceInfo>,
    /// How the model was made.
    pub provenance: Provenance,
    poser: Poser,
}

/// What a rollout is asked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RolloutRequest {
    /// Frames in all, the start included.
    pub frames: usize,
    /// The training sequence whose start latents begin it, counted from 0.
    pub sequence: usize,
    /// Couplings [M x M], row the source; absent: as learned.
    pub alpha: Option<DMatrix<f64>>,
    /// What changed couplings do to the experts.
    pub reading: Reading,
}

/// A rolled-out motion.
#[derive(Clone, Debug)]
pub struct Rollout {
    /// The latent path of each part [frames x Q_i].
    pub latents: Vec<DMatrix<f64>>,
    /// All columns, means included [frames x D].
    pub y: DMatrix<f64>,
}

impl MotionModel {
    /// Puts a model together; fails when its pose maps cannot be solved for.
    pub fn new(
        fitted: FittedModel,
        mapping: PoseMapping,
        layout: PartsLayout,
        column_means: Vec<f64>,
        frame_time: f64,
        sequences: Vec<SequenceInfo>,
        provenance: Provenance,
    ) -> Result<Self, NumericsError> {
        let poser = Poser::new(&fitted)?;
        Ok(Self { fitted, mapping, layout, column_means, frame_time, sequences, provenance, poser })
    }

    /// The best model of a training so far; `frames_per_second` is the rate that the data set was asked for.
    pub fn trained(
        dataset: &Dataset,
        trainer: &Trainer,
        frames_per_second: f64,
    ) -> Result<Self, NumericsError> {
        let progress = trainer.progress();
        let provenance = Provenance {
            engine: concat!("vcgpdm ", env!("CARGO_PKG_VERSION")).to_owned(),
            settings: trainer.settings().clone(),
            frames_per_second,
            bound: progress.best,
            terms: progress.terms,
            iterations: progress.iteration,
            evaluations: progress.evaluations,
            note: None,
        };
        Self::new(
            trainer.model()?,
            dataset.mapping.clone(),
            dataset.layout.clone(),
            dataset.column_means.clone(),
            dataset.frame_time,
            dataset.sequences.clone(),
            provenance,
        )
    }

    /// The mean rollout from a training sequence's start latents.
    pub fn rollout(&self, request: &RolloutRequest) -> Result<Rollout, RolloutError> {
        // What a BVH file may hold, so that the rollout can be read again and fits the memory.
        let latent: usize = self.fitted.parts.iter().map(|part| part.r.ncols()).sum();
        let widest = latent.max(self.column_means.len()).max(self.mapping.skeleton().channel_count());
        let most = MOST_FRAMES.min(MAX_VALUES / widest);
        if !(1..=most).contains(&request.frames) {
            return Err(RolloutError::Frames { most, found: request.frames });
        }
        let alpha = request.alpha.as_ref().unwrap_or(&self.fitted.alpha);
        let roller = Roller::new(&self.fitted, alpha, request.reading)?;
        let latents = roller.latents(self.fitted.start(request.sequence)?, request.frames)?;
        let y = self.columns_at(&latents);
        Ok(Rollout { latents, y })
    }

    /// All columns at the latents of every part [frames x Q_i]; a part without rows stays at its mean pose.
    fn columns_at(&self, latents: &[DMatrix<f64>]) -> DMatrix<f64> {
        let frames = latents.iter().map(|x| x.nrows()).max().unwrap_or(0);
        let mut y = DMatrix::from_fn(frames, self.column_means.len(), |_, d| self.column_means[d]);
        for (part, x) in latents.iter().enumerate().filter(|(_, x)| x.nrows() > 0) {
            let observed = self.poser.observations(part, x);
            for (c, column) in self.layout.columns(part).iter().enumerate() {
                let mut out = y.column_mut(*column);
                out += observed.column(c);
            }
        }
        y
    }

    /// The rollout as a clip, starting at the origin.
    pub fn clip(&self, rollout: &Rollout, name: &str) -> Result<Clip, PoseError> {
        let mut clip = self.mapping.decode(&rollout.y, &RootStart::default(), self.frame_time)?;
        clip.name = name.to_owned();
        Ok(clip)
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, for a body 1.7 m tall.
    pub fn positions(&self, rollout: &Rollout) -> Result<Vec<f32>, PoseError> {
        self.mapping.decode_positions(&rollout.y, &RootStart::default())
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
        Ok(self.mapping.decode_positions(&self.columns_at(&latents), &RootStart::default())?)
    }
}
