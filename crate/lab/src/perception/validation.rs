//! Whether a score predicts answers better than a constant, and how well it could: n-fold cross-validation (Knopp
//! et al. 2019, section 3.3; Velychko et al. 2017, section 3.3).

use crate::evaluation::stats::{mean, standard_error};
use crate::perception::ordering::Draw;
use crate::perception::regression::{Curve, Point};
use vcgpdm_core::elementary::Elementary;

/// Smallest probability of an answer by a constant.
const SMALLEST: f64 = 1e-6;

/// The logarithm of the Bayes factor of a prediction and a constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LogBayesFactor {
    /// Log likelihood by the prediction minus that by the constant: the mean over the blocks left out.
    pub mean: f64,
    /// Its standard error over the blocks.
    pub error: f64,
}

/// The log Bayes factors of two predictions of the blocks left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LogBayesFactors {
    /// Of the curve that is fitted to the other blocks.
    pub score: LogBayesFactor,
    /// Of the share of hits of each point in all blocks. No curve has a higher one.
    pub data: LogBayesFactor,
}

/// Splits all answers at random into blocks, fits curve and constant without each block, and compares their
/// likelihoods of the block. Absent with fewer answers than blocks.
pub(super) fn log_bayes_factors(
    points: &[Point],
    ceiling: f64,
    folds: usize,
    seed: u32,
) -> Option<LogBayesFactors> {
    let blocks = blocks(points, folds, seed)?;
    let (mut score, mut data) = (Vec::with_capacity(folds), Vec::with_capacity(folds));
    for left_out in &blocks {
        let rest = points.iter().zip(left_out).map(|(all, out)| Point {
            hits: all.hits - out.hits,
            trials: all.trials - out.trials,
            ..*all
        });
        let rest: Vec<Point> = rest.collect();
        let constant = constant(&rest, left_out);
        score.push(Curve::fit(&rest, ceiling).log_likelihood(left_out) - constant);
        let own = |(all, out): (&Point, &Point)| log_likelihood(all.hits / all.trials, out.hits, out.trials);
        data.push(points.iter().zip(left_out).map(own).sum::<f64>() - constant);
    }
    let factor = |differences: Vec<f64>| {
        Some(LogBayesFactor { mean: mean(&differences), error: standard_error(&differences)? })
    };
    Some(LogBayesFactors { score: factor(score)?, data: factor(data)? })
}

/// The answers of each block to each point.
fn blocks(points: &[Point], folds: usize, seed: u32) -> Option<Vec<Vec<Point>>> {
    let mut answers: Vec<(usize, bool)> = Vec::new();
    for (place, point) in points.iter().enumerate() {
        let (hits, trials) = (point.hits as usize, point.trials as usize);
        answers.extend((0..trials).map(|trial| (place, trial < hits)));
    }
    if folds < 2 || answers.len() < folds {
        return None;
    }
    Draw::new(seed, 0).shuffle(&mut answers);
    let none = |point: &Point| Point { hits: 0.0, trials: 0.0, ..*point };
    let empty: Vec<Point> = points.iter().map(none).collect();
    let mut blocks = vec![empty; folds];
    for (k, (place, hit)) in answers.into_iter().enumerate() {
        let point = &mut blocks[k % folds][place];
        point.trials += 1.0;
        point.hits += f64::from(u8::from(hit));
    }
    Some(blocks)
}

/// The log likelihood of answers by the share of hits in other answers.
fn constant(others: &[Point], answers: &[Point]) -> f64 {
    let sum = |points: &[Point]| {
        points.iter().fold((0.0, 0.0), |(hits, trials), point| (hits + point.hits, trials + point.trials))
    };
    let (hits, trials) = sum(others);
    let rate = (hits / f64::max(trials, 1.0)).clamp(SMALLEST, 1.0 - SMALLEST);
    let (hits, trials) = sum(answers);
    log_likelihood(rate, hits, trials)
}

/// The log likelihood of answers at a rate. A rate of 0 is certain of answers without a hit, and a rate of 1 of
/// answers that all are hits.
fn log_likelihood(rate: f64, hits: f64, trials: f64) -> f64 {
    let of = |count: f64, share: f64| if count > 0.0 { count * share.logarithm() } else { 0.0 };
    of(hits, rate) + of(trials - hits, 1.0 - rate)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    fn simulated(rate: impl Fn(f64) -> f64, seed: u64) -> Vec<Point> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut uniform = || random.next_u32() as f64 / f64::from(u32::MAX);
        let scores: Vec<f64> = (0..20).map(|_| 3.4 * (uniform() - 0.5)).collect();
        let point = |&score: &f64| {
            let hits = (0..158).filter(|_| uniform() < rate(score)).count();
            Point { score, hits: hits as f64, trials: 158.0 }
        };
        scores.iter().map(point).collect()
    }

    #[test]
    fn distinguishes_a_score_with_information_from_noise() {
        let truth = Curve { ceiling: 0.5, weights: [0.0, 1.5] };
        for seed in 0..5 {
            let informative = simulated(|score| truth.rate(score), seed);
            let LogBayesFactors { score, data } = log_bayes_factors(&informative, 0.5, 10, 1).unwrap();
            assert!(score.mean > 5.0 && score.mean > 4.0 * score.error, "{score:?}");
            assert!(data.mean >= score.mean, "{data:?} {score:?}");
            // The score is noise: near 0, a little below, as the curve learns what is none.
            let noise = simulated(|_| 0.3, seed);
            let LogBayesFactors { score, data } = log_bayes_factors(&noise, 0.5, 10, 1).unwrap();
            assert!((-0.5..0.3).contains(&score.mean), "{score:?}");
            // The data know the noise of each setting: half of a chi square of 19, over 10 blocks, is 0.95.
            assert!((0.3..2.0).contains(&data.mean) && data.mean >= score.mean, "{data:?}");
        }
    }

    #[test]
    fn the_data_are_certain_of_settings_whose_answers_all_agree() {
        let points = [(-1.0, 50.0), (1.0, 0.0)].map(|(score, hits)| Point { score, hits, trials: 50.0 });
        let LogBayesFactors { score, data } = log_bayes_factors(&points, 1.0, 10, 1).unwrap();
        // The constant is wrong about one of two answers; nothing is better than to be certain.
        let constant = -10.0 * std::f64::consts::LN_2;
        assert!((data.mean + constant).abs() < 0.1 && data.mean >= score.mean, "{data:?} {score:?}");
    }

    #[test]
    fn puts_each_answer_into_one_block() {
        let points = simulated(|_| 0.3, 1);
        let blocks = blocks(&points, 7, 3).unwrap();
        for (k, point) in points.iter().enumerate() {
            let sum =
                |value: &dyn Fn(&Point) -> f64| blocks.iter().map(|block| value(&block[k])).sum::<f64>();
            assert_eq!((sum(&|p| p.hits), sum(&|p| p.trials)), (point.hits, point.trials));
        }
        let sizes: Vec<f64> =
            blocks.iter().map(|block| block.iter().map(|point| point.trials).sum()).collect();
        assert!(sizes.iter().all(|size| [451.0, 452.0].contains(size)), "{sizes:?}");
        assert_eq!(log_bayes_factors(&points, 0.5, 1, 0), None);
        assert_eq!(log_bayes_factors(&[], 0.5, 10, 0), None);
    }
}
