//! `vcgpdm perception`: analyses answers to a study.

use crate::numbers::whole;
use crate::report::one_line;
use crate::usage::usage;
use crate::{files, study};
use serde_json::json;
use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use vcgpdm_lab::evaluation::fixed;
use vcgpdm_lab::perception::{
    AnalysisError, AnalysisOptions, AnswerFile, Confusion, PaperCheck, PerceptionResults, paper_checks,
    read_answers,
};

/// Analyse answers to a study of perceived naturalness: how often each model is taken for natural, and which
/// score predicts this.
///
/// The command prints tables as Markdown; with --out the results go to a file as one JSON document. With
/// --paper, and without files, it computes the results of Knopp et al. (2019) again, from the counts that
/// follow from their printed numbers.
#[derive(clap::Args)]
pub struct Arguments {
    /// The study that participants saw.
    #[arg(value_name = "STUDY.json", required_unless_present = "paper")]
    study: Option<PathBuf>,
    /// Files of answers from the page, jsPsych or JATOS, as CSV or JSON.
    #[arg(value_name = "ANSWERS.csv", required_unless_present = "paper")]
    answers: Vec<PathBuf>,
    /// Write the results to this file.
    #[arg(long, value_name = "RESULTS.json")]
    out: Option<PathBuf>,
    /// Write the data of the papers' figures into this folder, as CSV files.
    #[arg(long, value_name = "DIR")]
    figures: Option<PathBuf>,
    /// The ceiling c of the logistic regression p = c / (1 + exp(w0 + w1 S)).
    #[arg(long, value_name = "C", default_value_t = AnalysisOptions::default().ceiling)]
    ceiling: f64,
    /// Blocks of the cross-validation.
    #[arg(long, value_name = "N", default_value_t = AnalysisOptions::default().folds, value_parser = whole(AnalysisOptions::FOLDS))]
    folds: usize,
    /// Draws from the posteriors for the order of the models.
    #[arg(long, value_name = "N", default_value_t = AnalysisOptions::default().draws, value_parser = whole(AnalysisOptions::DRAWS))]
    draws: usize,
    /// The seed of blocks and draws.
    #[arg(long, value_name = "S", default_value_t = AnalysisOptions::default().seed, value_parser = whole(0..=u32::MAX))]
    seed: u32,
    /// Leave out participants who pass less than this share of the attention checks.
    #[arg(long, value_name = "SHARE", default_value_t = AnalysisOptions::default().attention)]
    attention: f64,
    /// Compute the results of Knopp et al. (2019) again.
    #[arg(long, conflicts_with_all = ["study", "answers", "out", "figures"])]
    paper: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let Some(place) = &arguments.study else {
        return files::print(&paper(&paper_checks(arguments.draws, arguments.seed))?);
    };
    let read = || [place].into_iter().chain(&arguments.answers).map(PathBuf::as_path);
    if let Some(out) = &arguments.out {
        files::check_writable(out, read())?;
    }
    let study = study::read(place)?;
    let texts = arguments.answers.iter().map(|path| files::read_text(path));
    let texts = texts.collect::<Result<Vec<String>, _>>()?;
    let names: Vec<String> = arguments.answers.iter().map(|path| path.display().to_string()).collect();
    let answer_files = names.iter().zip(&texts).map(|(name, text)| AnswerFile { name, text });
    let answers = read_answers(&study, &answer_files.collect::<Vec<_>>())?;
    let options = AnalysisOptions {
        ceiling: arguments.ceiling,
        folds: arguments.folds,
        draws: arguments.draws,
        seed: arguments.seed,
        attention: arguments.attention,
    };
    let results = PerceptionResults::new(&study, &answers, options).map_err(|error| match error {
        AnalysisError::Option { what, expected, found } => {
            usage(format!("--{what}: expected {expected}, found {found}"))
        }
        error => error.into(),
    })?;
    if let Some(folder) = &arguments.figures {
        write_figures(&results, folder)?;
    }
    if let Some(out) = &arguments.out {
        files::write_text(out, &(serde_json::to_string(&results)? + "\n"))?;
        if files::is_standard(out) {
            return Ok(());
        }
    }
    files::print(&files::escape(&tables(&results)?))
}

