//! Reading and writing clips for all commands, and the options for it.

use crate::files::{read_bytes, read_name};
use crate::task::say;
use crate::usage::usage;
use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm_core::motion::pose::PoseMapping;
use vcgpdm_core::motion::stage::UpAxis;
use vcgpdm_core::motion::{Clip, Recording, bvh, samples};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Reads a BVH file, or makes the sample clip that `sample:ID` names. Writes to stderr what is unusual in the
/// file.
pub fn read(path: &Path, up: &Up) -> Result<Clip> {
    let clip = read_quietly(path, up)?;
    warnings(&clip).iter().for_each(|warning| say(warning));
    Ok(clip)
}

/// Reads a clip for a model; see [`say_differences`].
pub fn read_for(path: &Path, up: &Up, mapping: &PoseMapping) -> Result<Clip> {
    let clip = read(path, up)?;
    say_differences(&clip, mapping);
    Ok(clip)
}

/// Says if another axis points up in a clip than in the body of a model, or its joints are in another order.
pub fn say_differences(clip: &Clip, mapping: &PoseMapping) {
    let differences = mapping.axis_warning(clip).into_iter().chain(mapping.order_warning(clip));
    differences.for_each(|warning| say(&format!("{}: {warning}", clip.name)));
}

/// Reads several clips for a model; see [`read_for`].
pub fn read_all_for(paths: &[PathBuf], up: &Up, mapping: &PoseMapping) -> Result<Vec<Clip>> {
    paths.iter().map(|path| read_for(path, up, mapping)).collect()
}

/// The warnings that [`read`] writes, as the data set of a training repeats them.
pub fn warnings(clip: &Clip) -> Vec<String> {
    clip.warnings.iter().map(|warning| format!("{}: {warning}", clip.name)).collect()
}

/// Reads several clips; see [`read`].
pub fn read_all(paths: &[PathBuf], up: &Up) -> Result<Vec<Clip>> {
    paths.iter().map(|path| read(path, up)).collect()
}

/// As [`read`], for commands whose results have the warnings of the clip.
pub fn read_quietly(path: &Path, up: &Up) -> Result<Clip> {
    if let Some(id) = path.to_str().and_then(|path| path.strip_prefix("sample:")) {
        let clip = samples::clip(id).ok_or_else(|| {
            let samples: Vec<&str> = samples::list().iter().map(|info| info.id).collect();
            format!("expected one of the samples {}, found {id:?}", samples.join(", "))
        })?;
        if up.root.is_some() {
            return Err(usage("--root: expected clips from files, found a sample"));
        }
        return Ok(up.of(clip));
    }
    let bytes = read_bytes(path)?;
    up.clip(bvh::read_at(&read_name(path), &bytes, up.rate.clip_fps)?)
}

/// The option `--clip-fps`.
#[derive(Clone, Copy, Default, clap::Args)]
pub struct Rate {
    /// Frames a second of the motion files, where their frame time is wrong or missing.
    #[arg(long, value_name = "F", alias = "amc-fps", value_parser = clip_fps)]
    pub clip_fps: Option<f64>,
}

fn clip_fps(text: &str) -> std::result::Result<f64, String> {
    let (from, to) = (Clip::RATES.start(), Clip::RATES.end());
    let rate = text.trim().parse().ok().filter(|rate| Clip::RATES.contains(rate));
    rate.ok_or_else(|| format!("expected frames a second from {from} to {to}"))
}

/// The options `--up`, `--root` and `--clip-fps`, for commands that read clips.
#[derive(Default, clap::Args)]
pub struct Up {
    /// The axis that points up in the clips: x, y, z, -x, -y or -z; absent: the axis found from the motion.
    #[arg(long = "up", value_name = "AXIS", value_parser = up_axis, allow_hyphen_values = true)]
    pub axis: Option<UpAxis>,
    /// The joint that becomes the root of the clips: of several bodies in one file, the one to read.
    #[arg(long = "root", value_name = "JOINT")]
    pub root: Option<String>,
    #[command(flatten)]
    pub rate: Rate,
}

impl Up {
    /// The clip with the axis that the user states.
    fn of(&self, clip: Clip) -> Clip {
        match self.axis {
            Some(axis) => clip.with_up(axis),
            None => clip,
        }
    }

    /// The clip of a recording, with the root and the axis that the user states.
    pub fn clip(&self, recording: Recording) -> Result<Clip> {
        Ok(self.of(recording.of_root(self.root.as_deref())?.into_clip()))
    }

    /// Refuses the options if the command reads no clip. `expected` is the option that would give a clip.
    pub fn check(&self, reads_clips: bool, expected: &str) -> Result<()> {
        let given = [
            ("--up", self.axis.is_some()),
            ("--root", self.root.is_some()),
            ("--clip-fps", self.rate.clip_fps.is_some()),
        ];
        match given.iter().find(|(_, given)| *given && !reads_clips) {
            Some((option, _)) => Err(usage(format!("{option}: expected {expected} with it"))),
            None => Ok(()),
        }
    }
}

fn up_axis(text: &str) -> std::result::Result<UpAxis, String> {
    UpAxis::from_name(text).ok_or_else(|| "expected x, y, z, -x, -y or -z".to_owned())
}

/// The option `--plain-names` of commands that write a clip to `--out`.
#[derive(clap::Args)]
pub struct Names {
    /// Write names of letters, digits, "_" and "-" only, without a prefix such as "mixamorig:".
    #[arg(long = "plain-names", requires = "out")]
    plain: bool,
}

impl Names {
    /// The text of a BVH file.
    pub fn bvh(&self, clip: Clip) -> String {
        bvh::write(&if self.plain { clip.with_plain_names() } else { clip })
    }
}

/// The clip of this content. `name` is its name in the file that needs the clip.
pub fn find<'a>(clips: &'a [Clip], name: &str, sha256: &str) -> Result<&'a Clip> {
    clips.iter().find(|clip| clip.sha256 == sha256).ok_or_else(|| {
        let start: String = sha256.chars().take(8).collect();
        format!("expected the clip {name} (SHA-256 {start}...) among those given, found none").into()
    })
}
