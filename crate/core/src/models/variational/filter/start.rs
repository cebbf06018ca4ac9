//! Where in the movement a recording starts.

use crate::models::variational::filter::error::ObservationError;
use crate::models::variational::filter::run::Filtered;
use crate::models::variational::filter::step::Filter;
use crate::models::variational::moments::Belief;
use nalgebra::{DMatrix, DVector};

/// Starting points that are tried for a whole recording.
const STARTS: usize = 8;
/// The covariance of a starting point is that of all histories of the training times this.
const SPREAD: f64 = 0.1;
/// The least variance of a latent at a starting point.
const LEAST: f64 = 1e-3;

/// A frame of a reference path.
#[derive(Clone, Copy)]
struct Place {
    path: usize,
    frame: usize,
    /// The mean squared error of the observed columns, in units of the observation noise.
    error: f64,
}

impl Filter {
    /// Filters observed columns, [frames x D_i] of each part, from the likeliest place of the movement.
    ///
    /// The prior of the first latents has many modes: the histories of the training. Those whose next
    /// `window` frames are nearest to the observed ones are starting points; the filter runs over the
    /// window from each of them, and the one under which these frames are likeliest is the start.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run).
    pub fn run_from_best(&self, y: &[DMatrix<f64>], window: usize) -> Result<Filtered, ObservationError> {
        let frames = self.check(y)?;
        let part = self.first_window(y, window);
        match self.likeliest(&part, STARTS) {
            Some((_, run)) if part[0].nrows() == frames => Ok(run),
            Some((start, _)) => self.run(start, y),
            None => self.run(self.unknown(), y),
        }
    }

    /// The frames of checked columns until `window` frames after the first one with a number.
    pub(super) fn first_window(&self, y: &[DMatrix<f64>], window: usize) -> Vec<DMatrix<f64>> {
        let frames = y[0].nrows();
        let first = (0..frames).find(|&t| y.iter().any(|y| y.row(t).iter().any(|value| !value.is_nan())));
        let window = (first.unwrap_or(0) + window).clamp(self.order(), frames);
        y.iter().map(|y| y.rows(0, window).into_owned()).collect()
    }

    /// The starting point under which these frames are the likeliest, and the filter from there; `None` if it
    /// fails from each of them. At most `starts` points are tried.
    pub(crate) fn likeliest(&self, y: &[DMatrix<f64>], starts: usize) -> Option<(Belief, Filtered)> {
        let mut best: Option<(f64, Belief, Filtered)> = None;
        for start in self.starts(y, starts) {
            // A start from which the numbers run away is not the place.
            let Ok(run) = self.run(start.clone(), y) else { continue };
            let evidence = run.evidence();
            if evidence.is_finite() && best.as_ref().is_none_or(|(most, ..)| evidence > *most) {
                best = Some((evidence, start, run));
            }
        }
        best.map(|(_, start, run)| (start, run))
    }

    /// Beliefs about the first p frames of these observed columns.
    pub(super) fn starts(&self, y: &[DMatrix<f64>], most: usize) -> Vec<Belief> {
        let covariance = self.history_covariance();
        let mut places = self.places_by_error(y);
        places.sort_by(|a, b| a.error.total_cmp(&b.error));
        let apart = (y[0].nrows() / 4).max(1);
        let mut chosen: Vec<Place> = Vec::new();
        for place in places {
            let near = |other: &Place| other.path == place.path && other.frame.abs_diff(place.frame) < apart;
            if chosen.len() < most && !chosen.iter().any(near) {
                chosen.push(place);
            }
        }
        let belief = |place: &Place| Belief {
            mean: self.history(place.path, place.frame),
            covariance: covariance.clone(),
        };
        chosen.iter().map(belief).collect()
    }

