//! Clips and their descriptions.

use crate::data::body::BodyInfo;
use crate::values::arguments::Text;
#[cfg(feature = "training")]
use crate::values::arguments::{Bytes, Whole};
use crate::values::convert::{from_js, to_js, to_js_joined, with_defaults};
use crate::values::error::{ErrorCode, VcgpdmError};
use js_sys::Object;
use serde::{Deserialize, Serialize};
#[cfg(feature = "training")]
use vcgpdm_core::models::{same_body, with_bones_of};
use vcgpdm_core::motion::bvh;
use vcgpdm_core::motion::parts::PartsPreset;
use vcgpdm_core::motion::stage::UpAxis;
use vcgpdm_core::motion::{Clip as MotionClip, parts, samples};
use wasm_bindgen::prelude::*;

/// The name, size, body and warnings of a clip.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct ClipInfo<'a> {
    name: &'a str,
    /// SHA-256 of the file, hexadecimal.
    sha256: &'a str,
    frames: usize,
    /// Seconds from one frame to the next.
    frame_time: f64,
    /// Height of the body in the file's own units.
    height: f64,
    #[cfg_attr(feature = "types", ts(as = "UpAxis"))]
    up_axis: &'static str,
    /// What was odd about the file but could be read.
    warnings: &'a [String],
    /// The root joints of the bodies in the file, where it has several; the first is read. `Clip.readBody`
    /// reads another.
    #[cfg(feature = "training")]
    bodies: &'a [String],
    /// Ways to split the body; at least "whole".
    presets: Vec<PartsPreset>,
}

/// A clip as plain data that `postMessage` can send to a worker.
#[cfg(feature = "training")]
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct ClipState {
    name: String,
    bvh: String,
    sha256: String,
    warnings: Vec<String>,
    /// The frames of the file that a cut clip contains; null if it was not cut.
    piece: Option<(usize, usize)>,
    /// Seconds from one frame of the file to the next.
    file_frame_time: f64,
    bones_of: Option<String>,
    /// The axis that points up, if it was stated.
    #[cfg_attr(feature = "types", ts(as = "Option<UpAxis>"))]
    up: Option<String>,
    /// The axis that was found when the file was read.
    #[cfg_attr(feature = "types", ts(as = "Option<UpAxis>"))]
    found_up: Option<String>,
}

/// A recorded motion.
#[wasm_bindgen]
pub struct Clip {
    pub(crate) clip: MotionClip,
}

#[wasm_bindgen]
impl Clip {
    /// A clip that the project makes itself, by its id in `samples()`.
    pub fn sample(id: &Text) -> Result<Clip, VcgpdmError> {
        let id = id.get(ErrorCode::Clip, "the id of a sample")?;
        #[cfg(feature = "training")]
        let clip = samples::clip(&id);
        #[cfg(not(feature = "training"))]
        let clip = samples::walking_clip(&id);
        let clip = clip.ok_or_else(|| {
            let message = format_args!("expected the id of a sample clip, found \"{id}\"");
            VcgpdmError::new(ErrorCode::Clip, &message)
        })?;
        Ok(Clip { clip })
    }

    /// The clips that the project makes itself.
    #[wasm_bindgen(unchecked_return_type = "SampleInfo[]")]
    pub fn samples() -> Result<JsValue, VcgpdmError> {
        #[cfg(feature = "training")]
        return to_js(&samples::list());
        #[cfg(not(feature = "training"))]
        return to_js(&samples::walking_list());
    }

    /// Its name, size, body and warnings.
    #[wasm_bindgen(unchecked_return_type = "ClipInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        let clip = &self.clip;
        let up = self.up();
        let info = ClipInfo {
            name: &clip.name,
            sha256: &clip.sha256,
            frames: clip.frames(),
            frame_time: clip.frame_time,
            height: clip.height_along(up),
            up_axis: up.name(),
            warnings: &clip.warnings,
            #[cfg(feature = "training")]
            bodies: &clip.bodies,
            presets: parts::presets(&clip.skeleton),
        };
        to_js_joined(&info, &BodyInfo::new(&clip.skeleton))
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Vec<f32> {
        self.clip.positions_along(self.up())
    }
}

