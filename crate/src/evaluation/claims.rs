//! The claims of Velychko et al. (2017, 2018) about the models, held against results.

use super::candidate::Candidate;
use super::comparison::{Correlation, Growth, ModelSummary, Row};
use crate::learner::ModelKind;
use serde::Serialize;

/// What the papers say, and what these results say to it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "comparison"), derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Claim {
    /// The claim and its year.
    pub claim: String,
    /// What was found.
    pub found: String,
    /// Whether that agrees.
    pub holds: bool,
}

fn is_balanced(candidate: &Candidate) -> bool {
    matches!(candidate, Candidate::MapGpdm(s) | Candidate::MapCgpdm(s) if s.balanced)
}

/// The claims about which there are results.
pub(super) fn claims(rows: &[Row], correlations: &[Correlation], growth: &[Growth]) -> Vec<Claim> {
    use ModelKind::{MapCgpdm, MapGpdm, Vcgpdm, Vgpdm};
    let mut claims = Vec::new();
    let mut say = |claim: &str, found: String, holds: bool| {
        claims.push(Claim { claim: claim.to_owned(), found, holds });
    };
    let of = |kind: ModelKind, balanced: bool| {
        rows.iter().filter(move |(c, _)| c.kind() == kind && is_balanced(c) == balanced).map(|(_, s)| s)
    };
    // The setting that the bound prefers: whoever trains does not know the error on the trial held out.
    let chosen = |kind: ModelKind, balanced: bool| {
        let bound = |s: &ModelSummary| s.bound.as_ref().map_or(f64::NEG_INFINITY, |b| b.mean);
        of(kind, balanced).max_by(|a, b| bound(a).total_cmp(&bound(b)))
    };
    let chosen_mse = |kind: ModelKind| chosen(kind, false).map(|s| s.mse.mean);
    let best = |kind: ModelKind| of(kind, false).min_by(|a, b| a.mse.mean.total_cmp(&b.mse.mean));
    let variational = (chosen_mse(Vcgpdm), chosen_mse(Vgpdm));
    for (balanced, what) in [
        (false, "Both variational models predict better than both MAP models (2017, 2018)"),
        (
            true,
            "The same beside MAP models whose dynamics are balanced (Urtasun, Fleet & Fua 2006; not in the papers)",
        ),
    ] {
        if let ((Some(a), Some(b)), Some(c), Some(d)) =
            (variational, chosen(MapGpdm, balanced), chosen(MapCgpdm, balanced))
        {
            say(
                what,
                format!(
                    "MSE vCGPDM {a:.5}, vGPDM {b:.5} beside MAP GPDM {:.5} (median {:.5}), MAP CGPDM {:.5} (median {:.5})",
                    c.mse.mean, c.mse_median, d.mse.mean, d.mse_median
                ),
                a.max(b) < c.mse.mean.min(d.mse.mean),
            );
        }
    }
    let others = ModelKind::ALL.into_iter().filter(|kind| *kind != Vcgpdm).filter_map(best);
    if let (Some(a), Some(other)) = (variational.0, others.min_by(|a, b| a.mse.mean.total_cmp(&b.mse.mean))) {
        say(
            "The two-part vCGPDM predicts best of all models (2017, 2018)",
            format!(
                "MSE {a:.5}; of the others at best {:.5}: {}, {}",
                other.mse.mean, other.model, other.label
            ),
            a < other.mse.mean,
        );
    }
    if let (Some(a), Some(b)) = variational {
        let ratio = a / b;
        say(
            "Parts cost no precision: the vCGPDM's MSE is at most 1.1 times the vGPDM's (2018)",
            format!("{ratio:.2} times"),
            ratio <= 1.1,
        );
    }
    for kind in [Vcgpdm, Vgpdm] {
        let settings = of(kind, false).count();
        if let (Some(a), Some(least)) = (chosen_mse(kind), best(kind).filter(|_| settings > 2)) {
            let ratio = a / least.mse.mean;
            say(
                "Where the bound is highest, the MSE is nearly the lowest: at most 1.1 times it (2017, 2018)",
                format!("{} over {settings} settings: {ratio:.2} times", kind.id()),
                ratio <= 1.1,
            );
        }
    }
    for Correlation { model, settings, rank, .. } in correlations {
        if [Vcgpdm.id(), Vgpdm.id()].contains(&model.as_str()) {
            let claim = "The bound predicts the MSE: rank correlation below -0.5 over inducing points (2018)";
            say(claim, format!("{model} over {settings} settings: {rank:.2}"), *rank < -0.5);
        }
    }
    let exponent = |kind: ModelKind| growth.iter().find(|g| g.model == kind.id()).and_then(|g| g.exponent);
    if let Some(e) = exponent(Vcgpdm) {
        let claim =
            "The vCGPDM's learning time grows about linearly with the frames: exponent below 1.1 (2017)";
        say(claim, format!("{e:.2}"), e < 1.1);
    }
    if let Some(e) = exponent(MapCgpdm) {
        let claim = "The MAP CGPDM's learning time grows with an exponent above 2 (2017)";
        say(claim, format!("{e:.2}"), e > 2.0);
    }
    claims
}
