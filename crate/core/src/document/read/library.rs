//! Reads a library of primitives.

use crate::document::error::DocumentError;
use crate::document::read::head::{Head, MOST_PARTS, MOST_SEQUENCES, sequence_info};
use crate::document::read::vcgpdm::{
    expert, external_evidence, part, provenance, rollout_rounds, sequence, start, training,
};
use crate::json::checks::{bounded_matrix, count, positive, shape, within};
use crate::json::{Field, FieldError, Object, Value};
use crate::models::data::sequences::MOST_FRAMES;
use crate::models::library::{
    CouplingsFrom, Excerpt, FramesFrom, LearnedMovement, Library, LibraryExpert, Origin, Primitive,
    Relearned, TrainedLibrary,
};
use crate::models::variational::{DynamicsSums, ExternalEvidence};
use crate::models::{MOST_DIMENSIONS, SequenceInfo};
use crate::motion::parts::PartsLayout;
use crate::motion::pose::PoseMapping;
use nalgebra::DMatrix;

/// Largest number of primitives, movements or excerpts.
const MOST: usize = 1000;

/// Reads the rest of the document behind its head.
pub(super) fn library(mut head: Head<PoseMapping>) -> Result<TrainedLibrary, DocumentError> {
    let order = head.document.get("order")?;
    let order = count(&order, order.whole()?, 1..=MOST_DIMENSIONS)?;
    let jitter = within(head.document.get("jitter")?, 0.0..=1.0, "a number from 0 to 1")?;
    let field = head.document.get("parts")?;
    let items = field.items()?;
    let m = count(&field, items.len(), 1..=MOST_PARTS)?;
    let (mut specs, mut maps, mut pose_sums) = (Vec::new(), Vec::new(), Vec::new());
    for item in items {
        let mut object = item.object()?;
        let (spec, map) = part::<PoseMapping>(&mut object)?;
        let field = object.get("sum_psi2")?;
        let psi2 = bounded_matrix(&field)?;
        shape(&field, &psi2, map.r.nrows(), map.r.nrows())?;
        object.end()?;
        specs.push(spec);
        maps.push(map);
        pose_sums.push(psi2);
    }
    let layout = PartsLayout::new(&specs, &head.mapping)?;
    for (i, map) in maps.iter().enumerate() {
        if map.mean.shape() != (map.r.nrows(), layout.columns(i).len()) {
            let (rows, columns) = (map.r.nrows(), layout.columns(i).len());
            let found = map.mean.shape();
            let message =
                format!("expected v_mean of part {i} to be {rows} x {columns} numbers, found {found:?}");
            return Err(field.error(message).into());
        }
    }
    let latent: Vec<usize> = maps.iter().map(|map| map.r.ncols()).collect();

    let field = head.document.get("primitives")?;
    let items = field.items()?;
    count(&field, items.len(), 0..=MOST)?;
    let mut primitives: Vec<Primitive> = Vec::with_capacity(items.len());
    for item in items {
        let read = primitive(item.clone(), &latent, order, jitter)?;
        if primitives.iter().any(|other| other.part == read.part && other.name == read.name) {
            return Err(item
                .error(format!("expected a name of its own, found {:?} twice", read.name))
                .into());
        }
        primitives.push(read);
    }
    let field = head.document.get("movements")?;
    let items = field.items()?;
    count(&field, items.len(), 0..=MOST)?;
    let (mut movements, mut sequences): (Vec<LearnedMovement>, Vec<SequenceInfo>) = (Vec::new(), Vec::new());
    for item in items {
        let (read, infos) = movement(item.clone(), &primitives, &latent, order)?;
        if movements.iter().any(|other| other.name == read.name) {
            return Err(item
                .error(format!("expected a name of its own, found {:?} twice", read.name))
                .into());
        }
        movements.push(read);
        sequences.extend(infos);
    }
    count(&field, sequences.len(), 0..=MOST_SEQUENCES)?;
    let (provenance, terms) = provenance(head.document.get("provenance")?, m)?;
    let body = head.finish(layout, sequences)?;
    let parts = maps.into_iter().map(|map| map.solved(jitter)).collect::<Result<_, _>>()?;
    let library = Library { order, jitter, parts, pose_sums, primitives, movements, terms };
    Ok(TrainedLibrary { library, body, provenance })
}

fn primitive(field: Field, latent: &[usize], order: usize, jitter: f64) -> Result<Primitive, DocumentError> {
    let mut object = field.object()?;
    let name = object.get("name")?.text()?.to_owned();
    let part = object.get("part")?;
    let part = count(&part, part.whole()?, 0..=latent.len() - 1)?;
    let field = object.get("experts")?;
    let items = field.items()?;
    count(&field, items.len(), latent.len()..=latent.len())?;
    let mut experts = Vec::with_capacity(items.len());
    for (item, q) in items.into_iter().zip(latent) {
        let mut object = item.object()?;
        let read = expert(&mut object, order * latent[part], *q)?;
        let points = read.z.nrows();
        let field = object.get("u_covariance")?;
        let covariance = bounded_matrix(&field)?;
        shape(&field, &covariance, points, points)?;
        let external: Option<ExternalEvidence> = external_evidence(&mut object, points, *q)?;
        object.end()?;
        experts.push(LibraryExpert { fitted: read.solved(jitter)?, covariance, external });
    }
    // Absent: the primitive comes from the library's training, and has no excerpts of other movements.
    let origin = object.optional("origin").filter(is_there).map(origin).transpose()?.map(Box::new);
    let excerpts = match object.optional("excerpts").filter(is_there) {
        Some(field) => {
            count(&field, field.items()?.len(), 0..=MOST)?;
            field.list(|item| excerpt(item, latent, order))?
        }
        None => Vec::new(),
    };
    object.end()?;
    Ok(Primitive { name, part, experts, origin, excerpts })
}

