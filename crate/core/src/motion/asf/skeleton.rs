//! Reads the skeleton of an ASF file.

use crate::motion::asf::file::AsfError;
use crate::motion::asf::file::{File, Line, lines};
use crate::motion::rotation;
use crate::motion::skeleton::{Channel, Joint, Skeleton};
use nalgebra::{UnitQuaternion, Vector3};
use std::collections::HashMap;

/// More bones than a body has.
const MOST_BONES: usize = 2000;

/// The names that the usual conversions to BVH give the bones of the CMU database.
const NAMES: [(&str, &str); 31] = [
    ("root", "Hips"),
    ("lhipjoint", "LHipJoint"),
    ("lfemur", "LeftUpLeg"),
    ("ltibia", "LeftLeg"),
    ("lfoot", "LeftFoot"),
    ("ltoes", "LeftToeBase"),
    ("rhipjoint", "RHipJoint"),
    ("rfemur", "RightUpLeg"),
    ("rtibia", "RightLeg"),
    ("rfoot", "RightFoot"),
    ("rtoes", "RightToeBase"),
    ("lowerback", "LowerBack"),
    ("upperback", "Spine"),
    ("thorax", "Spine1"),
    ("lowerneck", "Neck"),
    ("upperneck", "Neck1"),
    ("head", "Head"),
    ("lclavicle", "LeftShoulder"),
    ("lhumerus", "LeftArm"),
    ("lradius", "LeftForeArm"),
    ("lwrist", "LeftHand"),
    ("lhand", "LeftFingerBase"),
    ("lfingers", "LeftHandIndex1"),
    ("lthumb", "LThumb"),
    ("rclavicle", "RightShoulder"),
    ("rhumerus", "RightArm"),
    ("rradius", "RightForeArm"),
    ("rwrist", "RightHand"),
    ("rhand", "RightFingerBase"),
    ("rfingers", "RightHandIndex1"),
    ("rthumb", "RThumb"),
];

/// A degree of freedom: the meaning of a number in an AMC line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Dof {
    /// Translation along an axis.
    Translation(usize),
    /// Rotation about an axis.
    Rotation(usize),
    /// The bone's length, which is ignored.
    Length,
}

/// The degrees of freedom of a joint.
#[derive(Clone, Debug)]
pub(super) struct Turning {
    /// The bone's name in the files.
    pub(super) name: String,
    /// The orientation of the bone's own axes.
    pub(super) axis: UnitQuaternion<f64>,
    /// Its numbers in their order.
    pub(super) dofs: Vec<Dof>,
}

/// A skeleton with the joints of BVH, and the degrees of freedom of each joint.
pub(super) struct AsfBody {
    pub(super) skeleton: Skeleton,
    pub(super) turnings: Vec<Turning>,
    /// Whether angles are degrees.
    pub(super) degrees: bool,
    /// Position and orientation of the root at rest.
    pub(super) root_place: Vector3<f64>,
    pub(super) root_turn: UnitQuaternion<f64>,
}

/// The product of rotations about fixed axes, the first applied first.
pub(super) fn turned(order: impl Iterator<Item = (usize, f64)>) -> UnitQuaternion<f64> {
    order.fold(UnitQuaternion::identity(), |turn, (axis, angle)| rotation::about_axis(axis, angle) * turn)
}

/// A bone of the file.
struct Bone {
    turning: Turning,
    reach: Vector3<f64>,
}

/// Reads the file.
pub(super) fn read(file: File) -> Result<AsfBody, AsfError> {
    let text = String::from_utf8_lossy(file.bytes);
    let lines = lines(file.name, &text);
    let section = |name: &str| -> Result<&[Line], AsfError> {
        let begin =
            lines.iter().position(|line| line.words.first().is_some_and(|w| w.eq_ignore_ascii_case(name)));
        let begin = begin.ok_or_else(|| lines[lines.len() - 1].error(format!("a section {name}")))?;
        let rest = &lines[begin + 1..];
        let end = rest.iter().position(|line| line.words.first().is_none_or(|word| word.starts_with(':')));
        Ok(&rest[..end.unwrap_or(rest.len())])
    };
    let degrees = !section(":units").is_ok_and(|lines| {
        lines
            .iter()
            .any(|line| line.words.len() > 1 && line.words[0] == "angle" && line.words[1].starts_with("rad"))
    });
    let unit = if degrees { 1f64.to_radians() } else { 1.0 };
    let (root, root_place, root_turn) = root(section(":root")?, unit)?;
    let bones = bones(section(":bonedata")?, unit)?;
    let parents = section(":hierarchy")?;
    let (skeleton, turnings) = joints(root, bones, parents)?;
    Ok(AsfBody { skeleton, turnings, degrees, root_place, root_turn })
}

fn root(lines: &[Line], unit: f64) -> Result<(Turning, Vector3<f64>, UnitQuaternion<f64>), AsfError> {
    let mut turning = Turning { name: "root".to_owned(), axis: UnitQuaternion::identity(), dofs: Vec::new() };
    let (mut place, mut angles, mut order) = (Vector3::zeros(), vec![0.0; 3], vec![0, 1, 2]);
    for line in lines {
        match line.words[0] {
            "order" => {
                turning.dofs = line.words[1..].iter().map(|word| dof(word, line)).collect::<Result<_, _>>()?
            }
            "axis" => order = axes(line.words.get(1).copied().unwrap_or_default(), line)?,
            "position" => place = Vector3::from_column_slice(&line.numbers(3)?),
            "orientation" => angles = line.numbers(3)?,
            _ => return Err(line.error("order, axis, position or orientation of the root")),
        }
    }
    let turn = turned(order.into_iter().map(|axis| (axis, unit * angles[axis])));
    Ok((turning, place, turn))
}

