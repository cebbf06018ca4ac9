//! Reads a vCGPDM or vGPDM.

use crate::document::error::DocumentError;
use crate::document::read::head::{
    Head, MOST_PARTS, MOST_SEQUENCES, frames_per_second, note, part_spec, sequence_info,
};
use crate::document::settings::read_variational;
use crate::document::subject::Subject;
use crate::gp::{Kernel, NumericsError};
use crate::json::checks::{bounded_matrix, count, positive, positive_number, shape, within};
use crate::json::{Field, FieldError, Object};
use crate::models::variational::{BoundTerms, DynamicsSums, ExternalEvidence, FittedExpert, PoseMap, Vcgpdm};
use crate::models::{
    FittedModel, MOST_DIMENSIONS, MOST_INDUCING, Model, ModelKind, Provenance, SequenceInfo, Settings,
};
use crate::motion::parts::PartSpec;
use nalgebra::{DMatrix, DVector};
use std::ops::RangeInclusive;

/// Reads the rest of the document behind its head.
pub(super) fn vcgpdm<S: Subject>(mut head: Head<S>) -> Result<Model<S>, DocumentError> {
    let order = head.document.get("order")?;
    let order = count(&order, order.whole()?, 1..=MOST_DIMENSIONS)?;
    let jitter = within(head.document.get("jitter")?, 0.0..=1.0, "a number from 0 to 1")?;

    let parts = head.document.get("parts")?;
    let (specs, maps): (Vec<_>, Vec<_>) = parts.list(only(part::<S>))?.into_iter().unzip();
    let m = count(&parts, maps.len(), 1..=MOST_PARTS)?;
    let layout = head.mapping.layout(&specs)?;
    for (i, item) in parts.items()?.into_iter().enumerate() {
        let map: &PoseFields = &maps[i];
        shape(&item.object()?.get("v_mean")?, &map.mean, map.r.nrows(), layout.columns(i).len())?;
    }
    let latent: Vec<usize> = maps.iter().map(|map| map.r.ncols()).collect();

    let dynamics = head.document.get("dynamics")?;
    let items = dynamics.items()?;
    count(&dynamics, items.len(), m..=m)?;
    let mut targets = Vec::with_capacity(m);
    for (item, q) in items.into_iter().zip(&latent) {
        targets.push(target(item, &latent, *q, order)?);
    }
    if targets.iter().any(|target| target.external.is_some() != targets[0].external.is_some()) {
        let message = "expected other_precision and other_b in the dynamics of all parts or of none";
        return Err(dynamics.error(message).into());
    }
    let field = head.document.get("alpha")?;
    let alpha = field.matrix()?;
    shape(&field, &alpha, m, m)?;
    positive(&field, alpha.as_slice())?;
    let field = head.document.get("sequences")?;
    let (sequences, starts): (Vec<_>, Vec<_>) =
        field.list(|item| sequence(item, &latent, order))?.into_iter().unzip();
    count(&field, sequences.len(), 1..=MOST_SEQUENCES)?;
    let (provenance, terms) = provenance(head.document.get("provenance")?, m)?;
    let found = if m == 1 { ModelKind::Vgpdm } else { ModelKind::Vcgpdm };
    let provenance = match m {
        1 => provenance.of_one_part(),
        _ => provenance,
    };
    let body = head.body(found, layout, sequences)?;

    let mut parts = Vec::with_capacity(m);
    for map in maps {
        parts.push(map.solved(jitter)?);
    }
    let mut experts = vec![Vec::with_capacity(m); m];
    let (mut dynamics_covariance, mut sums) = (Vec::with_capacity(m), Vec::with_capacity(m));
    let mut external = Vec::new();
    for target in targets {
        for (row, expert) in experts.iter_mut().zip(target.experts) {
            row.push(expert.solved(jitter)?);
        }
        dynamics_covariance.push(target.covariance);
        sums.push(target.sums);
        external.extend(target.external);
    }
    let model =
        Vcgpdm { order, jitter, parts, experts, dynamics_covariance, sums, external, alpha, starts, terms };
    Ok(Model { fitted: FittedModel::Vcgpdm(Box::new(model)), body, provenance })
}

/// Reads an object, all of whose fields `read` takes.
fn only<T>(read: impl Fn(&mut Object) -> Result<T, FieldError>) -> impl Fn(Field) -> Result<T, FieldError> {
    move |field| {
        let mut object = field.object()?;
        let value = read(&mut object)?;
        object.end()?;
        Ok(value)
    }
}

