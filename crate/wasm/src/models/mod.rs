//! Models, their trainings and their rollouts.

#[cfg(feature = "speed")]
pub mod case;
#[cfg(feature = "training")]
pub mod completion;
pub mod endless;
pub mod model;
#[cfg(feature = "training")]
pub mod plane;
pub mod points;
pub mod predictions;
pub mod rollout;
pub mod settings;
pub mod trained;
#[cfg(feature = "training")]
pub mod trainer;
