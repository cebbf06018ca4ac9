//! The evidence lower bound of the vCGPDM and its gradient (Velychko et al. 2018, appendix C).
//!
//! ELBO = sum_i kinematics_i + sum_i dynamics_i + initial + entropy. Each GP term is the collapsed bound of
//! [`crate::gp::bound`] fed with the statistics of [`crate::gp::psi`]; the gradient is the backward pass
//! through both.

mod dynamics;
mod kinematics;
mod objective;
mod rows;
mod sums;
#[cfg(feature = "threads")]
mod threads;

use crate::elementary::Elementary;
use crate::gp::bound::InducingPosterior;
use crate::gp::psi::{PairWorkspace, Purpose};
use crate::gp::{Gaussians, NumericsError};
use crate::models::training::progress::BoundTerms;
use crate::models::variational::params::Params;
use dynamics::Dynamics;
use kinematics::Kinematics;
use nalgebra::DMatrix;
pub use objective::{Objective, StoredMaps};
use std::f64::consts::TAU;
pub use sums::{DynamicsSums, stack_offsets};

/// The optimal posteriors of all inducing outputs.
#[derive(Clone, Debug)]
pub struct Posteriors {
    /// q(v^i) `[M]`.
    pub kinematics: Vec<InducingPosterior>,
    /// q(u) into each target, the experts of all primitives stacked in order `[M]`.
    pub dynamics: Vec<InducingPosterior>,
    /// The sums from which q(u) was computed, `sums[movement][target]`, the primitives of the movement
    /// stacked in the order of their parts.
    pub sums: Vec<Vec<DynamicsSums>>,
    /// Sum over rows of psi2 of each pose map [L_i x L_i] `[M]`, from which q(v) was computed.
    pub pose_sums: Vec<DMatrix<f64>>,
}

/// Memory for the bound and its gradient: an evaluation allocates nothing.
pub struct Workspace {
    terms: BoundTerms,
    gradient: Params,
    /// The histories of each movement and part.
    histories: Vec<Vec<Gaussians>>,
    histories_adjoint: Vec<Vec<Gaussians>>,
    kinematics: Vec<Kinematics>,
    dynamics: Vec<Dynamics>,
    /// One for all parts in turn; with several threads one for each part.
    workspaces: Vec<PairWorkspaces>,
    #[cfg(feature = "threads")]
    threads: usize,
}

/// Memory for the terms of psi2 of the maps of one part.
struct PairWorkspaces {
    pose: PairWorkspace,
    /// One for each movement and source.
    dynamics: Vec<Vec<PairWorkspace>>,
}

impl PairWorkspaces {
    fn new(movements: usize, sources: usize) -> Self {
        let for_sources = || (0..sources).map(|_| PairWorkspace::default()).collect();
        Self { pose: PairWorkspace::default(), dynamics: (0..movements).map(|_| for_sources()).collect() }
    }
}

impl Workspace {
    /// The terms of the last bound.
    pub fn terms(&self) -> &BoundTerms {
        &self.terms
    }

    /// The last gradient of the objective, with respect to the natural parameters. It has entries for the signal variances of
    /// the dynamics kernels, though these are fixed at 1.
    pub fn gradient(&self) -> &Params {
        &self.gradient
    }
}

impl Objective {
    /// Memory for the bound of parameters with the shapes of `params`.
    pub fn workspace(&self, params: &Params) -> Workspace {
        let movements = || self.repertoire.movements().iter();
        let histories = |rows: usize| {
            let dims = params.parts.iter().map(|part| self.sequences().order() * part.latents.mean.ncols());
            dims.map(|dims| Gaussians::zeros(rows, dims)).collect()
        };
        let histories = || movements().map(|m| histories(m.sequences().transitions())).collect();
        let m = params.part_count();
        Workspace {
            terms: BoundTerms {
                kinematics: vec![0.0; m],
                dynamics: vec![0.0; m],
                initial: 0.0,
                entropy: 0.0,
            },
            gradient: params.zeros_like(),
            histories: histories(),
            histories_adjoint: histories(),
            kinematics: (0..m).map(|i| Kinematics::new(self, params, i)).collect(),
            dynamics: (0..m).map(|i| Dynamics::new(self, params, i)).collect(),
            workspaces: vec![PairWorkspaces::new(movements().len(), m)],
            #[cfg(feature = "threads")]
            threads: 1,
        }
    }

