//! Reads the HIERARCHY section of a file.

use crate::motion::bvh::error::{BvhError, BvhProblem};
use crate::motion::bvh::text::Cursor;
use crate::motion::skeleton::{Channel, Joint, MAX_JOINTS, Skeleton};

/// A joint whose closing brace has not come yet.
struct Open {
    joint: usize,
    offset: bool,
    channels: bool,
    children: bool,
}

/// Reads from the start of the file up to and including the word MOTION.
///
/// Open joints are in a vector because a deeply nested file could exhaust the call stack.
pub(super) fn read(cursor: &mut Cursor) -> Result<Skeleton, BvhError> {
    cursor.expect("HIERARCHY")?;
    cursor.expect("ROOT")?;
    let mut joints = Vec::new();
    let mut open = vec![begin(cursor, &mut joints, None)?];
    let mut end_sites = 0;
    while let Some(innermost) = open.last_mut() {
        let word = cursor.word();
        let here = innermost.joint;
        match word.map(str::to_ascii_uppercase).as_deref() {
            Some("OFFSET") if !innermost.offset => {
                joints[here].offset = triple(cursor)?;
                innermost.offset = true;
            }
            Some("CHANNELS") if !innermost.channels && !innermost.children => {
                joints[here].channels = channels(cursor)?;
                innermost.channels = true;
            }
            Some("JOINT") => {
                innermost.children = true;
                let child = begin(cursor, &mut joints, Some(here))?;
                open.push(child);
            }
            Some("END" | "ENDSITE") => {
                end_sites += 1;
                if end_sites > MAX_JOINTS {
                    return Err(cursor.error(BvhProblem::TooManyJoints { max: MAX_JOINTS }));
                }
                let end = end_site(cursor)?;
                joints[here].end_sites.push(end);
            }
            Some("}") if innermost.offset => {
                open.pop();
            }
            _ => {
                let wanted = match (innermost.offset, innermost.channels || innermost.children) {
                    (false, _) => "OFFSET",
                    (true, false) => "CHANNELS, JOINT, End Site or \"}\"",
                    (true, true) => "JOINT, End Site or \"}\"",
                };
                return Err(cursor.error(BvhProblem::expected(wanted, word)));
            }
        }
    }
    match cursor.word() {
        Some(word) if word.eq_ignore_ascii_case("MOTION") => Ok(Skeleton { joints }),
        Some(word) if word.eq_ignore_ascii_case("ROOT") => Err(cursor.error(BvhProblem::SecondRoot)),
        found => Err(cursor.error(BvhProblem::expected("MOTION", found))),
    }
}

/// The name and the opening brace of a joint.
fn begin(cursor: &mut Cursor, joints: &mut Vec<Joint>, parent: Option<usize>) -> Result<Open, BvhError> {
    if joints.len() >= MAX_JOINTS {
        return Err(cursor.error(BvhProblem::TooManyJoints { max: MAX_JOINTS }));
    }
    let mut name = cursor.name();
    if name.is_empty() && cursor.peek().is_some_and(|word| word != "{") {
        name = cursor.name_on_next_line();
    }
    let name = name.to_owned();
    cursor.expect("{")?;
    let joint = joints.len();
    joints.push(Joint { name, parent, offset: [0.0; 3], channels: Vec::new(), end_sites: Vec::new() });
    Ok(Open { joint, offset: false, channels: false, children: false })
}

fn triple(cursor: &mut Cursor) -> Result<[f64; 3], BvhError> {
    let mut numbers = [0.0; 3];
    for number in &mut numbers {
        *number = cursor.number()?;
    }
    Ok(numbers)
}

fn channels(cursor: &mut Cursor) -> Result<Vec<Channel>, BvhError> {
    let word = cursor.word();
    let Some(count) = word.and_then(|word| word.parse::<usize>().ok()).filter(|&count| count <= 6) else {
        return Err(cursor.error(BvhProblem::expected("a number of channels from 0 to 6", word)));
    };
    let mut channels = Vec::with_capacity(count);
    for _ in 0..count {
        let word = cursor.word();
        let Some(channel) = word.and_then(Channel::from_name) else {
            return Err(cursor.error(BvhProblem::expected("a channel name (Xposition … Zrotation)", word)));
        };
        if channels.contains(&channel) {
            return Err(cursor.error(BvhProblem::expected("each channel once in a joint", word)));
        }
        channels.push(channel);
    }
    Ok(channels)
}

/// What follows the word End: "Site" or any name, then an OFFSET in braces.
fn end_site(cursor: &mut Cursor) -> Result<[f64; 3], BvhError> {
    cursor.name();
    cursor.expect("{")?;
    cursor.expect("OFFSET")?;
    let offset = triple(cursor)?;
    if cursor.peek().is_some_and(|word| word.eq_ignore_ascii_case("CHANNELS")) {
        cursor.word();
        cursor.expect("0")?;
    }
    cursor.expect("}")?;
    Ok(offset)
}
