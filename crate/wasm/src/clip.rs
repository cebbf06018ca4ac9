//! Clips, and what there is to know of them.

use crate::motion::clip::Clip as MotionClip;
use crate::motion::{bvh, parts, samples};
use crate::wasm::{Figure, JointInfo, PartSpec, error, figure, joints, part_spec};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// A split of the body found from the names of its joints.
#[derive(Serialize, Tsify)]
pub struct PartsPreset {
    pub id: String,
    pub title: String,
    pub parts: Vec<PartSpec>,
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

/// A recorded motion.
#[wasm_bindgen]
pub struct Clip {
    pub(super) clip: MotionClip,
}

#[wasm_bindgen]
impl Clip {
    /// Reads a BVH file; a leading T-pose is dropped, with a warning. Throws an error that names the file, the line, what was
    /// expected and what was found.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Clip, JsError> {
        Ok(Clip { clip: bvh::read(name, bytes).map_err(error)?.into_clip() })
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
