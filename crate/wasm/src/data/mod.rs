//! Clips, tables and documents.

pub mod body;
pub mod bvh;
pub mod clip;
pub mod document_kind;
#[cfg(feature = "training")]
pub mod tables;
