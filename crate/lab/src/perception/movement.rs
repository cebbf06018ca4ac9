//! A movement as a short text: the positions of nodes over time, as whole numbers of a unit.
//!
//! Each node and axis has its first position, its first step, and then the difference of each step from the
//! one before: small numbers if the movement is smooth. The numbers are in base 64 with variable length, as
//! in source maps: six bits for each letter of `A-Za-z0-9+/`, of which the highest says that more follow; the
//! lowest bit of a number is its sign.

use thiserror::Error;

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
/// Bits of a letter for the number, and the bit that says that more follow.
const BITS: u32 = 5;
const MORE: u64 = 1 << BITS;
/// The largest coordinate, in units.
const FARTHEST: i64 = 10_000_000;

/// Why a text or positions are not a movement.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MovementError {
    /// The text is too short, too long, or has a wrong letter.
    #[error("expected the positions of {frames} frames of {nodes} nodes, found {found}")]
    Text {
        /// Frames expected.
        frames: usize,
        /// Nodes expected.
        nodes: usize,
        /// The text found instead.
        found: String,
    },
    /// A position is not finite, or too far away.
    #[error("expected positions up to {FARTHEST} units away, found one of {0}")]
    Far(f64),
}

/// The positions of a figure's nodes over time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FigureMovement {
    frames: usize,
    nodes: usize,
    text: String,
}

impl FigureMovement {
    /// From positions [frames x nodes x 3] in metres, rounded to whole numbers of `unit` metres.
    ///
    /// # Errors
    /// A position is not finite or too far away.
    pub fn new(positions: &[f32], nodes: usize, unit: f64) -> Result<Self, MovementError> {
        let columns = 3 * nodes.max(1);
        let frames = positions.len() / columns;
        let mut text = String::new();
        for column in 0..columns {
            let (mut place, mut step) = (0, 0);
            for frame in 0..frames {
                let units = f64::from(positions[frame * columns + column]) / unit;
                if units.is_nan() || units.abs() > FARTHEST as f64 {
                    return Err(MovementError::Far(units));
                }
                let units = units.round() as i64;
                let now = units - place;
                append(now - step, &mut text);
                // The first number is a position, not a step.
                (place, step) = (units, if frame == 0 { 0 } else { now });
            }
        }
        Ok(Self { frames, nodes, text })
    }

