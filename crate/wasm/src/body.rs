//! What a picture of a body needs to know.

use serde::Serialize;
use vcgpdm::motion::Skeleton;
use vcgpdm::motion::skeleton::{FigureNode, Joint};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A part is a named group of joints that move together, by their place in the skeleton. */
export interface PartSpec {
    name: string;
    joints: number[];
}

export interface JointInfo {
    name: string;
    /** Null for the root. */
    parent: number | null;
    /** What the file records of it, e.g. "Xrotation". */
    channels: string[];
}

/** A joint or an end site. A bone runs from each node to its parent node. */
export interface FigureNode {
    /** The joint, or, for an end site, the joint whose bone ends here. */
    joint: number;
    /** The parent node; null for the root. */
    parent: number | null;
    endSite: boolean;
}

/** What a picture of the body draws. */
export interface Figure {
    nodes: FigureNode[];
}
"#;

#[derive(Serialize)]
struct JointInfo {
    name: String,
    parent: Option<usize>,
    channels: Vec<&'static str>,
}

#[derive(Serialize)]
struct Figure {
    nodes: Vec<FigureNode>,
}

/// The joints of a body, and what a picture of it draws.
#[derive(Serialize)]
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
