//! `vcgpdm train`: clips to a model.

mod columns;
mod kind;
mod library;

use crate::progress::Progress;
use crate::usage::usage;
use crate::{files, interrupt};
use serde_json::json;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::time::Instant;
use vcgpdm::document::DocumentError;
use vcgpdm::golden::Case;
use vcgpdm::models::variational::Trainer;
use vcgpdm::models::{
    Dataset, DatasetError, Learner, LearningProgress, Model, ModelKind, ModelSettings, Movements, Observed,
    Provenance, Source, TrainedModel, with_bones_of,
};
use vcgpdm::motion::parts::PartSpec;
use vcgpdm::motion::{Clip, Skeleton, parts};

/// Train a model on clips of one body and print what it reached as one JSON object.
#[derive(clap::Args)]
pub struct Arguments {
    /// BVH files, or sample:ID; each becomes a sequence. With --columns: CSV files.
    #[arg(value_name = "CLIP", required_unless_present = "movements", conflicts_with = "movements")]
    clips: Vec<String>,
    /// Train a library of primitives: clips of one movement, under its name; may be given several times.
    #[arg(long = "movement", value_name = "NAME=CLIP,CLIP", conflicts_with = "seed_frames")]
    movements: Vec<String>,
    /// Parts that use the same primitive in all movements; every other part has one of its own in each.
    #[arg(long, value_name = "PART,PART", requires = "movements")]
    share: Vec<String>,
    /// What to train: vcgpdm, vgpdm, map-gpdm, map-cgpdm, tmp, dmp-discrete or dmp-rhythmic; absent: vcgpdm, or vgpdm for one part.
    #[arg(long, value_name = "KIND", value_parser = kind::named)]
    model: Option<ModelKind>,
    /// How to split the body: a preset by its id or its parts' names (whole; lower,upper; legs,trunk,left arm,right arm), or a
    /// file with a list like [{"name": "legs", "joints": ["LeftUpLeg", 3]}]. Models that are not coupled need none. With --columns:
    /// arm=x,y;leg=z (a name that ends with * means all that begin so), or a file with [{"name": "arm", "columns": ["x", "y"]}].
    #[arg(long, value_name = "lower,upper|whole|FILE")]
    parts: Option<String>,
    /// Train on columns of numbers that are no body: each CLIP is a CSV file, with the names of the columns in its first row and a row a
    /// moment. A column "time" holds seconds; a column "frame" is left out.
    #[arg(long, conflicts_with_all = ["seed_frames", "first_bones", "movements"])]
    columns: bool,
    /// Write the model to this file.
    #[arg(long, value_name = "MODEL.json")]
    out: PathBuf,
    /// Resample the clips to about so many frames a second. With --columns: the rows a second of files without times.
    #[arg(long, value_name = "F", default_value_t = 30.0)]
    fps: f64,
    /// Add the first COUNT frames of another clip, after resampling, as a sequence of their own.
    #[arg(long, value_name = "CLIP:COUNT")]
    seed_frames: Vec<String>,
    /// Give all clips the bones of the first: for recordings of several people with the same joints. Joint angles stay, the way of the
    /// root is scaled as its height above the ground is.
    #[arg(long)]
    first_bones: bool,
    /// Keep a note in the model, such as an acknowledgement.
    #[arg(long, value_name = "TEXT")]
    note: Option<String>,
    #[command(flatten)]
    options: kind::Options,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    if !arguments.movements.is_empty() {
        return library::run(arguments);
    }
    let split = split(arguments)?;
    if arguments.columns {
        let dataset = columns::dataset(&arguments.clips, split, arguments.fps)?;
        let rate = 1.0 / dataset.frame_time;
        return learn(arguments, split, &dataset, rate, |model| model.to_json());
    }
    let mut clips = Vec::new();
    for place in &arguments.clips {
        clips.push((files::read_clip(place)?, None));
    }
    for text in &arguments.seed_frames {
        let (clip, count) = read_seed_frames(text)?;
        clips.push((clip, Some(count)));
    }
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
    learn(arguments, split, &dataset, arguments.fps, |model| model.to_json())
}

/// What `--parts` says, or all as one part for models that are not coupled.
fn split(arguments: &Arguments) -> Result<&str, Box<dyn Error>> {
    match (&arguments.parts, arguments.model) {
        (Some(split), _) => Ok(split),
        (None, None | Some(ModelKind::Vcgpdm | ModelKind::MapCgpdm)) => {
            Err(usage("--parts: expected how to split the body of a coupled model, such as lower,upper"))
        }
        (None, Some(_)) => Ok("whole"),
    }
}

