//! Variational posterior of temporal movement primitives: its bound, and updates that never lower the bound.

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use crate::models::data::phase::{Alignment, PhaseAxis, PhaseMap, Trial, phase_range};
use crate::models::tmp::kernel::PhaseKernel;
use crate::models::tmp::trial_features::TrialFeatures;
use crate::models::tmp::trial_features::{CoefficientSums, leading};
use crate::models::tmp::weights::{ColumnWeights, infer};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::{E, PI};

/// Noise variances and column scales are at least this times the mean variance of a column; some columns
/// never change.
const FLOOR: f64 = 1e-6;
/// The least mean variance; that of a still clip is 0.
const LEAST_VARIANCE: f64 = 1e-4;
/// Starting values: the share of noise in a column's variance, and the share of the variance between trials
/// in that of the weights.
const NOISE_SHARE: f64 = 0.1;
const SPREAD_SHARE: f64 = 0.1;
/// Starting value: the variance of v.
const START_COVARIANCE: f64 = 1e-4;
/// Starting values: the lengthscale in cycles, and in lengths of a trial.
const LENGTHSCALE: [f64; 2] = [0.12, 0.08];

/// q(m) q(mu, w) and the hyperparameters, of a fixed number of primitives.
#[derive(Clone, Debug)]
pub struct Posterior {
    /// The process over phase.
    pub kernel: PhaseKernel,
    /// Map of each trial from frames to phases.
    pub maps: Vec<PhaseMap>,
    /// `E[v]` [R x Q]: primitive q at phases p is P(p) v_q.
    pub v: DMatrix<f64>,
    /// The covariance of v, primitive after primitive [RQ x RQ].
    pub v_covariance: DMatrix<f64>,
    /// q(mu_k, w_k) of every column.
    pub weights: Vec<ColumnWeights>,
    /// sigma_k^2 `[D]`.
    pub noise: DVector<f64>,
    /// c_k `[D]`.
    pub scale: DVector<f64>,
    /// V [Q x Q].
    pub spread: DMatrix<f64>,
    /// a_q `[Q]`.
    pub relevance: DVector<f64>,
    /// The number of columns in each group of neighbouring columns that share their noise.
    groups: Vec<usize>,
    /// The set of weights of each trial: its own, or one set for all trials.
    sets: Vec<usize>,
    range: (f64, f64),
    /// The features of each trial at its map.
    pub features: Vec<TrialFeatures>,
    v_log_determinant: f64,
    floor: f64,
}

fn start_lengthscale(axis: PhaseAxis, range: (f64, f64)) -> f64 {
    LENGTHSCALE[usize::from(axis == PhaseAxis::Trial)].max(PhaseKernel::shortest(axis, range))
}

impl Posterior {
    /// The starting posterior: `count` principal components over phase of the aligned trials. `groups` are
    /// the numbers of neighbouring columns that share their noise; `shared_weights`: all trials have the same
    /// weights.
    pub fn start(
        trials: &[Trial],
        alignment: &Alignment,
        groups: &[usize],
        count: usize,
        shared_weights: bool,
    ) -> Result<Self, NumericsError> {
        let axis = alignment.axis;
        let range = match axis {
            PhaseAxis::Cycle => (0.0, 1.0),
            PhaseAxis::Trial => phase_range(trials, &alignment.maps),
        };
        let lengthscale = start_lengthscale(axis, range);
        let kernel = PhaseKernel::new(axis, lengthscale, range)?;
        let maps = alignment.maps.clone();
        let features: Vec<TrialFeatures> =
            trials.iter().zip(&maps).map(|(t, m)| TrialFeatures::new(&kernel, t, m)).collect();
        let columns = trials.first().map_or(0, |t| t.y.ncols());
        let frames = trials.iter().map(|t| t.y.nrows()).sum::<usize>().max(1) as f64;
        let variance = DVector::from_fn(columns, |k, _| {
            trials.iter().map(|t| t.y.column(k).norm_squared()).sum::<f64>() / frames
        });
        let floor = FLOOR * variance.mean().max(LEAST_VARIANCE);
        let variance = variance.map(|v| v.max(floor));
        let r = kernel.inducing.len();
        let mut sums = CoefficientSums::new(r);
        for (features, trial) in features.iter().zip(trials) {
            sums.add(features, &trial.y, &variance)?;
        }
        let v = leading(&sums, count);
        let mut posterior = Self {
            kernel,
            maps,
            v,
            weights: Vec::new(),
            noise: group_means(&variance, groups) * NOISE_SHARE,
            scale: variance,
            spread: DMatrix::identity(count, count) * SPREAD_SHARE,
            relevance: DVector::from_element(count, 1.0),
            groups: groups.to_vec(),
            sets: (0..trials.len()).map(|s| if shared_weights { 0 } else { s }).collect(),
            range,
            features,
            v_covariance: DMatrix::identity(r * count, r * count) * START_COVARIANCE,
            v_log_determinant: (r * count) as f64 * START_COVARIANCE.logarithm(),
            floor,
        };
        posterior.noise.apply(|n| *n = n.max(floor));
        posterior.update_weights()?;
        Ok(posterior)
    }

