//! The period of a movement, from the autocorrelation of all columns together; and percentiles.

use nalgebra::DMatrix;

/// A movement with a smaller correlation one period later is not rhythmic.
pub const RHYTHMIC: f64 = 0.6;
/// A peak of at least this fraction of the highest peak may be the period. The first such peak is: later ones
/// are its multiples.
const NEARLY: f64 = 0.9;
/// A lag needs at least this number of pairs of frames.
const LEAST_FRAMES: usize = 8;

/// The period of a movement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Period {
    /// Frames from one repetition to the next.
    pub frames: f64,
    /// Correlation of the movement with itself one period later, at most 1.
    pub correlation: f64,
}

/// The period of `sequences` (each [T_s x D]); `None` if the autocorrelation has no peak.
///
/// For each lag L, rho(L) = sum y_t . y_{t+L} / sqrt(sum |y_t|^2 sum |y_{t+L}|^2) over all columns, frames
/// and sequences, each sequence centred by itself. The period is the first high peak after the first lag at
/// which rho increases, refined by a parabola. Half a gait cycle gives no such peak: left and right swap, so
/// the trunk is correlated with itself but the limbs are anticorrelated.
pub fn period(sequences: &[DMatrix<f64>]) -> Option<Period> {
    let centred: Vec<DMatrix<f64>> = sequences.iter().filter(|y| y.nrows() > 1).map(centred).collect();
    let longest = centred.iter().map(|y| y.ncols()).max()?;
    // A longer lag would compare only the two ends of a trial.
    let last = (2 * longest / 3).min(longest.saturating_sub(LEAST_FRAMES));
    let rho: Vec<f64> = (0..=last).map(|lag| correlation(&centred, lag)).collect();
    let first = (1..rho.len()).find(|&lag| rho[lag] > rho[lag - 1])?;
    let peaks =
        || (first..rho.len().saturating_sub(1)).filter(|&l| rho[l] >= rho[l - 1] && rho[l] > rho[l + 1]);
    let highest = peaks().map(|l| rho[l]).fold(f64::NEG_INFINITY, f64::max);
    let peak = peaks().find(|&l| highest > 0.0 && rho[l] >= NEARLY * highest)?;
    let (before, at, after) = (rho[peak - 1], rho[peak], rho[peak + 1]);
    let bend = before - 2.0 * at + after;
    let shift = if bend < 0.0 { 0.5 * (before - after) / bend } else { 0.0 };
    Some(Period { frames: peak as f64 + shift, correlation: at })
}

/// The frames minus their mean, as columns [D x T] so that each frame is contiguous in memory.
fn centred(y: &DMatrix<f64>) -> DMatrix<f64> {
    let mut frames = y.transpose();
    let mean = frames.column_mean();
    for mut frame in frames.column_iter_mut() {
        frame -= &mean;
    }
    frames
}

fn correlation(sequences: &[DMatrix<f64>], lag: usize) -> f64 {
    let (mut product, mut early, mut late) = (0.0, 0.0, 0.0);
    for y in sequences.iter().filter(|y| y.ncols() > lag) {
        let count = y.ncols() - lag;
        let (a, b) = (y.columns(0, count), y.columns(lag, count));
        product += a.dot(&b);
        early += a.norm_squared();
        late += b.norm_squared();
    }
    let scale = (early * late).sqrt();
    if scale > 0.0 { product / scale } else { 0.0 }
}

/// The 95th percentile and the maximum; both are 0 for an empty list.
pub(crate) fn upper_end(mut values: Vec<f64>) -> (f64, f64) {
    values.sort_unstable_by(f64::total_cmp);
    let last = values.len().saturating_sub(1);
    let at = |place: usize| values.get(place).copied().unwrap_or(0.0);
    (at(last * 95 / 100), at(last))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Two limbs in antiphase and a trunk at twice the frequency.
    fn gait(frames: usize, period: f64, start: f64) -> DMatrix<f64> {
        DMatrix::from_fn(frames, 3, |t, d| {
            let phase = TAU * (t as f64 / period + start);
            match d {
                0 => phase.sin() + 0.3 * (2.0 * phase).cos(),
                1 => -phase.sin() + 0.3 * (2.0 * phase).cos() + 5.0,
                _ => (2.0 * phase).sin(),
            }
        })
    }

    #[test]
    fn the_period_is_the_whole_cycle_and_not_half_or_twice_of_it() {
        let found = period(&[gait(110, 33.4, 0.1), gait(95, 33.4, 0.6)]).unwrap();
        assert!((found.frames - 33.4).abs() < 0.3, "{found:?}");
        assert!(found.correlation > 0.99, "{found:?}");
    }

    #[test]
    fn a_reach_is_not_rhythmic() {
        let reach = DMatrix::from_fn(80, 2, |t, d| ((t as f64 - 40.0) / (8.0 + d as f64)).tanh());
        assert!(period(&[reach]).is_none_or(|p| p.correlation < RHYTHMIC));
        assert_eq!(period(&[DMatrix::zeros(50, 3)]), None);
        assert_eq!(period(&[DMatrix::zeros(1, 3)]), None);
        assert_eq!(period(&[]), None);
    }
}
