//! The hidden Markov chain of movements: the sticky prior of [`recognition`](super::recognition).

use crate::elementary::Elementary;
use nalgebra::DMatrix;

/// A chain that stays in its state from one frame to the next, or changes to another one.
pub(super) struct MovementChain {
    /// The probability of a change from one frame to the next.
    pub(super) change: f64,
    /// The probability of each state in the first frame. A change goes to the other states in proportion to it.
    pub(super) prior: Vec<f64>,
}

impl MovementChain {
    /// The probability of each state in each frame given all frames, from the log density of each frame under
    /// each state [frames x states] (the forward-backward algorithm).
    pub(super) fn posterior(&self, log_densities: &DMatrix<f64>) -> DMatrix<f64> {
        let (frames, states) = log_densities.shape();
        let mut likelihoods = log_densities.clone();
        for mut row in likelihoods.row_iter_mut() {
            let most = row.max();
            row.apply(|value| *value = (*value - most).exponential());
        }
        let weighted = |p: &[f64], t: usize| -> Vec<f64> {
            p.iter().enumerate().map(|(s, p)| p * likelihoods[(t, s)]).collect()
        };
        let mut posterior = DMatrix::zeros(frames, states);
        let mut now = self.prior.clone();
        for t in 0..frames {
            let before = if t == 0 { now } else { self.forward(&now) };
            now = normalised(weighted(&before, t));
            posterior.row_mut(t).copy_from_slice(&now);
        }
        let mut later = vec![1.0; states];
        for t in (0..frames.saturating_sub(1)).rev() {
            later = normalised(self.backward(&weighted(&later, t + 1)));
            let both = posterior.row(t).iter().zip(&later).map(|(p, later)| p * later).collect();
            posterior.row_mut(t).copy_from_slice(&normalised(both));
        }
        posterior
    }

    /// The share of the prior that the other states have. A chain of one state has none and does not change.
    fn others(&self, state: usize) -> f64 {
        if self.prior.len() < 2 { 1.0 } else { 1.0 - self.prior[state] }
    }

    /// The probability of each state one frame later.
    fn forward(&self, p: &[f64]) -> Vec<f64> {
        if p.len() < 2 {
            return p.to_vec();
        }
        let leaving = |state: usize| self.change * p[state] / self.others(state);
        let all: f64 = (0..p.len()).map(leaving).sum();
        let next = |state: usize| (1.0 - self.change) * p[state] + self.prior[state] * (all - leaving(state));
        (0..p.len()).map(next).collect()
    }

    /// The likelihood of each state one frame earlier.
    fn backward(&self, later: &[f64]) -> Vec<f64> {
        if later.len() < 2 {
            return later.to_vec();
        }
        let all: f64 = later.iter().zip(&self.prior).map(|(later, prior)| later * prior).sum();
        let before = |state: usize| {
            let others = (all - self.prior[state] * later[state]) / self.others(state);
            (1.0 - self.change) * later[state] + self.change * others
        };
        (0..later.len()).map(before).collect()
    }
}

fn normalised(mut p: Vec<f64>) -> Vec<f64> {
    let sum: f64 = p.iter().sum();
    p.iter_mut().for_each(|value| *value /= sum);
    p
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_burst_changes_nothing_and_a_lasting_change_is_found() {
        // Two states; the second is likelier in the frames 40 to 79, and for two frames before.
        let of = |t: usize, s: usize| {
            let second = (40..80).contains(&t) || (20..22).contains(&t);
            if (s == 1) == second { 0.0 } else { -1.5 }
        };
        let chain = MovementChain { change: 1.0 / 60.0, prior: vec![0.5; 2] };
        let posterior = chain.posterior(&DMatrix::from_fn(120, 2, of));
        for (t, row) in posterior.row_iter().enumerate() {
            assert_eq!(row[1] > row[0], (40..80).contains(&t), "{t}");
            assert!((row.sum() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_posterior_is_that_of_all_paths() {
        // Three states and four frames: the sum over all 81 paths.
        let log_densities = DMatrix::from_fn(4, 3, |t, s| ((7 * t + 5 * s) % 4) as f64 - 1.5);
        let (change, prior) = (0.2, [0.5, 0.3, 0.2]);
        let mut expected = DMatrix::<f64>::zeros(4, 3);
        for path in 0..81_usize {
            let states = [path % 3, path / 3 % 3, path / 9 % 3, path / 27];
            let mut weight = prior[states[0]];
            for t in 0..4 {
                weight *= log_densities[(t, states[t])].exponential();
                if t > 0 {
                    let (from, to) = (states[t - 1], states[t]);
                    weight *=
                        if from == to { 1.0 - change } else { change * prior[to] / (1.0 - prior[from]) };
                }
            }
            (0..4).for_each(|t| expected[(t, states[t])] += weight);
        }
        let total = expected.row(0).sum();
        let chain = MovementChain { change, prior: prior.to_vec() };
        assert!((expected / total - chain.posterior(&log_densities)).amax() < 1e-12);
    }

    #[test]
    fn a_chain_of_one_state_is_always_in_it() {
        let chain = MovementChain { change: 0.2, prior: vec![1.0] };
        assert_eq!(chain.posterior(&DMatrix::from_element(5, 1, -7.0)), DMatrix::from_element(5, 1, 1.0));
    }
}
