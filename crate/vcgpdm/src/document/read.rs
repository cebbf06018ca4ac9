//! From the tree of a document to a model: every field is checked where it is read.

use crate::document::error::{DocumentError, FORMAT, VERSION};
use crate::gp::Kernel;
use crate::json::checks::{count, positive, positive_number, shape, tame, tame_matrix, within};
use crate::json::{Field, FieldError, Object, Value, write};
use crate::models::dmp::{DmpDiscrete, DmpRhythmic};
use crate::models::map::MapModel;
use crate::models::tmp::Tmp;
use crate::models::variational::{BoundTerms, DynamicsSums, FittedExpert, PoseMap, Vcgpdm};
use crate::models::{
    Body, DmpSettings, MapSettings, Model, ModelKind, ModelSettings, Provenance, SequenceInfo, TmpSettings,
    TrainedModel, VariationalSettings,
};
use crate::motion::parts::{PartSpec, PartsLayout};
use crate::motion::pose::PoseMapping;
use nalgebra::{DMatrix, DVector};
use std::ops::RangeInclusive;

const MOST_PARTS: usize = 64;
const MOST_LATENT: usize = 100;
const MOST_IPS: usize = 1000;
const MOST_ORDER: usize = 100;
const MOST_SEQUENCES: usize = 10_000;

/// A model of any kind.
pub(super) fn document(value: &Value) -> Result<TrainedModel, DocumentError> {
    let head = head(value)?;
    match head.kind {
        ModelKind::Vcgpdm | ModelKind::Vgpdm => Ok(variational(head)?.into()),
        ModelKind::MapGpdm
        | ModelKind::MapCgpdm
        | ModelKind::Tmp
        | ModelKind::DmpDiscrete
        | ModelKind::DmpRhythmic => baseline(head),
    }
}

/// A variational model. A program that asks for no other need not hold the code of the others.
pub(super) fn vcgpdm_document(value: &Value) -> Result<TrainedModel<Vcgpdm>, DocumentError> {
    let head = head(value)?;
    match head.kind {
        ModelKind::Vcgpdm | ModelKind::Vgpdm => variational(head),
        other => Err(DocumentError::Kind { found: other.id() }),
    }
}

/// What all kinds of documents have, and the rest.
struct Head<'a> {
    document: Object<'a>,
    /// The field that names the kind.
    named: Option<Field<'a>>,
    kind: ModelKind,
    mapping: PoseMapping,
    column_means: Vec<f64>,
    frame_time: f64,
}

impl Head<'_> {
    /// The body, once the model is known to be of the kind that the document names.
    fn body(
        self,
        found: ModelKind,
        layout: PartsLayout,
        sequences: Vec<SequenceInfo>,
    ) -> Result<Body, DocumentError> {
        if let Some(field) = self.named
            && found != self.kind
        {
            let message = format!("expected {}, for so many parts, found {}", found.id(), self.kind.id());
            return Err(field.error(message).into());
        }
        self.document.end()?;
        let Head { mapping, column_means, frame_time, .. } = self;
        Ok(Body { mapping, layout, column_means, frame_time, sequences })
    }
}

fn head(value: &Value) -> Result<Head<'_>, DocumentError> {
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
        1..=VERSION => {}
        found if found > VERSION => return Err(DocumentError::Version { found }),
        _ => return Err(version.wrong(&format!("from 1 to {VERSION}")).into()),
    }
    // The first version had no other kind and did not name it.
    let named = document.optional("kind");
    let kind = named.as_ref().map_or(Ok(ModelKind::Vcgpdm), kind)?;
    let mapping = PoseMapping::from_field(document.get("pose")?)?;
    let frame_time = within(document.get("frame_time")?, 1e-5..=10.0, "seconds from 0.00001 to 10")?;
    let means = document.get("column_means")?;
    let column_means = means.numbers()?;
    count(&means, column_means.len(), mapping.column_count()..=mapping.column_count())?;
    tame(&means, &column_means)?;
    Ok(Head { document, named, kind, mapping, column_means, frame_time })
}

fn kind(field: &Field) -> Result<ModelKind, FieldError> {
    let id = field.text()?;
    ModelKind::from_id(id).ok_or_else(|| {
        let known: Vec<&str> = ModelKind::ALL.into_iter().map(ModelKind::id).collect();
        let found: String = id.chars().take(60).collect();
        field.error(format!("expected one of {}, found {found:?}", known.join(", ")))
    })
}

