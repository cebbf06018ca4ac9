//! Golden cases: data and natural parameters as one JSON object. Another implementation of the bound can
//! compare its numbers with a case, or start from the same point.
//!
//! `input.params.parts[i]` (mu, s, r, kin_lambda, kin_var, beta), `input.params.dyn[j][i]` (z, lambda, var: j
//! predicts i), `input.params.alpha[j][i]`, `input.y[i]` (centred), `input.lengths`, `input.order`,
//! `input.jitter` (absent: 0).
//!
//! For movements that share primitives: `input.movements[m]` (lengths, uses: the primitive of each part)
//! instead of the lengths, `input.params.primitives[a]` (part, dyn\[i\]) instead of `dyn`, and
//! `input.params.alpha[m][j][i]`; the frames of all movements are stacked.
//!
//! For new primitives together with stored ones: movements with `input.stored`. It has the number of first
//! `primitives` that stay unchanged, and the mean and cov of the inducing outputs of the pose maps (`kin[i]`)
//! and of the stored primitives' experts for each part, stacked (`dyn[i]`).

mod error;
mod input;
mod rows;
mod shapes;
mod stored;

use crate::golden::input::{CaseSort, Input};
use crate::golden::rows::rows_of;
use crate::golden::shapes::{
    Further, GivenGradientJson, GradientJson, ParamsJson, PosteriorJson, PosteriorsJson, RolloutJson,
    matrices, matrix,
};
pub use error::CaseError;
pub use shapes::CaseResult;
use vcgpdm_core::gp::NumericsError;
use vcgpdm_core::models::MOST_FRAMES;
use vcgpdm_core::models::variational::{BoundTerms, Objective, Params, Vcgpdm};
use vcgpdm_core::models::{Parameters, Reading};

/// Data, parameters, and the rollouts to make.
#[derive(Clone, Debug)]
pub struct Case {
    /// The parameters.
    pub params: Params,
    /// The bound with its data.
    pub objective: Objective,
    rollouts: Vec<RolloutJson>,
    sort: CaseSort,
}

impl Case {
    /// Reads a golden file, or only its `input`.
    ///
    /// # Errors
    ///
    /// When the text is not a case, the shapes do not agree, or a variance is not positive.
    pub fn from_json(text: &str) -> Result<Self, CaseError> {
        let Input { params, objective, rollouts, sort } = Input::from_json(text)?;
        Ok(Self { params, objective, rollouts, sort })
    }

    /// Writes data and parameters of a plain model as a golden file that only has an `input`.
    ///
    /// # Errors
    ///
    /// When a number is not finite.
    pub fn write(params: &Params, objective: &Objective) -> Result<String, serde_json::Error> {
        let y: Vec<_> = objective.observations().iter().map(rows_of).collect();
        let mut input = serde_json::json!({
            "params": ParamsJson::plain(params),
            "y": y,
            "lengths": objective.sequences().lengths(),
            "order": objective.sequences().order(),
        });
        if objective.jitter() != 0.0 {
            input["jitter"] = objective.jitter().into();
        }
        serde_json::to_string(&serde_json::json!({ "input": input }))
    }

    /// Computes the bound, its terms, the gradient and the optimal posteriors. The case of a plain model also
    /// has rollouts. A case with movements also has the bound with the optimal inducing outputs fixed, and
    /// the gradient of this bound with respect to latents and couplings. A case with stored primitives has
    /// only the bound, its terms, and the gradient with respect to everything that is not stored.
    ///
    /// # Errors
    ///
    /// When the bound is not finite, a covariance cannot be factorised, or a rollout cannot be made.
    pub fn evaluate(&self) -> Result<CaseResult, CaseError> {
        let (terms, gradient) = self.bound(&self.objective)?;
        let (gradient, further) = match self.sort {
            CaseSort::Plain => {
                (GradientJson::Whole(ParamsJson::plain(&gradient)), Some(self.rolled_out(&terms)?))
            }
            CaseSort::Movements => {
                (GradientJson::Whole(ParamsJson::of_movements(&gradient)), Some(self.given()?))
            }
            CaseSort::Stored(stored) => (GradientJson::stored(&gradient, stored), None),
        };
        // A case with stored primitives already has the posteriors in its input.
        let posterior = match self.sort {
            CaseSort::Stored(_) => None,
            CaseSort::Plain | CaseSort::Movements => Some(self.posteriors()?),
        };
        Ok(CaseResult { elbo: terms.total(), terms, gradient, posterior, further, median_ms: None })
    }

