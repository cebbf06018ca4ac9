//! The trials of one participant: the same for the same seeds, on every machine.

use crate::perception::ordering::Draw;
use crate::perception::study::Study;
use serde::Serialize;
use vcgpdm_core::models::Settings;

/// The kind of a trial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum TrialKind {
    /// A generated and a natural movement.
    Comparison,
    /// An obviously failed and a natural movement: a test of attention.
    Attention,
    /// An unseen and a seen natural movement: participants who only recognise the seen ones choose those.
    Catch,
}

impl TrialKind {
    /// Its name in documents.
    pub fn id(self) -> &'static str {
        match self {
            TrialKind::Comparison => "comparison",
            TrialKind::Attention => "attention",
            TrialKind::Catch => "catch",
        }
    }

    /// The kind of this name.
    pub fn from_id(id: &str) -> Option<Self> {
        [TrialKind::Comparison, TrialKind::Attention, TrialKind::Catch]
            .into_iter()
            .find(|kind| kind.id() == id)
    }
}

/// The side of the natural movement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum NaturalSide {
    /// Left.
    Left,
    /// Right.
    Right,
    /// Both movements are natural.
    None,
}

impl NaturalSide {
    /// Its name in documents.
    pub fn id(self) -> &'static str {
        match self {
            NaturalSide::Left => "left",
            NaturalSide::Right => "right",
            NaturalSide::None => "none",
        }
    }
}

/// A trial of the test: two movements side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct StudyTrial {
    /// Counted from 0.
    pub block: usize,
    /// The kind.
    #[cfg_attr(feature = "types", ts(inline))]
    pub kind: TrialKind,
    /// The index of the stimulus on the left.
    pub left: usize,
    /// The index of the stimulus on the right.
    pub right: usize,
    /// The side of the natural movement; "none" if both are natural.
    #[cfg_attr(feature = "types", ts(inline))]
    pub natural_side: NaturalSide,
    /// The direction in which both figures walk: 0 is towards the observer, 90 to the observer's right.
    pub heading_degrees: usize,
}

/// A trial without sides: `first` is the generated movement, or in a catch trial the unseen one.
struct Pair {
    kind: TrialKind,
    first: usize,
    natural: usize,
}

impl Study {
    /// The trials of a participant, in order, block after block.
    pub fn trials(&self, participant_seed: u32) -> Vec<StudyTrial> {
        let mut draw = Draw::new(self.design.seed, participant_seed);
        let places = |wanted: &dyn Fn(usize) -> bool| -> Vec<usize> {
            (0..self.stimuli.len()).filter(|&k| wanted(k)).collect()
        };
        let seen = places(&|k| self.stimuli[k].natural() == Some(true));
        let unseen = places(&|k| self.stimuli[k].natural() == Some(false));
        let failed = places(&|k| self.stimuli[k].failed());

        let shown = self.comparisons(&mut draw);
        let checks = draw.deal(&failed, self.design.attention_checks);
        let catches = draw.deal(&unseen, self.design.catch_trials);
        let mut naturals = draw.deal(&seen, shown.len() + checks.len() + catches.len()).into_iter();
        let mut pair = |kind, first| naturals.next().map(|natural| Pair { kind, first, natural });

        let mut pairs: Vec<Pair> =
            shown.into_iter().filter_map(|first| pair(TrialKind::Comparison, first)).collect();
        draw.shuffle(&mut pairs);
        // One check in each of several equal sections, so that they cover the whole time.
        let stretches = checks.len();
        for (k, first) in checks.into_iter().enumerate() {
            let (begin, end) = (k * pairs.len() / stretches, (k + 1) * pairs.len() / stretches);
            let place = begin + draw.below(end + 1 - begin);
            if let Some(check) = pair(TrialKind::Attention, first) {
                pairs.insert(place.min(pairs.len()), check);
            }
        }
        let all = pairs.len() + catches.len();
        for first in catches {
            let begin = (3 * all).div_ceil(4).min(pairs.len());
            let place = begin + draw.below(pairs.len() + 1 - begin);
            if let Some(catch) = pair(TrialKind::Catch, first) {
                pairs.insert(place, catch);
            }
        }
        self.sides(pairs, &mut draw)
    }

    /// The generated movements of the comparisons. Settings come equally often, as far as the number of
    /// trials allows, and so do the movements of a setting.
    fn comparisons(&self, draw: &mut Draw) -> Vec<usize> {
        let mut settings: Vec<(&Settings, Vec<usize>)> = Vec::new();
        for (k, stimulus) in self.stimuli.iter().enumerate() {
            let Some(generated) = stimulus.generated().filter(|generated| !generated.failed) else {
                continue;
            };
            match settings.iter_mut().find(|(candidate, _)| **candidate == generated.candidate) {
                Some((_, movements)) => movements.push(k),
                None => settings.push((&generated.candidate, vec![k])),
            }
        }
        let order: Vec<usize> = (0..settings.len()).collect();
        let mut times = vec![0; settings.len()];
        draw.deal(&order, self.design.comparisons).into_iter().for_each(|setting| times[setting] += 1);
        settings.iter().zip(times).flat_map(|((_, movements), times)| draw.deal(movements, times)).collect()
    }

    /// Chooses sides (half of the natural movements on the left), directions and blocks.
    fn sides(&self, pairs: Vec<Pair>, draw: &mut Draw) -> Vec<StudyTrial> {
        let (count, blocks) = (pairs.len(), self.design.blocks.max(1));
        let lefts = draw.deal(&[true, false], count);
        let trials = pairs.into_iter().zip(lefts).enumerate();
        trials
            .map(|(k, (Pair { kind, first, natural }, left))| StudyTrial {
                block: k * blocks / count,
                kind,
                left: if left { natural } else { first },
                right: if left { first } else { natural },
                natural_side: match (kind, left) {
                    (TrialKind::Catch, _) => NaturalSide::None,
                    (_, true) => NaturalSide::Left,
                    (_, false) => NaturalSide::Right,
                },
                heading_degrees: draw.below(360),
            })
            .collect()
    }
}
