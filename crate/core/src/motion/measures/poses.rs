//! Poses of a motion compared with those of recorded clips.

use std::ops::Range;

/// Most poses that are compared with a motion, so that the time is linear in the frames of the motion.
const MOST_POSES: usize = 256;

/// The steps of a motion from frame to frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Steps {
    /// Mean length, the root mean square over the nodes; in metres.
    pub(crate) mean: f64,
    /// The share of steps that turn back: that have a part opposite to the step before. A step counts as far
    /// as the shorter of both goes.
    pub(crate) turned_back: f64,
}

/// Poses of a body with heading 0: positions of its nodes relative to the root, in metres for a body 1.7 m
/// tall. The distance of two poses is the root mean square distance of their nodes.
pub(crate) struct Poses {
    /// [frames x nodes x 3]
    positions: Vec<f32>,
    /// Numbers in a pose.
    width: usize,
}

impl Poses {
    /// The poses of these nodes in `positions` [frames x width] of a whole body with heading 0.
    pub(crate) fn new(positions: &[f32], width: usize, nodes: &[usize]) -> Self {
        let mut own = Vec::with_capacity(positions.len() / width * 3 * nodes.len());
        for pose in positions.chunks_exact(width) {
            for &node in nodes {
                for axis in 0..3 {
                    own.push(pose[3 * node + axis] - pose[axis]);
                }
            }
        }
        Self { positions: own, width: 3 * nodes.len() }
    }

    /// Number of poses.
    pub(crate) fn frames(&self) -> usize {
        self.positions.len() / self.width.max(1)
    }

    fn pose(&self, frame: usize) -> &[f32] {
        &self.positions[frame * self.width..][..self.width]
    }

    /// Root mean square distance of all poses from their mean, in metres.
    pub(crate) fn spread(&self) -> f64 {
        let count = self.frames().max(1) as f64;
        let variance = |k: usize| {
            let (mut sum, mut squares) = (0.0, 0.0);
            for value in self.positions.iter().skip(k).step_by(self.width) {
                sum += f64::from(*value);
                squares += f64::from(value * value);
            }
            squares / count - (sum / count) * (sum / count)
        };
        let variances: f64 = (0..self.width).map(variance).sum();
        (3.0 * variances / self.width.max(1) as f64).max(0.0).sqrt()
    }

    /// The sum of the squared distances of the nodes of two poses.
    fn squares(&self, frame: usize, other: &Poses, other_frame: usize) -> f64 {
        let pairs = self.pose(frame).iter().zip(other.pose(other_frame));
        f64::from(pairs.map(|(a, b)| (a - b) * (a - b)).sum::<f32>())
    }

    /// Whether two poses of the same nodes differ by at most `limit` metres.
    fn is_near(&self, frame: usize, other: &Poses, other_frame: usize, limit: f64) -> bool {
        3.0 * self.squares(frame, other, other_frame) <= limit * limit * self.width as f64
    }

    /// The number of last frames in which the pose differs from the last one by at most `limit` metres.
    pub(crate) fn last_still(&self, limit: f64) -> usize {
        let frames = self.frames();
        (0..frames).rev().take_while(|&frame| self.is_near(frame, self, frames - 1, limit)).count()
    }

    /// The steps from frame to frame in these frames. `begins`: the frames that begin a sequence, to which no
    /// step leads.
    pub(crate) fn steps(&self, frames: Range<usize>, begins: &[usize]) -> Steps {
        let is_step = |frame: usize| frame > frames.start && !begins.contains(&frame);
        let length = |frame: usize| self.squares(frame, self, frame - 1).sqrt();
        let (mut way, mut count, mut turned, mut pairs) = (0.0, 0, 0.0, 0.0);
        for frame in frames.clone().filter(|frame| is_step(*frame)) {
            way += length(frame);
            count += 1;
            if frame > 1 && is_step(frame - 1) {
                let [a, b, c] = [frame - 2, frame - 1, frame].map(|frame| self.pose(frame));
                let dot: f32 = (0..self.width).map(|k| (b[k] - a[k]) * (c[k] - b[k])).sum();
                // The shorter of the two steps: what a viewer sees of the turn.
                let turn = length(frame).min(length(frame - 1));
                pairs += turn;
                turned += if dot < 0.0 { turn } else { 0.0 };
            }
        }
        let nodes = (self.width as f64 / 3.0).max(1.0);
        Steps {
            mean: way / f64::from(count.max(1)) / nodes.sqrt(),
            turned_back: if pairs > 0.0 { turned / pairs } else { 0.0 },
        }
    }

