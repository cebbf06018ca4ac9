//! The tables of completing, as Markdown.

use crate::completing::results::{CompletedPart, Completing, Method, MethodScore};
use crate::evaluation::fixed;
use crate::evaluation::stats::median;
use std::fmt::Write;

/// Columns that the tables name: those with the lowest coverage.
const LOWEST: usize = 3;

/// The tables of these results, each with the name of its trials. Every number is a median over the trials
/// held out.
pub fn tables(all: &[(String, &Completing)]) -> String {
    let mut text = String::new();
    scores(&mut text, all);
    errors(&mut text, all);
    bands(&mut text, all);
    training(&mut text, all);
    text
}

/// The part `part` of all completed trials.
fn of_part(results: &Completing, part: usize) -> impl Iterator<Item = &CompletedPart> {
    results.trials.iter().filter_map(move |trial| trial.parts.get(part))
}

fn score_of(part: &CompletedPart, method: Method) -> Option<&MethodScore> {
    part.scores.iter().find(|score| score.method == method)
}

/// The median of a number of each trial; empty without a trial that has it.
fn middle<'a>(
    parts: impl Iterator<Item = &'a CompletedPart>,
    digits: usize,
    number: impl Fn(&CompletedPart) -> Option<f64>,
) -> String {
    let values: Vec<f64> = parts.filter_map(number).collect();
    if values.is_empty() { String::new() } else { fixed(median(&values), digits) }
}

/// The lines of a table: one for each part of each set of trials.
fn rows(
    text: &mut String,
    all: &[(String, &Completing)],
    headings: &str,
    row: impl Fn(&Completing, usize) -> String,
) {
    line(text, &format!("| trials | inferred | {headings} |"));
    line(text, &format!("{}|", "|---".repeat(3 + headings.matches('|').count())));
    for (name, results) in all {
        for (part, spec) in results.setting.parts.iter().enumerate() {
            line(text, &format!("| {name} | {} | {} |", spec.name, row(results, part)));
        }
    }
    line(text, "");
}

fn line(text: &mut String, words: &str) {
    // Writing to a string does not fail.
    let _ = writeln!(text, "{words}");
}

fn scores(text: &mut String, all: &[(String, &Completing)]) {
    line(
        text,
        "| trials | inferred | by | error | joints | coverage, % | log density | gaps | 0 to 0.25 s | 0 to 0.5 s | 0.5 to 1 s after the cut |",
    );
    line(text, &format!("{}|", "|---".repeat(11)));
    for (name, results) in all {
        for (part, spec) in results.setting.parts.iter().enumerate() {
            for method in Method::ALL {
                let number = |digits, number: &dyn Fn(&MethodScore) -> Option<f64>| {
                    middle(of_part(results, part), digits, |part| number(score_of(part, method)?))
                };
                let after = |k: usize| number(2, &|score| score.after_cut.get(k).copied().flatten());
                let cells = [
                    number(2, &|score| Some(score.error)),
                    number(2, &|score| Some(score.joints)),
                    number(0, &|score| Some(100.0 * score.coverage)),
                    number(0, &|score| Some(score.log_density)),
                    number(2, &|score| Some(score.gaps)),
                    after(0),
                    after(1),
                    after(2),
                ];
                let (part, method) = (&spec.name, method.name());
                line(text, &format!("| {name} | {part} | {method} | {} |", cells.join(" | ")));
            }
        }
    }
    line(text, "");
}

/// What the model cannot represent, and constant offsets.
fn errors(text: &mut String, all: &[(String, &Completing)]) {
    let headings = "error, all parts observed | error of the filter | without its constant offset | \
error of ridge regression | without its constant offset | mean posture of the trial, share of the mean pose's error";
    rows(text, all, headings, |results, part| {
        let number =
            |number: &dyn Fn(&CompletedPart) -> Option<f64>| middle(of_part(results, part), 2, number);
        let error = |part: &CompletedPart, method| score_of(part, method).map(|score| score.error);
        [
            number(&|part| Some(part.limits.all_observed)),
            number(&|part| error(part, Method::Filter)),
            number(&|part| Some(error(part, Method::Filter)? * (1.0 - part.limits.offset))),
            number(&|part| error(part, Method::Ridge)),
            number(&|part| Some(error(part, Method::Ridge)? * (1.0 - part.limits.ridge_offset))),
            number(&|part| Some(part.limits.posture)),
        ]
        .join(" | ")
    });
}

/// Where the bands are too narrow.
fn bands(text: &mut String, all: &[(String, &Completing)]) {
    let headings = "coverage, all parts observed, % | of the smoother, % | squared error : variance, all parts observed | \
filter | smoother | coverage with one noise variance for all columns, % | log density of the smoother | \
with one noise variance for all columns | columns with the lowest coverage of the smoother, %";
    rows(text, all, headings, |results, part| {
        let number = |digits, number: &dyn Fn(&CompletedPart) -> Option<f64>| {
            middle(of_part(results, part), digits, number)
        };
        [
            number(0, &|part| Some(100.0 * part.limits.all_observed_coverage)),
            number(0, &|part| Some(100.0 * score_of(part, Method::Smoother)?.coverage)),
            number(1, &|part| Some(part.limits.all_observed_squares)),
            number(1, &|part| Some(part.limits.filter_squares)),
            number(1, &|part| Some(part.limits.smoother_squares)),
            number(0, &|part| Some(100.0 * part.limits.beta_coverage)),
            number(0, &|part| Some(score_of(part, Method::Smoother)?.log_density)),
            number(0, &|part| Some(part.limits.beta_log_density)),
            lowest_columns(results, part),
        ]
        .join(" | ")
    });
}

/// The columns with the lowest mean coverage over the trials.
fn lowest_columns(results: &Completing, part: usize) -> String {
    let mut sums: Vec<(&str, f64, usize)> = Vec::new();
    for column in of_part(results, part).flat_map(|part| &part.limits.columns) {
        match sums.iter_mut().find(|(name, ..)| *name == column.column) {
            Some((_, sum, count)) => {
                *sum += column.coverage;
                *count += 1;
            }
            None => sums.push((&column.column, column.coverage, 1)),
        }
    }
    let mean = |(_, sum, count): &(&str, f64, usize)| 100.0 * sum / *count as f64;
    sums.sort_by(|a, b| mean(a).total_cmp(&mean(b)));
    let lowest = sums.iter().take(LOWEST).map(|column| format!("{} {}", column.0, fixed(mean(column), 0)));
    lowest.collect::<Vec<_>>().join(", ")
}

/// A training trial, as multiples of the model's own reconstruction.
fn training(text: &mut String, all: &[(String, &Completing)]) {
    let headings = "one frame ahead from learned latents | given parts at their learned latents | given parts observed | all parts observed";
    rows(text, all, headings, |results, part| {
        let number = |number: &dyn Fn(&CompletedPart) -> f64| {
            middle(of_part(results, part), 2, |part| Some(number(part)))
        };
        [
            number(&|part| part.limits.training.one_frame),
            number(&|part| part.limits.training.given_latents),
            number(&|part| part.limits.training.completed),
            number(&|part| part.limits.training.all_observed),
        ]
        .join(" | ")
    });
}
