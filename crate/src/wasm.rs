//! The face of the wasm package: converts and forwards. The only file with `#[wasm_bindgen]`.

use crate::dataset::{Dataset, Source};
use crate::model::{BoundTerms, Reading, coupling_weights};
use crate::motion_model::{MotionModel, Rollout as MotionRollout, RolloutRequest};
use crate::parts::{self, PartSpec as Part};
use crate::rollout::check_couplings;
use crate::rows::{matrix_from_rows, rows_of};
use crate::training::{Trainer as Training, TrainingSettings as Settings};
use crate::{Clip as MotionClip, Skeleton, bvh, samples};
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use std::rc::Rc;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// Which joints move together: a part is a named group of joints, by their place in the skeleton.
#[derive(Clone, Serialize, Deserialize, Tsify)]
pub struct PartSpec {
    pub name: String,
    pub joints: Vec<usize>,
}

/// A split of the body found from the names of its joints.
#[derive(Serialize, Tsify)]
pub struct PartsPreset {
    pub id: String,
    pub title: String,
    pub parts: Vec<PartSpec>,
}

#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct JointInfo {
    pub name: String,
    pub parent: Option<usize>,
    pub channels: Vec<String>,
}

/// What a picture of the body draws: a node for every joint and end site; a bone runs from each node to its parent node.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
#[serde(rename_all = "camelCase")]
pub struct FigureNode {
    pub joint: usize,
    pub parent: Option<usize>,
    pub end_site: bool,
}

#[derive(Serialize, Tsify)]
pub struct Figure {
    pub nodes: Vec<FigureNode>,
}

/// What there is to know of a clip.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
#[serde(rename_all = "camelCase")]
pub struct ClipInfo {
    pub name: String,
    /// SHA-256 of the file, hexadecimal.
    pub sha256: String,
    pub joints: Vec<JointInfo>,
    pub figure: Figure,
    pub frames: usize,
    /// Seconds from one frame to the next.
    pub frame_time: f64,
    /// Height of the body in the file's own units.
    pub height: f64,
    #[tsify(type = "\"x\" | \"y\" | \"z\"")]
    pub up_axis: String,
    /// What was odd about the file but could be read.
    pub warnings: Vec<String>,
    /// Splits found from the joint names; always at least "whole".
    pub presets: Vec<PartsPreset>,
}

/// A clip that the project makes itself.
#[derive(Serialize, Tsify)]
pub struct SampleInfo {
    pub id: String,
    pub title: String,
    pub movement: String,
}

/// What training is asked to do.
#[derive(Clone, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct TrainingSettings {
    pub parts: Vec<PartSpec>,
    /// Latent dimensions Q of every part.
    pub latent: usize,
    /// Dynamics inducing points K of every expert.
    pub dynamics_ips: usize,
    /// Pose inducing points L of every part.
    pub pose_ips: usize,
    /// Order p of the dynamics.
    pub order: usize,
    /// The clips are brought to about this rate.
    pub frames_per_second: f64,
    /// The seed of everything random, a whole number from 0 to 4294967295.
    pub seed: u32,
    /// Most iterations of the optimiser.
    pub max_iterations: usize,
}

/// The terms of the bound, in nats.
#[derive(Serialize, Tsify)]
pub struct Terms {
    /// The pose map of each part.
    pub kinematics: Vec<f64>,
    /// The dynamics into each part.
    pub dynamics: Vec<f64>,
    pub initial: f64,
    pub entropy: f64,
}

/// How far training is.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
#[serde(rename_all = "camelCase")]
pub struct TrainingProgress {
    pub iteration: usize,
    pub max_iterations: usize,
    pub evaluations: usize,
    /// The bound now, in nats.
    pub bound: f64,
    /// The best so far.
    pub best: f64,
    /// The terms of the best.
    pub terms: Terms,
    /// What is being optimised, in plain words.
    pub phase: String,
    pub done: bool,
    /// Why it ended, in plain words.
    pub reason: Option<String>,
    /// Share of the iterations used, 0 to 1. Time left is at most elapsed * (1 - fraction) / fraction.
    pub fraction: f64,
}

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

/// What a rollout is asked for.
#[derive(Deserialize, Tsify)]
pub struct RolloutOptions {
    /// Frames in all, the start included.
    pub frames: usize,
    /// The training sequence whose start latents begin it, counted from 0.
    pub sequence: usize,
    /// Coupling variances `alpha[source][target]`; absent: as learned.
    #[serde(default)]
    #[tsify(optional, type = "number[][] | null")]
    pub alpha: Option<Vec<Vec<f64>>>,
    /// What changed couplings do to the experts; absent: they stay as learned.
    #[serde(default)]
    #[tsify(optional, type = "\"as learned\" | \"re-inferred\"")]
    pub reading: Option<String>,
}

fn error(e: impl std::fmt::Display) -> JsError {
    JsError::new(&e.to_string())
}

