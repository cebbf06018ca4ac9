//! Trained models: what they hold, and what they predict.

use crate::json::rows::{matrix_from_rows, rows_of};
use crate::models::motion_model::{MotionModel, RolloutRequest};
use crate::models::rollout::check_couplings;
use crate::models::variational::elbo::dynamics::coupling_weights;
use crate::models::variational::posterior::Reading;
use crate::wasm::rollout::{Rollout, RolloutOptions};
use crate::wasm::training::TrainingSettings;
use crate::wasm::{Figure, JointInfo, Terms, error, figure, flat, joints, part_spec, terms};
use nalgebra::DMatrix;
use serde::Serialize;
use std::rc::Rc;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// A part of a trained model.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct PartInfo {
    pub name: String,
    pub joints: Vec<usize>,
    /// Latent dimensions Q.
    pub latent: usize,
    /// Pose inducing points L.
    pub pose_ips: usize,
}

/// A training sequence that a rollout can start from.
#[derive(Serialize, Tsify)]
pub struct SequenceInfo {
    pub name: String,
    pub sha256: String,
    pub frames: usize,
}

/// How a model was made.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Provenance {
    /// The program and its version.
    pub engine: String,
    pub settings: TrainingSettings,
    /// The final bound, in nats.
    pub bound: f64,
    pub terms: Terms,
    pub iterations: usize,
    pub evaluations: usize,
    pub note: Option<String>,
}

/// What there is to know of a model.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
#[serde(rename_all = "camelCase")]
pub struct ModelInfo {
    pub parts: Vec<PartInfo>,
    /// Order p of the dynamics.
    pub order: usize,
    /// Seconds from one frame to the next.
    pub frame_time: f64,
    /// Coupling variances as learned, `alpha[source][target]`.
    pub alpha: Vec<Vec<f64>>,
    /// Dynamics inducing points, `dynamicsIps[source][target]`.
    pub dynamics_ips: Vec<Vec<usize>>,
    pub sequences: Vec<SequenceInfo>,
    pub joints: Vec<JointInfo>,
    pub figure: Figure,
    pub provenance: Provenance,
}

/// A trained model.
#[wasm_bindgen]
pub struct Model {
    pub(super) model: Rc<MotionModel>,
}

impl Model {
    fn part(&self, part: usize) -> Result<&crate::models::variational::posterior::PoseMap, JsError> {
        self.model.fitted.parts.get(part).ok_or_else(|| error(format!("there is no part {part}")))
    }

    fn expert(
        &self,
        source: usize,
        target: usize,
    ) -> Result<&crate::models::variational::posterior::FittedExpert, JsError> {
        let row = self.model.fitted.experts.get(source).and_then(|row| row.get(target));
        row.ok_or_else(|| error(format!("there is no prediction of part {source} about part {target}")))
    }

    fn alpha(&self, alpha: &[Vec<f64>]) -> Result<DMatrix<f64>, JsError> {
        matrix_from_rows(alpha).map_err(|e| error(format!("alpha: {e}")))
    }
}

