//! `vcgpdm report`: the tables of an evaluation, as Markdown.

use crate::files;
use crate::results::{Finished, Results};
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;
use vcgpdm::ModelKind;
use vcgpdm::evaluation::stats::{exponent, mean, rank_correlation, standard_error};
use vcgpdm::evaluation::{Candidate, Outcome};

/// Print the tables of an evaluation, and what they say about the claims of the papers.
#[derive(clap::Args)]
pub struct Arguments {
    /// Files that `evaluate` wrote, all of the same trials and parts.
    #[arg(value_name = "RESULTS.json", required = true)]
    results: Vec<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let mut results = Results::read(&arguments.results[0])?;
    for path in &arguments.results[1..] {
        results.merge(Results::read(path)?, path)?;
    }
    let mut text = String::new();
    let setting = &results.setting;
    let names: Vec<&str> = setting.parts.iter().map(|part| part.name.as_str()).collect();
    writeln!(
        text,
        "{} trials, parts {}, {} frames a second; predictions start from {} frames.\n",
        setting.trials.len(),
        names.join(" and "),
        setting.frames_per_second,
        setting.start_frames
    )?;
    let summaries = summaries(&results);
    models(&mut text, &summaries)?;
    settings(&mut text, &summaries)?;
    growth(&mut text, &results)?;
    failures(&mut text, &results)?;
    claims(&mut text, &results, &summaries)?;
    files::print(&text)
}

/// A candidate, trained on all other trials, over folds and seeds.
struct Summary<'a> {
    candidate: &'a Candidate,
    /// The mean over the seeds of each fold.
    mse: Vec<f64>,
    variance: f64,
    bounds: Vec<f64>,
    outcomes: Vec<&'a Outcome>,
}

impl<'a> Summary<'a> {
    fn new(candidate: &'a Candidate, of: Vec<&'a Finished>, trials: usize) -> Self {
        let outcomes: Vec<&Outcome> = of.iter().filter_map(|f| f.outcome.as_ref()).collect();
        let fold = |held_out: usize| {
            let seeds = of.iter().filter(|f| f.job.held_out == held_out).filter_map(|f| f.outcome.as_ref());
            let mse: Vec<f64> = seeds.map(|o| o.score.dtw_mse).collect();
            (!mse.is_empty()).then(|| mean(&mse))
        };
        Self {
            candidate,
            mse: (1..=trials).filter_map(fold).collect(),
            variance: mean(&outcomes.iter().map(|o| o.score.variance).collect::<Vec<_>>()),
            bounds: outcomes.iter().filter_map(|o| o.bound).collect(),
            outcomes,
        }
    }

    fn mean(&self, value: impl Fn(&Outcome) -> f64) -> f64 {
        mean(&self.outcomes.iter().map(|o| value(o)).collect::<Vec<_>>())
    }

    fn bound(&self) -> Option<f64> {
        (!self.bounds.is_empty()).then(|| mean(&self.bounds))
    }
}

fn summaries(results: &Results) -> Vec<Summary<'_>> {
    let all = results.setting.trials.len() - 1;
    let whole: Vec<&Finished> = results.finished.iter().filter(|f| f.job.training_trials == all).collect();
    let mut candidates: Vec<&Candidate> = Vec::new();
    for finished in &whole {
        if !candidates.contains(&&finished.job.candidate) {
            candidates.push(&finished.job.candidate);
        }
    }
    let place = |c: &Candidate| ModelKind::ALL.iter().position(|kind| *kind == c.kind());
    candidates.sort_by_key(|c| place(c));
    let of =
        |candidate: &&Candidate| whole.iter().copied().filter(|f| f.job.candidate == **candidate).collect();
    let found = candidates.iter().map(|candidate| Summary::new(candidate, of(candidate), all + 1));
    found.filter(|summary| !summary.outcomes.is_empty()).collect()
}

/// Figure 4 of Velychko et al. 2018 as a table.
fn models(text: &mut String, summaries: &[Summary]) -> std::fmt::Result {
    writeln!(
        text,
        "| model | settings | DTW MSE | standard error | of a motionless prediction | bound | training, s | numbers stored | folds | runs |"
    )?;
    writeln!(text, "|---|---|---|---|---|---|---|---|---|---|")?;
    for s in summaries {
        writeln!(
            text,
            "| {} | {} | {:.5} | {} | {:.0} % | {} | {:.1} | {:.0} | {} | {} |",
            s.candidate.kind().id(),
            s.candidate.label(),
            mean(&s.mse),
            standard_error(&s.mse).map_or(String::new(), |e| format!("{e:.5}")),
            100.0 * mean(&s.mse) / s.variance,
            s.bound().map_or(String::new(), |b| format!("{b:.0}")),
            s.mean(|o| o.seconds),
            s.mean(|o| o.stored_numbers as f64),
            s.mse.len(),
            s.outcomes.len()
        )?;
    }
    writeln!(text)
}

/// Bound and MSE of each kind over its settings.
fn correlation(summaries: &[Summary], kind: ModelKind) -> Option<(f64, usize)> {
    let of = summaries.iter().filter(|s| s.candidate.kind() == kind);
    let pairs: Vec<(f64, f64)> = of.filter_map(|s| Some((s.bound()?, mean(&s.mse)))).collect();
    (pairs.len() > 2).then(|| rank_correlation(&pairs)).flatten().map(|r| (r, pairs.len()))
}

