//! Whether the path of the root and the bones are in the same unit, and whether there is a body at all.

use crate::motion::anatomy::Anatomy;
use crate::motion::clip::Clip;
use crate::motion::joint_names::Side;
use crate::motion::limbs::extents;
use crate::motion::stage::Stage;
use nalgebra::Vector3;

/// A root that moves by more body heights a second than any person or vehicle in a recording.
const TOO_FAST: f64 = 25.0;
/// Units that files mix: metres with centimetres or millimetres.
const FACTORS: [f64; 2] = [100.0, 1000.0];
/// The same, and decimetres, in both directions.
const FLOOR_FACTORS: [f64; 6] = [10.0, 100.0, 1000.0, 0.1, 0.01, 0.001];
/// A root that moves by a smaller share of the body's height does not move.
const STILL: f64 = 1e-3;
/// A root that rises or falls by a larger share of its way only bounces.
const STEEP: f64 = 0.7;
/// The unit of the root explains the steps when the factor is within this ratio of such a factor.
const NEAR: f64 = 3.0;
/// A walk is straight when the distance from its start to its end has this share of its length.
const STRAIGHT: f64 = 0.9;
/// Frames that are looked at.
const MOST_FRAMES: usize = 2_000;

impl Clip {
    /// The clip with the axis that points up found in it, and with a warning if this axis is not certain, if the
    /// path of the root is in another unit than the bones, or if the joints are all at one place.
    pub(super) fn with_checked_root(mut self) -> Clip {
        if self.frames() > 0 && extents(&self.world_pose(0).positions).amax() < 1e-9 {
            self.warnings.push(
                "the joints are all at one place: this body has no height, and lengths are in units of the file"
                    .to_owned(),
            );
            return self;
        }
        let fits = || self.walk().is_some_and(|walk| walk.fits());
        let on_floor = self.factor_to_floor().filter(|(_, is_upright)| !(*is_upright && fits()));
        self = match on_floor {
            Some((factor, true)) => {
                self.found_up = Some(self.with_scaled_root(factor).search_up_axis().axis);
                self
            }
            _ => self.with_checked_axis(),
        };
        // The axis that was found tells which way is up.
        let of_walk = || self.walk().and_then(|walk| walk.factor());
        if let Some((factor, is_upright)) = on_floor.or_else(|| Some((of_walk()?, true))) {
            if is_upright {
                self = self.without_axis_warning();
            }
            let (how, mend, rounded) =
                if factor > 1.0 { ("short", "multiply", factor) } else { ("long", "divide", 1.0 / factor) };
            let units = match rounded {
                10.0 => "centimetres and the other in millimetres",
                100.0 => "metres and the other in centimetres",
                _ => "metres and the other in millimetres",
            };
            self.warnings.push(format!(
                "the path of the root is about {rounded} times too {how} for the bones: a factor of about \
                 {rounded} between root path and bones. If one is in {units}, {mend} the root's position \
                 channels by {rounded}"
            ));
        }
        self
    }

    /// The columns of the root's position channels.
    fn root_columns(&self) -> impl Iterator<Item = usize> + '_ {
        let channels = self.skeleton.joints[0].channels.iter().enumerate();
        channels.filter(|(_, channel)| !channel.is_rotation()).map(|(column, _)| column)
    }

    /// The clip with a root whose path is longer by this factor.
    fn with_scaled_root(&self, factor: f64) -> Clip {
        let mut scaled = self.clone();
        self.root_columns().for_each(|column| scaled.values.column_mut(column).apply(|x| *x *= factor));
        scaled
    }

    /// The factor that puts a body on a floor at zero, and whether the body is upright; `None` if it is on this floor
    /// already, or if its root does not move: then there is no path.
    fn factor_to_floor(&self) -> Option<(f64, bool)> {
        let step = self.frames().div_ceil(MOST_FRAMES).max(1);
        let rows: Vec<usize> = (0..self.frames()).step_by(step).collect();
        let some = self.with_values(self.values.select_rows(&rows), self.frame_time);
        let moves = |column: usize| some.values.column(column).max() - some.values.column(column).min();
        let way = self.root_columns().map(moves).fold(0.0, f64::max);
        let (is_upright, on_floor) = match some.stands_on_floor() {
            Some(true) => return None,
            Some(false) => (true, Clip::stands_on_floor as fn(&Clip) -> Option<bool>),
            None if some.is_carried() == Some(false) => {
                (false, Clip::is_carried as fn(&Clip) -> Option<bool>)
            }
            None => return None,
        };
        let least = STILL * self.skeleton.height();
        let fits =
            |factor: &f64| factor * way > least && on_floor(&some.with_scaled_root(*factor)) == Some(true);
        FLOOR_FACTORS.into_iter().find(fits).map(|factor| (factor, is_upright))
    }

    /// The ways of root and feet; `None` without feet.
    fn walk(&self) -> Option<Walk> {
        let anatomy = Anatomy::find(&self.skeleton)?;
        let feet = [Side::Left, Side::Right].map(|side| anatomy.foot(&self.skeleton, side));
        let [Some(left), Some(right)] = feet else { return None };
        let Stage { up, height, .. } = self.stage();
        let poses: Vec<[Vector3<f64>; 3]> = (0..self.frames().min(MOST_FRAMES))
            .map(|frame| self.world_pose(frame).positions)
            .map(|places| [places[0], places[left] - places[0], places[right] - places[0]])
            .collect();
        let heights = || poses.iter().map(|[root, ..]| up.height(root));
        let rise = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
        let [way, left, right]: [f64; 3] = std::array::from_fn(|node| {
            poses.windows(2).map(|pair| (pair[1][node] - pair[0][node]).norm()).sum()
        });
        let distance = (poses.last()?[0] - poses[0][0]).norm();
        let seconds = self.frame_time * poses.len().saturating_sub(1) as f64;
        Some(Walk {
            ratio: 0.5 * (left + right) / way,
            is_straight: distance >= STRAIGHT * way && rise < STEEP * distance,
            is_too_fast: way > TOO_FAST * height * seconds,
        })
    }
}

