//! The named parameters of the vCGPDM.

use crate::gp::{Gaussians, Kernel};
use crate::models::search::parameters::{ALPHA, BETA, IPS, Kind, LAMBDA, MU, Parameters, S, SIGNAL};
use nalgebra::DMatrix;
use std::ops::Range;
use std::slice::{from_mut, from_ref};

/// The parameters of one part: its latents and its map from latents to poses.
#[derive(Clone, Debug, PartialEq)]
pub struct PartParams {
    /// q(x^i): means mu and diagonal variances S [N x Q_i].
    pub latents: Gaussians,
    /// Pose inducing inputs r [L_i x Q_i].
    pub r: DMatrix<f64>,
    /// The kernel of the pose map.
    pub kernel: Kernel,
    /// Observation noise variance beta.
    pub beta: f64,
}

/// The parameters of f^{ji}, the prediction of a source part j about a target part i.
#[derive(Clone, Debug, PartialEq)]
pub struct Expert {
    /// Dynamics inducing inputs z [K x pQ_j].
    pub z: DMatrix<f64>,
    /// Its kernel; the signal variance is 1.
    pub kernel: Kernel,
}

/// All parameters of a vCGPDM, in natural units (variances are variances, lengthscales are squared).
///
/// A gradient has the same type, entry by entry.
#[derive(Clone, Debug, PartialEq)]
pub struct Params {
    /// The parameters of each part `[M]`.
    pub parts: Vec<PartParams>,
    /// Experts by primitive and target: `experts[a][i]` is the prediction of primitive a about part i. In the
    /// plain model each part has one primitive, and `experts[j][i]` is j's prediction about i.
    pub experts: Vec<Vec<Expert>>,
    /// Coupling variances alpha of each movement [M x M], row the source, column the target; the plain model
    /// has one movement.
    pub alpha: Vec<DMatrix<f64>>,
}

impl Params {
    /// Number of parts M.
    pub fn part_count(&self) -> usize {
        self.parts.len()
    }

    /// The latent means of each part in these frames of the stack [T x Q_i] `[M]`.
    pub(in crate::models) fn latent_means(&self, frames: &Range<usize>) -> Vec<DMatrix<f64>> {
        let means = self.parts.iter().map(|part| &part.latents.mean);
        means.map(|x| x.rows(frames.start, frames.len()).into_owned()).collect()
    }

    /// The same shapes, all entries zero.
    pub fn zeros_like(&self) -> Params {
        let mut zeros = self.clone();
        zeros.set_zero();
        zeros
    }

    /// Sets all entries to zero.
    pub fn set_zero(&mut self) {
        self.visit_mut(&mut |_, values| values.fill(0.0));
        for expert in self.experts.iter_mut().flatten() {
            expert.kernel.variance = 0.0;
        }
    }
}

impl Parameters for Params {
    fn visit<'a>(&'a self, f: &mut dyn FnMut(Kind, &'a [f64])) {
        for part in &self.parts {
            f(MU, part.latents.mean.as_slice());
            f(S, part.latents.variance.as_slice());
            f(IPS, part.r.as_slice());
            f(LAMBDA, part.kernel.lambda.as_slice());
            f(SIGNAL, from_ref(&part.kernel.variance));
            f(BETA, from_ref(&part.beta));
        }
        for expert in self.experts.iter().flatten() {
            f(IPS, expert.z.as_slice());
            f(LAMBDA, expert.kernel.lambda.as_slice());
        }
        for alpha in &self.alpha {
            f(ALPHA, alpha.as_slice());
        }
    }

    fn visit_mut(&mut self, f: &mut dyn FnMut(Kind, &mut [f64])) {
        for part in &mut self.parts {
            f(MU, part.latents.mean.as_mut_slice());
            f(S, part.latents.variance.as_mut_slice());
            f(IPS, part.r.as_mut_slice());
            f(LAMBDA, part.kernel.lambda.as_mut_slice());
            f(SIGNAL, from_mut(&mut part.kernel.variance));
            f(BETA, from_mut(&mut part.beta));
        }
        for expert in self.experts.iter_mut().flatten() {
            f(IPS, expert.z.as_mut_slice());
            f(LAMBDA, expert.kernel.lambda.as_mut_slice());
        }
        for alpha in &mut self.alpha {
            f(ALPHA, alpha.as_mut_slice());
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::models::search::parameters::Parameters;
    use crate::models::variational::testing::random_case;
    use approx::assert_relative_eq;

    #[test]
    fn flat_vector_and_back() {
        let (params, ..) = random_case(3);
        let flat = params.to_flat();
        let mut back = params.zeros_like();
        for expert in back.experts.iter_mut().flatten() {
            expert.kernel.variance = 1.0;
        }
        back.set_flat(&flat);
        assert_relative_eq!(back.alpha[0], params.alpha[0], max_relative = 1e-14);
        for (a, b) in back.parts.iter().zip(&params.parts) {
            assert_relative_eq!(a.latents.mean, b.latents.mean);
            assert_relative_eq!(a.latents.variance, b.latents.variance, max_relative = 1e-14);
        }
        assert_eq!(flat.len(), params.flat_kinds().len());
    }

    #[test]
    fn values_outside_their_box_move_to_its_edge() {
        let (mut params, ..) = random_case(0);
        params.alpha[0][(0, 0)] = 1e9;
        params.parts[0].latents.mean[(0, 0)] = -50.0;
        let flat = params.to_flat();
        assert_eq!(flat[0], -10.0);
        params.set_flat(&flat);
        assert_eq!(params.alpha[0][(0, 0)], 10.0);
    }

    #[test]
    fn flat_entries_lie_in_their_flat_boxes_and_reach_both_ends() {
        let (mut params, ..) = random_case(0);
        let boxes: Vec<(f64, f64)> = params.flat_kinds().iter().map(|kind| kind.flat_box()).collect();
        let inside = |flat: &[f64]| flat.iter().zip(&boxes).all(|(x, (low, high))| (low..=high).contains(&x));
        assert!(inside(&params.to_flat()));
        for end in [boxes.iter().map(|b| b.0).collect::<Vec<f64>>(), boxes.iter().map(|b| b.1).collect()] {
            params.set_flat(&end);
            let back = params.to_flat();
            assert!(inside(&back));
            for (a, b) in back.iter().zip(&end) {
                assert_relative_eq!(a, b, max_relative = 1e-12);
            }
        }
    }
}
