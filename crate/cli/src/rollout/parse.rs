//! Reads couplings, cuts and pushes from the command line.

use std::path::PathBuf;
use vcgpdm_core::models::{Cut, Push};

/// The value of `--from`: what a rollout starts as.
#[derive(Clone, Debug, PartialEq)]
pub enum Start {
    /// This training sequence, counted from 0.
    Sequence(usize),
    /// The first frames of this clip.
    Clip { clip: PathBuf, frames: usize },
}

/// Reads `SEQUENCE` or `CLIP:FRAMES`; the path of the clip may have colons too.
pub fn start(text: &str) -> Result<Start, String> {
    if let Ok(sequence) = text.trim().parse() {
        return Ok(Start::Sequence(sequence));
    }
    let parsed = text.rsplit_once(':').and_then(|(clip, frames)| Some((clip, frames.parse::<usize>().ok()?)));
    match parsed {
        Some((clip, frames)) if frames > 0 && !clip.is_empty() => {
            Ok(Start::Clip { clip: clip.into(), frames })
        }
        _ => {
            Err("expected a training sequence, a whole number from 0, or CLIP:FRAMES, a clip and the number \
                  of its first frames, from 1"
                .to_owned())
        }
    }
}

/// Reads `SOURCE:TARGET=VALUE`: the indices of two parts, and the variance.
pub fn coupling(text: &str, parts: &[String]) -> Result<(usize, usize, f64), String> {
    let wrong = |expected: &str| format!("--alpha {text}: expected {expected}");
    let (pair_text, value) = text.rsplit_once('=').ok_or_else(|| wrong("SOURCE:TARGET=VALUE"))?;
    let (source, target) = pair(pair_text, parts).map_err(|expected| wrong(&expected))?;
    match value.trim().parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok((source, target, value)),
        _ => Err(wrong(&format!("a positive number after the equals sign, found {value:?}"))),
    }
}

/// Reads `SOURCE:TARGET@FROM-TO`.
pub fn cut(text: &str, parts: &[String]) -> Result<Cut, String> {
    let wrong = |expected: &str| format!("--cut {text}: expected {expected}");
    let (pair_text, frames) = text.rsplit_once('@').ok_or_else(|| wrong("SOURCE:TARGET@FROM-TO"))?;
    let (source, target) = pair(pair_text, parts).map_err(|expected| wrong(&expected))?;
    let frame = |text: &str| text.trim().parse::<usize>().ok();
    let (from, to) = frames
        .split_once('-')
        .and_then(|(from, to)| Some((frame(from)?, frame(to)?)))
        .filter(|(from, to)| from < to)
        .ok_or_else(|| wrong(&format!("two frames FROM-TO, the second one later, found {frames:?}")))?;
    Ok(Cut { source, target, from, to })
}

/// Reads `PART@FRAME=AMOUNT`.
pub fn push(text: &str, parts: &[String]) -> Result<Push, String> {
    let wrong = |expected: &str| format!("--push {text}: expected {expected}");
    let form = || wrong("PART@FRAME=AMOUNT");
    let (place, amount) = text.rsplit_once('=').ok_or_else(form)?;
    let (name, frame) = place.rsplit_once('@').ok_or_else(form)?;
    let part = part_index(name, parts)
        .ok_or_else(|| wrong(&format!("one of the parts {} before the @", parts.join(", "))))?;
    let frame = frame.trim().parse().map_err(|_| wrong(&format!("a frame after the @, found {frame:?}")))?;
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    let push = match amount.trim().strip_suffix('f') {
        Some(frames) => number(frames).map(|ahead| Push { part, frame, ahead, ..Push::default() }),
        None => amount.split(',').map(number).collect::<Option<_>>().map(|by| Push {
            part,
            frame,
            by,
            ahead: 0.0,
        }),
    };
    let expected = "numbers separated by commas, or one number with an f behind it, after the equals sign";
    push.ok_or_else(|| wrong(&format!("{expected}, found {amount:?}")))
}

