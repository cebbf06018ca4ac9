//! Training data: clips or tables as centred columns of parts, one sequence after the other.

pub(crate) mod column_mapping;
pub(crate) mod dataset;
pub(crate) mod json;
pub(crate) mod movements;
pub(crate) mod phase;
pub(crate) mod sequences;
mod tables;
mod warnings;