fn bones(lines: &[Line], unit: f64) -> Result<HashMap<String, Bone>, AsfError> {
    let mut bones = HashMap::new();
    let (mut name, mut direction, mut length) = (String::new(), Vector3::zeros(), 0.0);
    let (mut axis, mut dofs) = (UnitQuaternion::identity(), Vec::new());
    for line in lines {
        match line.words[0] {
            "begin" => (name, direction, length, axis, dofs) = Default::default(),
            "name" => name = line.words.get(1).copied().unwrap_or_default().to_owned(),
            "direction" => direction = Vector3::from_column_slice(&line.numbers(3)?),
            "length" => length = line.numbers(1)?[0],
            "axis" => {
                let angles = line.numbers(3)?;
                let order = axes(line.words.get(4).copied().unwrap_or("XYZ"), line)?;
                axis = turned(order.into_iter().map(|axis| (axis, unit * angles[axis])));
            }
            "dof" => dofs = line.words[1..].iter().map(|word| dof(word, line)).collect::<Result<_, _>>()?,
            "end" => {
                if name.is_empty() {
                    return Err(line.error("the name of the bone before its end"));
                }
                let reach = direction.try_normalize(1e-9).unwrap_or_else(Vector3::zeros) * length;
                let turning = Turning { name: name.clone(), axis, dofs: std::mem::take(&mut dofs) };
                if bones.insert(name.clone(), Bone { turning, reach }).is_some() || bones.len() > MOST_BONES {
                    return Err(
                        line.error(format!("fewer than {MOST_BONES} bones, each once, not {name} again"))
                    );
                }
            }
            // Limits, ids and masses are ignored.
            _ => {}
        }
    }
    Ok(bones)
}

/// The joints in depth-first order.
fn joints(
    root: Turning,
    mut bones: HashMap<String, Bone>,
    lines: &[Line],
) -> Result<(Skeleton, Vec<Turning>), AsfError> {
    let mut children: HashMap<&str, (&Line, &[&str])> = HashMap::new();
    for line in lines.iter().filter(|line| !["begin", "end"].contains(&line.words[0])) {
        children.insert(line.words[0], (line, &line.words[1..]));
    }
    let channels = |root: bool| {
        let places = [Channel::Xposition, Channel::Yposition, Channel::Zposition];
        let turns = [Channel::Zrotation, Channel::Yrotation, Channel::Xrotation];
        places.into_iter().filter(|_| root).chain(turns).collect()
    };
    let mut joints = vec![Joint {
        name: bvh_name(&root.name),
        parent: None,
        offset: [0.0; 3],
        channels: channels(true),
        end_sites: Vec::new(),
    }];
    let mut turnings = vec![root];
    // A stack of joints to add: name, parent, offset, line.
    let children_of =
        |name: &str, parent: usize, offset: Vector3<f64>| -> Vec<(String, usize, Vector3<f64>, usize)> {
            let Some((line, names)) = children.get(name) else { return Vec::new() };
            names.iter().rev().map(|child| ((*child).to_owned(), parent, offset, line.number)).collect()
        };
    let mut open = children_of("root", 0, Vector3::zeros());
    while let Some((name, parent, offset, number)) = open.pop() {
        let Some(Bone { turning, reach }) = bones.remove(&name) else {
            let line = lines.iter().find(|line| line.number == number);
            let error = line.map(|line| line.error(format!("bones of :bonedata, each once, not {name:?}")));
            return Err(error.unwrap_or_else(|| lines[0].error("bones of :bonedata")));
        };
        let place = joints.len();
        let next = children_of(&name, place, reach);
        let end_sites = if next.is_empty() { vec![reach.into()] } else { Vec::new() };
        joints.push(Joint {
            name: bvh_name(&name),
            parent: Some(parent),
            offset: offset.into(),
            channels: channels(false),
            end_sites,
        });
        turnings.push(turning);
        open.extend(next);
    }
    Ok((Skeleton { joints }, turnings))
}

fn bvh_name(name: &str) -> String {
    let entry = NAMES.iter().find(|(bone, _)| *bone == name);
    entry.map_or(name, |(_, joint)| joint).to_owned()
}

fn dof(word: &str, line: &Line) -> Result<Dof, AsfError> {
    let lower = word.to_ascii_lowercase();
    match lower.as_str() {
        "tx" | "ty" | "tz" => Ok(Dof::Translation(usize::from(lower.as_bytes()[1] - b'x'))),
        "rx" | "ry" | "rz" => Ok(Dof::Rotation(usize::from(lower.as_bytes()[1] - b'x'))),
        "l" => Ok(Dof::Length),
        _ => Err(line.error("some of TX, TY, TZ, RX, RY, RZ and L")),
    }
}

/// "XYZ" as 0, 1, 2.
fn axes(word: &str, line: &Line) -> Result<Vec<usize>, AsfError> {
    let axes: Vec<usize> =
        word.to_ascii_uppercase().bytes().filter_map(|c| "XYZ".bytes().position(|x| x == c)).collect();
    let mut sorted = axes.clone();
    sorted.sort_unstable();
    if sorted == [0, 1, 2] { Ok(axes) } else { Err(line.error("the three axes in some order, such as XYZ")) }
}
