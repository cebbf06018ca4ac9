//! The data: two systems with a known coupling, and their observations.

use crate::evaluation::dtw_mse;
use crate::synthetic::alignment::centre;
use crate::synthetic::function::{DrawnFunction, Evidence, grid, normal, rbf};
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use std::f64::consts::TAU;
use thiserror::Error;
use vcgpdm_core::elementary::Elementary;
use vcgpdm_core::gp::NumericsError;
use vcgpdm_core::models::variational::VariationalTrainer;
use vcgpdm_core::models::{Dataset, RolloutError, TrainingError, VariationalSettings};
use vcgpdm_core::motion::parts::PartSpec;
use vcgpdm_core::series::{Columns, SeriesError, Table};

/// The number of frames, T in the paper.
pub(super) const FRAMES: usize = 300;
/// Observed columns of a part.
pub(super) const COLUMNS: usize = 10;
/// The share of g^1 in the second part, in the paper; the rest is g^2.
pub const DRIVE: f64 = 0.1;
/// Frames before the first observed one, after which the start has no influence.
const LEAD: usize = 100;
/// Frames of one cycle of each part, in the evidence for the draws.
const PERIODS: [f64; 2] = [19.0, 11.0];
/// Standard deviation of the evidence, so that draws differ.
const LOOSENESS: f64 = 0.05;
/// A part is at rest if its standard deviation (both dimensions together) is smaller than this. On the unit
/// circle the deviation is 1.
const REST: f64 = 0.3;
/// Most draws: a draw with a part at rest is repeated.
const DRAWS: usize = 20;
/// Lengthscale of g^1 and g^2.
const DYNAMICS_LENGTHSCALE: f64 = 1.0;
/// Lengthscale of the observed functions.
const POSE_LENGTHSCALE: f64 = 1.5;
/// Frames a second of the table of a saved model, the usual rate of tables; the paper gives none.
const FRAME_RATE: f64 = 30.0;
/// Variance of the noise of the observations; the variance of their signal is 1.
pub const NOISE_VARIANCE: f64 = 0.01;

/// Data of two coupled systems, with the true latents.
#[derive(Clone, Debug, PartialEq)]
pub struct Synthetic {
    /// The true latents of each part [N x 2].
    pub latents: Vec<DMatrix<f64>>,
    /// The centred observations of each part [N x 10].
    pub y: Vec<DMatrix<f64>>,
    /// The share of g^1 in the second part, 0 to 1.
    pub drive: f64,
}

