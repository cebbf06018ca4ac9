//! From the tree of a document to a model: every field is checked where it is read.

use super::{DocumentError, FORMAT, VERSION};
use crate::dataset::SequenceInfo;
use crate::json::{Field, FieldError, Value, write};
use crate::model::{BoundTerms, DynamicsSums, FittedExpert, FittedModel, Kernel, PoseMap};
use crate::motion_model::{MotionModel, Provenance};
use crate::parts::{PartSpec, PartsLayout};
use crate::pose::PoseMapping;
use crate::training::TrainingSettings;
use nalgebra::{DMatrix, DVector};
use std::ops::RangeInclusive;

const MOST_PARTS: usize = 64;
const MOST_LATENT: usize = 100;
const MOST_IPS: usize = 1000;
const MOST_ORDER: usize = 100;
const MOST_SEQUENCES: usize = 10_000;
/// Beyond this no sum of products stays finite for sure.
const LARGEST: f64 = 1e12;

pub(super) fn document(value: &Value) -> Result<MotionModel, DocumentError> {
    let mut document = Field::root(value).object()?;
    let format = document.optional("format");
    match format.as_ref().map(Field::value) {
        Some(Value::Text(format)) if format == FORMAT => {}
        Some(other) => {
            let found = write(other).unwrap_or_default().chars().take(60).collect();
            return Err(DocumentError::Format { found });
        }
        None => return Err(DocumentError::Format { found: "no format".to_owned() }),
    }
    let version = document.get("version")?;
    match version.whole()? {
        VERSION => {}
        found if found > VERSION => return Err(DocumentError::Version { found }),
        _ => return Err(version.wrong(&VERSION.to_string()).into()),
    }
    let mapping = PoseMapping::from_field(document.get("pose")?)?;
    let frame_time = within(document.get("frame_time")?, 1e-5..=10.0, "seconds from 0.00001 to 10")?;
    let means = document.get("column_means")?;
    let column_means = means.numbers()?;
    count(&means, column_means.len(), mapping.column_count()..=mapping.column_count())?;
    tame(&means, &column_means)?;
    let order = document.get("order")?;
    let order = count(&order, order.whole()?, 1..=MOST_ORDER)?;
    let jitter = within(document.get("jitter")?, 0.0..=1.0, "a number from 0 to 1")?;

    let parts = document.get("parts")?;
    let (specs, maps): (Vec<_>, Vec<_>) = parts.list(part)?.into_iter().unzip();
    let m = count(&parts, maps.len(), 1..=MOST_PARTS)?;
    let layout = PartsLayout::new(&specs, &mapping)?;
    for (i, item) in parts.items()?.into_iter().enumerate() {
        let map: &PoseMap = &maps[i];
        shape(&item.object()?.get("v_mean")?, &map.mean, map.r.nrows(), layout.columns(i).len())?;
    }
    let latent: Vec<usize> = maps.iter().map(|map| map.r.ncols()).collect();

    let dynamics = document.get("dynamics")?;
    let items = dynamics.items()?;
    count(&dynamics, items.len(), m..=m)?;
    let mut targets = Vec::with_capacity(m);
    for (item, q) in items.into_iter().zip(&latent) {
        targets.push(target(item, &latent, *q, order)?);
    }
    let field = document.get("alpha")?;
    let alpha = field.matrix()?;
    shape(&field, &alpha, m, m)?;
    positive(&field, alpha.as_slice())?;
    let field = document.get("sequences")?;
    let (sequences, starts): (Vec<_>, Vec<_>) =
        field.list(|item| sequence(item, &latent, order))?.into_iter().unzip();
    count(&field, sequences.len(), 1..=MOST_SEQUENCES)?;
    let provenance = provenance(document.get("provenance")?, m)?;
    document.end()?;

    let mut experts = vec![Vec::with_capacity(m); m];
    let (mut dynamics_covariance, mut sums) = (Vec::with_capacity(m), Vec::with_capacity(m));
    for target in targets {
        for (row, expert) in experts.iter_mut().zip(target.experts) {
            row.push(expert);
        }
        dynamics_covariance.push(target.covariance);
        sums.push(target.sums);
    }
    let fitted =
        FittedModel { order, jitter, experts, dynamics_covariance, sums, parts: maps, alpha, starts };
    Ok(MotionModel::new(fitted, mapping, layout, column_means, frame_time, sequences, provenance)?)
}