    /// Computes the terms of the bound at `params`, then [`Workspace::terms`].
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised, or the bound is not finite.
    pub fn compute(&self, params: &Params, workspace: &mut Workspace) -> Result<(), NumericsError> {
        let Workspace { terms, histories, kinematics, dynamics, workspaces, .. } = workspace;
        let PairWorkspaces { pose: pose_workspace, dynamics: workspaces } = &mut workspaces[0];
        self.begin(params, histories, terms);
        for (i, (kinematics, dynamics)) in kinematics.iter_mut().zip(dynamics).enumerate() {
            kinematics.compute(self, params, i, Purpose::Value, pose_workspace);
            terms.kinematics[i] = kinematics.bound(self, params, i)?;
            dynamics.compute(self, params, histories, Purpose::Value, workspaces);
            terms.dynamics[i] = dynamics.bound()?;
        }
        finite(terms)
    }

    /// Computes the terms of the bound at `params` and the gradient of the objective, then [`Workspace::terms`]
    /// and [`Workspace::gradient`].
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised, or the bound is not finite.
    pub fn compute_with_gradient(
        &self,
        params: &Params,
        workspace: &mut Workspace,
    ) -> Result<(), NumericsError> {
        workspace.gradient.set_zero();
        workspace.histories_adjoint.iter_mut().flatten().for_each(Gaussians::set_zero);
        self.begin(params, &mut workspace.histories, &mut workspace.terms);
        self.free_gradient(params, &mut workspace.gradient);
        self.add_maps(params, workspace)?;
        let Workspace { terms, gradient, histories_adjoint, .. } = workspace;
        for (movement, adjoints) in self.repertoire.movements().iter().zip(histories_adjoint) {
            for (part, adjoint) in gradient.parts.iter_mut().zip(adjoints) {
                movement.sequences().add_histories_adjoint(adjoint, &mut part.latents);
            }
        }
        finite(terms)
    }

    /// Computes the terms of all maps and adds their gradient; that with respect to the histories is
    /// separate.
    fn add_maps(&self, params: &Params, workspace: &mut Workspace) -> Result<(), NumericsError> {
        #[cfg(feature = "threads")]
        if workspace.threads > 1 {
            return self.add_maps_in_threads(params, workspace);
        }
        let Workspace {
            terms, gradient, histories, histories_adjoint, kinematics, dynamics, workspaces, ..
        } = workspace;
        let PairWorkspaces { pose: pose_workspace, dynamics: workspaces } = &mut workspaces[0];
        for (i, (kinematics, dynamics)) in kinematics.iter_mut().zip(dynamics).enumerate() {
            kinematics.compute(self, params, i, Purpose::Gradient, pose_workspace);
            terms.kinematics[i] = kinematics.adjoint(self, params, i)?;
            kinematics.pull_back(&params.parts[i], pose_workspace, &mut gradient.parts[i]);
            dynamics.compute(self, params, histories, Purpose::Gradient, workspaces);
            terms.dynamics[i] = dynamics.adjoint(self, params)?;
            dynamics.pull_back(params, histories, workspaces, histories_adjoint);
            dynamics.add_gradient(self, params, gradient);
        }
        Ok(())
    }

    /// The terms of the bound at `params`.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised, or the bound is not finite.
    pub fn terms(&self, params: &Params) -> Result<BoundTerms, NumericsError> {
        let mut workspace = self.workspace(params);
        self.compute(params, &mut workspace)?;
        Ok(workspace.terms)
    }

    /// The terms of the bound at `params` and the gradient of the objective, as [`Workspace::gradient`].
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised, or the bound is not finite.
    pub fn terms_and_gradient(&self, params: &Params) -> Result<(BoundTerms, Params), NumericsError> {
        let mut workspace = self.workspace(params);
        self.compute_with_gradient(params, &mut workspace)?;
        Ok((workspace.terms, workspace.gradient))
    }

