//! GPDM and CGPDM with point estimates of their latents: all functions are marginalised, there are no
//! inducing points, and the cost is cubic in the frames (Wang, Fleet & Hertzmann 2008; Velychko, Endres,
//! Taubert & Giese 2014).

mod density;
mod exact_gp;
mod json;
mod learner;
mod model;
mod params;

pub use density::{LogDensity, MapTerms};
pub use learner::MapLearner;
pub use model::{MapModel, MapPoseMap};
pub use params::{MapParams, MapPart};
