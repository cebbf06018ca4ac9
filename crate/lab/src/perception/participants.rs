//! The participants, and whether they paid attention.

use crate::evaluation::stats::median;
use crate::perception::answers::Answer;
use crate::perception::results::Participant;
use crate::perception::study::Study;
use crate::perception::trials::TrialKind;

/// All participants, in the order of their first answers.
pub(super) fn participants(study: &Study, answers: &[Answer], attention: f64) -> Vec<Participant> {
    let mut names: Vec<&str> = Vec::new();
    for answer in answers {
        if !names.contains(&answer.participant.as_str()) {
            names.push(&answer.participant);
        }
    }
    names.into_iter().map(|name| participant(study, answers, name, attention)).collect()
}

fn participant(study: &Study, answers: &[Answer], name: &str, attention: f64) -> Participant {
    let own: Vec<&Answer> = answers.iter().filter(|answer| answer.participant == name).collect();
    let answered: Vec<&&Answer> = own.iter().filter(|answer| answer.chose_left.is_some()).collect();
    let of_kind = |kind: TrialKind| answered.iter().filter(move |answer| answer.kind == kind);
    let checks = of_kind(TrialKind::Attention).count();
    let hits = of_kind(TrialKind::Attention).filter(|answer| !took_generated(study, answer)).count();
    let left = answered.iter().filter(|answer| answer.chose_left == Some(true)).count();
    let times: Vec<f64> = answered.iter().filter_map(|answer| answer.rt).collect();
    Participant {
        name: name.to_owned(),
        comparisons: of_kind(TrialKind::Comparison).count(),
        unanswered: own.len() - answered.len(),
        attention_checks: checks,
        attention_hits: hits,
        excluded: checks > 0 && (hits as f64) < attention * checks as f64,
        left: (!answered.is_empty()).then(|| left as f64 / answered.len() as f64),
        median_rt: (!times.is_empty()).then(|| median(&times)),
        started_apart_ms: own.iter().filter_map(|answer| answer.started_apart_ms).reduce(f64::max),
    }
}

/// Whether the generated movement, or in a catch trial the unseen one, was taken for the more natural one.
pub(super) fn took_generated(study: &Study, answer: &Answer) -> bool {
    let chosen = if answer.chose_left == Some(true) { answer.left } else { answer.right };
    answer.chose_left.is_some() && study.stimuli[chosen].natural() != Some(true)
}
