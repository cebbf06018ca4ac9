//! `vcgpdm reproduce`: trains a model again with the settings of its file, and compares.

use crate::clips::{self, Rate, Up};
use crate::files;
use crate::numbers::whole;
use crate::task::Task;
use crate::usage::usage;
use serde_json::{Value, json};
use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm_core::models::{Dataset, FittedModel, Model, SequenceInfo, Source, Trainer, with_bones_of};
use vcgpdm_core::motion::Clip;

/// Train a model again from its clips, settings and seed, compare, and print the difference as one JSON
/// object.
///
/// The exit status is 1 when the model differs by more than the tolerance. On one machine the same program
/// gives the same bits, and a vCGPDM, vGPDM or DMP has them on another machine and in wasm, too. A TMP or MAP
/// model can differ in its last digits, because products of large matrices depend on the processor.
#[derive(clap::Args)]
pub struct Arguments {
    /// The model of a body, as `vcgpdm train` or the page has saved it.
    #[arg(value_name = "MODEL.json")]
    model: PathBuf,
    /// The clips of the training, in any order: BVH files, or sample:ID. They are recognised by their
    /// content.
    #[arg(value_name = "CLIP", required = true)]
    clips: Vec<PathBuf>,
    #[command(flatten)]
    rate: Rate,
    /// The largest difference of a number from the recorded one, relative to the larger of the two.
    #[arg(long, value_name = "T", default_value_t = 1e-8)]
    tolerance: f64,
    /// Threads that compute the bound (vcgpdm, vgpdm), as for `vcgpdm train`; the model is the same.
    #[arg(long, value_name = "T", default_value_t = 1, value_parser = whole(1..=u16::MAX))]
    threads: u16,
    /// Write the model that was trained again to this file.
    #[arg(long, value_name = "MODEL.json")]
    out: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let (path, tolerance) = (&arguments.model, arguments.tolerance);
    if !(tolerance.is_finite() && tolerance >= 0.0) {
        return Err(usage(format!("--tolerance {tolerance}: expected a finite number from 0")));
    }
    let recorded =
        Model::from_json(&files::read_text(path)?).map_err(|reason| files::with_path(path, &reason))?;
    if is_combination(&recorded.fitted) {
        return Err(format!(
            "{}: expected a model that was trained on clips, found a combination of primitives of a library, which was trained on other \
             movements too",
            path.display()
        )
        .into());
    }
    if let Some(out) = &arguments.out {
        let read = arguments.clips.iter().map(PathBuf::as_path);
        files::check_writable(out, read.chain([path.as_path()]))?;
    }
    // The axis that pointed up in the recorded training: found, or stated by the user. A clip that was turned
    // to this axis has its own.
    let mapping = &recorded.body.mapping;
    let root = &mapping.skeleton().joints[0].name;
    let rate = arguments.rate;
    let read = |path: &PathBuf| -> Result<Clip, Box<dyn Error>> {
        let mut clip = clips::read(path, &Up { rate, ..Up::default() })?;
        if clip.skeleton.joints[0].name != *root {
            // Another body of the same file.
            let up = Up { axis: None, root: Some(root.clone()), rate };
            clip = clips::read_quietly(path, &up).unwrap_or(clip);
        }
        Ok(if mapping.axis_warning(&clip).is_none() { clip.with_up(mapping.stage().up) } else { clip })
    };
    let given = arguments.clips.iter().map(read).collect::<Result<Vec<Clip>, _>>()?;
    let infos = &recorded.body.sequences;
    let clips = infos.iter().map(|info| clip_of(info, infos, &given)).collect::<Result<Vec<_>, _>>()?;
    let first_frames = |info: &SequenceInfo| (!info.whole).then_some(info.frames);
    let sources = clips.iter().zip(infos);
    let sources: Vec<Source> =
        sources.map(|(clip, info)| Source { clip, first_frames: first_frames(info) }).collect();

    let provenance = &recorded.provenance;
    let dataset = Dataset::new(&sources, recorded.body.layout.parts(), provenance.frames_per_second)?;
    let begin = Instant::now();
    let mut trainer = Trainer::new(&dataset, &provenance.settings, provenance.seed)?;
    trainer.use_threads(arguments.threads.into());
    let task = Task::new("at most")?;
    loop {
        let progress = trainer.step();
        // A training that was stopped is stopped at the same iteration again.
        if progress.done || progress.iteration >= provenance.iterations {
            break;
        }
        if task.is_stopped() {
            return Err("stopped before the last iteration of the recorded training".into());
        }
    }
    let again = trainer.finish()?;
    if let Some(out) = &arguments.out {
        files::write_text(out, &again.to_json()?)?;
    }

