//! `vcgpdm clip`: prints what is in a clip, and writes the clip back.

use crate::clips::{self, Names, Up};
use crate::files;
use crate::numbers::check_fps;
use serde_json::json;
use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm_core::motion::parts::PartSpec;
use vcgpdm_core::motion::{asf, parts};

/// Print the contents of a clip and the parts of each preset as one JSON object, and write the clip back.
#[derive(clap::Args)]
pub struct Arguments {
    /// A BVH file, or sample:ID; or an ASF skeleton.
    #[arg(value_name = "CLIP")]
    clip: PathBuf,
    /// The AMC motion of an ASF skeleton; 120 frames a second without --clip-fps.
    #[arg(value_name = "MOTION.amc")]
    motion: Option<PathBuf>,
    /// Keep these frames, from FROM up to but not including TO: counted from 0 at the file's rate, without a
    /// leading T-pose.
    #[arg(long, value_name = "FROM-TO", value_parser = frames)]
    frames: Option<(usize, usize)>,
    /// Transfer the motion to the body of this clip: joints of the same name, else of the same place, turn in the world as
    /// they do in CLIP, and the path of the root is scaled with its height above the ground.
    #[arg(long, value_name = "BODY.bvh")]
    onto: Option<PathBuf>,
    /// Resample to about this number of frames a second.
    #[arg(long, value_name = "F")]
    fps: Option<f64>,
    #[command(flatten)]
    up: Up,
    /// Write the clip to this file.
    #[arg(long, value_name = "OUT.bvh")]
    out: Option<PathBuf>,
    #[command(flatten)]
    names: Names,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    if let Some(fps) = arguments.fps {
        check_fps(fps)?;
    }
    let skeleton = arguments.clip.as_path();
    let mut clip = match &arguments.motion {
        None => clips::read_quietly(skeleton, &arguments.up)?,
        Some(motion) => {
            // The file does not state its rate.
            let rate = arguments.up.rate.clip_fps.unwrap_or(asf::CMU_RATE);
            let (skeleton_bytes, motion_bytes) = (files::read_bytes(skeleton)?, files::read_bytes(motion)?);
            let (skeleton_name, motion_name) = (files::read_name(skeleton), files::read_name(motion));
            let skeleton = asf::File { name: &skeleton_name, bytes: &skeleton_bytes };
            let motion = asf::File { name: &motion_name, bytes: &motion_bytes };
            arguments.up.clip(asf::read(skeleton, motion, rate)?)?
        }
    };
    if let Some(out) = &arguments.out {
        let read = [arguments.motion.as_deref(), arguments.onto.as_deref()].into_iter().flatten();
        files::check_writable(out, [skeleton].into_iter().chain(read))?;
    }
    if let Some((from, to)) = arguments.frames {
        clip = clip.cut(from, to)?;
    }
    if let Some(body) = &arguments.onto {
        clip = clip.onto(&clips::read(body, &Up::default())?)?;
    }
    if let Some(fps) = arguments.fps {
        clip = clip.resample(fps)?;
    }
    if let Some(out) = &arguments.out {
        files::write_text(out, &arguments.names.bvh(clip.clone()))?;
    }
    let joints = clip.skeleton.joints.iter().map(|joint| {
        let channels: Vec<&str> = joint.channels.iter().map(|channel| channel.name()).collect();
        json!({ "name": joint.name, "parent": joint.parent, "offset": joint.offset, "channels": channels })
    });
    let names = |part: &PartSpec| -> Vec<&str> {
        part.joints.iter().map(|&joint| clip.skeleton.joints[joint].name.as_str()).collect()
    };
    let presets = parts::presets(&clip.skeleton).into_iter().map(|preset| {
        let parts: Vec<_> =
            preset.parts.iter().map(|part| json!({ "name": part.name, "joints": names(part) })).collect();
        json!({ "id": preset.id, "title": preset.title, "parts": parts })
    });
    let stage = clip.stage();
    let summary = json!({
        "name": clip.name,
        "sha256": clip.sha256,
        "joints": joints.collect::<Vec<_>>(),
        "channels": clip.skeleton.channel_count(),
        "frames": clip.frames(),
        "frame_time": clip.frame_time,
        "height": stage.height,
        "up_axis": stage.up.name(),
        "presets": presets.collect::<Vec<_>>(),
        "warnings": clip.warnings,
    });
    let outs: Vec<&Path> = arguments.out.as_deref().into_iter().collect();
    files::print_summary(&summary, &outs)
}

fn frames(text: &str) -> Result<(usize, usize), String> {
    let frame = |text: &str| text.trim().parse::<usize>().ok();
    let found = text.split_once('-').and_then(|(from, to)| Some((frame(from)?, frame(to)?)));
    found.ok_or_else(|| "expected two frames FROM-TO".to_owned())
}