fn write_figures(results: &PerceptionResults, folder: &Path) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(folder).map_err(|error| files::with_path(folder, &error))?;
    let figures = results.figures();
    for figure in &figures {
        files::write_text(&folder.join(figure.name), &figure.csv)?;
    }
    let list: Vec<_> =
        figures.iter().map(|figure| json!({ "file": figure.name, "holds": figure.title })).collect();
    files::write_text(&folder.join("figures.json"), &(serde_json::to_string_pretty(&list)? + "\n"))
}

/// Numbers of the paper next to those that follow from its counts.
fn paper(checks: &[PaperCheck]) -> Result<String, std::fmt::Error> {
    let mut text =
        "| from the counts of Knopp et al. (2019) | the paper prints | computed |\n|---|---|---|\n"
            .to_owned();
    for PaperCheck { what, printed, computed, digits } in checks {
        writeln!(text, "| {what} | {printed} | {computed:.digits$} |")?;
    }
    Ok(text)
}

fn tables(results: &PerceptionResults) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    writeln!(text, "{}: {}\n", one_line(&results.title), results.study)?;
    participants(&mut text, results)?;
    settings(&mut text, results)?;
    regressions(&mut text, results)?;
    best(&mut text, results)?;
    Ok(text)
}

fn participants(text: &mut String, results: &PerceptionResults) -> std::fmt::Result {
    writeln!(
        text,
        "| participant | comparisons | unanswered | attention checks | left answers | median time, ms | |\n|---|---|---|---|---|---|---|"
    )?;
    for p in &results.participants {
        writeln!(
            text,
            "| {} | {} | {} | {} of {} | {} | {} | {} |",
            one_line(&p.name),
            p.comparisons,
            p.unanswered,
            p.attention_hits,
            p.attention_checks,
            p.left.map_or(String::new(), |share| format!("{:.0} %", 100.0 * share)),
            p.median_rt.map_or(String::new(), |time| format!("{time:.0}")),
            if p.excluded { "left out" } else { "" }
        )?;
    }
    let excluded = results.participants.iter().filter(|p| p.excluded).count();
    writeln!(
        text,
        "\n{} participants, {excluded} left out for passing less than {:.0} % of the attention checks. Participants took the generated movement for the natural one in {}.",
        results.participants.len(),
        100.0 * results.options.attention,
        rate(&results.all)
    )?;
    if let Some(catch) = &results.catch {
        writeln!(
            text,
            "Catch trials: participants took the unseen movement for the more natural one in {}; at equal odds beforehand, a rate of one half has the probability {:.2}.",
            rate(&catch.confusion),
            catch.is_half
        )?;
    }
    if let (Some(tell), Some(precise)) = (results.needed.to_tell, results.needed.for_precision) {
        writeln!(
            text,
            "A setting needs {tell} trials to distinguish 0.6 from 0.5 (one-sided at 5 %, power 0.8), and {precise} trials for a rate of 0.5 to lie in [0.45, 0.55] with probability 0.8.",
        )?;
    }
    writeln!(text)
}

/// Hits of trials, mean and standard deviation of the posterior.
fn rate(confusion: &Confusion) -> String {
    let Confusion { hits, trials, mean, deviation, .. } = confusion;
    format!("{hits} of {trials} ({mean:.3} ± {deviation:.3})")
}