    let difference = difference(&recorded, &again)?;
    let beyond = difference.clone().filter(|(_, relative)| *relative > tolerance);
    let summary = json!({
        "same_bits": difference.is_none(),
        "within_tolerance": beyond.is_none(),
        "largest_difference": difference.as_ref().map(|(at, relative)| json!({ "at": at, "relative": relative })),
        "recorded_objective": provenance.objective,
        "objective": again.provenance.objective,
        "iterations": again.provenance.iterations,
        "seconds": begin.elapsed().as_secs_f64(),
    });
    files::print_summary(&summary, &arguments.out.as_deref().into_iter().collect::<Vec<_>>())?;
    match beyond {
        Some((at, relative)) => Err(format!(
            "the model differs from the recorded one, most at {at}, relatively by {relative:.1e}. The recorded model is of {}: that \
             version may give the same numbers",
            provenance.engine
        )
        .into()),
        None => Ok(()),
    }
}

/// Whether the model contains information from data sets that are not its own: a model of a library of
/// several movements. A library of one movement gives the same model as a plain training.
fn is_combination(model: &FittedModel) -> bool {
    matches!(model, FittedModel::Vcgpdm(model) if !model.external.is_empty())
}

/// The clip of a sequence, with the bones of the training.
fn clip_of(info: &SequenceInfo, infos: &[SequenceInfo], given: &[Clip]) -> Result<Clip, Box<dyn Error>> {
    let find = |info: &SequenceInfo| clips::find(given, &info.name, &info.sha256);
    let mut clip = find(info)?.clone();
    if let Some(name) = &info.bones_of {
        let owner = owner_of(name, infos);
        let owner = owner.ok_or_else(|| format!("expected a sequence of the clip {name}, found none"))?;
        clip = with_bones_of(&clip, find(owner)?)?;
    }
    Ok(match info.piece {
        Some((first, end)) => clip.cut(first, end)?,
        None => clip,
    })
}

/// The sequence of the clip whose bones others have.
fn owner_of<'a>(name: &str, infos: &'a [SequenceInfo]) -> Option<&'a SequenceInfo> {
    infos.iter().find(|info| info.name == name)
}

/// The number in which two models differ most, with the difference relative to the larger number; infinity if
/// the models have other fields.
fn difference(recorded: &Model, again: &Model) -> Result<Option<(String, f64)>, Box<dyn Error>> {
    let document = |model: &Model| -> Result<Value, Box<dyn Error>> {
        let mut document: Value = serde_json::from_str(&model.to_json()?)?;
        // The program and the note are not part of the model.
        for name in ["engine", "note"] {
            document["provenance"].as_object_mut().and_then(|fields| fields.remove(name));
        }
        // A copy of a clip may have another name: the content counts.
        let infos = &model.body.sequences;
        let sequences = document["sequences"].as_array_mut().into_iter().flatten();
        for (sequence, info) in sequences.zip(infos) {
            let Some(sequence) = sequence.as_object_mut() else { continue };
            sequence.remove("clip");
            if let Some(name) = &info.bones_of {
                let owner = owner_of(name, infos).map(|owner| owner.sha256.clone());
                sequence.insert("bones_of".to_owned(), owner.into());
            }
        }
        Ok(document)
    };
    let (recorded, mut again) = (document(recorded)?, document(again)?);
    // Files of earlier versions have no noise variance of each column.
    if recorded["parts"][0]["column_noise"].is_null() {
        again["version"] = recorded["version"].clone();
        for part in again["parts"].as_array_mut().into_iter().flatten() {
            part.as_object_mut().and_then(|fields| fields.remove("column_noise"));
        }
    }
    let mut largest = None;
    compare("model", &recorded, &again, &mut largest);
    Ok(largest)
}

fn compare(at: &str, a: &Value, b: &Value, largest: &mut Option<(String, f64)>) {
    let mut found = |relative: f64| {
        if largest.as_ref().is_none_or(|(_, before)| relative > *before) {
            *largest = Some((at.to_owned(), relative));
        }
    };
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap_or(f64::NAN), b.as_f64().unwrap_or(f64::NAN));
            if a != b {
                found((a - b).abs() / a.abs().max(b.abs()));
            }
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            for (k, (a, b)) in a.iter().zip(b).enumerate() {
                compare(&format!("{at}[{k}]"), a, b, largest);
            }
        }
        (Value::Object(a), Value::Object(b)) if a.len() == b.len() => {
            for (name, a) in a {
                compare(&format!("{at}.{name}"), a, b.get(name).unwrap_or(&Value::Null), largest);
            }
        }
        _ if a == b => {}
        _ => found(f64::INFINITY),
    }
}
