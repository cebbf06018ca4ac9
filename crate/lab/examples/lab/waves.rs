//! Walking with and without waving, of thirty-two made trials each (docs/comparison.md): sets of four, in which each
//! trial is held out once. The set is the unit. Both movements have the same seeds.

use crate::parallel::each_seed;
use crate::ratios::ratio;
use clap::Args;
use vcgpdm::models::{DmpSettings, Settings, TmpSettings, VariationalSettings};
use vcgpdm::motion::{Clip, parts, samples};
use vcgpdm_lab::evaluation::{Fold, START_FRAMES, dtw_mse, stats};

/// Trials of a set, and their seconds.
const TRIALS: u32 = 4;
const SECONDS: f64 = 4.0;
/// The sample clips have lower seeds.
const FIRST_SEED: u64 = 1000;
const MOVEMENTS: [&str; 2] = ["walk", "walk and wave"];
/// What is compared with what: places in [`models`].
const COMPARED: [(usize, usize); 5] = [(0, 1), (0, 2), (0, 3), (0, 4), (0, 6)];

#[derive(Args)]
pub struct Arguments {
    /// Sets of four trials of each movement.
    #[arg(long, default_value_t = 8)]
    sets: u32,
    /// Most iterations of the variational models.
    #[arg(long, default_value_t = 3000)]
    iterations: usize,
    /// Sets at a time.
    #[arg(long, default_value_t = 1)]
    threads: usize,
}

fn models(iterations: usize) -> Vec<(&'static str, Settings)> {
    let ours = VariationalSettings::default().with_max_iterations(iterations);
    let ours = |points| ours.clone().with_points(points, points);
    let bases = DmpSettings { bases: 25 };
    vec![
        ("vCGPDM", Settings::Vcgpdm(ours(10))),
        ("vGPDM", Settings::Vgpdm(ours(10))),
        ("vGPDM, as large as both parts", Settings::Vgpdm(ours(20).with_latent(6))),
        ("vCGPDM without couplings", Settings::Vcgpdm(ours(10).with_uncoupled(true))),
        ("TMP", Settings::Tmp(TmpSettings::default())),
        ("DMP, discrete", Settings::DmpDiscrete(bases.clone())),
        ("DMP, rhythmic", Settings::DmpRhythmic(bases)),
    ]
}

/// By movement and model: the mean logarithm of the errors of a set.
type SetErrors = [Vec<f64>; 2];

pub fn run(arguments: &Arguments) {
    let models = models(arguments.iterations);
    let sets = each_seed(0..arguments.sets, arguments.threads, |set| {
        let errors = MOVEMENTS.map(|movement| errors(movement, set, &models));
        eprintln!("set {}", set + 1);
        errors
    });
    let of = |movement: usize, model: usize| -> Vec<f64> {
        sets.iter().map(|set: &SetErrors| set[movement][model].exp()).collect()
    };
    let over = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a / b).collect::<Vec<_>>();
    println!("| errors | walks | walks with waving | waving : not waving |\n{}|", "|---".repeat(4));
    for (a, b) in COMPARED {
        let cells = [0, 1].map(|movement| ratio(&of(movement, a), &of(movement, b)));
        let both = ratio(&over(&of(1, a), &of(1, b)), &over(&of(0, a), &of(0, b)));
        println!("| {} : {} | {} | {} | {both} |", models[a].0, models[b].0, cells[0], cells[1]);
    }
    println!(
        "\n| model | walks, error x 1000 | walks with waving | walks : walks with waving |\n{}|",
        "|---".repeat(4)
    );
    for (model, (name, _)) in models.iter().enumerate() {
        let [walks, waves] = [0, 1].map(|movement| of(movement, model));
        let thousand = |errors: &[f64]| 1000.0 * stats::mean(errors);
        println!(
            "| {name} | {:.2} | {:.2} | {} |",
            thousand(&walks),
            thousand(&waves),
            ratio(&walks, &waves)
        );
    }
}

/// The errors of all models in a set of trials.
fn errors(movement: &str, set: u32, models: &[(&str, Settings)]) -> Vec<f64> {
    let seed = |trial| FIRST_SEED + u64::from(set * TRIALS + trial);
    let clips: Vec<Clip> =
        (0..TRIALS).map(|trial| samples::trial(movement, seed(trial), SECONDS).unwrap()).collect();
    let presets = parts::presets(&clips[0].skeleton);
    let parts = &presets.iter().find(|preset| preset.id == "lower-upper").unwrap().parts;
    let folds: Vec<Fold> = (0..clips.len())
        .map(|trial| Fold::new(&clips, trial, clips.len() - 1, parts, 30.0, START_FRAMES).unwrap())
        .collect();
    let mean_error = |(_, settings): &(&str, Settings)| {
        let errors = folds.iter().map(|fold| {
            let mut learner = fold.learner(settings, 0).unwrap();
            while !learner.step().done {}
            let predicted = fold.predict(&learner.model().unwrap()).unwrap();
            dtw_mse(&predicted, fold.actual()).unwrap().dtw_mse.ln()
        });
        stats::mean(&errors.collect::<Vec<_>>())
    };
    models.iter().map(mean_error).collect()
}
