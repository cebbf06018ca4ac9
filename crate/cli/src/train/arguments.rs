//! The arguments of `vcgpdm train`.

use crate::clips::Up;
use crate::train::kind;
use std::ffi::OsString;
use std::path::PathBuf;
use vcgpdm_core::models::ModelKind;

/// Train a model on clips of one body and print a summary as one JSON object.
#[derive(clap::Args)]
pub struct Arguments {
    /// BVH files, or sample:ID; each becomes a sequence. With --columns: CSV files.
    #[arg(value_name = "CLIP", required_unless_present = "movements", conflicts_with = "movements")]
    pub(super) clips: Vec<PathBuf>,
    /// Train a library of primitives: clips of one movement, under its name; may be given several times.
    #[arg(long = "movement", value_name = "NAME=CLIP,CLIP", conflicts_with = "seed_frames")]
    pub(super) movements: Vec<OsString>,
    /// Parts that use the same primitive in all movements; every other part has one primitive for each
    /// movement.
    #[arg(long, value_name = "PART,PART")]
    pub(super) share: Vec<String>,
    /// The kind of model: vcgpdm, vgpdm, map-gpdm, map-cgpdm, tmp, dmp-discrete or dmp-rhythmic; absent:
    /// vcgpdm, or vgpdm for one part.
    #[arg(long, value_name = "KIND", value_parser = kind::parse)]
    pub(super) model: Option<ModelKind>,
    /// How to split the body: a preset by its id or its parts' names (whole; lower,upper; body,left arm,right
    /// arm; legs,trunk,left arm,right arm), or a file with a list like [{"name": "legs", "joints":
    /// ["LeftUpLeg", 3]}]. Models that are not coupled need none. With --columns: arm=x,y;leg=z (a name that
    /// begins or ends with * means all columns that end or begin like it), or a file with [{"name": "arm", "columns": ["x",
    /// "y"]}].
    #[arg(long, value_name = "lower,upper|whole|FILE")]
    pub(super) parts: Option<String>,
    /// Train on time series: each CLIP is a CSV file, with the names of the columns in its first row and one
    /// row for each moment. A column such as "time", "seconds" or "time_ms" holds the times; a column "frame" is ignored.
    #[arg(long, conflicts_with_all = ["seed_frames", "first_bones", "clip_fps"])]
    pub(super) columns: bool,
    /// Leave these columns out. A name that begins or ends with * means all columns that end or begin like
    /// it.
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', requires = "columns")]
    pub(super) without: Vec<String>,
    /// Write the model to this file.
    #[arg(long, value_name = "MODEL.json")]
    pub(super) out: PathBuf,
    /// Resample the clips to about this number of frames a second. With --columns: the rows a second of files
    /// without times.
    #[arg(long, value_name = "F", default_value_t = 30.0)]
    pub(super) fps: f64,
    /// Add the first COUNT frames of another clip, after resampling, as one more sequence.
    #[arg(long, value_name = "CLIP:COUNT")]
    pub(super) seed_frames: Vec<OsString>,
    /// Give all clips the bones of the first, for recordings of several people with the same joints. Joint
    /// angles stay; the path of the root is scaled with its height above the ground.
    #[arg(long)]
    pub(super) first_bones: bool,
    #[command(flatten)]
    pub(super) up: Up,
    /// Store a note in the model, such as an acknowledgement.
    #[arg(long, value_name = "TEXT")]
    pub(super) note: Option<String>,
    #[command(flatten)]
    pub(super) options: kind::Options,
}
