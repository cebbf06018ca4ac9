//! How many points lie: around their mean, in a Gaussian, and along a path.

use nalgebra::{DMatrix, DVector};

/// Of the squared length of three independent standard Gaussian numbers, 95 % are smaller.
const WITHIN_3: f64 = 7.815;

/// A future may be early or late by so many frames: less than half a lap of a walk at 30 frames a second.
const FRAMES_APART: usize = 15;

/// Points of one latent space.
pub struct Cloud {
    points: Vec<DVector<f64>>,
    pub mean: DVector<f64>,
    covariance: DMatrix<f64>,
    /// Root mean square deviation from the mean, over all dimensions.
    pub deviation: f64,
}

impl Cloud {
    pub fn of(points: Vec<DVector<f64>>) -> Self {
        let (count, width) = (points.len() as f64, points[0].len());
        let mean = points.iter().sum::<DVector<f64>>() / count;
        let mut covariance = DMatrix::zeros(width, width);
        for apart in points.iter().map(|x| x - &mean) {
            covariance += &apart * apart.transpose() / (count - 1.0);
        }
        let deviation = rms(covariance.diagonal().iter().copied());
        Self { points, mean, covariance, deviation }
    }

    /// The share of the points outside the region that holds 95 % of a Gaussian of three dimensions.
    pub fn share_outside(&self, mean: &DVector<f64>, covariance: &DMatrix<f64>) -> f64 {
        assert_eq!(mean.len(), 3, "the region is that of three dimensions");
        let outside = distances(&self.points, mean, covariance).into_iter().filter(|d| *d > WITHIN_3);
        outside.count() as f64 / self.points.len() as f64
    }

    /// The mean fourth power of the distance from the mean, in deviations, as a multiple of a Gaussian's: above 1 a few points are
    /// far out, below 1 the points lie around an empty middle.
    pub fn tails(&self) -> f64 {
        let width = self.mean.len() as f64;
        let squares = distances(&self.points, &self.mean, &self.covariance);
        squares.iter().map(|d| d * d).sum::<f64>() / self.points.len() as f64 / (width * (width + 2.0))
    }

    /// How far the points are early or late, in frames: root mean square of the frames from `t` to the frame of the nearest point
    /// of a path [frames x Q].
    pub fn timing(&self, path: &DMatrix<f64>, t: usize) -> f64 {
        let frames = t.saturating_sub(FRAMES_APART)..=(t + FRAMES_APART).min(path.nrows() - 1);
        let lag = |x: &DVector<f64>| {
            let distance = |frame: usize| (path.row(frame).transpose() - x).norm_squared();
            let nearest = frames.clone().min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
            nearest.map_or(0.0, |nearest| nearest as f64 - t as f64)
        };
        rms(self.points.iter().map(|x| lag(x).powi(2)))
    }
}

/// Squared distance of each point from the mean, in deviations.
fn distances(points: &[DVector<f64>], mean: &DVector<f64>, covariance: &DMatrix<f64>) -> Vec<f64> {
    let factor = covariance.clone().cholesky().unwrap();
    points.iter().map(|x| (x - mean).dot(&factor.solve(&(x - mean)))).collect()
}

/// The root of the mean of squares.
pub fn rms(squares: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = squares.len() as f64;
    (squares.sum::<f64>() / count).sqrt()
}