    fn posteriors(&self) -> Result<PosteriorsJson, CaseError> {
        let posteriors = self.objective.posteriors(&self.params)?;
        Ok(PosteriorsJson {
            kin: posteriors.kinematics.iter().map(PosteriorJson::from).collect(),
            dynamics: posteriors.dynamics.iter().map(PosteriorJson::from).collect(),
        })
    }

    fn bound(&self, objective: &Objective) -> Result<(BoundTerms, Params), CaseError> {
        let (terms, gradient) = objective.terms_and_gradient(&self.params)?;
        // Numbers near the limits of f64 can give a finite bound with a gradient that is not finite.
        let mut finite = true;
        gradient.visit(&mut |_, values| finite &= values.iter().all(|v| v.is_finite()));
        if finite {
            Ok((terms, gradient))
        } else {
            Err(NumericsError::NotFinite { what: "gradient of the bound" }.into())
        }
    }

    fn given(&self) -> Result<Further, CaseError> {
        let stored = self.objective.stored(&self.params)?;
        let (terms, gradient) = self.bound(&self.objective.clone().under(stored))?;
        let gradient_given = GivenGradientJson::from(&gradient);
        Ok(Further::Movements { elbo_given: terms.total(), gradient_given })
    }

    fn rolled_out(&self, terms: &BoundTerms) -> Result<Further, CaseError> {
        let model = Vcgpdm::at_optimum(&self.objective, &self.params, terms.clone())?;
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
        Ok(Further::Plain { rollouts: rollouts.collect::<Result<_, CaseError>>()? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use vcgpdm_core::models::variational::PartParams;

    /// The problem of a golden file.
    fn problem(text: &str) -> (Params, Objective) {
        let Case { params, objective, .. } = Case::from_json(text).unwrap();
        (params, objective)
    }

    const TWO_PARTS: &str = include_str!("../../../../tests/golden/case-1.json");
    const THREE_PARTS: &str = include_str!("../../../../tests/golden/case-3.json");

    #[test]
    fn reads_a_start_that_was_written() {
        let (params, objective) = problem(THREE_PARTS);
        let case = Case::from_json(&Case::write(&params, &objective).unwrap()).unwrap();
        assert_eq!(case.params, params);
        let again = case.objective.terms(&case.params).unwrap().total();
        assert_relative_eq!(again, objective.terms(&params).unwrap().total());
    }

    #[test]
    fn names_the_path_of_a_wrong_shape() {
        let (params, objective) = problem(TWO_PARTS);
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
    fn names_the_path_of_stored_outputs_that_do_not_fit() {
        let text = include_str!("../../../../tests/golden/stored-0.json");
        let refused = |place: &str, to: serde_json::Value| {
            let mut value: serde_json::Value = serde_json::from_str(text).unwrap();
            *value.pointer_mut(&format!("/input/stored/{place}")).unwrap() = to;
            Case::from_json(&value.to_string()).unwrap_err().to_string()
        };
        assert_eq!(
            refused("primitives", 3.into()),
            "at input.stored.primitives: expected at most 2, found 3"
        );
        assert_eq!(
            refused("kin", serde_json::json!([])),
            "at input.stored.kin: expected 2 (one for each part), found 0"
        );
        let error = refused("dyn/1/cov", serde_json::json!([[1.0]]));
        assert!(error.starts_with("at input.stored.dyn[1].cov: expected 4 x 4 numbers"), "{error}");
    }

    #[test]
    fn refuses_cases_that_are_too_large_or_have_no_columns() {
        let (params, objective) = problem(TWO_PARTS);
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
