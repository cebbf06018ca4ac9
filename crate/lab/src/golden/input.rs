//! The inputs of golden cases: of plain models, and of movements that share primitives.

use crate::golden::error::CaseError;
use crate::golden::rows;
use crate::golden::shapes::{ExpertJson, PartJson, RolloutJson, matrices, shape};
use crate::golden::stored::StoredJson;
use nalgebra::DMatrix;
use serde::Deserialize;
use serde::de::{DeserializeOwned, IgnoredAny};
use vcgpdm_core::json::place;
use vcgpdm_core::models::Sequences;
use vcgpdm_core::models::variational::{Objective, Params, Repertoire};

#[derive(Deserialize)]
struct Document<I> {
    input: I,
    #[serde(default)]
    expected: Expected,
}

/// The rollouts of a case.
#[derive(Default, Deserialize)]
struct Expected {
    #[serde(default)]
    rollouts: Vec<RolloutJson>,
}

/// Whether the input has movements.
#[derive(Deserialize)]
struct Sort {
    movements: Option<IgnoredAny>,
}

#[derive(Deserialize)]
struct PlainInput {
    params: PlainParams,
    y: Vec<Vec<Vec<f64>>>,
    lengths: Vec<usize>,
    order: usize,
    #[serde(default)]
    jitter: f64,
}

#[derive(Deserialize)]
struct PlainParams {
    parts: Vec<PartJson>,
    #[serde(rename = "dyn")]
    experts: Vec<Vec<ExpertJson>>,
    #[serde(with = "rows::matrix")]
    alpha: DMatrix<f64>,
}

#[derive(Deserialize)]
struct MovementsInput {
    params: MovementsParams,
    y: Vec<Vec<Vec<f64>>>,
    movements: Vec<MovementJson>,
    order: usize,
    #[serde(default)]
    jitter: f64,
    stored: Option<StoredJson>,
}

#[derive(Deserialize)]
struct MovementsParams {
    parts: Vec<PartJson>,
    primitives: Vec<PrimitiveJson>,
    alpha: Vec<Vec<Vec<f64>>>,
}

#[derive(Deserialize)]
struct PrimitiveJson {
    part: usize,
    #[serde(rename = "dyn")]
    experts: Vec<ExpertJson>,
}

#[derive(Deserialize)]
struct MovementJson {
    lengths: Vec<usize>,
    uses: Vec<usize>,
}

/// The form of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CaseSort {
    Plain,
    /// One or more movements.
    Movements,
    /// Movements with stored pose maps and this number of stored first primitives.
    Stored(usize),
}

/// Data and parameters of a case.
pub(super) struct Input {
    pub params: Params,
    pub objective: Objective,
    pub rollouts: Vec<RolloutJson>,
    pub sort: CaseSort,
}

fn parse<I: DeserializeOwned>(text: &str) -> Result<Document<I>, CaseError> {
    let mut deserializer = serde_json::Deserializer::from_str(text);
    serde_path_to_error::deserialize(&mut deserializer)
        .map_err(|e| CaseError::Form { path: place(e.path()), message: e.inner().to_string() })
}

impl Input {
    /// Reads a golden file of any form, or only its `input`.
    pub fn from_json(text: &str) -> Result<Self, CaseError> {
        if parse::<Sort>(text)?.input.movements.is_some() {
            return Self::of_movements(parse(text)?);
        }
        let Document { input: PlainInput { params, y, lengths, order, jitter }, expected } = parse(text)?;
        let sequences = Sequences::new(lengths, order)?;
        let y = matrices(&y, "input.y")?;
        let names = Names { experts: "input.params.dyn", alpha: "input.params.alpha" };
        let params = given(params.parts, params.experts, vec![params.alpha]);
        let m = params.parts.len();
        if params.experts.len() != m && m > 0 {
            return Err(wrong_count(names.experts, m, params.experts.len()));
        }
        let repertoire = Repertoire::plain(sequences, m);
        check(&params, &y, &repertoire, jitter, &names)?;
        let objective = Objective::of_movements(y, repertoire, jitter);
        Ok(Self { params, objective, rollouts: expected.rollouts, sort: CaseSort::Plain })
    }

