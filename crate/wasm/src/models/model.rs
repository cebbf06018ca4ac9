//! Trained models of every kind, of bodies and of tables.

use crate::data::body::BodyInfo;
#[cfg(feature = "training")]
use crate::models::predictions::Moments;
use crate::models::rollout::Rollout;
use crate::models::settings::{Task, settings_to_js};
use crate::models::trained::{Trained, column_names, coupled};
use crate::values::arguments::{Text, Whole};
use crate::values::convert::{flat, from_js, rows, to_js, to_js_joined, with_defaults};
use crate::values::error::{ErrorCode, VcgpdmError};
use serde::Serialize;
use std::sync::Arc;
#[cfg(feature = "training")]
use vcgpdm_core::document::Document;
use vcgpdm_core::models::variational::{BoundTerms, PoseMap, Vcgpdm};
use vcgpdm_core::models::{
    ColumnMapping, MOST_SAMPLES, Model as TrainedModel, ModelKind, Provenance, Rollout as Columns,
    RolloutError, RolloutRequest, SequenceInfo,
};
use vcgpdm_core::motion::parts::PartSpec;
use wasm_bindgen::prelude::*;

/// A part of a trained model.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct PartInfo<'a> {
    name: &'a str,
    joints: &'a [usize],
    /// Latent dimensions Q.
    latent: usize,
    /// Pose inducing points L.
    pose_ips: usize,
}

/// How a model of any kind was made.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct ModelProvenance<'a> {
    /// The program and its version.
    engine: &'a str,
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[cfg_attr(feature = "types", ts(type = "ModelSettings"))]
    settings: JsValue,
    /// The final bound in nats, or the objective of a model without a bound.
    bound: f64,
    /// What training maximised: the bound, or with `poseWeight` the sum of its terms with weighted poses.
    objective: f64,
    /// Null for a model without a bound.
    terms: Option<&'a BoundTerms>,
    iterations: usize,
    evaluations: usize,
    note: Option<&'a str>,
}

impl<'a> ModelProvenance<'a> {
    /// The provenance of a model or a library with these parts.
    pub(crate) fn new(
        made: &'a Provenance,
        parts: &[PartSpec],
        terms: Option<&'a BoundTerms>,
    ) -> Result<Self, VcgpdmError> {
        let task = Task { parts: parts.to_vec(), frames_per_second: made.frames_per_second, seed: made.seed };
        Ok(Self {
            engine: &made.engine,
            settings: settings_to_js(&task, &made.settings)?,
            bound: made.bound(),
            objective: made.objective,
            terms,
            iterations: made.iterations,
            evaluations: made.evaluations,
            note: made.note.as_deref(),
        })
    }
}

/// A model of any kind.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct ModelInfo<'a> {
    kind: ModelKind,
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[cfg_attr(feature = "types", ts(type = "ModelPart[]"))]
    parts: JsValue,
    /// The names of all columns, in the order of `Rollout.values`.
    columns: Vec<String>,
    /// Seconds from one frame to the next.
    frame_time: f64,
    sequences: &'a [SequenceInfo],
    /// Order p of the dynamics; this and the next three are null for a kind without couplings.
    order: Option<usize>,
    /// Coupling variances as learned, `alpha[source][target]`.
    alpha: Option<Vec<Vec<f64>>>,
    /// From how many frames of each sequence a rollout can start.
    start_frames: Option<Vec<usize>>,
    /// How many dynamics inducing points, `dynamicsIps[source][target]`.
    dynamics_ips: Option<Vec<Vec<usize>>>,
    /// The bound without the pose maps, in nats: the "dynamics ELBO" with which Knopp et al. (2019) predicted how
    /// natural people find the walks of models. Null for a kind without couplings.
    dynamics_elbo: Option<f64>,
    provenance: ModelProvenance<'a>,
}

impl<'a> ModelInfo<'a> {
    fn new<S: ColumnMapping>(trained: &'a TrainedModel<S>) -> Result<Self, VcgpdmError> {
        let (body, made) = (&trained.body, &trained.provenance);
        let specs = body.layout.parts();
        let model = trained.coupled().map(|coupled| coupled.model);
        let counts = |model: &Vcgpdm| {
            let rows = model.experts.iter();
            rows.map(|row| row.iter().map(|expert| expert.z().nrows()).collect()).collect()
        };
        Ok(ModelInfo {
            kind: trained.kind(),
            parts: match model {
                Some(model) => to_js(&part_infos(specs, &model.parts))?,
                None => to_js(specs)?,
            },
            columns: column_names(body),
            frame_time: body.frame_time,
            sequences: &body.sequences,
            order: model.map(|model| model.order),
            alpha: model.map(|model| rows(&model.alpha)),
            start_frames: model
                .map(|model| (0..body.sequences.len()).map(|k| model.start_frames(k)).collect()),
            dynamics_ips: model.map(counts),
            dynamics_elbo: model.map(|model| model.terms.dynamics_elbo()),
            provenance: ModelProvenance::new(made, specs, model.map(|model| &model.terms))?,
        })
    }
}

