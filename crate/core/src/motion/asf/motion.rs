//! Reads the frames of an AMC file.

use crate::motion::asf::file::AsfError;
use crate::motion::asf::file::{File, Line, lines};
use crate::motion::asf::skeleton::{AsfBody, Dof, turned};
use crate::motion::rotation;
use nalgebra::{DMatrix, UnitQuaternion, Vector3};
use std::ops::Range;

/// Rotations are written as BVH's angles about z, y and x.
const ZYX: [usize; 3] = [2, 1, 0];
/// A warning lists this many bones; it counts the others.
const MOST_NAMES: usize = 3;

/// A frame of the file.
struct Frame {
    /// Its number in the file, and the line of the number.
    number: u64,
    line: usize,
    /// Channel values; 0 for joints without a line.
    values: Vec<f64>,
    /// Whether each joint has a line.
    given: Vec<bool>,
}

/// Channel values [frames x channels] of the skeleton's joints, and what is unusual about the file.
pub(super) fn read(file: File, body: &AsfBody) -> Result<(DMatrix<f64>, Vec<String>), AsfError> {
    let text = String::from_utf8_lossy(file.bytes);
    let lines = lines(file.name, &text);
    let mut degrees = body.degrees;
    let channels = body.skeleton.channel_count();
    let most = body.skeleton.max_frames();
    let joints = body.turnings.len();
    // Angles of the previous frame, so that the next do not jump.
    let mut previous = vec![[0.0; 3]; joints];
    let mut frames: Vec<Frame> = Vec::new();
    // The first line with a number that is not read, and its bone.
    let mut moving: Option<(usize, &str)> = None;
    for line in &lines {
        let Some(&first) = line.words.first() else { break };
        if first.starts_with(':') {
            degrees = match first.to_ascii_uppercase().as_str() {
                ":DEGREES" => true,
                ":RADIANS" => false,
                _ => degrees,
            };
            continue;
        }
        if line.words.len() == 1 && first.bytes().all(|c| c.is_ascii_digit()) {
            if frames.len() >= most {
                return Err(line.error(format!("at most {most} frames")));
            }
            let number = first.parse().unwrap_or(u64::MAX);
            let (values, given) = (vec![0.0; channels], vec![false; joints]);
            frames.push(Frame { number, line: line.number, values, given });
            continue;
        }
        let Frame { values, given, .. } =
            frames.last_mut().ok_or_else(|| line.error("the number of a frame"))?;
        let joint = body.turnings.iter().position(|turning| turning.name == first);
        let joint = joint.ok_or_else(|| line.error("a bone of the skeleton"))?;
        let unit = if degrees { 1f64.to_radians() } else { 1.0 };
        let Moved { place, turn, ignored } = moved(line, body, joint, unit)?;
        if ignored && moving.is_none() {
            moving = Some((line.number, first));
        }
        let angles = rotation::angles_near(&turn, &ZYX, &previous[joint]);
        previous[joint] = angles;
        given[joint] = true;
        if joint == 0 {
            values[..3].copy_from_slice(place.as_slice());
        }
        values[angles_of(joint)].copy_from_slice(&angles.map(f64::to_degrees));
    }
    if frames.is_empty() {
        return Err(lines[lines.len() - 1].error("at least one frame"));
    }
    let mut warnings = Vec::new();
    warnings.extend(moving.map(|(line, bone)| {
        format!("line {line}: {bone} changes its place or length, but bones below the root are only turned")
    }));
    warnings.extend(jump(&frames));
    warnings.extend(fill(&mut frames, body));
    if !frames.iter().any(|frame| frame.given[0]) {
        warnings
            .push("no frame has a line of root: the body stays at the origin and does not turn".to_owned());
    }
    let values: Vec<f64> = frames.iter().flat_map(|frame| &frame.values).copied().collect();
    Ok((DMatrix::from_row_slice(frames.len(), channels, &values), warnings))
}

