//! Whether the latents or the inducing points decide where a training ends:
//!
//! ```sh
//! cargo run --release --example redrawn -- CLIP.bvh ... [--seeds 20] [--points 12] [--parts whole,lower-upper] [--threads 2]
//! ```
//!
//! Trains on each clip alone, from several seeds. Then takes the trainings that ended lowest, in the middle
//! and highest, draws other inducing inputs from their latents, or takes nothing but their latents, and
//! trains once more. Without a clip the first bundled walk is used.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

#[path = "shared/alone.rs"]
mod alone;
#[path = "shared/seeds.rs"]
mod seeds;

use alone::{Alone, alone};
use clap::Parser;
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardUniform};
use seeds::{each_seed, near, range};
use std::path::PathBuf;
use vcgpdm::models::VariationalSettings;
use vcgpdm::models::variational::{Objective, Params, Trainer, schedule, starting_point};

#[derive(Parser)]
struct Arguments {
    /// BVH files, or folders of them; absent: a bundled walk.
    clips: Vec<PathBuf>,
    /// Seeds of the first trainings, and draws of inducing inputs afterwards, from 0.
    #[arg(long, default_value_t = 20)]
    seeds: u32,
    /// Inducing points, of the dynamics as of the poses.
    #[arg(long, default_value_t = 12)]
    points: usize,
    /// Presets of parts.
    #[arg(long, value_delimiter = ',', default_values_t = ["lower-upper", "whole"].map(str::to_owned))]
    parts: Vec<String>,
    /// So many trainings at a time.
    #[arg(long, default_value_t = 1)]
    threads: usize,
}

/// A clip and split of the body to train on.
struct Problem {
    objective: Objective,
    settings: VariationalSettings,
}

impl Problem {
    fn start(&self, seed: u32) -> Params {
        starting_point(self.objective.observations(), self.objective.sequences(), &self.settings, seed)
    }

    fn trained(&self, start: Params, seed: u32) -> (f64, Params) {
        let phases = schedule(self.settings.max_iterations);
        let mut trainer =
            Trainer::from_start(self.objective.clone(), start, phases, &self.settings, seed).unwrap();
        while !trainer.step().done {}
        (trainer.progress().best, trainer.best())
    }

    /// Where training starts, but with the latents of `trained`.
    fn with_latents_of(&self, trained: &Params, seed: u32) -> Params {
        let mut params = self.start(seed);
        for (part, trained) in params.parts.iter_mut().zip(&trained.parts) {
            part.latents = trained.latents.clone();
        }
        self.redrawn(params, seed)
    }

    /// The same with inducing inputs that are rows of its latents, drawn anew.
    fn redrawn(&self, mut params: Params, seed: u32) -> Params {
        let mut rng = ChaCha8Rng::seed_from_u64(u64::from(seed));
        for (part, experts) in params.parts.iter_mut().zip(&mut params.experts) {
            draw(&part.latents.mean, &mut part.r, &mut rng);
            let histories = self.objective.sequences().histories(&part.latents).mean;
            experts.iter_mut().for_each(|expert| draw(&histories, &mut expert.z, &mut rng));
        }
        params
    }
}

/// Different rows of `x`, drawn into all rows of `z`.
fn draw(x: &DMatrix<f64>, z: &mut DMatrix<f64>, rng: &mut ChaCha8Rng) {
    let mut rows: Vec<(f64, usize)> = (0..x.nrows()).map(|row| (StandardUniform.sample(rng), row)).collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (k, (_, row)) in rows.iter().take(z.nrows()).enumerate() {
        z.set_row(k, &x.row(*row));
    }
}

fn main() {
    let arguments = Arguments::parse();
    println!(
        "Bounds; numbers with slashes are smallest / middle / largest. As high: within 0.5 % of the highest, or above.\n"
    );
    println!(
        "| clip | parts | of the seeds | ended at | other inducing points | as high | nothing kept but the latents | as high |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for Alone { clip, preset, dataset } in alone(&arguments.clips, &arguments.parts) {
        let settings = VariationalSettings {
            dynamics_ips: arguments.points,
            pose_ips: arguments.points,
            ..VariationalSettings::default()
        };
        let trainer = Trainer::new(dataset.y.clone(), dataset.lengths(), &settings, 0).unwrap();
        let problem = Problem { objective: trainer.objective(), settings };
        let each =
            |run: &(dyn Fn(u32) -> (f64, Params) + Sync)| each_seed(arguments.seeds, arguments.threads, run);
        let mut first = each(&|seed| problem.trained(problem.start(seed), seed));
        first.sort_by(|a, b| a.0.total_cmp(&b.0));
        let highest = first.last().map_or(f64::NAN, |run| run.0);
        for (name, place) in
            [("lowest", 0), ("middle", first.len() / 2), ("highest", first.len().saturating_sub(1))]
        {
            let Some((bound, from)) = first.get(place) else { continue };
            let again = |begin: &(dyn Fn(u32) -> Params + Sync)| {
                let bounds: Vec<f64> =
                    each(&|seed| problem.trained(begin(seed), seed)).iter().map(|run| run.0).collect();
                format!(
                    "{} | {} of {}",
                    range(bounds.iter().copied(), 0),
                    near(bounds.iter().copied(), highest),
                    bounds.len()
                )
            };
            println!(
                "| {clip} | {preset} | {name} | {bound:.0} | {} | {} |",
                again(&|seed| problem.redrawn(from.clone(), seed)),
                again(&|seed| problem.with_latents_of(from, seed)),
            );
        }
    }
}
