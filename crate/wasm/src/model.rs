//! Trained models: what they hold, and what they predict.

use crate::body::BodyInfo;
use crate::convert::{flat, from_js, rows, to_js_beside};
use crate::coupled::coupled;
use crate::error::{ErrorCode, VcgpdmError};
use crate::given::{Text, Whole};
#[cfg(feature = "training")]
use crate::predictions::Moments;
use crate::rollout::Rollout;
use crate::settings::{Task, settings_to_js};
use serde::Serialize;
use std::rc::Rc;
#[cfg(feature = "training")]
use vcgpdm::document::DocumentError;
use vcgpdm::models::variational::{BoundTerms, PoseMap};
use vcgpdm::models::{Coupled, MOST_SAMPLES, Model as TrainedModel, RolloutRequest, SequenceInfo};
use vcgpdm::motion::parts::PartSpec;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A part of a trained model. */
export interface PartInfo {
    name: string;
    joints: number[];
    /** Latent dimensions Q. */
    latent: number;
    /** Pose inducing points L. */
    poseIps: number;
}

/** A training sequence that a rollout can start from. */
export interface SequenceInfo {
    name: string;
    sha256: string;
    frames: number;
    /**
     * Seconds from its first frame to where its body comes to rest; null: it moves to its end, or is not
     * known.
     */
    restsFrom: number | null;
    /**
     * The frames of the file that were used, the first and the one after the last; null: all, or not known.
     */
    piece: [number, number] | null;
    /** The name of the clip whose bones it was given; null: it kept its own, or not known. */
    bonesOf: string | null;
    /** Whether all of the clip's frames are there; else only its first ones are. */
    whole: boolean;
}

/** How a model was made. */
export interface Provenance {
    /** The program and its version. */
    engine: string;
    settings: TrainingSettings;
    /** The final bound, in nats. */
    bound: number;
    terms: BoundTerms;
    iterations: number;
    evaluations: number;
    note: string | null;
}

/** What there is to know of a model. */
export interface ModelInfo {
    parts: PartInfo[];
    /** Order p of the dynamics. */
    order: number;
    /** Seconds from one frame to the next. */
    frameTime: number;
    /** Coupling variances as learned, `alpha[source][target]`. */
    alpha: number[][];
    /** From how many frames of each sequence a rollout can start. */
    startFrames: number[];
    /** How many dynamics inducing points, `dynamicsIps[source][target]`. */
    dynamicsIps: number[][];
    sequences: SequenceInfo[];
    joints: JointInfo[];
    figure: Figure;
    provenance: Provenance;
}
"#;

#[derive(Serialize)]
pub(crate) struct PartInfo<'a> {
    name: &'a str,
    joints: &'a [usize],
    latent: usize,
    pose_ips: usize,
}

#[derive(Serialize)]
pub(crate) struct Provenance<'a> {
    engine: &'a str,
    #[serde(with = "serde_wasm_bindgen::preserve")]
    settings: JsValue,
    bound: f64,
    terms: &'a BoundTerms,
    iterations: usize,
    evaluations: usize,
    note: Option<&'a str>,
}

#[derive(Serialize)]
struct ModelInfo<'a> {
    parts: Vec<PartInfo<'a>>,
    order: usize,
    frame_time: f64,
    alpha: Vec<Vec<f64>>,
    start_frames: Vec<usize>,
    dynamics_ips: Vec<Vec<usize>>,
    sequences: &'a [SequenceInfo],
    provenance: Provenance<'a>,
}

impl<'a> ModelInfo<'a> {
    fn new(coupled: Coupled<'a>, settings: JsValue) -> Self {
        let Coupled { model: fitted, body, provenance: made, .. } = coupled;
        let counts = fitted.experts.iter().map(|row| row.iter().map(|expert| expert.z().nrows()).collect());
        ModelInfo {
            parts: part_infos(body.layout.parts(), &fitted.parts),
            order: fitted.order,
            frame_time: body.frame_time,
            alpha: rows(&fitted.alpha),
            start_frames: (0..body.sequences.len()).map(|k| fitted.start_frames(k)).collect(),
            dynamics_ips: counts.collect(),
            sequences: &body.sequences,
            provenance: provenance_info(made, &fitted.terms, settings),
        }
    }
}

