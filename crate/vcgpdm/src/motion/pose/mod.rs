//! Poses as rows of numbers Y that a model can learn from, and back.
//!
//! A row holds six numbers of the root that do not depend on where the body is and which way it faces, and
//! for each other joint its rotation vector (exponential map). See [`PoseMapping`].

mod decode;
mod encode;
mod mapping;
mod root;
mod stored;

pub use encode::Encoded;
pub use mapping::{Column, ColumnKind, PoseError, PoseMapping};
pub use root::{RootStart, RootTrack};

#[cfg(test)]
mod tests;
