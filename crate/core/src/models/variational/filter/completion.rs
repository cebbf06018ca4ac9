//! Columns of parts that were not observed, and their errors.

use crate::gp::NumericsError;
use crate::models::variational::filter::pose_process::ColumnMoments;
use crate::models::variational::filter::step::Filter;
use crate::models::variational::moments::LatentMoments;
use nalgebra::DMatrix;
use serde::Serialize;

/// The band of 95 % of a Gaussian, in standard deviations.
const BAND: f64 = 1.959_963_984_540_054;
/// A column whose pose map is nowhere larger never changed in training.
const CHANGES: f64 = 1e-9;

/// How well predicted columns of a part fit the recorded ones.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct CompletionScore {
    /// Mean squared error over all frames and columns.
    pub mse: f64,
    /// That of the mean pose of the training clips.
    pub mse_mean_pose: f64,
    /// Share of the numbers within the 95 % band of their prediction, of columns that changed in training.
    pub coverage_95: f64,
    /// Log density of all columns of a frame together that changed in training, in nats; mean over the frames.
    pub log_density: f64,
}

impl Filter {
    /// The columns of a part in every frame, under these latents.
    pub fn frames<'a>(
        &'a self,
        part: usize,
        latents: &'a LatentMoments,
    ) -> impl Iterator<Item = Result<ColumnMoments, NumericsError>> + 'a {
        let rows = latents.means[part].row_iter().zip(&latents.covariances[part]);
        rows.map(move |(mean, covariance)| self.column_moments(part, &mean.transpose(), covariance))
    }

    /// The mean columns of a part [frames x D_i] under these latents.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn mean_columns(&self, part: usize, latents: &LatentMoments) -> Result<DMatrix<f64>, NumericsError> {
        let mut means = DMatrix::zeros(latents.means[part].nrows(), self.poses[part].columns());
        for (t, moments) in self.frames(part, latents).enumerate() {
            means.set_row(t, &moments?.mean.transpose());
        }
        Ok(means)
    }

    /// Compares the columns of a part under these latents with the recorded ones [frames x D_i], whose missing
    /// numbers are NaN.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn score(
        &self,
        part: usize,
        latents: &LatentMoments,
        recorded: &DMatrix<f64>,
    ) -> Result<CompletionScore, NumericsError> {
        let changing = self.poses[part].changing(CHANGES);
        let mut sums = CompletionScore { mse: 0.0, mse_mean_pose: 0.0, coverage_95: 0.0, log_density: 0.0 };
        let (mut numbers, mut in_bands, mut frames) = (0_usize, 0_usize, 0_usize);
        for (moments, row) in self.frames(part, latents).zip(recorded.row_iter()) {
            let (moments, row) = (moments?, row.iter().copied().collect::<Vec<f64>>());
            let known: Vec<usize> = (0..row.len()).filter(|&c| !row[c].is_nan()).collect();
            for &c in &known {
                sums.mse += (row[c] - moments.mean[c]).powi(2);
                sums.mse_mean_pose += row[c].powi(2);
                numbers += 1;
            }
            let known: Vec<usize> = known.into_iter().filter(|&c| changing[c]).collect();
            for &c in &known {
                let band = BAND * moments.covariance[(c, c)].sqrt();
                sums.coverage_95 += f64::from(u8::from((row[c] - moments.mean[c]).abs() <= band));
                in_bands += 1;
            }
            if !known.is_empty() {
                sums.log_density += moments.log_density(&row, &known)?;
                frames += 1;
            }
        }
        sums.mse /= numbers.max(1) as f64;
        sums.mse_mean_pose /= numbers.max(1) as f64;
        sums.coverage_95 /= in_bands.max(1) as f64;
        sums.log_density /= frames.max(1) as f64;
        Ok(sums)
    }
}
