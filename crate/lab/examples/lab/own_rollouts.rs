//! Models whose dynamics learned from their own rollouts, compared with the same models before
//! (docs/training.md).
//!
//! Each folder has the clips (.bvh) of one movement of one person. Each trial is held out in turn.

use crate::clips::{FolderTrainings, read_clips};
use crate::parallel::each_seed;
use crate::ratio::{ERRORS, over_folders, over_trials};
use vcgpdm::models::{FittedModel, Model, RolloutRequest, Settings, VariationalSettings};
use vcgpdm::motion::Clip;
use vcgpdm::motion::parts::presets;
use vcgpdm_lab::evaluation::{Fold, Outcome, START_FRAMES};

const FRAMES_PER_SECOND: f64 = 30.0;
/// Frames of a rollout, 20 s.
const FRAMES: usize = 600;

#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    trainings: FolderTrainings,
    /// A preset of parts of which there are two.
    #[arg(long, default_value = "lower-upper")]
    parts: String,
}

/// The same training before and after learning from its rollouts.
struct Pair {
    outcomes: [Outcome; 2],
    moves_on: [bool; 2],
}

/// A model as `vcgpdm train` makes it, and before it learned from its rollouts.
fn pair(fold: &Fold, seed: u32) -> Pair {
    let movements = fold.movements();
    let longest = movements.lengths().into_iter().max().unwrap_or(0);
    let seconds = longest as f64 / FRAMES_PER_SECOND;
    let settings = Settings::Vcgpdm(VariationalSettings::for_clips(seconds));
    let mut learner = fold.learner(&settings, seed).unwrap();
    while !learner.step().done {}
    let progress = learner.progress();
    let mut model = fold.model(learner.model().unwrap(), &settings, seed, &progress).unwrap();
    let outcome = |fitted: &FittedModel| fold.outcome(fitted, &progress, 0.0).unwrap();
    let before = (outcome(&model.fitted), moves_on(&model));
    model.learn_from_own_rollouts();
    let after = (outcome(&model.fitted), moves_on(&model));
    Pair { outcomes: [before.0, after.0], moves_on: [before.1, after.1] }
}

/// Whether the rollout from the held-out trial's first frames moves on.
fn moves_on(model: &Model) -> bool {
    let sequence = model.body.sequences.len() - 1;
    let request = RolloutRequest { frames: FRAMES, sequence, ..RolloutRequest::default() };
    let coupled = model.coupled().unwrap();
    let rollout = coupled.rollout(&request).unwrap();
    coupled
        .positions(&rollout)
        .is_ok_and(|positions| coupled.health(&rollout, &request, &positions).unwrap().is_good())
}

pub fn run(Arguments { trainings: FolderTrainings { folders, seeds, threads }, parts }: &Arguments) {
    println!("{seeds} seeds. Ratios: after : before.\n");
    println!(
        "| trials | {} | models that move on, before | after |",
        ERRORS.map(|(name, _)| name).join(" | ")
    );
    println!("{}|", "|---".repeat(3 + ERRORS.len()));
    let mut all: Vec<[Vec<Vec<Outcome>>; 2]> = Vec::new();
    let mut moving = Vec::new();
    for folder in folders {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let trials: Vec<Clip> = read_clips(std::slice::from_ref(folder)).collect();
        let presets = presets(&trials[0].skeleton);
        let parts = &presets.iter().find(|preset| preset.id == *parts).unwrap().parts;
        let (mut before, mut after, mut moves) = (Vec::new(), Vec::new(), [0, 0]);
        for held_out in 0..trials.len() {
            eprintln!("{name}: trial {} of {} held out", held_out + 1, trials.len());
            let most = trials.len() - 1;
            let fold = Fold::new(&trials, held_out, most, parts, FRAMES_PER_SECOND, START_FRAMES).unwrap();
            let pairs = each_seed(0..*seeds, *threads, |seed| pair(&fold, seed));
            let (mut first, mut second) = (Vec::new(), Vec::new());
            for Pair { outcomes: [a, b], moves_on } in pairs {
                first.push(a);
                second.push(b);
                moves.iter_mut().zip(moves_on).for_each(|(count, moves_on)| *count += usize::from(moves_on));
            }
            before.push(first);
            after.push(second);
        }
        let cells = ERRORS.map(|(_, error)| over_trials(&after, &before, error));
        let ([first, second], models) = (moves, trials.len() * *seeds as usize);
        println!("| {name} | {} | {first} of {models} | {second} |", cells.join(" | "));
        all.push([after, before]);
        moving.push([first, second, models]);
    }
    let folders: Vec<_> = all.iter().map(|[after, before]| (&after[..], &before[..])).collect();
    let cells = ERRORS.map(|(_, error)| over_folders(&folders, error));
    let sum = |place: usize| moving.iter().map(|moves| moves[place]).sum::<usize>();
    println!("| all folders | {} | {} of {} | {} |", cells.join(" | "), sum(0), sum(2), sum(1));
}
