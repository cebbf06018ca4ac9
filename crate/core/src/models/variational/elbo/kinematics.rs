//! The kinematics of one part: the collapsed bound of its pose map.

use crate::gp::NumericsError;
use crate::gp::bound::{InducingPosterior, SparseGp};
use crate::gp::kernel::KernelAdjoint;
use crate::gp::outputs::Outputs;
use crate::gp::psi::{PairWorkspace, PsiAdjoint, PsiStatistics, Purpose};
use crate::gp::stored_outputs::StoredOutputs;
use crate::gp::tall::{add_product, add_tr_product};
use crate::models::variational::elbo::objective::Objective;
use crate::models::variational::params::{Params, PartParams};
use nalgebra::DMatrix;

/// The statistics of the pose map of one part, with memory for its bound and adjoints.
pub struct Kinematics {
    k: DMatrix<f64>,
    statistics: PsiStatistics,
    /// psi1^T Y [L x D].
    b: DMatrix<f64>,
    outputs: Outputs,
    /// dF/db^T [D x L].
    b_adjoint: DMatrix<f64>,
    /// dF/dpsi1 [N x L].
    psi1_adjoint: DMatrix<f64>,
    kernel_adjoint: KernelAdjoint,
}

impl Kinematics {
    pub fn new(objective: &Objective, params: &Params, i: usize) -> Self {
        let (frames, columns) = objective.y[i].shape();
        let (ips, latent) = params.parts[i].r.shape();
        Self {
            k: DMatrix::zeros(ips, ips),
            statistics: PsiStatistics::new(frames, ips, latent),
            b: DMatrix::zeros(ips, columns),
            outputs: objective.outputs(|stored| &stored.kinematics[i], (ips, columns)),
            b_adjoint: DMatrix::zeros(columns, ips),
            psi1_adjoint: DMatrix::zeros(frames, ips),
            kernel_adjoint: KernelAdjoint::zeros(ips, latent),
        }
    }

    /// Computes the statistics of part i.
    pub fn compute(
        &mut self,
        objective: &Objective,
        params: &Params,
        i: usize,
        purpose: Purpose,
        workspace: &mut PairWorkspace,
    ) {
        let part = &params.parts[i];
        part.kernel.inducing_covariance_into(&part.r, objective.jitter, &mut self.k);
        self.statistics.compute(&part.latents, &part.r, &part.kernel, purpose, workspace);
        self.b.fill(0.0);
        add_tr_product(&self.statistics.psi1, &objective.y[i], &mut self.b);
    }

    /// The process and its inducing outputs, borrowed separately.
    fn gp(&mut self, objective: &Objective, params: &Params, i: usize) -> (SparseGp<'_>, &mut Outputs) {
        let gp = SparseGp {
            k: &self.k,
            psi2: &self.statistics.psi2,
            b: &self.b,
            psi0: self.statistics.psi0,
            second_moment: objective.second_moments[i],
            rows: objective.y[i].nrows(),
            noise: params.parts[i].beta,
        };
        (gp, &mut self.outputs)
    }

    /// The bound, in nats.
    pub fn bound(&mut self, objective: &Objective, params: &Params, i: usize) -> Result<f64, NumericsError> {
        let (gp, outputs) = self.gp(objective, params, i);
        outputs.bound(&gp)
    }

    /// q(v).
    pub fn posterior(
        &mut self,
        objective: &Objective,
        params: &Params,
        i: usize,
    ) -> Result<InducingPosterior, NumericsError> {
        self.gp(objective, params, i).0.posterior()
    }

    /// Sum over rows of psi2, from which q(v) is computed.
    pub fn into_psi2(self) -> DMatrix<f64> {
        self.statistics.psi2
    }

    /// The optimal inducing outputs of the pose map, to be stored.
    pub fn stored(
        &mut self,
        objective: &Objective,
        params: &Params,
        i: usize,
    ) -> Result<StoredOutputs, NumericsError> {
        StoredOutputs::best(&self.gp(objective, params, i).0)
    }

    /// The bound, in nats. [`pull_back`](Self::pull_back) then adds its gradient, times the weight of the
    /// pose term in the objective.
    pub fn adjoint(
        &mut self,
        objective: &Objective,
        params: &Params,
        i: usize,
    ) -> Result<f64, NumericsError> {
        let (gp, outputs) = self.gp(objective, params, i);
        let bound = outputs.bound_and_adjoint(&gp)?;
        let factor = objective.pose_factor(params, i);
        if factor != 1.0 {
            outputs.weight_adjoint(factor);
        }
        let (part, adjoint) = (&params.parts[i], self.outputs.adjoint());
        let kernel = &mut self.kernel_adjoint;
        kernel.set_zero();
        part.kernel.inducing_covariance_adjoint(&part.r, &self.k, objective.jitter, &adjoint.k, kernel);
        adjoint.b.transpose_to(&mut self.b_adjoint);
        self.psi1_adjoint.fill(0.0);
        add_product(&objective.y[i], &self.b_adjoint, &mut self.psi1_adjoint);
        Ok(bound)
    }

    /// Adds the gradient of the weighted objective to `into`, that of the `part`; `workspace` is as
    /// [`compute`](Self::compute) left it.
    pub fn pull_back(&mut self, part: &PartParams, workspace: &mut PairWorkspace, into: &mut PartParams) {
        let (adjoint, kernel) = (self.outputs.adjoint(), &mut self.kernel_adjoint);
        into.beta += adjoint.noise;
        let psi = PsiAdjoint { psi0: adjoint.psi0, psi1: &self.psi1_adjoint, psi2: &adjoint.psi2 };
        let inputs = (&part.latents, &part.r, &part.kernel);
        self.statistics.pull_back(inputs, &psi, workspace, &mut into.latents, kernel);
        kernel.add_to(&mut into.r, &mut into.kernel);
    }
}
