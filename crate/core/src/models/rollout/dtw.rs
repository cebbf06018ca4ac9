//! The mean squared error of a predicted trial after dynamic time warping.

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Penalty for each column of a step that advances only one of the two motions (Sakoe and Chiba).
const PENALTY_PER_COLUMN: f64 = 1e-4;

/// How far a prediction is from the trial held out, in the squared units of the columns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Score {
    /// Mean squared error after dynamic time warping.
    pub dtw_mse: f64,
    /// Mean squared error frame by frame.
    pub mse: f64,
    /// The error of a prediction that does not move.
    pub variance: f64,
}

/// Why two motions cannot be compared.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ScoreError {
    /// A motion has no frames or no columns.
    #[error(
        "expected at least one frame and one column in the {which} motion, found {frames} frames of {columns} columns"
    )]
    Empty {
        /// "predicted" or "actual".
        which: &'static str,
        /// Rows found.
        frames: usize,
        /// Columns found.
        columns: usize,
    },
    /// The motions are of different bodies or poses.
    #[error("expected {expected} columns in the predicted motion, as in the actual one, found {found}")]
    Columns {
        /// Columns of the actual motion.
        expected: usize,
        /// Columns of the predicted motion.
        found: usize,
    },
    /// A value is not finite.
    #[error("expected finite numbers, found {value} in the {which} motion, frame {frame}, column {column}")]
    NotFinite {
        /// "predicted" or "actual".
        which: &'static str,
        /// The row, counted from 0.
        frame: usize,
        /// The column, counted from 0.
        column: usize,
        /// The value found.
        value: f64,
    },
    /// The motions are too long.
    #[error("expected motions of at most {MAX_CELLS} pairs of frames, found {predicted} x {actual} frames")]
    TooLong {
        /// Frames of the predicted motion.
        predicted: usize,
        /// Frames of the actual motion.
        actual: usize,
    },
}

/// Most pairs of frames: ten minutes against ten minutes at 30 frames a second.
const MAX_CELLS: usize = 324_000_000;

/// The score of a predicted motion [T_1 x D] against the actual one [T_2 x D].
///
/// Velychko et al. (2018, section 5.3) compare a rollout, started with the first frames of a held-out trial,
/// with the whole trial: the mean squared error of the kinematics after dynamic time warping, because a
/// small difference in phase would otherwise dominate the error. In detail:
///
/// 1. Each motion is centred by its own column means (over all its frames).
/// 2. The path is a minimum of the sum over its cells of `|p_i - a_j|^2 / s^2`, where `s^2` is the sum of all
///    squares of the centred actual motion, plus `1e-4 D` for every step (1, 0) or (0, 1); steps (1, 1) are
///    free. It leads from the first pair of frames to the last. Of paths that cost the same, the one with the
///    last step (1, 1), then (1, 0), is taken.
/// 3. `dtw_mse` is the mean of `(p_i - a_j)^2` over the path's cells and the columns, in the original units
///    squared. The penalty chooses the path and is no part of the score.
///
/// `mse` is the same without alignment over the first min(T_1, T_2) frames (centred as before). A prediction
/// whose pose never changes is 0 after centring; if it is as long as the trial, its `mse` equals `variance`
/// (1/T_2, not 1/(T_2 - 1)). If the pose of the trial never changes, `s` is 1.
///
/// Takes O(T_1 T_2 D) operations, one byte for each pair of frames and two rows of costs.
///
/// ```
/// use nalgebra::DMatrix;
/// use vcgpdm_core::models::dtw_mse;
///
/// let wave = |lag: f64| DMatrix::from_fn(60, 1, |t, _| (0.2 * t as f64 - lag).sin());
/// let late = dtw_mse(&wave(0.4), &wave(0.0))?;
/// assert!(late.dtw_mse < 0.2 * late.mse, "a difference in phase counts little");
/// # Ok::<(), vcgpdm_core::models::ScoreError>(())
/// ```
///
/// # Errors
/// A motion is empty, too long or not finite, or the motions have different numbers of columns.
pub fn dtw_mse(predicted: &DMatrix<f64>, actual: &DMatrix<f64>) -> Result<Score, ScoreError> {
    Ok(score_and_columns(predicted, actual)?.0)
}

