//! The T-pose that some conversions put before a motion: recognised and dropped.

use crate::motion::clip::{Clip, ClipError, LocalPose};
use crate::motion::rotation;
use crate::motion::stage::upper_end;

/// A step from the first frame below this (degrees, mean over the joints) is no change of pose.
const SMALLEST_STEP: f64 = 3.0;
/// One joint counts for at most this angle (degrees): a sensor that flips over is no new pose.
const LARGEST_ANGLE: f64 = 60.0;

impl Clip {
    /// The clip without the T-pose that stands before the motion, and whether there was one.
    ///
    /// Conversions of the CMU recordings add the body at rest as row 0. It is known by the step to row 1, which is far
    /// larger than the steps of the motion itself; less far suffices where nearly all angles of row 0 are zero.
    /// A motion that sets out from rest smoothly keeps its first frame. A notice is added to the warnings.
    pub fn drop_t_pose(&self) -> (Clip, bool) {
        if !self.begins_with_t_pose() {
            return (self.clone(), false);
        }
        let rest = self.values.rows(1, self.frames() - 1).into_owned();
        let mut clip = self.with_values(rest, self.frame_time);
        clip.warnings
            .push("the first row is a T-pose that does not belong to the motion: it was left out".to_owned());
        (clip, true)
    }

    /// What training uses: without a leading T-pose, at about `fps` frames a second.
    pub fn prepared(&self, fps: f64) -> Result<Clip, ClipError> {
        self.drop_t_pose().0.resample(fps)
    }

    /// Whether row 0 is such a pose.
    pub(crate) fn begins_with_t_pose(&self) -> bool {
        let steps = self.steps();
        let Some((&first, later)) = steps.split_first() else { return false };
        if later.is_empty() || first < SMALLEST_STEP {
            return false;
        }
        let (usual, largest) = upper_end(later.to_vec());
        let at_rest = self.share_at_rest() >= 0.75;
        at_rest && first > 1.5 * usual || later.len() >= 10 && first > 4.0 * largest
    }

    /// Of the angles that are in use (not zero in row 1), the share that is zero in row 0.
    fn share_at_rest(&self) -> f64 {
        // The root is left out: the added pose keeps the place, and sometimes the heading, of the body.
        let channels = self.skeleton.joints.iter().skip(1).flat_map(|joint| &joint.channels);
        let first = self.skeleton.joints[0].channels.len();
        let used: Vec<usize> = (channels.zip(first..))
            .filter(|(channel, column)| channel.is_rotation() && self.values[(1, *column)].abs() > 1e-6)
            .map(|(_, column)| column)
            .collect();
        let zero = used.iter().filter(|&&column| self.values[(0, column)].abs() <= 1e-6).count();
        zero as f64 / used.len().max(1) as f64
    }

    /// How far the joints turn from each frame to the next: the mean angle over the joints that can turn
    /// [frames - 1], degrees.
    fn steps(&self) -> Vec<f64> {
        let turning: Vec<usize> = (self.skeleton.joints.iter().enumerate())
            .filter(|(_, joint)| joint.rotation_axes().next().is_some())
            .map(|(place, _)| place)
            .collect();
        let step = |a: &LocalPose, b: &LocalPose| {
            let angles = (turning.iter())
                .map(|&joint| rotation::angle_between(&a.rotations[joint], &b.rotations[joint]).to_degrees());
            angles.map(|angle| angle.min(LARGEST_ANGLE)).sum::<f64>() / turning.len().max(1) as f64
        };
        let poses: Vec<LocalPose> = (0..self.frames()).map(|frame| self.local_pose(frame)).collect();
        poses.windows(2).map(|pair| step(&pair[0], &pair[1])).collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::motion::clip::Clip;

    /// A chain of three joints that swing by `angle(frame)` degrees; row 0 as given.
    fn swinging(frames: usize, first_row_at_rest: bool, angle: impl Fn(usize) -> f64) -> Clip {
        let mut text = String::from(
            "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n\
             JOINT b\n{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT c\n{\nOFFSET 0 1 0\n\
             CHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\n}\nMOTION\n",
        );
        text += &format!("Frames: {frames}\nFrame Time: 0.008333\n");
        for frame in 0..frames {
            let a = if frame == 0 && first_row_at_rest { 0.0 } else { angle(frame) };
            text += &format!("1 2 3 0 0 0 {a} {} {} {} {a} 1\n", a * 0.5, -a, a * 0.3);
        }
        crate::motion::bvh::read("swing.bvh", text.as_bytes()).unwrap()
    }

    #[test]
    fn an_added_row_at_rest_is_dropped_with_a_notice() {
        let clip = swinging(50, true, |frame| 40.0 + 10.0 * (0.2 * frame as f64).sin());
        let (rest, dropped) = clip.drop_t_pose();
        assert!(dropped);
        assert_eq!(rest.frames(), 49);
        assert_eq!(rest.values.row(0), clip.values.row(1));
        assert!(rest.warnings.iter().any(|warning| warning.contains("T-pose")));
        assert!(!rest.drop_t_pose().1);
    }

    #[test]
    fn a_motion_that_sets_out_from_rest_keeps_its_first_frame() {
        assert!(!swinging(50, false, |frame| frame as f64).drop_t_pose().1);
        assert!(!swinging(50, false, |frame| 40.0 * (0.3 * frame as f64).sin()).drop_t_pose().1);
    }

    #[test]
    fn clips_too_short_to_tell_are_left_alone() {
        assert!(!swinging(2, true, |_| 40.0).drop_t_pose().1);
        assert!(!swinging(1, true, |_| 40.0).drop_t_pose().1);
    }
}