/// The channels of a joint's angles. The root has three positions before them.
fn angles_of(joint: usize) -> Range<usize> {
    3 + 3 * joint..6 + 3 * joint
}

/// A warning about the first frame whose number does not follow that of the frame before.
fn jump(frames: &[Frame]) -> Option<String> {
    let step = |pair: &[Frame]| pair[1].number.checked_sub(pair[0].number).filter(|step| *step > 0);
    let usual = frames.windows(2).filter_map(step).min()?;
    let jump = frames.windows(2).find(|pair| step(pair) != Some(usual))?;
    let ([before, after], line) = ([&jump[0], &jump[1]].map(|frame| frame.number), jump[1].line);
    let why = if after > before {
        "frames are missing there, and the motion jumps over them"
    } else {
        "the number is wrong, or another recording begins there"
    };
    Some(format!(
        "line {line}: frame {after} follows frame {before}: {why} (clip --frames keeps the frames before or after)"
    ))
}

/// Gives joints that only some frames have their pose of the nearest frame before, or else after. A joint
/// that all frames omit is at rest.
fn fill(frames: &mut [Frame], body: &AsfBody) -> Option<String> {
    let mut names = Vec::new();
    let mut incomplete = vec![false; frames.len()];
    for (joint, turning) in body.turnings.iter().enumerate() {
        let Some(first) = frames.iter().position(|frame| frame.given[joint]) else { continue };
        if frames.iter().all(|frame| frame.given[joint]) {
            continue;
        }
        names.push(turning.name.as_str());
        let channels = if joint == 0 { 0..6 } else { angles_of(joint) };
        let mut known = frames[first].values[channels.clone()].to_vec();
        for (frame, incomplete) in frames.iter_mut().zip(&mut incomplete) {
            if frame.given[joint] {
                known.copy_from_slice(&frame.values[channels.clone()]);
            } else {
                frame.values[channels.clone()].copy_from_slice(&known);
                *incomplete = true;
            }
        }
    }
    let first = &frames[incomplete.iter().position(|is| *is)?];
    let count = incomplete.iter().filter(|is| **is).count();
    let shown = names.iter().take(MOST_NAMES).copied().collect::<Vec<_>>().join(", ");
    let more = names.len().saturating_sub(MOST_NAMES);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    Some(format!(
        "{count} of {} frames have no lines of {shown}{more}, first frame {} (line {}): these bones keep \
         the pose of the nearest frame that has them",
        frames.len(),
        first.number,
        first.line
    ))
}

/// Where a line moves a joint.
struct Moved {
    place: Vector3<f64>,
    turn: UnitQuaternion<f64>,
    /// Whether the bone changes its place or length, which is not read below the root.
    ignored: bool,
}

/// Position and rotation of a joint from the numbers of a line.
fn moved(line: &Line, body: &AsfBody, joint: usize, unit: f64) -> Result<Moved, AsfError> {
    let turning = &body.turnings[joint];
    if line.words.len() != turning.dofs.len() + 1 {
        return Err(line.error(format!("{} numbers of {}", turning.dofs.len(), turning.name)));
    }
    let numbers = line.numbers(turning.dofs.len())?;
    let mut place = Vector3::zeros();
    let mut turns = Vec::new();
    let mut ignored = false;
    for (dof, number) in turning.dofs.iter().zip(numbers) {
        match *dof {
            Dof::Translation(axis) => place[axis] += number,
            Dof::Rotation(axis) => turns.push((axis, unit * number)),
            Dof::Length => ignored |= number != 0.0,
        }
    }
    let own = turned(turns.into_iter());
    if joint == 0 {
        return Ok(Moved { place: body.root_place + place, turn: own * body.root_turn, ignored });
    }
    // The file gives the bone's axis in the world at rest.
    ignored |= place != Vector3::zeros();
    Ok(Moved { place, turn: turning.axis * own * turning.axis.inverse(), ignored })
}
