//! Whether the path of the root and the bones are in the same unit, and whether there is a body at all.

use crate::motion::anatomy::Anatomy;
use crate::motion::clip::Clip;
use crate::motion::joint_names::Side;
use crate::motion::limbs::extents;
use nalgebra::Vector3;

/// A root that moves by more body heights a second than any person or vehicle in a recording.
const TOO_FAST: f64 = 25.0;
/// Units that files mix: metres with centimetres or millimetres.
const FACTORS: [f64; 2] = [100.0, 1000.0];
/// Hips that walk rise and fall by more than this share of the body's height.
const LEVEL: f64 = 0.005;
/// The unit of the root explains the steps when the factor is within this ratio of such a factor,
const NEAR: f64 = 1.6;
/// and the correlation of the root's path with the feet is at least this.
const CLEAR: f64 = 0.8;
/// Frames that are looked at.
const MOST_FRAMES: usize = 2_000;

impl Clip {
    /// The clip with a warning if its root's path is in another unit than its bones, or if its joints are all
    /// at one place.
    pub(super) fn with_checked_root(mut self) -> Clip {
        if self.frames() > 0 && extents(&self.world_pose(0).positions).amax() < 1e-9 {
            self.warnings.push(
                "the joints are all at one place: this body has no height, and lengths are in units of the file"
                    .to_owned(),
            );
            return self;
        }
        if let Some(factor) = self.root_factor() {
            let (how, rounded) = if factor > 1.0 { ("short", factor) } else { ("long", 1.0 / factor) };
            self.warnings.push(format!(
                "the path of the root is about {rounded} times too {how} for the bones: a factor of about \
                 {rounded} between root path and bones. If one is in metres and the other in centimetres, \
                 {} the root's position channels by {rounded}",
                if factor > 1.0 { "multiply" } else { "divide" }
            ));
        }
        self
    }

    /// The number by which the root's path must be multiplied to fit the bones; `None` if it fits, or if
    /// nothing shows it.
    ///
    /// The foot on the ground stands still: the root moves as the foot moves backwards below it.
    fn root_factor(&self) -> Option<f64> {
        let anatomy = Anatomy::find(&self.skeleton)?;
        let feet = [Side::Left, Side::Right].map(|side| anatomy.foot(&self.skeleton, side));
        let [Some(left), Some(right)] = feet else { return None };
        let up = self.up_axis();
        let flat = |v: Vector3<f64>| {
            let y_up = up.to_y_up() * v;
            Vector3::new(y_up.x, 0.0, y_up.z)
        };
        let poses: Vec<[Vector3<f64>; 3]> = (0..self.frames().min(MOST_FRAMES))
            .map(|frame| self.world_pose(frame).positions)
            .map(|places| [places[0], places[left] - places[0], places[right] - places[0]])
            .collect();
        let heights = || poses.iter().map(|[root, ..]| up.height(root));
        let rise = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
        let (mut way, mut roots, mut feet, mut both) = (0.0, 0.0, 0.0, 0.0);
        for pair in poses.windows(2) {
            let lower = if up.height(&pair[0][1]) < up.height(&pair[0][2]) { 1 } else { 2 };
            let (root, foot) = (flat(pair[1][0] - pair[0][0]), flat(pair[0][lower] - pair[1][lower]));
            way += root.norm();
            roots += root.norm_squared();
            feet += foot.norm_squared();
            both += root.dot(&foot);
        }
        let seconds = self.frame_time * poses.len().saturating_sub(1) as f64;
        let speed = way / seconds / self.height();
        let factor = both / roots;
        let correlation = both / (roots * feet).sqrt();
        let known =
            |size: f64| FACTORS.into_iter().find(|known| (1.0 / NEAR..NEAR).contains(&(size / known)));
        // A body on a treadmill keeps its place too, but its hips rise and fall.
        let short = factor > 1.0 && rise < LEVEL * self.height();
        let long = factor < 1.0 && speed > TOO_FAST;
        let found = if short { known(factor) } else { known(1.0 / factor).map(|known| 1.0 / known) };
        found.filter(|_| correlation >= CLEAR && (short || long))
    }
}

#[cfg(test)]
mod tests {
    use crate::motion::skeleton::{Channel, Joint, Skeleton};
    use crate::motion::{Clip, Recording, samples};
    use nalgebra::DMatrix;

    fn warnings(clip: Clip) -> Vec<String> {
        Recording::new("walk.bvh", clip.skeleton, clip.frame_time, clip.values).into_clip().warnings
    }

    #[test]
    fn a_root_in_another_unit_is_named_and_a_treadmill_is_not() {
        for id in ["walk-1", "stand-wave-1", "bottle-1"] {
            let clip = samples::clip(id).unwrap();
            assert!(warnings(clip.clone()).is_empty(), "{id}");
            let mut still = clip;
            (0..3).for_each(|axis| still.values.column_mut(axis).fill(0.9));
            assert!(warnings(still).is_empty(), "{id}");
        }
        for (factor, text) in [(0.01, "short"), (100.0, "long"), (1e-3, "short")] {
            let mut walk = samples::clip("walk-1").unwrap();
            (0..3).for_each(|axis| walk.values.column_mut(axis).apply(|x| *x *= factor));
            let [warning] = &warnings(walk)[..] else { panic!("{factor}") };
            assert!(warning.contains(&format!("00 times too {text} for the bones")), "{warning}");
        }
    }

    #[test]
    fn a_single_point_is_no_body() {
        let root = Joint {
            name: "ball".to_owned(),
            parent: None,
            offset: [0.0; 3],
            channels: Channel::ALL.to_vec(),
            end_sites: Vec::new(),
        };
        let values = DMatrix::from_fn(9, 6, |t, column| if column == 1 { (t % 3) as f64 } else { 0.0 });
        let clip = Clip::new("ball.bvh", Skeleton { joints: vec![root] }, 0.1, values);
        assert!(warnings(clip)[0].contains("no height"));
    }
}
