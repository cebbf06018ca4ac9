//! Reads the MOTION section of a file: two numbers, then the rows.

use crate::motion::bvh::error::{BvhError, BvhProblem, quoted};
use crate::motion::bvh::text::{Cursor, finite, is_blank, not_a_number};
use crate::motion::clip::Clip;
use crate::motion::skeleton::Skeleton;

/// The rows of a file.
pub(super) struct Motion {
    pub(super) frames: usize,
    /// Seconds.
    pub(super) frame_time: f64,
    /// Channel values [frames x channels], row by row.
    pub(super) values: Vec<f64>,
}

/// Reads the section from behind the word MOTION to the end of the file. `rate` replaces the frame time.
pub(super) fn read(
    cursor: &mut Cursor,
    skeleton: &Skeleton,
    rate: Option<f64>,
    warnings: &mut Vec<String>,
) -> Result<Motion, BvhError> {
    let (channels, most) = (skeleton.channel_count(), skeleton.max_frames());
    let Header { count, frame_time } = header(cursor, rate, warnings)?;
    let too_many = |frames| BvhProblem::TooManyFrames { frames, nodes: skeleton.node_count(), most };
    if let Count::Declared(declared) = count
        && declared > most
    {
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
    match count {
        // A recorder that was ended never filled in the number.
        Count::Missing(line, text) => warnings.push(format!(
            "line {line}: the number of frames is missing (found {}): all {found} rows were read",
            quoted(text)
        )),
        Count::Declared(declared) if declared == found => {}
        // A wrong count by one or two rows is common. A larger difference means that the file was cut short.
        Count::Declared(declared) if found.abs_diff(declared) > 5.max(declared / 50) => {
            return Err(cursor.error_at(header_line, BvhProblem::RowCount { declared, found }));
        }
        Count::Declared(declared) => warnings.push(format!(
            "\"Frames:\" declares {declared} rows, the file has {found}: all {found} were read"
        )),
    }
    Ok(Motion { frames: found, frame_time, values })
}

/// The number of frames in the header.
#[derive(Clone, Copy)]
enum Count<'a> {
    Declared(usize),
    /// The line, and the text in place of a number.
    Missing(usize, &'a str),
}

struct Header<'a> {
    count: Count<'a>,
    /// Seconds.
    frame_time: f64,
}

/// The numbers after `Frames:` and `Frame Time:` (or `Frames Time:`), in either order.
fn header<'a>(
    cursor: &mut Cursor<'a>,
    rate: Option<f64>,
    warnings: &mut Vec<String>,
) -> Result<Header<'a>, BvhError> {
    let (mut count, mut frame_time) = (None, None);
    loop {
        let wanted = if count.is_none() { "Frames:" } else { "Frame Time:" };
        let Some((line, text)) = cursor.line() else {
            return Err(cursor.error(BvhProblem::expected(wanted, None)));
        };
        // The key ends at the colon, or at the first digit where the colon is missing.
        let end =
            text.find(|c: char| c == ':' || c.is_ascii_digit() || "+-.".contains(c)).unwrap_or(text.len());
        let key: String =
            text[..end].chars().filter(|&c| !is_blank(c)).collect::<String>().to_ascii_lowercase();
        let value = text[end..].trim_start_matches(':').trim_matches(is_blank);
        let value = if value.is_empty() { cursor.number_on_next_line().unwrap_or_default() } else { value };
        match key.as_str() {
            "frames" if count.is_none() => {
                let declared = finite(value).filter(|count| *count >= 1.0 && count.fract() == 0.0);
                count = Some(
                    declared.map_or(Count::Missing(line, value), |count| Count::Declared(count as usize)),
                );
            }
            "frametime" | "framestime" if frame_time.is_none() => {
                frame_time = Some(match rate {
                    Some(rate) => seconds_at(rate).map_err(|problem| cursor.error_at(line, problem))?,
                    None => seconds(line, value, warnings).map_err(|problem| cursor.error(problem))?,
                });
            }
            _ => {
                return Err(
                    cursor.error_at(line, BvhProblem::expected(wanted, Some(text.trim_matches(is_blank))))
                );
            }
        }
        if let (Some(count), Some(frame_time)) = (count, frame_time) {
            return Ok(Header { count, frame_time });
        }
    }
}

/// Longer frames than those of the lowest rate of a clip, with its tolerance, are no times.
const LONGEST_FRAME: f64 = 10.25;

/// The frame time of this text, which is on this line.
fn seconds(line: usize, text: &str, warnings: &mut Vec<String>) -> Result<f64, BvhProblem> {
    let seconds = finite(text).filter(|seconds| (1e-5..=LONGEST_FRAME).contains(seconds)).ok_or_else(|| {
        let wanted = "the seconds of a frame, from 0.00001 to 10, not a rate or milliseconds (--clip-fps F \
                      states a rate)";
        BvhProblem::expected(wanted, Some(text))
    })?;
    if seconds >= 1.0 {
        warnings.push(format!(
            "line {line}: a frame lasts {seconds} s; is that a rate, not a time? --clip-fps F states a rate"
        ));
    }
    Ok(seconds)
}

/// The frame time at this rate.
fn seconds_at(rate: f64) -> Result<f64, BvhProblem> {
    if Clip::RATES.contains(&rate) {
        return Ok(1.0 / rate);
    }
    let (from, to) = (Clip::RATES.start(), Clip::RATES.end());
    let wanted = format!("a stated rate from {from} to {to} frames a second");
    Err(BvhProblem::expected(&wanted, Some(&rate.to_string())))
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
