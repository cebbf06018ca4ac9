//! Reads a study from a JSON tree. Every field is checked.

use crate::perception::design::Design;
use crate::perception::error::{StudyError, VERSION};
use crate::perception::movement::FigureMovement;
use crate::perception::record::{short, whole};
use crate::perception::stimulus::{Generated, MovementSource, Scores, Stimulus};
use crate::perception::study::{Figure, Look, Study, Texts};
use std::collections::HashSet;
use vcgpdm_core::document::read_settings;
use vcgpdm_core::json::checks::{bounded, count, within};
use vcgpdm_core::json::{Field, FieldError, Object, Value, check_heading};
use vcgpdm_core::models::ModelKind;
use vcgpdm_core::models::variational::BoundTerms;
use vcgpdm_core::motion::landmarks::Landmarks;

const MOST_STIMULI: usize = 5_000;
const MOST_NODES: usize = 500;
const MOST_FRAMES: usize = 2_400;
const MOST_PARTS: usize = 100;
/// Most letters of a title or name, and of an id.
const TITLE: usize = 200;
const ID: usize = 100;

pub(super) fn study(value: &Value) -> Result<Study, StudyError> {
    let mut document = Field::root(value).object()?;
    check_heading(&mut document, Study::FORMAT, VERSION..=VERSION)?;
    let title = short(&document.get("title")?, TITLE)?;
    let look = document.get("look")?;
    let look = Look::from_id(look.text()?).ok_or_else(|| look.error("expected figure or points"))?;
    let seconds_field = document.get("seconds")?;
    let seconds = within(seconds_field.clone(), Study::SECONDS, "seconds from 0.1 to 60")?;
    let cross_seconds = within(document.get("cross_seconds")?, 0.0..=60.0, "seconds from 0 to 60")?;
    let texts = Texts::read(document.get("texts")?)?;
    let design = Design::read(document.get("design")?)?;
    let frames_per_second = whole(document.get("frames_per_second")?, 10..=240)?;
    let unit = within(document.get("metres_per_unit")?, 1e-5..=0.1, "metres from 0.00001 to 0.1")?;
    let (figure, height) = figure(document.get("figure")?)?;
    let field = document.get("stimuli")?;
    let nodes = figure.names.len();
    let stimuli = field.list(|item| stimulus(item, nodes))?;
    count(&field, stimuli.len(), 2..=MOST_STIMULI)?;
    document.end()?;
    let mut ids = HashSet::new();
    if let Some(twice) = stimuli.iter().find(|stimulus| !ids.insert(stimulus.id.as_str())) {
        return Err(field.error(format!("expected different ids, found \"{}\" twice", twice.id)).into());
    }
    let any = |wanted: &dyn Fn(&Stimulus) -> bool| stimuli.iter().any(wanted);
    if !any(&|s| s.natural() == Some(true)) {
        return Err(field.error("expected a natural movement that is \"seen\", found none").into());
    }
    if !any(&|s| s.generated().is_some_and(|generated| !generated.failed)) {
        return Err(field.error("expected a generated movement that has not failed, found none").into());
    }
    let study = Study {
        title,
        look,
        frames_per_second,
        seconds,
        cross_seconds,
        texts,
        design,
        figure,
        height,
        unit,
        stimuli,
    };
    let longest = study.longest();
    if study.frames() == 0 || study.seconds > longest + 0.5 / frames_per_second as f64 {
        let expected = format!("at most the {longest:.2} seconds of the shortest movement");
        return Err(seconds_field.wrong(&expected).into());
    }
    Ok(study)
}

