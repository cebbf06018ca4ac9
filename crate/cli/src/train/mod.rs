//! `vcgpdm train`: trains a model on clips or tables.

mod arguments;
mod body;
mod columns;
mod kind;
mod library;
mod steps;

pub use arguments::Arguments;
pub use body::parts;
pub use kind::{objective, pose_weight, weight};
use steps::{say_others, warn_of_training};
pub use steps::{train_steps, warn_of_cost};

use crate::clips;
use crate::files;
use crate::health::{advice, health_of, warning};
use crate::numbers::check_fps;
use crate::task::say;
use crate::usage::usage;
use body::with_hint;
use clap_lex::OsStrExt;
use serde_json::json;
use std::error::Error;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Instant;
use vcgpdm_core::models::variational::VariationalTrainer;
use vcgpdm_core::models::{
    ColumnMapping, Dataset, FittedModel, Health, Model, ModelKind, Provenance, Settings, Source, Trainer,
    VariationalSettings, with_bones_of,
};
use vcgpdm_core::motion::Clip;
use vcgpdm_lab::golden::Case;

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    if !arguments.movements.is_empty() {
        return library::run(arguments);
    }
    // clap cannot check this: --movement conflicts with the clips.
    if !arguments.share.is_empty() {
        return Err(usage("--share: expected --movement with it"));
    }
    let split = split(arguments)?;
    if arguments.columns {
        let dataset = columns::dataset(&arguments.clips, split, &arguments.without, arguments.fps)?;
        return train(arguments, split, &dataset, &[], |model| Ok((model.to_json()?, None)));
    }
    check_fps(arguments.fps)?;
    let mut clips: Vec<(Clip, Option<usize>)> = Vec::new();
    for path in &arguments.clips {
        clips.push((clips::read(path, &arguments.up)?, None));
    }
    for text in &arguments.seed_frames {
        let (path, count) = seed_frames(text)?;
        clips.push((clips::read(&path, &arguments.up)?, Some(count)));
    }
    let said: Vec<String> = clips.iter().flat_map(|(clip, _)| clips::warnings(clip)).collect();
    if arguments.first_bones {
        let first = clips[0].0.clone();
        for (clip, _) in &mut clips {
            *clip = with_bones_of(clip, &first)?;
        }
    }
    let parts = parts(split, &clips[0].0.skeleton)?;
    let sources: Vec<Source> =
        clips.iter().map(|(clip, first_frames)| Source { clip, first_frames: *first_frames }).collect();
    let dataset = Dataset::new(&sources, &parts, arguments.fps).map_err(with_hint)?;
    train(arguments, split, &dataset, &said, |model| Ok((model.to_json()?, health_of(model))))
}

/// The value of `--parts`; without it, "whole" for models that are not coupled.
fn split(arguments: &Arguments) -> Result<&str, Box<dyn Error>> {
    match (&arguments.parts, arguments.model) {
        (Some(split), _) => Ok(split),
        (None, None | Some(ModelKind::Vcgpdm | ModelKind::MapCgpdm)) => {
            let (data, example) =
                if arguments.columns { ("columns", "arm=x,y;leg=z") } else { ("body", "lower,upper") };
            Err(usage(format!(
                "--parts: expected how to split the {data} of a coupled model, such as {example}"
            )))
        }
        (None, Some(_)) => Ok("whole"),
    }
}