/// The parts with their pose maps.
pub(crate) fn part_infos<'a>(specs: &'a [PartSpec], maps: &[PoseMap]) -> Vec<PartInfo<'a>> {
    let info = |(spec, map): (&'a PartSpec, &PoseMap)| PartInfo {
        name: &spec.name,
        joints: &spec.joints,
        latent: map.r().ncols(),
        pose_ips: map.r().nrows(),
    };
    specs.iter().zip(maps).map(info).collect()
}

/// How a model or a library was made.
pub(crate) fn provenance_info<'a>(
    made: &'a vcgpdm::models::Provenance,
    terms: &'a BoundTerms,
    settings: JsValue,
) -> Provenance<'a> {
    Provenance {
        engine: &made.engine,
        settings,
        bound: made.objective,
        terms,
        iterations: made.iterations,
        evaluations: made.evaluations,
        note: made.note.as_deref(),
    }
}

/// A trained model.
#[wasm_bindgen]
pub struct Model {
    pub(crate) model: Rc<TrainedModel>,
}

#[wasm_bindgen]
impl Model {
    /// Reads a shared model. Throws the reason and the path of the field when the text is not one.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<Model, VcgpdmError> {
        let text = text.get(ErrorCode::Model, "the document")?;
        let model = TrainedModel::coupled_from_json(&text);
        // Only the whole package reads the other kinds.
        #[cfg(feature = "training")]
        if let Err(reason @ (DocumentError::Kind { .. } | DocumentError::Subject { .. })) = &model {
            let words = format_args!("{reason}; AnyModel.fromJson reads models of every kind");
            return Err(VcgpdmError::new(ErrorCode::Model, &words));
        }
        Ok(Model { model: Rc::new(model?) })
    }

    /// The model as a JSON document.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, VcgpdmError> {
        Ok(coupled(&self.model)?.to_json()?)
    }

    /// SHA-256 of that document, hexadecimal.
    pub fn sha256(&self) -> Result<String, VcgpdmError> {
        Ok(coupled(&self.model)?.sha256()?)
    }

    /// What there is to know of it.
    #[wasm_bindgen(unchecked_return_type = "ModelInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        let (body, made) = (&self.model.body, &self.model.provenance);
        let parts = body.layout.parts().to_vec();
        let task = Task { parts, frames_per_second: made.frames_per_second, seed: made.seed };
        let settings = settings_to_js(&task, &made.settings)?;
        let info = ModelInfo::new(coupled(&self.model)?, settings);
        to_js_beside(&info, &BodyInfo::new(body.mapping.skeleton()))
    }

    /// The mean rollout from a training sequence's start latents, under the learned couplings or others.
    pub fn rollout(
        &self,
        #[wasm_bindgen(unchecked_param_type = "RolloutOptions")] options: JsValue,
    ) -> Result<Rollout, VcgpdmError> {
        let request = from_js(ErrorCode::Rollout, "rollout", &options)?;
        Rollout::new(&self.model, coupled(&self.model)?.rollout(&request)?, &request)
    }

    /// Sampled rollouts, at most 1000, of the seeds `seed`, `seed + 1`, and so on: every frame is drawn from
    /// what the experts predict. Together they have no more frames than one rollout may have.
    #[wasm_bindgen(js_name = sampledRollouts)]
    pub fn sampled_rollouts(
        &self,
        #[wasm_bindgen(unchecked_param_type = "RolloutOptions")] options: JsValue,
        count: &Whole,
        seed: &Whole,
    ) -> Result<Vec<Rollout>, VcgpdmError> {
        let count = count.get(ErrorCode::Rollout, "the number of rollouts")?;
        if !(1..=MOST_SAMPLES).contains(&count) {
            let words =
                format_args!("the number of rollouts: expected from 1 to {MOST_SAMPLES}, found {count}");
            return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
        }
        let seed = seed.get(ErrorCode::Rollout, "the seed")?;
        let request: RolloutRequest = from_js(ErrorCode::Rollout, "rollout", &options)?;
        let together = request.frames.saturating_mul(count as usize);
        let model = coupled(&self.model)?;
        model.check_frames(together).map_err(|reason| {
            VcgpdmError::new(ErrorCode::Rollout, &format_args!("all rollouts together: {reason}"))
        })?;
        let seeds = u64::from(seed)..u64::from(seed) + u64::from(count);
        let rollouts = model.sampled_rollouts(&request, seeds)?;
        rollouts.map(|rollout| Rollout::new(&self.model, rollout?, &request)).collect()
    }

    /// What is known of the latents in every frame of a rollout, by moment matching.
    #[cfg(feature = "training")]
    pub fn moments(
        &self,
        #[wasm_bindgen(unchecked_param_type = "RolloutOptions")] options: JsValue,
    ) -> Result<Moments, VcgpdmError> {
        let request = from_js(ErrorCode::Rollout, "rollout", &options)?;
        Ok(Moments(coupled(&self.model)?.moments(&request)?))
    }

    /// Pose inducing inputs r of a part [L x Q].
    #[wasm_bindgen(js_name = poseIps)]
    pub fn pose_ips(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let part = part.count(ErrorCode::Model, "the part")?;
        Ok(flat(coupled(&self.model)?.model.pose_map(part)?.r()))
    }

    /// Dynamics inducing inputs z of the source's prediction about the target [K x order * Q of the source],
    /// oldest state first.
    #[wasm_bindgen(js_name = dynamicsIps)]
    pub fn dynamics_ips(&self, source: &Whole, target: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let source = source.count(ErrorCode::Model, "the source")?;
        let target = target.count(ErrorCode::Model, "the target")?;
        Ok(flat(coupled(&self.model)?.model.expert(source, target)?.z()))
    }

    /// What the source's dynamics inducing points predict, `E[u]` [K x Q of the target].
    #[wasm_bindgen(js_name = dynamicsIvs)]
    pub fn dynamics_ivs(&self, source: &Whole, target: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let source = source.count(ErrorCode::Model, "the source")?;
        let target = target.count(ErrorCode::Model, "the target")?;
        Ok(flat(coupled(&self.model)?.model.expert(source, target)?.mean()))
    }

    /// How much a pose inducing point says about each latent point [frames x Q], 0 to 1: k(x, r) / sigma^2.
    #[wasm_bindgen(js_name = poseIpWeights)]
    pub fn pose_ip_weights(
        &self,
        part: &Whole,
        index: &Whole,
        latents: &[f64],
    ) -> Result<Vec<f64>, VcgpdmError> {
        let part = part.count(ErrorCode::Model, "the part")?;
        let index = index.count(ErrorCode::Model, "the index")?;
        Ok(coupled(&self.model)?.model.pose_ip_weights(part, index, latents)?)
    }

    /// How much a dynamics inducing point says about each frame of the source's latent path [frames x Q], 0
    /// to 1: k(history, z); 0 for the first frames, which have no history.
    #[wasm_bindgen(js_name = dynamicsIpWeights)]
    pub fn dynamics_ip_weights(
        &self,
        source: &Whole,
        target: &Whole,
        index: &Whole,
        latents: &[f64],
    ) -> Result<Vec<f64>, VcgpdmError> {
        let source = source.count(ErrorCode::Model, "the source")?;
        let target = target.count(ErrorCode::Model, "the target")?;
        let index = index.count(ErrorCode::Model, "the index")?;
        Ok(coupled(&self.model)?.model.dynamics_ip_weights(source, target, index, latents)?)
    }

    /// World positions of the figure's nodes [nodes x 3] with one part at a latent point and the others at
    /// their mean pose.
    pub fn pose(&self, part: &Whole, latent: &[f64]) -> Result<Vec<f32>, VcgpdmError> {
        let part = part.count(ErrorCode::Model, "the part")?;
        Ok(coupled(&self.model)?.pose(part, latent)?)
    }
}
