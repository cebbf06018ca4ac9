//! The mean dynamics of the latents of all parts, under given couplings: iterated, they are the latent path of a rollout (as in
//! Velychko et al. 2018, figure 3F).

use crate::gp::KernelSum;
use crate::models::rollout::RolloutError;
use nalgebra::DMatrix;

/// The mean dynamics of all parts under given couplings: x^i_t = sum_j w_{ji} f^{ji}(x^j_{t-p}, ..., x^j_{t-1}).
#[derive(Clone, Debug)]
pub struct LatentDynamics {
    order: usize,
    /// Latent dimensions Q_i of each part.
    latent: Vec<usize>,
    /// w_{ji} f^{ji} as `experts[target][source]`.
    experts: Vec<Vec<KernelSum>>,
}

impl LatentDynamics {
    /// Dynamics of this `order` of parts with `latent` dimensions each; `experts[target][source]` are the weighted predictions
    /// w_{ji} f^{ji}, from histories [p Q_j] to latents `[Q_i]`.
    pub(crate) fn new(order: usize, latent: Vec<usize>, experts: Vec<Vec<KernelSum>>) -> Self {
        Self { order, latent, experts }
    }

    /// The latent path of every part [frames x Q_i]: the `start` [p x Q_i] of each part, then the mean dynamics, all parts
    /// advancing together.
    ///
    /// # Errors
    ///
    /// When the start latents are not p x Q_i numbers for each part.
    pub fn path(&self, start: &[DMatrix<f64>], frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        let p = self.order;
        for (part, &columns) in self.latent.iter().enumerate() {
            let (found_rows, found_columns) = start.get(part).map_or((0, 0), |s| s.shape());
            if (found_rows, found_columns) != (p, columns) {
                return Err(RolloutError::Start { part, rows: p, columns, found_rows, found_columns });
            }
        }
        // One row after the other, so that a history is a slice.
        let mut paths: Vec<Vec<f64>> = Vec::new();
        for (start, q) in start.iter().zip(&self.latent) {
            let mut path = vec![0.0; frames.max(p) * q];
            for (k, value) in path[..p * q].iter_mut().enumerate() {
                *value = start[(k / q, k % q)];
            }
            paths.push(path);
        }
        let widest = self.latent.iter().max().copied().unwrap_or(0);
        let mut scratch = vec![0.0; p * widest];
        let mut next = vec![0.0; widest];
        for t in p..frames {
            for (i, &q) in self.latent.iter().enumerate() {
                let next = &mut next[..q];
                next.fill(0.0);
                for (j, expert) in self.experts[i].iter().enumerate() {
                    let qj = self.latent[j];
                    expert.add_to(&paths[j][(t - p) * qj..t * qj], &mut scratch, next);
                }
                paths[i][t * q..(t + 1) * q].copy_from_slice(next);
            }
        }
        let shapes = paths.iter().zip(&self.latent);
        Ok(shapes.map(|(path, &q)| DMatrix::from_row_slice(frames, q, &path[..frames * q])).collect())
    }
}
