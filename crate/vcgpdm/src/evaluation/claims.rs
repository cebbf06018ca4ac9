//! The claims of Velychko et al. (2017, 2018) about the models, held against results.

use crate::evaluation::correlation::correlation;
use crate::evaluation::labels::Labels;
use crate::evaluation::rows::{Row, common_folds, groups};
use crate::evaluation::summary::{Claim, Growth};
use crate::models::ModelKind::{MapCgpdm, MapGpdm, Vcgpdm, Vgpdm};
use crate::models::{ModelKind, ModelSettings};
use std::collections::BTreeSet;

fn is_balanced(candidate: &ModelSettings) -> bool {
    matches!(candidate, ModelSettings::MapGpdm(s) | ModelSettings::MapCgpdm(s) if s.balanced)
}

/// The settings of a kind that are compared with each other, and the one that is held against other kinds.
struct Contender<'a, 'r> {
    settings: Vec<&'a Row<'r>>,
    /// The setting that the bound prefers: whoever trains does not know the error on the trial held out.
    chosen: &'a Row<'r>,
}

/// Of the plain or balanced settings of a kind; absent where there is nothing to choose by.
fn contender<'a, 'r>(rows: &'a [Row<'r>], kind: ModelKind, balanced: bool) -> Option<Contender<'a, 'r>> {
    let settings = settings(rows, kind, balanced);
    let chosen = match settings[..] {
        [only] => only,
        _ => {
            // A bound sums over frames: those of different trials cannot be compared.
            let folds = common_folds(&settings);
            let bounds = settings.iter().filter_map(|row| Some((*row, row.bound(&folds)?)));
            bounds.max_by(|(_, a), (_, b)| a.total_cmp(b))?.0
        }
    };
    Some(Contender { settings, chosen })
}

/// The plain or balanced settings of a kind that differ in size alone: of several such groups the one with most results, of
/// equally many the first.
fn settings<'a, 'r>(rows: &'a [Row<'r>], kind: ModelKind, balanced: bool) -> Vec<&'a Row<'r>> {
    let chosen = |row: &&Row| row.candidate.kind() == kind && is_balanced(row.candidate) == balanced;
    let runs = |group: &Vec<&Row>| group.iter().map(|row| row.runs()).sum::<usize>();
    groups(rows.iter().filter(chosen)).into_iter().rev().max_by_key(runs).unwrap_or_default()
}

/// The one with the least error over these folds, and that.
fn least<'a, 'r>(rows: &[&'a Row<'r>], folds: &BTreeSet<usize>) -> Option<(&'a Row<'r>, f64)> {
    let errors = rows.iter().filter_map(|row| Some((*row, row.mse(folds)?)));
    errors.min_by(|(_, a), (_, b)| a.total_cmp(b))
}

/// The claims about which there are results. All that a claim compares is compared over the same trials held out.
pub(super) fn claims(rows: &[Row], trials: usize, growth: &[Growth], labels: &Labels) -> Vec<Claim> {
    let mut claims = Vec::new();
    // Says so where not all trials count.
    let over = |folds: usize| {
        if folds < trials { format!(" (over {folds} of {trials} trials)") } else { String::new() }
    };
    let mut say = |claim: &str, found: String, holds: bool| {
        claims.push(Claim { claim: claim.to_owned(), found, holds });
    };
    let (vcgpdm, vgpdm) = (contender(rows, Vcgpdm, false), contender(rows, Vgpdm, false));
    for (balanced, what) in [
        (false, "Both variational models predict better than both MAP models (2017, 2018)"),
        (
            true,
            "The same beside MAP models whose dynamics are balanced (Urtasun, Fleet & Fua 2006; not in the papers)",
        ),
    ] {
        let (gpdm, cgpdm) = (contender(rows, MapGpdm, balanced), contender(rows, MapCgpdm, balanced));
        let (Some(a), Some(b), Some(c), Some(d)) = (&vcgpdm, &vgpdm, gpdm, cgpdm) else { continue };
        let all = [a.chosen, b.chosen, c.chosen, d.chosen];
        let folds = common_folds(&all);
        let [Some(a), Some(b), Some(c), Some(d)] = all.map(|row| row.mse(&folds)) else { continue };
        let [_, _, Some(c_median), Some(d_median)] = all.map(|row| row.mse_median(&folds)) else { continue };
        say(
            what,
            format!(
                "MSE vCGPDM {a:.5}, vGPDM {b:.5} beside MAP GPDM {c:.5} (median {c_median:.5}), MAP CGPDM {d:.5} (median {d_median:.5}){}",
                over(folds.len())
            ),
            a.max(b) < c.min(d),
        );
    }
    if let Some(a) = &vcgpdm {
        let kinds = ModelKind::ALL.into_iter().filter(|kind| *kind != Vcgpdm);
        let others: Vec<&Row> = kinds.flat_map(|kind| settings(rows, kind, false)).collect();
        let folds = common_folds(&[&others[..], &[a.chosen]].concat());
        if let (Some(mse), Some((best, least))) = (a.chosen.mse(&folds), least(&others, &folds)) {
            let (model, label) = (best.candidate.kind().title(), labels.label(best.candidate));
            say(
                "The two-part vCGPDM predicts best of all models (2017, 2018)",
                format!(
                    "MSE {mse:.5}; of the others at best {least:.5}: {model}, {label}{}",
                    over(folds.len())
                ),
                mse < least,
            );
        }
    }
    if let (Some(a), Some(b)) = (&vcgpdm, &vgpdm) {
        let folds = common_folds(&[a.chosen, b.chosen]);
        if let (Some(a), Some(b)) = (a.chosen.mse(&folds), b.chosen.mse(&folds))
            && b > 0.0
        {
            let ratio = a / b;
            say(
                "Parts cost no precision: the vCGPDM's MSE is at most 1.1 times the vGPDM's (2018)",
                format!("{ratio:.2} times{}", over(folds.len())),
                ratio <= 1.1,
            );
        }
    }
    let several = || [&vcgpdm, &vgpdm].into_iter().flatten().filter(|kind| kind.settings.len() > 2);
    for Contender { settings, chosen } in several() {
        let folds = common_folds(settings);
        if let (Some(a), Some((_, least))) = (chosen.mse(&folds), least(settings, &folds))
            && least > 0.0
        {
            let (ratio, kind, count) = (a / least, chosen.candidate.kind().title(), settings.len());
            say(
                "Where the bound is highest, the MSE is nearly the lowest: at most 1.1 times it (2017, 2018)",
                format!("{kind} over {count} settings: {ratio:.2} times{}", over(folds.len())),
                ratio <= 1.1,
            );
        }
    }
    for Contender { settings, .. } in several() {
        if let Some(c) = correlation(settings, String::new(), labels) {
            let claim = "The bound predicts the MSE: rank correlation below -0.5 over inducing points (2018)";
            let found =
                format!("{} over {} settings: {:.2}{}", c.model.title(), c.settings, c.rank, over(c.folds));
            say(claim, found, c.rank < -0.5);
        }
    }
    let exponent = |kind: ModelKind| growth.iter().find(|g| g.model == kind).and_then(|g| g.exponent);
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
