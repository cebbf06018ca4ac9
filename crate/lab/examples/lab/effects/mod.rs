//! How each coupling changes the movement of the body (docs/couplings.md).
//!
//! Without clips: the first model of the page, its presets, and models of the sample walks. With clips:
//! models of the lower and upper body, one for each seed, and all couplings of the model with the highest
//! bound.
mod presets;
mod sweep;

use crate::clips::read_clips;
use crate::models::{self, lower_upper, train};
use clap::Args;
use std::path::PathBuf;
pub use sweep::health_text;
use sweep::{Learned, scale};
use vcgpdm::Model;
use vcgpdm::models::Reading;
use vcgpdm::motion::Clip;

#[derive(Args)]
pub struct Arguments {
    /// BVH files, or folders of them.
    clips: Vec<PathBuf>,
    #[arg(long, value_delimiter = ',', default_value = "1")]
    seeds: Vec<u32>,
    #[arg(long, default_value_t = 2000)]
    max_iterations: usize,
}

pub fn run(arguments: &Arguments) {
    if arguments.clips.is_empty() {
        let start = models::start();
        println!("### The model that the page opens with\n");
        sweep::print(start.coupled().unwrap());
        println!("### Its presets\n");
        presets::print(start.coupled().unwrap());
        for (title, model) in models::sample_models() {
            println!("### {title}\n");
            sweep::print(model.coupled().unwrap());
        }
        return;
    }
    let clips: Vec<Clip> = read_clips(&arguments.clips).collect();
    let models: Vec<(u32, Model)> = (arguments.seeds.iter())
        .map(|&seed| {
            eprintln!("seed {seed}");
            (seed, train(&clips, &lower_upper(&clips[0]), seed, arguments.max_iterations))
        })
        .collect();
    println!("### With the legs cut off from the arms\n");
    println!("Lower to upper times 100, re-inferred. {} clips, seeds {:?}.\n", clips.len(), arguments.seeds);
    println!("| seed | bound | hands swing | feet swing | in step | period of hands, s | of feet, s |");
    println!("{}|", "|---".repeat(7));
    for (seed, model) in &models {
        let model = model.coupled().unwrap();
        let learned = Learned::new(model);
        let alpha = scale(&model.model.alpha, &[(0, 1, 100.0)]);
        let cut = learned.effect(model, alpha, Reading::ReInferred);
        let [hands, feet] = cut.periods().map(sweep::number);
        println!(
            "| {seed} | {:.0} | {:.2} | {:.2} | {} | {hands} | {feet} |",
            model.model.bound(),
            cut.hands,
            cut.feet,
            sweep::number(cut.locking),
        );
    }
    println!();
    let best = models.iter().max_by(|a, b| a.1.fitted.bound().partial_cmp(&b.1.fitted.bound()).unwrap());
    if let Some((seed, model)) = best {
        println!("### The highest bound: seed {seed}\n");
        sweep::print(model.coupled().unwrap());
    }
}
