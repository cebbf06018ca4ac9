//! Time of one bound with its gradient, of a training and of a rollout: the native side of `npm run speed`.
//! Prints one JSON object:
//!
//! ```sh
//! cargo run --release -p vcgpdm-lab --example speed -- CASE.json [CLIP.bvh ...]
//! ```
//!
//! `vcgpdm train --write-start` writes the case, or another implementation. The training is on lower and
//! upper body of the clips, or of the bundled walks where no clip is named.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)]

use serde_json::{Value, json};
use std::hint::black_box;
use std::time::Instant;
use vcgpdm_core::models::variational::VariationalTrainer;
use vcgpdm_core::models::{Dataset, RolloutRequest, Source, VariationalSettings};
use vcgpdm_core::motion::{Clip, bvh, parts, samples};
use vcgpdm_lab::golden::Case;

fn evaluation(case: &Case) -> Value {
    let mut workspace = case.objective.workspace(&case.params);
    let mut times = Vec::new();
    for _ in 0..300 {
        let begin = Instant::now();
        case.objective.compute_with_gradient(black_box(&case.params), &mut workspace).unwrap();
        times.push(1e3 * begin.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    json!({ "bound": workspace.terms().total(), "median_ms": times[times.len() / 2] })
}

fn training(clips: &[Clip]) -> Value {
    let sources: Vec<Source> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let parts = parts::presets(&clips[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts;
    let dataset = Dataset::new(&sources, &parts, 30.0).unwrap();
    let begin = Instant::now();
    let mut trainer =
        VariationalTrainer::new(dataset.y.clone(), dataset.lengths(), &VariationalSettings::default(), 0)
            .unwrap();
    let mut trace = Vec::new();
    let last = loop {
        let progress = trainer.step();
        trace.push((begin.elapsed().as_secs_f64(), progress.best));
        if progress.done {
            break progress;
        }
    };
    let model = trainer.finish(&dataset).unwrap();
    let model = model.coupled().unwrap();
    let request = RolloutRequest { frames: 300, ..RolloutRequest::default() };
    let mut times = Vec::new();
    for _ in 0..200 {
        let begin = Instant::now();
        black_box(model.positions(&model.rollout(black_box(&request)).unwrap()).unwrap());
        times.push(1e3 * begin.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    let enough = last.best - 1e-3 * last.best.abs();
    let nearly = trace.iter().find(|(_, best)| *best >= enough).map(|(seconds, _)| seconds);
    json!({
        "frames": dataset.lengths().iter().sum::<usize>(),
        "bound": last.best,
        "iterations": last.iteration,
        "seconds": trace[trace.len() - 1].0,
        "seconds_to_999": nearly,
        "rollout_ms": times[times.len() / 2],
    })
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let case = arguments.next().expect("the first argument is a case's file");
    let case = Case::from_json(&std::fs::read_to_string(case).unwrap()).unwrap();
    let mut clips: Vec<Clip> =
        arguments.map(|file| bvh::read(&file, &std::fs::read(&file).unwrap()).unwrap().into_clip()).collect();
    if clips.is_empty() {
        clips = samples::list().iter().take(6).map(|sample| samples::clip(sample.id).unwrap()).collect();
    }
    println!("{}", json!({ "evaluation": evaluation(&case), "training": training(&clips) }));
}
