//! Prints, as Markdown, how the time of one bound with its gradient and the memory of a training grow with
//! frames, parts, inducing points and latent dimensions, beside what is estimated before a training begins:
//!
//! ```sh
//! cargo run --release --example scaling
//! ```
//!
//! The data are the bundled walks, one after the other as often as needed, a little different each time.
//! Every row is measured in a process of its own: a few iterations of a training, whose largest memory the
//! system tells (Linux; elsewhere it is left out).
#![allow(clippy::disallowed_methods, missing_docs, clippy::unwrap_used)]

#[path = "shared/long_walks.rs"]
mod long_walks;

use long_walks::{split, walks};
use nalgebra::DMatrix;
use std::process::Command;
use std::time::Instant;
use vcgpdm::models::variational::VariationalTrainer;
use vcgpdm::models::{MapSettings, Movements, Sequence, Settings, VariationalSettings};
use vcgpdm_lab::evaluation::stats::exponent;

/// Iterations enough for the optimiser to have filled its memory.
const ITERATIONS: usize = 40;

#[derive(Clone, Copy)]
struct Size {
    frames: usize,
    parts: usize,
    /// None: a MAP model.
    ips: Option<usize>,
    latent: usize,
}

const IPS: usize = 12;
const BASE: Size = Size { frames: 500, parts: 2, ips: Some(IPS), latent: 3 };

fn settings(latent: usize, ips: usize) -> VariationalSettings {
    let (dynamics_ips, pose_ips, max_iterations) = (ips, ips, ITERATIONS);
    VariationalSettings { latent, dynamics_ips, pose_ips, max_iterations, ..VariationalSettings::default() }
}

fn map_settings(latent: usize) -> Settings {
    Settings::MapCgpdm(MapSettings { latent, ..MapSettings::default() })
}

/// Milliseconds of one bound with its gradient.
fn measure(size: Size, ips: usize) -> f64 {
    let (y, lengths) = walks(size.frames);
    let settings = settings(size.latent, ips);
    let mut trainer = VariationalTrainer::new(split(&y, size.parts), lengths, &settings, 0).unwrap();
    while !trainer.step().done {}
    let (objective, params) = (trainer.objective().clone(), trainer.best());
    // Its memory is that of a training alone.
    drop(trainer);
    let mut workspace = objective.workspace(&params);
    let mut times = Vec::new();
    let begin = Instant::now();
    while times.len() < 5 || (begin.elapsed().as_secs_f64() < 1.0 && times.len() < 200) {
        let begin = Instant::now();
        objective.compute_with_gradient(&params, &mut workspace).unwrap();
        times.push(1e3 * begin.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Milliseconds of an iteration of a MAP CGPDM: of the density with its gradient, now and then twice.
fn measure_map(size: Size) -> f64 {
    let (y, lengths) = walks(size.frames);
    let sequences = lengths.into_iter().map(|frames| Sequence { frames, whole: true }).collect();
    let movements = Movements { y: split(&y, size.parts), sequences };
    let mut learner = map_settings(size.latent).learner(&movements, 0).unwrap();
    learner.step();
    let (begin, before) = (Instant::now(), learner.progress().iteration);
    while begin.elapsed().as_secs_f64() < 1.0 {
        learner.step();
    }
    1e3 * begin.elapsed().as_secs_f64() / (learner.progress().iteration - before) as f64
}

/// The largest memory of this process so far, in MB.
fn peak_memory() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<f64>().ok().map(|kb| kb / 1024.0)
}

/// Time in milliseconds and memory in MB, from a process of its own.
fn in_a_process(size: Size) -> (f64, Option<f64>) {
    let numbers = [size.frames, size.parts, size.ips.unwrap_or(0), size.latent].map(|n| n.to_string());
    let output = Command::new(std::env::current_exe().unwrap()).args(numbers).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut found = text.split_whitespace().map(|word| word.parse::<f64>().ok());
    (found.next().flatten().unwrap(), found.next().flatten())
}

/// Prints a table; gives the points (varied number, milliseconds).
fn table(title: &str, sizes: impl Iterator<Item = (usize, Size)>) -> Vec<(f64, f64)> {
    println!("| {title} | ms | estimated | largest memory, MB | estimated |\n|---|---|---|---|---|");
    let points = sizes.map(|(number, size)| {
        let (ms, memory) = in_a_process(size);
        let columns: Vec<usize> =
            split(&walks(size.frames).0, size.parts).iter().map(DMatrix::ncols).collect();
        let cost = match size.ips {
            Some(ips) => settings(size.latent, ips).cost(size.frames, &columns),
            None => map_settings(size.latent).cost(size.frames, &columns),
        };
        let (estimated, bytes) = (1e3 * cost.evaluation_seconds, cost.bytes / f64::from(1 << 20));
        let memory = memory.map_or(String::new(), |m| format!("{m:.0}"));
        println!("| {number} | {ms:.2} | {estimated:.2} | {memory} | {bytes:.0} |");
        (number as f64, ms)
    });
    let points = points.collect();
    println!();
    points
}

fn main() {
    let numbers: Vec<usize> = std::env::args().skip(1).map(|word| word.parse().unwrap()).collect();
    if let [frames, parts, ips, latent] = numbers[..] {
        let size = Size { frames, parts, ips: (ips > 0).then_some(ips), latent };
        let ms = size.ips.map_or_else(|| measure_map(size), |ips| measure(size, ips));
        println!("{ms} {}", peak_memory().map_or("-".to_owned(), |m| m.to_string()));
        return;
    }
    println!("{} parts, {IPS} + {IPS} inducing points:\n", BASE.parts);
    let frames = [250, 500, 1000, 2000, 4000, 8000, 16_000];
    let points = table("frames", frames.map(|frames| (frames, Size { frames, ..BASE })).into_iter());
    println!("Exponent in frames: {:.3}.\n", exponent(&points).unwrap());
    println!("{} frames, {IPS} + {IPS} inducing points:\n", BASE.frames);
    table("parts", (1..=5).map(|parts| (parts, Size { parts, ..BASE })));
    println!("{} frames, {} parts:\n", BASE.frames, BASE.parts);
    let ips = [8, 12, 16, 24, 32, 40, 80];
    table("inducing points", ips.map(|ips| (ips, Size { ips: Some(ips), ..BASE })).into_iter());
    println!("{} frames, {} parts, {IPS} + {IPS} inducing points:\n", BASE.frames, BASE.parts);
    table("latent dimensions", [2, 3, 4, 6, 8].map(|latent| (latent, Size { latent, ..BASE })).into_iter());
    let map = Size { ips: None, ..BASE };
    println!("MAP CGPDM, {} parts:\n", map.parts);
    let frames = [125, 250, 500, 1000, 2000];
    let points = table("frames", frames.map(|frames| (frames, Size { frames, ..map })).into_iter());
    println!("Exponent in frames: {:.3}.\n", exponent(&points).unwrap());
    println!("MAP CGPDM, {} frames:\n", map.frames);
    table("parts", (1..=3).map(|parts| (parts, Size { parts, ..map })));
}
