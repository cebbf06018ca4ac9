//! The JSON of golden cases, and its conversion to parameters and back.

use crate::golden::error::CaseError;
use crate::golden::rows;
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};
use vcgpdm_core::gp::bound::InducingPosterior;
use vcgpdm_core::gp::{Gaussians, Kernel};
use vcgpdm_core::json::rows::matrix_from_rows;
use vcgpdm_core::models::variational::{BoundTerms, Expert, Params, PartParams};

#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct PartJson {
    #[serde(with = "rows::matrix")]
    mu: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    s: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    r: DMatrix<f64>,
    #[serde(with = "rows::vector")]
    kin_lambda: DVector<f64>,
    kin_var: f64,
    beta: f64,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct ExpertJson {
    #[serde(with = "rows::matrix")]
    z: DMatrix<f64>,
    #[serde(with = "rows::vector")]
    lambda: DVector<f64>,
    var: f64,
}

/// One matrix for a plain model, otherwise one for each movement.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
enum AlphaJson {
    Plain(#[serde(with = "rows::matrix")] DMatrix<f64>),
    Movements(Vec<Vec<Vec<f64>>>),
}

/// A gradient, or the parameters of a plain model.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ParamsJson {
    parts: Vec<PartJson>,
    #[serde(rename = "dyn")]
    experts: Vec<Vec<ExpertJson>>,
    alpha: AlphaJson,
}

/// The gradient of a case.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub(super) enum GradientJson {
    Whole(ParamsJson),
    /// With respect to latents, couplings and the experts of new primitives.
    Stored {
        #[serde(flatten)]
        given: GivenGradientJson,
        #[serde(rename = "dyn")]
        experts: Vec<Vec<ExpertJson>>,
    },
}

impl GradientJson {
    /// The gradient if this number of first primitives is stored.
    pub fn stored(gradient: &Params, stored: usize) -> Self {
        let experts = gradient.experts.iter().skip(stored);
        let experts = experts.map(|row| row.iter().map(ExpertJson::from).collect()).collect();
        Self::Stored { given: GivenGradientJson::from(gradient), experts }
    }
}

/// The gradient with stored inducing outputs: with respect to latents and couplings.
#[derive(Clone, Debug, Serialize)]
pub(super) struct GivenGradientJson {
    parts: Vec<LatentsJson>,
    alpha: Vec<Vec<Vec<f64>>>,
}

#[derive(Clone, Debug, Serialize)]
struct LatentsJson {
    #[serde(with = "rows::matrix")]
    mu: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    s: DMatrix<f64>,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct RolloutJson {
    pub alpha: Vec<Vec<f64>>,
    pub x0: Vec<Vec<Vec<f64>>>,
    pub steps: usize,
    #[serde(default)]
    pub x: Vec<Vec<Vec<f64>>>,
    #[serde(default)]
    pub y: Vec<Vec<Vec<f64>>>,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct PosteriorJson {
    #[serde(with = "rows::matrix")]
    mean: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    cov: DMatrix<f64>,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct PosteriorsJson {
    pub kin: Vec<PosteriorJson>,
    #[serde(rename = "dyn")]
    pub dynamics: Vec<PosteriorJson>,
}

/// All numbers of a case, in the form of golden files.
#[derive(Clone, Debug, Serialize)]
pub struct CaseResult {
    pub(super) elbo: f64,
    pub(super) terms: BoundTerms,
    pub(super) gradient: GradientJson,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) posterior: Option<PosteriorsJson>,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub(super) further: Option<Further>,
    /// Median milliseconds of one bound with its gradient, when it was measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub median_ms: Option<f64>,
}

/// The numbers that only cases of one form have.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub(super) enum Further {
    Plain {
        rollouts: Vec<RolloutJson>,
    },
    /// The bound of the same movements with their optimal inducing outputs fixed.
    Movements {
        elbo_given: f64,
        gradient_given: GivenGradientJson,
    },
}

/// Returns an error for a matrix of another shape.
pub(super) fn shape(path: String, expected: (usize, usize), found: (usize, usize)) -> Result<(), CaseError> {
    if expected == found {
        return Ok(());
    }
    let text = |(r, c)| format!("{r} x {c} numbers");
    Err(CaseError::Shape { path, expected: text(expected), found: text(found) })
}

pub(super) fn matrix(rows: &[Vec<f64>], path: &str) -> Result<DMatrix<f64>, CaseError> {
    matrix_from_rows(rows).map_err(|message| CaseError::Form { path: path.to_owned(), message })
}

pub(super) fn matrices(all: &[Vec<Vec<f64>>], path: &str) -> Result<Vec<DMatrix<f64>>, CaseError> {
    all.iter().enumerate().map(|(k, rows)| matrix(rows, &format!("{path}[{k}]"))).collect()
}

impl From<PartJson> for PartParams {
    fn from(p: PartJson) -> Self {
        Self {
            latents: Gaussians { mean: p.mu, variance: p.s },
            r: p.r,
            kernel: Kernel { lambda: p.kin_lambda, variance: p.kin_var },
            beta: p.beta,
        }
    }
}

impl From<&PartParams> for PartJson {
    fn from(p: &PartParams) -> Self {
        Self {
            mu: p.latents.mean.clone(),
            s: p.latents.variance.clone(),
            r: p.r.clone(),
            kin_lambda: p.kernel.lambda.clone(),
            kin_var: p.kernel.variance,
            beta: p.beta,
        }
    }
}

impl From<ExpertJson> for Expert {
    fn from(e: ExpertJson) -> Self {
        Self { z: e.z, kernel: Kernel { lambda: e.lambda, variance: e.var } }
    }
}

impl From<&Expert> for ExpertJson {
    fn from(e: &Expert) -> Self {
        Self { z: e.z.clone(), lambda: e.kernel.lambda.clone(), var: e.kernel.variance }
    }
}

impl From<&InducingPosterior> for PosteriorJson {
    fn from(p: &InducingPosterior) -> Self {
        Self { mean: p.mean.clone(), cov: p.covariance.clone() }
    }
}

impl ParamsJson {
    fn new(params: &Params, alpha: AlphaJson) -> Self {
        let experts = params.experts.iter().map(|row| row.iter().map(ExpertJson::from).collect());
        Self { parts: params.parts.iter().map(PartJson::from).collect(), experts: experts.collect(), alpha }
    }

    /// The parameters of a plain model, with one matrix alpha.
    pub fn plain(params: &Params) -> Self {
        Self::new(params, AlphaJson::Plain(params.alpha.first().cloned().unwrap_or_default()))
    }

    /// The parameters with one matrix alpha for each movement.
    pub fn of_movements(params: &Params) -> Self {
        Self::new(params, AlphaJson::Movements(alpha_rows(params)))
    }
}

impl From<&Params> for GivenGradientJson {
    fn from(params: &Params) -> Self {
        let parts = params
            .parts
            .iter()
            .map(|part| LatentsJson { mu: part.latents.mean.clone(), s: part.latents.variance.clone() });
        Self { parts: parts.collect(), alpha: alpha_rows(params) }
    }
}

fn alpha_rows(params: &Params) -> Vec<Vec<Vec<f64>>> {
    params.alpha.iter().map(rows::rows_of).collect()
}
