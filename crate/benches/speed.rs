//! How long the things take that people wait for, on the project's own walk: two parts, Q = 3, 12 + 12 inducing points.
#![allow(missing_docs, clippy::unwrap_used)]

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use vcgpdm::{Dataset, MotionModel, RolloutRequest, Source, Trainer, TrainingSettings, presets, samples};

fn dataset() -> Dataset {
    let clips: Vec<_> = samples::list().iter().take(4).map(|s| samples::clip(s.id).unwrap()).collect();
    let parts = presets(&clips[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts;
    let sources: Vec<_> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    Dataset::new(&sources, &parts, 30.0).unwrap()
}

fn speed(criterion: &mut Criterion) {
    let dataset = dataset();
    let settings = TrainingSettings { max_iterations: 60, ..TrainingSettings::default() };
    let mut trainer = Trainer::new(dataset.y.clone(), dataset.lengths(), settings).unwrap();
    while !trainer.step().done {}
    let (objective, params) = (trainer.objective(), trainer.best());
    let frames: usize = dataset.lengths().iter().sum();
    criterion.bench_function(&format!("bound and gradient, {frames} frames"), |bench| {
        bench.iter(|| objective.terms_and_gradient(black_box(&params)).unwrap());
    });

    let model = MotionModel::trained(&dataset, &trainer, 30.0).unwrap();
    let request = RolloutRequest { frames: 300, ..RolloutRequest::default() };
    criterion.bench_function("rollout of 300 frames with figure positions", |bench| {
        bench.iter(|| model.positions(&model.rollout(black_box(&request)).unwrap()).unwrap());
    });
}

criterion_group!(benches, speed);
criterion_main!(benches);
