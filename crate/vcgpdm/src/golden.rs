//! Golden cases: a problem and a point in its parameter space as one JSON object, in natural parameters, so that another
//! implementation of the bound can be compared number by number or can start from the same place.
//!
//! `input.params.parts[i]` (mu, s, r, kin_lambda, kin_var, beta), `input.params.dyn[j][i]` (z, lambda, var: j predicts i),
//! `input.params.alpha[j][i]`, `input.y[i]` (centred), `input.lengths`, `input.order`, `input.jitter` (absent: 0).

use crate::gp::{Gaussians, Kernel, NumericsError};
use crate::json::rows;
use crate::json::rows::{matrix_from_rows, rows_of};
use crate::models::sequences::MOST_FRAMES;
use crate::models::variational::{
    BoundTerms, Expert, InducingPosterior, Objective, Params, PartParams, Vcgpdm,
};
use crate::models::{Parameters, Reading, RolloutError, Sequences, SequencesError};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Why a case could not be read or evaluated.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CaseError {
    /// Not JSON of the expected form.
    #[error("at {path}: {message}")]
    Form {
        /// The field's path.
        path: String,
        /// What was expected and found.
        message: String,
    },
    /// Shapes that do not fit each other.
    #[error("at {path}: expected {expected}, found {found}")]
    Shape {
        /// The field's path.
        path: String,
        /// What would fit.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// Lengths that cannot be used.
    #[error(transparent)]
    Sequences(#[from] SequencesError),
    /// The bound could not be computed.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
    /// A rollout could not be made.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct PartJson {
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
struct ExpertJson {
    #[serde(with = "rows::matrix")]
    z: DMatrix<f64>,
    #[serde(with = "rows::vector")]
    lambda: DVector<f64>,
    var: f64,
}

/// Parameters, or a gradient, in the form of the golden cases.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct ParamsJson {
    parts: Vec<PartJson>,
    #[serde(rename = "dyn")]
    experts: Vec<Vec<ExpertJson>>,
    #[serde(with = "rows::matrix")]
    alpha: DMatrix<f64>,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct Input {
    params: ParamsJson,
    y: Vec<Vec<Vec<f64>>>,
    lengths: Vec<usize>,
    order: usize,
    #[serde(default, skip_serializing_if = "is_zero")]
    jitter: f64,
}

#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_zero(v: &f64) -> bool {
    *v == 0.0
}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct RolloutJson {
    alpha: Vec<Vec<f64>>,
    x0: Vec<Vec<Vec<f64>>>,
    steps: usize,
    #[serde(default)]
    x: Vec<Vec<Vec<f64>>>,
    #[serde(default)]
    y: Vec<Vec<Vec<f64>>>,
}

#[derive(Debug, Default, Deserialize)]
struct Expected {
    #[serde(default)]
    rollouts: Vec<RolloutJson>,
}

#[derive(Debug, Deserialize)]
struct Document {
    input: Input,
    #[serde(default)]
    expected: Expected,
}

#[derive(Clone, Debug, Serialize)]
struct PosteriorJson {
    #[serde(with = "rows::matrix")]
    mean: DMatrix<f64>,
    #[serde(with = "rows::matrix")]
    cov: DMatrix<f64>,
}

#[derive(Clone, Debug, Serialize)]
struct PosteriorsJson {
    kin: Vec<PosteriorJson>,
    #[serde(rename = "dyn")]
    dynamics: Vec<PosteriorJson>,
}

/// Everything that is expected of a case: serialises in the golden files' own shape.
#[derive(Clone, Debug, Serialize)]
pub struct CaseResult {
    elbo: f64,
    terms: BoundTerms,
    gradient: ParamsJson,
    posterior: PosteriorsJson,
    rollouts: Vec<RolloutJson>,
    /// Median milliseconds of one bound with its gradient, when it was measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub median_ms: Option<f64>,
}

/// A problem, a point in its parameter space, and the rollouts asked for.
#[derive(Clone, Debug)]
pub struct Case {
    /// The parameters.
    pub params: Params,
    /// What the bound is computed on.
    pub objective: Objective,
    rollouts: Vec<RolloutJson>,
}

impl Case {
    /// Reads a golden file, or the `input` of one alone.
    ///
    /// # Errors
    ///
    /// When the text is not a case, shapes do not fit each other, or a variance is not positive.
    pub fn from_json(text: &str) -> Result<Self, CaseError> {
        let mut deserializer = serde_json::Deserializer::from_str(text);
        let document: Document = serde_path_to_error::deserialize(&mut deserializer)
            .map_err(|e| CaseError::Form { path: e.path().to_string(), message: e.inner().to_string() })?;
        let Input { params, y, lengths, order, jitter } = document.input;
        let sequences = Sequences::new(lengths, order)?;
        let y = matrices(&y, "input.y")?;
        let params = params_from_json(params)?;
        check(&params, &y, &sequences, jitter)?;
        Ok(Self {
            params,
            objective: Objective::new(y, sequences, jitter),
            rollouts: document.expected.rollouts,
        })
    }

    /// Writes a problem and a point in its parameter space as a golden file with an `input` only.
    ///
    /// # Errors
    ///
    /// When a number is not finite.
    pub fn write(params: &Params, objective: &Objective) -> Result<String, serde_json::Error> {
        let input = Input {
            params: params_to_json(params),
            y: objective.observations().iter().map(rows_of).collect(),
            lengths: objective.sequences().lengths().to_vec(),
            order: objective.sequences().order(),
            jitter: objective.jitter(),
        };
        serde_json::to_string(&serde_json::json!({ "input": input }))
    }

    /// Bound, terms, gradient, optimal posteriors and the rollouts asked for.
    ///
    /// # Errors
    ///
    /// When the bound is not finite, a covariance cannot be factorised, or a rollout that is asked for cannot be made.
    pub fn evaluate(&self) -> Result<CaseResult, CaseError> {
        let (terms, gradient) = self.objective.terms_and_gradient(&self.params)?;
        // Numbers near the ends of what an f64 holds may give a finite bound whose gradient is not.
        let mut finite = true;
        gradient.visit(&mut |_, values| finite &= values.iter().all(|v| v.is_finite()));
        if !finite {
            return Err(NumericsError::NotFinite { what: "gradient of the bound" }.into());
        }
        let posteriors = self.objective.posteriors(&self.params)?;
        let model = Vcgpdm::fit(&self.objective, &self.params, terms.clone())?;
        let rollouts = self.rollouts.iter().enumerate().map(|(k, asked)| {
            let path = format!("expected.rollouts[{k}]");
            let alpha = matrix(&asked.alpha, &format!("{path}.alpha"))?;
            let x0 = matrices(&asked.x0, &format!("{path}.x0"))?;
            if asked.steps > MOST_FRAMES {
                return Err(CaseError::Shape {
                    path: format!("{path}.steps"),
                    expected: format!("at most {MOST_FRAMES}"),
                    found: asked.steps.to_string(),
                });
            }
            let dynamics = model.dynamics(&alpha, Reading::AsLearned)?;
            let x = dynamics.path(&x0, asked.steps + model.order)?;
            let y = model.observations(&x).iter().map(rows_of).collect();
            Ok(RolloutJson { x: x.iter().map(rows_of).collect(), y, ..asked.clone() })
        });
        let json = |p: &InducingPosterior| PosteriorJson { mean: p.mean.clone(), cov: p.covariance.clone() };
        Ok(CaseResult {
            elbo: terms.total(),
            terms,
            gradient: params_to_json(&gradient),
            posterior: PosteriorsJson {
                kin: posteriors.kinematics.iter().map(json).collect(),
                dynamics: posteriors.dynamics.iter().map(json).collect(),
            },
            rollouts: rollouts.collect::<Result<_, CaseError>>()?,
            median_ms: None,
        })
    }
}

fn matrix(rows: &[Vec<f64>], path: &str) -> Result<DMatrix<f64>, CaseError> {
    matrix_from_rows(rows).map_err(|message| CaseError::Form { path: path.to_owned(), message })
}

fn matrices(all: &[Vec<Vec<f64>>], path: &str) -> Result<Vec<DMatrix<f64>>, CaseError> {
    all.iter().enumerate().map(|(k, rows)| matrix(rows, &format!("{path}[{k}]"))).collect()
}

fn params_from_json(json: ParamsJson) -> Result<Params, CaseError> {
    let parts = json.parts.into_iter().map(|p| PartParams {
        latents: Gaussians { mean: p.mu, variance: p.s },
        r: p.r,
        kernel: Kernel { lambda: p.kin_lambda, variance: p.kin_var },
        beta: p.beta,
    });
    let experts = json.experts.into_iter().map(|row| {
        row.into_iter()
            .map(|e| Expert { z: e.z, kernel: Kernel { lambda: e.lambda, variance: e.var } })
            .collect()
    });
    Ok(Params { parts: parts.collect(), experts: experts.collect(), alpha: vec![json.alpha] })
}

fn params_to_json(params: &Params) -> ParamsJson {
    let part = |p: &PartParams| PartJson {
        mu: p.latents.mean.clone(),
        s: p.latents.variance.clone(),
        r: p.r.clone(),
        kin_lambda: p.kernel.lambda.clone(),
        kin_var: p.kernel.variance,
        beta: p.beta,
    };
    let expert =
        |e: &Expert| ExpertJson { z: e.z.clone(), lambda: e.kernel.lambda.clone(), var: e.kernel.variance };
    ParamsJson {
        parts: params.parts.iter().map(part).collect(),
        experts: params.experts.iter().map(|row| row.iter().map(expert).collect()).collect(),
        alpha: params.alpha[0].clone(),
    }
}

/// Shapes fit each other, and variances are positive.
fn check(params: &Params, y: &[DMatrix<f64>], sequences: &Sequences, jitter: f64) -> Result<(), CaseError> {
    let m = params.parts.len();
    let shape = |path: String, expected: (usize, usize), found: (usize, usize)| {
        if expected == found {
            return Ok(());
        }
        let text = |(r, c)| format!("{r} x {c} numbers");
        Err(CaseError::Shape { path, expected: text(expected), found: text(found) })
    };
    let count = |path: &str, found: usize| {
        let (expected, found) = (format!("{m} (one for each part)"), found.to_string());
        Err(CaseError::Shape { path: path.to_owned(), expected, found })
    };
    let positive = |path: String, values: &[f64]| match values.iter().find(|v| v.is_nan() || **v <= 0.0) {
        None => Ok(()),
        Some(v) => Err(CaseError::Shape { path, expected: "positive numbers".into(), found: v.to_string() }),
    };
    if m == 0 {
        let (expected, found) = ("at least one part".into(), "none".into());
        return Err(CaseError::Shape { path: "input.params.parts".into(), expected, found });
    }
    if y.len() != m {
        return count("input.y", y.len());
    }
    if params.experts.len() != m {
        return count("input.params.dyn", params.experts.len());
    }
    shape("input.params.alpha".into(), (m, m), params.alpha[0].shape())?;
    positive("input.params.alpha".into(), params.alpha[0].as_slice())?;
    if !(0.0..1.0).contains(&jitter) {
        let (expected, found) = ("a jitter from 0 to 1".into(), jitter.to_string());
        return Err(CaseError::Shape { path: "input.jitter".into(), expected, found });
    }
    let n = sequences.frames();
    for (i, part) in params.parts.iter().enumerate() {
        let at = |name: &str| format!("input.params.parts[{i}].{name}");
        let q = part.latents.mean.ncols();
        shape(at("mu"), (n, q.max(1)), part.latents.mean.shape())?;
        shape(at("s"), (n, q), part.latents.variance.shape())?;
        shape(at("r"), (part.r.nrows().max(1), q), part.r.shape())?;
        shape(at("kin_lambda"), (q, 1), part.kernel.lambda.shape())?;
        shape(format!("input.y[{i}]"), (n, y[i].ncols().max(1)), y[i].shape())?;
        positive(at("s"), part.latents.variance.as_slice())?;
        positive(at("kin_lambda"), part.kernel.lambda.as_slice())?;
        positive(at("kin_var"), &[part.kernel.variance])?;
        positive(at("beta"), &[part.beta])?;
        if params.experts[i].len() != m {
            return count(&format!("input.params.dyn[{i}]"), params.experts[i].len());
        }
        for (target, expert) in params.experts[i].iter().enumerate() {
            let at = |name: &str| format!("input.params.dyn[{i}][{target}].{name}");
            let dims = sequences.order() * q;
            shape(at("z"), (expert.z.nrows().max(1), dims), expert.z.shape())?;
            shape(at("lambda"), (dims, 1), expert.kernel.lambda.shape())?;
            positive(at("lambda"), expert.kernel.lambda.as_slice())?;
            if expert.kernel.variance != 1.0 {
                let (expected, found) = ("1 (it is fixed)".into(), expert.kernel.variance.to_string());
                return Err(CaseError::Shape { path: at("var"), expected, found });
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::variational::testing::random_case;
    use approx::assert_relative_eq;

    #[test]
    fn a_written_start_reads_back() {
        let (params, objective) = random_case(3);
        let case = Case::from_json(&Case::write(&params, &objective).unwrap()).unwrap();
        assert_eq!(case.params, params);
        let again = case.objective.terms(&case.params).unwrap().total();
        assert_relative_eq!(again, objective.terms(&params).unwrap().total());
    }

    #[test]
    fn wrong_shapes_are_refused_with_their_path() {
        let (params, objective) = random_case(1);
        let text = Case::write(&params, &objective).unwrap();
        let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
        value["input"]["params"]["parts"][1]["kin_lambda"] = serde_json::json!([1.0]);
        let error = Case::from_json(&value.to_string()).unwrap_err().to_string();
        assert_eq!(error, "at input.params.parts[1].kin_lambda: expected 3 x 1 numbers, found 1 x 1 numbers");
        value["input"]["params"]["parts"][1]["kin_lambda"] = serde_json::json!("wide");
        let error = Case::from_json(&value.to_string()).unwrap_err().to_string();
        assert!(error.starts_with("at input.params.parts[1].kin_lambda: invalid type: string"), "{error}");
    }

    #[test]
    fn what_would_not_fit_the_memory_or_has_no_columns_is_refused() {
        let (params, objective) = random_case(1);
        let mut value: serde_json::Value =
            serde_json::from_str(&Case::write(&params, &objective).unwrap()).unwrap();
        let start = |part: &PartParams| rows_of(&part.latents.mean.rows(0, 2).into_owned());
        let x0: Vec<_> = params.parts.iter().map(start).collect();
        for steps in [1_000_000_000_000_000, u64::MAX / 2, u64::MAX] {
            let rollout = serde_json::json!({ "alpha": rows_of(&params.alpha[0]), "x0": x0, "steps": steps });
            value["expected"] = serde_json::json!({ "rollouts": [rollout] });
            let error = Case::from_json(&value.to_string()).unwrap().evaluate().unwrap_err().to_string();
            let expected = format!("at expected.rollouts[0].steps: expected at most 1000000, found {steps}");
            assert_eq!(error, expected);
        }
        for row in value["input"]["y"][0].as_array_mut().unwrap() {
            *row = serde_json::json!([]);
        }
        let error = Case::from_json(&value.to_string()).unwrap_err().to_string();
        assert!(error.starts_with("at input.y[0]: expected "), "{error}");
    }
}
