//! The posterior of a rate: exact sums over binomial terms.

use serde::Serialize;
use vcgpdm_core::elementary::Elementary;

/// The posterior of a rate after `hits` of `trials`, from a uniform prior: beta(1 + hits, 1 + trials - hits).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Rate {
    /// Number of hits.
    pub hits: usize,
    /// Number of trials.
    pub trials: usize,
}

impl Rate {
    /// The rate of `hits`, at most `trials`, in `trials`.
    pub fn new(hits: usize, trials: usize) -> Self {
        Self { hits: hits.min(trials), trials }
    }

    /// Both parameters of the beta distribution.
    pub fn parameters(self) -> (f64, f64) {
        (1.0 + self.hits as f64, 1.0 + (self.trials - self.hits) as f64)
    }

    /// The posterior's mean.
    pub fn mean(self) -> f64 {
        let (a, b) = self.parameters();
        a / (a + b)
    }

    /// The posterior's standard deviation.
    pub fn deviation(self) -> f64 {
        let (a, b) = self.parameters();
        (a * b / (a + b + 1.0)).sqrt() / (a + b)
    }

    /// The posterior probability that the rate is below `x`.
    pub fn below(self, x: f64) -> f64 {
        // P(rate < x) is the probability of more than `hits` hits in one more trial at the rate x.
        1.0 - at_most(self.hits, self.trials + 1, x)
    }

    /// The value that exceeds the rate with this posterior probability.
    pub fn quantile(self, probability: f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if self.below(middle) < probability { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    /// The posterior probability that the rate is exactly one half. The prior gives one half the probability
    /// 1/2, and the other rates a uniform density.
    pub fn is_half(self) -> f64 {
        let half = terms(self.trials, 0.5).get(self.hits).copied().unwrap_or(0.0);
        // With a uniform rate, all numbers of hits are equally likely.
        let other = 1.0 / (self.trials as f64 + 1.0);
        half / (half + other)
    }
}

/// The probability of each number of hits in `trials` at this rate.
pub(super) fn terms(trials: usize, rate: f64) -> Vec<f64> {
    if rate <= 0.0 || rate >= 1.0 {
        let sure = if rate <= 0.0 { 0 } else { trials };
        return (0..=trials).map(|hits| f64::from(u8::from(hits == sure))).collect();
    }
    let odds = (rate / (1.0 - rate)).logarithm();
    // Logarithms: with many trials the first probability is too small for an f64.
    let mut term = trials as f64 * (1.0 - rate).logarithm();
    let mut all = Vec::with_capacity(trials + 1);
    for hits in 0..=trials {
        all.push(term.exponential());
        term += ((trials - hits) as f64 / (hits + 1) as f64).logarithm() + odds;
    }
    all
}

/// The probability of at most `hits` hits in `trials` at this rate.
fn at_most(hits: usize, trials: usize, rate: f64) -> f64 {
    terms(trials, rate).iter().take(hits + 1).sum::<f64>().min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn computes_the_posterior_as_by_hand() {
        let rate = Rate::new(1, 2);
        // beta(2, 2): mean 1/2, variance 1/20, density 6 x (1 - x).
        assert_relative_eq!(rate.mean(), 0.5);
        assert_relative_eq!(rate.deviation(), 0.05_f64.sqrt());
        assert_relative_eq!(rate.below(0.25), 3.0 / 16.0 - 2.0 / 64.0, epsilon = 1e-12);
        assert_relative_eq!(rate.quantile(0.5), 0.5, epsilon = 1e-9);
        // Two coins show one head with probability 1/2; a uniform rate with 1/3.
        assert_relative_eq!(rate.is_half(), 0.5 / (0.5 + 1.0 / 3.0), epsilon = 1e-12);
        assert_relative_eq!(at_most(1, 3, 0.5), 0.5, epsilon = 1e-12);
        assert_eq!((at_most(0, 3, 0.0), at_most(2, 3, 1.0)), (1.0, 0.0));
        assert_eq!(Rate::new(0, 0).mean(), 0.5);
    }

    #[test]
    fn many_trials_neither_overflow_nor_underflow() {
        let rate = Rate::new(50_000, 100_000);
        assert_relative_eq!(rate.below(0.5), 0.5, epsilon = 1e-6);
        assert_relative_eq!(rate.below(rate.quantile(0.975)), 0.975, epsilon = 1e-9);
        assert!((rate.quantile(0.975) - 0.5031).abs() < 1e-4);
    }

    /// Knopp et al. (2019), section 4.1.
    #[test]
    fn gives_the_result_of_the_papers_catch_trials() {
        assert!((Rate::new(72, 162).is_half() - 0.79).abs() < 0.005, "{}", Rate::new(72, 162).is_half());
    }
}
