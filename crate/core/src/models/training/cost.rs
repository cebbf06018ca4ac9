//! Estimated time and memory of a training, to warn of a training that would take very long.

use crate::models::training::settings::{MapSettings, Settings, VariationalSettings};
use serde::Serialize;
use std::iter::Sum;

/// Seconds of one step of the sums over rows: a few multiplications, four at a time, natively on one core of
/// a usual machine. `npm run lab -- scaling` prints measured next to estimated times.
const ROW_STEP: f64 = 6e-10;
/// Seconds of one step for an entry of a covariance, one at a time.
const ENTRY_STEP: f64 = 1e-9;
/// Seconds of one of the N^3 steps of a factor and its inverse, in blocks.
const DENSE_STEP: f64 = 5e-11;
/// Mean number of evaluations of the bound in an iteration; some line searches need a second one.
const EVALUATIONS: f64 = 1.06;
/// Vectors of all parameters in the optimiser: 20 pairs of steps and gradients, and those of its line search.
const OPTIMISER_VECTORS: f64 = 60.0;

/// Estimated cost of a training on one core, right to a factor of about two.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
#[non_exhaustive]
pub struct TrainingCost {
    /// Seconds of one evaluation of the bound, or the density, with its gradient.
    #[serde(skip)]
    pub evaluation_seconds: f64,
    /// Seconds for all iterations; a training whose bound settles ends sooner.
    pub seconds: f64,
    /// Bytes of memory.
    pub bytes: f64,
}

impl VariationalSettings {
    /// The cost of a training on `frames` frames of parts with these numbers of `columns`.
    pub fn cost(&self, frames: usize, columns: &[usize]) -> TrainingCost {
        let d = columns.iter().sum::<usize>() as f64;
        let [n, m, q, p, l, k] =
            [frames, columns.len(), self.latent, self.order, self.pose_ips, self.dynamics_ips]
                .map(|count| count as f64);
        let (pose_pairs, pairs) = (l * (l + 1.0) / 2.0, k * (k + 1.0) / 2.0);
        // For each frame: psi2 and psi1 with the observations of every pose map; psi2 of every expert and of
        // every pair of experts, and psi1.
        let poses = m * pose_pairs * (1.0 + q) + l * d;
        let dynamics = m * m * (pairs * (1.0 + p * q) + (m - 1.0) / 2.0 * k * k + k * q);
        let factors = m * ((m * k).powi(3) + l.powi(3));
        let evaluation_seconds = ROW_STEP * (n * (poses + dynamics) + factors);
        let parameters = 2.0 * n * m * q + m * l * q + m * m * k * p * q;
        // The terms of psi2 are stored for the gradient.
        let scratch = m * pairs + pose_pairs + 2.0 * d + m * (2.0 * l + 2.0 * k + 4.0 * p * q);
        let numbers = parameters * OPTIMISER_VECTORS + n * scratch + 8.0 * m * (m * k).powi(2);
        TrainingCost::new(evaluation_seconds, self.max_iterations, numbers)
    }
}

impl MapSettings {
    /// As for variational models. The time grows with the cube of the frames and the memory with their
    /// square, because every map is a Gaussian process over all frames.
    pub fn cost(&self, frames: usize, columns: &[usize]) -> TrainingCost {
        let d = columns.iter().sum::<usize>() as f64;
        let [n, m, q, p] = [frames, columns.len(), self.latent, self.order].map(|count| count as f64);
        // Each part has two covariances: of its poses, and of its dynamics with an expert from each part.
        let factors = DENSE_STEP * 2.0 * m * n.powi(3);
        let kernels = ENTRY_STEP * n * n * (m * (2.0 + 2.0 * q) + m * m * (2.0 + 2.0 * p * q));
        // The kernel of each expert, the covariance, its factor, its inverse and their products.
        let numbers = n * m * q * OPTIMISER_VECTORS + (m + 5.0) * n * n + 4.0 * n * d;
        TrainingCost::new(factors + kernels, self.max_iterations, numbers)
    }
}

impl Settings {
    /// As for variational models. A model without couplings has all columns in one part. 0 for TMP and DMP,
    /// which cost little compared with the others.
    pub fn cost(&self, frames: usize, columns: &[usize]) -> TrainingCost {
        let whole = [columns.iter().sum()];
        let columns = if self.kind().is_coupled() { columns } else { &whole };
        match self {
            Self::Vcgpdm(settings) | Self::Vgpdm(settings) => settings.cost(frames, columns),
            Self::MapGpdm(settings) | Self::MapCgpdm(settings) => settings.cost(frames, columns),
            Self::Tmp(_) | Self::DmpDiscrete(_) | Self::DmpRhythmic(_) => TrainingCost::default(),
        }
    }
}