/// Reads `SOURCE:TARGET`: the indices of two parts. The error says what was expected.
fn pair(text: &str, parts: &[String]) -> Result<(usize, usize), String> {
    // The name of a part may have a colon: the right colon has parts on both sides.
    let mut splits = text.match_indices(':').map(|(at, _)| (&text[..at], &text[at + 1..]));
    splits
        .find_map(|(source, target)| Some((part_index(source, parts)?, part_index(target, parts)?)))
        .ok_or_else(|| format!("two of the parts {} on both sides of a colon", parts.join(", ")))
}

/// The index of a part, from its name or its number from 0.
pub fn part_index(name: &str, parts: &[String]) -> Option<usize> {
    let named = parts.iter().position(|part| part == name);
    named.or_else(|| name.parse().ok().filter(|&index: &usize| index < parts.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts() -> Vec<String> {
        ["lower", "upper", "a:b"].map(str::to_owned).to_vec()
    }

    #[test]
    fn reads_what_a_rollout_starts_as() {
        assert_eq!(start("3"), Ok(Start::Sequence(3)));
        let clip = |clip: &str, frames| Ok(Start::Clip { clip: clip.into(), frames });
        assert_eq!(start("walk.bvh:5"), clip("walk.bvh", 5));
        assert_eq!(start("sample:walk-1:12"), clip("sample:walk-1", 12));
        for wrong in ["-1", "walk.bvh", "walk.bvh:", "walk.bvh:0", "sample:walk-1", ":5", "1.5"] {
            assert!(start(wrong).unwrap_err().starts_with("expected a training sequence"), "{wrong}");
        }
    }

    #[test]
    fn reads_couplings_of_parts_by_name_or_number() {
        assert_eq!(coupling("lower:upper=2.5", &parts()), Ok((0, 1, 2.5)));
        assert_eq!(coupling("1:0=1e-2", &parts()), Ok((1, 0, 0.01)));
        assert_eq!(coupling("a:b:lower=3", &parts()), Ok((2, 0, 3.0)));
    }

    #[test]
    fn refuses_wrong_couplings() {
        for (text, expected) in [
            ("lower:upper", "expected SOURCE:TARGET=VALUE"),
            ("lower=1", "expected two of the parts lower, upper, a:b on both sides of a colon"),
            ("lower:head=1", "expected two of the parts lower, upper, a:b"),
            ("lower:3=1", "expected two of the parts"),
            ("lower:upper=-1", "expected a positive number after the equals sign, found \"-1\""),
            ("lower:upper=nan", "found \"nan\""),
        ] {
            let error = coupling(text, &parts()).unwrap_err();
            assert!(error.starts_with(&format!("--alpha {text}: ")) && error.contains(expected), "{error}");
        }
    }

    #[test]
    fn reads_cuts_of_two_parts_and_two_frames() {
        assert_eq!(cut("lower:upper@90-150", &parts()), Ok(Cut { source: 0, target: 1, from: 90, to: 150 }));
        for (text, expected) in [
            ("lower:upper", "expected SOURCE:TARGET@FROM-TO"),
            ("lower@3-9", "expected two of the parts"),
            ("lower:upper@9-3", "expected two frames FROM-TO, the second one later, found \"9-3\""),
            ("lower:upper@9", "expected two frames FROM-TO"),
        ] {
            let error = cut(text, &parts()).unwrap_err();
            assert!(error.starts_with(&format!("--cut {text}: ")) && error.contains(expected), "{error}");
        }
    }

    #[test]
    fn reads_pushes_by_latent_displacements_or_steps_ahead() {
        let by = |by: Vec<f64>, ahead| Push { part: 1, frame: 60, by, ahead };
        assert_eq!(push("upper@60=0.5,-1,0", &parts()), Ok(by(vec![0.5, -1.0, 0.0], 0.0)));
        assert_eq!(push("upper@60=-3f", &parts()), Ok(by(Vec::new(), -3.0)));
        for (text, expected) in [
            ("upper=1", "expected PART@FRAME=AMOUNT"),
            ("head@3=1", "expected one of the parts lower, upper, a:b before the @"),
            ("upper@x=1", "expected a frame after the @, found \"x\""),
            ("upper@3=1,two", "expected numbers separated by commas"),
        ] {
            let error = push(text, &parts()).unwrap_err();
            assert!(error.starts_with(&format!("--push {text}: ")) && error.contains(expected), "{error}");
        }
    }
}