/// The fields of a pose map.
pub(super) struct PoseFields {
    pub(super) r: DMatrix<f64>,
    kernel: Kernel,
    beta: f64,
    column_noise: Vec<f64>,
    pub(super) mean: DMatrix<f64>,
    covariance: DMatrix<f64>,
}

impl PoseFields {
    pub(super) fn solved(self, jitter: f64) -> Result<PoseMap, NumericsError> {
        let Self { r, kernel, beta, column_noise, mean, covariance } = self;
        Ok(PoseMap::new(r, kernel, beta, mean, covariance, jitter)?.with_column_noise(column_noise))
    }
}

/// Reads a part with its pose map. Other fields of the object stay.
pub(super) fn part<S: Subject>(part: &mut Object) -> Result<(PartSpec, PoseFields), FieldError> {
    let spec = part_spec::<S>(part)?;
    let field = part.get("lambda")?;
    let lambda = field.numbers()?;
    let q = count(&field, lambda.len(), 1..=MOST_DIMENSIONS)?;
    positive(&field, &lambda)?;
    let variance = positive_number(part.get("variance")?)?;
    let beta = positive_number(part.get("beta")?)?;
    let field = part.get("r")?;
    let r = bounded_matrix(&field)?;
    let l = count(&field, r.nrows(), 1..=MOST_INDUCING)?;
    shape(&field, &r, l, q)?;
    // The caller checks its shape once the layout of the parts exists.
    let mean = bounded_matrix(&part.get("v_mean")?)?;
    let field = part.get("v_covariance")?;
    let covariance = bounded_matrix(&field)?;
    shape(&field, &covariance, l, l)?;
    let kernel = Kernel { lambda: DVector::from_vec(lambda), variance };
    // Absent: beta is the noise variance of each column.
    let mut column_noise = Vec::new();
    if let Some(field) = part.optional("column_noise") {
        column_noise = field.numbers()?;
        count(&field, column_noise.len(), mean.ncols()..=mean.ncols())?;
        positive(&field, &column_noise)?;
    }
    Ok((spec, PoseFields { r, kernel, beta, column_noise, mean, covariance }))
}

/// The fields of an expert.
pub(super) struct ExpertFields {
    pub(super) z: DMatrix<f64>,
    kernel: Kernel,
    mean: DMatrix<f64>,
}

impl ExpertFields {
    pub(super) fn solved(self, jitter: f64) -> Result<FittedExpert, NumericsError> {
        FittedExpert::new(self.z, self.kernel, self.mean, jitter)
    }
}

/// The dynamics into one part. Matrices over all sources stack their blocks in order.
struct Target {
    experts: Vec<ExpertFields>,
    covariance: DMatrix<f64>,
    sums: DynamicsSums,
    external: Option<ExternalEvidence>,
}

/// `latent` are the dimensions of the sources, `q` is that of the target.
fn target(field: Field, latent: &[usize], q: usize, order: usize) -> Result<Target, FieldError> {
    let mut target = field.object()?;
    let field = target.get("experts")?;
    let mut experts = Vec::with_capacity(latent.len());
    let items = field.items()?;
    count(&field, items.len(), latent.len()..=latent.len())?;
    for (item, source) in items.into_iter().zip(latent) {
        experts.push(only(|object| expert(object, order * source, q))(item)?);
    }
    let total = experts.iter().map(|expert| expert.z.nrows()).sum();
    let mut matrix = |name: &str, width: usize| {
        let field = target.get(name)?;
        let matrix = bounded_matrix(&field)?;
        shape(&field, &matrix, total, width)?;
        Ok::<_, FieldError>(matrix)
    };
    let covariance = matrix("u_covariance", total)?;
    let sums = DynamicsSums { psi2: matrix("sum_psi2", total)?, psi1_mu: matrix("sum_psi1_mu", q)? };
    let external = external_evidence(&mut target, total, q)?;
    target.end()?;
    Ok(Target { experts, covariance, sums, external })
}

/// Reads the evidence from other data about `total` inducing outputs of `q` columns, if there is any.
pub(super) fn external_evidence(
    object: &mut Object,
    total: usize,
    q: usize,
) -> Result<Option<ExternalEvidence>, FieldError> {
    let Some(field) = object.optional("other_precision") else { return Ok(None) };
    let precision = bounded_matrix(&field)?;
    shape(&field, &precision, total, total)?;
    let field = object.get("other_b")?;
    let b = bounded_matrix(&field)?;
    shape(&field, &b, total, q)?;
    Ok(Some(ExternalEvidence { precision, b }))
}