    /// From a text.
    ///
    /// # Errors
    /// The text is not of the positions of `frames` frames and `nodes` nodes.
    pub fn from_text(text: &str, frames: usize, nodes: usize) -> Result<Self, MovementError> {
        let movement = Self { frames, nodes, text: text.to_owned() };
        movement.read(|_, _| {})?;
        Ok(movement)
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Number of frames.
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// The positions of the first `frames` frames [frames x nodes x 3], in metres.
    pub fn positions(&self, frames: usize, unit: f64) -> Vec<f32> {
        let frames = frames.min(self.frames);
        let mut positions = vec![0.0; frames * self.nodes * 3];
        // The text was read before, so there is no error.
        let _ = self.read(|at, units| {
            if let Some(place) = positions.get_mut(at) {
                *place = (units as f64 * unit) as f32;
            }
        });
        positions
    }

    /// Calls `take(index in [frames x nodes x 3], units)` for every number.
    fn read(&self, mut take: impl FnMut(usize, i64)) -> Result<(), MovementError> {
        let Self { frames, nodes, text } = self;
        let wrong = |found: String| MovementError::Text { frames: *frames, nodes: *nodes, found };
        let columns = 3 * nodes;
        let mut letters = text.bytes();
        for column in 0..columns {
            let (mut place, mut step) = (0_i64, 0_i64);
            for frame in 0..*frames {
                let more = number(&mut letters).map_err(wrong)?;
                let now = step + more;
                place += now;
                if place.abs() > FARTHEST || now.abs() > 2 * FARTHEST {
                    return Err(MovementError::Far(place as f64));
                }
                step = if frame == 0 { 0 } else { now };
                take(frame * columns + column, place);
            }
        }
        match letters.count() {
            0 => Ok(()),
            rest => Err(wrong(format!("{rest} letters more"))),
        }
    }
}

fn append(number: i64, text: &mut String) {
    let mut rest = (number.unsigned_abs() << 1) | u64::from(number < 0);
    loop {
        let bits = rest % MORE;
        rest >>= BITS;
        let letter = if rest > 0 { bits | MORE } else { bits };
        text.push(char::from(LETTERS[letter as usize]));
        if rest == 0 {
            return;
        }
    }
}

/// The next number, or the text found instead.
fn number(letters: &mut std::str::Bytes) -> Result<i64, String> {
    let (mut number, mut shift) = (0_u64, 0);
    loop {
        let letter = letters.next().ok_or("the end of the text")?;
        let bits = match letter {
            b'A'..=b'Z' => letter - b'A',
            b'a'..=b'z' => letter - b'a' + 26,
            b'0'..=b'9' => letter - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            other => return Err(format!("the byte {other}, which is no letter of the code")),
        };
        let bits = u64::from(bits);
        number |= (bits % MORE) << shift;
        if bits < MORE {
            let size = (number >> 1) as i64;
            return Ok(if number % 2 == 1 { -size } else { size });
        }
        shift += BITS;
        if shift > 25 {
            return Err("a number that is too large".to_owned());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use vcgpdm_core::motion::samples;

    #[test]
    fn stores_a_walk_in_a_short_text_within_half_a_unit() {
        let clip = samples::clip("walk-1").unwrap().resample(30.0).unwrap();
        let places = clip.stage_positions();
        let nodes = clip.skeleton.node_count();
        let movement = FigureMovement::new(&places, nodes, 0.001).unwrap();
        assert_eq!(movement.frames(), clip.frames());
        assert!(movement.text().len() < 2 * places.len(), "{} {}", movement.text().len(), places.len());
        let again = FigureMovement::from_text(movement.text(), clip.frames(), nodes).unwrap();
        assert_eq!(again, movement);
        for (a, b) in again.positions(clip.frames(), 0.001).iter().zip(&places) {
            assert!((a - b).abs() < 0.000_51, "{a} {b}");
        }
        assert_eq!(again.positions(10, 0.001), again.positions(clip.frames(), 0.001)[..30 * nodes]);
    }

    #[test]
    fn refuses_wrong_texts() {
        let error = |text: &str, frames| FigureMovement::from_text(text, frames, 1).unwrap_err().to_string();
        assert!(FigureMovement::from_text("AAAAAA", 2, 1).is_ok());
        let begin = "expected the positions of 2 frames of 1 nodes, found ";
        assert_eq!(error("AAAAA", 2), format!("{begin}the end of the text"));
        assert_eq!(error("AAAAAAB", 2), format!("{begin}1 letters more"));
        assert_eq!(error("AAé", 2), format!("{begin}the byte 195, which is no letter of the code"));
        assert_eq!(error("/////////", 2), format!("{begin}a number that is too large"));
        assert!(FigureMovement::new(&[f32::NAN; 3], 1, 0.001).is_err());
        assert!(FigureMovement::new(&[1e9; 3], 1, 0.001).is_err());
        // The steps add up to an impossible position.
        let far = format!("A{}", "+///f".repeat(200));
        assert!(FigureMovement::from_text(&far, 201, 1).is_err());
    }

    proptest! {
        #[test]
        fn any_positions_come_back(places in prop::collection::vec(-9_000_000_i32..9_000_000, 0..12)) {
            let metres: Vec<f32> = places.iter().flat_map(|p| [*p as f32 * 0.5, 0.0, 1.0]).collect();
            let movement = FigureMovement::new(&metres, 1, 0.5).unwrap();
            prop_assert_eq!(movement.positions(places.len(), 0.5), metres);
        }

        #[test]
        fn no_text_panics(text in "[A-Za-z0-9+/]{0,40}", frames in 0_usize..6) {
            if let Ok(movement) = FigureMovement::from_text(&text, frames, 1) {
                prop_assert_eq!(movement.positions(frames, 1.0).len(), 3 * frames);
            }
        }
    }
}