/// The score, and the error of each column `[D]`, whose mean is `dtw_mse`.
pub fn score_and_columns(
    predicted: &DMatrix<f64>,
    actual: &DMatrix<f64>,
) -> Result<(Score, Vec<f64>), ScoreError> {
    check("predicted", predicted)?;
    check("actual", actual)?;
    let columns = actual.ncols();
    if predicted.ncols() != columns {
        return Err(ScoreError::Columns { expected: columns, found: predicted.ncols() });
    }
    let (rows, frames) = (predicted.nrows(), actual.nrows());
    if rows.saturating_mul(frames) > MAX_CELLS {
        return Err(ScoreError::TooLong { predicted: rows, actual: frames });
    }
    let (predicted, actual) = (centred(predicted), centred(actual));

    let squares: f64 = actual.iter().map(|v| v * v).sum();
    let scale = if squares > 0.0 { 1.0 / squares } else { 1.0 };
    let path = warp(rows, frames, PENALTY_PER_COLUMN * columns as f64, |i, j| {
        scale * squared_distance(frame(&predicted, i, columns), frame(&actual, j, columns))
    });
    let difference = |pairs: &mut dyn Iterator<Item = (usize, usize)>| {
        let (mut sum, mut count) = (0.0, 0.0);
        for (i, j) in pairs {
            sum += squared_distance(frame(&predicted, i, columns), frame(&actual, j, columns));
            count += columns as f64;
        }
        sum / count
    };
    let mut errors = vec![0.0; columns];
    for (i, j) in &path {
        let pairs = frame(&predicted, *i, columns).iter().zip(frame(&actual, *j, columns));
        for (error, (p, a)) in errors.iter_mut().zip(pairs) {
            *error += (p - a) * (p - a) / path.len() as f64;
        }
    }
    let score = Score {
        dtw_mse: difference(&mut path.into_iter()),
        mse: difference(&mut (0..rows.min(frames)).map(|t| (t, t))),
        variance: squares / (frames * columns) as f64,
    };
    Ok((score, errors))
}

fn check(which: &'static str, motion: &DMatrix<f64>) -> Result<(), ScoreError> {
    let (frames, columns) = motion.shape();
    if frames == 0 || columns == 0 {
        return Err(ScoreError::Empty { which, frames, columns });
    }
    match motion.iter().position(|v| !v.is_finite()) {
        // Column after column, as the matrix is stored.
        Some(k) => {
            Err(ScoreError::NotFinite { which, frame: k % frames, column: k / frames, value: motion[k] })
        }
        None => Ok(()),
    }
}

/// The motion minus its column means, one frame after the other [T x D].
fn centred(motion: &DMatrix<f64>) -> Vec<f64> {
    let means = motion.row_mean();
    motion.row_iter().flat_map(|row| (row - &means).iter().copied().collect::<Vec<_>>()).collect()
}

fn frame(motion: &[f64], t: usize, columns: usize) -> &[f64] {
    &motion[t * columns..(t + 1) * columns]
}

fn squared_distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum()
}

/// The last step into a cell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    Both,
    First,
    Second,
}

