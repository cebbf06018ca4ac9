//! `vcgpdm train`: clips to a model.

use crate::{files, interrupt};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::time::Instant;
use vcgpdm::{
    Case, Clip, Dataset, MotionModel, PartSpec, Skeleton, Source, Trainer, TrainingProgress,
    TrainingSettings, parts_from_json, presets,
};

/// Train a model on clips of one body and print its bound as one JSON object.
#[derive(clap::Args)]
pub struct Arguments {
    /// BVH files, or sample:ID; each becomes a sequence.
    #[arg(value_name = "CLIP", required = true)]
    clips: Vec<String>,
    /// How to split the body: a preset by its id or its parts' names (whole; lower,upper; legs,trunk,left arm,right arm), or a
    /// file with a list like [{"name": "legs", "joints": ["LeftUpLeg", 3]}].
    #[arg(long, value_name = "lower,upper|whole|FILE")]
    parts: String,
    /// Write the model to this file.
    #[arg(long, value_name = "MODEL.json")]
    out: PathBuf,
    /// The seed of everything random.
    #[arg(long, value_name = "S", default_value_t = TrainingSettings::default().seed)]
    seed: u32,
    /// Latent dimensions of every part.
    #[arg(long, value_name = "Q", default_value_t = TrainingSettings::default().latent)]
    latent: usize,
    /// Inducing points of every dynamics map.
    #[arg(long, value_name = "K", default_value_t = TrainingSettings::default().dynamics_ips)]
    dynamics_ips: usize,
    /// Inducing points of every pose map.
    #[arg(long, value_name = "L", default_value_t = TrainingSettings::default().pose_ips)]
    pose_ips: usize,
    /// Frames of history that the dynamics see.
    #[arg(long, value_name = "P", default_value_t = TrainingSettings::default().order)]
    order: usize,
    /// Resample the clips to about so many frames a second.
    #[arg(long, value_name = "F", default_value_t = 30.0, allow_negative_numbers = true)]
    fps: f64,
    /// Most iterations of the optimiser.
    #[arg(long, value_name = "N", default_value_t = TrainingSettings::default().max_iterations)]
    max_iterations: usize,
    /// Add the first COUNT frames of another clip, after resampling, as a sequence of their own.
    #[arg(long, value_name = "CLIP:COUNT")]
    seed_frames: Vec<String>,
    /// Write the starting point as the input of a case, for another implementation to start from.
    #[arg(long, value_name = "CASE.json")]
    write_start: Option<PathBuf>,
    /// Keep a note in the model, such as an acknowledgement.
    #[arg(long, value_name = "TEXT")]
    note: Option<String>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let mut clips = Vec::new();
    for place in &arguments.clips {
        clips.push((files::read_clip(place)?, None));
    }
    for text in &arguments.seed_frames {
        let (clip, count) = read_seed_frames(text)?;
        clips.push((clip, Some(count)));
    }
    let parts = parts(&arguments.parts, &clips[0].0.skeleton)?;
    let sources: Vec<Source> =
        clips.iter().map(|(clip, first_frames)| Source { clip, first_frames: *first_frames }).collect();
    let dataset = Dataset::new(&sources, &parts, arguments.fps)?;
    let settings = TrainingSettings {
        latent: arguments.latent,
        dynamics_ips: arguments.dynamics_ips,
        pose_ips: arguments.pose_ips,
        order: arguments.order,
        seed: arguments.seed,
        max_iterations: arguments.max_iterations,
    };
    files::check_writable(&arguments.out)?;

    let begin = Instant::now();
    let mut trainer = Trainer::new(dataset.y.clone(), dataset.lengths(), settings)?;
    if let Some(path) = &arguments.write_start {
        files::write_text(path, &Case::write(&trainer.best(), &trainer.objective())?)?;
    }
    let progress = train(&mut trainer)?;
    let seconds = begin.elapsed().as_secs_f64();

    let mut model = MotionModel::trained(&dataset, &trainer, arguments.fps)?;
    model.provenance.note.clone_from(&arguments.note);
    files::write_text(&arguments.out, &model.to_json()?)?;
    let alpha: Vec<Vec<f64>> =
        model.fitted.alpha.row_iter().map(|row| row.iter().copied().collect()).collect();
    files::print_json(&json!({
        "elbo": progress.best,
        "terms": progress.terms,
        "alpha": alpha,
        "iterations": progress.iteration,
        "evaluations": progress.evaluations,
        "seconds": seconds,
        "warnings": dataset.warnings,
        "reason": progress.reason.unwrap_or_else(|| "stopped".to_owned()),
    }))
}

/// Trains to the end, or until Ctrl-C: then the best so far is kept. The bar is drawn on stderr, and only when that is a terminal.
fn train(trainer: &mut Trainer) -> Result<TrainingProgress, Box<dyn Error>> {
    let stopped = interrupt::flag()?;
    let bar = ProgressBar::new(trainer.settings().max_iterations as u64);
    if let Ok(style) =
        ProgressStyle::with_template("{bar:30} {pos}/{len}  {msg}  {elapsed} (at most {eta} left)")
    {
        bar.set_style(style);
    }
    loop {
        let progress = trainer.step();
        bar.set_position(progress.iteration as u64);
        bar.set_message(format!("bound {:.1}, {}", progress.best, progress.phase));
        if progress.done || stopped.load(Ordering::Relaxed) {
            bar.finish_and_clear();
            return Ok(progress);
        }
    }
}

/// `CLIP:COUNT`; the clip's place may hold colons itself.
fn read_seed_frames(text: &str) -> Result<(Clip, usize), Box<dyn Error>> {
    let parsed = text.rsplit_once(':').and_then(|(clip, count)| Some((clip, count.parse::<usize>().ok()?)));
    match parsed {
        Some((clip, count)) if count > 0 && !clip.is_empty() => Ok((files::read_clip(clip)?, count)),
        _ => Err(format!("--seed-frames {text}: expected CLIP:COUNT with a number of frames above 0").into()),
    }
}

/// The parts that `--parts` asks for.
pub fn parts(asked: &str, skeleton: &Skeleton) -> Result<Vec<PartSpec>, Box<dyn Error>> {
    let presets = presets(skeleton);
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
        return parts_from_json(&files::read_text(path)?, skeleton)
            .map_err(|error| files::about(path, &error));
    }
    let known: Vec<String> = presets
        .iter()
        .map(|preset| preset.parts.iter().map(|part| part.name.as_str()).collect::<Vec<_>>().join(","))
        .collect();
    Err(format!(
        "--parts {asked}: expected whole, a file, or what this body can be split into ({})",
        known.join("; ")
    )
    .into())
}