fn settings(text: &mut String, results: &PerceptionResults) -> std::fmt::Result {
    writeln!(
        text,
        "| model | settings | movements | taken for natural | rate | P(rate > 0.5) | test MSE | DTW MSE | training MSE | bound | bound: pose terms | bound: dynamics terms |\n|---|---|---|---|---|---|---|---|---|---|---|---|"
    )?;
    for s in &results.settings {
        let nats = |value: Option<f64>| value.map_or(String::new(), |value| fixed(value, 0));
        let error = |value: Option<f64>| value.map_or(String::new(), |value| fixed(value, 5));
        let scores = s.scores.as_ref();
        let (count, mean, above) = match &s.confusion {
            Some(c) => (
                format!("{} of {}", c.hits, c.trials),
                format!("{:.3} ± {:.3}", c.mean, c.deviation),
                format!("{:.2}", c.above_half),
            ),
            None if s.movements == 0 => ("attention checks".to_owned(), String::new(), String::new()),
            None => (String::new(), String::new(), String::new()),
        };
        writeln!(
            text,
            "| {} | {} | {} | {count} | {mean} | {above} | {} | {} | {} | {} | {} | {} |",
            s.model.id(),
            s.label,
            s.movements,
            error(scores.map(|scores| scores.mse)),
            error(scores.map(|scores| scores.dtw_mse)),
            error(scores.and_then(|scores| scores.training_mse)),
            nats(scores.and_then(|scores| scores.bound)),
            nats(scores.and_then(|scores| scores.pose)),
            nats(scores.and_then(|scores| scores.dynamics)),
        )?;
    }
    writeln!(text)
}

fn regressions(text: &mut String, results: &PerceptionResults) -> std::fmt::Result {
    if results.regressions.is_empty() {
        return Ok(());
    }
    writeln!(
        text,
        "| model | score S | settings | answers | w0 | w1 (of the standardised S) | ln K | ln K of the data |\n|---|---|---|---|---|---|---|---|"
    )?;
    for r in &results.regressions {
        let weight = |k: usize| match r.errors {
            Some(errors) => format!("{:.2} ± {:.2}", r.weights[k], errors[k]),
            None => format!("{:.2}", r.weights[k]),
        };
        let factor = |factor: Option<f64>, error: Option<f64>| match (factor, error) {
            (Some(factor), Some(error)) => format!("{factor:+.2} ± {error:.2}"),
            _ => String::new(),
        };
        writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} |",
            r.model.map_or("all", |model| model.id()),
            r.score.title(),
            r.settings,
            r.trials,
            weight(0),
            weight(1),
            factor(r.log_bayes_factor, r.log_bayes_factor_error),
            factor(r.data_log_bayes_factor, r.data_log_bayes_factor_error)
        )?;
    }
    writeln!(
        text,
        "\np = {} / (1 + exp(w0 + w1 S)). ln K is the log Bayes factor of the curve compared with the best constant, for the answers of a block that was left out, in nats: the mean over {} blocks. The data predict with each setting's share of all its answers; no score can have a higher ln K.\n",
        results.options.ceiling, results.options.folds
    )
}

fn best(text: &mut String, results: &PerceptionResults) -> std::fmt::Result {
    if results.best.is_empty() {
        return Ok(());
    }
    let names: String = results.best.iter().map(|best| format!(" > {} |", best.model.id())).collect();
    writeln!(text, "| best setting of each kind | rate | P(rate > 0.5) |{names}")?;
    writeln!(text, "{}|", "|---".repeat(3 + results.best.len()))?;
    for (a, best) in results.best.iter().enumerate() {
        let pairs: String = (0..results.best.len())
            .map(|b| if a == b { " |".to_owned() } else { format!(" {:.2} |", results.pairs[a][b]) })
            .collect();
        let comma = if best.label.is_empty() { "" } else { ", " };
        writeln!(
            text,
            "| {}{comma}{} | {} | {:.3} |{pairs}",
            best.model.id(),
            best.label,
            rate(&best.confusion),
            best.confusion.above_half
        )?;
    }
    for order in results.orders.iter().take(3) {
        let names: Vec<&str> = order.models.iter().map(|model| model.id()).collect();
        writeln!(text, "\n{}: probability {:.2}", names.join(" > "), order.probability)?;
    }
    Ok(())
}