fn is_there(field: &Field) -> bool {
    *field.value() != Value::Null
}

fn origin(field: Field) -> Result<Origin, FieldError> {
    let mut object = field.object()?;
    let training = training(&mut object)?;
    let clips = clips(object.get("clips")?)?;
    let relearned = object.optional("relearned").filter(is_there).map(relearned).transpose()?;
    object.end()?;
    Ok(Origin { training, clips, relearned })
}

fn clips(field: Field) -> Result<Vec<SequenceInfo>, FieldError> {
    count(&field, field.items()?.len(), 0..=MOST_SEQUENCES)?;
    field.list(|item| {
        let mut object = item.object()?;
        let info = sequence_info(&mut object)?;
        object.end()?;
        Ok(info)
    })
}

fn relearned(field: Field) -> Result<Relearned, FieldError> {
    let mut object = field.object()?;
    let primitive = object.get("primitive")?.text()?.to_owned();
    let frames = object.get("frames")?;
    let frames =
        FramesFrom::from_id(frames.text()?).ok_or_else(|| frames.wrong("clips, remembered or generated"))?;
    let clips = clips(object.get("clips")?)?;
    object.end()?;
    Ok(Relearned { primitive, clips, frames })
}

fn excerpt(field: Field, latent: &[usize], order: usize) -> Result<Excerpt, FieldError> {
    let mut object = field.object()?;
    let movement = object.get("movement")?.text()?.to_owned();
    let field = object.get("alpha")?;
    let alpha = field.numbers()?;
    count(&field, alpha.len(), latent.len()..=latent.len())?;
    positive(&field, &alpha)?;
    let field = object.get("starts")?;
    count(&field, field.items()?.len(), 0..=MOST_SEQUENCES)?;
    let starts = field.list(|item| start(item, latent, order..=MOST_FRAMES))?;
    object.end()?;
    Ok(Excerpt { movement, alpha, starts })
}

fn movement(
    field: Field,
    primitives: &[Primitive],
    latent: &[usize],
    order: usize,
) -> Result<(LearnedMovement, Vec<SequenceInfo>), DocumentError> {
    let m = latent.len();
    let mut object = field.object()?;
    let name = object.get("name")?.text()?.to_owned();
    let field = object.get("uses")?;
    let uses = field.list(|item| item.whole())?;
    count(&field, uses.len(), m..=m)?;
    for (part, used) in uses.iter().enumerate() {
        if primitives.get(*used).is_none_or(|primitive| primitive.part != part) {
            let message = format!("expected a primitive of part {part} in its place, found primitive {used}");
            return Err(field.error(message).into());
        }
    }
    let field = object.get("alpha")?;
    let alpha = field.matrix()?;
    shape(&field, &alpha, m, m)?;
    positive(&field, alpha.as_slice())?;
    let points = |i: usize| uses.iter().map(|a| primitives[*a].experts[i].covariance.nrows()).sum::<usize>();
    let sums = match object.optional("sums") {
        Some(field) if *field.value() != Value::Null => {
            let items = field.items()?;
            count(&field, items.len(), m..=m)?;
            let read = items.into_iter().enumerate().map(|(i, item)| sums(item, points(i), latent[i]));
            Some(read.collect::<Result<Vec<_>, _>>()?)
        }
        _ => None,
    };
    let (infos, starts): (Vec<_>, Vec<_>) =
        object.get("sequences")?.list(|item| sequence(item, latent, order))?.into_iter().unzip();
    let couplings = couplings(object.get("couplings")?)?;
    let rollout_rounds = rollout_rounds(&mut object)?;
    object.end()?;
    Ok((LearnedMovement { name, uses, alpha, sums, starts, couplings, rollout_rounds }, infos))
}

fn sums(field: Field, points: usize, q: usize) -> Result<DynamicsSums, FieldError> {
    let mut object = field.object()?;
    let mut matrix = |name: &str, width: usize| -> Result<DMatrix<f64>, FieldError> {
        let field = object.get(name)?;
        let matrix = bounded_matrix(&field)?;
        shape(&field, &matrix, points, width)?;
        Ok(matrix)
    };
    let sums = DynamicsSums { psi2: matrix("sum_psi2", points)?, psi1_mu: matrix("sum_psi1_mu", q)? };
    object.end()?;
    Ok(sums)
}

fn couplings(field: Field) -> Result<CouplingsFrom, FieldError> {
    let mut object: Object = field.object()?;
    let from = object.get("from")?;
    let read = match from.text()? {
        "training" => CouplingsFrom::Training,
        "hand" => CouplingsFrom::Hand,
        "nothing" => CouplingsFrom::Nothing,
        "movement" => CouplingsFrom::Movement { movement: object.get("movement")?.text()?.to_owned() },
        "clips" => CouplingsFrom::Clips {
            bound: object.get("bound")?.number()?,
            iterations: object.get("iterations")?.whole()?,
        },
        _ => return Err(from.wrong("training, clips, movement, hand or nothing")),
    };
    object.end()?;
    Ok(read)
}