fn joints(skeleton: &Skeleton) -> Vec<JointInfo> {
    let joint = |j: &crate::Joint| JointInfo {
        name: j.name.clone(),
        parent: j.parent,
        channels: j.channels.iter().map(|c| c.name().to_owned()).collect(),
    };
    skeleton.joints.iter().map(joint).collect()
}

fn figure(skeleton: &Skeleton) -> Figure {
    let nodes = skeleton.figure().into_iter();
    Figure {
        nodes: nodes.map(|n| FigureNode { joint: n.joint, parent: n.parent, end_site: n.end_site }).collect(),
    }
}

fn part_spec(part: &Part) -> PartSpec {
    PartSpec { name: part.name.clone(), joints: part.joints.clone() }
}

fn terms(terms: &BoundTerms) -> Terms {
    Terms {
        kinematics: terms.kinematics.clone(),
        dynamics: terms.dynamics.clone(),
        initial: terms.initial,
        entropy: terms.entropy,
    }
}

/// Row after row.
fn flat(matrix: &DMatrix<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

/// A recorded motion.
#[wasm_bindgen]
pub struct Clip {
    clip: MotionClip,
}

#[wasm_bindgen]
impl Clip {
    /// Reads a BVH file; a leading T-pose is dropped, with a warning. Throws an error that names the file, the line, what was
    /// expected and what was found.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Clip, JsError> {
        let (clip, _) = bvh::read(name, bytes).map_err(error)?.drop_t_pose();
        Ok(Clip { clip })
    }

    /// A clip that the project makes itself, by its id in `samples()`.
    pub fn sample(id: &str) -> Result<Clip, JsError> {
        let unknown = || error(format!("expected the id of a sample clip, found \"{id}\""));
        Ok(Clip { clip: samples::clip(id).ok_or_else(unknown)? })
    }

    /// The clips that the project makes itself.
    pub fn samples() -> Result<Vec<Ts<SampleInfo>>, JsError> {
        let info = |s: samples::SampleInfo| SampleInfo {
            id: s.id.to_owned(),
            title: s.title.to_owned(),
            movement: s.movement.to_owned(),
        };
        samples::list().into_iter().map(|s| info(s).into_ts().map_err(error)).collect()
    }

    /// The clip's name.
    #[wasm_bindgen(getter)]
    pub fn name(&self) -> String {
        self.clip.name.clone()
    }

    /// What there is to know of it.
    pub fn info(&self) -> Result<Ts<ClipInfo>, JsError> {
        let clip = &self.clip;
        let presets = parts::presets(&clip.skeleton).into_iter().map(|p| PartsPreset {
            id: p.id.to_string(),
            title: p.title.to_string(),
            parts: p.parts.iter().map(part_spec).collect(),
        });
        let info = ClipInfo {
            name: clip.name.clone(),
            sha256: clip.sha256.clone(),
            joints: joints(&clip.skeleton),
            figure: figure(&clip.skeleton),
            frames: clip.frames(),
            frame_time: clip.frame_time,
            height: clip.height(),
            up_axis: clip.up_axis().letter().to_owned(),
            warnings: clip.warnings.clone(),
            presets: presets.collect(),
        };
        info.into_ts().map_err(error)
    }

    /// The frames from `first` up to but not including `end`.
    pub fn cut(&self, first: usize, end: usize) -> Result<Clip, JsError> {
        Ok(Clip { clip: self.clip.cut(first, end).map_err(error)? })
    }

    /// The clip at about another frame rate.
    pub fn resample(&self, frames_per_second: f64) -> Result<Clip, JsError> {
        Ok(Clip { clip: self.clip.resample(frames_per_second).map_err(error)? })
    }

    /// The clip as the text of a BVH file.
    #[wasm_bindgen(js_name = toBvh)]
    pub fn to_bvh(&self) -> String {
        bvh::write(&self.clip)
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Vec<f32> {
        self.clip.stage_positions()
    }
}

/// The clips that a model is trained on, one sequence each.
#[wasm_bindgen]
#[derive(Default)]
pub struct TrainingSet {
    clips: Vec<MotionClip>,
}

#[wasm_bindgen]
impl TrainingSet {
    /// An empty set.
    #[wasm_bindgen(constructor)]
    pub fn new() -> TrainingSet {
        TrainingSet::default()
    }

    /// Adds a clip. Throws the reason when its body differs from the first clip's; the set stays as it was.
    pub fn add(&mut self, clip: &Clip) -> Result<(), JsError> {
        if let Some(first) = self.clips.first() {
            first.skeleton.same_body(&clip.clip.skeleton).map_err(|reason| {
                error(format!("{} cannot be trained together with {}: {reason}", clip.clip.name, first.name))
            })?;
        }
        self.clips.push(clip.clip.clone());
        Ok(())
    }

    /// How many clips there are.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> usize {
        self.clips.len()
    }
}

/// A training under way.
#[wasm_bindgen]
pub struct Trainer {
    dataset: Dataset,
    training: Training,
    frames_per_second: f64,
}

