//! `vcgpdm study`: makes a study of perceived naturalness from an evaluation and its clips.

use crate::clips::{self, Up};
use crate::evaluate::models;
use crate::numbers::{check_within, whole};
use crate::task::Task;
use crate::usage::{first_given, usage};
use crate::{files, results};
use serde_json::json;
use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use vcgpdm_core::models::{Body, Settings, with_bones_of};
use vcgpdm_core::motion::Clip;
use vcgpdm_core::motion::pose::RootStart;
use vcgpdm_lab::evaluation::{Fold, Job, Outcome, Results, TrialClip};
use vcgpdm_lab::perception::{Look, Maker, Preset, Study, StudyMovement, TrialKind};

/// Make a study of perceived naturalness: which of two movements, a natural and a generated one, is the more
/// natural?
///
/// Of the results of an evaluation and its clips, the study takes every model but promp and ar with all its
/// settings, and of several seeds the one whose rollouts repeat the training trials best. Each is trained again, because results do not contain
/// movements, and predicts each trial held out. This takes as long as the trainings took; the number of
/// seconds is printed before. Without clips, the command changes the design or the look of a study, or marks
/// other movements as failures.
#[derive(clap::Args)]
pub struct Arguments {
    /// Results that `evaluate` wrote, or a study to change.
    #[arg(value_name = "RESULTS.json")]
    source: PathBuf,
    /// The clips of the evaluation, in any order: BVH files, or sample:ID. They are recognised by their
    /// content.
    #[arg(value_name = "CLIP")]
    clips: Vec<PathBuf>,
    /// Natural movements that no model has seen, for catch trials.
    #[arg(long, value_name = "CLIP", num_args = 1.., value_delimiter = ',')]
    unseen: Vec<PathBuf>,
    #[command(flatten)]
    up: Up,
    /// Only these models: all, or ids; absent: all.
    #[arg(long, value_name = "all|ID,ID")]
    models: Option<String>,
    /// Only predictions of these trials: all, or numbers from 1; absent: all.
    #[arg(long, value_name = "all|N,N")]
    folds: Option<String>,
    /// The trials and times: class, p3-part-1, p3-part-2 or p2.
    #[arg(long, value_name = "DESIGN")]
    preset: Option<String>,
    /// How the figures are drawn: figure, or points (point lights).
    #[arg(long, value_name = "figure|points")]
    look: Option<String>,
    /// The title of the study.
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// Ids of the generated movements that are marked as obvious failures, which check the attention. All
    /// other movements are unmarked.
    #[arg(long, value_name = "ID,ID", value_delimiter = ',')]
    failed: Option<Vec<String>>,
    /// Seconds of every movement, at most those of the design, 3.5 (p2: 1.8), which are the default.
    #[arg(long, value_name = "S")]
    seconds: Option<f64>,
    /// The seed of everything random in the design.
    #[arg(long, value_name = "S", value_parser = whole(0..=u32::MAX))]
    seed: Option<u32>,
    /// Trainings at the same time; absent: one for each core.
    #[arg(long, value_name = "T", value_parser = whole(1..=u16::MAX))]
    threads: Option<u16>,
    /// Write the study to this file.
    #[arg(long, value_name = "STUDY.json")]
    out: PathBuf,
}

/// Default seconds of every movement.
const SECONDS: f64 = 3.5;