fn part(field: Field) -> Result<(PartSpec, PoseMap), FieldError> {
    let mut part = field.object()?;
    let spec = PartSpec {
        name: part.get("name")?.text()?.to_owned(),
        joints: part.get("joints")?.list(|joint| joint.whole())?,
    };
    let field = part.get("lambda")?;
    let lambda = field.numbers()?;
    let q = count(&field, lambda.len(), 1..=MOST_LATENT)?;
    positive(&field, &lambda)?;
    let variance = positive_number(part.get("variance")?)?;
    let beta = positive_number(part.get("beta")?)?;
    let field = part.get("r")?;
    let r = tame_matrix(&field)?;
    let l = count(&field, r.nrows(), 1..=MOST_IPS)?;
    shape(&field, &r, l, q)?;
    // Its shape is known when the parts are known to fit the body.
    let mean = tame_matrix(&part.get("v_mean")?)?;
    let field = part.get("v_covariance")?;
    let covariance = tame_matrix(&field)?;
    shape(&field, &covariance, l, l)?;
    part.end()?;
    let kernel = Kernel { lambda: DVector::from_vec(lambda), variance };
    Ok((spec, PoseMap { r, kernel, beta, mean, covariance }))
}

/// The dynamics into one part; matrices over its sources stack them in order.
struct Target {
    experts: Vec<FittedExpert>,
    covariance: DMatrix<f64>,
    sums: DynamicsSums,
}

/// `latent`: dimensions of each source; `q`: of the target.
fn target(field: Field, latent: &[usize], q: usize, order: usize) -> Result<Target, FieldError> {
    let mut target = field.object()?;
    let field = target.get("experts")?;
    let mut experts = Vec::with_capacity(latent.len());
    let items = field.items()?;
    count(&field, items.len(), latent.len()..=latent.len())?;
    for (item, source) in items.into_iter().zip(latent) {
        experts.push(expert(item, order * source, q)?);
    }
    let total = experts.iter().map(|expert| expert.z.nrows()).sum();
    let mut matrix = |name: &str, width: usize| {
        let field = target.get(name)?;
        let matrix = tame_matrix(&field)?;
        shape(&field, &matrix, total, width)?;
        Ok::<_, FieldError>(matrix)
    };
    let covariance = matrix("u_covariance", total)?;
    let sums = DynamicsSums { psi2: matrix("sum_psi2", total)?, psi1_mu: matrix("sum_psi1_mu", q)? };
    target.end()?;
    Ok(Target { experts, covariance, sums })
}

/// `dims`: of the source's history; `q`: of the target.
fn expert(field: Field, dims: usize, q: usize) -> Result<FittedExpert, FieldError> {
    let mut expert = field.object()?;
    let field = expert.get("lambda")?;
    let lambda = field.numbers()?;
    count(&field, lambda.len(), dims..=dims)?;
    positive(&field, &lambda)?;
    let field = expert.get("z")?;
    let z = tame_matrix(&field)?;
    let k = count(&field, z.nrows(), 1..=MOST_IPS)?;
    shape(&field, &z, k, dims)?;
    let field = expert.get("u_mean")?;
    let mean = tame_matrix(&field)?;
    shape(&field, &mean, k, q)?;
    expert.end()?;
    Ok(FittedExpert { z, kernel: Kernel { lambda: DVector::from_vec(lambda), variance: 1.0 }, mean })
}

/// A training sequence with the latent means of the first frames of each part.
fn sequence(
    field: Field,
    latent: &[usize],
    order: usize,
) -> Result<(SequenceInfo, Vec<DMatrix<f64>>), FieldError> {
    let mut sequence = field.object()?;
    let info = SequenceInfo {
        name: sequence.get("clip")?.text()?.to_owned(),
        sha256: sequence.get("sha256")?.text()?.to_owned(),
        frames: sequence.get("frames")?.whole()?,
    };
    let field = sequence.get("start")?;
    let items = field.items()?;
    count(&field, items.len(), latent.len()..=latent.len())?;
    let mut start = Vec::with_capacity(latent.len());
    for (item, q) in items.iter().zip(latent) {
        let latents = tame_matrix(item)?;
        shape(item, &latents, order, *q)?;
        start.push(latents);
    }
    sequence.end()?;
    Ok((info, start))
}

