//! Reads a whole file, and warns of what is unusual in it.

use crate::motion::bvh::error::{BvhError, BvhProblem, quoted};
use crate::motion::bvh::text::{Cursor, decode};
use crate::motion::bvh::{hierarchy, motion};
use crate::motion::clip::sha256;
use crate::motion::foreign::foreign_format;
use crate::motion::recording::Recording;
use crate::motion::skeleton::Skeleton;
use nalgebra::DMatrix;

/// Reads a BVH file. `name` is used in messages and becomes the recording's name.
///
/// It accepts any hierarchy with one root, any channel order, the line ends CR, LF and CR LF, keywords in any
/// case, UTF-16, a byte order mark, Latin-1 names, and row counts that are slightly wrong.
/// [`Recording::warnings`] says what was unusual. [`Recording::into_clip`] makes the recording a clip.
///
/// ```
/// use vcgpdm_core::motion::bvh;
///
/// let text = "HIERARCHY
/// ROOT Hips
/// {
///   OFFSET 0 0 0
///   CHANNELS 3 Zrotation Xrotation Yrotation
///   End Site
///   {
///     OFFSET 0 10 0
///   }
/// }
/// MOTION
/// Frames: 2
/// Frame Time: 0.05
/// 0 0 90
/// 0 0 80
/// ";
/// let clip = bvh::read("turn.bvh", text.as_bytes())?.into_clip();
/// assert_eq!((clip.frames(), clip.values[(1, 2)]), (2, 80.0));
///
/// let error = bvh::read("turn.bvh", text.replace("OFFSET 0 10", "OFFSET 0 ten").as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "turn.bvh, line 8: expected a number, found \"ten\"");
/// # Ok::<(), vcgpdm_core::motion::bvh::BvhError>(())
/// ```
///
/// # Errors
///
/// A [`BvhError`] with the line, when the file is not a valid BVH file.
pub fn read(name: &str, bytes: &[u8]) -> Result<Recording, BvhError> {
    read_at(name, bytes, None)
}

/// As [`read`], at `rate` frames a second where the caller states them: the frame time of the file is
/// ignored then.
///
/// # Errors
///
/// As [`read`], and for a rate outside [`Clip::RATES`](crate::motion::Clip::RATES).
pub fn read_at(name: &str, bytes: &[u8], rate: Option<f64>) -> Result<Recording, BvhError> {
    if let Some(found) = foreign_format(bytes) {
        let problem = BvhProblem::Expected { expected: "a BVH file".to_owned(), found: found.to_owned() };
        return Err(BvhError { file: name.to_owned(), line: 1, problem });
    }
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
    let motion = motion::read(&mut cursor, &skeleton, rate, &mut warnings)?;
    warn_of_rows(&motion.values, channels, &mut warnings);
    Ok(Recording {
        name: name.to_owned(),
        skeleton,
        frame_time: motion.frame_time,
        values: DMatrix::from_row_slice(motion.frames, channels, &motion.values),
        warnings,
        sha256: sha256(bytes),
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
            "{joints} joints share their names with others ({}): joints are identified by their index",
            listed(&repeated)
        ));
    }
    let odd: Vec<&str> = (skeleton.joints.iter().map(|joint| joint.name.as_str()))
        .filter(|name| name.is_empty() || name.contains(|c: char| c.is_whitespace() || c == ':'))
        .collect();
    if !odd.is_empty() {
        warnings.push(format!(
            "{} names hold blanks or colons, or are empty ({}): they are kept, but some programs cannot \
             read them",
            odd.len(),
            listed(&odd)
        ));
    }
}

/// The first few names, quoted.
fn listed(names: &[&str]) -> String {
    let mut text: Vec<String> = names.iter().take(3).map(|name| quoted(name)).collect();
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
