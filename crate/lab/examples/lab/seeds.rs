//! How many seeds lead to a model that keeps moving (docs/training.md), and what the page says about each
//! (docs/couplings.md). Each clip is trained on alone, with several splits of the body and several sizes.
//! Bounds are smallest / middle / largest of the seeds. The poses visited are those of the part that visits
//! least, for each seed, in per cent of its clip's frames.

use crate::clips::read_clips;
use crate::effects::health_text;
use crate::parallel::each_seed;
use clap::Args;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm::models::{
    Dataset, Ending, Health, PoseWeight, RolloutRequest, Source, Trainer, VariationalSettings, best_to_show,
};
use vcgpdm::motion::{Clip, parts, samples};
use vcgpdm_lab::evaluation::TrainingTrials;

const FRAMES_PER_SECOND: f64 = 30.0;

/// The page trains from this many seeds and shows the best of them.
const GROUP: usize = 4;

#[derive(Args)]
pub struct Arguments {
    /// BVH files, or folders of them; absent: the first sample walk.
    clips: Vec<PathBuf>,
    /// Seeds, from 0.
    #[arg(long, default_value_t = 10)]
    seeds: u32,
    /// Inducing points of every dynamics map, and of every pose map.
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

pub fn run(arguments: &Arguments) {
    println!(
        "| clip | parts | points | weight of the poses | seeds that keep moving | one pose | few poses | poses visited, % | chosen of {GROUP} seeds | bound | within 0.5 % of the best | s |"
    );
    println!("{}|", "|---".repeat(12));
    let mut clips: Vec<Clip> = read_clips(&arguments.clips).collect();
    if clips.is_empty() {
        clips.push(samples::clip("walk-1").unwrap());
    }
    for clip in &clips {
        let presets = parts::presets(&clip.skeleton);
        for preset in arguments.parts.iter().filter_map(|id| presets.iter().find(|preset| preset.id == *id)) {
            let source = Source { clip, first_frames: None };
            let dataset = Dataset::new(&[source], &preset.parts, FRAMES_PER_SECOND).unwrap();
            for &points in &arguments.points {
                for &pose_weight in &arguments.pose_weights {
                    let settings = VariationalSettings {
                        dynamics_ips: points,
                        pose_ips: points,
                        max_iterations: arguments.iterations,
                        pose_weight,
                        ..VariationalSettings::default()
                    };
                    let train = |seed| train(&settings, arguments.frames, &dataset, seed);
                    let runs = each_seed(0..arguments.seeds, arguments.threads, train);
                    let weight = match pose_weight {
                        PoseWeight::Fixed(weight) => weight.to_string(),
                        PoseWeight::Balanced => "balanced".to_owned(),
                    };
                    print(&format!("{} | {} | {points} | {weight}", clip.name, preset.id), &runs);
                }
            }
        }
    }
}

/// Reads a weight as files have it.
fn pose_weight(text: &str) -> Result<PoseWeight, serde_json::Error> {
    let value = text.parse::<f64>().map_or_else(|_| text.into(), serde_json::Value::from);
    serde_json::from_value(value)
}

fn train(settings: &VariationalSettings, frames: usize, dataset: &Dataset, seed: u32) -> Run {
    let begin = Instant::now();
    let mut trainer = Trainer::new(dataset, &settings.clone().into(), seed).unwrap();
    trainer.run();
    let seconds = begin.elapsed().as_secs_f64();
    let model = trainer.finish().unwrap();
    let error = TrainingTrials::new(dataset).error(&model.fitted).unwrap_or(f64::INFINITY);
    let request = RolloutRequest { frames, ..Default::default() };
    let model = model.coupled().unwrap();
    let rollout = model.rollout(&request).unwrap();
    let positions = model.positions(&rollout).unwrap();
    let health = model.health(&rollout, &request, &positions).unwrap();
    Run { bound: model.model.bound(), error, seconds, health }
}

fn print(title: &str, runs: &[Run]) {
    let endings: Vec<String> =
        runs.iter().map(|run| format!("{} ({:.0})", health_text(&run.health), run.bound)).collect();
    eprintln!("{title}: {}", endings.join(", "));
    let moving = runs.iter().filter(|run| run.health.is_good()).count();
    let ending = |states: &[Ending]| runs.iter().filter(|run| states.contains(&run.health.state)).count();
    let one_pose = ending(&[Ending::StandsStill, Ending::KeepsOnePose]);
    let few_poses = ending(&[Ending::VisitsFewPoses]);
    let visited: Vec<String> = runs.iter().map(|run| format!("{:.0}", run.visited())).collect();
    let groups: Vec<&[Run]> = runs.chunks_exact(GROUP).collect();
    let chosen = groups.iter().filter(|group| {
        let best = best_to_show(group.iter().map(|run| (run.health.rank, run.error)));
        best.is_some_and(|place| group[place].health.is_good())
    });
    let chosen = chosen.count();
    let mut bounds: Vec<f64> = runs.iter().map(|run| run.bound).collect();
    bounds.sort_by(f64::total_cmp);
    let (low, middle, high) = (bounds[0], bounds[bounds.len() / 2], bounds[bounds.len() - 1]);
    let near = bounds.iter().filter(|bound| **bound >= high - 0.005 * high.abs()).count();
    let seconds = runs.iter().map(|run| run.seconds).sum::<f64>() / runs.len() as f64;
    println!(
        "| {title} | {moving} of {} | {one_pose} | {few_poses} | {} | {chosen} of {} | {low:.0} / {middle:.0} / {high:.0} | {near} | {seconds:.1} |",
        runs.len(),
        visited.join(" "),
        groups.len()
    );
}
