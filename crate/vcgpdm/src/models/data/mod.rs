//! The data that models are trained on: clips or tables as centred columns of parts, sequence after sequence.

pub(crate) mod dataset;
pub(crate) mod movements;
pub(crate) mod observed;
pub(crate) mod phase;
pub(crate) mod sequence_info;
pub(crate) mod sequences;
mod tables;
pub(crate) mod trials;
mod warnings;
