//! How the time of a training grows with the frames: figure 2 of the supplement of Velychko et al. (2017).

use crate::evaluation::candidate::{Candidate, CandidateKind};
use crate::evaluation::job::Finished;
use crate::evaluation::labels::Labels;
use crate::evaluation::outcome::{Outcome, share_converged};
use crate::evaluation::results::Results;
use crate::evaluation::stats::{exponent_interval, mean};
use crate::evaluation::summary::{FramesAndTime, Growth};
use std::collections::{BTreeMap, BTreeSet};

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