    /// The posterior with one more primitive: the function of phase that explains most of the residual.
    pub fn with_one_more(&self, trials: &[Trial]) -> Result<Self, NumericsError> {
        let (r, count) = (self.v.nrows(), self.primitives());
        let mut sums = CoefficientSums::new(r);
        for (s, (features, trial)) in self.features.iter().zip(trials).enumerate() {
            let residual = &trial.y - &features.features * &self.v * self.mean_weights(s).transpose();
            sums.add(features, &residual, &self.noise)?;
        }
        let mut more = self.clone();
        more.v = self.v.clone().insert_column(count, 0.0);
        more.v.set_column(count, &leading(&sums, 1).column(0));
        let mut covariance = DMatrix::identity(r * (count + 1), r * (count + 1)) * START_COVARIANCE;
        covariance.view_mut((0, 0), (r * count, r * count)).copy_from(&self.v_covariance);
        more.v_covariance = covariance;
        more.v_log_determinant += r as f64 * START_COVARIANCE.logarithm();
        // The residual is about as large as the noise.
        let small = self.noise.mean() / self.scale.mean();
        more.relevance = self.relevance.clone().insert_row(count, small);
        more.spread = self.spread.clone().insert_column(count, 0.0).insert_row(count, 0.0);
        more.spread[(count, count)] = small;
        more.update_weights()?;
        Ok(more)
    }

    /// Number of primitives Q.
    pub fn primitives(&self) -> usize {
        self.v.ncols()
    }

    /// `E[w_sk]` of trial `s` [D x Q].
    pub fn mean_weights(&self, s: usize) -> DMatrix<f64> {
        let set = self.sets[s];
        DMatrix::from_fn(self.weights.len(), self.primitives(), |k, q| self.weights[k].mean[set][q])
    }

    /// E[M^T M] over the frames of a trial [Q x Q], where M are the primitives at its phases.
    pub fn energy(&self, trial: &TrialFeatures) -> DMatrix<f64> {
        let r = self.v.nrows();
        let mut energy = symmetric(self.v.tr_mul(&(&trial.gram * &self.v)));
        for a in 0..self.primitives() {
            for b in 0..self.primitives() {
                energy[(a, b)] += self.v_covariance.view((a * r, b * r), (r, r)).dot(&trial.gram);
            }
            energy[(a, a)] += trial.residual;
        }
        energy
    }

    /// omega_s = sum_k E[w_sk w_sk^T] / sigma_k^2 [Q x Q].
    fn weight_precision(&self, s: usize) -> DMatrix<f64> {
        let mut sum = DMatrix::zeros(self.primitives(), self.primitives());
        for (weights, noise) in self.weights.iter().zip(self.noise.iter()) {
            sum += &weights.second[self.sets[s]] / *noise;
        }
        sum
    }

