//! Times of the bound and of rollouts on the project's own walks, with three latent dimensions. `npm run lab
//! -- scaling` also measures memory, with up to 16,000 frames; `npm run speed` compares native and wasm.
#![allow(missing_docs, clippy::unwrap_used)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::DMatrix;
use std::hint::black_box;
use vcgpdm::models::variational::VariationalTrainer;
use vcgpdm::models::{Dataset, Reading, RolloutRequest, Source, VariationalSettings};
use vcgpdm::motion::{parts, samples};

fn dataset() -> Dataset {
    let clips: Vec<_> = samples::list().iter().take(4).map(|s| samples::clip(s.id).unwrap()).collect();
    let parts = parts::presets(&clips[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts;
    let sources: Vec<_> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    Dataset::new(&sources, &parts, 30.0).unwrap()
}

fn trained(y: Vec<DMatrix<f64>>, lengths: Vec<usize>, ips: usize) -> VariationalTrainer {
    let settings = VariationalSettings {
        dynamics_ips: ips,
        pose_ips: ips,
        max_iterations: 30,
        ..VariationalSettings::default()
    };
    let mut trainer = VariationalTrainer::new(y, lengths, &settings, 0).unwrap();
    while !trainer.step().done {}
    trainer
}

/// The walks of both parts, repeated `times` times.
fn repeated(dataset: &Dataset, times: usize) -> (Vec<DMatrix<f64>>, Vec<usize>) {
    let repeat =
        |y: &DMatrix<f64>| DMatrix::from_fn(y.nrows() * times, y.ncols(), |t, d| y[(t % y.nrows(), d)]);
    (dataset.y.iter().map(repeat).collect(), dataset.lengths().repeat(times))
}

/// The columns of both parts, divided into `parts` groups.
fn split(dataset: &Dataset, parts: usize) -> Vec<DMatrix<f64>> {
    let columns: Vec<_> = dataset.y.iter().flat_map(|y| y.column_iter()).collect();
    let place = |i: usize| i * columns.len() / parts;
    (0..parts).map(|i| DMatrix::from_columns(&columns[place(i)..place(i + 1)])).collect()
}

fn bound(criterion: &mut Criterion) {
    let dataset = dataset();
    let mut group = criterion.benchmark_group("bound with gradient");
    let mut add = |id: BenchmarkId, trainer: &VariationalTrainer| {
        let (objective, params) = (trainer.objective(), trainer.best());
        let mut workspace = objective.workspace(&params);
        group.throughput(Throughput::Elements(objective.sequences().frames() as u64));
        group.bench_function(id, |bench| {
            bench.iter(|| objective.compute_with_gradient(black_box(&params), &mut workspace).unwrap());
        });
    };
    for times in [1, 2, 4, 8] {
        let (y, lengths) = repeated(&dataset, times);
        add(BenchmarkId::new("frames", lengths.iter().sum::<usize>()), &trained(y, lengths, 12));
    }
    for parts in 1..=5 {
        add(BenchmarkId::new("parts", parts), &trained(split(&dataset, parts), dataset.lengths(), 12));
    }
    for ips in [8, 16, 20, 30, 40] {
        add(BenchmarkId::new("inducing points", ips), &trained(dataset.y.clone(), dataset.lengths(), ips));
    }
    group.finish();
}

fn rollout(criterion: &mut Criterion) {
    let dataset = dataset();
    let trainer = trained(dataset.y.clone(), dataset.lengths(), 12);
    let model = trainer.finish(&dataset).unwrap();
    let model = model.coupled().unwrap();
    let request = RolloutRequest { frames: 300, ..RolloutRequest::default() };
    let mut group = criterion.benchmark_group("rollout");
    group.throughput(Throughput::Elements(300));
    group.bench_function("300 frames with figure positions", |bench| {
        bench.iter(|| model.positions(&model.rollout(black_box(&request)).unwrap()).unwrap());
    });
    // The request of a moved slider: other couplings.
    let mut alpha = model.model.alpha.clone();
    alpha[(0, 1)] *= 2.0;
    for (id, reading) in [("as learned", Reading::AsLearned), ("re-inferred", Reading::ReInferred)] {
        let request = RolloutRequest { alpha: Some(alpha.clone()), reading, ..request.clone() };
        group.bench_function(BenchmarkId::new("300 frames under changed couplings", id), |bench| {
            bench.iter(|| model.rollout(black_box(&request)).unwrap());
        });
    }
    group.finish();
}

/// A frame of a recording that moves a model: predicted, then corrected by the columns of both parts.
fn observed(criterion: &mut Criterion) {
    let dataset = dataset();
    let model = trained(dataset.y.clone(), dataset.lengths(), 12).finish(&dataset).unwrap();
    let filter = model.coupled().unwrap().filter(&RolloutRequest::default()).unwrap();
    let first: Vec<_> = dataset.y.iter().map(|y| y.rows(0, 30).into_owned()).collect();
    let run = filter.run_from_best(&first, 15).unwrap();
    let row: Vec<Vec<f64>> = dataset.y.iter().map(|y| y.row(30).iter().copied().collect()).collect();
    let belief = run.beliefs.last().unwrap();
    criterion.bench_function("observed frame of both parts", |bench| {
        bench.iter(|| {
            let mut next = filter.predict(black_box(belief)).unwrap();
            filter.correct(&mut next, 0, &row).unwrap();
            next
        });
    });
}

criterion_group!(benches, bound, rollout, observed);
criterion_main!(benches);
