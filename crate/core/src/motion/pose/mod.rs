//! Poses as rows of numbers Y for a model, and back.
//!
//! A row has six numbers of the root, which do not depend on the position and heading of the body, and the
//! rotation vector (exponential map) of each other joint. See [`PoseMapping`].

mod climb;
mod decode;
mod encode;
mod mapping;
mod root;
mod stored;

pub use encode::Encoded;
pub(crate) use mapping::ROOT_COLUMNS;
pub use mapping::{Column, ColumnKind, PoseError, PoseMapping};
pub use root::{RootStart, RootTrack};

#[cfg(test)]
mod tests;
