//! GPDM and CGPDM with point estimates of their latents: all functions marginalised, no inducing points,
//! cubic in the frames (Wang, Fleet & Hertzmann 2008; Velychko, Endres, Taubert & Giese 2014).

mod density;
mod exact_gp;
mod learner;
mod model;
mod params;
mod stored;

pub use density::{LogDensity, MapTerms};
pub use learner::MapLearner;
pub use model::{MapModel, MapPoseMap};
pub use params::{MapParams, MapPart};
