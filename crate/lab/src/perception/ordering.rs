//! The order of several rates, from random draws of their posteriors; and random choices that are the same on every
//! machine.

use crate::perception::beta::Rate;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rand_distr::{Beta, Distribution};
use std::collections::HashMap;

/// Probabilities of the orders of rates.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Ordering {
    /// Orders with the highest rate first, each with its share of the draws; the most frequent order first.
    pub orders: Vec<(Vec<usize>, f64)>,
    /// `pairs[a][b]`: the share of the draws with rate a above rate b; 1/2 for a = b.
    pub pairs: Vec<Vec<f64>>,
}

/// The orders of these rates in `draws` draws.
pub(super) fn ordering(rates: &[Rate], draws: usize, seed: u32) -> Ordering {
    let posteriors: Option<Vec<Beta<f64>>> = rates
        .iter()
        .map(|rate| {
            let (a, b) = rate.parameters();
            Beta::new(a, b).ok()
        })
        .collect();
    // Both parameters are at least 1, so the distributions exist.
    let posteriors = posteriors.unwrap_or_default();
    let count = posteriors.len();
    let mut random = ChaCha8Rng::seed_from_u64(seed.into());
    let mut orders: HashMap<Vec<usize>, usize> = HashMap::new();
    let mut above = vec![vec![0_usize; count]; count];
    for _ in 0..draws {
        let drawn: Vec<f64> = posteriors.iter().map(|posterior| posterior.sample(&mut random)).collect();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&a, &b| drawn[b].total_cmp(&drawn[a]));
        for (place, &a) in order.iter().enumerate() {
            order[place + 1..].iter().for_each(|&b| above[a][b] += 1);
        }
        *orders.entry(order).or_default() += 1;
    }
    let share = |times: usize| times as f64 / draws.max(1) as f64;
    let mut orders: Vec<(Vec<usize>, f64)> =
        orders.into_iter().map(|(order, times)| (order, share(times))).collect();
    orders.sort_by(|a, b| b.1.total_cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
    let pair = |a: usize, b: usize| if a == b { 0.5 } else { share(above[a][b]) };
    let pairs = (0..count).map(|a| (0..count).map(|b| pair(a, b)).collect()).collect();
    Ordering { orders, pairs }
}

/// Random choices from two seeds.
pub(super) struct Draw(ChaCha8Rng);

impl Draw {
    pub fn new(first: u32, second: u32) -> Self {
        Self(ChaCha8Rng::seed_from_u64((u64::from(first) << 32) | u64::from(second)))
    }

    /// A whole number from 0 to `end` - 1; 0 if `end` is 0.
    pub fn below(&mut self, end: usize) -> usize {
        // The numbers differ in probability by at most 2^-32, which no experiment can notice.
        ((u128::from(self.0.next_u64()) * end as u128) >> 64) as usize
    }

    /// Shuffles the items; every order has the same probability.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for end in (1..items.len()).rev() {
            let other = self.below(end + 1);
            items.swap(end, other);
        }
    }

    /// `count` items: all in random order, then all again in another random order, and so on.
    pub fn deal<T: Copy>(&mut self, items: &[T], count: usize) -> Vec<T> {
        let mut result = Vec::with_capacity(count);
        while result.len() < count && !items.is_empty() {
            let mut deck = items.to_vec();
            self.shuffle(&mut deck);
            deck.truncate(count - result.len());
            result.extend(deck);
        }
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gives_equal_rates_all_orders_and_clear_rates_one() {
        let equal = ordering(&[Rate::new(5, 20); 3], 60_000, 1);
        assert_eq!(equal.orders.len(), 6);
        assert!(equal.orders.iter().all(|(_, share)| (share - 1.0 / 6.0).abs() < 0.006), "{equal:?}");
        let rates = [Rate::new(5, 100), Rate::new(90, 100), Rate::new(50, 100)];
        let clear = ordering(&rates, 1_000, 1);
        assert_eq!(clear.orders, [(vec![1, 2, 0], 1.0)]);
        assert_eq!(clear.pairs, [[0.5, 0.0, 0.0], [1.0, 0.5, 1.0], [1.0, 0.0, 0.5]]);
        assert_eq!(ordering(&rates, 1_000, 1), clear);
        assert_eq!(ordering(&[], 10, 1).orders, [(vec![], 1.0)]);
    }

    #[test]
    fn gives_the_probability_of_a_pair_as_by_hand() {
        // beta(2, 1) above beta(1, 1): the integral of 2 x times x is 2/3.
        let pairs = ordering(&[Rate::new(1, 1), Rate::new(0, 0)], 100_000, 2).pairs;
        assert!(
            (pairs[0][1] - 2.0 / 3.0).abs() < 0.006 && (pairs[1][0] - 1.0 / 3.0).abs() < 0.006,
            "{pairs:?}"
        );
    }
}

#[cfg(test)]
mod draw_tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn deals_items_evenly_and_the_same_from_the_same_seed() {
        let dealt = Draw::new(1, 2).deal(&[10, 11, 12], 8);
        assert_eq!(dealt, Draw::new(1, 2).deal(&[10, 11, 12], 8));
        assert_ne!(dealt, Draw::new(1, 3).deal(&[10, 11, 12], 8));
        for round in dealt.chunks_exact(3) {
            let mut round = round.to_vec();
            round.sort_unstable();
            assert_eq!(round, [10, 11, 12]);
        }
        assert!(Draw::new(0, 0).deal::<usize>(&[], 5).is_empty());
        // Each of two items comes first.
        let firsts: HashSet<_> = (0..20).map(|seed| Draw::new(seed, 0).deal(&[0, 1], 1)).collect();
        assert_eq!(firsts.len(), 2);
        let mut counts = [0; 5];
        let mut draw = Draw::new(7, 7);
        (0..10_000).for_each(|_| counts[draw.below(5)] += 1);
        assert!(counts.iter().all(|count| (1850..2150).contains(count)), "{counts:?}");
    }
}
