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
    Dataset, Ending, Health, RolloutRequest, Source, Trainer, VariationalSettings, best_to_show,
};
use vcgpdm::motion::{Clip, parts, samples};

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
        "| clip | parts | points | seeds that keep moving | one pose | few poses | poses visited, % | chosen of {GROUP} seeds | bound | within 0.5 % of the best | s |"
    );
    println!("{}|", "|---".repeat(11));
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
                let train = |seed| train(arguments, &dataset, points, seed);
                let runs = each_seed(0..arguments.seeds, arguments.threads, train);
                print(&format!("{} | {} | {points}", clip.name, preset.id), &runs);
            }
        }
    }
}

fn train(arguments: &Arguments, dataset: &Dataset, points: usize, seed: u32) -> Run {
    let settings = VariationalSettings {
        dynamics_ips: points,
        pose_ips: points,
        max_iterations: arguments.iterations,
        ..VariationalSettings::default()
    };
    let begin = Instant::now();
    let mut trainer = Trainer::new(dataset, &settings.into(), seed).unwrap();
    trainer.run();
    let seconds = begin.elapsed().as_secs_f64();
    let model = trainer.finish().unwrap();
    let request = RolloutRequest { frames: arguments.frames, ..Default::default() };
    let model = model.coupled().unwrap();
    let rollout = model.rollout(&request).unwrap();
    let positions = model.positions(&rollout).unwrap();
    let health = model.health(&rollout, &request, &positions).unwrap();
    Run { bound: model.model.bound(), seconds, health }
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
        let best = best_to_show(group.iter().map(|run| (run.health.rank, run.bound)));
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
