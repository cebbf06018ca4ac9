//! Whether a body climbs in a clip, as on stairs or on a floor that is tilted: then its height is a way.

use crate::motion::pose::mapping::PoseMapping;
use nalgebra::DMatrix;

/// The least change of the height over a clip, in leg lengths.
const LEAST: f64 = 0.2;
/// A quarter of the clip that climbs has at least this share of a quarter of the whole change.
const STEADY: f64 = 0.3;

impl PoseMapping {
    /// The change of the root's height over rows of Y that contain heights, in leg lengths, if the body climbs:
    /// its height changes steadily in the same direction, and it goes farther than it climbs.
    pub(crate) fn climb(&self, y: &DMatrix<f64>) -> Option<f64> {
        let frames = y.nrows();
        if frames < 8 || self.climbs_from.is_some() {
            return None;
        }
        // The slope of a line through the heights, times the number of frames.
        let change = |first: usize, count: usize| {
            let middle = 0.5 * (count as f64 - 1.0);
            let (mut both, mut squares) = (0.0, 0.0);
            for t in 0..count {
                let from_middle = t as f64 - middle;
                both += from_middle * y[(first + t, HEIGHT)];
                squares += from_middle * from_middle;
            }
            both / squares * count as f64
        };
        let whole = change(0, frames);
        let quarter = frames / 4;
        let is_steady = (0..4).all(|n| change(n * quarter, quarter) / whole > 0.25 * STEADY);
        let mut track = self.track(&Default::default());
        let mut place = nalgebra::Vector3::zeros();
        for t in 0..frames {
            place = track.push(&std::array::from_fn(|column| y[(t, column)])).place;
        }
        let farther = place.x * place.x + place.z * place.z > whole * whole;
        (whole.abs() > LEAST && is_steady && farther).then_some(whole)
    }

    /// The mapping whose rows contain changes of the height. `y` are the rows of the first clip, with heights.
    #[must_use]
    pub(crate) fn climbing(self, y: &DMatrix<f64>) -> PoseMapping {
        PoseMapping { climbs_from: y.column(HEIGHT).iter().next().copied(), ..self }
    }

    /// Whether rows contain changes of the height instead of heights.
    pub(crate) fn climbs(&self) -> bool {
        self.climbs_from.is_some()
    }
}

/// The column of the root's height.
const HEIGHT: usize = 3;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{Clip, samples};

    /// A walk that rises by `rise` cm in each second.
    fn uphill(rise: f64) -> Clip {
        let mut walk = samples::clip("walk-1").unwrap().resample(30.0).unwrap();
        let seconds = walk.frame_time;
        for t in 0..walk.frames() {
            walk.values[(t, 1)] += rise * seconds * t as f64;
        }
        walk
    }

    #[test]
    fn a_walk_uphill_climbs_and_one_on_the_ground_does_not() {
        for (rise, climbs) in [(0.0, false), (1.0, false), (35.0, true), (-35.0, true), (12.0, true)] {
            let walk = uphill(rise);
            let mapping = PoseMapping::new(&walk);
            let change = mapping.climb(&mapping.encode(&walk).unwrap().y);
            assert_eq!(change.is_some(), climbs, "{rise}: {change:?}");
        }
        for id in ["walk-2", "bottle-1", "stand-wave-1", "walk-wave-1"] {
            let clip = samples::clip(id).unwrap();
            let mapping = PoseMapping::new(&clip);
            assert_eq!(mapping.climb(&mapping.encode(&clip).unwrap().y), None, "{id}");
        }
    }

    #[test]
    fn eight_frames_are_enough_to_tell() {
        let climbs = [7, 8].map(|frames| {
            let walk = uphill(60.0).resample(5.0).unwrap().cut(0, frames).unwrap();
            let mapping = PoseMapping::new(&walk);
            mapping.climb(&mapping.encode(&walk).unwrap().y).is_some()
        });
        assert_eq!(climbs, [false, true]);
    }

    #[test]
    fn rows_with_changes_of_the_height_give_the_clip_back() {
        let walk = uphill(35.0);
        let mapping = PoseMapping::new(&walk);
        let heights = mapping.encode(&walk).unwrap().y;
        let mapping = mapping.climbing(&heights);
        assert_eq!(mapping.climb(&heights), None, "these rows cannot climb once more");
        let encoded = mapping.encode(&walk).unwrap();
        assert!(encoded.y.column(HEIGHT).amax() < 0.1);
        let again = mapping.decode(&encoded.y, &encoded.start, walk.frame_time).unwrap();
        assert!((&again.values - &walk.values).amax() < 1e-9);
        let from_origin = mapping.decode(&encoded.y, &Default::default(), walk.frame_time).unwrap();
        assert!((from_origin.values[(0, 1)] - walk.values[(0, 1)]).abs() < 1e-9);
    }

    #[test]
    fn a_step_up_at_the_end_is_no_climb() {
        let mut walk = uphill(0.0);
        let frames = walk.frames();
        for t in 3 * frames / 4..frames {
            walk.values[(t, 1)] += 4.0 * (t - 3 * frames / 4) as f64;
        }
        let mapping = PoseMapping::new(&walk);
        assert_eq!(mapping.climb(&mapping.encode(&walk).unwrap().y), None);
    }
}
