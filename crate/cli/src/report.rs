//! `vcgpdm report`: the tables of an evaluation, as Markdown.

use crate::{files, results};
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;
use vcgpdm::evaluation::{Comparison, Labels, Results, Spread};

/// Print the tables of an evaluation, and what they say about the claims of the papers.
#[derive(clap::Args)]
pub struct Arguments {
    /// Files that `evaluate` wrote, all of the same trials and parts.
    #[arg(value_name = "RESULTS.json", required = true)]
    results: Vec<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let mut results = results::read(&arguments.results[0])?;
    for path in &arguments.results[1..] {
        results.merge(results::read(path)?).map_err(|error| files::about(path, &error))?;
    }
    let mut text = String::new();
    let setting = results.setting();
    let names: Vec<String> = setting.parts.iter().map(|part| one_line(&part.name)).collect();
    writeln!(
        text,
        "{} trials, parts {}, {} frames a second; predictions start from {} frames.\n",
        setting.trials.len(),
        names.join(" and "),
        setting.frames_per_second,
        setting.start_frames
    )?;
    let comparison = Comparison::of(&results);
    models(&mut text, &comparison)?;
    correlations(&mut text, &comparison)?;
    growth(&mut text, &comparison)?;
    failures(&mut text, &results)?;
    claims(&mut text, &comparison)?;
    files::print(&files::shown(&text))
}

/// Mean and standard error.
fn spread(spread: &Spread, digits: usize) -> String {
    match spread.standard_error {
        Some(error) => format!("{:.digits$} ± {error:.digits$}", spread.mean),
        None => format!("{:.digits$}", spread.mean),
    }
}

/// Figure 4 of Velychko et al. 2018 as a table.
fn models(text: &mut String, comparison: &Comparison) -> std::fmt::Result {
    writeln!(
        text,
        "| model | settings | DTW MSE | median | of a motionless prediction | bound | training, s | numbers stored | folds | runs |"
    )?;
    writeln!(text, "|---|---|---|---|---|---|---|---|---|---|")?;
    for s in &comparison.models {
        writeln!(
            text,
            "| {} | {} | {} | {:.5} | {:.0} % | {} | {} | {:.0} | {} | {} |",
            s.model.id(),
            s.label,
            spread(&s.mse, 5),
            s.mse_median,
            100.0 * s.mse.mean / s.variance,
            s.bound.as_ref().map_or(String::new(), |b| spread(b, 0)),
            spread(&s.seconds, 1),
            s.stored_numbers.mean,
            s.folds,
            s.runs
        )?;
    }
    writeln!(text, "\nMean ± standard error over the trials held out.\n")
}

fn correlations(text: &mut String, comparison: &Comparison) -> std::fmt::Result {
    if comparison.correlations.is_empty() {
        return Ok(());
    }
    writeln!(text, "| model | settings compared | rank correlation of bound and MSE |\n|---|---|---|")?;
    for c in &comparison.correlations {
        let (comma, label) = if c.label.is_empty() { ("", "") } else { (", ", c.label.as_str()) };
        writeln!(text, "| {}{comma}{label} | {} | {:.2} |", c.model.id(), c.settings, c.rank)?;
    }
    writeln!(text)
}

fn growth(text: &mut String, comparison: &Comparison) -> std::fmt::Result {
    if comparison.growth.is_empty() {
        return Ok(());
    }
    writeln!(text, "| model | settings | frames: ms an iteration | exponent |\n|---|---|---|---|")?;
    for g in &comparison.growth {
        let list: Vec<String> =
            g.points.iter().map(|p| format!("{:.0}: {:.2}", p.frames, 1e3 * p.seconds)).collect();
        let exponent = g.exponent.map_or(String::new(), |e| format!("{e:.2}"));
        writeln!(text, "| {} | {} | {} | {exponent} |", g.model.id(), g.label, list.join(", "))?;
    }
    writeln!(text)
}

/// Text that somebody else wrote, as part of a line or a cell of Markdown: without line breaks and bars.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "\\|")
}

fn failures(text: &mut String, results: &Results) -> std::fmt::Result {
    let labels = Labels::of(results);
    for f in results.finished().iter().filter(|f| f.failure.is_some()) {
        let (job, why) = (&f.job, one_line(f.failure.as_deref().unwrap_or_default()));
        let (kind, label) = (job.candidate.kind().id(), labels.label(&job.candidate));
        writeln!(
            text,
            "Failed: {kind}, {label}, trial {} held out, seed {}: {why}\n",
            job.held_out, job.seed
        )?;
    }
    Ok(())
}

/// What the papers say, and what these results say to it.
fn claims(text: &mut String, comparison: &Comparison) -> std::fmt::Result {
    if comparison.claims.is_empty() {
        return Ok(());
    }
    writeln!(text, "| the papers say | we find | holds here |\n|---|---|---|")?;
    for c in &comparison.claims {
        writeln!(text, "| {} | {} | {} |", c.claim, c.found, if c.holds { "yes" } else { "no" })?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::one_line;

    #[test]
    fn failures_do_not_break_the_tables() {
        assert_eq!(one_line("expected a | b,\n\n| found |\r\n c"), "expected a \\| b, \\| found \\| c");
    }
}