impl Clip {
    /// The wasm of a first visit has the sample clips alone, in which y points up: without the search for the axis it
    /// is smaller.
    fn up(&self) -> UpAxis {
        #[cfg(feature = "training")]
        return self.clip.up_axis();
        #[cfg(not(feature = "training"))]
        return UpAxis::Y;
    }
}

#[cfg(feature = "training")]
#[wasm_bindgen]
impl Clip {
    /// Reads a BVH file. A leading T-pose is left out, and a root that only carries a child that moves, each
    /// with a warning. `framesPerSecond` replaces the frame time of the file where it is wrong. The error names
    /// the file, the line, what was expected and what was found.
    pub fn read(
        name: &Text,
        bytes: &Bytes,
        #[wasm_bindgen(js_name = framesPerSecond)] frames_per_second: Option<f64>,
    ) -> Result<Clip, VcgpdmError> {
        let name = name.get(ErrorCode::Clip, "the name")?;
        let bytes = bytes.get(ErrorCode::Clip, "the file")?;
        Ok(Clip { clip: bvh::read_at(&name, &bytes, frames_per_second)?.into_clip() })
    }

    /// Reads one body of a BVH file that has several: the joint of this name and all joints below it.
    #[wasm_bindgen(js_name = readBody)]
    pub fn read_body(
        name: &Text,
        bytes: &Bytes,
        root: &Text,
        #[wasm_bindgen(js_name = framesPerSecond)] frames_per_second: Option<f64>,
    ) -> Result<Clip, VcgpdmError> {
        let name = name.get(ErrorCode::Clip, "the name")?;
        let bytes = bytes.get(ErrorCode::Clip, "the file")?;
        let recording = bvh::read_at(&name, &bytes, frames_per_second)?;
        Ok(Clip { clip: recording.of_root(Some(&root.get(ErrorCode::Clip, "the root")?))?.into_clip() })
    }

    /// The clip's name.
    #[wasm_bindgen(getter)]
    pub fn name(&self) -> String {
        self.clip.name.clone()
    }

    /// The frames from `first` up to but not including `end`.
    pub fn cut(&self, first: &Whole, end: &Whole) -> Result<Clip, VcgpdmError> {
        let first = first.count(ErrorCode::Clip, "the first frame")?;
        let end = end.count(ErrorCode::Clip, "the end")?;
        Ok(Clip { clip: self.clip.cut(first, end)? })
    }

    /// The clip at about another frame rate.
    pub fn resample(&self, frames_per_second: f64) -> Result<Clip, VcgpdmError> {
        Ok(Clip { clip: self.clip.resample(frames_per_second)? })
    }

    /// The same motion of a body with the bones of `other`, whose joints must have the same names in the same
    /// tree; as it is where the bodies are the same.
    #[wasm_bindgen(js_name = withBonesOf)]
    pub fn with_bones_of(&self, other: &Clip) -> Result<Clip, VcgpdmError> {
        Ok(Clip { clip: with_bones_of(&self.clip, &other.clip)? })
    }

    /// The clip in which this axis points up, where another one was found.
    #[wasm_bindgen(js_name = withUp)]
    pub fn with_up(
        &self,
        #[wasm_bindgen(unchecked_param_type = "UpAxis")] axis: &Text,
    ) -> Result<Clip, VcgpdmError> {
        let up = up_axis(&axis.get(ErrorCode::Clip, "the axis that points up")?)?;
        Ok(Clip { clip: self.clip.with_up(up) })
    }