#[wasm_bindgen]
impl Model {
    /// Reads a shared model. Throws the reason and the path of the field when the text is not one.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &str) -> Result<Model, JsError> {
        Ok(Model { model: Rc::new(MotionModel::from_json(text).map_err(error)?) })
    }

    /// The model as a JSON document.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, JsError> {
        self.model.to_json().map_err(error)
    }

    /// What there is to know of it.
    pub fn info(&self) -> Result<Ts<ModelInfo>, JsError> {
        let model = &self.model;
        let fitted = &model.fitted;
        let parts: Vec<PartInfo> = model
            .body
            .layout
            .parts()
            .iter()
            .zip(&fitted.parts)
            .map(|(spec, map)| PartInfo {
                name: spec.name.clone(),
                joints: spec.joints.clone(),
                latent: map.r.ncols(),
                pose_ips: map.r.nrows(),
            })
            .collect();
        let p = &model.provenance;
        let provenance = Provenance {
            engine: p.engine.clone(),
            settings: TrainingSettings {
                parts: model.body.layout.parts().iter().map(part_spec).collect(),
                latent: p.settings.latent,
                dynamics_ips: p.settings.dynamics_ips,
                pose_ips: p.settings.pose_ips,
                order: p.settings.order,
                frames_per_second: p.frames_per_second,
                seed: p.settings.seed,
                max_iterations: p.settings.max_iterations,
            },
            bound: p.bound,
            terms: terms(&p.terms),
            iterations: p.iterations,
            evaluations: p.evaluations,
            note: p.note.clone(),
        };
        let sequences = model.body.sequences.iter();
        let info = ModelInfo {
            parts,
            order: fitted.order,
            frame_time: model.body.frame_time,
            alpha: rows_of(&fitted.alpha),
            dynamics_ips: fitted
                .experts
                .iter()
                .map(|row| row.iter().map(|e| e.z.nrows()).collect())
                .collect(),
            sequences: sequences
                .map(|s| SequenceInfo { name: s.name.clone(), sha256: s.sha256.clone(), frames: s.frames })
                .collect(),
            joints: joints(model.body.mapping.skeleton()),
            figure: figure(model.body.mapping.skeleton()),
            provenance,
        };
        info.into_ts().map_err(error)
    }

    /// The weights `w[source][target]` that coupling variances give; the weights into each part sum to 1.
    #[wasm_bindgen(unchecked_return_type = "number[][]")]
    pub fn weights(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[][]")] alpha: JsValue,
    ) -> Result<JsValue, JsError> {
        let alpha: Vec<Vec<f64>> = serde_wasm_bindgen::from_value(alpha).map_err(error)?;
        let mut weights = self.alpha(&alpha)?;
        check_couplings(&weights, self.model.fitted.part_count()).map_err(error)?;
        for mut column in weights.column_iter_mut() {
            let w = coupling_weights(column.as_slice()).1;
            column.copy_from_slice(&w);
        }
        serde_wasm_bindgen::to_value(&rows_of(&weights)).map_err(error)
    }

    /// The mean rollout from a training sequence's start latents, under the learned couplings or others.
    pub fn rollout(&self, options: Ts<RolloutOptions>) -> Result<Rollout, JsError> {
        let options = crate::wasm::read("rollout", &options)?;
        let reading = match options.reading.as_deref() {
            None | Some("as learned") => Reading::AsLearned,
            Some("re-inferred") => Reading::ReInferred,
            Some(other) => {
                return Err(error(format!(
                    "expected the reading \"as learned\" or \"re-inferred\", found \"{other}\""
                )));
            }
        };
        let alpha = options.alpha.as_deref().map(|alpha| self.alpha(alpha)).transpose()?;
        let request = RolloutRequest { frames: options.frames, sequence: options.sequence, alpha, reading };
        let rollout = self.model.rollout(&request).map_err(error)?;
        let positions = self.model.positions(&rollout).map_err(error)?;
        Ok(Rollout { rollout, positions, model: Rc::clone(&self.model) })
    }

    /// Pose inducing inputs r of a part [L x Q].
    #[wasm_bindgen(js_name = poseIps)]
    pub fn pose_ips(&self, part: usize) -> Result<Vec<f64>, JsError> {
        Ok(flat(&self.part(part)?.r))
    }

    /// Dynamics inducing inputs z of the source's prediction about the target [K x order * Q of the source], oldest state first.
    #[wasm_bindgen(js_name = dynamicsIps)]
    pub fn dynamics_ips(&self, source: usize, target: usize) -> Result<Vec<f64>, JsError> {
        Ok(flat(&self.expert(source, target)?.z))
    }

    /// What the source's dynamics inducing points predict, E[u] [K x Q of the target].
    #[wasm_bindgen(js_name = dynamicsIvs)]
    pub fn dynamics_ivs(&self, source: usize, target: usize) -> Result<Vec<f64>, JsError> {
        Ok(flat(&self.expert(source, target)?.mean))
    }

    /// How much a pose inducing point says about each latent point [frames x Q], 0 to 1: k(x, r) / sigma^2.
    #[wasm_bindgen(js_name = poseIpWeights)]
    pub fn pose_ip_weights(&self, part: usize, index: usize, latents: &[f64]) -> Result<Vec<f64>, JsError> {
        let part = self.part(part)?;
        kernel_weights(&part.kernel, &part.r, index, latents, 1)
    }

    /// How much a dynamics inducing point says about each frame of the source's latent path [frames x Q], 0 to 1:
    /// k(history, z); 0 for the first frames, which have no history.
    #[wasm_bindgen(js_name = dynamicsIpWeights)]
    pub fn dynamics_ip_weights(
        &self,
        source: usize,
        target: usize,
        index: usize,
        latents: &[f64],
    ) -> Result<Vec<f64>, JsError> {
        let expert = self.expert(source, target)?;
        kernel_weights(&expert.kernel, &expert.z, index, latents, self.model.fitted.order)
    }

    /// World positions of the figure's nodes [nodes x 3] with one part at a latent point and the others at their mean pose.
    pub fn pose(&self, part: usize, latent: &[f64]) -> Result<Vec<f32>, JsError> {
        self.model.pose(part, latent).map_err(error)
    }
}

/// k(window, z_index) / sigma^2 for windows of `width` rows: of one row at its own frame, of more rows at the frame after them.
fn kernel_weights(
    kernel: &crate::gp::kernel::Kernel,
    z: &DMatrix<f64>,
    index: usize,
    latents: &[f64],
    width: usize,
) -> Result<Vec<f64>, JsError> {
    if index >= z.nrows() {
        return Err(error(format!("expected an inducing point from 0 to {}, found {index}", z.nrows() - 1)));
    }
    let q = z.ncols() / width;
    if !latents.len().is_multiple_of(q) {
        return Err(error(format!("expected rows of {q} latents, found {} numbers", latents.len())));
    }
    let frames = latents.len() / q;
    let lag = if width == 1 { 0 } else { width };
    let mut out = vec![0.0; frames];
    let z = z.rows(index, 1).into_owned();
    for t in lag..frames {
        let window = DMatrix::from_row_slice(1, z.ncols(), &latents[(t - lag) * q..(t - lag + width) * q]);
        out[t] = kernel.cross_covariance(&window, &z)[(0, 0)] / kernel.variance;
    }
    Ok(out)
}
