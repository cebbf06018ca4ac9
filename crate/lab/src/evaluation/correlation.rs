//! Figures beside the tables: the correlation of bound and error over the sizes of a kind of model (figure 1 of the
//! supplement of Velychko et al. 2017; on the training trials figure 6B of Velychko et al. 2018), the growth of the
//! time with the data, and bounds of several parts compared with one.

use crate::evaluation::candidate::{Candidate, CandidateKind};
use crate::evaluation::effect::{Choice, Contender, Errors};
use crate::evaluation::job::Finished;
use crate::evaluation::labels::Labels;
use crate::evaluation::outcome::{Outcome, share_converged};
use crate::evaluation::primary::FEWEST_TRIALS;
use crate::evaluation::results::Results;
use crate::evaluation::rows::{Row, common_folds, groups, is_plain, settings};
use crate::evaluation::stats::{Interval, exponent_interval, mean, mean_interval, rank_correlation};
use crate::evaluation::summary::{BoundAndError, Correlation, Evidence, FramesAndTime, Growth};
use std::collections::{BTreeMap, BTreeSet};
use vcgpdm_core::models::ModelKind;

/// One correlation for every kind of model and all its settings but the size.
pub(super) fn correlations(rows: &[Row], labels: &Labels) -> Vec<Correlation> {
    let mut correlations = Vec::new();
    for kind in CandidateKind::all() {
        let groups = groups(rows.iter().filter(|row| row.candidate.kind() == kind));
        let several = groups.len() > 1;
        for group in &groups {
            let label = if several { labels.without_size(group[0].candidate) } else { String::new() };
            correlations.extend(correlation(group, label, labels));
        }
    }
    correlations
}

/// Over the folds that all of these candidates have; absent for fewer than three candidates.
pub(super) fn correlation(rows: &[&Row], label: String, labels: &Labels) -> Option<Correlation> {
    with_error(rows, label, labels, &|row, folds| row.mse(folds))
}

/// The same with the error on the training trials.
pub(super) fn training_correlation(rows: &[&Row], labels: &Labels) -> Option<Correlation> {
    with_error(rows, String::new(), labels, &|row, folds| row.training_mse(folds))
}

fn with_error(
    rows: &[&Row],
    label: String,
    labels: &Labels,
    error: &dyn Fn(&Row, &BTreeSet<usize>) -> Option<f64>,
) -> Option<Correlation> {
    let folds = common_folds(rows);
    let pair = |row: &&Row, folds: &BTreeSet<usize>| Some((row.bound(folds)?, error(row, folds)?));
    // A trial that is hard, or long, has other errors and bounds than the others: ranks within a trial do not
    // mix them.
    let within = |fold: &usize| {
        let of_fold = BTreeSet::from([*fold]);
        let pairs: Vec<(f64, f64)> = rows.iter().filter_map(|row| pair(row, &of_fold)).collect();
        (pairs.len() > 2).then(|| rank_correlation(&pairs)).flatten()
    };
    let trials: BTreeMap<usize, f64> = folds.iter().filter_map(|fold| Some((*fold, within(fold)?))).collect();
    let ranks: Vec<f64> = trials.values().copied().collect();
    let point = |row: &&Row| {
        let (bound, mse) = pair(row, &folds)?;
        Some(BoundAndError { label: labels.label(row.candidate), bound, mse })
    };
    let points: Vec<BoundAndError> = rows.iter().filter_map(point).collect();
    let model = rows.first()?.candidate.kind();
    let rank = mean(&ranks);
    // Equal ranks of few trials say nothing about others.
    let says = |interval: &Interval| ranks.len() >= FEWEST_TRIALS || interval.low < interval.high;
    let interval = mean_interval(&ranks).filter(says).map(|interval| interval.map(|r| r.clamp(-1.0, 1.0)));
    let (settings, folds) = (points.len(), ranks.len());
    (folds > 0).then_some(Correlation { model, label, settings, folds, rank, interval, points, trials })
}

