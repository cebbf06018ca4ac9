//! Disturbed rollouts: couplings that are cut for some frames, parts that are pushed.

use crate::models::rollout::couplings::{Reading, check_couplings};
use crate::models::rollout::latent_dynamics::LatentDynamics;
use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::rollout::request::{Push, RolloutError, RolloutRequest};
use crate::models::variational::model::Vcgpdm;
use nalgebra::DMatrix;

/// The coupling variance of a source without weight; 1 / alpha does not overflow.
const SILENT: f64 = 1e90;

impl Vcgpdm {
    /// The mean dynamics with these couplings `(source, target)` cut and the others as in `alpha` [M x M]:
    /// the remaining sources share the weight of the cut ones.
    ///
    /// # Errors
    ///
    /// As [`Vcgpdm::dynamics`], and when a part does not exist or would have no source.
    pub fn dynamics_without(
        &self,
        cuts: &[(usize, usize)],
        alpha: &DMatrix<f64>,
        reading: Reading,
    ) -> Result<LatentDynamics, RolloutError> {
        check_couplings(alpha, self.part_count())?;
        self.check_parts(cuts)?;
        let mut alpha = alpha.clone();
        for &cut in cuts {
            alpha[cut] = SILENT;
        }
        let without_source = |target: &usize| alpha.column(*target).iter().all(|alpha| *alpha == SILENT);
        if let Some(target) = (0..alpha.ncols()).find(without_source) {
            return Err(RolloutError::CutOff { target });
        }
        self.dynamics(&alpha, reading)
    }

    fn check_parts(&self, cuts: &[(usize, usize)]) -> Result<(), RolloutError> {
        let count = self.part_count();
        let missing = cuts.iter().map(|(source, target)| *source.max(target)).find(|part| *part >= count);
        missing.map_or(Ok(()), |found| Err(RolloutError::Part { count, found }))
    }

    /// The latent path [frames x Q_i] of each part that a request asks for, with its cuts and pushes.
    ///
    /// # Errors
    ///
    /// When the couplings, cuts or pushes do not fit the model, a cut or a push has no frame in which it
    /// acts, there is no such sequence, or the start latents do not fit the model.
    pub fn path(&self, request: &RolloutRequest) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        let alpha = request.alpha_or(&self.alpha);
        let latent = self.latent_dimensions();
        let mut paths = LatentPaths::new(&self.start_of(request)?, self.order, &latent)?;
        let (first, end) = (paths.frames(), request.frames);
        let frames = end.max(first);
        let unfelt = |what, found| RolloutError::Unfelt { what, first, end, found };
        for push in &request.pushes {
            push.check(&latent)?;
            if !(first..end).contains(&push.frame) {
                return Err(unfelt("push", push.frame));
            }
        }
        for cut in &request.cuts {
            self.check_parts(&[(cut.source, cut.target)])?;
            if cut.from.max(first) >= cut.to.min(end) {
                return Err(unfelt("cut", cut.from));
            }
        }
        let changes = request.cuts.iter().flat_map(|cut| [cut.from, cut.to]);
        let changes: Vec<usize> = changes.chain(request.pushes.iter().map(|push| push.frame)).collect();
        let mut seen = paths.clone();
        while seen.frames() < frames {
            // Until the next change only the dynamics act.
            let from = seen.frames();
            let to = changes.iter().copied().filter(|frame| *frame > from).fold(frames, usize::min);
            for push in request.pushes.iter().filter(|push| push.frame == from) {
                paths.push(push);
            }
            let active = request.cuts.iter().filter(|cut| (cut.from..cut.to).contains(&from));
            let active: Vec<_> = active.map(|cut| (cut.source, cut.target)).collect();
            self.dynamics_without(&active, alpha, request.reading)?.extend(&mut paths, to);
            // A push changes the history of the dynamics, not the frames already shown.
            seen.follow(&paths);
        }
        Ok(seen.matrices(0..request.frames))
    }
}

