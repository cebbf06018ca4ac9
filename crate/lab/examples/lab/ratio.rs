//! The ratio of the errors of two models over the trials held out.

use vcgpdm_lab::evaluation::Outcome;
use vcgpdm_lab::evaluation::stats::{mean, median, median_interval};

/// The median ratio of the errors of `first` and `second`, its interval, and in how many trials it is below
/// 1. Both have the outcomes of every seed for each trial held out; errors are means over the seeds.
pub fn ratio(first: &[&Vec<Outcome>], second: &[&Vec<Outcome>], error: impl Fn(&Outcome) -> f64) -> String {
    let of_seeds = |outcomes: &Vec<Outcome>| mean(&outcomes.iter().map(&error).collect::<Vec<f64>>());
    let logarithm = |(a, b): (&&Vec<Outcome>, &&Vec<Outcome>)| (of_seeds(a) / of_seeds(b)).ln();
    let logarithms: Vec<f64> = first.iter().zip(second).map(logarithm).collect();
    let range = median_interval(&logarithms).map(|i| format!(" ({})", i.map(f64::exp)));
    let wins = logarithms.iter().filter(|ratio| **ratio < 0.0).count();
    format!("{:.2}{}, {wins} of {}", median(&logarithms).exp(), range.unwrap_or_default(), logarithms.len())
}