/// Of a model of `m` parts.
fn provenance(field: Field, m: usize) -> Result<Provenance, FieldError> {
    let mut object = field.object()?;
    let provenance = Provenance {
        engine: object.get("engine")?.text()?.to_owned(),
        settings: settings(object.get("settings")?)?,
        frames_per_second: object.get("frames_per_second")?.number()?,
        bound: object.get("bound")?.number()?,
        terms: terms(object.get("terms")?, m)?,
        iterations: object.get("iterations")?.whole()?,
        evaluations: object.get("evaluations")?.whole()?,
        note: match object.optional("note") {
            Some(note) if *note.value() != Value::Null => Some(note.text()?.to_owned()),
            _ => None,
        },
    };
    object.end()?;
    Ok(provenance)
}

fn settings(field: Field) -> Result<TrainingSettings, FieldError> {
    let mut object = field.object()?;
    let mut whole = |name: &str| object.get(name)?.whole();
    let (latent, dynamics_ips, pose_ips) = (whole("latent")?, whole("dynamics_ips")?, whole("pose_ips")?);
    let (order, max_iterations) = (whole("order")?, whole("max_iterations")?);
    let field = object.get("seed")?;
    let seed =
        u32::try_from(field.whole()?).map_err(|_| field.wrong("a whole number from 0 to 4294967295"))?;
    object.end()?;
    Ok(TrainingSettings { latent, dynamics_ips, pose_ips, order, seed, max_iterations })
}

fn terms(field: Field, m: usize) -> Result<BoundTerms, FieldError> {
    let mut object = field.object()?;
    let mut for_each_part = |name: &str| {
        let field = object.get(name)?;
        let numbers = field.numbers()?;
        count(&field, numbers.len(), m..=m)?;
        Ok::<_, FieldError>(numbers)
    };
    let (kinematics, dynamics) = (for_each_part("kinematics")?, for_each_part("dynamics")?);
    let terms = BoundTerms {
        kinematics,
        dynamics,
        initial: object.get("initial")?.number()?,
        entropy: object.get("entropy")?.number()?,
    };
    object.end()?;
    Ok(terms)
}

/// A number in a range that `expected` puts into words.
fn within(field: Field, range: RangeInclusive<f64>, expected: &str) -> Result<f64, FieldError> {
    let number = field.number()?;
    if range.contains(&number) { Ok(number) } else { Err(field.wrong(expected)) }
}

/// `found` of a field: its value or its length.
fn count(field: &Field, found: usize, range: RangeInclusive<usize>) -> Result<usize, FieldError> {
    if range.contains(&found) {
        return Ok(found);
    }
    let (lowest, highest) = range.into_inner();
    let expected = if lowest == highest { lowest.to_string() } else { format!("from {lowest} to {highest}") };
    Err(field.error(format!("expected {expected}, found {found}")))
}

fn shape(field: &Field, matrix: &DMatrix<f64>, rows: usize, columns: usize) -> Result<(), FieldError> {
    let (r, c) = matrix.shape();
    if (r, c) == (rows, columns) {
        return Ok(());
    }
    Err(field.error(format!("expected {rows} x {columns} numbers, found {r} x {c}")))
}

fn positive_number(field: Field) -> Result<f64, FieldError> {
    let number = field.number()?;
    positive(&field, &[number])?;
    Ok(number)
}

fn positive(field: &Field, values: &[f64]) -> Result<(), FieldError> {
    match values.iter().find(|v| !(1e-12..=LARGEST).contains(*v)) {
        None => Ok(()),
        Some(v) => Err(field.error(format!("expected positive numbers up to 1e12, found {v}"))),
    }
}

fn tame(field: &Field, values: &[f64]) -> Result<(), FieldError> {
    match values.iter().find(|v| v.abs() > LARGEST) {
        None => Ok(()),
        Some(v) => Err(field.error(format!("expected numbers up to 1e12 in size, found {v}"))),
    }
}

fn tame_matrix(field: &Field) -> Result<DMatrix<f64>, FieldError> {
    let matrix = field.matrix()?;
    tame(field, matrix.as_slice())?;
    Ok(matrix)
}