/// One entry for each fold that both models have. Both are of the same frames and columns, with a noise for
/// each part or one for all. Models with weighted pose terms do not count: their training did not maximise
/// the bound on the evidence.
pub(super) fn evidence(rows: &[Row], name: &dyn Fn(usize) -> String) -> Vec<Evidence> {
    let contender = |kind| Contender::new(settings(rows, kind, &is_plain), Choice::Bound);
    let (Some(parts), Some(whole)) = (contender(ModelKind::Vcgpdm), contender(ModelKind::Vgpdm)) else {
        return Vec::new();
    };
    let of_fold = |(fold, bound): (&usize, &f64)| {
        let (a, b) = (parts.errors.get(fold)?, whole.errors.get(fold)?);
        let log_bayes_factor = bound - whole.bounds.get(fold)?;
        (*b > 0.0).then(|| Evidence { trial: name(*fold), log_bayes_factor, error_ratio: a / b })
    };
    parts.bounds.iter().filter_map(of_fold).collect()
}

/// In each fold, the error of the split with the higher bound, and that of the other split.
pub(super) fn by_preference(parts: &Contender, whole: &Contender) -> (Errors, Errors) {
    let mut sides = (Errors::new(), Errors::new());
    for (fold, bound) in &parts.bounds {
        let Some(other) = whole.bounds.get(fold) else { continue };
        let (Some(a), Some(b)) = (parts.errors.get(fold), whole.errors.get(fold)) else { continue };
        let (preferred, other) = if bound > other { (a, b) } else { (b, a) };
        sides.0.insert(*fold, *preferred);
        sides.1.insert(*fold, *other);
    }
    sides
}

/// Outcomes of a candidate by the number of trials trained on, each with the trial held out.
type Course<'a> = BTreeMap<usize, Vec<(usize, &'a Outcome)>>;

/// For each kind, the candidate that was trained on the most different numbers of trials; only folds with all
/// of these numbers count.
pub(super) fn growth(several: &[&Results], labels: &Labels) -> Vec<Growth> {
    let mut courses: Vec<(&Candidate, Course)> = Vec::new();
    let mut before = 0;
    for results in several {
        for Finished { job, outcome, .. } in results.finished() {
            let Some(outcome) = outcome else { continue };
            let place = courses.iter().position(|(other, _)| **other == job.candidate).unwrap_or_else(|| {
                courses.push((&job.candidate, Course::new()));
                courses.len() - 1
            });
            let course = courses[place].1.entry(job.training_trials).or_default();
            course.push((before + job.held_out, outcome));
        }
        before += results.setting().trials.len();
    }
    let growth = |kind: CandidateKind| {
        let of_kind = courses.iter().filter(|(candidate, _)| candidate.kind() == kind);
        let (candidate, course) = of_kind.max_by_key(|(_, course)| course.len())?;
        let points = points(course);
        let power = |seconds: &dyn Fn(&FramesAndTime) -> f64| {
            let pairs = points.iter().map(|p| (p.frames, seconds(p)));
            let pairs: Vec<(f64, f64)> = pairs.filter(|(_, seconds)| *seconds > 0.0).collect();
            let slope = exponent_interval(&pairs);
            (slope.map(|(exponent, _)| exponent), slope.and_then(|(_, interval)| interval))
        };
        let (exponent, interval) = power(&|p| p.seconds);
        let (training_exponent, training_interval) = power(&|p| p.training_seconds);
        (points.len() > 2).then(|| Growth {
            model: kind,
            label: labels.label(candidate),
            points,
            exponent,
            interval,
            training_exponent,
            training_interval,
            converged: share_converged(course.values().flatten().map(|(_, outcome)| *outcome)),
        })
    };
    CandidateKind::all().filter_map(growth).collect()
}

/// Mean frames and seconds for each number of trials, over the folds that all of them have.
fn points(course: &Course) -> Vec<FramesAndTime> {
    let folds = |outcomes: &Vec<(usize, &Outcome)>| -> BTreeSet<usize> {
        outcomes.iter().map(|(fold, _)| *fold).collect()
    };
    let common = course.values().map(folds).reduce(|a, b| &a & &b).unwrap_or_default();
    let point = |outcomes: &Vec<(usize, &Outcome)>| {
        let shared = outcomes.iter().filter(|(fold, _)| common.contains(fold));
        let shared: Vec<&Outcome> = shared.map(|(_, outcome)| *outcome).collect();
        let of = |value: &dyn Fn(&Outcome) -> f64| {
            mean(&shared.iter().map(|outcome| value(outcome)).collect::<Vec<f64>>())
        };
        (!shared.is_empty()).then(|| FramesAndTime {
            frames: of(&|o| o.frames as f64),
            seconds: of(&|o| o.seconds / o.iterations.max(1) as f64),
            training_seconds: of(&|o| o.seconds),
        })
    };
    course.values().filter_map(point).collect()
}