fn figure(field: Field) -> Result<(Figure, f64), FieldError> {
    let mut object = field.object()?;
    let list = object.get("names")?;
    let names = list.list(|name| short(&name, TITLE))?;
    let nodes = count(&list, names.len(), 1..=MOST_NODES)?;
    let list = object.get("parents")?;
    let mut place = 0;
    let parents = list.list(|parent| {
        place += 1;
        match parent.value() {
            Value::Null => Ok(None),
            _ if place == 1 => Err(parent.wrong("null, as the first node is the root")),
            _ => whole(parent, 0..=place - 2).map(Some),
        }
    })?;
    count(&list, parents.len(), nodes..=nodes)?;
    let joints = whole(object.get("joints")?, 1..=nodes)?;
    let height = within(object.get("height")?, 0.1..=10.0, "metres from 0.1 to 10")?;
    let node = |field: Field| whole(field, 0..=nodes - 1);
    let head = object.optional("head").map(node).transpose()?;
    let feet = match object.optional("feet") {
        None => None,
        Some(field) => match field.list(node)?[..] {
            [left, right] => Some([left, right]),
            _ => return Err(field.wrong("two nodes")),
        },
    };
    let field = object.get("dots")?;
    let dots = field.list(node)?;
    count(&field, dots.len(), 1..=nodes)?;
    object.end()?;
    Ok((Figure { names, parents, joints, landmarks: Landmarks { head, feet, dots } }, height))
}

fn stimulus(field: Field, nodes: usize) -> Result<Stimulus, FieldError> {
    let mut object = field.object()?;
    let id = object.get("id")?;
    let name = short(&id, ID)?;
    let letter = |c: char| c.is_ascii_alphanumeric() || "._+-".contains(c);
    if !name.starts_with(|c: char| c.is_ascii_alphabetic()) || !name.chars().all(letter) {
        return Err(id.error("expected letters, digits and any of . _ + -, a letter first"));
    }
    let kind = object.get("kind")?;
    let trial = short(&object.get("trial")?, TITLE)?;
    let source = match kind.text()? {
        "natural" => MovementSource::Natural { seen: object.get("seen")?.boolean()? },
        "generated" => MovementSource::Generated(Box::new(generated(&mut object)?)),
        _ => return Err(kind.error("expected natural or generated")),
    };
    let speed = within(object.get("speed")?, 0.0..=1000.0, "metres a second from 0 to 1000")?;
    let frames = whole(object.get("frames")?, 1..=MOST_FRAMES)?;
    let places = object.get("places")?;
    let movement = FigureMovement::from_text(places.text()?, frames, nodes)
        .map_err(|reason| places.error(reason.to_string()))?;
    object.end()?;
    Ok(Stimulus { id: name, trial, source, speed, movement })
}

fn generated(object: &mut Object) -> Result<Generated, FieldError> {
    let failed = object.get("failed")?.boolean()?;
    let model = object.get("model")?;
    let kind = ModelKind::from_id(model.text()?).ok_or_else(|| {
        let ids: Vec<&str> = ModelKind::ALL.into_iter().map(ModelKind::id).collect();
        model.error(format!("expected one of {}", ids.join(", ")))
    })?;
    let (candidate, seed) = read_settings(object.get("settings")?, kind)?;
    let scores = scores(object.get("scores")?)?;
    Ok(Generated { candidate, seed, failed, scores })
}

fn scores(field: Field) -> Result<Scores, FieldError> {
    let mut object = field.object()?;
    let error = |field: Field| within(field, 0.0..=1e300, "an error from 0");
    let mse = error(object.get("mse")?)?;
    let dtw_mse = error(object.get("dtw_mse")?)?;
    let training_mse = object.optional("training_mse").map(error).transpose()?;
    let bound = object.optional("bound").map(|field| nats(&field)).transpose()?;
    let terms = object.optional("terms").map(terms).transpose()?;
    object.end()?;
    Ok(Scores { mse, dtw_mse, training_mse, bound, terms })
}

fn terms(field: Field) -> Result<BoundTerms, FieldError> {
    let mut object = field.object()?;
    let kinematics = object.get("kinematics")?;
    let dynamics = object.get("dynamics")?;
    let terms = BoundTerms {
        kinematics: kinematics.numbers()?,
        dynamics: dynamics.numbers()?,
        initial: nats(&object.get("initial")?)?,
        entropy: nats(&object.get("entropy")?)?,
    };
    bounded(&kinematics, &terms.kinematics)?;
    bounded(&dynamics, &terms.dynamics)?;
    count(&kinematics, terms.kinematics.len(), 1..=MOST_PARTS)?;
    count(&dynamics, terms.dynamics.len(), terms.kinematics.len()..=terms.kinematics.len())?;
    object.end()?;
    Ok(terms)
}

fn nats(field: &Field) -> Result<f64, FieldError> {
    let number = field.number()?;
    bounded(field, &[number])?;
    Ok(number)
}
