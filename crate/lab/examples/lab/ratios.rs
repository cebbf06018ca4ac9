//! Ratios of errors over units: trials, persons, or sets of trials.

use crate::seeds::read_clips;
use std::path::PathBuf;
use vcgpdm::motion::{Clip, samples};
use vcgpdm_lab::evaluation::Effect;

/// The ratio of the errors `a` and `b` of each unit, with its interval, and in how many units it is below 1.
pub fn ratio(a: &[f64], b: &[f64]) -> String {
    let errors = |all: &[f64]| all.iter().copied().enumerate().collect();
    let Effect { mean, mean_interval, wins, folds, .. } = Effect::new(&errors(a), &errors(b)).unwrap();
    let interval = mean_interval.map_or(String::new(), |interval| format!(" ({interval})"));
    format!("{mean:.2} times{interval}, lower in {wins} of {folds}")
}

/// The name and the trials of each person; without a folder, the sample walks.
pub fn persons(folders: &[PathBuf]) -> impl Iterator<Item = (String, Vec<Clip>)> {
    let walks = || {
        let walks = samples::list().into_iter().filter(|info| info.movement == "walk");
        ("made walks".to_owned(), walks.map(|info| samples::clip(info.id).unwrap()).collect())
    };
    folders.is_empty().then(walks).into_iter().chain(folders.iter().map(|folder| {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        (name, read_clips(std::slice::from_ref(folder)).collect())
    }))
}
