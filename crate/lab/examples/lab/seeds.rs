//! How many seeds lead to a model that keeps moving (docs/training.md), and what the page says about each
//! (docs/couplings.md). Each clip is trained on alone, with several splits of the body and several sizes.
//! Bounds are smallest / middle / largest of the seeds. The poses visited are those of the part that visits
//! least, for each seed, in per cent of its clip's frames. A last table adds up clips of similar length.

use crate::parallel::each_seed;
use clap::Args;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm_core::models::{
    Dataset, Ending, Health, PoseWeight, RolloutRequest, Source, Trainer, VariationalSettings, best_to_show,
};
use vcgpdm_core::motion::{Clip, bvh, parts, samples};
use vcgpdm_lab::evaluation::TrainingTrials;

const FRAMES_PER_SECOND: f64 = 30.0;

/// The page trains from this many seeds and shows the best of them.
const GROUP: usize = 4;

/// The last table has a row for clips shorter than each of these seconds, and one for all longer clips.
const LENGTHS: [f64; 3] = [4.0, 8.0, 12.0];

#[derive(Args)]
pub struct Arguments {
    /// BVH files, or folders of them; absent: the first sample walk.
    clips: Vec<PathBuf>,
    /// Trains on the first seconds of each clip only.
    #[arg(long)]
    seconds: Option<f64>,
    /// Seeds, from 0.
    #[arg(long, default_value_t = 10)]
    seeds: u32,
    /// Inducing points of every dynamics map, and of every pose map; 0: as many as the library gives the clip.
    #[arg(long, value_delimiter = ',', default_values_t = [12, 20, 30])]
    points: Vec<usize>,
    /// Presets of parts.
    #[arg(long, value_delimiter = ',', default_values_t = ["whole", "lower-upper", "legs-trunk-arms"].map(str::to_owned))]
    parts: Vec<String>,
    /// Weights of the pose terms in the objective: numbers, or "balanced".
    #[arg(long, value_delimiter = ',', default_value = "1", value_parser = pose_weight)]
    pose_weights: Vec<PoseWeight>,
    /// Most iterations.
    #[arg(long, default_value_t = 600)]
    iterations: usize,
    /// Let the dynamics learn from rollouts of the model after the training.
    #[arg(long)]
    own_rollouts: bool,
    /// Frames of a rollout.
    #[arg(long, default_value_t = 300)]
    frames: usize,
    /// Trainings at a time.
    #[arg(long, default_value_t = 1)]
    threads: usize,
}

/// How one training ended.
struct Run {
    bound: f64,
    /// The error of rollouts on the clip, infinite if unknown.
    error: f64,
    seconds: f64,
    health: Health,
}

impl Run {
    /// The smallest share of its clip's poses that a part visits, in per cent.
    fn visited(&self) -> f64 {
        let shares = self.health.parts.iter().filter_map(|part| part.visited);
        100.0 * shares.fold(1.0, f64::min)
    }
}

/// The trainings of one clip with the same settings.
struct Trainings {
    seconds: f64,
    points: usize,
    runs: Vec<Run>,
    /// The error of the seed in the middle, relative to that with the first number of points.
    relative_error: f64,
}

impl Trainings {
    fn moving(&self) -> usize {
        self.runs.iter().filter(|run| run.health.is_good()).count()
    }

    /// How many groups of seeds there are, and how many of their models that the page would show keep moving.
    fn chosen(&self) -> (usize, usize) {
        let groups: Vec<&[Run]> = self.runs.chunks_exact(GROUP).collect();
        let is_good = |group: &&&[Run]| {
            let best = best_to_show(group.iter().map(|run| (run.health.rank, run.error)));
            best.is_some_and(|place| group[place].health.is_good())
        };
        (groups.iter().filter(is_good).count(), groups.len())
    }

    fn mean_seconds(&self) -> f64 {
        self.runs.iter().map(|run| run.seconds).sum::<f64>() / self.runs.len() as f64
    }
}