    /// `E[w_sk]` / sigma_k^2 of trial `s` [D x Q].
    fn scaled_weights(&self, s: usize) -> DMatrix<f64> {
        let mut scaled = self.mean_weights(s);
        for (mut row, noise) in scaled.row_iter_mut().zip(self.noise.iter()) {
            row /= *noise;
        }
        scaled
    }

    /// [`Self::energy`] of every trial.
    fn energies(&self) -> Vec<DMatrix<f64>> {
        self.features.iter().map(|trial| self.energy(trial)).collect()
    }

    /// The number of sets of weights.
    fn set_count(&self) -> usize {
        self.sets.iter().max().map_or(0, |last| last + 1)
    }

    /// Updates q(v), a Gaussian of precision I + sum_s omega_s (x) P_s^T P_s over all primitives.
    pub fn update_primitives(&mut self) -> Result<(), NumericsError> {
        let (r, count) = (self.kernel.inducing.len(), self.primitives());
        let mut precision = DMatrix::identity(r * count, r * count);
        let mut information = DMatrix::zeros(r, count);
        for s in 0..self.features.len() {
            let (weights, trial) = (self.weight_precision(s), &self.features[s]);
            for a in 0..count {
                for b in 0..count {
                    let mut block = precision.view_mut((a * r, b * r), (r, r));
                    block += &trial.gram * weights[(a, b)];
                }
            }
            information += &trial.projected * self.scaled_weights(s);
        }
        let factor = Factor::of_large(&precision, "precision of the primitives")?;
        let stacked = DMatrix::from_column_slice(r * count, 1, information.as_slice());
        self.v = DMatrix::from_column_slice(r, count, factor.solve(&stacked).as_slice());
        self.v_covariance = factor.inverse();
        self.v_log_determinant = -factor.log_determinant();
        Ok(())
    }

    /// Updates q(mu, w), column by column.
    pub fn update_weights(&mut self) -> Result<(), NumericsError> {
        let energies = self.energies();
        let projections: Vec<DMatrix<f64>> =
            self.features.iter().map(|trial| self.v.tr_mul(&trial.projected)).collect();
        let precision = Factor::new(&self.spread, "covariance of the weights")?.inverse();
        let column = |k: usize| {
            let count = self.primitives();
            let zero = (DMatrix::zeros(count, count), DVector::zeros(count));
            let mut likelihoods = vec![zero; self.set_count()];
            for ((set, e), h) in self.sets.iter().zip(&energies).zip(&projections) {
                likelihoods[*set].0 += e / self.noise[k];
                likelihoods[*set].1 += h.column(k) / self.noise[k];
            }
            infer(&(&precision / self.scale[k]), &(&self.relevance * self.scale[k]), &likelihoods)
        };
        self.weights = (0..self.noise.len()).map(column).collect::<Result<_, _>>()?;
        Ok(())
    }

    /// Expected squared error of column `k` over all trials, with the `energies` of [`Self::energy`].
    fn squared_error(&self, trials: &[Trial], energies: &[DMatrix<f64>], k: usize) -> f64 {
        let weights = &self.weights[k];
        let error = |(s, trial): (usize, &Trial)| {
            let projection = self.v.tr_mul(&self.features[s].projected.column(k));
            let set = self.sets[s];
            trial.y.column(k).norm_squared() - 2.0 * projection.dot(&weights.mean[set])
                + weights.second[set].dot(&energies[s])
        };
        trials.iter().enumerate().map(error).sum()
    }

