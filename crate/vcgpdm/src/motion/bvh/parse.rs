//! A whole file: bytes to clip, with what was odd about it.

use crate::motion::bvh::text::{Cursor, decode};
use crate::motion::bvh::{BvhError, BvhProblem, hierarchy, motion};
use crate::motion::clip::{Clip, sha256};
use crate::motion::skeleton::Skeleton;
use nalgebra::DMatrix;

/// Reads a BVH file. `name` is used in messages and kept as the clip's name.
///
/// Any hierarchy with one root, any channel order, CR, LF and CR LF line ends, keywords in any case, a byte order
/// mark, Latin-1 names and row counts that are off by a little can be read; what was odd is in
/// [`Clip::warnings`](crate::motion::clip::Clip::warnings). Everything else is a [`BvhError`] with the line.
pub fn read(name: &str, bytes: &[u8]) -> Result<Clip, BvhError> {
    let (text, encoding) = decode(bytes);
    let mut warnings: Vec<String> = encoding.into_iter().collect();
    let mut cursor = Cursor::new(name, &text);
    let skeleton = hierarchy::read(&mut cursor)?;
    let channels = skeleton.channel_count();
    if channels == 0 {
        let problem = BvhProblem::expected(
            "a joint with CHANNELS before MOTION, so that something moves",
            Some("MOTION"),
        );
        return Err(cursor.error(problem));
    }
    warn_of_names(&skeleton, &mut warnings);
    let motion = motion::read(&mut cursor, channels, &mut warnings)?;
    warn_of_rows(&motion.values, channels, &mut warnings);
    Ok(Clip {
        name: name.to_owned(),
        skeleton,
        frame_time: motion.frame_time,
        values: DMatrix::from_row_slice(motion.frames, channels, &motion.values),
        warnings,
        sha256: sha256(bytes),
        piece: None,
        file_frame_time: motion.frame_time,
    })
}

fn warn_of_names(skeleton: &Skeleton, warnings: &mut Vec<String>) {
    let count = |name: &str| skeleton.joints.iter().filter(|joint| joint.name == name).count();
    // In the order of the file, each once.
    let mut repeated: Vec<&str> = Vec::new();
    let mut joints = 0;
    for joint in &skeleton.joints {
        let name = joint.name.as_str();
        if !repeated.contains(&name) && count(name) > 1 {
            repeated.push(name);
            joints += count(name);
        }
    }
    if !repeated.is_empty() {
        warnings.push(format!(
            "{joints} joints share their names with others ({}): joints are told apart by their place",
            listed(&repeated)
        ));
    }
    let odd: Vec<&str> = (skeleton.joints.iter().map(|joint| joint.name.as_str()))
        .filter(|name| name.is_empty() || name.contains(|c: char| c.is_whitespace() || c == ':'))
        .collect();
    if !odd.is_empty() {
        warnings.push(format!(
            "{} names hold blanks or colons, or are empty ({}): they are kept, but some programs cannot read them",
            odd.len(),
            listed(&odd)
        ));
    }
}

/// The first few names, quoted.
fn listed(names: &[&str]) -> String {
    let mut text: Vec<String> = names.iter().take(3).map(|name| crate::motion::bvh::quoted(name)).collect();
    if names.len() > 3 {
        text.push("…".to_owned());
    }
    text.join(", ")
}

fn warn_of_rows(values: &[f64], channels: usize, warnings: &mut Vec<String>) {
    let rows: Vec<&[f64]> = values.chunks_exact(channels).collect();
    // A first row of zeros is a body at rest, not a fault.
    let zeros = rows.iter().skip(1).filter(|row| row.iter().all(|&x| x == 0.0)).count();
    if zeros > 0 && zeros + 1 < rows.len() {
        warnings.push(format!("{zeros} of {} rows hold only zeros", rows.len()));
    }
    let frozen = rows.windows(2).rev().take_while(|pair| pair[0] == pair[1]).count();
    if frozen >= 2 && frozen + 1 < rows.len() {
        warnings.push(format!("the last {} rows are the same: the recording is frozen there", frozen + 1));
    }
}