    fn of_movements(document: Document<MovementsInput>) -> Result<Self, CaseError> {
        let MovementsInput { params, y, movements, order, jitter, stored } = document.input;
        let sequences = Sequences::new(movements.iter().flat_map(|m| m.lengths.clone()).collect(), order)?;
        let y = matrices(&y, "input.y")?;
        let (owners, experts): (Vec<_>, Vec<_>) =
            params.primitives.into_iter().map(|p| (p.part, p.experts)).unzip();
        let alpha = matrices(&params.alpha, "input.params.alpha")?;
        let names = Names { experts: "input.params.primitives", alpha: "input.params.alpha" };
        let params = given(params.parts, experts, alpha);
        let movements = movements.into_iter().map(|m| (m.lengths.len(), m.uses)).collect();
        let repertoire = Repertoire::new(sequences, params.parts.len(), owners, movements)?;
        if params.alpha.len() != repertoire.movements().len() {
            let expected = format!("{} (one for each movement)", repertoire.movements().len());
            let (path, found) = (names.alpha.to_owned(), params.alpha.len().to_string());
            return Err(CaseError::Shape { path, expected, found });
        }
        check(&params, &y, &repertoire, jitter, &names)?;
        let (sort, maps) = match stored {
            None => (CaseSort::Movements, None),
            Some(stored) => (CaseSort::Stored(stored.primitives()), Some(stored.maps(&params, &y, jitter)?)),
        };
        let objective = Objective::of_movements(y, repertoire, jitter);
        let objective = match maps {
            None => objective,
            Some(maps) => objective.under(maps),
        };
        Ok(Self { params, objective, rollouts: Vec::new(), sort })
    }
}

fn given(parts: Vec<PartJson>, experts: Vec<Vec<ExpertJson>>, alpha: Vec<DMatrix<f64>>) -> Params {
    let experts = experts.into_iter().map(|row| row.into_iter().map(Into::into).collect());
    Params { parts: parts.into_iter().map(Into::into).collect(), experts: experts.collect(), alpha }
}

/// The names of the fields in error messages.
struct Names {
    experts: &'static str,
    alpha: &'static str,
}

fn wrong_count(path: &str, parts: usize, found: usize) -> CaseError {
    let (expected, found) = (format!("{parts} (one for each part)"), found.to_string());
    CaseError::Shape { path: path.to_owned(), expected, found }
}

fn positive(path: String, values: &[f64]) -> Result<(), CaseError> {
    match values.iter().find(|v| v.is_nan() || **v <= 0.0) {
        None => Ok(()),
        Some(v) => Err(CaseError::Shape { path, expected: "positive numbers".into(), found: v.to_string() }),
    }
}

/// Checks that the shapes agree and that the variances are positive.
fn check(
    params: &Params,
    y: &[DMatrix<f64>],
    repertoire: &Repertoire,
    jitter: f64,
    names: &Names,
) -> Result<(), CaseError> {
    let m = params.parts.len();
    if m == 0 {
        let (expected, found) = ("at least one part".into(), "none".into());
        return Err(CaseError::Shape { path: "input.params.parts".into(), expected, found });
    }
    if y.len() != m {
        return Err(wrong_count("input.y", m, y.len()));
    }
    for (k, alpha) in params.alpha.iter().enumerate() {
        let path =
            if params.alpha.len() == 1 { names.alpha.to_owned() } else { format!("{}[{k}]", names.alpha) };
        shape(path.clone(), (m, m), alpha.shape())?;
        positive(path, alpha.as_slice())?;
    }
    if !(0.0..1.0).contains(&jitter) {
        let (expected, found) = ("a jitter from 0 to 1".into(), jitter.to_string());
        return Err(CaseError::Shape { path: "input.jitter".into(), expected, found });
    }
    let n = repertoire.sequences().frames();
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
    }
    for (primitive, (row, owner)) in params.experts.iter().zip(repertoire.primitives()).enumerate() {
        if row.len() != m {
            return Err(wrong_count(&format!("{}[{primitive}]", names.experts), m, row.len()));
        }
        let dims = repertoire.sequences().order() * params.parts[*owner].latents.mean.ncols();
        for (target, expert) in row.iter().enumerate() {
            let at = |name: &str| format!("{}[{primitive}][{target}].{name}", names.experts);
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
