//! Sampled futures and moment matching are two answers to one question, on the model that walks first on the
//! page.

use crate::start_model;

use start_model::start_model;
use vcgpdm::models::RolloutRequest;

#[test]
fn moments_are_those_of_many_futures_as_long_as_a_gaussian_can_say_it() {
    let model = start_model();
    let model = model.coupled().unwrap();
    let request = RolloutRequest { frames: 60, ..RolloutRequest::default() };
    let dynamics = model.predictive_dynamics(&request).unwrap();
    let start = &model.model.start(0, 0).unwrap();
    let moments = dynamics.moments(start, 60).unwrap();
    let draws = 1000;
    let futures: Vec<_> = (0..draws).map(|seed| dynamics.sample(start, 60, seed).unwrap()).collect();
    let count = draws as f64;
    for (part, means) in moments.means.iter().enumerate() {
        for t in 2..60 {
            for q in 0..means.ncols() {
                let values: Vec<f64> = futures.iter().map(|future| future[part][(t, q)]).collect();
                let mean = values.iter().sum::<f64>() / count;
                let variance = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (count - 1.0);
                let (known_mean, known) = (means[(t, q)], moments.covariances[part][t][(q, q)]);
                let (shift, ratio) = ((mean - known_mean).abs() / known.sqrt(), (variance / known).sqrt());
                let found = format!("part {part}, frame {t}, dimension {q}: {shift}, {ratio}");
                // Two frames are exact, so that only chance is left: four standard errors.
                if t < 4 {
                    assert!(shift < 4.0 / count.sqrt(), "{found}");
                    assert!((ratio * ratio - 1.0).abs() < 4.0 * (2.0 / count).sqrt(), "{found}");
                }
                // Then the phases of the futures part along the bent cycle, and a Gaussian says ever less:
                // docs/uncertainty.md.
                if t < 15 {
                    assert!(shift < 0.25 && (0.8..1.25).contains(&ratio), "{found}");
                }
                assert!(known_mean.is_finite() && known > 0.0, "{found}");
            }
        }
    }
}