impl Arguments {
    /// The first option on the command line that only acts when a study is made.
    fn making_option(&self) -> Option<&'static str> {
        let options = [
            ("--unseen", !self.unseen.is_empty()),
            ("--up", self.up.axis.is_some()),
            ("--clip-fps", self.up.rate.clip_fps.is_some()),
            ("--root", self.up.root.is_some()),
            ("--models", self.models.is_some()),
            ("--folds", self.folds.is_some()),
            ("--seconds", self.seconds.is_some()),
        ];
        first_given(options)
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let clips = arguments.clips.iter().chain(&arguments.unseen).map(PathBuf::as_path);
    files::check_writable(&arguments.out, clips.chain([arguments.source.as_path()]))?;
    if let Some(seconds) = arguments.seconds {
        check_within("--seconds", "seconds", Study::SECONDS, seconds)?;
    }
    let preset = arguments.preset.as_deref().map(preset).transpose()?;
    let look = arguments.look.as_deref().map(look).transpose()?;
    let mut study = if arguments.clips.is_empty() {
        if let Some(option) = arguments.making_option() {
            return Err(usage(format!(
                "{option}: expected the clips of an evaluation with it; an existing study keeps its movements"
            )));
        }
        let old = read(&arguments.source)?;
        if let Some(preset) = preset { old.with_preset(preset) } else { old }
    } else {
        make(arguments, preset.unwrap_or(Preset::Class))?
    };
    if let Some(look) = look {
        study.look = look;
    }
    if let Some(title) = &arguments.title {
        study.title.clone_from(title);
    }
    if let Some(seed) = arguments.seed {
        study.design.seed = seed;
    }
    if let Some(ids) = &arguments.failed {
        study = study.with_failed(ids)?;
    }
    let text = study.to_json()? + "\n";
    // A study that cannot be read must not reach participants.
    let study = Study::from_json(&text)?;
    files::write_text(&arguments.out, &text)?;
    let trials = study.trials(0);
    let count = |kind: TrialKind| trials.iter().filter(|trial| trial.kind == kind).count();
    let failed = study.stimuli.iter().filter(|stimulus| stimulus.failed()).count();
    let summary = json!({
        "hash": study.hash()?,
        "natural": study.stimuli.iter().filter(|stimulus| stimulus.natural() == Some(true)).count(),
        "unseen": study.stimuli.iter().filter(|stimulus| stimulus.natural() == Some(false)).count(),
        "generated": study.stimuli.iter().filter(|stimulus| stimulus.generated().is_some()).count(),
        "failed": failed,
        "blocks": study.design.blocks,
        "comparisons": count(TrialKind::Comparison),
        "attention_checks": count(TrialKind::Attention),
        "catch_trials": count(TrialKind::Catch),
        "bytes": text.len(),
    });
    files::print_summary(&summary, &[&arguments.out])
}

/// Reads a study.
pub fn read(path: &Path) -> Result<Study, Box<dyn Error>> {
    Study::from_json(&files::read_text(path)?).map_err(|error| files::with_path(path, &error))
}

fn preset(id: &str) -> Result<Preset, Box<dyn Error>> {
    Preset::from_id(id).ok_or_else(|| {
        let ids = Preset::ALL.map(Preset::id).join(", ");
        usage(format!("--preset {id}: expected one of {ids}"))
    })
}

fn look(id: &str) -> Result<Look, Box<dyn Error>> {
    Look::from_id(id).ok_or_else(|| usage(format!("--look {id}: expected figure or points")))
}

fn make(arguments: &Arguments, preset: Preset) -> Result<Study, Box<dyn Error>> {
    let results = results::read(&arguments.source)?;
    let setting = results.setting();
    let given = clips::read_all(&arguments.clips, &arguments.up)?;
    let clips = setting.trials.iter().map(|trial| clip_of(trial, &given)).collect::<Result<Vec<_>, _>>()?;
    let unseen = clips::read_all(&arguments.unseen, &arguments.up)?;
    let best = best(arguments, &results)?;
    let (rate, start) = (setting.frames_per_second, setting.start_frames);

    let mut folds = Vec::new();
    for trial in 0..clips.len() {
        folds.push(Fold::new(&clips, trial, clips.len() - 1, &setting.parts, rate, start)?);
    }
    let Some(body) = folds.first().map(Fold::body) else { return Err("expected trials, found none".into()) };
    let (skeleton, frame_time) = (body.mapping.skeleton().clone(), body.frame_time);
    let mut maker = Maker::new(&skeleton, arguments.seconds.unwrap_or(SECONDS), 1.0 / frame_time, start);
    for (trial, fold) in folds.iter().enumerate() {
        let positions = fold.body().positions(fold.actual())?;
        let (name, frame_time) = (&setting.trials[trial].name, fold.body().frame_time);
        maker.natural(&StudyMovement { trial, name, positions: &positions, frame_time }, true)?;
    }
    for (trial, clip) in unseen.iter().enumerate() {
        let positions = unseen_positions(body, clip, &clips[0])?;
        let movement = StudyMovement { trial, name: &clip.name, positions: &positions, frame_time };
        maker.natural(&movement, false)?;
    }
    for (job, (positions, outcome)) in predictions(&best, &folds, arguments)? {
        let (trial, name) = (job.held_out, &setting.trials[job.held_out].name);
        let frame_time = folds[trial].body().frame_time;
        let movement = StudyMovement { trial, name, positions: &positions, frame_time };
        maker.generated(&movement, settings(&job)?, job.seed, &outcome)?;
    }
    let title = arguments.title.clone().unwrap_or_else(|| "Which movement is more natural?".to_owned());
    let look = Look::Figure;
    Ok(maker.study(&title, preset, look, arguments.seed.unwrap_or(0))?)
}

