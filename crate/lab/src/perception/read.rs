//! Reads a study from a JSON tree. Every field is checked.

use crate::perception::design::Design;
use crate::perception::error::{StudyError, VERSION};
use crate::perception::movement::FigureMovement;
use crate::perception::stimulus::{Generated, MovementSource, Scores, Stimulus};
use crate::perception::study::{Figure, Look, Study, Texts};
use std::collections::HashSet;
use std::ops::RangeInclusive;
use vcgpdm::internals::json::checks::{bounded, count, within};
use vcgpdm::internals::json::{Field, FieldError, Object, Value, check_heading};
use vcgpdm::internals::read_settings;
use vcgpdm::models::ModelKind;
use vcgpdm::models::variational::BoundTerms;
use vcgpdm::motion::landmarks::Landmarks;

const MOST_STIMULI: usize = 5_000;
const MOST_NODES: usize = 500;
const MOST_FRAMES: usize = 2_400;
const MOST_TRIALS: usize = 10_000;
const MOST_PARTS: usize = 100;
/// Most letters of a title or name, of an id, and of a text to read.
const TITLE: usize = 200;
const ID: usize = 100;
const TEXT: usize = 20_000;

pub(super) fn study(value: &Value) -> Result<Study, StudyError> {
    let mut document = Field::root(value).object()?;
    check_heading(&mut document, Study::FORMAT, VERSION..=VERSION)?;
    let title = short(&document.get("title")?, TITLE)?;
    let look = document.get("look")?;
    let look = Look::from_id(look.text()?).ok_or_else(|| look.error("expected figure or points"))?;
    let seconds_field = document.get("seconds")?;
    let seconds = within(seconds_field.clone(), Study::SECONDS, "seconds from 0.1 to 60")?;
    let cross_seconds = within(document.get("cross_seconds")?, 0.0..=60.0, "seconds from 0 to 60")?;
    let texts = texts(document.get("texts")?)?;
    let design = design(document.get("design")?)?;
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

fn texts(field: Field) -> Result<Texts, FieldError> {
    let mut object = field.object()?;
    let mut read = |name: &str| short(&object.get(name)?, TEXT);
    let texts = Texts {
        consent: read("consent")?,
        instructions: read("instructions")?,
        question: read("question")?,
        pause: read("pause")?,
        end: read("end")?,
    };
    object.end()?;
    Ok(texts)
}

fn design(field: Field) -> Result<Design, FieldError> {
    let mut object = field.object()?;
    let seed = object.get("seed")?;
    let design = Design {
        blocks: whole(object.get("blocks")?, 1..=100)?,
        comparisons: whole(object.get("comparisons")?, 1..=MOST_TRIALS)?,
        attention_checks: whole(object.get("attention_checks")?, 0..=MOST_TRIALS)?,
        catch_trials: whole(object.get("catch_trials")?, 0..=MOST_TRIALS)?,
        pause_seconds: whole(object.get("pause_seconds")?, 0..=3600)?,
        answer_during_movement: object.get("answer_during_movement")?.boolean()?,
        seed: u32::try_from(seed.whole()?).map_err(|_| seed.wrong("a whole number from 0 to 4294967295"))?,
    };
    object.end()?;
    Ok(design)
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
    let bound = object.optional("bound").map(|field| nats(&field)).transpose()?;
    let terms = object.optional("terms").map(terms).transpose()?;
    object.end()?;
    Ok(Scores { mse, dtw_mse, bound, terms })
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

fn whole(field: Field, range: RangeInclusive<usize>) -> Result<usize, FieldError> {
    count(&field, field.whole()?, range)
}

/// A text of at most `most` letters.
fn short(field: &Field, most: usize) -> Result<String, FieldError> {
    let text = field.text()?;
    match text.chars().count() {
        found if found > most => Err(field.error(format!("expected at most {most} letters, found {found}"))),
        _ => Ok(text.to_owned()),
    }
}
