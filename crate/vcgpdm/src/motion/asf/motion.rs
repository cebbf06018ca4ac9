//! Reads the frames of an AMC file.

use crate::motion::asf::error::AsfError;
use crate::motion::asf::file::{File, Line, lines};
use crate::motion::asf::skeleton::{AsfBody, Dof, turned};
use crate::motion::rotation;
use nalgebra::{DMatrix, UnitQuaternion, Vector3};

/// Rotations are written as BVH's angles about z, y and x.
const ZYX: [usize; 3] = [2, 1, 0];

/// Channel values [frames x channels] of the skeleton's joints.
pub(super) fn read(file: File, body: &AsfBody) -> Result<DMatrix<f64>, AsfError> {
    let text = String::from_utf8_lossy(file.bytes);
    let lines = lines(file.name, &text);
    let mut degrees = body.degrees;
    let channels = body.skeleton.channel_count();
    let most = body.skeleton.max_frames();
    let mut values: Vec<f64> = Vec::new();
    // Angles of the previous frame, so that the next do not jump. A joint that a frame omits is at rest.
    let mut previous = vec![[0.0; 3]; body.turnings.len()];
    let mut row: Option<Vec<f64>> = None;
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
            values.extend(row.replace(vec![0.0; channels]).unwrap_or_default());
            if values.len() >= most.saturating_mul(channels) {
                return Err(line.error(format!("at most {most} frames")));
            }
            continue;
        }
        let row = row.as_mut().ok_or_else(|| line.error("the number of a frame"))?;
        let joint = body.turnings.iter().position(|turning| turning.name == first);
        let joint = joint.ok_or_else(|| line.error("a bone of the skeleton"))?;
        let unit = if degrees { 1f64.to_radians() } else { 1.0 };
        let (place, turn) = moved(line, body, joint, unit)?;
        let angles = rotation::angles_near(&turn, &ZYX, &previous[joint]);
        previous[joint] = angles;
        let at = if joint == 0 { 0 } else { 3 + 3 * joint };
        if joint == 0 {
            row[..3].copy_from_slice(place.as_slice());
        }
        let at = if joint == 0 { 3 } else { at };
        row[at..at + 3].copy_from_slice(&angles.map(f64::to_degrees));
    }
    values.extend(row.unwrap_or_default());
    if values.is_empty() {
        return Err(lines[lines.len() - 1].error("at least one frame"));
    }
    Ok(DMatrix::from_row_slice(values.len() / channels, channels, &values))
}

/// Position and rotation of a joint from the numbers of a line.
fn moved(
    line: &Line,
    body: &AsfBody,
    joint: usize,
    unit: f64,
) -> Result<(Vector3<f64>, UnitQuaternion<f64>), AsfError> {
    let turning = &body.turnings[joint];
    if line.words.len() != turning.dofs.len() + 1 {
        return Err(line.error(format!("{} numbers of {}", turning.dofs.len(), turning.name)));
    }
    let numbers = line.numbers(turning.dofs.len())?;
    let mut place = Vector3::zeros();
    let mut turns = Vec::new();
    for (dof, number) in turning.dofs.iter().zip(numbers) {
        match *dof {
            Dof::Translation(axis) => place[axis] += number,
            Dof::Rotation(axis) => turns.push((axis, unit * number)),
            Dof::Length => {}
        }
    }
    let own = turned(turns.into_iter());
    if joint == 0 {
        return Ok((body.root_place + place, own * body.root_turn));
    }
    // The file gives the bone's axis in the world at rest.
    Ok((place, turning.axis * own * turning.axis.inverse()))
}
