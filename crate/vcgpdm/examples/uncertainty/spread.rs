//! How many points lie: around their mean, in a Gaussian, and along a path.

use nalgebra::{DMatrix, DVector};

/// Of the squared length of three independent standard Gaussian numbers, 95 % are smaller.
const WITHIN_3: f64 = 7.815;

/// How early or late a point can be, in frames: less than half a lap of a walk at 30 frames a second.
const FARTHEST: usize = 16;

/// So many frames early or late is out of time: an eighth of a second.
const OUT_OF_TIME: usize = 4;

/// Points of one latent space.
pub struct Cloud {
    points: Vec<DVector<f64>>,
    pub mean: DVector<f64>,
    /// Root mean square deviation from the mean, over all dimensions.
    pub deviation: f64,
}

/// How many points are outside the region that holds 95 % of a Gaussian, and how many are out of time.
pub struct Region {
    pub outside: usize,
    pub out_of_time_inside: usize,
    pub out_of_time_outside: usize,
}

impl Cloud {
    pub fn of(points: Vec<DVector<f64>>) -> Self {
        let count = points.len() as f64;
        let mean = points.iter().sum::<DVector<f64>>() / count;
        let squares: f64 = points.iter().map(|x| (x - &mean).norm_squared()).sum();
        let deviation = (squares / (count - 1.0) / mean.len() as f64).sqrt();
        Self { points, mean, deviation }
    }

    pub fn count(&self) -> usize {
        self.points.len()
    }

    /// The region is that of three latent dimensions; a point is early or late beside frame `t` of the path [frames x Q].
    pub fn region(
        &self,
        mean: &DVector<f64>,
        covariance: &DMatrix<f64>,
        path: &DMatrix<f64>,
        t: usize,
    ) -> Region {
        assert_eq!(mean.len(), 3, "the region is that of three dimensions");
        let factor = covariance.clone().cholesky().unwrap();
        let mut region = Region { outside: 0, out_of_time_inside: 0, out_of_time_outside: 0 };
        for x in &self.points {
            let apart = x - mean;
            let is_outside = apart.dot(&factor.solve(&apart)) > WITHIN_3;
            let out_of_time = usize::from(nearest(x, path, t).abs_diff(t) >= OUT_OF_TIME);
            if is_outside {
                region.outside += 1;
                region.out_of_time_outside += out_of_time;
            } else {
                region.out_of_time_inside += out_of_time;
            }
        }
        region
    }
}

/// The frame around `t` in which a path [frames x Q] comes nearest to a point.
fn nearest(x: &DVector<f64>, path: &DMatrix<f64>, t: usize) -> usize {
    let distance = |frame: usize| (path.row(frame).transpose() - x).norm_squared();
    let frames = t.saturating_sub(FARTHEST)..path.nrows().min(t + FARTHEST + 1);
    frames.min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap_or(t)
}

/// The root of the mean of squares.
pub fn rms(squares: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = squares.len() as f64;
    (squares.sum::<f64>() / count).sqrt()
}