    /// The share of the way through these poses that `motion` visits: each frame counts as far as the pose has
    /// moved since the frame before, and is visited when a pose of `motion` from its frame `first` on differs
    /// from it by at most `limit` metres. `begins`: the frames that begin a sequence, which count nothing. Of
    /// more than [`MOST_POSES`] frames every second, third, ... is compared, and of the motion every frame of
    /// `stride`. 1 without a way.
    pub(crate) fn visited(
        &self,
        begins: &[usize],
        (motion, first, stride): (&Poses, usize, usize),
        limit: f64,
    ) -> f64 {
        let (mut visited, mut all) = (0.0, 0.0);
        for frame in (1..self.frames()).step_by(self.frames().div_ceil(MOST_POSES)) {
            if begins.contains(&frame) {
                continue;
            }
            let way = self.squares(frame, self, frame - 1).sqrt();
            all += way;
            if (first..motion.frames()).step_by(stride).any(|t| self.is_near(frame, motion, t, limit)) {
                visited += way;
            }
        }
        if all > 0.0 { visited / all } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hand that goes round the root, 0.3 m away, in `frames` frames; the root is somewhere else each time.
    fn circle(frames: usize, share: f64) -> Poses {
        let pose = |frame: usize| {
            let angle = std::f64::consts::TAU * share * frame as f64 / frames as f64;
            let root = 0.1 * frame as f32;
            [root, 1.0, 2.0, root + 0.3 * angle.cos() as f32, 1.0, 2.0 + 0.3 * angle.sin() as f32]
        };
        let positions: Vec<f32> = (0..frames).flat_map(pose).collect();
        Poses::new(&positions, 6, &[1])
    }

    #[test]
    fn the_spread_is_the_distance_from_the_mean_pose() {
        assert!((circle(40, 1.0).spread() - 0.3).abs() < 1e-4, "{}", circle(40, 1.0).spread());
    }

    #[test]
    fn half_a_circle_visits_half_of_the_poses() {
        let (clip, half) = (circle(400, 1.0), circle(400, 0.5));
        assert_eq!(clip.visited(&[0], (&clip, 0, 1), 1e-6), 1.0);
        let found = clip.visited(&[0], (&half, 0, 1), 1e-3);
        assert!((found - 0.5).abs() < 0.01, "{found}");
        // The last half of its frames visits a quarter.
        let found = clip.visited(&[0], (&half, 200, 1), 1e-3);
        assert!((found - 0.25).abs() < 0.01, "{found}");
        // Poses at most 60 degrees away differ by at most the radius.
        let found = clip.visited(&[0], (&circle(1, 0.0), 0, 1), 0.3001);
        assert!((found - 1.0 / 3.0).abs() < 0.01, "{found}");
    }

    #[test]
    fn steps_have_a_length_and_turn_back() {
        let forward = circle(100, 0.5);
        let steps = forward.steps(0..100, &[0]);
        let expected = 0.3 * std::f64::consts::PI / 100.0;
        assert!((steps.mean / expected - 1.0).abs() < 0.01 && steps.turned_back == 0.0, "{steps:?}");
        // No step leads to the beginning of a sequence, and none turns back there.
        let mut twice = circle(100, 0.5);
        twice.positions.extend(circle(100, 0.5).positions);
        let steps = twice.steps(0..200, &[0, 100]);
        assert!((steps.mean / expected - 1.0).abs() < 0.01 && steps.turned_back == 0.0, "{steps:?}");
        // A quarter of the frames go forward, and the others one forward, one back.
        let mut shaking = circle(100, 0.5);
        for frame in (25..100).step_by(2) {
            let before = shaking.pose(frame - 1).to_vec();
            let place = frame * shaking.width;
            shaking.positions[place..place + before.len()].copy_from_slice(&before);
            shaking.positions[place] += 0.1;
        }
        let found = shaking.steps(0..100, &[0]).turned_back;
        assert!(found > 0.9, "{found}");
    }

    #[test]
    fn frames_at_rest_count_nothing() {
        let mut clip = circle(400, 1.0);
        // The clip waits in its last pose as long again, and then a second sequence begins on the other side.
        for _ in 0..400 {
            let last = clip.pose(399).to_vec();
            clip.positions.extend(last);
        }
        let other = clip.pose(200).to_vec();
        clip.positions.extend(other);
        let found = clip.visited(&[0, 800], (&circle(400, 0.5), 0, 1), 1e-3);
        assert!((found - 0.5).abs() < 0.01, "{found}");
    }

    #[test]
    fn a_long_clip_is_sampled() {
        let found = circle(4000, 1.0).visited(&[0], (&circle(400, 0.5), 0, 1), 3e-3);
        assert!((found - 0.5).abs() < 0.01, "{found}");
    }

    #[test]
    fn without_a_way_everything_is_visited() {
        assert_eq!(circle(1, 1.0).visited(&[0], (&circle(1, 0.5), 0, 1), 0.1), 1.0);
    }

    #[test]
    fn a_pose_is_still_while_it_differs_little_from_the_last() {
        let quarter = circle(100, 0.25);
        assert_eq!(quarter.last_still(1e-6), 1);
        assert_eq!(quarter.last_still(1.0), 100);
        // Chords of 0.1 m reach 19 degrees of 90 back.
        assert!((20..=23).contains(&quarter.last_still(0.1)), "{}", quarter.last_still(0.1));
    }
}