    /// Updates sigma^2, c, V and a, each to the maximum of the bound given the others.
    pub fn update_hyperparameters(&mut self, trials: &[Trial]) -> Result<(), NumericsError> {
        let frames = trials.iter().map(|t| t.y.nrows()).sum::<usize>() as f64;
        let energies = self.energies();
        let (d, count, s) = (self.weights.len(), self.primitives(), self.set_count());
        let errors = DVector::from_fn(d, |k, _| self.squared_error(trials, &energies, k) / frames);
        self.noise = group_means(&errors, &self.groups).map(|n| n.max(self.floor));
        let precision = Factor::new(&self.spread, "covariance of the weights")?.inverse();
        for k in 0..d {
            let w = &self.weights[k];
            let centre: f64 = (0..count).map(|q| w.centre_second[(q, q)] / self.relevance[q]).sum();
            self.scale[k] =
                ((precision.dot(&w.deviation) + centre) / (count * (s + 1)) as f64).max(self.floor);
        }
        let mut spread = DMatrix::zeros(count, count);
        let mut relevance = DVector::zeros(count);
        for (w, scale) in self.weights.iter().zip(self.scale.iter()) {
            spread += &w.deviation / *scale;
            relevance += w.centre_second.diagonal() / *scale;
        }
        self.spread = symmetric(spread / (d * s) as f64);
        self.relevance = relevance.map(|a| (a / d as f64).max(f64::MIN_POSITIVE));
        Ok(())
    }