pub fn run(arguments: &Arguments) {
    println!(
        "| clip | s | parts | points | weight of the poses | seeds that keep moving | one pose | few poses | shake | poses visited, % | chosen of {GROUP} seeds | error on the clip | bound | within 0.5 % of the best | s of a training |"
    );
    println!("{}|", "|---".repeat(15));
    let mut clips: Vec<Clip> = read_clips(&arguments.clips).collect();
    if clips.is_empty() {
        clips.push(samples::clip("walk-1").unwrap());
    }
    let mut all: Vec<Trainings> = Vec::new();
    for clip in &clips {
        let most = arguments.seconds.map_or(clip.frames(), |seconds| (seconds / clip.frame_time) as usize);
        let clip = &clip.cut(0, most.min(clip.frames())).unwrap();
        let seconds = clip.frames() as f64 * clip.frame_time;
        let presets = parts::presets(&clip.skeleton);
        for preset in arguments.parts.iter().filter_map(|id| presets.iter().find(|preset| preset.id == *id)) {
            let source = Source { clip, first_frames: None };
            let dataset = Dataset::new(&[source], &preset.parts, FRAMES_PER_SECOND).unwrap();
            for &pose_weight in &arguments.pose_weights {
                let mut first_error = None;
                for &points in &arguments.points {
                    let usual = VariationalSettings::for_clips(seconds);
                    let number = |usual| if points == 0 { usual } else { points };
                    let settings = VariationalSettings {
                        dynamics_ips: number(usual.dynamics_ips),
                        pose_ips: number(usual.pose_ips),
                        max_iterations: arguments.iterations,
                        pose_weight,
                        ..VariationalSettings::default()
                    };
                    let train = |seed| train(&settings, arguments, &dataset, seed);
                    let runs = each_seed(0..arguments.seeds, arguments.threads, train);
                    let weight = match pose_weight {
                        PoseWeight::Fixed(weight) => weight.to_string(),
                        PoseWeight::Balanced => "balanced".to_owned(),
                    };
                    let error = middle(runs.iter().map(|run| run.error));
                    let relative_error = error / *first_error.get_or_insert(error);
                    let trainings = Trainings { seconds, points, runs, relative_error };
                    let title = format!("{} | {seconds:.1} | {} | {points} | {weight}", clip.name, preset.id);
                    print(&title, &trainings);
                    all.push(trainings);
                }
            }
        }
    }
    print_lengths(&all, &arguments.points);
}