    /// The error at every frame of the reference paths that has a whole history after it.
    fn places_by_error(&self, y: &[DMatrix<f64>]) -> Vec<Place> {
        let observed: Vec<Vec<Vec<usize>>> = y
            .iter()
            .map(|y| y.row_iter().map(|row| (0..row.len()).filter(|&c| !row[c].is_nan()).collect()).collect())
            .collect();
        let mut places = Vec::new();
        for (path, latents) in self.references.iter().enumerate() {
            let frames = latents.first().map_or(0, DMatrix::nrows);
            let poses: Vec<DMatrix<f64>> =
                self.poses.iter().zip(latents).map(|(map, x)| map.observations(x)).collect();
            for frame in 0..(frames + 1).saturating_sub(self.order()) {
                let (mut error, mut count) = (0.0, 0);
                for t in 0..y[0].nrows().min(frames - frame) {
                    for (part, (y, map)) in y.iter().zip(&self.poses).enumerate() {
                        let columns = &observed[part][t];
                        let square =
                            |c: &usize| (y[(t, *c)] - poses[part][(frame + t, *c)]).powi(2) / map.noise();
                        error += columns.iter().map(square).sum::<f64>();
                        count += columns.len();
                    }
                }
                places.push(Place { path, frame, error: error / count.max(1) as f64 });
            }
        }
        places
    }

    /// The means of p frames of a reference path from `frame` on.
    fn history(&self, path: usize, frame: usize) -> DVector<f64> {
        let p = self.order();
        let part = |x: &DMatrix<f64>| x.rows(frame, p).transpose().as_slice().to_vec();
        DVector::from_vec(self.references[path].iter().flat_map(part).collect())
    }

    /// The covariance of a starting point: the histories of the training are far apart along the movement,
    /// and near each other across it.
    fn history_covariance(&self) -> DMatrix<f64> {
        let p = self.order();
        let frames = |path: &Vec<DMatrix<f64>>| path.first().map_or(0, |x| (x.nrows() + 1).saturating_sub(p));
        let all = self.references.iter().enumerate();
        let all: Vec<DVector<f64>> =
            all.flat_map(|(k, path)| (0..frames(path)).map(move |frame| self.history(k, frame))).collect();
        let size = self.unknown().mean.len();
        let count = all.len().max(1) as f64;
        let mean = all.iter().fold(DVector::zeros(size), |sum: DVector<f64>, h| sum + h) / count;
        let mut covariance = DMatrix::identity(size, size) * LEAST;
        for history in &all {
            let apart = history - &mean;
            covariance.ger(SPREAD / count, &apart, &apart, 1.0);
        }
        covariance
    }

    /// The prior of the first p frames, N(0, I).
    pub fn unknown(&self) -> Belief {
        let size = self.poses.iter().map(|map| map.latent()).sum::<usize>() * self.order();
        Belief { mean: DVector::zeros(size), covariance: DMatrix::identity(size, size) }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::models::rollout::couplings::Reading;
    use crate::models::training::pose_weight::PoseWeight;
    use crate::models::variational::testing::fitted;
    use approx::assert_relative_eq;
    use nalgebra::DMatrix;

    #[test]
    fn the_error_of_a_place_counts_what_is_observed_there_in_units_of_the_noise() {
        let model = fitted(1);
        let filter = model.filter(&model.alpha, Reading::AsLearned, PoseWeight::default()).unwrap();
        let latents = &model.starts[0];
        let frames = latents[0].nrows();
        // Each column is three standard deviations off from frame 1 on; of one, nothing is known.
        let window = |frame: usize, count: usize| -> Vec<DMatrix<f64>> {
            let part = |(part, x): (usize, &DMatrix<f64>)| {
                let mut y = filter.poses[part].observations(&x.rows(frame, count).into_owned());
                y.add_scalar_mut(3.0 * model.parts[part].beta().sqrt());
                y.column_mut(part).fill(f64::NAN);
                y
            };
            latents.iter().enumerate().map(part).collect()
        };
        let places = filter.places_by_error(&window(1, frames - 1));
        let of_each = model.starts.iter().map(|x| x[0].nrows() + 1 - filter.order());
        assert_eq!(places.len(), of_each.sum::<usize>());
        assert_relative_eq!(places[1].error, 9.0, epsilon = 1e-9);
        // Numbers that run away have no likeliest place.
        let far: Vec<_> = window(1, 5).iter().map(|y| y * 1e200).collect();
        assert!(filter.likeliest(&far, 8).is_none());
        // The path ends before the window does.
        let mut late = window(frames - 3, 3);
        late.iter_mut().for_each(|y| *y = y.clone().insert_rows(3, 5, 0.0));
        let found = &filter.places_by_error(&late)[frames - 3];
        assert_eq!((found.path, found.frame), (0, frames - 3));
        assert_relative_eq!(found.error, 9.0, epsilon = 1e-9);
    }
}