impl TrainingCost {
    fn new(evaluation_seconds: f64, iterations: usize, numbers: f64) -> Self {
        let seconds = evaluation_seconds * EVALUATIONS * iterations as f64;
        Self { evaluation_seconds, seconds, bytes: 8.0 * numbers }
    }
}

impl Sum for TrainingCost {
    /// The cost of trainings one after the other: the memory is that of the largest.
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |a, b| Self {
            evaluation_seconds: a.evaluation_seconds + b.evaluation_seconds,
            seconds: a.seconds + b.seconds,
            bytes: a.bytes.max(b.bytes),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn costs_of_variational_models_grow_with_frames_and_points() {
        let usual = VariationalSettings::default();
        let cost = |frames| usual.cost(frames, &[30, 30]);
        let (short, long) = (cost(1000), cost(2000));
        assert!((1.9..2.0).contains(&(long.evaluation_seconds / short.evaluation_seconds)));
        assert!((1.9..2.0).contains(&(long.bytes / short.bytes)));
        let twice = VariationalSettings { max_iterations: 2 * usual.max_iterations, ..usual.clone() };
        assert_eq!(twice.cost(1000, &[30, 30]).seconds, 2.0 * short.seconds);
        let points = VariationalSettings { dynamics_ips: 120, pose_ips: 120, ..usual };
        assert!(points.cost(1000, &[30, 30]).seconds > 80.0 * short.seconds);
    }

    /// By hand, for one frame of one column: 4 latent means and variances, 2 poses of 2 dimensions and 3 points of 4
    /// are parameters.
    #[test]
    fn the_memory_of_a_small_training() {
        let small =
            VariationalSettings { latent: 2, order: 2, pose_ips: 2, dynamics_ips: 3, ..Default::default() };
        let parameters = 4.0 + 4.0 + 12.0;
        let scratch = 6.0 + 3.0 + 2.0 + (4.0 + 6.0 + 16.0);
        let numbers = parameters * OPTIMISER_VECTORS + scratch + 8.0 * 9.0;
        assert_eq!(small.cost(1, &[1]).bytes, TrainingCost::new(0.0, 1, numbers).bytes);
    }

    /// By hand, for ten frames of three and four columns: the steps of each frame, and those of the factors.
    #[test]
    fn the_time_of_a_small_training() {
        let small =
            VariationalSettings { latent: 2, order: 2, pose_ips: 4, dynamics_ips: 3, ..Default::default() };
        let poses = 2.0 * 10.0 * 3.0 + 4.0 * 7.0;
        let dynamics = 4.0 * (6.0 * 5.0 + 4.5 + 3.0 * 2.0);
        let factors = 2.0 * (216.0 + 64.0);
        let seconds = ROW_STEP * (10.0 * (poses + dynamics) + factors);
        assert_relative_eq!(small.cost(10, &[3, 4]).evaluation_seconds, seconds, max_relative = 1e-12);
        let map = MapSettings { latent: 2, order: 2, ..Default::default() };
        let entries = 100.0 * (2.0 * 6.0 + 4.0 * 10.0);
        let seconds = DENSE_STEP * 4000.0 + ENTRY_STEP * entries;
        assert_relative_eq!(map.cost(10, &[3, 4]).evaluation_seconds, seconds, max_relative = 1e-12);
    }

    #[test]
    fn costs_of_map_models_grow_with_the_cube_of_the_frames() {
        let map = Settings::MapCgpdm(MapSettings::default());
        let [short, long] = [2000, 4000].map(|frames| map.cost(frames, &[30, 30]));
        assert!((7.0..8.0).contains(&(long.seconds / short.seconds)));
        assert!((3.9..4.0).contains(&(long.bytes / short.bytes)));
        let one = Settings::MapGpdm(MapSettings::default());
        assert_eq!(one.cost(2000, &[30, 30]), one.cost(2000, &[60]));
        assert!(one.cost(2000, &[60]).seconds < short.seconds);
        let tmp = Settings::Tmp(crate::models::TmpSettings::default());
        assert_eq!(tmp.cost(2000, &[60]), TrainingCost::default());
        let both: TrainingCost = [short, long].into_iter().sum();
        assert_eq!((both.seconds, both.bytes), (short.seconds + long.seconds, long.bytes));
    }
}
