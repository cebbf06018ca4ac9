//! What a training will cost, before it begins: so that one that would take a day, or more memory than there
//! is, is not begun unawares.

use crate::models::training::settings::{MapSettings, Settings, VariationalSettings};
use std::iter::Sum;

/// Seconds of one step of the sums over rows, a few multiplications four at a time, of the native program on
/// one core of a usual machine. `npm run lab -- scaling` prints measured next to estimated times.
const ROW_STEP: f64 = 6e-10;
/// The same of a covariance's entry, one at a time.
const ENTRY_STEP: f64 = 1e-9;
/// Seconds of one of the N^3 steps of a factor and its inverse, by blocks, on the same machine.
const DENSE_STEP: f64 = 5e-11;
/// Evaluations of the bound in an iteration: now and then a line search needs a second one.
const EVALUATIONS: f64 = 1.06;
/// Vectors of all parameters that the optimiser holds: 20 pairs of steps and gradients, and those of its line
/// search.
const OPTIMISER_VECTORS: f64 = 60.0;

/// What a training will cost on one core: an estimate, good to a factor of two or so.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrainingCost {
    /// Seconds of one evaluation of the bound, or the density, with its gradient.
    pub evaluation_seconds: f64,
    /// Seconds until all iterations are used; a bound that settles ends the training sooner.
    pub seconds: f64,
    /// Bytes of memory.
    pub bytes: f64,
}

impl VariationalSettings {
    /// What a training on so many frames costs, of parts with so many `columns` each.
    pub fn cost(&self, frames: usize, columns: &[usize]) -> TrainingCost {
        let d = columns.iter().sum::<usize>() as f64;
        let [n, m, q, p, l, k] =
            [frames, columns.len(), self.latent, self.order, self.pose_ips, self.dynamics_ips]
                .map(|count| count as f64);
        let (pose_pairs, pairs) = (l * (l + 1.0) / 2.0, k * (k + 1.0) / 2.0);
        // Of each frame: psi2 and psi1 with the observations of every pose map; psi2 of every expert, psi2 of
        // every two experts, psi1.
        let poses = m * pose_pairs * (1.0 + q) + l * d;
        let dynamics = m * m * (pairs * (1.0 + p * q) + (m - 1.0) / 2.0 * k * k + k * q);
        let factors = m * ((m * k).powi(3) + l.powi(3));
        let evaluation_seconds = ROW_STEP * (n * (poses + dynamics) + factors);
        let parameters = 2.0 * n * m * q + m * l * q + m * m * k * p * q;
        // The summands of psi2 are kept for the gradient.
        let rooms = m * pairs + pose_pairs + 2.0 * d + m * (2.0 * l + 2.0 * k + 4.0 * p * q);
        let numbers = parameters * OPTIMISER_VECTORS + n * rooms + 8.0 * m * (m * k).powi(2);
        TrainingCost::of(evaluation_seconds, self.max_iterations, numbers)
    }
}

impl MapSettings {
    /// As for variational models. It grows with the cube of the frames, and its memory with their square:
    /// every map is a Gaussian process over all frames.
    pub fn cost(&self, frames: usize, columns: &[usize]) -> TrainingCost {
        let d = columns.iter().sum::<usize>() as f64;
        let [n, m, q, p] = [frames, columns.len(), self.latent, self.order].map(|count| count as f64);
        // Of each part two covariances: that of its poses, and that of its dynamics, of an expert from each
        // part.
        let factors = DENSE_STEP * 2.0 * m * n.powi(3);
        let kernels = ENTRY_STEP * n * n * (m * (2.0 + 2.0 * q) + m * m * (2.0 + 2.0 * p * q));
        // An expert's kernel each, the covariance, its factor, its inverse, and what is on the way between
        // them.
        let numbers = n * m * q * OPTIMISER_VECTORS + (m + 5.0) * n * n + 4.0 * n * d;
        TrainingCost::of(factors + kernels, self.max_iterations, numbers)
    }
}

impl Settings {
    /// As for variational models; one that does not couple parts takes all columns as one. Nothing for TMP
    /// and DMP: beside the others they cost little.
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
    fn of(evaluation_seconds: f64, iterations: usize, numbers: f64) -> Self {
        let seconds = evaluation_seconds * EVALUATIONS * iterations as f64;
        Self { evaluation_seconds, seconds, bytes: 8.0 * numbers }
    }
}

impl Sum for TrainingCost {
    /// Of trainings one after the other: the memory is that of the largest.
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

    /// The times are checked by the example, against a clock.
    #[test]
    fn costs_grow_as_the_sums_do() {
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

    #[test]
    fn exact_models_grow_with_the_cube_and_the_others_hardly_cost() {
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