/// A model of tables has no body.
#[cfg(feature = "training")]
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct NoBody {
    /// Null for a model of tables.
    #[cfg_attr(feature = "types", ts(type = "JointInfo[] | null"))]
    joints: Option<()>,
    /// Null for a model of tables.
    #[cfg_attr(feature = "types", ts(type = "Figure | null"))]
    figure: Option<()>,
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

/// How many rollouts are sampled if the caller names no number.
const SAMPLES: u32 = 10;

/// The request of a rollout from JavaScript. Each option has a default.
fn request_from_js(options: &JsValue) -> Result<RolloutRequest, VcgpdmError> {
    let options = with_defaults(ErrorCode::Rollout, "rollout", options, js_sys::Object::new().into())?;
    from_js(ErrorCode::Rollout, "rollout", &options)
}

/// `count` sampled rollouts of the seeds `seed`, `seed + 1`, and so on, as columns.
fn sampled<'r, S: ColumnMapping>(
    model: &'r TrainedModel<S>,
    request: &'r RolloutRequest,
    count: u32,
    seed: u32,
) -> Result<impl Iterator<Item = Result<Columns, RolloutError>> + 'r, VcgpdmError> {
    let model = coupled(model)?;
    let together = request.frames.saturating_mul(count as usize);
    model.check_frames(together).map_err(|reason| {
        VcgpdmError::new(ErrorCode::Rollout, &format_args!("all rollouts together: {reason}"))
    })?;
    let seeds = u64::from(seed)..u64::from(seed) + u64::from(count);
    Ok(model.sampled_rollouts(request, seeds)?)
}

/// A trained model of any kind, of a body or of tables. The small package `vcgpdm/player` has vCGPDM and
/// vGPDM of bodies only.
#[wasm_bindgen]
pub struct Model {
    pub(crate) model: Trained,
}

impl From<TrainedModel> for Model {
    fn from(model: TrainedModel) -> Self {
        Model { model: Trained::Body(Arc::new(model)) }
    }
}

