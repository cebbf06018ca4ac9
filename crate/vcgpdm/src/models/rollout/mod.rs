//! Rollouts: requests, latent dynamics under given couplings, motions without an end, the health of a rollout, and its
//! error after dynamic time warping.

pub(crate) mod couplings;
pub(crate) mod dtw;
pub(crate) mod endless;
pub(crate) mod health;
pub(crate) mod latent_dynamics;
pub(crate) mod latent_paths;
pub(crate) mod log_density;
mod movers;
pub(crate) mod pace;
pub(crate) mod reach;
pub(crate) mod request;
