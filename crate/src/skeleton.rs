//! The joint tree of a body: names, parents, offsets and the channels each joint is recorded in.

use serde::{Deserialize, Serialize};

/// One degree of freedom of a joint, as a BVH file names it. Rotations are in degrees, positions in file units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Channel {
    /// Translation along x.
    Xposition,
    /// Translation along y.
    Yposition,
    /// Translation along z.
    Zposition,
    /// Rotation about x.
    Xrotation,
    /// Rotation about y.
    Yrotation,
    /// Rotation about z.
    Zrotation,
}

/// One joint. Joints are known by their place in the skeleton: names need not be unique.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Joint {
    /// The name as written in the file.
    pub name: String,
    /// The place of the parent, which always comes before its children; `None` for the root.
    pub parent: Option<usize>,
    /// The joint's place in its parent's frame, in file units.
    pub offset: [f64; 3],
    /// The channels in the order in which a row of the file holds them.
    pub channels: Vec<Channel>,
    /// The ends of the bones that leave this joint and reach no other joint, in file units.
    pub end_sites: Vec<[f64; 3]>,
}

/// A joint tree with one root at place 0 and parents before children.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Skeleton {
    /// The joints, in the order of the file.
    pub joints: Vec<Joint>,
}
