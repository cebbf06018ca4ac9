//! How the time of one bound with its gradient and the memory of a training grow with frames, parts, inducing
//! points and latent dimensions, next to the estimates before a training (docs/training.md).
//!
//! The data are the sample walks, repeated with small differences. Each row is measured in a process of its
//! own by a few iterations of a training; Linux tells the largest memory of a process.

use clap::Args;
use nalgebra::DMatrix;
use std::process::Command;
use std::time::Instant;
use vcgpdm_core::models::variational::VariationalTrainer;
use vcgpdm_core::models::{Dataset, MapSettings, Movements, Sequence, Settings, Source, VariationalSettings};
use vcgpdm_core::motion::{parts, samples};
use vcgpdm_lab::evaluation::stats::{exponent, median};

#[derive(Args)]
pub struct Arguments {
    /// Measures this size only: frames, parts, inducing points (0: a MAP CGPDM), latent dimensions.
    #[arg(long, value_delimiter = ',', num_args = 4)]
    size: Vec<usize>,
}

/// With this number of iterations the optimiser has all its memory.
const ITERATIONS: usize = 40;
const IPS: usize = 12;
const BASE: Size = Size { frames: 500, parts: 2, ips: Some(IPS), latent: 3 };

#[derive(Clone, Copy)]
struct Size {
    frames: usize,
    parts: usize,
    /// None: a MAP CGPDM.
    ips: Option<usize>,
    latent: usize,
}

impl Size {
    fn settings(&self) -> Settings {
        let Some(ips) = self.ips else {
            return Settings::MapCgpdm(MapSettings { latent: self.latent, ..MapSettings::default() });
        };
        Settings::Vcgpdm(VariationalSettings {
            latent: self.latent,
            dynamics_ips: ips,
            pose_ips: ips,
            max_iterations: ITERATIONS,
            ..VariationalSettings::default()
        })
    }

    /// Milliseconds of one bound with its gradient, or of one iteration of a MAP CGPDM.
    fn measure(&self) -> f64 {
        let (y, lengths) = walks(self.frames);
        let y = split(&y, self.parts);
        match self.settings() {
            Settings::Vcgpdm(settings) => measure_bound(y, lengths, &settings),
            settings => measure_map(y, &lengths, &settings),
        }
    }

    /// Milliseconds and megabytes, from a process of its own.
    fn measure_in_process(&self) -> (f64, Option<f64>) {
        let numbers = [self.frames, self.parts, self.ips.unwrap_or(0), self.latent];
        let size = numbers.map(|number| number.to_string()).join(",");
        let program = std::env::current_exe().unwrap();
        let output = Command::new(program).args(["scaling", "--size", &size]).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let mut numbers = text.split_whitespace().map(|word| word.parse::<f64>().ok());
        (numbers.next().flatten().unwrap(), numbers.next().flatten())
    }
}

fn measure_bound(y: Vec<DMatrix<f64>>, lengths: Vec<usize>, settings: &VariationalSettings) -> f64 {
    let mut trainer = VariationalTrainer::new(y, lengths, settings, 0).unwrap();
    while !trainer.step().done {}
    let (objective, params) = (trainer.objective().clone(), trainer.best());
    // The largest memory is that of the training alone.
    drop(trainer);
    let mut workspace = objective.workspace(&params);
    let mut times = Vec::new();
    let begin = Instant::now();
    while times.len() < 5 || (begin.elapsed().as_secs_f64() < 1.0 && times.len() < 200) {
        let begin = Instant::now();
        objective.compute_with_gradient(&params, &mut workspace).unwrap();
        times.push(1e3 * begin.elapsed().as_secs_f64());
    }
    median(&times)
}

fn measure_map(y: Vec<DMatrix<f64>>, lengths: &[usize], settings: &Settings) -> f64 {
    let sequences = lengths.iter().map(|&frames| Sequence { frames, whole: true }).collect();
    let mut learner = settings.learner(&Movements { y, sequences }, 0).unwrap();
    learner.step();
    let (begin, first) = (Instant::now(), learner.progress().iteration);
    while begin.elapsed().as_secs_f64() < 1.0 {
        learner.step();
    }
    1e3 * begin.elapsed().as_secs_f64() / (learner.progress().iteration - first) as f64
}

/// The largest memory of this process so far, in megabytes.
fn peak_memory() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<f64>().ok().map(|kilobytes| kilobytes / 1024.0)
}