/// Why the experiment could not be made.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SyntheticError {
    /// The share of the first part in the second is not from 0 to 1.
    #[error("the share of the first part in the second must be from 0 to 1, found {0:?}")]
    Drive(f64),
    /// A covariance could not be factorised.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
    /// The observations do not make a table.
    #[error(transparent)]
    Table(#[from] SeriesError),
    /// Training could not start.
    #[error(transparent)]
    Training(#[from] TrainingError),
    /// The model cannot be rolled out.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
}

impl Synthetic {
    /// Draws the functions, the movement and the observations; all follow from the seed. `drive` is the share
    /// of g^1 in the second part, 0 to 1: [`DRIVE`] in the paper, 0 for two independent parts.
    ///
    /// # Errors
    ///
    /// [`SyntheticError::Drive`] for another share, [`SyntheticError::Numerics`] when a covariance cannot be
    /// factorised.
    pub fn draw(seed: u32, drive: f64) -> Result<Self, SyntheticError> {
        if !(0.0..=1.0).contains(&drive) {
            return Err(SyntheticError::Drive(drive));
        }
        let mut random = ChaCha8Rng::seed_from_u64(u64::from(seed));
        let mut latents = moving(drive, &mut random)?;
        for _ in 1..DRAWS {
            if latents.iter().all(|x| spread(x) >= REST) {
                break;
            }
            latents = moving(drive, &mut random)?;
        }
        let mut y = Vec::new();
        for x in &latents {
            let pose = DrawnFunction::prior(rbf(POSE_LENGTHSCALE), grid(7, 3.0), COLUMNS, &mut random)?;
            let mut seen = pose.at(x);
            seen += normal(FRAMES, COLUMNS, NOISE_VARIANCE.sqrt(), &mut random);
            centre(&mut seen);
            y.push(seen);
        }
        Ok(Self { latents, y, drive })
    }

    /// The settings of the experiment: two latent dimensions, ten inducing points and second order, as in the
    /// paper, and enough iterations for the bound to converge.
    pub fn settings() -> VariationalSettings {
        VariationalSettings {
            latent: 2,
            order: 2,
            dynamics_ips: 10,
            pose_ips: 10,
            max_iterations: 1500,
            ..Default::default()
        }
    }

    /// A training on the observations, ready to begin.
    ///
    /// # Errors
    ///
    /// As [`VariationalTrainer::new`].
    pub fn trainer(
        &self,
        settings: &VariationalSettings,
        seed: u32,
    ) -> Result<VariationalTrainer, TrainingError> {
        VariationalTrainer::new(self.y.clone(), vec![FRAMES], settings, seed)
    }

    /// The observations as a table of 20 columns: a model of them is a model of tables. The columns are not
    /// divided by their standard deviations: training sees them as they were drawn.
    ///
    /// # Errors
    ///
    /// A number is not finite or too large.
    pub fn dataset(&self) -> Result<Dataset<Columns>, SyntheticError> {
        let (width, parts) = (COLUMNS, self.y.len());
        let names: Vec<String> = (0..width * parts)
            .map(|column| format!("part {} curve {}", column / width + 1, column % width + 1))
            .collect();
        let values = DMatrix::from_fn(FRAMES, names.len(), |t, c| self.y[c / width][(t, c % width)]);
        let table = Table::checked("synthetic experiment", names.clone(), values, 1.0 / FRAME_RATE)?;
        let part = |k: usize| PartSpec {
            name: format!("part {}", k + 1),
            joints: (k * width..(k + 1) * width).collect(),
        };
        let specs: Vec<PartSpec> = (0..parts).map(part).collect();
        let scaled = Dataset::of_tables(&[table], &specs, FRAME_RATE)?;
        let units = vec![1.0; names.len()];
        Ok(Dataset { y: self.y.clone(), mapping: Columns::new(names, units), ..scaled })
    }

    /// The mean squared error of `generated` observations [N x 10] of each part, after dynamic time warping;
    /// the mean over the parts. Each part is warped alone, because it has its own rhythm.
    ///
    /// # Errors
    ///
    /// A number is not finite.
    pub fn mse(&self, generated: &[DMatrix<f64>]) -> Result<f64, SyntheticError> {
        let mut sum = 0.0;
        for (own, y) in generated.iter().zip(&self.y) {
            // The shapes agree, so the only possible reason is a number that is not finite.
            let score = dtw_mse(own, y);
            sum += score.map_err(|_| NumericsError::NotFinite { what: "rollout" })?.dtw_mse;
        }
        Ok(sum / self.y.len() as f64)
    }
}

/// Transitions from two rings around the origin, by one angle and half the distance to the unit circle.
fn turn(angle: f64) -> Evidence {
    const AROUND: usize = 8;
    let (sin, cos) = angle.sine_cosine();
    let inputs = DMatrix::from_fn(2 * AROUND, 2, |k, c| {
        let radius = if k < AROUND { 0.6 } else { 1.5 };
        let (y, x) = (TAU * k as f64 / AROUND as f64).sine_cosine();
        radius * if c == 0 { x } else { y }
    });
    let values = DMatrix::from_fn(inputs.nrows(), 2, |k, c| {
        let (x, y) = (inputs[(k, 0)], inputs[(k, 1)]);
        let half_way = 0.5 + 0.5 / x.hypotenuse(y);
        half_way * if c == 0 { cos * x - sin * y } else { sin * x + cos * y }
    });
    Evidence { inputs, values, noise_variance: LOOSENESS * LOOSENESS }
}

/// The standard deviation of all dimensions together.
pub(super) fn spread(x: &DMatrix<f64>) -> f64 {
    let mut centred = x.clone();
    centre(&mut centred);
    (centred.norm_squared() / x.nrows() as f64).sqrt()
}

/// Latents of new draws of g^1 and g^2: equations (18) and (19).
fn moving(drive: f64, random: &mut ChaCha8Rng) -> Result<Vec<DMatrix<f64>>, NumericsError> {
    let mut dynamics = Vec::new();
    for period in PERIODS {
        let draw = DrawnFunction::prior(rbf(DYNAMICS_LENGTHSCALE), grid(9, 3.0), 2, random)?;
        dynamics.push(draw.given(&turn(TAU / period), random)?);
    }
    let mut latents = vec![DMatrix::zeros(FRAMES, 2); 2];
    let start = DMatrix::from_row_slice(1, 2, &[1.0, 0.0]);
    let mut now = [start.clone(), start];
    for t in 0..LEAD + FRAMES {
        let next = [dynamics[0].at(&now[0]), dynamics[1].at(&now[1])];
        for q in 0..2 {
            if t >= LEAD {
                latents[0][(t - LEAD, q)] = now[0][(0, q)];
                latents[1][(t - LEAD, q)] = now[1][(0, q)];
            }
            now[0][(0, q)] = next[0][(0, q)];
            now[1][(0, q)] = drive * next[0][(0, q)] + (1.0 - drive) * next[1][(0, q)];
        }
    }
    Ok(latents)
}

vcgpdm_core::coded!(SyntheticError {
    Self::Drive(_) => Settings,
    Self::Numerics(_) => Numerics,
    Self::Table(_) => Table,
    Self::Training(reason) => reason.code(),
    Self::Rollout(reason) => reason.code(),
});