/// Trains on the data set, and writes the model and what it reached; `fps` is the rate that the data set was asked for.
fn learn<S: Observed>(
    arguments: &Arguments,
    split: &str,
    dataset: &Dataset<S>,
    fps: f64,
    to_json: impl Fn(&TrainedModel<Model, S>) -> Result<String, DocumentError>,
) -> Result<(), Box<dyn Error>> {
    let kind = kind::of_parts(arguments.model, dataset.layout.parts().len(), split)?;
    let settings = arguments.options.settings(kind)?;
    let movements = Movements::of(dataset);
    let seed_frames =
        arguments.seed_frames.iter().filter_map(|text| text.rsplit_once(':')).map(|(clip, _)| clip);
    let read = arguments.clips.iter().map(String::as_str).chain(seed_frames).map(Path::new);
    let outs = [Some(&arguments.out), arguments.options.write_start.as_ref()];
    files::check_outs(outs.into_iter().flatten(), read)?;
    let begin = Instant::now();
    let seed = arguments.options.seed;
    let mut learner = settings.learner(&movements, seed).map_err(|reason| dataset.refusal(reason))?;
    if let Some(path) = &arguments.options.write_start {
        write_start(path, movements, &settings, seed)?;
    }
    let reason = train(&mut *learner, objective(kind))?;
    let seconds = begin.elapsed().as_secs_f64();

    let mut trained = TrainedModel::<Model, S>::trained(dataset, &*learner, settings, seed, fps)?;
    trained.provenance.note.clone_from(&arguments.note);
    files::write_text(&arguments.out, &to_json(&trained)?)?;
    let Provenance { objective, iterations, evaluations, .. } = trained.provenance;
    let summary = match &trained.model {
        Model::Vcgpdm(model) => {
            let rows = model.alpha.row_iter();
            let alpha: Vec<Vec<f64>> = rows.map(|row| row.iter().copied().collect()).collect();
            json!({
                "kind": kind.id(),
                "elbo": objective,
                "terms": model.terms,
                "alpha": alpha,
                "iterations": iterations,
                "evaluations": evaluations,
                "seconds": seconds,
                "warnings": dataset.warnings,
                "reason": reason,
            })
        }
        model => json!({
            "kind": kind.id(),
            "objective": objective,
            "bound": model.bound(),
            "iterations": iterations,
            "seconds": seconds,
            "warnings": dataset.warnings,
            "reason": reason,
        }),
    };
    files::print_summary(&summary, &[&arguments.out])
}

/// The reason, and what helps where only the bones differ.
fn with_hint(reason: DatasetError) -> Box<dyn Error> {
    match &reason {
        DatasetError::Body { reason: body, .. } if body.is_of_bones() => {
            format!("{reason}; --first-bones gives all clips the bones of the first").into()
        }
        _ => reason.into(),
    }
}

/// Writes where the training of a variational model starts, as the input of a case.
fn write_start(
    path: &Path,
    movements: Movements,
    settings: &ModelSettings,
    seed: u32,
) -> Result<(), Box<dyn Error>> {
    // No other kind has the option.
    if let ModelSettings::Vcgpdm(settings) | ModelSettings::Vgpdm(settings) = settings {
        let lengths = movements.lengths();
        let trainer = Trainer::new(movements.y, lengths, settings, seed)?;
        files::write_text(path, &Case::write(&trainer.best(), &trainer.objective())?)?;
    }
    Ok(())
}

/// What a training of this kind maximises, in words.
fn objective(kind: ModelKind) -> &'static str {
    match kind {
        ModelKind::Vcgpdm | ModelKind::Vgpdm | ModelKind::Tmp => "bound",
        ModelKind::MapGpdm | ModelKind::MapCgpdm => "log density",
        ModelKind::DmpDiscrete | ModelKind::DmpRhythmic => "minus the mean squared error",
    }
}

/// Trains to the end, or until Ctrl-C or SIGTERM: then the best so far is kept. Says why it ended.
fn train(learner: &mut dyn Learner, objective: &str) -> Result<String, Box<dyn Error>> {
    train_steps(|| learner.step(), objective)
}

/// As `train`, one step after the other.
pub fn train_steps(
    mut step: impl FnMut() -> LearningProgress,
    objective: &str,
) -> Result<String, Box<dyn Error>> {
    let stopped = interrupt::flag()?;
    let mut shown = Progress::new("at most");
    loop {
        let progress = step();
        // Not the iterations: a search for the number of primitives may end long before the most there can be.
        shown.show(progress.fraction, || {
            let phase = progress.phase.map_or(String::new(), |phase| format!(", {phase}"));
            let (iteration, most, best) = (progress.iteration, progress.max_iterations, progress.best);
            format!("{iteration}/{most}  {objective} {best:.1}{phase}")
        });
        if progress.done || stopped.load(Ordering::Relaxed) {
            shown.finish();
            return Ok(progress.reason.map_or_else(|| "stopped".to_owned(), |reason| reason.to_string()));
        }
    }
}

/// `CLIP:COUNT`; the clip's place may hold colons itself.
fn read_seed_frames(text: &str) -> Result<(Clip, usize), Box<dyn Error>> {
    let parsed = text.rsplit_once(':').and_then(|(clip, count)| Some((clip, count.parse::<usize>().ok()?)));
    match parsed {
        Some((clip, count)) if count > 0 && !clip.is_empty() => Ok((files::read_clip(clip)?, count)),
        _ => Err(usage(format!("--seed-frames {text}: expected CLIP:COUNT with a number of frames above 0"))),
    }
}

/// The parts that `--parts` asks for.
pub fn parts(asked: &str, skeleton: &Skeleton) -> Result<Vec<PartSpec>, Box<dyn Error>> {
    let presets = parts::presets(skeleton);
    if let Some(preset) = presets.iter().find(|preset| preset.id == asked) {
        return Ok(preset.parts.clone());
    }
    // The parts' names, in the order in which the model is to have them.
    let names: Vec<&str> = asked.split(',').map(str::trim).collect();
    for preset in presets.iter().filter(|preset| preset.parts.len() == names.len()) {
        let chosen: Option<Vec<PartSpec>> =
            names.iter().map(|name| preset.parts.iter().find(|part| part.name == *name).cloned()).collect();
        if let Some(chosen) =
            chosen.filter(|_| names.iter().all(|a| names.iter().filter(|b| a == *b).count() == 1))
        {
            return Ok(chosen);
        }
    }
    let path = Path::new(asked);
    if path.exists() {
        return parts::from_json(&files::read_text(path)?, skeleton)
            .map_err(|error| files::about(path, &error));
    }
    let known: Vec<String> = presets
        .iter()
        .map(|preset| preset.parts.iter().map(|part| part.name.as_str()).collect::<Vec<_>>().join(","))
        .collect();
    Err(usage(format!(
        "--parts {asked}: expected whole, a file, or what this body can be split into ({})",
        known.join("; ")
    )))
}
