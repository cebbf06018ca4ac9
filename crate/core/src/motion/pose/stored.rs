//! Writes a pose mapping into a document and reads it.

use crate::json::{Field, FieldError, Value};
use crate::motion::pose::mapping::PoseMapping;
use crate::motion::skeleton::{Channel, Joint, Skeleton};
use crate::motion::stage::{Stage, UpAxis};

/// The largest size of a number; products of larger ones could overflow.
const LARGEST: f64 = 1e12;

impl PoseMapping {
    /// The mapping as JSON.
    pub(crate) fn to_value(&self) -> Value {
        let stage = Value::object([
            ("up", Value::text(self.stage.up.name())),
            ("height", Value::Number(self.stage.height)),
            ("ground", Value::Number(self.stage.ground)),
        ]);
        let climbs_from = self.climbs_from.map(|height| ("climbs_from", Value::Number(height)));
        let fields = [
            ("skeleton", Value::object([("joints", Value::list(&self.skeleton.joints, joint_value))])),
            ("stage", stage),
            ("upright", Value::numbers(&self.upright)),
            ("positions", triples_value(&self.positions)),
            ("first", triples_value(&self.first)),
        ];
        Value::of_fields(fields.into_iter().chain(climbs_from).collect())
    }

    /// Reads a mapping and checks its skeleton, stage and sizes.
    pub(crate) fn from_field(field: Field) -> Result<PoseMapping, FieldError> {
        let mut mapping = field.object()?;
        let field = mapping.get("skeleton")?;
        let mut object = field.clone().object()?;
        let skeleton = Skeleton { joints: object.get("joints")?.list(joint)? };
        object.end()?;
        skeleton.validate().map_err(|problem| field.error(problem.to_string()))?;
        let stage = stage(mapping.get("stage")?)?;
        let field = mapping.get("upright")?;
        let upright: [f64; 4] = field.array()?;
        let norm = upright.iter().map(|x| x * x).sum::<f64>().sqrt();
        if !(0.999999..1.000001).contains(&norm) {
            return Err(field.error("expected four numbers whose squares add up to 1"));
        }
        let joints = skeleton.joints.len();
        let positions = triples(&mapping.get("positions")?, joints)?;
        let first = triples(&mapping.get("first")?, joints)?;
        let climbs_from = match mapping.optional("climbs_from") {
            Some(field) => match field.number()? {
                height if height.abs() < LARGEST => Some(height),
                _ => return Err(field.wrong("a height below 1e12 in size")),
            },
            None => None,
        };
        mapping.end()?;
        Ok(PoseMapping { skeleton, stage, upright, positions, first, climbs_from })
    }
}

fn triples_value(triples: &[[f64; 3]]) -> Value {
    Value::list(triples, |triple| Value::numbers(triple))
}

fn joint_value(joint: &Joint) -> Value {
    Value::object([
        ("name", Value::text(&joint.name)),
        ("parent", joint.parent.map_or(Value::Null, Value::whole)),
        ("offset", Value::numbers(&joint.offset)),
        ("channels", Value::list(&joint.channels, |channel| Value::text(channel.name()))),
        ("end_sites", triples_value(&joint.end_sites)),
    ])
}

fn joint(field: Field) -> Result<Joint, FieldError> {
    let mut object = field.object()?;
    let parent = object.get("parent")?;
    let joint = Joint {
        name: object.get("name")?.text()?.to_owned(),
        parent: if *parent.value() == Value::Null { None } else { Some(parent.whole()?) },
        offset: object.get("offset")?.array()?,
        channels: object.get("channels")?.list(channel)?,
        end_sites: object.get("end_sites")?.list(|end| end.array())?,
    };
    object.end()?;
    Ok(joint)
}

fn channel(field: Field) -> Result<Channel, FieldError> {
    Channel::from_name(field.text()?).ok_or_else(|| field.error("expected a channel such as \"Xrotation\""))
}

fn stage(field: Field) -> Result<Stage, FieldError> {
    let mut object = field.object()?;
    let field = object.get("up")?;
    let up = UpAxis::from_name(field.text()?)
        .ok_or_else(|| field.error("expected one of \"x\", \"y\", \"z\", \"-x\", \"-y\", \"-z\""))?;
    let field = object.get("height")?;
    let height = field.number()?;
    if !(1.0 / LARGEST..LARGEST).contains(&height) {
        return Err(field.wrong("a positive number"));
    }
    let field = object.get("ground")?;
    let ground = field.number()?;
    if ground.abs() >= LARGEST {
        return Err(field.wrong("a height below 1e12 in size"));
    }
    object.end()?;
    Ok(Stage { up, height, ground })
}

/// Three numbers of sensible size for each joint.
fn triples(field: &Field, joints: usize) -> Result<Vec<[f64; 3]>, FieldError> {
    let triples = field.list(|item| item.array::<3>())?;
    if triples.len() != joints {
        return Err(field.wrong(&format!("three numbers for each of the {joints} joints")));
    }
    match triples.iter().flatten().find(|x| x.abs() >= LARGEST) {
        None => Ok(triples),
        Some(x) => Err(field.error(format!("expected numbers below 1e12 in size, found {x}"))),
    }
}
