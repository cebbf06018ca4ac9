//! Inverse kinematics of a whole pose: the angles with which a node of the figure is near a wanted place.

use crate::models::kinds::body::Body;
use crate::models::kinds::reach::minimum;
use crate::models::rollout::request::RolloutError;
use crate::motion::pose::{ROOT_COLUMNS, RootStart};
use nalgebra::{DMatrix, DVector, Vector3};

/// A dragged node should be this near to its place, in metres.
const NEAR: f64 = 0.01;
/// A joint that carries no other turns by about this much for it, in radians; one that carries n others is n + 1 times
/// as stiff.
const TURN: f64 = 1.0;

impl Body {
    /// The displacement of all columns `[D]` with which a node of the figure in frame `frame` of `y` [frames x D] is
    /// near `place`, in metres from the root in a world with y up. The joints turn as little as possible, those that
    /// carry many others least.
    ///
    /// # Errors
    ///
    /// When there is no such frame or node, or a number is not finite.
    pub fn dragged(
        &self,
        y: &DMatrix<f64>,
        frame: usize,
        node: usize,
        place: [f64; 3],
    ) -> Result<Vec<f64>, RolloutError> {
        if let Some(&found) = place.iter().find(|x| !x.is_finite()) {
            return Err(RolloutError::Place { found });
        }
        if frame >= y.nrows() {
            return Err(RolloutError::StartFrame { most: y.nrows().saturating_sub(1), found: frame });
        }
        let count = self.mapping.skeleton().figure().len();
        if node >= count {
            return Err(RolloutError::Node { count, found: node });
        }
        if y.ncols() == ROOT_COLUMNS.len() {
            // A body of one joint, and nothing to turn.
            return Ok(vec![0.0; y.ncols()]);
        }
        let mut track = self.mapping.track(&RootStart::default());
        self.mapping.continue_positions(&y.rows(0, frame + 1).into_owned(), &mut track)?;
        let wanted = track.relative_to_heading(&place.into());
        let row = y.rows(frame, 1).into_owned();
        let turned = |turns: &DVector<f64>| {
            let mut row = row.clone();
            row.iter_mut().skip(ROOT_COLUMNS.len()).zip(turns.iter()).for_each(|(column, by)| *column += by);
            row
        };
        let joints = &self.mapping.skeleton().joints;
        let mut carried = vec![1.0; joints.len()];
        for joint in (1..joints.len()).rev() {
            // A parent stands before its children.
            let parent = joints[joint].parent.unwrap_or_default();
            carried[parent] += carried[joint];
        }
        let residuals = |turns: &DVector<f64>| {
            let positions = self.positions(&turned(turns)).ok()?;
            let at = |node: usize| Vector3::from_fn(|axis, _| f64::from(positions[3 * node + axis]));
            let off = (at(node) - at(0) - wanted) / NEAR;
            let all = off
                .iter()
                .copied()
                .chain(turns.iter().enumerate().map(|(column, turn)| turn * carried[1 + column / 3] / TURN));
            Some(DVector::from_iterator(3 + turns.len(), all))
        };
        let turns = minimum(DVector::zeros(y.ncols() - ROOT_COLUMNS.len()), residuals);
        Ok((turned(&turns) - row).as_slice().to_vec())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::rollout::request::{Handles, PosePush};
    use crate::models::{Dataset, DmpSettings, Model, Settings, Trainer};
    use crate::motion::parts::{self, PartSpec};
    use crate::motion::{bvh, samples};

    fn trained(settings: Settings) -> Model {
        let clip = samples::clip("walk-1").unwrap().cut(0, 120).unwrap();
        let parts = &parts::presets(&clip.skeleton)[1].parts;
        let dataset = Dataset::new(&[(&clip).into()], parts, 30.0).unwrap();
        let mut trainer = Trainer::new(&dataset, &settings, 0).unwrap();
        while !trainer.step().done {}
        trainer.finish().unwrap()
    }

    #[test]
    fn a_dragged_hand_is_at_its_place_and_a_dmp_returns_from_there() {
        let model = trained(Settings::DmpRhythmic(DmpSettings::default()));
        let y = model.rollout(0, 90).unwrap();
        let positions = |y: &DMatrix<f64>| model.body.positions(y).unwrap();
        let nodes = model.body.mapping.skeleton().figure().len();
        let from_root = |positions: &[f32], frame: usize, node: usize| -> [f64; 3] {
            let at = |node: usize, axis: usize| f64::from(positions[3 * (frame * nodes + node) + axis]);
            std::array::from_fn(|axis| at(node, axis) - at(0, axis))
        };
        let apart = |a: [f64; 3], b: [f64; 3]| (Vector3::from(a) - Vector3::from(b)).norm();
        let hand = (0..nodes).max_by(|&a, &b| {
            let side = |node: usize| from_root(&positions(&y), 0, node)[0].abs();
            side(a).total_cmp(&side(b))
        });
        let (hand, frame) = (hand.unwrap(), 40);
        let mut place = from_root(&positions(&y), frame, hand);
        place[1] += 0.2;
        let by = model.body.dragged(&y, frame, hand, place).unwrap();
        assert!(by[..ROOT_COLUMNS.len()].iter().all(|&change| change == 0.0));
        let handles = Handles { push: Some(PosePush { frame, by }), ..Handles::default() };
        let pushed = positions(&model.rollout_with(0, 90, &handles).unwrap());
        let missed = apart(from_root(&pushed, frame, hand), place);
        assert!(missed < 0.02, "{missed}");
        let learned = positions(&y);
        let off = |frame| apart(from_root(&pushed, frame, hand), from_root(&learned, frame, hand));
        assert!(off(frame + 1) > 0.03 && off(frame + 30) < 1e-3, "{} {}", off(frame + 1), off(frame + 30));

        // At half the tempo the body goes as far in twice the frames.
        let slow = model.rollout_with(0, 179, &Handles { tempo: 0.5, ..Handles::default() }).unwrap();
        let way = |y: &DMatrix<f64>, column: usize| y.column(column).sum();
        assert!((way(&slow, 1) / way(&y, 1) - 1.0).abs() < 0.02, "{} {}", way(&slow, 1), way(&y, 1));

        let one = "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 9 0\n}\n}\nMOTION\nFrames: 3\nFrame Time: 0.1\n0 9 0 0 0 0\n0 9 1 0 0 0\n0 9 2 0 0 0\n";
        let clip = bvh::read("one.bvh", one.as_bytes()).unwrap().into_clip();
        let whole = [PartSpec { name: "body".to_owned(), joints: vec![0] }];
        let body = Body::new(&Dataset::new(&[(&clip).into()], &whole, 10.0).unwrap());
        let still = body.columns(&[DMatrix::zeros(3, 6)]);
        assert_eq!(body.dragged(&still, 1, 1, [0.0, 1.0, 0.0]), Ok(vec![0.0; 6]));

        // A frame, a node, a place, a displacement or a tempo that cannot be is refused.
        let refused = |found: Result<Vec<f64>, RolloutError>| found.unwrap_err().to_string();
        assert!(refused(model.body.dragged(&y, 90, hand, place)).contains("from 0 to 89"));
        assert!(refused(model.body.dragged(&y, frame, nodes, place)).contains("a node of the figure"));
        assert!(refused(model.body.dragged(&y, frame, hand, [0.0, f64::NAN, 0.0])).contains("finite"));
        let with = |handles| model.rollout_with(0, 90, &handles).unwrap_err().to_string();
        let short = Some(PosePush { frame, by: vec![0.0] });
        assert!(with(Handles { push: short, ..Handles::default() }).contains("displacement of the push"));
        let late = Some(PosePush { frame: 90, by: vec![0.0; y.ncols()] });
        assert!(with(Handles { push: late, ..Handles::default() }).contains("before 90, found 90"));
        assert!(with(Handles { tempo: 9.0, ..Handles::default() }).contains("a tempo from 0.25 to 2"));
    }
}
