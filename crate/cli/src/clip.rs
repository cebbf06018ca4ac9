//! `vcgpdm clip`: what a clip is, and the clip written back.

use crate::files;
use serde_json::json;
use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm::motion::bvh;

/// Print what a clip holds as one JSON object, and write it back.
#[derive(clap::Args)]
pub struct Arguments {
    /// A BVH file, or sample:ID.
    #[arg(value_name = "CLIP")]
    clip: String,
    /// Resample to about so many frames a second.
    #[arg(long, value_name = "F")]
    fps: Option<f64>,
    /// Write the clip to this file.
    #[arg(long, value_name = "OUT.bvh")]
    out: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let mut clip = files::read_clip(&arguments.clip)?;
    if let Some(out) = &arguments.out {
        files::check_writable(out, [Path::new(&arguments.clip)])?;
    }
    if let Some(fps) = arguments.fps {
        clip = clip.resample(fps)?;
    }
    if let Some(out) = &arguments.out {
        files::write_text(out, &bvh::write(&clip))?;
    }
    let joints = clip.skeleton.joints.iter().map(|joint| {
        let channels: Vec<&str> = joint.channels.iter().map(|channel| channel.name()).collect();
        json!({ "name": joint.name, "parent": joint.parent, "offset": joint.offset, "channels": channels })
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
        "up_axis": stage.up.letter(),
        "warnings": clip.warnings,
    });
    let outs: Vec<&Path> = arguments.out.as_deref().into_iter().collect();
    files::print_summary(&summary, &outs)
}
