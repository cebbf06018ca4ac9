//! The number of trials that a study needs, computed exactly.

use crate::perception::beta::{Rate, terms};

/// Largest number of trials.
const MOST: usize = 5_000;
/// Level of the test: the largest probability to reject a rate of one half that is true.
const LEVEL: f64 = 0.05;

/// The smallest number of trials with which the exact one-sided binomial test, at 5 %, detects a rate that
/// differs from one half by `difference` with at least this power. Knopp et al. (2019) have 158: a difference
/// of 0.1, the width of [0.45, 0.55], and a power of 0.8.
pub fn trials_to_tell(difference: f64, power: f64) -> Option<usize> {
    let rate = 0.5 + difference.abs();
    let possible = rate > 0.5 && rate <= 1.0 && power < 1.0;
    // The power is not monotonic in the number of trials, so all numbers are tried.
    (1..=MOST).take_while(|_| possible).find(|&trials| power_of(trials, rate) >= power)
}

/// The power of this test.
fn power_of(trials: usize, rate: f64) -> f64 {
    // From the largest number of hits down, while their probability at one half stays below the level.
    let (half, other) = (terms(trials, 0.5), terms(trials, rate));
    let (mut level, mut power) = (0.0, 0.0);
    for (half, other) in half.iter().zip(&other).rev() {
        level += half;
        if level > LEVEL {
            break;
        }
        power += other;
    }
    power
}

/// The smallest number of trials after which a rate of one half is known up to `width` / 2 with at least this
/// posterior probability.
pub fn trials_for_precision(width: f64, probability: f64) -> Option<usize> {
    let within = |trials: usize| {
        let rate = Rate::new(trials / 2, trials);
        rate.below(0.5 + 0.5 * width) - rate.below(0.5 - 0.5 * width)
    };
    // Even numbers only; the probability grows with them.
    let (mut low, mut high) = (0, 2 * MOST);
    if within(2 * high) < probability {
        return None;
    }
    while low < high {
        let middle = (low + high) / 2;
        if within(2 * middle) >= probability { high = middle } else { low = middle + 1 }
    }
    Some(2 * high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gives_the_papers_number_of_trials() {
        assert_eq!(trials_to_tell(0.1, 0.8), Some(158));
        // The criterion that the paper describes in its text.
        assert_eq!(trials_for_precision(0.1, 0.8), Some(162));
    }

    #[test]
    fn smaller_differences_need_more_trials() {
        assert!(trials_to_tell(0.05, 0.8) > trials_to_tell(0.1, 0.8));
        assert!(trials_to_tell(0.1, 0.95) > trials_to_tell(0.1, 0.8));
        assert_eq!(trials_to_tell(0.0, 0.8), None);
        assert_eq!(trials_for_precision(0.001, 0.8), None);
        assert!(trials_for_precision(0.2, 0.8) < trials_for_precision(0.1, 0.8));
        // Five heads of five tosses are the first result below 5 %, and certain at a rate of 1.
        assert_eq!(trials_to_tell(0.5, 0.8), Some(5));
    }
}