#[wasm_bindgen]
impl Trainer {
    /// Prepares the clips and finds the starting point.
    #[wasm_bindgen(constructor)]
    pub fn new(clips: &TrainingSet, settings: Ts<TrainingSettings>) -> Result<Trainer, JsError> {
        let settings = settings.to_rust().map_err(|e| error(format!("settings: {e}")))?;
        let sources: Vec<Source> =
            clips.clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
        let parts: Vec<Part> =
            settings.parts.into_iter().map(|p| Part { name: p.name, joints: p.joints }).collect();
        let frames_per_second = settings.frames_per_second;
        let dataset = Dataset::new(&sources, &parts, frames_per_second).map_err(error)?;
        let settings = Settings {
            latent: settings.latent,
            dynamics_ips: settings.dynamics_ips,
            pose_ips: settings.pose_ips,
            order: settings.order,
            seed: settings.seed,
            max_iterations: settings.max_iterations,
        };
        let training = Training::new(dataset.y.clone(), dataset.lengths(), settings).map_err(error)?;
        Ok(Trainer { dataset, training, frames_per_second })
    }

    /// One iteration of the optimiser: a few milliseconds to some tens.
    pub fn step(&mut self) -> Result<Ts<TrainingProgress>, JsError> {
        let p = self.training.step();
        let progress = TrainingProgress {
            iteration: p.iteration,
            max_iterations: p.max_iterations,
            evaluations: p.evaluations,
            bound: p.bound,
            best: p.best,
            terms: terms(&p.terms),
            phase: p.phase,
            done: p.done,
            reason: p.reason,
            fraction: p.fraction,
        };
        progress.into_ts().map_err(error)
    }

    /// The best model so far, at any time.
    pub fn model(&self) -> Result<Model, JsError> {
        let model =
            MotionModel::trained(&self.dataset, &self.training, self.frames_per_second).map_err(error)?;
        Ok(Model { model: Rc::new(model) })
    }

    /// Latent means of the training frames at the best so far [frames x Q] of one part, sequences one after the other.
    pub fn latents(&self, part: usize) -> Result<Vec<f64>, JsError> {
        let params = self.training.best();
        let part = params.parts.get(part).ok_or_else(|| error(format!("there is no part {part}")))?;
        Ok(flat(&part.latents.mean))
    }
}

/// A trained model.
#[wasm_bindgen]
pub struct Model {
    model: Rc<MotionModel>,
}

impl Model {
    fn part(&self, part: usize) -> Result<&crate::PoseMap, JsError> {
        self.model.fitted.parts.get(part).ok_or_else(|| error(format!("there is no part {part}")))
    }

    fn expert(&self, source: usize, target: usize) -> Result<&crate::FittedExpert, JsError> {
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
        let options = options.to_rust().map_err(|e| error(format!("rollout: {e}")))?;
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
    kernel: &crate::Kernel,
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

/// A rolled-out motion.
#[wasm_bindgen]
pub struct Rollout {
    rollout: MotionRollout,
    positions: Vec<f32>,
    model: Rc<MotionModel>,
}

#[wasm_bindgen]
impl Rollout {
    /// Frames in all, the start included.
    #[wasm_bindgen(getter)]
    pub fn frames(&self) -> usize {
        self.rollout.y.nrows()
    }

    /// The latent path of a part [frames x Q].
    pub fn latents(&self, part: usize) -> Result<Vec<f64>, JsError> {
        let path = self.rollout.latents.get(part).ok_or_else(|| error(format!("there is no part {part}")))?;
        Ok(flat(path))
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Vec<f32> {
        self.positions.clone()
    }

    /// The motion as the text of a BVH file.
    #[wasm_bindgen(js_name = toBvh)]
    pub fn to_bvh(&self) -> Result<String, JsError> {
        Ok(bvh::write(&self.model.clip(&self.rollout, "rollout.bvh").map_err(error)?))
    }
}

/// A fresh seed from the machine's own randomness.
#[wasm_bindgen(js_name = freshSeed)]
pub fn fresh_seed() -> Result<u32, JsError> {
    getrandom::u32().map_err(error)
}

/// The version of this package.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// A problem and a point in its parameter space, for measuring one bound with its gradient.
#[cfg(feature = "speed")]
#[wasm_bindgen]
pub struct Case {
    case: crate::case::Case,
    workspace: crate::model::Workspace,
}

#[cfg(feature = "speed")]
#[wasm_bindgen]
impl Case {
    /// Reads a golden case.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &str) -> Result<Case, JsError> {
        let case = crate::case::Case::from_json(text)?;
        let workspace = case.objective.workspace(&case.params);
        Ok(Case { case, workspace })
    }

    /// The bound, in nats; its gradient is computed as well.
    #[wasm_bindgen(js_name = boundWithGradient)]
    pub fn bound_with_gradient(&mut self) -> Result<f64, JsError> {
        self.case.objective.compute_with_gradient(&self.case.params, &mut self.workspace)?;
        Ok(self.workspace.terms().total())
    }
}
