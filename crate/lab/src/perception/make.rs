//! Makes a study of natural movements and of predictions of models.

use crate::evaluation::Outcome;
use crate::perception::design::Preset;
use crate::perception::error::StudyError;
use crate::perception::movement::{FigureMovement, MovementError};
use crate::perception::staging::{StagingError, staged};
use crate::perception::stimulus::{Generated, MovementSource, Scores, Stimulus};
use crate::perception::study::{Figure, Look, Study, Texts};
use thiserror::Error;
use vcgpdm_core::models::Settings;
use vcgpdm_core::motion::Skeleton;
use vcgpdm_core::motion::landmarks::Landmarks;
use vcgpdm_core::motion::stage::STAGE_HEIGHT;

/// Unit of the stored positions in metres: a quarter of a pixel of a figure 400 pixels high.
const UNIT: f64 = 0.001;
/// From this number of frames a second on, a study has 60 frames a second, otherwise 30.
const FAST: f64 = 45.0;

/// Why a movement cannot be part of a study.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{id}: {reason}")]
pub struct MakerError {
    /// The id of the movement.
    pub id: String,
    /// The reason.
    pub reason: MakerReason,
}

/// The reason why a movement cannot be part of a study.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MakerReason {
    /// It cannot be shown.
    #[error(transparent)]
    Staging(#[from] StagingError),
    /// It cannot be stored.
    #[error(transparent)]
    Movement(#[from] MovementError),
    /// Its positions are of another body.
    #[error("expected positions of {expected} nodes in every frame, found {found} numbers")]
    Nodes {
        /// Nodes of the body.
        expected: usize,
        /// Numbers found.
        found: usize,
    },
}

/// A recorded movement, or the prediction of a trial.
#[derive(Clone, Copy, Debug)]
pub struct StudyMovement<'a> {
    /// The trial, counted from 0. Its id in the study counts from 1.
    pub trial: usize,
    /// The name of the trial.
    pub name: &'a str,
    /// Positions [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub positions: &'a [f32],
    /// Seconds from one frame to the next.
    pub frame_time: f64,
}

/// Collects the movements of a study.
#[derive(Clone, Debug)]
pub struct Maker {
    skeleton: Skeleton,
    seconds: f64,
    rate: usize,
    skipped: usize,
    stimuli: Vec<Stimulus>,
    made: Vec<Made>,
}

/// A generated stimulus with the outcome that decides whether another seed replaces it.
#[derive(Clone, Debug)]
struct Made {
    index: usize,
    trial: usize,
    outcome: Outcome,
}

impl Maker {
    /// A study of movements of this body, of `seconds` seconds each, without the `skipped` first frames from
    /// which predictions start. `frames_per_second` are those of the movements; the study has 30 or 60.
    pub fn new(skeleton: &Skeleton, seconds: f64, frames_per_second: f64, skipped: usize) -> Self {
        let rate = if frames_per_second < FAST { 30 } else { 60 };
        Self { skeleton: skeleton.clone(), seconds, rate, skipped, stimuli: Vec::new(), made: Vec::new() }
    }

    /// Adds a recorded movement: for all trials (`seen`), or for catch trials only.
    ///
    /// # Errors
    /// It is too short, not finite, or of another body.
    pub fn natural(&mut self, shown: &StudyMovement, seen: bool) -> Result<(), MakerError> {
        let kind = if seen { "trial" } else { "unseen" };
        let id = format!("{kind}-{}", shown.trial.saturating_add(1));
        self.add(id, shown, MovementSource::Natural { seen })
    }

    /// Adds the prediction of the trial that was held out. Of several seeds of a candidate the
    /// [best](Outcome::is_better_seed) stays.
    ///
    /// # Errors
    /// It is too short, not finite, or of another body.
    pub fn generated(
        &mut self,
        shown: &StudyMovement,
        candidate: &Settings,
        seed: u32,
        outcome: &Outcome,
    ) -> Result<(), MakerError> {
        let id = format!("{}-trial-{}", name(candidate), shown.trial.saturating_add(1));
        let scores = Scores::new(outcome);
        let generated = Generated { candidate: candidate.clone(), seed, failed: false, scores };
        let source = MovementSource::Generated(Box::new(generated));
        let of_candidate = |index: usize| match &self.stimuli[index].source {
            MovementSource::Generated(made) => made.candidate == *candidate,
            MovementSource::Natural { .. } => false,
        };
        let same = |made: &Made| made.trial == shown.trial && of_candidate(made.index);
        let Some(earlier) = self.made.iter().position(same) else {
            self.add(id, shown, source)?;
            let index = self.stimuli.len() - 1;
            self.made.push(Made { index, trial: shown.trial, outcome: outcome.clone() });
            return Ok(());
        };
        let (movement, speed) = self.movement(shown).map_err(|reason| MakerError { id, reason })?;
        let earlier = &mut self.made[earlier];
        if outcome.is_better_seed(&earlier.outcome) {
            earlier.outcome = outcome.clone();
            let stimulus = &mut self.stimuli[earlier.index];
            (stimulus.source, stimulus.movement, stimulus.speed) = (source, movement, speed);
        }
        Ok(())
    }

    fn add(&mut self, id: String, shown: &StudyMovement, source: MovementSource) -> Result<(), MakerError> {
        let (movement, speed) =
            self.movement(shown).map_err(|reason| MakerError { id: id.clone(), reason })?;
        let taken = |id: &str| self.stimuli.iter().any(|stimulus| stimulus.id == id);
        // Candidates may differ in more than their size.
        let id = (1..).map(|k| if k == 1 { id.clone() } else { format!("{id}-{k}") }).find(|id| !taken(id));
        let (id, trial) = (id.unwrap_or_default(), shown.name.chars().take(200).collect());
        self.stimuli.push(Stimulus { id, trial, source, speed, movement });
        Ok(())
    }

