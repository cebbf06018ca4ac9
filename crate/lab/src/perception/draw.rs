//! Random choices, the same on every machine.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

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
        let mut counts = [0; 5];
        let mut draw = Draw::new(7, 7);
        (0..10_000).for_each(|_| counts[draw.below(5)] += 1);
        assert!(counts.iter().all(|count| (1850..2150).contains(count)), "{counts:?}");
    }
}
