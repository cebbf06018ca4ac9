//! The filter over a whole clip, and the smoother.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetrise};
use crate::models::variational::filter::error::ObservationError;
use crate::models::variational::filter::step::Filter;
use crate::models::variational::moments::{Belief, LatentMoments};
use nalgebra::DMatrix;

/// The beliefs of a filter over the frames of a clip.
#[derive(Clone, Debug)]
pub struct Filtered {
    /// The belief after the frame p - 1 and each later one, when the frames so far are observed.
    pub beliefs: Vec<Belief>,
    /// The Gaussian about each history and the next latents, before the next frame is observed.
    joints: Vec<Belief>,
    /// log p(y_t | y_0 .. y_{t-1}) of every frame, in nats.
    pub log_densities: Vec<f64>,
}

impl Filtered {
    /// log p(y) of all frames, in nats.
    pub fn evidence(&self) -> f64 {
        self.log_densities.iter().sum()
    }
}

impl Filter {
    /// Filters the observed columns of all parts, [frames x D_i] each, from a belief about the first p frames
    /// before any of them is observed.
    ///
    /// # Errors
    ///
    /// When the columns do not fit the model, there are fewer than p frames, a number is infinite, or a
    /// covariance cannot be factorised.
    pub fn run(&self, start: Belief, y: &[DMatrix<f64>]) -> Result<Filtered, ObservationError> {
        let frames = self.check(y)?;
        let row =
            |t: usize| -> Vec<Vec<f64>> { y.iter().map(|y| y.row(t).iter().copied().collect()).collect() };
        let mut belief = start;
        let mut log_densities = Vec::with_capacity(frames);
        for t in 0..self.order() {
            log_densities.push(self.correct(&mut belief, self.order() - 1 - t, &row(t))?);
        }
        let (mut beliefs, mut joints) = (vec![belief.clone()], Vec::new());
        for t in self.order()..frames {
            let joint = self.dynamics.joint(&belief)?;
            belief = self.dynamics.advanced(&joint);
            log_densities.push(self.correct(&mut belief, 0, &row(t))?);
            beliefs.push(belief.clone());
            joints.push(joint);
        }
        Ok(Filtered { beliefs, joints, log_densities })
    }

    /// Checks the columns of all parts, and returns the number of frames.
    pub(in crate::models) fn check(&self, y: &[DMatrix<f64>]) -> Result<usize, ObservationError> {
        if y.len() != self.poses.len() {
            return Err(ObservationError::Parts { expected: self.poses.len(), found: y.len() });
        }
        let frames = y.first().map_or(0, DMatrix::nrows);
        for (part, (y, expected)) in y.iter().zip(self.columns()).enumerate() {
            if y.ncols() != expected {
                return Err(ObservationError::Columns { part, expected, found: y.ncols() });
            }
            if y.nrows() != frames {
                return Err(ObservationError::Frames { part, expected: frames, found: y.nrows() });
            }
            for (frame, row) in y.row_iter().enumerate() {
                if let Some(&found) = row.iter().find(|value| value.is_infinite()) {
                    return Err(ObservationError::NotFinite { part, frame, found });
                }
            }
        }
        if frames < self.order() {
            return Err(ObservationError::Short { least: self.order(), found: frames });
        }
        Ok(frames)
    }

    /// Means and covariances of the latents of every frame, given the frames until then.
    pub fn filtered(&self, run: &Filtered) -> LatentMoments {
        self.moments_of(&run.beliefs)
    }

    /// Means and covariances of the latents of every frame, given all frames.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn smoothed(&self, run: &Filtered) -> Result<LatentMoments, NumericsError> {
        let mut beliefs = run.beliefs.clone();
        for t in (0..run.joints.len()).rev() {
            beliefs[t] = self.smooth(&run.beliefs[t], &run.joints[t], &beliefs[t + 1])?;
        }
        Ok(self.moments_of(&beliefs))
    }

    /// The belief about a history given all frames, from that about the `next` history given all frames.
    fn smooth(&self, belief: &Belief, joint: &Belief, next: &Belief) -> Result<Belief, NumericsError> {
        let (places, size) = (self.dynamics.advanced_places(), belief.mean.len());
        let predicted = self.dynamics.advanced(joint);
        let oldest: Vec<usize> =
            (0..self.poses.len()).flat_map(|i| self.places(i, self.order() - 1)).collect();
        // J^T = P^-1 cov(h', o).
        let gain = DMatrix::from_fn(size, oldest.len(), |row, o| joint.covariance[(places[row], oldest[o])]);
        let gain = Factor::new(&predicted.covariance, "covariance of the predicted latents")?.solve(&gain);
        let change = gain.tr_mul(&(&next.mean - &predicted.mean));
        let across = next.covariance.tr_mul(&gain);
        let own = gain.tr_mul(&((&next.covariance - &predicted.covariance) * &gain));
        let (mut mean, mut covariance) = (belief.mean.clone(), belief.covariance.clone());
        // The later frames of the history are in the next history too.
        let kept: Vec<(usize, usize)> =
            places.iter().copied().enumerate().filter(|(_, old)| *old < size).collect();
        for &(new, old) in &kept {
            mean[old] = next.mean[new];
            for &(other_new, other_old) in &kept {
                covariance[(old, other_old)] = next.covariance[(new, other_new)];
            }
            for (o, &place) in oldest.iter().enumerate() {
                covariance[(place, old)] = across[(new, o)];
                covariance[(old, place)] = across[(new, o)];
            }
        }
        for (o, &place) in oldest.iter().enumerate() {
            mean[place] += change[o];
            for (p, &other) in oldest.iter().enumerate() {
                covariance[(place, other)] += own[(o, p)];
            }
        }
        symmetrise(&mut covariance);
        for k in 0..size {
            covariance[(k, k)] = covariance[(k, k)].max(0.0);
        }
        Ok(Belief { mean, covariance })
    }

    /// The latents of every frame: the first belief is about the first p frames, each later one about one
    /// more.
    fn moments_of(&self, beliefs: &[Belief]) -> LatentMoments {
        let lags = |first: bool| if first { (0..self.order()).rev() } else { (0..1).rev() };
        let (mut means, mut covariances) = (Vec::new(), Vec::new());
        for part in 0..self.poses.len() {
            let each = beliefs.iter().enumerate();
            let each = each.flat_map(|(t, belief)| lags(t == 0).map(move |lag| (belief, lag)));
            let (rows, own): (Vec<_>, Vec<_>) =
                each.map(|(belief, lag)| self.latents(belief, part, lag)).unzip();
            means.push(DMatrix::from_fn(rows.len(), self.poses[part].latent(), |t, q| rows[t][q]));
            covariances.push(own);
        }
        LatentMoments { means, covariances }
    }
}