/// The cheapest path of pairs from (0, 0) to the last pair: cells cost `distance(i, j)`, steps that advance
/// one side alone cost `penalty`.
fn warp(
    rows: usize,
    columns: usize,
    penalty: f64,
    distance: impl Fn(usize, usize) -> f64,
) -> Vec<(usize, usize)> {
    let mut steps = vec![Step::Both; rows * columns];
    let (mut above, mut costs) = (vec![f64::INFINITY; columns], vec![f64::INFINITY; columns]);
    for i in 0..rows {
        for j in 0..columns {
            let both = match (i, j) {
                (0, 0) => 0.0,
                (_, 0) | (0, _) => f64::INFINITY,
                _ => above[j - 1],
            };
            let first = above[j] + penalty;
            let second = if j > 0 { costs[j - 1] + penalty } else { f64::INFINITY };
            let (before, step) = if both <= first && both <= second {
                (both, Step::Both)
            } else if first <= second {
                (first, Step::First)
            } else {
                (second, Step::Second)
            };
            costs[j] = before + distance(i, j);
            steps[i * columns + j] = step;
        }
        std::mem::swap(&mut above, &mut costs);
    }
    let (mut i, mut j) = (rows - 1, columns - 1);
    let mut path = vec![(i, j)];
    while (i, j) != (0, 0) {
        match steps[i * columns + j] {
            Step::Both => (i, j) = (i - 1, j - 1),
            Step::First => i -= 1,
            Step::Second => j -= 1,
        }
        path.push((i, j));
    }
    path.reverse();
    path
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::dmatrix;
    use proptest::prelude::*;

    fn wave(frames: usize, late: f64) -> DMatrix<f64> {
        DMatrix::from_fn(frames, 3, |t, d| ((t as f64 - late) * 0.2 + d as f64).sin() * (1.0 + d as f64))
    }

    #[test]
    fn identical_motions_have_no_error() {
        let motion = wave(80, 0.0);
        let score = dtw_mse(&motion, &motion).unwrap();
        assert_eq!((score.dtw_mse, score.mse), (0.0, 0.0));
        // Each column is centred by its own mean, so a constant offset does not matter either.
        let score = dtw_mse(&motion.add_scalar(3.0), &motion).unwrap();
        assert!(score.dtw_mse < 1e-25 && score.mse < 1e-25);
    }

    #[test]
    fn aligns_a_late_copy() {
        let score = dtw_mse(&wave(200, 6.0), &wave(200, 0.0)).unwrap();
        assert!(score.mse > 0.5 * score.variance, "{score:?}");
        assert!(score.dtw_mse < 0.06 * score.variance, "{score:?}");
    }

    #[test]
    fn the_error_of_a_motionless_prediction_is_the_variance() {
        let actual = wave(90, 0.0);
        let score = dtw_mse(&DMatrix::from_element(90, 3, 7.5), &actual).unwrap();
        assert_relative_eq!(score.mse, score.variance, max_relative = 1e-12);
        let by_hand = (actual.row_variance().sum()) / 3.0;
        assert_relative_eq!(score.variance, by_hand, max_relative = 1e-12);
        // No pair of frames can be better than another in sum, so warping does not help it to much.
        assert!(score.dtw_mse > 0.3 * score.variance, "{score:?}");
    }

    #[test]
    fn scores_small_motions_as_by_hand() {
        // Centred: (-1, 0, 1) and (-1, -1, 2). Sum of squares of the actual motion: 6. Penalty: 1e-4.
        // Cells |p - a|^2: 0 0 9 / 1 1 4 / 4 4 1. The diagonal costs (0 + 1 + 1) / 6; going (0,0) (0,1) (1,2)
        // (2,2) costs (0 + 0 + 4 + 1) / 6 + 2e-4; (0,0) (0,1) (1,1) (2,2) costs (0 + 0 + 1 + 1) / 6 + 2e-4:
        // the diagonal wins.
        let score = dtw_mse(&dmatrix![4.0; 5.0; 6.0], &dmatrix![1.0; 1.0; 4.0]).unwrap();
        assert_relative_eq!(score.dtw_mse, 2.0 / 3.0, max_relative = 1e-12);
        assert_relative_eq!(score.mse, 2.0 / 3.0, max_relative = 1e-12);
        assert_relative_eq!(score.variance, 2.0, max_relative = 1e-12);
        // Unequal lengths: centred (-2, 0, 0, 2) against (-2, 2); path (0,0) then three cells; two steps wait
        // at one side. (0,0) (1,0) (2,0) (3,1) and (0,0) (1,0) (2,1) (3,1) and ... all cost (4 + 4) / 8 +
        // 2e-4, mean (4 + 4) / 4.
        let score = dtw_mse(&dmatrix![1.0; 3.0; 3.0; 5.0], &dmatrix![0.0; 4.0]).unwrap();
        assert_relative_eq!(score.dtw_mse, 2.0, max_relative = 1e-12);
        assert_relative_eq!(score.mse, 2.0, max_relative = 1e-12);
        assert_relative_eq!(score.variance, 4.0, max_relative = 1e-12);
        // The sum of squares of two equal columns is 5341. The diagonal costs 4 / 5341 = 7.5e-4, one step aside and
        // one back cost 2 / 5341 + 2 * 2e-4 = 7.7e-4: too much with two columns.
        let two = |values: [f64; 4]| DMatrix::from_fn(4, 2, |t, _| values[t]);
        let score = dtw_mse(&two([0.0, 0.0, 1.0, 60.0]), &two([0.0, 1.0, 0.0, 60.0])).unwrap();
        assert_relative_eq!(score.dtw_mse, 0.5, max_relative = 1e-12);
    }

    #[test]
    fn the_penalty_keeps_equal_motions_in_step() {
        // Without it any detour over equal frames would be as good.
        let path = warp(4, 4, 1e-4, |_, _| 0.0);
        assert_eq!(path, [(0, 0), (1, 1), (2, 2), (3, 3)]);
        assert_eq!(warp(1, 3, 1e-4, |_, _| 1.0), [(0, 0), (0, 1), (0, 2)]);
        // Both ways around the middle cost the same: the last step is (1, 0).
        let middle = |i: usize, j: usize| if (i, j) == (1, 1) { 1.0 } else { 0.0 };
        assert_eq!(warp(3, 3, 1e-4, middle), [(0, 0), (0, 1), (1, 2), (2, 2)]);
    }

    #[test]
    fn refuses_motions_that_cannot_be_compared() {
        let says = |a: &DMatrix<f64>, b: &DMatrix<f64>| dtw_mse(a, b).unwrap_err().to_string();
        assert_eq!(
            says(&wave(5, 0.0), &DMatrix::zeros(5, 2)),
            "expected 2 columns in the predicted motion, as in the actual one, found 3"
        );
        assert!(says(&DMatrix::zeros(0, 3), &wave(5, 0.0)).contains("predicted motion, found 0 frames"));
        let mut odd = wave(5, 0.0);
        odd[(3, 2)] = f64::NAN;
        assert!(says(&wave(5, 0.0), &odd).ends_with("found NaN in the actual motion, frame 3, column 2"));
        let still = dtw_mse(&DMatrix::zeros(4, 1), &DMatrix::zeros(3, 1)).unwrap();
        assert_eq!((still.dtw_mse, still.mse, still.variance), (0.0, 0.0, 0.0));
    }

    /// All monotone paths from (i, j) to the end, with their cost.
    fn cheapest(
        rows: usize,
        columns: usize,
        penalty: f64,
        distance: &dyn Fn(usize, usize) -> f64,
        at: (usize, usize),
    ) -> f64 {
        let (i, j) = at;
        if at == (rows - 1, columns - 1) {
            return distance(i, j);
        }
        let next = [(i + 1, j + 1, 0.0), (i + 1, j, penalty), (i, j + 1, penalty)];
        let onward = next.into_iter().filter(|&(i, j, _)| i < rows && j < columns);
        let rest = onward.map(|(i, j, extra)| extra + cheapest(rows, columns, penalty, distance, (i, j)));
        distance(i, j) + rest.fold(f64::INFINITY, f64::min)
    }

    proptest! {
        #[test]
        fn no_other_path_is_cheaper(
            rows in 1..6usize, columns in 1..6usize, penalty in 0.0..0.5f64,
            cells in prop::collection::vec(0.0..1.0f64, 25),
        ) {
            let distance = |i: usize, j: usize| cells[5 * i + j];
            let path = warp(rows, columns, penalty, distance);
            prop_assert_eq!((path[0], path[path.len() - 1]), ((0, 0), (rows - 1, columns - 1)));
            let mut cost: f64 = path.iter().map(|&(i, j)| distance(i, j)).sum();
            for pair in path.windows(2) {
                let (di, dj) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
                prop_assert!(di <= 1 && dj <= 1 && di + dj > 0);
                cost += if di + dj == 1 { penalty } else { 0.0 };
            }
            let best = cheapest(rows, columns, penalty, &distance, (0, 0));
            prop_assert!((cost - best).abs() < 1e-12);
        }

        #[test]
        fn scores_are_finite_and_scale_with_the_units(
            values in prop::collection::vec(-5.0..5.0f64, 60), split in 1..29usize, unit in 0.01..100.0f64,
        ) {
            let all = DMatrix::from_row_slice(30, 2, &values);
            let (a, b) = (all.rows(0, split).into_owned(), all.rows(split, 30 - split).into_owned());
            let score = dtw_mse(&a, &b).unwrap();
            let scaled = dtw_mse(&(&a * unit), &(&b * unit)).unwrap();
            for (x, y) in [(score.dtw_mse, scaled.dtw_mse), (score.mse, scaled.mse), (score.variance, scaled.variance)] {
                prop_assert!(x.is_finite() && (x * unit * unit - y).abs() <= 1e-9 * y.abs().max(1e-300));
            }
        }
    }
}