/// What is left of a baseline's document after the body.
fn baseline(mut head: Head) -> Result<TrainedModel, DocumentError> {
    let parts = head.document.get("parts")?;
    let specs = parts.list(|part| {
        let mut object = part.object()?;
        let spec = part_spec(&mut object)?;
        object.end()?;
        Ok(spec)
    })?;
    count(&parts, specs.len(), 1..=MOST_PARTS)?;
    let layout = PartsLayout::new(&specs, &head.mapping)?;
    let columns: Vec<usize> = (0..specs.len()).map(|part| layout.columns(part).len()).collect();
    let field = head.document.get("sequences")?;
    let sequences = field.list(|item| {
        let mut object = item.object()?;
        let info = sequence_info(&mut object)?;
        object.end()?;
        Ok(info)
    })?;
    count(&field, sequences.len(), 1..=MOST_SEQUENCES)?;
    let lengths: Vec<usize> = sequences.iter().map(|sequence| sequence.frames).collect();
    let field = head.document.get("model")?;
    let count = lengths.len();
    let model = match head.kind {
        ModelKind::MapGpdm | ModelKind::MapCgpdm => {
            Model::Map(Box::new(MapModel::from_field(field, &columns, lengths)?))
        }
        ModelKind::Tmp => Model::Tmp(Box::new(Tmp::from_field(field, &columns, count)?)),
        ModelKind::DmpDiscrete => {
            Model::DmpDiscrete(Box::new(DmpDiscrete::from_field(field, &columns, count)?))
        }
        ModelKind::DmpRhythmic => {
            Model::DmpRhythmic(Box::new(DmpRhythmic::from_field(field, &columns, count)?))
        }
        // They have a document of their own.
        ModelKind::Vcgpdm | ModelKind::Vgpdm => return Err(field.error("expected a baseline").into()),
    };
    let mut object = head.document.get("provenance")?.object()?;
    let engine = object.get("engine")?.text()?.to_owned();
    let (settings, seed) = baseline_settings(object.get("settings")?, head.kind)?;
    let provenance = Provenance {
        engine,
        settings,
        seed,
        frames_per_second: frames_per_second(&mut object)?,
        objective: object.get("objective")?.number()?,
        iterations: object.get("iterations")?.whole()?,
        evaluations: 0,
        note: note(&mut object)?,
    };
    object.end()?;
    let body = head.body(model.kind(), layout, sequences)?;
    Ok(TrainedModel { model, body, provenance })
}

/// What is left of a variational model's document after the body.
fn variational(mut head: Head) -> Result<TrainedModel<Vcgpdm>, DocumentError> {
    let order = head.document.get("order")?;
    let order = count(&order, order.whole()?, 1..=MOST_ORDER)?;
    let jitter = within(head.document.get("jitter")?, 0.0..=1.0, "a number from 0 to 1")?;

    let parts = head.document.get("parts")?;
    let (specs, maps): (Vec<_>, Vec<_>) = parts.list(part)?.into_iter().unzip();
    let m = count(&parts, maps.len(), 1..=MOST_PARTS)?;
    let layout = PartsLayout::new(&specs, &head.mapping)?;
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
    let body = head.body(found, layout, sequences)?;

    let mut parts = Vec::with_capacity(m);
    for PoseFields { r, kernel, beta, mean, covariance } in maps {
        parts.push(PoseMap::new(r, kernel, beta, mean, covariance, jitter)?);
    }
    let mut experts = vec![Vec::with_capacity(m); m];
    let (mut dynamics_covariance, mut sums) = (Vec::with_capacity(m), Vec::with_capacity(m));
    for target in targets {
        for (row, ExpertFields { z, kernel, mean }) in experts.iter_mut().zip(target.experts) {
            row.push(FittedExpert::new(z, kernel, mean, jitter)?);
        }
        dynamics_covariance.push(target.covariance);
        sums.push(target.sums);
    }
    let model = Vcgpdm { order, jitter, parts, experts, dynamics_covariance, sums, alpha, starts, terms };
    Ok(TrainedModel { model, body, provenance })
}

fn part_spec(part: &mut Object) -> Result<PartSpec, FieldError> {
    Ok(PartSpec {
        name: part.get("name")?.text()?.to_owned(),
        joints: part.get("joints")?.list(|joint| joint.whole())?,
    })
}

fn sequence_info(sequence: &mut Object) -> Result<SequenceInfo, FieldError> {
    Ok(SequenceInfo {
        name: sequence.get("clip")?.text()?.to_owned(),
        sha256: sequence.get("sha256")?.text()?.to_owned(),
        frames: sequence.get("frames")?.whole()?,
    })
}

fn note(object: &mut Object) -> Result<Option<String>, FieldError> {
    match object.optional("note") {
        Some(note) if *note.value() != Value::Null => Ok(Some(note.text()?.to_owned())),
        _ => Ok(None),
    }
}

/// A part's pose map as it stands in the document.
struct PoseFields {
    r: DMatrix<f64>,
    kernel: Kernel,
    beta: f64,
    mean: DMatrix<f64>,
    covariance: DMatrix<f64>,
}

fn part(field: Field) -> Result<(PartSpec, PoseFields), FieldError> {
    let mut part = field.object()?;
    let spec = part_spec(&mut part)?;
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
    Ok((spec, PoseFields { r, kernel, beta, mean, covariance }))
}