    /// The optimal posteriors at `params`.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn posteriors(&self, params: &Params) -> Result<Posteriors, NumericsError> {
        let Workspace { mut terms, mut histories, kinematics, dynamics, mut workspaces, .. } =
            self.workspace(params);
        let PairWorkspaces { pose: pose_workspace, dynamics: workspaces } = &mut workspaces[0];
        let movements = self.repertoire.movements().len();
        self.begin(params, &mut histories, &mut terms);
        let mut out = Posteriors {
            kinematics: Vec::new(),
            dynamics: Vec::new(),
            sums: vec![Vec::new(); movements],
            pose_sums: Vec::new(),
        };
        for (i, (mut kinematics, mut dynamics)) in kinematics.into_iter().zip(dynamics).enumerate() {
            kinematics.compute(self, params, i, Purpose::Value, pose_workspace);
            out.kinematics.push(kinematics.posterior(self, params, i)?);
            out.pose_sums.push(kinematics.into_psi2());
            dynamics.compute(self, params, &histories, Purpose::Value, workspaces);
            out.dynamics.push(dynamics.posterior()?);
            for (movement_sums, sums) in out.sums.iter_mut().zip(dynamics.into_sums()) {
                movement_sums.push(sums);
            }
        }
        Ok(out)
    }

    /// The optimal inducing outputs of all maps at `params`, for the bound of other movements: see
    /// [`under`](Self::under).
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn stored(&self, params: &Params) -> Result<StoredMaps, NumericsError> {
        let Workspace { mut terms, mut histories, kinematics, dynamics, mut workspaces, .. } =
            self.workspace(params);
        let PairWorkspaces { pose: pose_workspace, dynamics: workspaces } = &mut workspaces[0];
        self.begin(params, &mut histories, &mut terms);
        let mut out = StoredMaps { kinematics: Vec::new(), dynamics: Vec::new() };
        for (i, (mut kinematics, mut dynamics)) in kinematics.into_iter().zip(dynamics).enumerate() {
            kinematics.compute(self, params, i, Purpose::Value, pose_workspace);
            out.kinematics.push(kinematics.stored(self, params, i)?);
            dynamics.compute(self, params, &histories, Purpose::Value, workspaces);
            out.dynamics.push(dynamics.stored()?);
        }
        Ok(out)
    }

    /// Computes the histories and the terms without a GP: the prior of the initial states and the entropy.
    fn begin(&self, params: &Params, histories: &mut [Vec<Gaussians>], terms: &mut BoundTerms) {
        for (movement, histories) in self.repertoire.movements().iter().zip(histories) {
            for (part, histories) in params.parts.iter().zip(histories) {
                movement.sequences().histories_into(&part.latents, histories);
            }
        }
        (terms.initial, terms.entropy) = (0.0, 0.0);
        for part in &params.parts {
            let Gaussians { mean, variance } = &part.latents;
            terms.entropy +=
                0.5 * ((TAU.logarithm() + 1.0) * variance.len() as f64 + sum_of_logarithms(variance));
            for t in self.sequences().initial_frames() {
                for q in 0..mean.ncols() {
                    terms.initial -= 0.5 * (TAU.logarithm() + mean[(t, q)].powi(2) + variance[(t, q)]);
                }
            }
        }
    }

    /// Adds the gradient of the terms without a GP.
    fn free_gradient(&self, params: &Params, gradient: &mut Params) {
        for (part, into) in params.parts.iter().zip(&mut gradient.parts) {
            let Gaussians { mean, variance } = &part.latents;
            let into = &mut into.latents;
            into.variance.zip_apply(variance, |g, s| *g += 0.5 / s);
            for t in self.sequences().initial_frames() {
                for q in 0..mean.ncols() {
                    into.mean[(t, q)] -= mean[(t, q)];
                    into.variance[(t, q)] -= 0.5;
                }
            }
        }
    }
}

/// The sum of the logarithms of positive numbers. Eight numbers need one logarithm, that of their product, if
/// this is a normal number.
fn sum_of_logarithms(values: &DMatrix<f64>) -> f64 {
    let logarithm = |chunk: &[f64]| {
        let product: f64 = chunk.iter().product();
        if product.is_normal() { product.logarithm() } else { chunk.iter().map(|v| v.logarithm()).sum() }
    };
    values.as_slice().chunks(8).map(logarithm).sum()
}

fn finite(terms: &BoundTerms) -> Result<(), NumericsError> {
    if terms.total().is_finite() { Ok(()) } else { Err(NumericsError::NotFinite { what: "bound" }) }
}

#[cfg(test)]
mod tests;