fn settings(text: &mut String, summaries: &[Summary]) -> std::fmt::Result {
    let found: Vec<(ModelKind, f64, usize)> = ModelKind::ALL
        .into_iter()
        .filter_map(|kind| correlation(summaries, kind).map(|(r, n)| (kind, r, n)))
        .collect();
    if found.is_empty() {
        return Ok(());
    }
    writeln!(text, "| model | settings compared | rank correlation of bound and MSE |\n|---|---|---|")?;
    for (kind, r, n) in found {
        writeln!(text, "| {} | {n} | {r:.2} |", kind.id())?;
    }
    writeln!(text)
}

/// Frames and seconds an iteration, of runs on fewer and more trials.
fn times(results: &Results, kind: ModelKind) -> Vec<(f64, f64)> {
    let of = results.finished.iter().filter(|f| f.job.candidate.kind() == kind);
    let counts: std::collections::BTreeSet<usize> = of.clone().map(|f| f.job.training_trials).collect();
    let point = |count: usize| {
        let outcomes =
            of.clone().filter(|f| f.job.training_trials == count).filter_map(|f| f.outcome.as_ref());
        let (frames, seconds): (Vec<f64>, Vec<f64>) =
            outcomes.map(|o| (o.frames as f64, o.seconds / o.iterations.max(1) as f64)).unzip();
        (!frames.is_empty()).then(|| (mean(&frames), mean(&seconds)))
    };
    counts.into_iter().filter_map(point).collect()
}

fn growth(text: &mut String, results: &Results) -> std::fmt::Result {
    let grown: Vec<(ModelKind, Vec<(f64, f64)>)> = ModelKind::ALL
        .into_iter()
        .map(|kind| (kind, times(results, kind)))
        .filter(|(_, t)| t.len() > 2)
        .collect();
    if grown.is_empty() {
        return Ok(());
    }
    writeln!(text, "| model | frames: ms an iteration | exponent |\n|---|---|---|")?;
    for (kind, points) in grown {
        let list: Vec<String> = points.iter().map(|(n, s)| format!("{n:.0}: {:.2}", 1e3 * s)).collect();
        let exponent = exponent(&points).map_or(String::new(), |e| format!("{e:.2}"));
        writeln!(text, "| {} | {} | {exponent} |", kind.id(), list.join(", "))?;
    }
    writeln!(text)
}

fn failures(text: &mut String, results: &Results) -> std::fmt::Result {
    for f in results.finished.iter().filter(|f| f.failure.is_some()) {
        let (job, why) = (&f.job, f.failure.as_deref().unwrap_or_default());
        let (kind, label) = (job.candidate.kind().id(), job.candidate.label());
        writeln!(
            text,
            "Failed: {kind}, {label}, trial {} held out, seed {}: {why}\n",
            job.held_out, job.seed
        )?;
    }
    Ok(())
}

/// What the papers say, and what these results say to it.
fn claims(text: &mut String, results: &Results, summaries: &[Summary]) -> std::fmt::Result {
    let best = |kind: ModelKind| {
        let of = summaries.iter().filter(|s| s.candidate.kind() == kind).map(|s| mean(&s.mse));
        of.min_by(f64::total_cmp)
    };
    let mut rows: Vec<(&str, String, bool)> = Vec::new();
    use ModelKind::{MapCgpdm, MapGpdm, Vcgpdm, Vgpdm};
    if let (Some(a), Some(b), Some(c), Some(d)) = (best(Vcgpdm), best(Vgpdm), best(MapGpdm), best(MapCgpdm)) {
        rows.push((
            "Both variational models predict better than both MAP models (2017, 2018)",
            format!("MSE {a:.5} and {b:.5} beside {c:.5} and {d:.5}"),
            a.max(b) < c.min(d),
        ));
    }
    if let (Some(a), Some(b)) = (best(Vcgpdm), best(Vgpdm)) {
        let ratio = a / b;
        rows.push((
            "Parts cost no precision: the vCGPDM's MSE is at most 1.1 times the vGPDM's (2018)",
            format!("{ratio:.2} times"),
            ratio <= 1.1,
        ));
    }
    for kind in [Vcgpdm, Vgpdm] {
        if let Some((r, n)) = correlation(summaries, kind) {
            let claim = "The bound predicts the MSE: rank correlation below -0.5 over inducing points (2018)";
            rows.push((claim, format!("{} over {n} settings: {r:.2}", kind.id()), r < -0.5));
        }
    }
    for (kind, claim, limit) in [
        (
            Vcgpdm,
            "The vCGPDM's learning time grows about linearly with the frames: exponent below 1.1 (2017)",
            false,
        ),
        (MapCgpdm, "The MAP CGPDM's learning time grows with an exponent above 2 (2017)", true),
    ] {
        if let Some(e) = Some(times(results, kind)).filter(|t| t.len() > 2).and_then(|t| exponent(&t)) {
            rows.push((claim, format!("{e:.2}"), if limit { e > 2.0 } else { e < 1.1 }));
        }
    }
    if rows.is_empty() {
        return Ok(());
    }
    writeln!(text, "| the papers say | we find | holds here |\n|---|---|---|")?;
    for (claim, found, holds) in rows {
        writeln!(text, "| {claim} | {found} | {} |", if holds { "yes" } else { "no" })?;
    }
    Ok(())
}