/// Reads an expert; `dims` is the dimension of the source's history, `q` that of the target. Other fields of
/// the object stay.
pub(super) fn expert(expert: &mut Object, dims: usize, q: usize) -> Result<ExpertFields, FieldError> {
    let field = expert.get("lambda")?;
    let lambda = field.numbers()?;
    count(&field, lambda.len(), dims..=dims)?;
    positive(&field, &lambda)?;
    let field = expert.get("z")?;
    let z = bounded_matrix(&field)?;
    let k = count(&field, z.nrows(), 1..=MOST_INDUCING)?;
    shape(&field, &z, k, dims)?;
    let field = expert.get("u_mean")?;
    let mean = bounded_matrix(&field)?;
    shape(&field, &mean, k, q)?;
    Ok(ExpertFields { z, kernel: Kernel { lambda: DVector::from_vec(lambda), variance: 1.0 }, mean })
}

/// Reads a training sequence with the latent means of its first frames, or of all frames, for each part.
pub(super) fn sequence(
    field: Field,
    latent: &[usize],
    order: usize,
) -> Result<(SequenceInfo, Vec<DMatrix<f64>>), FieldError> {
    let mut sequence = field.object()?;
    let info = sequence_info(&mut sequence)?;
    // At least the first frames; some documents have all frames.
    let start = start(sequence.get("start")?, latent, order..=info.frames.max(order))?;
    sequence.end()?;
    Ok((info, start))
}

/// Reads the latent means of a number of frames in the range `frames`, the same number for each part.
pub(super) fn start(
    field: Field,
    latent: &[usize],
    frames: RangeInclusive<usize>,
) -> Result<Vec<DMatrix<f64>>, FieldError> {
    let items = field.items()?;
    count(&field, items.len(), latent.len()..=latent.len())?;
    let mut start: Vec<DMatrix<f64>> = Vec::with_capacity(latent.len());
    for (item, q) in items.iter().zip(latent) {
        let latents = bounded_matrix(item)?;
        let rows = latents.nrows().clamp(*frames.start(), *frames.end());
        shape(item, &latents, start.first().map_or(rows, DMatrix::nrows), *q)?;
        start.push(latents);
    }
    Ok(start)
}

/// Reads the provenance of a variational model of `m` parts, with the terms of its bound.
pub(super) fn provenance(field: Field, m: usize) -> Result<(Provenance, BoundTerms), FieldError> {
    let mut object = field.object()?;
    let mut provenance = training(&mut object)?;
    provenance.rollout_rounds = rollout_rounds(&mut object)?;
    let terms = terms(object.get("terms")?, m)?;
    object.end()?;
    Ok((provenance, terms))
}

/// Reads the number of rounds of own rollouts; absent: 0.
pub(super) fn rollout_rounds(object: &mut Object) -> Result<usize, FieldError> {
    object.optional("rollout_rounds").map_or(Ok(0), |field| field.whole())
}

/// Reads the fields of a provenance that all documents of variational models have.
pub(super) fn training(object: &mut Object) -> Result<Provenance, FieldError> {
    let engine = object.get("engine")?.text()?.to_owned();
    let (settings, seed) = read_variational(object.get("settings")?)?;
    let bound = object.get("bound")?.number()?;
    let objective = object.optional("objective").map(|field| field.number()).transpose()?;
    Ok(Provenance {
        engine,
        settings: Settings::Vcgpdm(settings),
        seed,
        frames_per_second: frames_per_second(object)?,
        objective: objective.unwrap_or(bound),
        plain_bound: objective.map(|_| bound),
        iterations: object.get("iterations")?.whole()?,
        evaluations: object.get("evaluations")?.whole()?,
        rollout_rounds: 0,
        note: note(object)?,
    })
}

fn terms(field: Field, m: usize) -> Result<BoundTerms, FieldError> {
    let mut object = field.object()?;
    let mut part_numbers = |name: &str| {
        let field = object.get(name)?;
        let numbers = field.numbers()?;
        count(&field, numbers.len(), m..=m)?;
        Ok::<_, FieldError>(numbers)
    };
    let (kinematics, dynamics) = (part_numbers("kinematics")?, part_numbers("dynamics")?);
    let terms = BoundTerms {
        kinematics,
        dynamics,
        initial: object.get("initial")?.number()?,
        entropy: object.get("entropy")?.number()?,
    };
    object.end()?;
    Ok(terms)
}
