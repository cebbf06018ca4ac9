//! The synthetic experiment: who drives whom, where the truth is known.

use crate::json::rows::rows_of;
use crate::models::flat::ALPHA;
use crate::synthetic::experiment::{Experiment, Findings, Fit};
use crate::synthetic::{ALIKE, DRIVE, MUCH, NOISE_VARIANCE, Synthetic};
use crate::wasm::training::{TrainingProgress, progress};
use crate::wasm::{error, flat};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// The data, the truth about them, and what counts as finding it.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SyntheticTruth {
    pub frames: usize,
    /// The share of the first part in the second.
    pub drive: f64,
    /// The true latents of each part [frames x 2], row after row.
    pub latents: Vec<Vec<f64>>,
    /// What the model sees of each part, centred [frames x columns], row after row.
    pub observed: Vec<Vec<f64>>,
    /// Observed columns of a part.
    pub columns: usize,
    /// Variance of the observations' noise.
    pub noise: f64,
    /// From this ratio of coupling variances on a part counts for nothing.
    pub much: f64,
    /// Up to this ratio both parts have their say.
    pub alike: f64,
    /// No coupling variance can be larger.
    pub largest_alpha: f64,
}

/// How well a model explains the data.
#[derive(Serialize, Tsify)]
pub struct SyntheticFit {
    /// The bound, in nats.
    pub bound: f64,
    /// The mean squared error of a rollout of all frames, after dynamic time warping of each part.
    pub mse: f64,
}

/// What the coupling variances say about who drives whom, and whether it is true.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SyntheticVerdict {
    /// alpha from 2 to 1 over alpha from 1 to 1.
    pub back: f64,
    /// alpha from 1 to 2 over alpha from 2 to 2.
    pub forth: f64,
    /// Whether `back` says that the second part does not drive the first, which is true.
    pub back_is_right: bool,
    /// Whether `forth` says truly whether the first part drives the second.
    pub forth_is_right: bool,
}

/// What training has found so far, at its best bound.
#[derive(Serialize, Tsify)]
pub struct SyntheticFindings {
    /// Coupling variances `alpha[source][target]`.
    pub alpha: Vec<Vec<f64>>,
    /// The weights that they give `[source][target]`; those into each part sum to 1.
    pub weights: Vec<Vec<f64>>,
    pub verdict: SyntheticVerdict,
    /// The learned latents of each part [frames x 2], row after row, after the affine map that brings them nearest the truth.
    pub learned: Vec<Vec<f64>>,
    /// The share of the true latents' variance that these explain, for each part.
    pub explained: Vec<f64>,
    pub start: SyntheticFit,
    pub now: SyntheticFit,
}

fn fit(fit: Fit) -> SyntheticFit {
    SyntheticFit { bound: fit.bound, mse: fit.mse }
}

/// Two made-up systems, of which one drives the other or does not, and a training that is to find out.
#[wasm_bindgen]
pub struct SyntheticExperiment {
    experiment: Experiment,
}

#[wasm_bindgen]
impl SyntheticExperiment {
    /// Makes the data and finds where training starts; both follow from the seed, a whole number from 0 to 4294967295.
    /// `driving`: whether the first part drives the second.
    #[wasm_bindgen(constructor)]
    pub fn new(seed: u32, driving: bool) -> Result<SyntheticExperiment, JsError> {
        let data = Synthetic::draw(seed, if driving { DRIVE } else { 0.0 }).map_err(error)?;
        let experiment = Experiment::new(data, Synthetic::settings(seed)).map_err(error)?;
        Ok(SyntheticExperiment { experiment })
    }

    /// The data, and the truth about them.
    pub fn truth(&self) -> Result<Ts<SyntheticTruth>, JsError> {
        let data = self.experiment.data();
        let (frames, columns) = data.y.first().map_or((0, 0), |y| y.shape());
        let truth = SyntheticTruth {
            frames,
            drive: data.drive,
            latents: data.latents.iter().map(flat).collect(),
            observed: data.y.iter().map(flat).collect(),
            columns,
            noise: NOISE_VARIANCE,
            much: MUCH,
            alike: ALIKE,
            largest_alpha: ALPHA.highest(),
        };
        truth.into_ts().map_err(error)
    }

    /// One iteration of the optimiser: a few milliseconds.
    pub fn step(&mut self) -> Result<Ts<TrainingProgress>, JsError> {
        progress(self.experiment.step()).into_ts().map_err(error)
    }

    /// What training has found so far, at any time.
    pub fn findings(&self) -> Result<Ts<SyntheticFindings>, JsError> {
        let drive = self.experiment.data().drive;
        let Findings { alpha, weights, verdict, learned, fit: now } =
            self.experiment.findings().map_err(error)?;
        let findings = SyntheticFindings {
            alpha: rows_of(&alpha),
            weights: rows_of(&weights),
            verdict: SyntheticVerdict {
                back: verdict.back,
                forth: verdict.forth,
                back_is_right: verdict.back_is_right(),
                forth_is_right: verdict.forth_is_right(drive),
            },
            learned: learned.iter().map(|part| flat(&part.latents)).collect(),
            explained: learned.iter().map(|part| part.explained).collect(),
            start: fit(self.experiment.start()),
            now: fit(now),
        };
        findings.into_ts().map_err(error)
    }
}
