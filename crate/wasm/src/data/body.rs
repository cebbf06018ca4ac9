//! What a picture of a body needs to know.

use serde::Serialize;
use vcgpdm_core::motion::Skeleton;
use vcgpdm_core::motion::skeleton::{FigureNode, Joint};

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
struct JointInfo {
    name: String,
    /// Null for the root.
    parent: Option<usize>,
    /// What the file records of it, e.g. "Xrotation".
    channels: Vec<&'static str>,
}

/// What a picture of the body draws.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
struct Figure {
    nodes: Vec<FigureNode>,
}

/// The joints of a body, and what a picture of it draws.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct BodyInfo {
    joints: Vec<JointInfo>,
    figure: Figure,
}

impl BodyInfo {
    /// The joints and the figure of a skeleton.
    pub fn new(skeleton: &Skeleton) -> Self {
        let joint = |joint: &Joint| JointInfo {
            name: joint.name.clone(),
            parent: joint.parent,
            channels: joint.channels.iter().map(|channel| channel.name()).collect(),
        };
        let joints = skeleton.joints.iter().map(joint).collect();
        Self { joints, figure: Figure { nodes: skeleton.figure() } }
    }
}
