//! How often the movements of each setting were taken for the natural one, their scores, and whether the participants
//! paid attention.

use crate::evaluation::stats::{mean, median};
use crate::evaluation::{Candidate, Labels};
use crate::perception::answers::Answer;
use crate::perception::beta::Rate;
use crate::perception::results::{Confusion, MeanScores, Participant, SettingResult, Size};
use crate::perception::stimulus::Generated;
use crate::perception::study::Study;
use crate::perception::trials::TrialKind;
use vcgpdm_core::models::{ModelKind, Settings};

/// The answers of participants who paid attention.
pub(super) struct Counted<'a> {
    study: &'a Study,
    answers: Vec<&'a Answer>,
}

impl<'a> Counted<'a> {
    pub fn new(study: &'a Study, answers: &'a [Answer], participants: &[Participant]) -> Self {
        let counts = |answer: &&Answer| {
            let excluded = |p: &Participant| p.excluded && p.name == answer.participant;
            answer.chose_left.is_some() && !participants.iter().any(excluded)
        };
        Self { study, answers: answers.iter().filter(counts).collect() }
    }

    /// How often the generated movement, or in catch trials the unseen one, was taken for the more natural
    /// one in the wanted trials.
    pub fn rate(&self, wanted: impl Fn(&Answer) -> bool) -> Rate {
        let trials: Vec<&&Answer> = self.answers.iter().filter(|answer| wanted(answer)).collect();
        let hits = trials.iter().filter(|answer| took_generated(self.study, answer)).count();
        Rate::new(hits, trials.len())
    }
}

/// Every model with all its settings, in the order of tables.
pub(super) fn settings(counted: &Counted) -> Vec<SettingResult> {
    let study = counted.study;
    let generated: Vec<&Generated> =
        study.stimuli.iter().filter_map(|stimulus| stimulus.generated()).collect();
    let all: Vec<Candidate> = generated.iter().map(|generated| generated.candidate.clone().into()).collect();
    let labels = Labels::of_candidates(all.iter());
    let mut candidates: Vec<&Settings> = Vec::new();
    for generated in &generated {
        if !candidates.contains(&&generated.candidate) {
            candidates.push(&generated.candidate);
        }
    }
    candidates.sort_by_key(|candidate| {
        let kind = ModelKind::ALL.iter().position(|kind| *kind == candidate.kind());
        let Size { dynamics_ips, pose_ips, primitives, bases } = size(candidate);
        (kind, dynamics_ips, pose_ips, primitives, bases)
    });
    let result = |candidate: &&Settings| {
        let own = |generated: &&&Generated| generated.candidate == **candidate;
        let good: Vec<&&Generated> =
            generated.iter().filter(own).filter(|generated| !generated.failed).collect();
        let rate = counted.rate(|answer| {
            let of_candidate = |place: usize| {
                study.stimuli[place].generated().is_some_and(|g| !g.failed && g.candidate == **candidate)
            };
            answer.kind == TrialKind::Comparison && (of_candidate(answer.left) || of_candidate(answer.right))
        });
        SettingResult {
            model: candidate.kind(),
            candidate: (*candidate).clone(),
            label: labels.label(&(*candidate).clone().into()),
            size: size(candidate),
            movements: good.len(),
            failed: generated.iter().filter(own).count() - good.len(),
            scores: mean_scores(&good),
            confusion: (rate.trials > 0).then(|| Confusion::new(rate)),
        }
    };
    candidates.iter().map(result).collect()
}

fn size(candidate: &Settings) -> Size {
    match candidate {
        Settings::Vcgpdm(s) | Settings::Vgpdm(s) => {
            Size { dynamics_ips: Some(s.dynamics_ips), pose_ips: Some(s.pose_ips), ..Size::default() }
        }
        Settings::MapGpdm(_) | Settings::MapCgpdm(_) => Size::default(),
        Settings::Tmp(s) => Size { primitives: s.primitives, ..Size::default() },
        Settings::DmpDiscrete(s) | Settings::DmpRhythmic(s) => {
            Size { bases: Some(s.bases), ..Size::default() }
        }
    }
}

/// Means over movements; a score is absent if a movement lacks it.
fn mean_scores(movements: &[&&Generated]) -> Option<MeanScores> {
    let over = |value: &dyn Fn(&Generated) -> Option<f64>| -> Option<f64> {
        let values: Option<Vec<f64>> = movements.iter().map(|generated| value(generated)).collect();
        values.filter(|values| !values.is_empty()).map(|values| mean(&values))
    };
    let size = size(&movements.first()?.candidate);
    Some(MeanScores {
        mse: over(&|generated| Some(generated.scores.mse))?,
        dtw_mse: over(&|generated| Some(generated.scores.dtw_mse))?,
        training_mse: over(&|generated| generated.scores.training_mse),
        bound: over(&|generated| generated.scores.bound),
        dynamics: over(&|generated| generated.scores.dynamics()),
        pose: over(&|generated| generated.scores.pose()),
        points: size.points(),
    })
}

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
