//! Reads the MOTION section of a file: two numbers, then the rows.

use crate::motion::bvh::error::{BvhError, BvhProblem};
use crate::motion::bvh::text::{Cursor, finite, is_blank, not_a_number};
use crate::motion::skeleton::Skeleton;

/// The rows of a file.
pub(super) struct Motion {
    pub(super) frames: usize,
    /// Seconds.
    pub(super) frame_time: f64,
    /// Channel values [frames x channels], row by row.
    pub(super) values: Vec<f64>,
}

/// Reads the section from behind the word MOTION to the end of the file.
pub(super) fn read(
    cursor: &mut Cursor,
    skeleton: &Skeleton,
    warnings: &mut Vec<String>,
) -> Result<Motion, BvhError> {
    let (channels, most) = (skeleton.channel_count(), skeleton.max_frames());
    let (declared, frame_time) = header(cursor, most, warnings)?;
    let too_many = |frames| BvhProblem::TooManyFrames { frames, nodes: skeleton.node_count(), most };
    if declared > most {
        return Err(cursor.error(too_many(declared)));
    }
    let header_line = cursor.word_line();
    let values = rows(cursor, channels, most * channels)?;
    let found = values.len() / channels;
    if found > most {
        return Err(cursor.error(too_many(found)));
    }
    if found == 0 {
        return Err(cursor.error_at(header_line, BvhProblem::expected("at least one row of values", None)));
    }
    let difference = found.abs_diff(declared);
    if difference > 0 {
        // A wrong count by one or two rows is common. A larger difference means that the file was cut short.
        if difference > 5.max(declared / 50) {
            return Err(cursor.error_at(header_line, BvhProblem::RowCount { declared, found }));
        }
        warnings.push(format!(
            "\"Frames:\" declares {declared} rows, the file has {found}: all {found} were read"
        ));
    }
    Ok(Motion { frames: found, frame_time, values })
}

/// The numbers after `Frames:` and `Frame Time:` (or `Frames Time:`), in either order. `most` is the largest
/// number of frames of this body.
fn header(cursor: &mut Cursor, most: usize, warnings: &mut Vec<String>) -> Result<(usize, f64), BvhError> {
    let (mut frames, mut frame_time) = (None, None);
    while frames.is_none() || frame_time.is_none() {
        let wanted = if frames.is_none() { "Frames:" } else { "Frame Time:" };
        let Some((line, text)) = cursor.line() else {
            return Err(cursor.error(BvhProblem::expected(wanted, None)));
        };
        // The key ends at the colon, or at the first digit where the colon is missing.
        let end =
            text.find(|c: char| c == ':' || c.is_ascii_digit() || "+-.".contains(c)).unwrap_or(text.len());
        let key: String =
            text[..end].chars().filter(|&c| !is_blank(c)).collect::<String>().to_ascii_lowercase();
        let value = text[end..].trim_start_matches(':').trim_matches(is_blank);
        let value = if value.is_empty() {
            cursor.line().map(|(_, text)| text.trim_matches(is_blank))
        } else {
            Some(value)
        };
        match key.as_str() {
            "frames" if frames.is_none() => {
                let count = value.and_then(finite).filter(|count| *count >= 1.0 && count.fract() == 0.0);
                let Some(count) = count else {
                    let wanted = format!("a number of frames from 1 to {most}");
                    return Err(cursor.error(BvhProblem::expected(&wanted, value)));
                };
                frames = Some(count as usize);
            }
            "frametime" | "framestime" if frame_time.is_none() => {
                let seconds = value.and_then(finite).filter(|seconds| (1e-5..=3600.0).contains(seconds));
                let Some(seconds) = seconds else {
                    let wanted = "the seconds of a frame, from 0.00001 to 3600";
                    return Err(cursor.error(BvhProblem::expected(wanted, value)));
                };
                if seconds >= 1.0 {
                    warnings
                        .push(format!("line {line}: a frame lasts {seconds} s; is that a rate, not a time?"));
                }
                frame_time = Some(seconds);
            }
            _ => {
                return Err(
                    cursor.error_at(line, BvhProblem::expected(wanted, Some(text.trim_matches(is_blank))))
                );
            }
        }
    }
    Ok((frames.unwrap_or(0), frame_time.unwrap_or(0.0)))
}

/// The values of all rows. A row may span several lines but ends at the end of a line; a line may hold
/// several whole rows. Stops after the line in which there are more than `most` numbers.
fn rows(cursor: &mut Cursor, channels: usize, most: usize) -> Result<Vec<f64>, BvhError> {
    let mut values = Vec::new();
    // The line where the incomplete row began, and the count of its numbers until now.
    let mut first_line = 0;
    let mut pending = 0;
    while let Some((line, text)) = cursor.line() {
        if values.len() > most {
            return Ok(values);
        }
        let before = values.len();
        for word in text.split(is_blank).filter(|word| !word.is_empty()) {
            let Some(number) = finite(word) else {
                return Err(cursor.error_at(line, not_a_number(Some(word))));
            };
            values.push(number);
        }
        let length = values.len() - before;
        if pending == 0 {
            first_line = line;
        }
        pending += length;
        if pending % channels == 0 && (pending == channels || pending == length) {
            pending = 0;
        } else if pending > channels {
            // The line where the row began is the wrong one.
            let frame = (values.len() - pending) / channels + 1;
            let found = if pending > length { pending - length } else { length };
            return Err(
                cursor.error_at(first_line, BvhProblem::RowLength { frame, expected: channels, found })
            );
        }
    }
    if pending > 0 {
        let frame = values.len() / channels + 1;
        return Err(
            cursor.error_at(first_line, BvhProblem::RowLength { frame, expected: channels, found: pending })
        );
    }
    Ok(values)
}
