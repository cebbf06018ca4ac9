//! Writes clips as BVH, and hashes clips that do not come from a file.

use crate::motion::clip::{Clip, sha256};
use crate::motion::recording::Recording;
use crate::motion::skeleton::{Joint, Skeleton};
use nalgebra::DMatrix;
use std::fmt::Write;

/// Writes a clip as BVH: tabs, LF line ends, each joint's own channels in their order. Numbers have the
/// digits that are read back as the same value. Joints below the root whose position channels do not change
/// are written with rotations alone, and their positions as offsets.
pub fn write(clip: &Clip) -> String {
    text(&clip.skeleton, clip.frame_time, &clip.values)
}

impl Clip {
    /// A motion that was computed, not recorded. Its hash is that of the text that [`write()`] returns.
    ///
    /// `values` are the channel values [frames x channels], degrees and file units; `frame_time` is in
    /// seconds.
    pub fn new(name: &str, skeleton: Skeleton, frame_time: f64, values: DMatrix<f64>) -> Clip {
        Recording::new(name, skeleton, frame_time, values).with_all_rows()
    }
}

impl Recording {
    /// A recording that does not come from a BVH file. Its hash is that of the text that [`write()`] would
    /// return.
    ///
    /// `values` are the channel values [frames x channels], degrees and file units; `frame_time` is in
    /// seconds.
    pub fn new(name: &str, skeleton: Skeleton, frame_time: f64, values: DMatrix<f64>) -> Recording {
        Recording {
            name: name.to_owned(),
            sha256: sha256(text(&skeleton, frame_time, &values).as_bytes()),
            skeleton,
            frame_time,
            values,
            warnings: Vec::new(),
        }
    }
}

/// Positions of inner joints that vary by less than this share of the body's height are constant: files round
/// positions to about this share.
const CONSTANT: f64 = 1e-5;

/// The skeleton without position channels of inner joints that do not move, whose mean positions become the
/// offsets; and the columns of the remaining channels. Readers disagree whether a position channel of an inner
/// joint is added to the offset or replaces it: with rotations alone they agree.
fn with_offsets(skeleton: &Skeleton, values: &DMatrix<f64>) -> (Skeleton, Vec<usize>) {
    let mut written = skeleton.clone();
    let mut columns = Vec::with_capacity(values.ncols());
    let has_inner_positions = skeleton.joints.iter().skip(1).any(Joint::has_positions);
    if !has_inner_positions || values.nrows() == 0 {
        return (written, (0..values.ncols()).collect());
    }
    let tolerance = CONSTANT * skeleton.height();
    let starts = skeleton.channel_starts();
    for (joint, start) in written.joints.iter_mut().zip(starts) {
        let channels = joint.channels.clone();
        let positions = (start..).zip(&channels).filter(|(_, channel)| !channel.is_rotation());
        let is_constant =
            |column: usize| values.column(column).max() - values.column(column).min() <= tolerance;
        let removes = joint.parent.is_some() && positions.clone().all(|(column, _)| is_constant(column));
        if removes {
            for (column, channel) in positions {
                let first = values[(0, column)];
                let differences = values.column(column).iter().map(|value| value - first).sum::<f64>();
                joint.offset[channel.axis()] = first + differences / values.nrows() as f64;
            }
            joint.channels.retain(|channel| channel.is_rotation());
        }
        let kept = (start..).zip(&channels).filter(|(_, channel)| !removes || channel.is_rotation());
        columns.extend(kept.map(|(column, _)| column));
    }
    (written, columns)
}

/// The text of a BVH file.
fn text(skeleton: &Skeleton, frame_time: f64, values: &DMatrix<f64>) -> String {
    let mut text = String::new();
    let (skeleton, kept) = with_offsets(skeleton, values);
    let skeleton = &skeleton;
    // Writing to a String cannot fail: its results are ignored here and below.
    let order = hierarchy(skeleton, &mut text);
    let _ = writeln!(text, "MOTION\nFrames: {}\nFrame Time: {frame_time}", values.nrows());
    let starts = skeleton.channel_starts();
    let columns: Vec<usize> = (order.into_iter())
        .flat_map(|joint| (starts[joint]..).take(skeleton.joints[joint].channels.len()))
        .map(|column| kept[column])
        .collect();
    for row in values.row_iter() {
        for (place, &column) in columns.iter().enumerate() {
            let _ = write!(text, "{}{}", if place == 0 { "" } else { " " }, row[column]);
        }
        text.push('\n');
    }
    text
}

/// Writes the joint tree and returns the order in which the joints were written, which is depth first.
fn hierarchy(skeleton: &Skeleton, text: &mut String) -> Vec<usize> {
    enum Step {
        Open(usize),
        Close,
    }
    let mut children = vec![Vec::new(); skeleton.joints.len()];
    for (place, joint) in skeleton.joints.iter().enumerate() {
        if let Some(parent) = joint.parent {
            children[parent].push(place);
        }
    }
    let mut order = Vec::with_capacity(skeleton.joints.len());
    let mut depth = 0;
    let mut steps = vec![Step::Open(0)];
    text.push_str("HIERARCHY\n");
    while let Some(step) = steps.pop() {
        match step {
            Step::Open(place) => {
                order.push(place);
                let joint = &skeleton.joints[place];
                let tabs = "\t".repeat(depth);
                let keyword = if joint.parent.is_none() { "ROOT" } else { "JOINT" };
                let _ = writeln!(text, "{tabs}{keyword} {}\n{tabs}{{", safe_name(&joint.name));
                depth += 1;
                // Readers disagree whether a position is added to the offset: without an offset they agree.
                let offset =
                    if joint.parent.is_none() && joint.is_placed() { [0.0; 3] } else { joint.offset };
                let _ = writeln!(text, "{tabs}\tOFFSET {}", spaced(&offset));
                let _ = write!(text, "{tabs}\tCHANNELS {}", joint.channels.len());
                for channel in &joint.channels {
                    let _ = write!(text, " {}", channel.name());
                }
                text.push('\n');
                for end in &joint.end_sites {
                    let _ = writeln!(
                        text,
                        "{tabs}\tEnd Site\n{tabs}\t{{\n{tabs}\t\tOFFSET {}\n{tabs}\t}}",
                        spaced(end)
                    );
                }
                steps.push(Step::Close);
                steps.extend(children[place].iter().rev().map(|&child| Step::Open(child)));
            }
            Step::Close => {
                depth -= 1;
                let _ = writeln!(text, "{}}}", "\t".repeat(depth));
            }
        }
    }
    order
}

fn spaced(offset: &[f64; 3]) -> String {
    format!("{} {} {}", offset[0], offset[1], offset[2])
}

/// The name without characters that would break the file: it may come from a stranger's model.
fn safe_name(name: &str) -> String {
    name.chars().map(|c| if c.is_control() || c == '{' || c == '}' { '_' } else { c }).collect()
}
