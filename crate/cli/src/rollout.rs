//! `vcgpdm rollout`: a new motion from a trained model.

use crate::files;
use nalgebra::DMatrix;
use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use vcgpdm::models::variational::Vcgpdm;
use vcgpdm::models::{Model, RolloutRequest, TrainedModel};
use vcgpdm::motion::bvh;

/// Roll a model out and write the motion as BVH.
#[derive(clap::Args)]
pub struct Arguments {
    /// A trained model of any kind.
    #[arg(value_name = "MODEL.json")]
    model: PathBuf,
    /// Frames in all, the start included.
    #[arg(long, value_name = "N")]
    frames: usize,
    /// Start where this training sequence starts, counted from 0 in the order given to training.
    #[arg(long, value_name = "SEQUENCE", default_value_t = 0)]
    from: usize,
    /// Change a coupling variance: how little the part SOURCE says about the part TARGET. Parts by name or number, from 0.
    #[arg(long, value_name = "SOURCE:TARGET=VALUE", num_args = 1..)]
    alpha: Vec<String>,
    /// Write the motion to this file.
    #[arg(long, value_name = "OUT.bvh")]
    out: PathBuf,
    /// Write the latent path to this file, with a header row.
    #[arg(long, value_name = "OUT.csv")]
    latents: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let model = read_model(&arguments.model)?;
    for path in [Some(&arguments.out), arguments.latents.as_ref()].into_iter().flatten() {
        files::check_writable(path)?;
    }
    let (y, body) = match model.into_vcgpdm() {
        Ok(model) => (coupled(arguments, &model)?, model.body),
        Err(model) => {
            let options =
                [("--alpha", !arguments.alpha.is_empty()), ("--latents", arguments.latents.is_some())];
            if let Some((option, _)) = options.into_iter().find(|(_, given)| *given) {
                let kind = model.kind().id();
                return Err(
                    format!("{option}: expected a vcgpdm or vgpdm model, found a {kind} model").into()
                );
            }
            (model.rollout(arguments.from, arguments.frames)?, model.body)
        }
    };
    let clip = body.clip(&y, &name_of(&arguments.out))?;
    files::write_text(&arguments.out, &bvh::write(&clip))
}

/// All columns of a model whose couplings may be changed, and its latents into a file of their own.
fn coupled(arguments: &Arguments, model: &TrainedModel<Vcgpdm>) -> Result<DMatrix<f64>, Box<dyn Error>> {
    let names: Vec<String> = model.body.layout.parts().iter().map(|part| part.name.clone()).collect();
    let mut alpha = model.model.alpha.clone();
    for coupling in &arguments.alpha {
        let (source, target, value) = parse_coupling(coupling, &names)?;
        alpha[(source, target)] = value;
    }
    let request = RolloutRequest {
        frames: arguments.frames,
        sequence: arguments.from,
        alpha: Some(alpha),
        ..RolloutRequest::default()
    };
    let rollout = model.rollout(&request)?;
    if let Some(path) = &arguments.latents {
        files::write_text(path, &csv(&names, &rollout.latents, model.body.frame_time))?;
    }
    Ok(rollout.y)
}

/// Reads a model document of any kind.
pub fn read_model(path: &Path) -> Result<TrainedModel, Box<dyn Error>> {
    TrainedModel::<Model>::from_json(&files::read_text(path)?).map_err(|error| files::about(path, &error))
}

fn name_of(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// `SOURCE:TARGET=VALUE` as places of the parts and the variance.
fn parse_coupling(text: &str, parts: &[String]) -> Result<(usize, usize, f64), String> {
    let wrong = |expected: &str| format!("--alpha {text}: expected {expected}");
    let (pair, value) = text.rsplit_once('=').ok_or_else(|| wrong("SOURCE:TARGET=VALUE"))?;
    // A part's name may hold a colon: the cut is where both sides are parts.
    let place = |name: &str| {
        let named = parts.iter().position(|part| part == name);
        named.or_else(|| name.parse().ok().filter(|&place: &usize| place < parts.len()))
    };
    let mut cuts = pair.match_indices(':').map(|(at, _)| (&pair[..at], &pair[at + 1..])).peekable();
    if cuts.peek().is_none() {
        return Err(wrong("SOURCE:TARGET=VALUE"));
    }
    let found = cuts.find_map(|(source, target)| Some((place(source)?, place(target)?)));
    let known = format!("two of the parts {} on both sides of the colon", parts.join(", "));
    let (source, target) = found.ok_or_else(|| wrong(&known))?;
    match value.trim().parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok((source, target, value)),
        _ => Err(wrong(&format!("a positive number after the equals sign, found {value:?}"))),
    }
}

/// One row a frame: frame, time in seconds, and the latents of all parts.
fn csv(names: &[String], latents: &[DMatrix<f64>], frame_time: f64) -> String {
    let mut text = "frame,time".to_owned();
    for (name, latents) in names.iter().zip(latents) {
        for q in 0..latents.ncols() {
            // Writing to a String cannot fail.
            let _ = write!(text, ",{}", quoted(&format!("{name}_{q}")));
        }
    }
    text.push('\n');
    for frame in 0..latents.first().map_or(0, |first| first.nrows()) {
        let _ = write!(text, "{frame},{}", frame as f64 * frame_time);
        for value in latents.iter().flat_map(|latents| latents.row(frame).iter().copied().collect::<Vec<_>>())
        {
            let _ = write!(text, ",{value}");
        }
        text.push('\n');
    }
    text
}

/// A CSV field (RFC 4180).
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts() -> Vec<String> {
        ["lower", "upper", "a:b"].map(str::to_owned).to_vec()
    }

    #[test]
    fn couplings_are_read_by_name_or_number() {
        assert_eq!(parse_coupling("lower:upper=2.5", &parts()), Ok((0, 1, 2.5)));
        assert_eq!(parse_coupling("1:0=1e-2", &parts()), Ok((1, 0, 0.01)));
        assert_eq!(parse_coupling("a:b:lower=3", &parts()), Ok((2, 0, 3.0)));
    }

    #[test]
    fn couplings_that_make_no_sense_are_refused_in_words() {
        for (text, expected) in [
            ("lower:upper", "expected SOURCE:TARGET=VALUE"),
            ("lower=1", "expected SOURCE:TARGET=VALUE"),
            ("lower:head=1", "expected two of the parts lower, upper, a:b"),
            ("lower:3=1", "expected two of the parts"),
            ("lower:upper=-1", "expected a positive number after the equals sign, found \"-1\""),
            ("lower:upper=nan", "found \"nan\""),
        ] {
            let error = parse_coupling(text, &parts()).unwrap_err();
            assert!(error.starts_with(&format!("--alpha {text}: ")) && error.contains(expected), "{error}");
        }
    }

    #[test]
    fn the_latent_path_has_a_header_and_a_row_a_frame() {
        let latents = [
            DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 3.0, 4.5]),
            DMatrix::from_row_slice(2, 1, &[-1.0, 0.5]),
        ];
        let names = ["lower".to_owned(), "up, \"er\"".to_owned()];
        let text = csv(&names, &latents, 0.25);
        assert_eq!(text, "frame,time,lower_0,lower_1,\"up, \"\"er\"\"_0\"\n0,0,1,2,-1\n1,0.25,3,4.5,0.5\n");
    }
}