/// The clip of a trial, cut as in the evaluation.
fn clip_of(trial: &TrialClip, given: &[Clip]) -> Result<Clip, Box<dyn Error>> {
    let clip = clips::find(given, &trial.name, &trial.sha256)?;
    Ok(match trial.piece {
        Some((first, end)) => clip.cut(first, end)?,
        None => clip.clone(),
    })
}

/// The joint positions of a clip that is not a trial, by way of the same columns as those of the trials.
fn unseen_positions(body: &Body, clip: &Clip, first: &Clip) -> Result<Vec<f32>, Box<dyn Error>> {
    let clip = with_bones_of(clip, first)?;
    let columns = body.mapping.encode(&clip.resample(1.0 / body.frame_time)?)?;
    Ok(body.mapping.decode_positions(&columns.y, &RootStart::default())?)
}

/// The seed with the best rollouts on the training trials for each candidate in each fold, with the seconds of
/// its training. Only models of the library that were trained on all other trials count.
fn best(arguments: &Arguments, results: &Results) -> Result<Vec<(Job, f64)>, Box<dyn Error>> {
    let trials = results.setting().trials.len();
    let kinds = models(arguments.models.as_deref().unwrap_or("all"))?;
    let folds = crate::evaluate::folds(arguments.folds.as_deref().unwrap_or("all"), trials)?;
    let mut best: Vec<(Job, &Outcome)> = Vec::new();
    for finished in results.in_order() {
        let (job, Some(outcome)) = (&finished.job, &finished.outcome) else { continue };
        let wanted = settings(job).is_ok()
            && kinds.contains(&job.candidate.kind())
            && (folds.is_empty() || folds.contains(&job.held_out));
        if !wanted || job.training_trials + 1 != trials {
            continue;
        }
        let same = |other: &&mut (Job, &Outcome)| {
            (&other.0.candidate, other.0.held_out) == (&job.candidate, job.held_out)
        };
        match best.iter_mut().find(same) {
            Some(other) if outcome.is_better_seed(other.1) => *other = (job.clone(), outcome),
            Some(_) => {}
            None => best.push((job.clone(), outcome)),
        }
    }
    Ok(best.into_iter().map(|(job, outcome)| (job, outcome.seconds)).collect())
}

/// The settings of a model of the library. A study shows no rivals.
fn settings(job: &Job) -> Result<&Settings, String> {
    let kind = job.candidate.kind().id();
    job.candidate.settings().ok_or_else(|| format!("expected a model of the library, found {kind}"))
}

type Prediction = (Vec<f32>, Outcome);

/// Trains every candidate again and predicts the trial held out: joint positions, and the outcome.
fn predictions(
    jobs: &[(Job, f64)],
    folds: &[Fold],
    arguments: &Arguments,
) -> Result<Vec<(Job, Prediction)>, Box<dyn Error>> {
    let task = Task::new("about")?;
    let seconds: f64 = jobs.iter().map(|(_, seconds)| seconds).sum();
    let message = |done: usize| format!("{done} of {} trainings, which took {seconds:.0} s", jobs.len());
    task.show(0.0, || message(0));
    let (next, done) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = arguments.threads.map_or(cores, usize::from).min(jobs.len());
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    let Some((job, _)) = jobs.get(place) else { return };
                    let Some(fold) = folds.get(job.held_out) else { return };
                    let made = predict(fold, job, &|| task.is_stopped());
                    let mut done = done.lock().unwrap_or_else(PoisonError::into_inner);
                    done.insert(place, made);
                    task.show(done.len() as f64 / jobs.len() as f64, || message(done.len()));
                }
            });
        }
    });
    task.finish();
    let done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    let predictions = done.into_iter().map(|(place, made)| {
        let job = &jobs[place].0;
        made.map(|made| (job.clone(), made)).map_err(|reason| format!("{job}: {reason}").into())
    });
    predictions.collect()
}

fn predict(fold: &Fold, job: &Job, stopped: &dyn Fn() -> bool) -> Result<Prediction, String> {
    let text = |error: &dyn Error| error.to_string();
    let mut learner = fold.learner(settings(job)?, job.seed).map_err(|error| text(&error))?;
    while !learner.step().done {
        if stopped() {
            return Err("stopped".to_owned());
        }
    }
    let model = learner.model().map_err(|error| text(&error))?;
    let outcome = fold.outcome(&model, &learner.progress(), 0.0).map_err(|error| text(&error))?;
    let columns = fold.predict(&model).map_err(|error| text(&error))?;
    Ok((fold.body().positions(&columns).map_err(|error| text(&error))?, outcome))
}
