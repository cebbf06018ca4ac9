//! The cost of the trainings of a comparison, estimated before they begin.

use crate::evaluation::job::Job;
use vcgpdm::models::TrainingCost;
use vcgpdm::motion::Clip;
use vcgpdm::motion::parts::PartSpec;

/// Columns of a joint: its rotation. The few columns of the root are neglected.
const COLUMNS: usize = 3;

impl Job {
    /// The estimated cost of its training on one core; that of a TMP, a DMP or a rival is neglected. `trials` are all
    /// clips of the comparison in their order.
    pub fn cost(&self, trials: &[Clip], parts: &[PartSpec], frames_per_second: f64) -> TrainingCost {
        let others = trials.iter().enumerate().filter(|(k, _)| *k != self.held_out);
        let seconds: f64 = others
            .take(self.training_trials)
            .map(|(_, clip)| clip.values.nrows() as f64 * clip.frame_time)
            .sum();
        let columns: Vec<usize> = parts.iter().map(|part| COLUMNS * part.joints.len()).collect();
        self.candidate.cost((seconds * frames_per_second).round() as usize, &columns)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::testing::{map, variational};
    use vcgpdm::models::Settings;
    use vcgpdm::motion::{parts, samples};

    #[test]
    fn the_cost_follows_the_training_trials() {
        let clips: Vec<Clip> = ["walk-1", "walk-2", "walk-3"].map(|id| samples::clip(id).unwrap()).into();
        let parts = parts::presets(&clips[0].skeleton).remove(1).parts;
        let cost = |candidate: &Settings, training_trials| {
            let job = Job { candidate: candidate.clone().into(), held_out: 0, training_trials, seed: 0 };
            job.cost(&clips, &parts, 30.0)
        };
        let variational = Settings::Vcgpdm(variational(12));
        let columns: Vec<usize> = parts.iter().map(|part| 3 * part.joints.len()).collect();
        let frames =
            |k: usize| (clips[k].values.nrows() as f64 * clips[k].frame_time * 30.0).round() as usize;
        assert_eq!(
            cost(&variational, 1),
            variational.cost(frames(1), &columns),
            "the first trial that is not held out"
        );
        let map = Settings::MapGpdm(map(false));
        for candidate in [&variational, &map] {
            assert!(cost(candidate, 2).seconds > 1.5 * cost(candidate, 1).seconds);
        }
    }
}
