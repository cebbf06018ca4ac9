//! Bayes factors between splits of the body (Velychko 2020, equation 2.12), and the ratios of their errors.

use crate::evaluation::contender::{Choice, Contender};
use crate::evaluation::effect::Errors;
use crate::evaluation::rows::{Row, is_plain, settings};
use crate::evaluation::summary::Evidence;
use vcgpdm::models::ModelKind;

/// One entry for each fold that both models have. Both are of the same frames and columns, with a noise for
/// each part or one for all. Models with weighted pose terms do not count: their training did not maximise
/// the bound on the evidence.
pub(super) fn evidence(rows: &[Row], name: &dyn Fn(usize) -> String) -> Vec<Evidence> {
    let contender = |kind| Contender::new(settings(rows, kind, &is_plain), Choice::Bound);
    let (Some(parts), Some(whole)) = (contender(ModelKind::Vcgpdm), contender(ModelKind::Vgpdm)) else {
        return Vec::new();
    };
    let of_fold = |(fold, bound): (&usize, &f64)| {
        let (a, b) = (parts.errors.get(fold)?, whole.errors.get(fold)?);
        let log_bayes_factor = bound - whole.bounds.get(fold)?;
        (*b > 0.0).then(|| Evidence { trial: name(*fold), log_bayes_factor, error_ratio: a / b })
    };
    parts.bounds.iter().filter_map(of_fold).collect()
}

/// In each fold, the error of the split with the higher bound, and that of the other split.
pub(super) fn by_preference(parts: &Contender, whole: &Contender) -> (Errors, Errors) {
    let mut sides = (Errors::new(), Errors::new());
    for (fold, bound) in &parts.bounds {
        let Some(other) = whole.bounds.get(fold) else { continue };
        let (Some(a), Some(b)) = (parts.errors.get(fold), whole.errors.get(fold)) else { continue };
        let (preferred, other) = if bound > other { (a, b) } else { (b, a) };
        sides.0.insert(*fold, *preferred);
        sides.1.insert(*fold, *other);
    }
    sides
}
