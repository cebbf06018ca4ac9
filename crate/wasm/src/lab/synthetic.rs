//! The synthetic experiment: which part drives which, on data with a known answer.

use crate::models::model::Model;
use crate::models::trained::Trained;
use crate::values::arguments::Whole;
use crate::values::convert::{flat, rows, to_js};
use crate::values::error::{ErrorCode, VcgpdmError};
use nalgebra::DMatrix;
use serde::Serialize;
use std::sync::Arc;
use vcgpdm_core::models::variational::LARGEST_COUPLING;
use vcgpdm_lab::synthetic::{
    ALIKE, DRIVE, Experiment, Findings, Fit, MUCH, NOISE_VARIANCE, Snapshot, Synthetic,
};
use wasm_bindgen::prelude::*;

/// A model at one moment of its training, as in figure 3 (E to H) of Velychko et al. (2018). Points are in the
/// coordinates of the true latents, where an affine map puts the learned latents nearest to them. Matrices are
/// row after row.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct SyntheticSnapshot {
    /// The learned latents of each part [frames x 2].
    learned: Vec<Vec<f64>>,
    /// For each part, the share of the variance of the true latents that the learned latents explain.
    explained: Vec<f64>,
    /// Pose inducing points of each part [L x 2].
    pose_ips: Vec<Vec<f64>>,
    /// Dynamics inducing points of each part's prediction about itself [K x order * 2], oldest state first.
    dynamics_ips: Vec<Vec<f64>>,
    /// The mean path of each part from the learned first states [frames x 2].
    path: Vec<Vec<f64>>,
    /// The observations of each part on that path [frames x columns].
    generated: Vec<Vec<f64>>,
}

impl From<&Snapshot> for SyntheticSnapshot {
    fn from(snapshot: &Snapshot) -> Self {
        let flattened = |parts: &[DMatrix<f64>]| parts.iter().map(flat).collect();
        SyntheticSnapshot {
            learned: snapshot.learned.iter().map(|part| flat(&part.latents)).collect(),
            explained: snapshot.learned.iter().map(|part| part.explained).collect(),
            pose_ips: flattened(&snapshot.pose_ips),
            dynamics_ips: flattened(&snapshot.dynamics_ips),
            path: flattened(&snapshot.path),
            generated: flattened(&snapshot.generated),
        }
    }
}

/// The data, the true latents and couplings, and the limits by which couplings are judged.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct SyntheticTruth {
    frames: usize,
    /// The share of the first part in the dynamics of the second part.
    drive: f64,
    /// The true latents of each part [frames x 2], row after row.
    latents: Vec<Vec<f64>>,
    /// The starting point of the training.
    start: SyntheticSnapshot,
    /// The centred observations of each part [frames x columns], row after row.
    observed: Vec<Vec<f64>>,
    /// Number of observed columns of a part.
    columns: usize,
    /// Variance of the observations' noise.
    noise: f64,
    /// If the ratio of coupling variances is at least this, the other part counts as without influence.
    much: f64,
    /// If the ratio of coupling variances is at most this, both parts count as having influence.
    alike: f64,
    /// The largest possible coupling variance.
    largest_alpha: f64,
}

/// Ratios of coupling variances, which show which part drives which, and whether they show the truth.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
struct SyntheticVerdict {
    /// alpha from 2 to 1, divided by alpha from 1 to 1.
    back: f64,
    /// alpha from 1 to 2, divided by alpha from 2 to 2.
    forth: f64,
    /// Whether `back` shows the truth: the second part does not drive the first.
    back_is_right: bool,
    /// Whether `forth` shows the truth about whether the first part drives the second.
    forth_is_right: bool,
}

/// The findings of the training at its best bound so far.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct SyntheticFindings {
    /// Coupling variances `alpha[source][target]`.
    alpha: Vec<Vec<f64>>,
    /// The weights `[source][target]` that follow from the coupling variances. The weights into each part sum
    /// to 1.
    weights: Vec<Vec<f64>>,
    verdict: SyntheticVerdict,
    model: SyntheticSnapshot,
    start: Fit,
    now: Fit,
}

/// Two simulated systems, and a training on their data. The training is a test: can it find whether the first
/// system drives the second?
#[wasm_bindgen]
pub struct SyntheticExperiment {
    experiment: Experiment,
}

#[wasm_bindgen]
impl SyntheticExperiment {
    /// Makes the data and finds the starting point of the training. The seed, a whole number from 0 to
    /// 4294967295, determines both. `driving`: whether the first part drives the second. `points`: how many
    /// inducing points each function has; absent: 10, as in one half of the paper's figure 3; the other has 4.
    #[wasm_bindgen(constructor)]
    pub fn new(
        seed: &Whole,
        driving: bool,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] points: Option<Whole>,
    ) -> Result<SyntheticExperiment, VcgpdmError> {
        let seed = seed.get(ErrorCode::Settings, "the seed")?;
        let mut settings = Synthetic::settings();
        if let Some(points) = points {
            let points = points.count(ErrorCode::Settings, "the number of inducing points")?;
            settings = settings.with_points(points, points);
        }
        let data = Synthetic::draw(seed, if driving { DRIVE } else { 0.0 })?;
        Ok(SyntheticExperiment { experiment: Experiment::new(data, &settings, seed)? })
    }

    /// The data and the true latents and couplings.
    #[wasm_bindgen(unchecked_return_type = "SyntheticTruth")]
    pub fn truth(&self) -> Result<JsValue, VcgpdmError> {
        let data = self.experiment.data();
        let (frames, columns) = data.y.first().map_or((0, 0), |y| y.shape());
        to_js(&SyntheticTruth {
            frames,
            drive: data.drive,
            latents: data.latents.iter().map(flat).collect(),
            start: self.experiment.start().into(),
            observed: data.y.iter().map(flat).collect(),
            columns,
            noise: NOISE_VARIANCE,
            much: MUCH,
            alike: ALIKE,
            largest_alpha: LARGEST_COUPLING,
        })
    }

    /// One iteration of the optimiser. It takes a few milliseconds.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        to_js(&self.experiment.step())
    }

    /// The findings so far. They can be read at any time.
    #[wasm_bindgen(unchecked_return_type = "SyntheticFindings")]
    pub fn findings(&self) -> Result<JsValue, VcgpdmError> {
        let drive = self.experiment.data().drive;
        let Findings { alpha, weights, verdict, now } = self.experiment.findings()?;
        to_js(&SyntheticFindings {
            alpha: rows(&alpha),
            weights: rows(&weights),
            verdict: SyntheticVerdict {
                back: verdict.back,
                forth: verdict.forth,
                back_is_right: verdict.back_is_right(),
                forth_is_right: verdict.forth_is_right(drive),
            },
            model: (&now).into(),
            start: self.experiment.start().fit,
            now: now.fit,
        })
    }

    /// The best model so far: a model of a table with a column for each observed curve.
    pub fn model(&self) -> Result<Model, VcgpdmError> {
        Ok(Model { model: Trained::Table(Arc::new(self.experiment.model()?)) })
    }
}
