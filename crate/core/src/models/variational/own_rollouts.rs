//! Dynamics that learn from rollouts of the model itself.
//!
//! Training infers the experts from rows that lead from a recorded history to the next frame. A rollout reads
//! its own frames instead, and soon has histories that no recording has. In a round, the model of the round
//! before is rolled out from frames of the training; each frame of such a rollout gives a row that leads from the
//! rollout's history most of the way to the recorded frame that should come next. The experts are inferred again from the
//! recorded rows and these (Venkatraman, Hebert & Bagnell 2015, "Data as Demonstrator").
//!
//! Recorded rows and rows of rollouts have half of the weight each, so that all have the weight that the
//! recorded rows had alone, and the variances of the experts do not shrink. Kernels, inducing inputs,
//! couplings, latents and pose maps stay.

use crate::gp::NumericsError;
use crate::gp::bound::{InducingPosterior, SparseGp};
use crate::gp::linalg::block_diagonal;
use crate::gp::tall::add_tr_product;
use crate::models::rollout::couplings::{Reading, coupling_weights};
use crate::models::rollout::request::RolloutError;
use crate::models::variational::elbo::DynamicsSums;
use crate::models::variational::maps::FittedExpert;
use crate::models::variational::model::Vcgpdm;
use nalgebra::DMatrix;

/// Most rollouts in a round, so that the time of a round is bounded.
const MOST_STARTS: usize = 250;
/// The share of the way back to the recording that a rollout learns to make up in one frame. With 1, some models
/// learned to overshoot: they shook.
const RETURN: f64 = 0.7;
/// A rollout that is early or late by at most this many frames learns the frame that follows its own pose.
const SLACK: usize = 4;

/// The histories of all parts [rows x pQ_j], and what should come next in every part [rows x Q_i].
struct Rows {
    histories: Vec<Vec<f64>>,
    targets: Vec<Vec<f64>>,
    count: usize,
}

impl Vcgpdm {
    /// The model after a round, from rollouts of `latest`, the model after the round before, with this many
    /// frames.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub(in crate::models) fn after_round(
        &self,
        latest: &Vcgpdm,
        frames: usize,
    ) -> Result<Vcgpdm, RolloutError> {
        self.with_rows(&latest.rollout_rows(frames)?)
    }

    /// The model whose experts are inferred from the recorded rows and these.
    fn with_rows(&self, rows: &Rows) -> Result<Vcgpdm, RolloutError> {
        let mut model = self.clone();
        if rows.count == 0 {
            return Ok(model);
        }
        let weight = self.transitions() as f64 / rows.count as f64;
        for (target, sums) in model.sums.iter_mut().enumerate() {
            let DynamicsSums { psi2, psi1_mu } = self.sums_of_rows(target, rows);
            sums.psi2.zip_apply(&psi2, |recorded, made| *recorded = 0.5 * (*recorded + weight * made));
            sums.psi1_mu.zip_apply(&psi1_mu, |recorded, made| *recorded = 0.5 * (*recorded + weight * made));
        }
        model.infer_experts()?;
        Ok(model)
    }

    /// Number R of recorded rows.
    fn transitions(&self) -> usize {
        let frames = self.starts.iter().filter_map(|start| start.first());
        frames.map(|x| x.nrows().saturating_sub(self.order)).sum()
    }

    /// Infers all experts from the sums, under the learned couplings.
    pub(in crate::models) fn infer_experts(&mut self) -> Result<(), NumericsError> {
        for target in 0..self.part_count() {
            let (noise, weights) = coupling_weights(self.alpha.column(target).as_slice());
            let offsets = self.offsets(target);
            let (mut psi2, mut b) = self.sums[target].weighted(&weights, &offsets);
            if let Some(external) = self.external.get(target) {
                psi2 += &external.precision * noise;
                b += &external.b * noise;
            }
            let k = block_diagonal(self.experts.iter().map(|row| row[target].k()));
            // The mean and the covariance need no other statistics.
            let gp = SparseGp { noise, k: &k, psi2: &psi2, b: &b, psi0: 0.0, second_moment: 0.0, rows: 0 };
            let InducingPosterior { mean, covariance } = gp.posterior()?;
            for (row, &at) in self.experts.iter_mut().zip(&offsets) {
                let (z, kernel) = (row[target].z().clone(), row[target].kernel().clone());
                let mean = mean.rows(at, z.nrows()).into_owned();
                row[target] = FittedExpert::new(z, kernel, mean, self.jitter)?;
            }
            self.dynamics_covariance[target] = covariance;
        }
        Ok(())
    }

    /// The rows of rollouts of this many frames from evenly chosen frames of the training.
    fn rollout_rows(&self, frames: usize) -> Result<Rows, RolloutError> {
        let order = self.order;
        let dynamics = self.dynamics(&self.alpha, Reading::AsLearned)?;
        let empty = || vec![Vec::new(); self.part_count()];
        let mut rows = Rows { histories: empty(), targets: empty(), count: 0 };
        let every = self.transitions().div_ceil(MOST_STARTS).max(2);
        for recorded in &self.starts {
            let length = recorded.first().map_or(0, DMatrix::nrows);
            for begin in (0..length.saturating_sub(order + 1)).step_by(every) {
                let start: Vec<_> = recorded.iter().map(|x| x.rows(begin, order).into_owned()).collect();
                let path = dynamics.path(&start, order + frames.min(length - order - begin))?;
                if path.iter().all(|x| x.iter().all(|v| v.is_finite())) {
                    rows.add(&path, recorded, begin, order);
                }
            }
        }
        Ok(rows)
    }

    /// The sums of rows about a target.
    fn sums_of_rows(&self, target: usize, rows: &Rows) -> DynamicsSums {
        let offsets = self.offsets(target);
        let mut kernels = DMatrix::zeros(rows.count, offsets[self.part_count()]);
        for ((row, history), &at) in self.experts.iter().zip(&rows.histories).zip(&offsets) {
            let expert = &row[target];
            let history = DMatrix::from_row_slice(rows.count, expert.z().ncols(), history);
            let k = expert.kernel().cross_covariance(&history, expert.z());
            kernels.columns_mut(at, k.ncols()).copy_from(&k);
        }
        let latent = self.parts[target].r().ncols();
        let targets = DMatrix::from_row_slice(rows.count, latent, &rows.targets[target]);
        let mut sums = DynamicsSums::zeros(kernels.ncols(), latent);
        add_tr_product(&kernels, &kernels, &mut sums.psi2);
        add_tr_product(&kernels, &targets, &mut sums.psi1_mu);
        sums
    }
}