/// Trains on the data set, writes the model and prints a summary. `said` are warnings that were said before; `finish`
/// makes the document of the model and finds how its motion ends.
fn train<S: ColumnMapping>(
    arguments: &Arguments,
    split: &str,
    dataset: &Dataset<S>,
    said: &[String],
    finish: impl Fn(&Model<S>) -> Result<(String, Option<Health>), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let kind = kind::check_parts(arguments.model, dataset.layout.parts().len(), split)?;
    let usual = VariationalSettings::for_dataset(dataset);
    let settings = arguments.options.settings(kind, &usual)?;
    let mut read = arguments.clips.clone();
    for text in &arguments.seed_frames {
        read.push(seed_frames(text)?.0);
    }
    let read = read.iter().map(PathBuf::as_path);
    let start = arguments.options.write_start.as_deref().map(|path| ("--write-start", path));
    files::check_outs([Some(("--out", arguments.out.as_path())), start].into_iter().flatten(), read)?;
    warn_of_training(&settings, dataset);
    let begin = Instant::now();
    let seed = arguments.options.seed;
    let mut trainer = Trainer::new(dataset, &settings, seed)?;
    trainer.use_threads(arguments.options.threads.into());
    let warnings = trainer.warnings();
    say_others(&warnings, said);
    if let Some(path) = &arguments.options.write_start {
        write_start(path, dataset, &settings, seed)?;
    }
    let reason = train_steps(|| trainer.step(), objective(&settings))?;
    let seconds = begin.elapsed().as_secs_f64();
    let setbacks = trainer.progress().setbacks;

    let mut trained = trainer.finish()?;
    trained.provenance.note.clone_from(&arguments.note);
    let (document, health) = finish(&trained)?;
    files::write_text(&arguments.out, &document)?;
    let bound = trained.provenance.bound();
    let Provenance { objective, plain_bound, iterations, evaluations, .. } = trained.provenance;
    let summary = match &trained.fitted {
        FittedModel::Vcgpdm(model) => {
            let mut summary = json!({
                "kind": kind.id(),
                "elbo": bound,
                "terms": model.terms,
                "dynamics_elbo": model.terms.dynamics_elbo(),
                "alpha": files::rows(&model.alpha),
                "iterations": iterations,
                "evaluations": evaluations,
                "setbacks": setbacks,
                "seconds": seconds,
                "warnings": warnings,
                "reason": reason,
            });
            if plain_bound.is_some() {
                summary["objective"] = objective.into();
            }
            if let Some(settings) = trained.provenance.settings.variational() {
                summary["dynamics_ips"] = settings.dynamics_ips.into();
                summary["pose_ips"] = settings.pose_ips.into();
                if let Some(health) = health {
                    let parts = dataset.layout.parts();
                    let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
                    let words = warning(&health, &names).map(|ends| (ends, advice(settings, &usual)));
                    if let Some((ends, advice)) = &words {
                        say(&format!("warning: a motion of the model {ends}; {advice}"));
                    }
                    summary["rollout_rounds"] = trained.provenance.rollout_rounds.into();
                    summary["health"] = json!(health);
                    summary["advice"] = json!(words.map(|(_, advice)| advice));
                }
            }
            summary
        }
        model => json!({
            "kind": kind.id(),
            "objective": objective,
            "bound": model.bound(),
            "iterations": iterations,
            "setbacks": setbacks,
            "seconds": seconds,
            "warnings": warnings,
            "reason": reason,
        }),
    };
    files::print_summary(&summary, &[&arguments.out])
}

/// Writes the starting point of the training of a variational model, as the input of a case.
fn write_start<S: ColumnMapping>(
    path: &Path,
    dataset: &Dataset<S>,
    settings: &Settings,
    seed: u32,
) -> Result<(), Box<dyn Error>> {
    // No other kind has the option.
    if let Settings::Vcgpdm(settings) | Settings::Vgpdm(settings) = settings {
        let trainer = VariationalTrainer::new(dataset.y.clone(), dataset.lengths(), settings, seed)?;
        files::write_text(path, &Case::write(&trainer.best(), &trainer.objective())?)?;
    }
    Ok(())
}

/// Reads `CLIP:COUNT`; the path of the clip may have colons too.
fn seed_frames(text: &OsStr) -> Result<(PathBuf, usize), Box<dyn Error>> {
    let words: Vec<&OsStr> = text.split(":").collect();
    let parsed = words
        .split_last()
        .and_then(|(count, clip)| Some((clip.join(OsStr::new(":")), count.to_str()?.parse::<usize>().ok()?)));
    match parsed {
        Some((clip, count)) if count > 0 && !clip.is_empty() => Ok((clip.into(), count)),
        _ => Err(usage(format!(
            "--seed-frames {}: expected CLIP:COUNT with a number of frames above 0",
            text.display()
        ))),
    }
}
