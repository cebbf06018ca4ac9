//! Rollouts: requests, latent dynamics under given couplings, live rollouts, and the health of a rollout.

pub(crate) mod couplings;
pub(crate) mod health;
pub(crate) mod latent_dynamics;
pub(crate) mod latent_paths;
pub(crate) mod live;
mod movers;
pub(crate) mod naturalness;
mod reach;
pub(crate) mod request;
