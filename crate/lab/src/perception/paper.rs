//! The results of Knopp et al. (2019), as far as they follow from the counts that the printed rates and
//! errors imply; and the power of such a study.

use crate::perception::beta::{Rate, terms};
use crate::perception::ordering::{Ordering, ordering};

/// The best setting of each kind of model, from the highest rate to the lowest: its name in the paper, and
/// how often it was taken for the natural one.
pub const BEST: [(&str, usize, usize); 6] = [
    ("TMP", 108, 170),
    ("vGPDM", 28, 51),
    ("DMP", 92, 170),
    ("vCGPDM", 75, 162),
    ("MAP CGPDM", 30, 270),
    ("MAP GPDM", 0, 270),
];
/// Catch trials in which the unknown movement was taken for the natural one, of all.
pub const CATCH: (usize, usize) = (72, 162);

/// A number of the paper, and the computed one.
#[derive(Clone, Debug, PartialEq)]
pub struct PaperCheck {
    /// The name of the number.
    pub what: String,
    /// The number in the paper.
    pub printed: String,
    /// The number that follows from the counts.
    pub computed: f64,
    /// Number of decimals to print.
    pub digits: usize,
}

/// All numbers of the paper that follow from these counts. `draws` draws give the orders.
pub fn paper_checks(draws: usize, seed: u32) -> Vec<PaperCheck> {
    let rates = BEST.map(|(_, hits, trials)| Rate::new(hits, trials));
    let printed = [
        ("0.64", "0.04"),
        ("0.55", "0.07"),
        ("0.54", "0.04"),
        ("0.46", "0.04"),
        ("0.11", "0.02"),
        ("0.000", "0.004"),
    ];
    let mut checks = Vec::new();
    let mut add = |what: String, printed: &str, computed: f64, digits: usize| {
        checks.push(PaperCheck { what, printed: printed.to_owned(), computed, digits });
    };
    for (((name, hits, trials), rate), (mean, error)) in BEST.iter().zip(rates).zip(printed) {
        add(format!("{name}, {hits} of {trials}: share"), mean, *hits as f64 / *trials as f64, 3);
        add(format!("{name}: standard deviation of the posterior"), error, rate.deviation(), 3);
    }
    let Ordering { orders, pairs } = ordering(&rates, draws, seed);
    let first = orders.iter().find(|(order, _)| order.is_sorted()).map_or(0.0, |(_, share)| *share);
    let names: Vec<&str> = BEST.iter().map(|(name, ..)| *name).collect();
    let likeliest = orders.first().is_some_and(|(order, _)| order.is_sorted());
    let note = if likeliest { "the likeliest order" } else { "an order" };
    add(format!("{}: probability of this, {note}", names.join(" > ")), "0.36", first, 3);
    add("P(TMP > vGPDM)".to_owned(), "0.87", pairs[0][1], 3);
    add("P(vGPDM > vCGPDM)".to_owned(), "0.86", pairs[1][3], 3);
    add("P(TMP > 0.5)".to_owned(), "about 0.99", 1.0 - rates[0].below(0.5), 4);
    let (hits, trials) = CATCH;
    let caught = Rate::new(hits, trials);
    add(format!("catch trials, {hits} of {trials}: P(p = 0.5)"), "about 0.8", caught.is_half(), 3);
    let needed = |count: Option<usize>| count.map_or(f64::NAN, |count| count as f64);
    add(
        "trials for the exact one-sided test at 5 % to tell 0.6 from 0.5 with power 0.8".to_owned(),
        "158",
        needed(trials_to_tell(0.1, 0.8)),
        0,
    );
    add(
        "trials until a rate of 0.5 lies in [0.45, 0.55] with probability 0.8".to_owned(),
        "(not this)",
        needed(trials_for_precision(0.1, 0.8)),
        0,
    );
    checks
}

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

    /// The paper's numbers, from its counts.
    #[test]
    fn gives_the_results_of_the_paper() {
        let checks = paper_checks(400_000, 1);
        let computed = |words: &str| {
            checks.iter().find(|check| check.what.contains(words)).map(|check| check.computed).unwrap()
        };
        for (name, rate) in [
            ("TMP", 0.64),
            ("vGPDM", 0.55),
            ("DMP", 0.54),
            ("vCGPDM", 0.46),
            ("MAP CGPDM", 0.11),
            ("MAP GPDM", 0.0),
        ] {
            let found = computed(&format!("{name}, "));
            assert!((found - rate).abs() < 0.006, "{name}: {found}");
        }
        assert!((computed("the likeliest order") - 0.36).abs() < 0.005);
        assert!((computed("P(TMP > vGPDM)") - 0.87).abs() < 0.005);
        assert!((computed("P(vGPDM > vCGPDM)") - 0.86).abs() < 0.005);
        assert!((computed("P(p = 0.5)") - 0.79).abs() < 0.005);
        // The paper says about 0.99; more follows from its rate and error.
        assert!(computed("P(TMP > 0.5)") > 0.999);
        assert_eq!(computed("exact one-sided test"), 158.0);
    }
}

#[cfg(test)]
mod power_tests {
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
