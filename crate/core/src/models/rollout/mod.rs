//! Rollouts: requests, latent dynamics under given couplings, their paths and pace, and the error of a rollout after
//! dynamic time warping.

pub(crate) mod couplings;
pub(crate) mod dtw;
pub(crate) mod latent_dynamics;
pub(crate) mod latent_paths;
pub(crate) mod pace;
pub(crate) mod request;
