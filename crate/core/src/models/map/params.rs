//! Parameters of a GPDM or CGPDM with point latents.

use crate::gp::Kernel;
use crate::models::search::parameters::{ALPHA, BETA, Kind, LAMBDA, MU, Parameters, SIGNAL};
use nalgebra::DMatrix;
use std::slice::{from_mut, from_ref};

/// The parameters of one part: its latents and its map from latents to poses.
#[derive(Clone, Debug, PartialEq)]
pub struct MapPart {
    /// x^i [N x Q_i].
    pub latents: DMatrix<f64>,
    /// The kernel of the pose map.
    pub kernel: Kernel,
    /// Observation noise variance beta.
    pub beta: f64,
}

/// All parameters, in natural units. A gradient has the same type.
#[derive(Clone, Debug, PartialEq)]
pub struct MapParams {
    /// The parameters of each part `[M]`.
    pub parts: Vec<MapPart>,
    /// Kernels of the dynamics by source and target: `dynamics[j][i]` is that of j's prediction about i.
    /// Their signal variance is 1, because the scale of a function and its coupling weight could otherwise
    /// compensate each other.
    pub dynamics: Vec<Vec<Kernel>>,
    /// Variances theta of the linear term theta x_{-t} . x_{-t'} of each kernel of the dynamics (Wang et al.
    /// 2008, 10) [M x M], row the source, column the target; [0 x 0]: no linear term.
    pub linear: DMatrix<f64>,
    /// Coupling variances alpha [M x M], row the source, column the target.
    pub alpha: DMatrix<f64>,
}

impl MapParams {
    /// Number of parts M.
    pub fn part_count(&self) -> usize {
        self.parts.len()
    }

    /// theta of part j's prediction about part i; `None` without linear terms.
    pub fn linear_term(&self, j: usize, i: usize) -> Option<f64> {
        self.linear.get((j, i)).copied()
    }

    /// The same shapes, all entries zero.
    pub fn zeros_like(&self) -> MapParams {
        let mut zeros = self.clone();
        zeros.visit_mut(&mut |_, values| values.fill(0.0));
        for kernel in zeros.dynamics.iter_mut().flatten() {
            kernel.variance = 0.0;
        }
        zeros
    }
}

impl Parameters for MapParams {
    fn visit<'a>(&'a self, f: &mut dyn FnMut(Kind, &'a [f64])) {
        for part in &self.parts {
            f(MU, part.latents.as_slice());
            f(LAMBDA, part.kernel.lambda.as_slice());
            f(SIGNAL, from_ref(&part.kernel.variance));
            f(BETA, from_ref(&part.beta));
        }
        for kernel in self.dynamics.iter().flatten() {
            f(LAMBDA, kernel.lambda.as_slice());
        }
        f(SIGNAL, self.linear.as_slice());
        f(ALPHA, self.alpha.as_slice());
    }

    fn visit_mut(&mut self, f: &mut dyn FnMut(Kind, &mut [f64])) {
        for part in &mut self.parts {
            f(MU, part.latents.as_mut_slice());
            f(LAMBDA, part.kernel.lambda.as_mut_slice());
            f(SIGNAL, from_mut(&mut part.kernel.variance));
            f(BETA, from_mut(&mut part.beta));
        }
        for kernel in self.dynamics.iter_mut().flatten() {
            f(LAMBDA, kernel.lambda.as_mut_slice());
        }
        f(SIGNAL, self.linear.as_mut_slice());
        f(ALPHA, self.alpha.as_mut_slice());
    }
}