    fn movement(&self, shown: &StudyMovement) -> Result<(FigureMovement, f64), MakerReason> {
        let nodes = self.skeleton.node_count();
        let found = shown.positions.len();
        if found == 0 || nodes == 0 || !found.is_multiple_of(3 * nodes) {
            return Err(MakerReason::Nodes { expected: nodes, found });
        }
        let StudyMovement { positions, frame_time, .. } = *shown;
        let staged = staged(&self.skeleton, positions, frame_time, self.skipped, self.seconds, self.rate)?;
        Ok((FigureMovement::new(&staged.positions, nodes, UNIT)?, staged.speed))
    }

    /// The study.
    ///
    /// # Errors
    /// There is no natural movement for all trials, or no generated one.
    pub fn study(self, title: &str, preset: Preset, look: Look, seed: u32) -> Result<Study, StudyError> {
        let nodes = self.skeleton.figure();
        let name = |place: usize| {
            let joint = self.skeleton.joints[nodes[place].joint].name.chars().take(180).collect::<String>();
            if nodes[place].end_site { format!("{joint} end") } else { joint }
        };
        let (_, cross_seconds) = preset.seconds();
        let study = Study {
            title: title.to_owned(),
            look,
            frames_per_second: self.rate,
            seconds: self.seconds,
            cross_seconds,
            texts: Texts::default(),
            design: preset.design(seed),
            figure: Figure {
                names: (0..nodes.len()).map(name).collect(),
                parents: nodes.iter().map(|node| node.parent).collect(),
                joints: self.skeleton.joints.len(),
                landmarks: Landmarks::new(&self.skeleton),
            },
            height: STAGE_HEIGHT,
            unit: UNIT,
            stimuli: self.stimuli,
        };
        // A study that cannot be read must not reach participants.
        let study = study.with_preset(preset);
        Study::from_json(&study.to_json()?)
    }
}

/// Kind and size of a candidate, as part of an id.
fn name(candidate: &Settings) -> String {
    let size = match candidate {
        Settings::Vcgpdm(s) | Settings::Vgpdm(s) => format!("-{}-{}", s.dynamics_ips, s.pose_ips),
        Settings::MapGpdm(_) | Settings::MapCgpdm(_) => String::new(),
        Settings::Tmp(s) => s.primitives.map_or("-bound".to_owned(), |count| format!("-{count}")),
        Settings::DmpDiscrete(s) | Settings::DmpRhythmic(s) => format!("-{}", s.bases),
    };
    format!("{}{size}", candidate.kind().id())
}

vcgpdm_core::coded!(MakerError => Study);

#[cfg(test)]
mod tests {
    use super::*;
    use vcgpdm_core::models::TmpSettings;
    use vcgpdm_core::motion::samples;

    fn outcome(objective: f64) -> Outcome {
        let plain = crate::evaluation::testing::outcome(0.05, Some(objective), 10, 1.0);
        // The error on the training trials, not the objective, chooses the seed.
        Outcome { objective: -objective, training_mse: Some(0.1 / (1.0 + objective)), ..plain }
    }

    #[test]
    fn makes_a_study_of_movements() {
        let clips = ["walk-1", "walk-2"].map(|id| samples::clip(id).unwrap().resample(30.0).unwrap());
        let mut maker = Maker::new(&clips[0].skeleton, 3.5, 30.0, 5);
        let places = clips.each_ref().map(|clip| clip.stage_positions());
        let shown = |k: usize| StudyMovement {
            trial: k,
            name: "a walk",
            positions: &places[k],
            frame_time: clips[k].frame_time,
        };
        maker.natural(&shown(0), true).unwrap();
        maker.natural(&shown(1), false).unwrap();
        let tmp = Settings::Tmp(TmpSettings { primitives: Some(4), normalised_time: false });
        let time = Settings::Tmp(TmpSettings { primitives: Some(4), normalised_time: true });
        // The seed with the smallest error on the training trials stays, in whatever order they come.
        for (seed, objective) in [(3, 1.0), (4, 7.0), (5, 6.0)] {
            maker.generated(&shown(0), &tmp, seed, &outcome(objective)).unwrap();
        }
        maker.generated(&shown(0), &time, 0, &outcome(0.0)).unwrap();
        let few = StudyMovement { positions: &places[0][1..], ..shown(0) };
        let error = maker.natural(&few, true).unwrap_err().to_string();
        assert!(error.starts_with("trial-1: expected positions of "), "{error}");
        let short = StudyMovement { positions: &places[0][..places[0].len() / 2], ..shown(0) };
        let error = maker.generated(&short, &tmp, 0, &outcome(9.0)).unwrap_err().to_string();
        assert_eq!(error, "tmp-4-trial-1: expected a movement of at least 3.50 seconds, found 2.10");
        let study = maker.study("Walks", Preset::Class, Look::Figure, 1).unwrap();
        let ids: Vec<&str> = study.stimuli.iter().map(|stimulus| stimulus.id.as_str()).collect();
        assert_eq!(ids, ["trial-1", "unseen-2", "tmp-4-trial-1", "tmp-4-trial-1-2"]);
        assert_eq!(study.stimuli[2].generated().unwrap().scores.bound, Some(7.0));
        assert_eq!((study.frames(), study.frames_per_second, study.height), (105, 30, 1.7));
        assert_eq!(study.figure.landmarks.dots.len(), 13);
        assert!(study.figure.names.last().unwrap().ends_with(" end"));
        assert_eq!(study.trials(0).len(), 56, "nothing has failed");
    }
}
