//! One run for each of many seeds, several at a time, and what is said of all of them.

use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};

/// The runs of the seeds from 0 on, seed by seed.
pub fn each_seed<Run: Send>(seeds: u32, threads: usize, run: impl Fn(u32) -> Run + Sync) -> Vec<Run> {
    let next = AtomicU32::new(0);
    let done = Mutex::new((0..seeds).map(|_| None).collect::<Vec<_>>());
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed >= seeds {
                        break;
                    }
                    let run = run(seed);
                    done.lock().unwrap()[seed as usize] = Some(run);
                }
            });
        }
    });
    done.into_inner().unwrap().into_iter().flatten().collect()
}

/// Smallest, middle and largest.
pub fn range(values: impl Iterator<Item = f64>, digits: usize) -> String {
    let mut sorted: Vec<f64> = values.collect();
    if sorted.is_empty() {
        return String::new();
    }
    sorted.sort_by(f64::total_cmp);
    let (low, high) = (sorted[0], sorted[sorted.len() - 1]);
    format!("{low:.digits$} / {:.digits$} / {high:.digits$}", sorted[sorted.len() / 2])
}

/// How many bounds are within 0.5 % of the best.
pub fn near(bounds: impl Iterator<Item = f64>, best: f64) -> usize {
    bounds.filter(|bound| *bound >= best - 0.005 * best.abs()).count()
}