impl Rows {
    /// Adds the rows of a rollout that began at frame `begin` of a recorded sequence.
    fn add(&mut self, path: &[DMatrix<f64>], recorded: &[DMatrix<f64>], begin: usize, order: usize) {
        let last = recorded[0].nrows() - order - 1;
        let mut at = begin;
        for step in 1..path[0].nrows() - order {
            // A rollout may go slower or faster than the recording: its row follows the pose, not the clock.
            let clock = at + 1;
            let near = clock.saturating_sub(SLACK)..=(clock + SLACK).min(last);
            let distance = |frame: usize| -> f64 {
                let parts = path.iter().zip(recorded);
                parts.map(|(x, y)| (x.rows(step, order) - y.rows(frame, order)).norm_squared()).sum()
            };
            let distances = near.map(|frame| (distance(frame), frame.abs_diff(clock), frame));
            let nearest = distances.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let Some((_, _, frame)) = nearest else { break };
            at = frame;
            for ((x, y), (history, target)) in
                path.iter().zip(recorded).zip(self.histories.iter_mut().zip(&mut self.targets))
            {
                history.extend(x.rows(step, order).transpose().iter());
                let (rolled, recorded, next) =
                    (x.row(step + order - 1), y.row(at + order - 1), y.row(at + order));
                target.extend((next + (rolled - recorded) * (1.0 - RETURN)).iter());
            }
            self.count += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::variational::testing::fitted;
    use approx::assert_relative_eq;

    #[test]
    fn recorded_rows_alone_give_the_model_that_they_gave() {
        for seed in 0..4 {
            let model = fitted(seed);
            let mut again = model.clone();
            again.infer_experts().unwrap();
            for target in 0..model.part_count() {
                let (found, expected) =
                    (&again.dynamics_covariance[target], &model.dynamics_covariance[target]);
                assert_relative_eq!(found, expected, epsilon = 1e-9, max_relative = 1e-7);
                for (found, expected) in again.experts.iter().zip(&model.experts) {
                    let (found, expected) = (found[target].mean(), expected[target].mean());
                    assert_relative_eq!(found, expected, epsilon = 1e-9, max_relative = 1e-7);
                }
            }
        }
    }

    /// Every row as often as its weight says, one by one.
    #[test]
    fn sums_are_those_of_the_rows_one_by_one() {
        let model = fitted(1);
        let rows = model.rollout_rows(6).unwrap();
        let next = model.with_rows(&rows).unwrap();
        let weight = model.transitions() as f64 / rows.count as f64;
        for target in 0..model.part_count() {
            let latent = model.latent_dimensions();
            let mut sums = model.sums[target].clone();
            for row in 0..rows.count {
                let mut k: Vec<f64> = Vec::new();
                for (part, experts) in model.experts.iter().enumerate() {
                    let width = model.order * latent[part];
                    let history = &rows.histories[part][row * width..][..width];
                    let history = DMatrix::from_row_slice(1, width, history);
                    let expert = &experts[target];
                    k.extend(expert.kernel().cross_covariance(&history, expert.z()).iter());
                }
                let k = DMatrix::from_column_slice(k.len(), 1, &k);
                let width = latent[target];
                let mu = DMatrix::from_row_slice(1, width, &rows.targets[target][row * width..][..width]);
                sums.psi2 += &k * k.transpose() * weight;
                sums.psi1_mu += &k * mu * weight;
            }
            assert_relative_eq!(next.sums[target].psi2, sums.psi2 * 0.5, epsilon = 1e-9);
            assert_relative_eq!(next.sums[target].psi1_mu, sums.psi1_mu * 0.5, epsilon = 1e-9);
        }
    }

    /// A recording that goes round a circle, and a rollout that does so 10 % slower.
    #[test]
    fn rows_follow_the_pose_and_not_the_clock() {
        let circle = |frames: usize, speed: f64| {
            let at = |t: usize| speed * t as f64;
            vec![DMatrix::from_fn(frames, 2, |t, q| if q == 0 { at(t).cos() } else { at(t).sin() })]
        };
        let (recorded, slow) = (circle(80, 0.1), circle(42, 0.09));
        let mut rows = Rows { histories: vec![Vec::new()], targets: vec![Vec::new()], count: 0 };
        rows.add(&slow, &recorded, 0, 2);
        assert_eq!((rows.count, rows.histories[0].len(), rows.targets[0].len()), (39, 39 * 4, 39 * 2));
        for row in 0..rows.count {
            let (history, target) = (&rows.histories[0][4 * row..][..4], &rows.targets[0][2 * row..][..2]);
            // Oldest first; the newest frame is that of step row + 2.
            assert_eq!(history[2..], [slow[0][(row + 2, 0)], slow[0][(row + 2, 1)]]);
            // The target is one recorded step (0.1) ahead of the pose, within half a step.
            let turn = target[1].atan2(target[0]) - history[3].atan2(history[2]);
            let turn = turn.rem_euclid(std::f64::consts::TAU);
            assert!((0.04..0.16).contains(&turn), "row {row}: {turn}");
        }
    }

    /// Sequences of 11 and 8 frames, with a history of two.
    #[test]
    fn rollouts_begin_at_every_second_frame_and_end_with_their_recording() {
        let mut model = fitted(1);
        let rows = |model: &Vcgpdm, frames: usize| model.rollout_rows(frames).unwrap().count;
        assert_eq!(rows(&model, 6), (5 + 5 + 4 + 2) + (5 + 3 + 1));
        let mut long = model.clone();
        for x in long.starts.iter_mut().flatten() {
            *x = DMatrix::from_fn(1000, x.ncols(), |t, q| x[(t % x.nrows(), q)]);
        }
        assert_eq!(rows(&long, 2), MOST_STARTS);
        // A rollout whose numbers are not finite teaches nothing.
        model.starts[1][0][(0, 0)] = f64::NAN;
        assert_eq!(rows(&model, 6), (5 + 5 + 4 + 2) + (3 + 1));
    }

    #[test]
    fn a_recording_without_rows_changes_nothing() {
        let mut model = fitted(0);
        for x in model.starts.iter_mut().flatten() {
            *x = x.rows(0, 2).into_owned();
        }
        assert_eq!(model.after_round(&model, 5).unwrap(), model);
    }
}
