//! The ratio of the errors of two models over the trials held out.

use vcgpdm_lab::evaluation::Outcome;
use vcgpdm_lab::evaluation::stats::{Interval, mean, mean_interval, median, median_interval};

/// An error of an outcome.
pub type ErrorOf = fn(&Outcome) -> f64;

/// The errors that are compared, with the titles of their columns. The body has two parts.
pub const ERRORS: [(&str, ErrorOf); 4] = [
    ("held out", |outcome| outcome.score.dtw_mse),
    ("lower body", |outcome| outcome.part_errors[0]),
    ("upper body", |outcome| outcome.part_errors[1]),
    ("on the training trials", |outcome| outcome.training_mse.unwrap_or(f64::NAN)),
];

/// The outcomes of a model for each trial held out, from every seed.
type OfTrials<'a> = &'a [Vec<Outcome>];

/// The logarithm of the ratio of two models' errors for each trial held out. Both have the outcomes of every
/// seed for each trial; errors are means over the seeds.
fn logarithms(first: OfTrials, second: OfTrials, error: ErrorOf) -> Vec<f64> {
    let of_seeds = |outcomes: &Vec<Outcome>| mean(&outcomes.iter().map(error).collect::<Vec<f64>>());
    first.iter().zip(second).map(|(first, second)| (of_seeds(first) / of_seeds(second)).ln()).collect()
}

/// The median ratio of the errors of `first` and `second`, its interval, and in how many trials it is below 1.
pub fn over_trials(first: OfTrials, second: OfTrials, error: ErrorOf) -> String {
    let logarithms = logarithms(first, second, error);
    cell(&logarithms, median(&logarithms), median_interval(&logarithms))
}

/// The mean ratio of the errors over folders, its interval, and in how many folders it is below 1. The ratio
/// of a folder is the mean over its trials. All means are geometric.
pub fn over_folders(folders: &[(OfTrials, OfTrials)], error: ErrorOf) -> String {
    let of_folder = |&(first, second): &(_, _)| mean(&logarithms(first, second, error));
    let logarithms: Vec<f64> = folders.iter().map(of_folder).collect();
    cell(&logarithms, mean(&logarithms), mean_interval(&logarithms))
}

fn cell(logarithms: &[f64], middle: f64, range: Option<Interval>) -> String {
    let range = range.map(|i| format!(" ({})", i.map(f64::exp)));
    let wins = logarithms.iter().filter(|ratio| **ratio < 0.0).count();
    format!("{:.2}{}, {wins} of {}", middle.exp(), range.unwrap_or_default(), logarithms.len())
}
