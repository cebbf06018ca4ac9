//! Where points are, relative to their mean, to a Gaussian and to a path.

use nalgebra::{DMatrix, DVector};

/// The 95 % quantile of the squared length of three independent standard Gaussian numbers.
const WITHIN_3: f64 = 7.815;

/// How early or late a point can be, in frames: less than half a lap of a walk at 30 frames a second.
const FARTHEST: usize = 16;

/// From this number of frames on, a point is early or late: an eighth of a second.
const OUT_OF_TIME: usize = 4;

/// Points of one latent space.
pub struct Cloud {
    points: Vec<DVector<f64>>,
    pub mean: DVector<f64>,
    /// Root mean square deviation from the mean, over all dimensions.
    pub deviation: f64,
}

/// Points inside or outside the region that holds 95 % of a Gaussian.
#[derive(Default)]
pub struct Group {
    pub count: usize,
    pub out_of_time: usize,
    distances: Vec<f64>,
}

impl Group {
    fn add(&mut self, (frame, distance): (usize, f64), t: usize) {
        self.count += 1;
        self.out_of_time += usize::from(frame.abs_diff(t) >= OUT_OF_TIME);
        self.distances.push(distance);
    }

    /// The median distance from the path.
    pub fn off_path(&self) -> Option<f64> {
        let mut distances = self.distances.clone();
        distances.sort_by(f64::total_cmp);
        distances.get(distances.len() / 2).copied()
    }
}

impl Cloud {
    pub fn new(points: Vec<DVector<f64>>) -> Self {
        let count = points.len() as f64;
        let mean = points.iter().sum::<DVector<f64>>() / count;
        let squares: f64 = points.iter().map(|x| (x - &mean).norm_squared()).sum();
        let deviation = (squares / (count - 1.0) / mean.len() as f64).sqrt();
        Self { points, mean, deviation }
    }

    /// The points inside and outside the region; a point is early or late compared with frame `t` of the
    /// path [frames x Q].
    pub fn groups(
        &self,
        mean: &DVector<f64>,
        covariance: &DMatrix<f64>,
        path: &DMatrix<f64>,
        t: usize,
    ) -> [Group; 2] {
        assert_eq!(mean.len(), 3, "the region is that of three dimensions");
        let factor = covariance.clone().cholesky().unwrap();
        let mut groups = [Group::default(), Group::default()];
        for x in &self.points {
            let apart = x - mean;
            let is_outside = apart.dot(&factor.solve(&apart)) > WITHIN_3;
            groups[usize::from(is_outside)].add(nearest(x, path, t), t);
        }
        groups
    }
}

/// The frame around `t` in which a path [frames x Q] is nearest to a point, and the distance.
fn nearest(x: &DVector<f64>, path: &DMatrix<f64>, t: usize) -> (usize, f64) {
    let frames = t.saturating_sub(FARTHEST)..path.nrows().min(t + FARTHEST + 1);
    let distances = frames.map(|frame| (frame, (path.row(frame).transpose() - x).norm()));
    distances.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((t, f64::NAN))
}

/// The root of the mean of squares.
pub fn rms(squares: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = squares.len() as f64;
    (squares.sum::<f64>() / count).sqrt()
}