    /// Tries lengthscales `factor` times longer and shorter, each with its best q(v), and takes one that
    /// raises the bound. Returns whether it did.
    pub fn update_lengthscale(&mut self, trials: &[Trial], factor: f64) -> Result<bool, NumericsError> {
        self.update_primitives()?;
        let best = self.bound(trials)?;
        let shortest = PhaseKernel::shortest(self.kernel.axis, self.range);
        for factor in [factor, 1.0 / factor] {
            let lengthscale = (self.kernel.lengthscale * factor).max(shortest);
            if lengthscale == self.kernel.lengthscale {
                continue;
            }
            let mut other = self.clone();
            other.kernel = PhaseKernel::new(self.kernel.axis, lengthscale, self.range)?;
            other.update_features(trials);
            other.update_primitives()?;
            let bound = other.bound(trials)?;
            if bound > best {
                *self = other;
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn update_features(&mut self, trials: &[Trial]) {
        self.features =
            trials.iter().zip(&self.maps).map(|(t, m)| TrialFeatures::new(&self.kernel, t, m)).collect();
    }

    /// Moves the trials along the axis by `step`, and stretches whole trials, where that raises the bound.
    pub fn update_phases(&mut self, trials: &[Trial], step: f64) {
        let (r, count) = (self.kernel.inducing.len(), self.primitives());
        for (s, trial) in trials.iter().enumerate() {
            let precision = self.weight_precision(s);
            let mut quadratic = DMatrix::zeros(r, r);
            for a in 0..count {
                for b in 0..count {
                    quadratic += self.v_covariance.view((a * r, b * r), (r, r)) * precision[(a, b)];
                }
            }
            quadratic += &self.v * &precision * self.v.transpose();
            // (1 - p^T p) tr(omega) has the same form.
            for a in 0..r {
                quadratic[(a, a)] -= precision.trace();
            }
            let linear = &trial.y * self.scaled_weights(s) * self.v.transpose();
            let value =
                |trial: &TrialFeatures| linear.dot(&trial.features) - 0.5 * quadratic.dot(&trial.gram);
            let mut best = value(&self.features[s]);
            let stretch = if trial.whole { 2.0 * step } else { 0.0 };
            for (shift, stretch) in [(step, 0.0), (-step, 0.0), (0.0, stretch), (0.0, -stretch)] {
                let map = self.maps[s].moved(trial.y.nrows(), shift, stretch);
                if map == self.maps[s] || map.rate <= 0.0 {
                    continue;
                }
                let features = TrialFeatures::new(&self.kernel, trial, &map);
                let moved = value(&features);
                if moved > best {
                    best = moved;
                    self.maps[s] = map;
                    self.features[s] = features;
                }
            }
        }
    }

    /// Adds a trial with these features without learning from it. Its weights are its own unless all trials
    /// share them.
    pub fn include(&mut self, features: TrialFeatures, map: PhaseMap) -> Result<(), NumericsError> {
        let shared_weights = self.sets.len() > 1 && self.set_count() == 1;
        self.sets.push(if shared_weights { 0 } else { self.set_count() });
        self.features.push(features);
        self.maps.push(map);
        self.update_weights()
    }

    /// Autocorrelation of the residuals of the primitives at lags of 0, 1, ... frames, over all trials and
    /// columns, each weighted by its noise.
    pub fn residual_correlations(&self, trials: &[Trial], lags: usize) -> Vec<f64> {
        let mut sums = vec![0.0; lags];
        for (s, (trial, features)) in trials.iter().zip(&self.features).enumerate() {
            let residual = &trial.y - &features.features * &self.v * self.mean_weights(s).transpose();
            for (column, noise) in residual.column_iter().zip(self.noise.iter()) {
                for (lag, sum) in sums.iter_mut().enumerate().take(column.len()) {
                    let rest = column.len() - lag;
                    *sum += column.rows(0, rest).dot(&column.rows(lag, rest)) / noise;
                }
            }
        }
        let all = sums.first().copied().unwrap_or(0.0);
        let correlation = |(lag, sum): (usize, &f64)| {
            if lag == 0 || all <= 0.0 { f64::from(u8::from(lag == 0)) } else { sum / all }
        };
        sums.iter().enumerate().map(correlation).collect()
    }

    /// The bound on log p(Y), in nats: E[log p(Y | v, w)] + E[log p(w | mu)] + E[log p(mu)] + entropies -
    /// KL(q(v) || p(v)).
    pub fn bound(&self, trials: &[Trial]) -> Result<f64, NumericsError> {
        let frames = trials.iter().map(|t| t.y.nrows()).sum::<usize>() as f64;
        let energies = self.energies();
        let (s, q) = (self.set_count() as f64, self.primitives() as f64);
        let spread = Factor::new(&self.spread, "covariance of the weights")?;
        let (precision, log_spread) = (spread.inverse(), spread.log_determinant());
        let log_relevance: f64 = self.relevance.iter().map(|a| a.logarithm()).sum();
        let mut bound = 0.0;
        for (k, w) in self.weights.iter().enumerate() {
            let (noise, scale) = (self.noise[k], self.scale[k]);
            bound -= 0.5 * frames * (2.0 * PI * noise).logarithm();
            bound -= 0.5 * self.squared_error(trials, &energies, k) / noise;
            bound -= 0.5 * s * (q * (2.0 * PI * scale).logarithm() + log_spread);
            bound -= 0.5 * precision.dot(&w.deviation) / scale;
            bound -= 0.5 * (q * (2.0 * PI * scale).logarithm() + log_relevance);
            let centre: f64 = (0..w.centre.len()).map(|q| w.centre_second[(q, q)] / self.relevance[q]).sum();
            bound -= 0.5 * centre / scale;
            bound += 0.5 * ((s + 1.0) * q * (2.0 * PI * E).logarithm() + w.log_determinant);
        }
        Ok(bound - self.divergence())
    }

    /// KL(q(v) || N(0, I)), in nats.
    pub fn divergence(&self) -> f64 {
        let size = self.v.len() as f64;
        0.5 * (self.v.norm_squared() + self.v_covariance.trace() - size - self.v_log_determinant)
    }

    /// The lowest and highest phase of the whole trials.
    pub fn range(&self, trials: &[Trial]) -> (f64, f64) {
        if self.kernel.axis == PhaseAxis::Cycle { (0.0, 1.0) } else { phase_range(trials, &self.maps) }
    }
}

/// The values with each replaced by the mean of its group.
fn group_means(values: &DVector<f64>, groups: &[usize]) -> DVector<f64> {
    let mut out = values.clone();
    let mut at = 0;
    for &size in groups {
        let mean = values.rows(at, size).mean();
        out.rows_mut(at, size).fill(mean);
        at += size;
    }
    out
}