/// The ways of root and feet over a clip. The feet of a body that walks move to and fro below the root about as fast
/// as the root moves.
struct Walk {
    /// The way of the feet as seen from the root, divided by that of the root.
    ratio: f64,
    /// Whether the root goes along a straight line. A body on a treadmill keeps its place, but its hips rise and fall.
    is_straight: bool,
    is_too_fast: bool,
}

impl Walk {
    /// Whether the paths of feet and root are in one unit.
    fn fits(&self) -> bool {
        self.is_straight && (1.0 / NEAR..NEAR).contains(&self.ratio)
    }

    /// The number by which the root's path must be multiplied to fit the bones; `None` if it fits, or if nothing
    /// shows it.
    fn factor(&self) -> Option<f64> {
        let known =
            |size: f64| FACTORS.into_iter().find(|known| (1.0 / NEAR..NEAR).contains(&(size / known)));
        let too_long = known(1.0 / self.ratio).filter(|_| self.is_too_fast).map(|known| 1.0 / known);
        known(self.ratio).filter(|_| self.is_straight).or(too_long)
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
            assert_eq!(warnings(clip.clone()), [""; 0], "{id}");
            let mut still = clip;
            (0..3).for_each(|axis| still.values.column_mut(axis).fill(0.9));
            assert_eq!(warnings(still.clone()), [""; 0], "{id}");
            // Rounding is no path.
            for (t, value) in still.values.column_mut(0).iter_mut().enumerate() {
                *value += 1e-6 * (t % 2) as f64;
            }
            assert_eq!(warnings(still), [""; 0], "{id}");
        }
        let factors =
            [(0.01, "100 times too short"), (100.0, "100 times too long"), (0.1, "10 times too short")];
        for (factor, text) in factors {
            for id in ["walk-1", "stand-wave-1"] {
                let mut clip = samples::clip(id).unwrap();
                (0..3).for_each(|axis| clip.values.column_mut(axis).apply(|x| *x *= factor));
                // Without a floor at zero the steps of a walk show it.
                let mut lifted = clip.clone();
                lifted.values.column_mut(1).add_scalar_mut(3.0);
                for clip in if id == "walk-1" && factor != 0.1 { vec![clip, lifted] } else { vec![clip] } {
                    let [warning] = &warnings(clip)[..] else { panic!("{factor}") };
                    assert!(warning.contains(&format!("{text} for the bones")), "{warning}");
                }
            }
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

    #[test]
    fn a_way_there_and_back_is_too_long_if_the_body_is_too_fast() {
        let walk = samples::clip("walk-1").unwrap();
        let rows: Vec<usize> = (0..walk.frames()).chain((0..walk.frames()).rev()).collect();
        let mut clip = walk.with_values(walk.values.select_rows(&rows), walk.frame_time);
        (0..3).for_each(|axis| clip.values.column_mut(axis).apply(|x| *x *= 100.0));
        // High above any floor.
        clip.values.column_mut(1).add_scalar_mut(3000.0);
        let is_named = |clip: Clip| warnings(clip).iter().any(|text| text.contains("100 times too long"));
        assert!(!is_named(Clip { frame_time: 100.0 * clip.frame_time, ..clip.clone() }));
        assert!(is_named(clip));
    }

    #[test]
    fn a_clip_without_frames_is_read() {
        let walk = samples::clip("walk-1").unwrap();
        let empty = walk.with_values(walk.values.rows(0, 0).into_owned(), 0.1);
        assert_eq!(empty.with_checked_root().frames(), 0);
    }
}
