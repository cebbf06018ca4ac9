//! The error on the training trials over the bound, as an exponential curve (Velychko et al. 2018, figure 6B).

use crate::evaluation::stats::mean;
use crate::perception::regression::Standard;
use crate::perception::results::{ErrorCurve, SettingResult};
use vcgpdm_core::elementary::Elementary;
use vcgpdm_core::models::ModelKind;

/// The curve of each kind of model, over its settings with answers.
pub(super) fn error_curves(settings: &[SettingResult]) -> Vec<ErrorCurve> {
    let of_kind = |model: ModelKind| {
        let rated = settings.iter().filter(|setting| setting.model == model && setting.confusion.is_some());
        let pairs = rated.filter_map(|setting| {
            let scores = setting.scores.as_ref()?;
            Some((scores.bound?, scores.training_mse.filter(|error| *error > 0.0)?))
        });
        error_curve(model, &pairs.collect::<Vec<_>>())
    };
    ModelKind::ALL.into_iter().filter_map(of_kind).collect()
}

/// The curve through pairs of a bound and an error: a straight line through the logarithms of the errors, by least
/// squares.
fn error_curve(model: ModelKind, pairs: &[(f64, f64)]) -> Option<ErrorCurve> {
    let (bounds, logarithms): (Vec<f64>, Vec<f64>) =
        pairs.iter().map(|(bound, error)| (*bound, error.logarithm())).unzip();
    let standard = Standard::of(&bounds)?;
    let places = || bounds.iter().map(|bound| standard.of_score(*bound)).zip(&logarithms);
    let count = pairs.len() as f64;
    // The standardised bounds have the mean 0 and the mean square 1.
    let (w0, w1) = (mean(&logarithms), places().map(|(x, y)| x * y).sum::<f64>() / count);
    let squares: f64 = places().map(|(x, y)| y - w0 - w1 * x).map(|off| off * off).sum();
    let curve = standard.drawn(|x| (w0 + w1 * x).exponential());
    // The curve through the largest numbers of a file can overflow.
    curve.iter().all(|(_, error)| error.is_finite()).then_some(ErrorCurve {
        model,
        settings: pairs.len(),
        centre: standard.centre,
        scale: standard.scale,
        weights: [w0, w1],
        error: (squares / (count - 2.0) / count).sqrt(),
        curve,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_a_made_curve_and_the_error_of_its_slope() {
        let made = |k: usize, off: f64| {
            let bound = 28_000.0 + 250.0 * k as f64;
            (bound, (-3.0 - 0.002 * (bound - 28_000.0) + off).exp())
        };
        let exact: Vec<(f64, f64)> = (0..9).map(|k| made(k, 0.0)).collect();
        let found = error_curve(ModelKind::Vcgpdm, &exact).unwrap();
        assert!((found.weights[1] / found.scale + 0.002).abs() < 1e-12 && found.error < 1e-9, "{found:?}");
        for (bound, error) in &found.curve {
            let expected = (-3.0 - 0.002 * (bound - 28_000.0)).exp();
            assert!((error / expected - 1.0).abs() < 1e-9, "{bound}: {error}");
        }
        // 0.1 above and below the curve in turn: the slope is known to 0.1 / sqrt(9), a little more for two weights.
        let noisy: Vec<(f64, f64)> = (0..9).map(|k| made(k, if k % 2 == 0 { 0.1 } else { -0.1 })).collect();
        let found = error_curve(ModelKind::Vcgpdm, &noisy).unwrap();
        assert!((0.033..0.04).contains(&found.error), "{found:?}");
        assert!(error_curve(ModelKind::Vcgpdm, &exact[..2]).is_none());
        let huge = [(0.0, 1e-300), (1.0, 1e300), (2.0, 1e300)];
        assert!(error_curve(ModelKind::Vcgpdm, &huge).is_none(), "it overflows");
    }
}