/// Prints a table of one number that varies. Returns the pairs of this number and milliseconds.
fn print(title: &str, numbers: &[usize], size: impl Fn(usize) -> Size) -> Vec<(f64, f64)> {
    println!("| {title} | ms | estimated | largest memory, MB | estimated |\n|---|---|---|---|---|");
    let mut pairs = Vec::new();
    for &number in numbers {
        let size = size(number);
        let (ms, memory) = size.measure_in_process();
        let columns: Vec<usize> =
            split(&walks(size.frames).0, size.parts).iter().map(DMatrix::ncols).collect();
        let cost = size.settings().cost(size.frames, &columns);
        let (estimated, bytes) = (1e3 * cost.evaluation_seconds, cost.bytes / f64::from(1 << 20));
        let memory = memory.map_or(String::new(), |memory| format!("{memory:.0}"));
        println!("| {number} | {ms:.2} | {estimated:.2} | {memory} | {bytes:.0} |");
        pairs.push((number as f64, ms));
    }
    println!();
    pairs
}

pub fn run(arguments: &Arguments) {
    if let [frames, parts, ips, latent] = arguments.size[..] {
        let ms = Size { frames, parts, ips: (ips > 0).then_some(ips), latent }.measure();
        println!("{ms} {}", peak_memory().map_or("-".to_owned(), |memory| memory.to_string()));
        return;
    }
    println!("{} parts, {IPS} + {IPS} inducing points:\n", BASE.parts);
    let frames = [250, 500, 1000, 2000, 4000, 8000, 16_000];
    let pairs = print("frames", &frames, |frames| Size { frames, ..BASE });
    println!("Exponent in frames: {:.3}.\n", exponent(&pairs).unwrap());
    println!("{} frames, {IPS} + {IPS} inducing points:\n", BASE.frames);
    print("parts", &[1, 2, 3, 4, 5], |parts| Size { parts, ..BASE });
    println!("{} frames, {} parts:\n", BASE.frames, BASE.parts);
    print("inducing points", &[8, 12, 16, 24, 32, 40, 80], |ips| Size { ips: Some(ips), ..BASE });
    println!("{} frames, {} parts, {IPS} + {IPS} inducing points:\n", BASE.frames, BASE.parts);
    print("latent dimensions", &[2, 3, 4, 6, 8], |latent| Size { latent, ..BASE });
    let map = Size { ips: None, ..BASE };
    println!("MAP CGPDM, {} parts:\n", map.parts);
    let pairs = print("frames", &[125, 250, 500, 1000, 2000], |frames| Size { frames, ..map });
    println!("Exponent in frames: {:.3}.\n", exponent(&pairs).unwrap());
    println!("MAP CGPDM, {} frames:\n", map.frames);
    print("parts", &[1, 2, 3], |parts| Size { parts, ..map });
}

/// All columns of the sample walks, repeated to `frames` frames, and the lengths of the sequences.
fn walks(frames: usize) -> (DMatrix<f64>, Vec<usize>) {
    let clips: Vec<_> = samples::list().iter().take(6).map(|s| samples::clip(s.id).unwrap()).collect();
    let sources: Vec<Source> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let parts = parts::presets(&clips[0].skeleton).remove(0).parts;
    let dataset = Dataset::new(&sources, &parts, 30.0).unwrap();
    let (all, lengths) = (&dataset.y[0], dataset.lengths());
    let mut y = DMatrix::zeros(frames, all.ncols());
    let mut sequences = Vec::new();
    let mut at = 0;
    while at < frames {
        let round = sequences.len() / lengths.len();
        let k = sequences.len() % lengths.len();
        let first: usize = lengths[..k].iter().sum();
        let rest = frames - at;
        // The last sequence must be long enough for dynamics.
        let length = if rest < lengths[k] + 10 { rest.min(lengths[k]) } else { lengths[k] };
        let scale = 1.0 + 0.03 * (round as f64).sin();
        y.rows_mut(at, length).copy_from(&(all.rows(first, length) * scale));
        at += length;
        sequences.push(length);
    }
    (y, sequences)
}

/// The columns in `parts` groups of about the same size.
fn split(y: &DMatrix<f64>, parts: usize) -> Vec<DMatrix<f64>> {
    let begin = |part: usize| part * y.ncols() / parts;
    (0..parts).map(|part| y.columns(begin(part), begin(part + 1) - begin(part)).into_owned()).collect()
}