#[wasm_bindgen]
impl Model {
    /// Reads a model's document. Throws the reason and the path of the field when the text is not a model.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<Model, VcgpdmError> {
        let text = text.get(ErrorCode::Model, "the document")?;
        #[cfg(feature = "training")]
        let model = match Document::from_json(&text)? {
            Document::Body(model) => Trained::Body(Arc::new(*model)),
            Document::Series(model) => Trained::Table(Arc::new(*model)),
        };
        #[cfg(not(feature = "training"))]
        let model = Trained::Body(Arc::new(TrainedModel::coupled_from_json(&text)?));
        Ok(Model { model })
    }

    /// The model as a JSON document.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, VcgpdmError> {
        match &self.model {
            #[cfg(feature = "training")]
            Trained::Body(model) => Ok(model.to_json()?),
            #[cfg(not(feature = "training"))]
            Trained::Body(model) => Ok(coupled(model)?.to_json()?),
            #[cfg(feature = "training")]
            Trained::Table(model) => Ok(model.to_json()?),
        }
    }

    /// SHA-256 of that document, hexadecimal.
    pub fn sha256(&self) -> Result<String, VcgpdmError> {
        Ok(vcgpdm_core::motion::sha256(self.to_json()?.as_bytes()))
    }

    /// Its kind, parts, sequences, couplings and settings.
    #[wasm_bindgen(unchecked_return_type = "ModelInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        match &self.model {
            Trained::Body(model) => {
                to_js_joined(&ModelInfo::new(model)?, &BodyInfo::new(model.body.mapping.skeleton()))
            }
            #[cfg(feature = "training")]
            Trained::Table(model) => {
                to_js_joined(&ModelInfo::new(model)?, &NoBody { joints: None, figure: None })
            }
        }
    }

    /// The mean rollout from a training sequence's start. A vCGPDM or vGPDM can also start from another frame
    /// or from latents, and have other couplings than the learned ones.
    pub fn rollout(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "RolloutOptions")] options: JsValue,
    ) -> Result<Rollout, VcgpdmError> {
        let request = request_from_js(&options)?;
        Rollout::mean(&self.model, request)
    }

    /// Sampled rollouts, at most 1000 and by default 10, of the seeds `seed` (by default 0), `seed + 1`, and so
    /// on: every frame is drawn from what the experts predict. Together they have no more frames than one
    /// rollout may have.
    #[wasm_bindgen(js_name = sampledRollouts)]
    pub fn sampled_rollouts(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "RolloutOptions")] options: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] count: Option<Whole>,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] seed: Option<Whole>,
    ) -> Result<Vec<Rollout>, VcgpdmError> {
        let count =
            count.map_or(Ok(SAMPLES), |count| count.get(ErrorCode::Rollout, "the number of rollouts"))?;
        if !(1..=MOST_SAMPLES).contains(&count) {
            let words =
                format_args!("the number of rollouts: expected from 1 to {MOST_SAMPLES}, found {count}");
            return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
        }
        let seed = seed.map_or(Ok(0), |seed| seed.get(ErrorCode::Rollout, "the seed"))?;
        let request = request_from_js(&options)?;
        match &self.model {
            Trained::Body(body) => {
                let rollouts = sampled(body, &request, count, seed)?;
                rollouts.map(|rollout| Rollout::new(body, rollout?, &request)).collect()
            }
            #[cfg(feature = "training")]
            Trained::Table(table) => {
                let rollouts = sampled(table, &request, count, seed)?;
                rollouts.map(|rollout| Ok(Rollout::of_table(table, rollout?, request.clone()))).collect()
            }
        }
    }

    /// Gaussian moments of the latents in every frame of a rollout, by moment matching.
    #[cfg(feature = "training")]
    pub fn moments(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "RolloutOptions")] options: JsValue,
    ) -> Result<Moments, VcgpdmError> {
        let request = request_from_js(&options)?;
        Ok(Moments(coupled(self.model.body()?)?.moments(&request)?))
    }

    /// Pose inducing inputs r of a part [L x Q].
    #[wasm_bindgen(js_name = poseIps)]
    pub fn pose_ips(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let part = part.count(ErrorCode::Model, "the part")?;
        Ok(flat(self.model.latent()?.pose_map(part)?.r()))
    }

    /// Dynamics inducing inputs z of the source's prediction about the target [K x order * Q of the source],
    /// oldest state first.
    #[wasm_bindgen(js_name = dynamicsIps)]
    pub fn dynamics_ips(&self, source: &Whole, target: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let source = source.count(ErrorCode::Model, "the source")?;
        let target = target.count(ErrorCode::Model, "the target")?;
        Ok(flat(self.model.latent()?.expert(source, target)?.z()))
    }

    /// What the source's dynamics inducing points predict, `E[u]` [K x Q of the target].
    #[wasm_bindgen(js_name = dynamicsIvs)]
    pub fn dynamics_ivs(&self, source: &Whole, target: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let source = source.count(ErrorCode::Model, "the source")?;
        let target = target.count(ErrorCode::Model, "the target")?;
        Ok(flat(self.model.latent()?.expert(source, target)?.mean()))
    }

    /// The weight of a pose inducing point at each latent point [frames x Q], 0 to 1: k(x, r) / sigma^2.
    #[wasm_bindgen(js_name = poseIpWeights)]
    pub fn pose_ip_weights(
        &self,
        part: &Whole,
        index: &Whole,
        latents: &[f64],
    ) -> Result<Vec<f64>, VcgpdmError> {
        let part = part.count(ErrorCode::Model, "the part")?;
        let index = index.count(ErrorCode::Model, "the index")?;
        Ok(self.model.latent()?.pose_ip_weights(part, index, latents)?)
    }

    /// The weight of a dynamics inducing point in each frame of the source's latent path [frames x Q], 0
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
        Ok(self.model.latent()?.dynamics_ip_weights(source, target, index, latents)?)
    }

    /// World positions of the figure's nodes [nodes x 3] with one part at a latent point and the others at
    /// their mean pose.
    pub fn pose(&self, part: &Whole, latent: &[f64]) -> Result<Vec<f32>, VcgpdmError> {
        let part = part.count(ErrorCode::Model, "the part")?;
        Ok(coupled(self.model.body()?)?.pose(part, latent)?)
    }
}