/// An expert as it stands in the document.
struct ExpertFields {
    z: DMatrix<f64>,
    kernel: Kernel,
    mean: DMatrix<f64>,
}

/// The dynamics into one part; matrices over its sources stack them in order.
struct Target {
    experts: Vec<ExpertFields>,
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
fn expert(field: Field, dims: usize, q: usize) -> Result<ExpertFields, FieldError> {
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
    Ok(ExpertFields { z, kernel: Kernel { lambda: DVector::from_vec(lambda), variance: 1.0 }, mean })
}

/// A training sequence with the latent means of the first frames of each part.
fn sequence(
    field: Field,
    latent: &[usize],
    order: usize,
) -> Result<(SequenceInfo, Vec<DMatrix<f64>>), FieldError> {
    let mut sequence = field.object()?;
    let info = sequence_info(&mut sequence)?;
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

/// How a variational model of `m` parts was made, and the terms of its bound.
fn provenance(field: Field, m: usize) -> Result<(Provenance<VariationalSettings>, BoundTerms), FieldError> {
    let mut object = field.object()?;
    let engine = object.get("engine")?.text()?.to_owned();
    let (settings, seed) = variational_settings(object.get("settings")?)?;
    let frames_per_second = frames_per_second(&mut object)?;
    let objective = object.get("bound")?.number()?;
    let terms = terms(object.get("terms")?, m)?;
    let iterations = object.get("iterations")?.whole()?;
    let evaluations = object.get("evaluations")?.whole()?;
    let note = note(&mut object)?;
    object.end()?;
    let provenance =
        Provenance { engine, settings, seed, frames_per_second, objective, iterations, evaluations, note };
    Ok((provenance, terms))
}

/// What training was asked for, and the seed.
fn variational_settings(field: Field) -> Result<(VariationalSettings, u32), FieldError> {
    let mut object = field.object()?;
    let settings = VariationalSettings {
        latent: in_range(&object.get("latent")?, 1..=MOST_LATENT)?,
        dynamics_ips: in_range(&object.get("dynamics_ips")?, 1..=MOST_IPS)?,
        pose_ips: in_range(&object.get("pose_ips")?, 1..=MOST_IPS)?,
        order: in_range(&object.get("order")?, 1..=MOST_ORDER)?,
        max_iterations: object.get("max_iterations")?.whole()?,
    };
    let seed = seed(&mut object)?;
    object.end()?;
    Ok((settings, seed))
}

/// The same for a model that is not variational.
fn baseline_settings(field: Field, kind: ModelKind) -> Result<(ModelSettings, u32), FieldError> {
    let mut object = field.clone().object()?;
    let (settings, seed) = match kind {
        ModelKind::MapGpdm => (ModelSettings::MapGpdm(map_settings(&mut object)?), seed(&mut object)?),
        ModelKind::MapCgpdm => (ModelSettings::MapCgpdm(map_settings(&mut object)?), seed(&mut object)?),
        ModelKind::Tmp => {
            let primitives = object.optional("primitives").map(|field| in_range(&field, 1..=MOST_IPS));
            (ModelSettings::Tmp(TmpSettings { primitives: primitives.transpose()? }), 0)
        }
        ModelKind::DmpDiscrete => (ModelSettings::DmpDiscrete(dmp_settings(&mut object)?), 0),
        ModelKind::DmpRhythmic => (ModelSettings::DmpRhythmic(dmp_settings(&mut object)?), 0),
        ModelKind::Vcgpdm | ModelKind::Vgpdm => return Err(field.error("expected settings of a baseline")),
    };
    object.end()?;
    Ok((settings, seed))
}

fn map_settings(object: &mut Object) -> Result<MapSettings, FieldError> {
    Ok(MapSettings {
        latent: in_range(&object.get("latent")?, 1..=MOST_LATENT)?,
        order: in_range(&object.get("order")?, 1..=MOST_ORDER)?,
        max_iterations: object.get("max_iterations")?.whole()?,
        // Yes is 1.
        balanced: in_range(&object.get("balanced")?, 0..=1)? == 1,
    })
}

fn dmp_settings(object: &mut Object) -> Result<DmpSettings, FieldError> {
    Ok(DmpSettings { bases: in_range(&object.get("bases")?, 1..=MOST_IPS)? })
}

/// A setting, within what training could have been asked for.
fn in_range(field: &Field, range: RangeInclusive<usize>) -> Result<usize, FieldError> {
    count(field, field.whole()?, range)
}

fn seed(object: &mut Object) -> Result<u32, FieldError> {
    let field = object.get("seed")?;
    u32::try_from(field.whole()?).map_err(|_| field.wrong("a whole number from 0 to 4294967295"))
}

fn frames_per_second(object: &mut Object) -> Result<f64, FieldError> {
    within(object.get("frames_per_second")?, 0.1..=10_000.0, "frames a second from 0.1 to 10000")
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