impl Push {
    /// Checks that the push fits parts of these `latent` dimensions.
    ///
    /// # Errors
    ///
    /// When there is no such part, the displacement has other dimensions, or a number is not finite.
    pub fn check(&self, latent: &[usize]) -> Result<(), RolloutError> {
        let &expected =
            latent.get(self.part).ok_or(RolloutError::Part { count: latent.len(), found: self.part })?;
        let part = self.part;
        if !self.by.is_empty() && self.by.len() != expected {
            return Err(RolloutError::Push { part, expected, found: self.by.len() });
        }
        let wrong = self.by.iter().chain([&self.ahead]).find(|x| !x.is_finite());
        wrong.map_or(Ok(()), |&found| Err(RolloutError::PushNumber { part, found }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::rollout::request::Cut;
    use crate::models::variational::testing::fitted;

    fn request(frames: usize) -> RolloutRequest {
        RolloutRequest { frames, ..RolloutRequest::default() }
    }

    #[test]
    fn without_disturbances_the_path_is_that_of_the_dynamics() {
        let model = fitted(3);
        let expected =
            model.dynamics(&model.alpha, Reading::AsLearned).unwrap().path(&model.start(0, 0).unwrap(), 15);
        assert_eq!(model.path(&request(15)), expected);
        assert_eq!(model.path(&request(1)).unwrap()[0], model.start(0, 0).unwrap()[0].rows(0, 1));
    }

    #[test]
    fn a_path_goes_on_after_given_latents() {
        let model = fitted(3);
        let given: Vec<_> = model.starts[0].iter().map(|x| x.rows(1, 6).into_owned()).collect();
        let after = |given: &[DMatrix<f64>], frames| RolloutRequest {
            start: Some(given.to_vec()),
            ..request(frames)
        };
        let path = model.path(&after(&given, 15)).unwrap();
        let last: Vec<_> = given.iter().map(|x| x.rows(4, 2).into_owned()).collect();
        let expected = model.dynamics(&model.alpha, Reading::AsLearned).unwrap().path(&last, 11).unwrap();
        for part in 0..3 {
            assert_eq!(path[part].rows(0, 6), given[part]);
            assert_eq!(path[part].rows(4, 11), expected[part]);
        }
        let early = Push { part: 0, frame: 5, by: vec![1.0], ahead: 0.0 };
        let refused = |request: RolloutRequest| model.path(&request).unwrap_err().to_string();
        assert_eq!(
            refused(RolloutRequest { pushes: vec![early], ..after(&given, 15) }),
            "expected a push in a frame that is predicted, from 6 on and before 15, found 5"
        );
        assert_eq!(refused(after(&given[..2], 15)), "expected start latents of 3 parts, found 2");
        let mut uneven = given.clone();
        uneven[1] = uneven[1].rows(0, 5).into_owned();
        let words = "the start latents of part 1 must be 6 x 2 numbers, found 5 x 2";
        assert_eq!(refused(after(&uneven, 15)), words);
        assert_eq!(
            refused(RolloutRequest { frame: 4, ..after(&given, 15) }),
            "expected start latents, or a training sequence and its frame, found both: sequence 0 and frame 4"
        );
        assert_eq!(model.path(&after(&given, 3)).unwrap()[0], given[0].rows(0, 3));
    }

    #[test]
    fn samples_and_moments_go_on_after_given_latents() {
        let model = fitted(3);
        let given: Vec<_> = model.starts[0].iter().map(|x| x.rows(1, 6).into_owned()).collect();
        let last: Vec<_> = given.iter().map(|x| x.rows(4, 2).into_owned()).collect();
        let dynamics = model.predictive_dynamics(&model.alpha, Reading::AsLearned).unwrap();
        let (sample, expected) =
            (dynamics.sample(&given, 15, 4).unwrap(), dynamics.sample(&last, 11, 4).unwrap());
        let (moments, short) = (dynamics.moments(&given, 9).unwrap(), dynamics.moments(&last, 5).unwrap());
        for part in 0..3 {
            assert_eq!(sample[part].rows(0, 6), given[part]);
            assert_eq!(sample[part].rows(4, 11), expected[part]);
            assert_eq!(moments.means[part].rows(0, 6), given[part]);
            assert_eq!(moments.means[part].rows(4, 5), short.means[part]);
            assert!(moments.covariances[part][..6].iter().all(|covariance| covariance.norm() == 0.0));
            assert_eq!(moments.covariances[part][4..], short.covariances[part]);
        }
        assert_eq!(dynamics.moments(&given, 4).unwrap().means[0], given[0].rows(0, 4));
    }

    #[test]
    fn a_cut_acts_from_its_first_frame_until_its_end() {
        let model = fitted(1);
        let cut = Cut { source: 0, target: 1, from: 5, to: 8 };
        let path = model.path(&RolloutRequest { cuts: vec![cut], ..request(12) }).unwrap();
        let learned = model.path(&request(12)).unwrap();
        assert_eq!(path[1].rows(0, 5), learned[1].rows(0, 5));
        assert_ne!(path[1].row(5), learned[1].row(5));
        // During the cut the dynamics are those of the other sources, after it the learned ones.
        let go_on = |dynamics: &LatentDynamics, from: usize, to: usize| {
            let start: Vec<_> = path.iter().map(|x| x.rows(from - 2, 2).into_owned()).collect();
            dynamics.path(&start, to - from + 2).unwrap()[1].rows(2, to - from).into_owned()
        };
        let without = model.dynamics_without(&[(0, 1)], &model.alpha, Reading::AsLearned).unwrap();
        let with = model.dynamics(&model.alpha, Reading::AsLearned).unwrap();
        assert_eq!(go_on(&without, 5, 8), path[1].rows(5, 3));
        assert_eq!(go_on(&with, 8, 12), path[1].rows(8, 4));
    }

    #[test]
    fn a_push_acts_from_its_frame_on() {
        let model = fitted(1);
        let push = Push { part: 0, frame: 4, by: vec![0.5, -0.25], ahead: 1.0 };
        let path = model.path(&RolloutRequest { pushes: vec![push], ..request(8) }).unwrap();
        let learned = model.path(&request(8)).unwrap();
        assert_eq!(path[0].rows(0, 4), learned[0].rows(0, 4));
        assert_ne!(path[0].row(4), learned[0].row(4));
        assert_ne!(path[1].row(4), learned[1].row(4));
    }

    #[test]
    fn refuses_disturbances_that_do_not_fit() {
        let model = fitted(1);
        let refused = |request: RolloutRequest| model.path(&request).unwrap_err().to_string();
        let cut = |source, target| Cut { source, target, from: 3, to: 4 };
        for part in [2, 7] {
            assert_eq!(
                refused(RolloutRequest { cuts: vec![cut(0, part)], ..request(9) }),
                format!("expected a part from 0 to 1, found {part}")
            );
        }
        assert_eq!(
            refused(RolloutRequest { cuts: vec![cut(0, 1), cut(1, 1)], ..request(9) }),
            "expected one coupling into part 1 that is not cut, found none: nothing would say where it goes"
        );
        let push = Push { part: 0, frame: 3, by: vec![1.0], ahead: 0.0 };
        assert_eq!(
            refused(RolloutRequest { pushes: vec![push], ..request(9) }),
            "expected a push of part 0 by 2 finite numbers, one for each latent dimension, found 1"
        );
        let push = |frame, by| Push { part: 0, frame, by: vec![by, 1.0], ahead: 0.0 };
        assert_eq!(
            refused(RolloutRequest { pushes: vec![push(3, f64::NAN)], ..request(9) }),
            "expected a push of part 0 by finite numbers, found NaN"
        );
        for frame in [1, 9] {
            assert_eq!(
                refused(RolloutRequest { pushes: vec![push(frame, 1.0)], ..request(9) }),
                format!(
                    "expected a push in a frame that is predicted, from 2 on and before 9, found {frame}"
                )
            );
        }
        for (from, to) in [(0, 2), (9, 12)] {
            let cut = Cut { source: 0, target: 1, from, to };
            assert_eq!(
                refused(RolloutRequest { cuts: vec![cut], ..request(9) }),
                format!("expected a cut in a frame that is predicted, from 2 on and before 9, found {from}")
            );
        }
    }
}