    /// The clip as the text of a BVH file.
    #[wasm_bindgen(js_name = toBvh)]
    pub fn to_bvh(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "BvhOptions")] options: JsValue,
    ) -> Result<String, VcgpdmError> {
        bvh_text(self.clip.clone(), &options)
    }

    /// The clip as plain data, for a worker: `Clip.fromState` makes the same clip there.
    #[wasm_bindgen(unchecked_return_type = "ClipState")]
    pub fn state(&self) -> Result<JsValue, VcgpdmError> {
        let clip = &self.clip;
        to_js(&ClipState {
            name: clip.name.clone(),
            bvh: bvh::write(clip),
            sha256: clip.sha256.clone(),
            warnings: clip.warnings.clone(),
            piece: clip.piece,
            file_frame_time: clip.file_frame_time,
            bones_of: clip.bones_of.clone(),
            up: clip.up.map(|up| up.name().to_owned()),
            found_up: clip.found_up.map(|up| up.name().to_owned()),
        })
    }

    /// The clip of a state.
    #[wasm_bindgen(js_name = fromState)]
    pub fn from_state(
        #[wasm_bindgen(unchecked_param_type = "ClipState")] state: JsValue,
    ) -> Result<Clip, VcgpdmError> {
        let state: ClipState = from_js(ErrorCode::Clip, "state", &state)?;
        // As it is: the rows belong to the motion already.
        let recording = bvh::read(&state.name, state.bvh.as_bytes())?;
        let clip = MotionClip {
            name: state.name,
            skeleton: recording.skeleton,
            frame_time: recording.frame_time,
            values: recording.values,
            warnings: state.warnings,
            sha256: state.sha256,
            piece: state.piece,
            file_frame_time: state.file_frame_time,
            bones_of: state.bones_of,
            up: state.up.as_deref().map(up_axis).transpose()?,
            bodies: Vec::new(),
            found_up: state.found_up.as_deref().map(up_axis).transpose()?,
        };
        Ok(Clip { clip })
    }
}

#[cfg(feature = "training")]
fn up_axis(name: &str) -> Result<UpAxis, VcgpdmError> {
    UpAxis::from_name(name).ok_or_else(|| {
        let message =
            format_args!("the axis that points up: expected x, y, z, -x, -y or -z, found \"{name}\"");
        VcgpdmError::new(ErrorCode::Clip, &message)
    })
}

#[cfg(feature = "training")]
impl Clip {
    /// The body that moves.
    pub fn skeleton(&self) -> &vcgpdm_core::motion::Skeleton {
        &self.clip.skeleton
    }
}

/// The clips or tables that a model is trained on, one sequence each.
#[cfg(feature = "training")]
#[wasm_bindgen]
#[derive(Default)]
pub struct TrainingSet {
    pub(crate) clips: Vec<MotionClip>,
    pub(crate) tables: Vec<vcgpdm_core::series::Table>,
}

#[cfg(feature = "training")]
#[wasm_bindgen]
impl TrainingSet {
    /// An empty set.
    #[wasm_bindgen(constructor)]
    pub fn new() -> TrainingSet {
        TrainingSet::default()
    }

    /// Adds a clip. Throws the reason when its body differs from the first clip's, with the code "bones"
    /// where only its bones do; the set stays as it was.
    pub fn add(&mut self, clip: &Clip) -> Result<(), VcgpdmError> {
        if !self.tables.is_empty() {
            return Err(VcgpdmError::new(ErrorCode::Clips, &"expected a table as the others, found a clip"));
        }
        if let Some(first) = self.clips.first() {
            same_body(first, &clip.clip)?;
        }
        self.clips.push(clip.clip.clone());
        Ok(())
    }

    /// Adds a table. Its columns may be in another order than those of the first table.
    #[wasm_bindgen(js_name = addTable)]
    pub fn add_table(&mut self, table: &crate::data::tables::Table) -> Result<(), VcgpdmError> {
        if !self.clips.is_empty() {
            return Err(VcgpdmError::new(ErrorCode::Table, &"expected a clip as the others, found a table"));
        }
        self.tables.push(match self.tables.first() {
            Some(first) => table.table.like(first)?,
            None => table.table.clone(),
        });
        Ok(())
    }

    /// How many clips or tables there are.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> usize {
        self.clips.len() + self.tables.len()
    }
}

/// How the text of a BVH file is written.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct BvhOptions {
    /// Whether joints get names that every program reads: `mixamorig:Hips` becomes `Hips`. three.js does not
    /// move joints whose names have a colon. Absent: the names stay.
    #[cfg_attr(feature = "types", ts(type = "boolean", optional))]
    plain_names: bool,
}

/// The text of a BVH file.
pub fn bvh_text(clip: MotionClip, options: &JsValue) -> Result<String, VcgpdmError> {
    let options = with_defaults(ErrorCode::Clip, "toBvh", options, Object::new().into())?;
    let BvhOptions { plain_names } = from_js(ErrorCode::Clip, "toBvh", &options)?;
    Ok(bvh::write(&if plain_names { clip.with_plain_names() } else { clip }))
}
