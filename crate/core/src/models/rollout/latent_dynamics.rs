//! Mean dynamics of the latents of all parts under given couplings (Velychko et al. 2018, figure 3F).

use crate::gp::KernelSum;
use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::rollout::request::RolloutError;
use nalgebra::DMatrix;

/// The mean dynamics of all parts under given couplings: x^i_t = sum_j w_{ji} f^{ji}(x^j_{t-p}, ...,
/// x^j_{t-1}).
#[derive(Clone, Debug)]
pub struct LatentDynamics {
    order: usize,
    /// Latent dimensions Q_i of each part.
    latent: Vec<usize>,
    /// w_{ji} f^{ji} as `experts[target][source]`.
    experts: Vec<Vec<KernelSum>>,
}

impl LatentDynamics {
    /// Dynamics of this `order` of parts with `latent` dimensions each; `experts[target][source]` are the
    /// weighted predictions w_{ji} f^{ji}, from histories [p Q_j] to latents `[Q_i]`.
    pub(crate) fn new(order: usize, latent: Vec<usize>, experts: Vec<Vec<KernelSum>>) -> Self {
        Self { order, latent, experts }
    }

    /// The latent path of every part [frames x Q_i]: the `start` [p x Q_i] of each part, then the mean
    /// dynamics, all parts advancing together.
    ///
    /// # Errors
    ///
    /// When the start latents are not p x Q_i numbers for each part.
    pub fn path(&self, start: &[DMatrix<f64>], frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        let mut paths = LatentPaths::new(start, self.order, &self.latent)?;
        self.extend(&mut paths, frames);
        Ok(paths.matrices(0..frames))
    }

    /// Extends paths of these parts until they have `frames` frames.
    pub(crate) fn extend(&self, paths: &mut LatentPaths, frames: usize) {
        let widest = self.latent.iter().max().copied().unwrap_or(0);
        let mut scratch = vec![0.0; self.order * widest];
        let mut next: Vec<Vec<f64>> = self.latent.iter().map(|&q| vec![0.0; q]).collect();
        while paths.frames() < frames {
            for (next, experts) in next.iter_mut().zip(&self.experts) {
                next.fill(0.0);
                for (j, expert) in experts.iter().enumerate() {
                    expert.add_to(&paths.history(j), &mut scratch, next);
                }
            }
            paths.append(&next);
        }
    }
}
