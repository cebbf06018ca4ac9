//! The models that the vCGPDM is compared with.

pub mod map;
