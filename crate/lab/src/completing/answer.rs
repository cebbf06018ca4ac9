//! Inferred columns of a part, and how far they are from the recorded ones.

use crate::evaluation::EvaluationError;
use nalgebra::DMatrix;
use std::ops::Range;
use vcgpdm::gp::NumericsError;
use vcgpdm::models::variational::{Filter, LatentMoments};

/// The band of 95 % of a Gaussian, in standard deviations.
const BAND: f64 = 1.96;

/// Means and variances of the columns of a part [frames x D], and the log density of each recorded frame.
pub struct Answer {
    pub mean: DMatrix<f64>,
    pub variance: DMatrix<f64>,
    pub log_densities: Vec<f64>,
}

impl Answer {
    /// The columns `columns` of part `part` of a model under latents. `recorded` has these columns, of which
    /// those at the places `changing` have a density.
    pub fn of_latents(
        filter: &Filter,
        latents: &LatentMoments,
        part: usize,
        columns: &[usize],
        recorded: &DMatrix<f64>,
        changing: &[usize],
    ) -> Result<Self, NumericsError> {
        let (frames, width) = recorded.shape();
        let (mut mean, mut variance) = (DMatrix::zeros(frames, width), DMatrix::zeros(frames, width));
        let mut log_densities = Vec::with_capacity(frames);
        let changing: Vec<usize> = changing.iter().map(|&c| columns[c]).collect();
        for (t, moments) in filter.frames(part, latents).enumerate() {
            let moments = moments?;
            let mut row = vec![0.0; moments.mean.len()];
            for (c, &column) in columns.iter().enumerate() {
                mean[(t, c)] = moments.mean[column];
                variance[(t, c)] = moments.covariance[(column, column)];
                row[column] = recorded[(t, c)];
            }
            log_densities.push(moments.log_density(&row, &changing)?);
        }
        Ok(Self { mean, variance, log_densities })
    }

    /// The share of the numbers of a column within the 95 % band.
    pub fn coverage_of(&self, recorded: &DMatrix<f64>, column: usize, frames: &Range<usize>) -> f64 {
        let is_inside = |&t: &usize| {
            let error = (self.mean[(t, column)] - recorded[(t, column)]).abs();
            error < BAND * self.variance[(t, column)].sqrt()
        };
        frames.clone().filter(is_inside).count() as f64 / frames.len() as f64
    }

    /// The mean coverage of these columns.
    pub fn coverage(&self, recorded: &DMatrix<f64>, columns: &[usize], frames: &Range<usize>) -> f64 {
        let all = columns.iter().map(|&c| self.coverage_of(recorded, c, frames));
        all.sum::<f64>() / columns.len() as f64
    }

    /// The mean of the squared errors divided by their predicted variances: 1 for variances that are right.
    pub fn squares(&self, recorded: &DMatrix<f64>, columns: &[usize], frames: &Range<usize>) -> f64 {
        let number =
            |t: usize, c: usize| (self.mean[(t, c)] - recorded[(t, c)]).powi(2) / self.variance[(t, c)];
        let all = frames.clone().flat_map(|t| columns.iter().map(move |&c| number(t, c)));
        all.sum::<f64>() / (columns.len() * frames.len()) as f64
    }

    /// The mean log density of a frame.
    pub fn log_density(&self, frames: &Range<usize>) -> f64 {
        self.log_densities[frames.clone()].iter().sum::<f64>() / frames.len() as f64
    }
}

/// The squared error in these frames, as a share of that of the mean pose, which is 0.
pub fn share(mean: &DMatrix<f64>, recorded: &DMatrix<f64>, frames: &Range<usize>) -> f64 {
    let rows = |y: &DMatrix<f64>| y.rows(frames.start, frames.len()).into_owned();
    (rows(mean) - rows(recorded)).norm_squared() / rows(recorded).norm_squared()
}

/// The share of the squared numbers in these frames that the mean of each column makes.
pub fn constant_share(y: &DMatrix<f64>, frames: &Range<usize>) -> f64 {
    let rows = y.rows(frames.start, frames.len());
    let constant: f64 = rows.row_mean().iter().map(|mean| mean * mean).sum();
    constant * frames.len() as f64 / rows.norm_squared()
}

/// The number, if it is finite: JSON has no others.
pub fn finite(what: &'static str, found: f64) -> Result<f64, EvaluationError> {
    if found.is_finite() { Ok(found) } else { Err(EvaluationError::NotFinite { what, found }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_errors_bands_and_constant_offsets() {
        let recorded = DMatrix::from_row_slice(4, 2, &[1.0, 1.0, 3.0, 1.0, 1.0, 1.0, 3.0, 1.0]);
        let answer = Answer {
            mean: DMatrix::from_element(4, 2, 1.0),
            variance: DMatrix::from_element(4, 2, 1.0),
            log_densities: vec![0.0, -2.0, -4.0, -6.0],
        };
        let all = 0..4;
        // Errors of 2 in two of eight numbers; their squares are 8 of 24.
        assert_eq!(share(&answer.mean, &recorded, &all), 8.0 / 24.0);
        assert_eq!(answer.coverage(&recorded, &[0, 1], &all), 0.75);
        assert_eq!(answer.coverage_of(&recorded, 0, &(0..1)), 1.0);
        assert_eq!(answer.squares(&recorded, &[0], &all), 2.0);
        assert_eq!(answer.log_density(&(1..3)), -3.0);
        // The means are 2 and 1: four times 5 of 24.
        assert_eq!(constant_share(&recorded, &all), 20.0 / 24.0);
        assert!(finite("an error", f64::NAN).is_err());
    }
}