fn middle(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = numbers.into_iter().collect();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

/// Adds up the trainings of clips of similar length.
fn print_lengths(all: &[Trainings], points: &[usize]) {
    println!(
        "\n| clips | points | models that keep moving | chosen of {GROUP} seeds | error on the clip, relative to {} points | s of a training |",
        points[0]
    );
    println!("{}|", "|---".repeat(6));
    let class = |seconds: f64| LENGTHS.iter().filter(|length| seconds >= **length).count();
    for place in 0..=LENGTHS.len() {
        for &points in points {
            let alike = |one: &&Trainings| one.points == points && class(one.seconds) == place;
            let group: Vec<&Trainings> = all.iter().filter(alike).collect();
            if group.is_empty() {
                continue;
            }
            let length = match (place.checked_sub(1).map(|lower| LENGTHS[lower]), LENGTHS.get(place)) {
                (None, Some(upper)) => format!("shorter than {upper} s"),
                (Some(lower), Some(upper)) => format!("{lower} to {upper} s"),
                (lower, None) => format!("{} s or longer", lower.unwrap_or(0.0)),
            };
            let moving: usize = group.iter().map(|one| one.moving()).sum();
            let models: usize = group.iter().map(|one| one.runs.len()).sum();
            let chosen: Vec<(usize, usize)> = group.iter().map(|one| one.chosen()).collect();
            println!(
                "| {}, {length} | {points} | {moving} of {models} | {} of {} | {:.2} | {:.1} |",
                group.len(),
                chosen.iter().map(|(moving, _)| moving).sum::<usize>(),
                chosen.iter().map(|(_, groups)| groups).sum::<usize>(),
                middle(group.iter().map(|one| one.relative_error)),
                group.iter().map(|one| one.mean_seconds()).sum::<f64>() / group.len() as f64,
            );
        }
    }
}

/// Reads a weight as files have it.
fn pose_weight(text: &str) -> Result<PoseWeight, serde_json::Error> {
    let value = text.parse::<f64>().map_or_else(|_| text.into(), serde_json::Value::from);
    serde_json::from_value(value)
}

fn train(settings: &VariationalSettings, arguments: &Arguments, dataset: &Dataset, seed: u32) -> Run {
    let begin = Instant::now();
    let mut trainer = Trainer::new(dataset, &settings.clone().into(), seed).unwrap();
    trainer.run();
    let mut model = trainer.finish().unwrap();
    if arguments.own_rollouts {
        model.learn_from_own_rollouts();
    }
    let seconds = begin.elapsed().as_secs_f64();
    let error = TrainingTrials::new(dataset).error(&model.fitted).unwrap_or(f64::INFINITY);
    let request = RolloutRequest { frames: arguments.frames, ..Default::default() };
    let model = model.coupled().unwrap();
    let rollout = model.rollout(&request).unwrap();
    let positions = model.positions(&rollout).unwrap();
    let health = model.health(&rollout, &request, &positions).unwrap();
    Run { bound: model.model.bound(), error, seconds, health }
}

fn print(title: &str, trainings: &Trainings) {
    let runs = &trainings.runs;
    let endings: Vec<String> =
        runs.iter().map(|run| format!("{} ({:.0})", health_text(&run.health), run.bound)).collect();
    eprintln!("{title}: {}", endings.join(", "));
    let ending = |states: &[Ending]| runs.iter().filter(|run| states.contains(&run.health.state)).count();
    let one_pose = ending(&[Ending::StandsStill, Ending::KeepsOnePose]);
    let few_poses = ending(&[Ending::VisitsFewPoses]);
    let shake = ending(&[Ending::Shakes]);
    let visited: Vec<String> = runs.iter().map(|run| format!("{:.0}", run.visited())).collect();
    let (chosen, groups) = trainings.chosen();
    let mut bounds: Vec<f64> = runs.iter().map(|run| run.bound).collect();
    bounds.sort_by(f64::total_cmp);
    let (low, middle_bound, high) = (bounds[0], bounds[bounds.len() / 2], bounds[bounds.len() - 1]);
    let near = bounds.iter().filter(|bound| **bound >= high - 0.005 * high.abs()).count();
    println!(
        "| {title} | {} of {} | {one_pose} | {few_poses} | {shake} | {} | {chosen} of {groups} | {:.5} | {low:.0} / {middle_bound:.0} / {high:.0} | {near} | {:.1} |",
        trainings.moving(),
        runs.len(),
        visited.join(" "),
        middle(runs.iter().map(|run| run.error)),
        trainings.mean_seconds(),
    );
}

/// Reads files, and the BVH files of folders in the order of their names. A clip is read when the iterator
/// reaches it.
pub fn read_clips(paths: &[PathBuf]) -> impl Iterator<Item = Clip> {
    let files = paths.iter().flat_map(|path| {
        if !path.is_dir() {
            return vec![path.clone()];
        }
        let entries = std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path());
        let mut files: Vec<PathBuf> =
            entries.filter(|file| file.extension().is_some_and(|ending| ending == "bvh")).collect();
        files.sort();
        files
    });
    let read = |file: PathBuf| {
        let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        bvh::read(&name, &std::fs::read(&file).unwrap()).unwrap().into_clip()
    };
    files.map(read)
}

/// The ending of a rollout as text.
fn health_text(health: &Health) -> String {
    let from = health.from.unwrap_or(0.0);
    match health.state {
        Ending::MovesOn => "moves on".to_owned(),
        Ending::VisitsFewPoses => {
            let share = health.part.and_then(|part| health.parts[part].visited).unwrap_or(0.0);
            format!("visits {:.0} % of the poses", 100.0 * share)
        }
        Ending::StandsStill | Ending::RestsAsRecorded => format!("stands still from {from:.1} s"),
        Ending::KeepsOnePose => format!("keeps one pose from {from:.1} s"),
        Ending::LeavesTrainingRange => format!("leaves the training range from {from:.1} s"),
        Ending::Shakes => "shakes".to_owned(),
        Ending::NotFinite => "not finite".to_owned(),
    }
}
