//! `vcgpdm train --movement`: trains a library of primitives on clips of several movements.

use crate::clips;
use crate::files;
use crate::health::{health_of, warning};
use crate::library::primitives_by_part;
use crate::numbers::check_fps;
use crate::task::say;
use crate::train::arguments::Arguments;
use crate::train::body::{parts, with_hint};
use crate::train::kind::objective;
use crate::train::steps::{say_others, train_steps, warn_of_training};
use crate::usage::usage;
use clap_lex::OsStrExt;
use serde_json::json;
use std::error::Error;
use std::ffi::OsStr;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm_core::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement, TrainedLibrary};
use vcgpdm_core::models::{
    Dataset, Health, ModelKind, Setbacks, Settings, Source, VariationalSettings, with_bones_of,
};

/// A movement of the command line.
struct Movement {
    name: String,
    clips: Vec<PathBuf>,
}

/// Reads `NAME=CLIP,CLIP`.
fn movement(text: &OsStr) -> Result<Movement, Box<dyn Error>> {
    let path = |clip: &OsStr| clip.to_str().map_or_else(|| clip.into(), |clip| PathBuf::from(clip.trim()));
    let parsed = text.split_once("=").map(|(name, clips)| Movement {
        name: name.to_string_lossy().trim().to_owned(),
        clips: clips.split(",").map(path).filter(|clip| !clip.as_os_str().is_empty()).collect(),
    });
    parsed.filter(|movement| !movement.clips.is_empty()).ok_or_else(|| {
        usage(format!("--movement {}: expected NAME=CLIP,CLIP with at least one clip", text.display()))
    })
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let movements = arguments.movements.iter().map(|text| movement(text)).collect::<Result<Vec<_>, _>>()?;
    let split = arguments
        .parts
        .as_deref()
        .ok_or_else(|| usage("--parts: expected how to split the body of a library, such as lower,upper"))?;
    if !matches!(arguments.model, None | Some(ModelKind::Vcgpdm)) {
        return Err(usage("--movement: expected no other model than vcgpdm, which alone has primitives"));
    }
    check_fps(arguments.fps)?;
    let paths: Vec<PathBuf> = movements.iter().flat_map(|movement| movement.clips.clone()).collect();
    let clips = paths.iter().map(|path| clips::read(path, &arguments.up));
    let mut clips = clips.collect::<Result<Vec<_>, _>>()?;
    let said: Vec<String> = clips.iter().flat_map(clips::warnings).collect();
    if arguments.first_bones {
        let first = clips[0].clone();
        for clip in &mut clips {
            *clip = with_bones_of(clip, &first)?;
        }
    }
    let parts = parts(split, &clips[0].skeleton)?;
    let mut shared = vec![false; parts.len()];
    for name in arguments.share.iter().flat_map(|text| text.split(',')) {
        let index = parts.iter().position(|part| part.name == name.trim()).ok_or_else(|| {
            let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
            usage(format!("--share {name}: expected one of the parts {}", names.join(", ")))
        })?;
        shared[index] = true;
    }
    let planned = movements
        .into_iter()
        .map(|movement| PlannedMovement { name: movement.name, sequences: movement.clips.len() });
    let plan =
        LibraryPlan::new(planned.collect(), shared).map_err(|error| usage(format!("--movement: {error}")))?;
    // A library has the settings of the vCGPDM: options of other kinds are refused.
    let model_settings =
        arguments.options.settings(ModelKind::Vcgpdm, &VariationalSettings::for_library())?;
    let Settings::Vcgpdm(settings) = &model_settings else {
        return Err("expected settings of a vcgpdm".into());
    };
    if arguments.options.write_start.is_some() {
        return Err(usage("--write-start: expected a plain model, found movements"));
    }
    let sources: Vec<Source> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let dataset = Dataset::new(&sources, &parts, arguments.fps).map_err(with_hint)?;
    files::check_writable(&arguments.out, paths.iter().map(PathBuf::as_path))?;
    let begin = Instant::now();
    warn_of_training(&model_settings, &dataset);
    let seed = arguments.options.seed;
    let mut trainer = LibraryTrainer::new(&dataset, &plan, settings, seed)?;
    trainer.use_threads(arguments.options.threads.into());
    let warnings = trainer.warnings();
    say_others(&warnings, &said);
    let reason = train_steps(|| trainer.step(), objective(&model_settings))?;
    let seconds = begin.elapsed().as_secs_f64();
    let mut trained = trainer.finish()?;
    trained.provenance.note.clone_from(&arguments.note);
    files::write_text(&arguments.out, &trained.to_json()?)?;
    let healths = healths(&trained);
    let end = (&*reason, trainer.progress().setbacks);
    files::print_summary(&summary(&trained, &healths, seconds, end, &warnings), &[&arguments.out])
}

/// How the motion of each movement ends. Warns of those that do not move on.
fn healths(trained: &TrainedLibrary) -> Vec<Option<Health>> {
    let names: Vec<&str> = trained.body.layout.parts().iter().map(|part| part.name.as_str()).collect();
    let movements = trained.library.movements.iter().enumerate();
    let healths = movements.map(|(index, movement)| {
        let health = trained.movement(index).ok().as_ref().and_then(health_of);
        if let Some(ends) = health.as_ref().and_then(|health| warning(health, &names)) {
            say(&format!("warning: the movement {} {ends}; another --seed may help", movement.name));
        }
        health
    });
    healths.collect()
}

fn summary(
    trained: &TrainedLibrary,
    healths: &[Option<Health>],
    seconds: f64,
    (reason, setbacks): (&str, Setbacks),
    warnings: &[String],
) -> serde_json::Value {
    let library = &trained.library;
    let parts = trained.body.layout.parts();
    let primitives: Vec<_> = library
        .primitives
        .iter()
        .map(|primitive| json!({ "part": parts[primitive.part].name, "name": primitive.name }))
        .collect();
    let movements: Vec<_> = library
        .movements
        .iter()
        .zip(healths)
        .map(|(movement, health)| {
            json!({
                "name": movement.name,
                "uses": primitives_by_part(trained, &movement.uses),
                "alpha": files::rows(&movement.alpha),
                "rollout_rounds": movement.rollout_rounds,
                "health": health,
            })
        })
        .collect();
    let mut summary = json!({
        "kind": "library",
        "elbo": trained.provenance.bound(),
        "terms": library.terms,
        "primitives": primitives,
        "movements": movements,
        "iterations": trained.provenance.iterations,
        "evaluations": trained.provenance.evaluations,
        "setbacks": setbacks,
        "seconds": seconds,
        "warnings": warnings,
        "reason": reason,
    });
    if trained.provenance.plain_bound.is_some() {
        summary["objective"] = trained.provenance.objective.into();
    }
    summary
}
