//! The table of rollouts from observed first frames.

use crate::report::spread::spread;
use std::fmt::Write;
use vcgpdm_lab::evaluation::{NO_WORSE, ObservedStarts, Results, fixed};

/// Rollouts from first frames that were trained on and from observed ones.
pub fn observed_starts(text: &mut String, several: &[&Results]) -> std::fmt::Result {
    let starts = ObservedStarts::of(several);
    if starts.is_empty() {
        return Ok(());
    }
    writeln!(
        text,
        "| model | settings | first frames trained on: DTW MSE | observed: DTW MSE | observed : trained on | below {NO_WORSE} (our threshold) | training, s | observing, s | time saved, s | folds |"
    )?;
    writeln!(text, "{}|", "|---".repeat(10))?;
    for s in &starts {
        let interval = s.interval.map_or(String::new(), |interval| format!(" ({interval})"));
        writeln!(
            text,
            "| {} | {} | {} | {} | {}{interval} | {} | {} | {} | {} | {} |",
            s.model.id(),
            s.label,
            spread(&s.trained_on, 5),
            spread(&s.observed, 5),
            fixed(s.ratio, 2),
            s.no_worse.word(),
            spread(&s.training_seconds, 1),
            spread(&s.observing_seconds, 3),
            fixed(s.training_seconds.mean - s.observing_seconds.mean, 1),
            s.observed.count
        )?;
    }
    writeln!(
        text,
        "\nThe observing model was trained without the trial held out. The ratio is compared trial by trial: the median with its interval by the sign test, with fewer than six trials the mean with that by Student's t. The time saved counts when there is a model of the other trials already.\n"
    )
}
