//! Couplings, cuts and pushes as words of the command line.

use vcgpdm::models::{Cut, Push};

/// `SOURCE:TARGET=VALUE` as places of the parts and the variance.
pub fn coupling(text: &str, parts: &[String]) -> Result<(usize, usize, f64), String> {
    let wrong = |expected: &str| format!("--alpha {text}: expected {expected}");
    let (pair, value) = text.rsplit_once('=').ok_or_else(|| wrong("SOURCE:TARGET=VALUE"))?;
    let (source, target) = pair_of(pair, parts).map_err(|expected| wrong(&expected))?;
    match value.trim().parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok((source, target, value)),
        _ => Err(wrong(&format!("a positive number after the equals sign, found {value:?}"))),
    }
}

/// `SOURCE:TARGET@FROM-TO`.
pub fn cut(text: &str, parts: &[String]) -> Result<Cut, String> {
    let wrong = |expected: &str| format!("--cut {text}: expected {expected}");
    let (pair, frames) = text.rsplit_once('@').ok_or_else(|| wrong("SOURCE:TARGET@FROM-TO"))?;
    let (source, target) = pair_of(pair, parts).map_err(|expected| wrong(&expected))?;
    let frame = |text: &str| text.trim().parse::<usize>().ok();
    let (from, to) = frames
        .split_once('-')
        .and_then(|(from, to)| Some((frame(from)?, frame(to)?)))
        .filter(|(from, to)| from < to)
        .ok_or_else(|| wrong(&format!("two frames FROM-TO, the second one later, found {frames:?}")))?;
    Ok(Cut { source, target, from, to })
}

/// `PART@FRAME=AMOUNT`.
pub fn push(text: &str, parts: &[String]) -> Result<Push, String> {
    let wrong = |expected: &str| format!("--push {text}: expected {expected}");
    let whole = || wrong("PART@FRAME=AMOUNT");
    let (place, amount) = text.rsplit_once('=').ok_or_else(whole)?;
    let (name, frame) = place.rsplit_once('@').ok_or_else(whole)?;
    let known = || wrong(&format!("one of the parts {} before the @", parts.join(", ")));
    let part = place_of(name, parts).ok_or_else(known)?;
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
    let numbers = "numbers separated by commas, or one number with an f behind it, after the equals sign";
    push.ok_or_else(|| wrong(&format!("{numbers}, found {amount:?}")))
}

/// `SOURCE:TARGET` as places of the parts, or what was expected.
fn pair_of(pair: &str, parts: &[String]) -> Result<(usize, usize), String> {
    // A part's name may hold a colon: the cut is where both sides are parts.
    let mut cuts = pair.match_indices(':').map(|(at, _)| (&pair[..at], &pair[at + 1..]));
    cuts.find_map(|(source, target)| Some((place_of(source, parts)?, place_of(target, parts)?)))
        .ok_or_else(|| format!("two of the parts {} on both sides of a colon", parts.join(", ")))
}

/// A part by its name or its number, from 0.
fn place_of(name: &str, parts: &[String]) -> Option<usize> {
    let named = parts.iter().position(|part| part == name);
    named.or_else(|| name.parse().ok().filter(|&place: &usize| place < parts.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts() -> Vec<String> {
        ["lower", "upper", "a:b"].map(str::to_owned).to_vec()
    }

    #[test]
    fn couplings_are_read_by_name_or_number() {
        assert_eq!(coupling("lower:upper=2.5", &parts()), Ok((0, 1, 2.5)));
        assert_eq!(coupling("1:0=1e-2", &parts()), Ok((1, 0, 0.01)));
        assert_eq!(coupling("a:b:lower=3", &parts()), Ok((2, 0, 3.0)));
    }

    #[test]
    fn couplings_that_make_no_sense_are_refused_in_words() {
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
    fn cuts_have_two_parts_and_two_frames() {
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
    fn pushes_are_latent_displacements_or_steps_ahead() {
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
