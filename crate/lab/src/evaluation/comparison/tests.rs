use super::*;
use crate::evaluation::summary::ClaimAnswer;
use crate::evaluation::testing::{finished, map, outcome, results, setting, variational};
use approx::assert_relative_eq;
use vcgpdm_core::models::{
    DmpSettings, EndReason, ModelKind, PoseWeight, Settings, TmpSettings, VariationalSettings,
};

#[test]
fn seeds_are_averaged_before_folds() {
    let mut jobs = Vec::new();
    let candidate = || Settings::Vgpdm(variational(8));
    for (fold, seed, mse) in [(0, 0, 1.0), (0, 1, 3.0), (1, 0, 6.0)] {
        jobs.push(finished(candidate(), fold, 2, seed, outcome(mse, Some(10.0), 100, 1.0)));
    }
    // Trained on fewer trials: no row of the table.
    jobs.push(finished(candidate(), 2, 1, 0, outcome(100.0, Some(10.0), 50, 1.0)));
    let found = Comparison::new(&results(3, &jobs));
    assert_eq!(found.models.len(), 1);
    let row = &found.models[0];
    assert_eq!((row.folds, row.runs, row.mse.count), (2, 3, 2));
    // Means 2 and 6 of the folds: mean 4, standard error |6 - 2| / 2.
    assert_relative_eq!(row.mse.mean, 4.0);
    assert_relative_eq!(row.mse.standard_error.unwrap(), 2.0);
    assert_relative_eq!(row.mse_median, 4.0);
    assert!(found.claims.is_empty() && found.correlations.is_empty() && found.growth.is_empty());
}

/// The answer to the claim at `place` whose finding contains these words.
fn answer(found: &Comparison, place: &str, words: &str) -> ClaimAnswer {
    let mut of_place = found.claims.iter().filter(|c| c.place.contains(place) && c.found.contains(words));
    let claim = of_place.next().unwrap_or_else(|| panic!("{place}, {words}: {:#?}", found.claims));
    assert!(of_place.next().is_none(), "{place}, {words}: {:#?}", found.claims);
    claim.answer
}

#[test]
fn claims_use_the_setting_with_the_best_rollouts_on_the_training_trials() {
    let mut jobs = Vec::new();
    for fold in 0..10 {
        let hard = 1.0 + 0.3 * (fold + 1) as f64;
        let mut add = |candidate: Settings, mse: f64, bound: Option<f64>| {
            jobs.push(finished(candidate, fold, 9, 0, outcome(hard * mse, bound, 100, 1.0)));
        };
        // Two wild folds in favour of the claim, as many a MAP rollout has.
        add(Settings::MapGpdm(map(false)), 0.4, None);
        add(Settings::MapCgpdm(map(false)), if [2, 5].contains(&fold) { 99.0 } else { 0.25 }, None);
        add(Settings::MapGpdm(map(true)), 0.25, None);
        // Rollouts prefer 12, the bound 8; 16 happens to predict better.
        for (ips, mse, trained_on, bound) in [(8, 0.5, 0.4, 3.0), (12, 0.3, 0.1, 1.0), (16, 0.2, 0.2, 2.0)] {
            for (kind, factor, more) in
                [(Settings::Vcgpdm as fn(_) -> _, 1.0, 0.0), (Settings::Vgpdm, 1.05, 5.0)]
            {
                let mut outcome = outcome(hard * factor * mse, Some(bound + more), 100, 1.0);
                outcome.training_mse = Some(trained_on);
                jobs.push(finished(kind(variational(ips)), fold, 9, 0, outcome));
            }
        }
    }
    let found = Comparison::new(&results(10, &jobs));
    // Better than the plain GPDM, not than the balanced one; of ten trials the wild ones leave the CGPDM
    // undecided.
    assert_eq!(answer(&found, "3.2", "12 + 12 inducing points compared with MAP GPDM"), ClaimAnswer::Yes);
    assert_eq!(answer(&found, "not in the papers", "MAP GPDM, balanced"), ClaimAnswer::No);
    assert_eq!(answer(&found, "3.2", "compared with MAP CGPDM"), ClaimAnswer::Undecided);
    assert_eq!(answer(&found, "5.3", "compared with vGPDM"), ClaimAnswer::Yes);
    // Not the best of all if one is better, or if that is undecided.
    assert_eq!(answer(&found, "3.2", "lower in 10 of 10"), ClaimAnswer::Undecided);
    // 0.5 is not nearly 0.3. One setting for each number of pose points: bound and error correlate over all.
    assert_eq!(answer(&found, "5.3", "vCGPDM, of 3 settings the one"), ClaimAnswer::No);
    assert_eq!(answer(&found, "3.2", "vCGPDM, all sizes: 0.50"), ClaimAnswer::No);
    // The bounds prefer the whole body, which predicts worse: in every trial.
    assert_eq!(answer(&found, "2020", "the preferred one"), ClaimAnswer::No);
    assert_eq!(found.evidence.len(), 10);
    assert_eq!(found.parts, ["lower"]);
    // In the table, 12 stands for the three of its kind; a MAP model that is balanced differs in more
    // than its size.
    let stand: Vec<usize> = found.models.iter().map(|model| model.stands_for).collect();
    assert_eq!(stand, [0, 3, 0, 0, 3, 0, 1, 1, 1]);
    assert_relative_eq!(found.evidence[2].log_bayes_factor, -5.0);
    assert_relative_eq!(found.evidence[2].error_ratio, 1.0 / 1.05, epsilon = 1e-12);
    assert_eq!(found.evidence[2].trial, "walk 3");
}

#[test]
fn three_parts_have_claims_of_their_own() {
    let with = |three: f64, tmp: f64| {
        let mut setting = setting(7);
        setting.parts = vec![setting.parts[0].clone(); 3];
        let mut found = Results::new(setting);
        for fold in 0..7 {
            let hard = 1.0 + 0.3 * fold as f64;
            let candidates = [
                (Settings::Vcgpdm(variational(8)), three),
                (Settings::Vgpdm(variational(8)), 1.0),
                (Settings::Tmp(TmpSettings::default()), tmp),
            ];
            for (candidate, mse) in candidates {
                found.add(finished(candidate, fold, 6, 0, outcome(hard * mse, None, 100, 1.0))).unwrap();
            }
        }
        let found = Comparison::new(&found);
        // What the papers say of two parts is no heading for three.
        assert!(found.claims.iter().all(|c| !c.claim.contains("2-part") && !c.claim.contains("waving")));
        ["clear advantage", "on par with the TMP"].map(|words| {
            let claim = found.claims.iter().find(|claim| claim.claim.contains(words)).unwrap();
            claim.answer
        })
    };
    assert_eq!(with(1.0, 1.05), [ClaimAnswer::Yes, ClaimAnswer::Yes]);
    assert_eq!(with(1.5, 1.0), [ClaimAnswer::Yes, ClaimAnswer::No]);
    assert_eq!(with(0.5, 1.0), [ClaimAnswer::No, ClaimAnswer::No]);
}

/// As after a cancelled run: only the first model has the last two trials, which are hard.
#[test]
fn compares_models_over_the_trials_that_both_have() {
    let mut jobs = Vec::new();
    let mut add = |candidate: Settings, fold: usize, mse: f64| {
        jobs.push(finished(candidate, fold, 2, 0, outcome(mse, Some(1.0), 100, 1.0)));
    };
    for (fold, mse) in [(0, 0.2), (1, 0.9), (2, 0.9)] {
        add(Settings::Vcgpdm(variational(12)), fold, mse);
    }
    add(Settings::Vgpdm(variational(12)), 0, 0.25);
    let found = Comparison::new(&results(3, &jobs));
    let claim = found.claims.iter().find(|c| c.place == "2018, section 5.3").unwrap();
    assert!(claim.found.contains("0.80 times in the median of 1 trial,"), "{claim:?}");
    // A single trial has no interval: nothing is decided.
    assert!(found.claims.iter().all(|claim| claim.answer == ClaimAnswer::Undecided), "{:?}", found.claims);
    // The table shows all trials of each model.
    assert_eq!((found.models[0].folds, found.models[1].folds), (3, 1));
    assert_relative_eq!(found.models[0].mse.mean, 2.0 / 3.0);
    // Models without a common trial are not compared.
    jobs[3].job.held_out = 1;
    jobs.retain(|f| f.job.held_out != 1 || f.job.candidate.kind() == ModelKind::Vgpdm);
    assert!(Comparison::new(&results(3, &jobs)).claims.is_empty());
}

#[test]
fn several_comparisons_are_put_together_trial_by_trial() {
    let subject = |ratios: &[f64]| {
        let mut jobs = Vec::new();
        for (k, ratio) in ratios.iter().enumerate() {
            let mut add = |candidate, mse| {
                jobs.push(finished(candidate, k, ratios.len() - 1, 0, outcome(mse, Some(1.0), 100, 1.0)));
            };
            add(Settings::Vcgpdm(variational(12)), ratio * (k + 1) as f64);
            add(Settings::Vgpdm(variational(12)), (k + 1) as f64);
        }
        results(ratios.len(), &jobs)
    };
    let (a, b) = (subject(&[0.9, 0.95, 1.02, 0.92]), subject(&[0.9, 0.8, 0.97, 0.93, 0.94, 0.9]));
    let pays = |found: &Comparison| answer(found, "5.3", "compared with vGPDM");
    assert_eq!(pays(&Comparison::new(&a)), ClaimAnswer::Undecided);
    let both = Comparison::of_several(&[&a, &b]);
    // Two persons are few, though the error is lower in nine of ten trials.
    assert_eq!((pays(&both), both.models[0].folds, both.evidence.len()), (ClaimAnswer::Undecided, 10, 10));
    assert!(
        both.claims.iter().any(|claim| claim.primary && claim.found.contains("in the mean of 2 persons"))
            && both.claims.iter().any(|claim| !claim.primary && claim.found.contains("lower in 9 of 10"))
    );
    // A size of one person alone does not count where only what both have is compared.
    let mut wide = a.clone();
    let more = finished(Settings::Vcgpdm(variational(20)), 0, 3, 0, outcome(0.1, Some(9.0), 100, 1.0));
    wide.add(more).unwrap();
    assert_eq!((wide.in_common(&[&wide, &b]), b.in_common(&[&wide, &b])), (a, b));
}

/// Coupled and uncoupled parts, and a whole body as large, are compared at the sizes that both have.
#[test]
fn compares_variants_at_the_same_sizes() {
    let mut setting = setting(10);
    setting.parts.push(setting.parts[0].clone());
    let mut found = Results::new(setting);
    for fold in 0..10 {
        let mut add = |candidate: Settings, mse: f64| {
            let outcome = outcome(mse * (fold + 1) as f64, Some(1.0), 100, 1.0);
            found.add(finished(candidate, fold, 9, 0, outcome)).unwrap();
        };
        add(Settings::Vcgpdm(variational(10)), 0.5);
        add(Settings::Vcgpdm(variational(20)), 0.1);
        add(Settings::Vcgpdm(variational(10).with_uncoupled(true)), 1.0);
        add(Settings::Vgpdm(variational(20).with_latent(6)), 0.5);
        add(Settings::Vcgpdm(variational(20).with_order(3)), 0.05);
    }
    let found = Comparison::new(&found);
    let ours = "not in the papers";
    let words = "10 + 10 inducing points, order 2 compared with vCGPDM, 10 + 10 inducing points, order 2, uncoupled: 0.50";
    assert_eq!(answer(&found, ours, words), ClaimAnswer::Yes);
    // The large whole body is the counterpart of 10 + 10 points, and the only vGPDM.
    let words = "vCGPDM, 10 + 10 inducing points, order 2 compared with vGPDM, 20 + 20 inducing points: 1.00";
    assert_eq!(answer(&found, ours, words), ClaimAnswer::Undecided);
    let words =
        "20 + 20 inducing points, order 2 compared with vCGPDM, 20 + 20 inducing points, order 3: 2.00";
    assert_eq!(answer(&found, ours, words), ClaimAnswer::No);
    assert_eq!(found.claims.iter().filter(|claim| claim.primary).count(), 3);
}

#[test]
fn decides_whether_a_dmp_is_best_with_25_bases() {
    let with = |errors: [f64; 3]| {
        let mut jobs = Vec::new();
        for fold in 0..6 {
            for (bases, mse) in [5, 25, 100].into_iter().zip(errors) {
                let candidate = Settings::DmpDiscrete(DmpSettings { bases });
                let outcome = outcome(mse * (fold + 1) as f64, None, 100, 1.0);
                jobs.push(finished(candidate, fold, 5, 0, outcome));
            }
        }
        answer(&Comparison::new(&results(6, &jobs)), "2019, section 4.2", "5 bases compared with 25")
    };
    assert_eq!(with([3.0, 1.0, 1.5]), ClaimAnswer::Yes);
    assert_eq!(with([3.0, 1.0, 0.9]), ClaimAnswer::No);
    assert_eq!(with([3.0, 1.0, 1.0]), ClaimAnswer::Undecided);
}

#[test]
fn correlates_bound_and_error_over_the_trials_of_all_settings() {
    let mut jobs = Vec::new();
    let mut add = |ips: usize, fold: usize, mse: f64, bound: f64| {
        let candidate = Settings::Vgpdm(VariationalSettings { pose_ips: 8, ..variational(ips) });
        jobs.push(finished(candidate, fold, 2, 0, outcome(mse, Some(bound), 100, 1.0)));
    };
    // In the first fold, the higher the bound, the lower the error. The second fold is longer, so that its
    // bounds are higher, and hard.
    for (ips, mse, bound) in [(4, 0.3, 10.0), (8, 0.2, 20.0), (12, 0.1, 30.0)] {
        add(ips, 0, mse, bound);
    }
    add(4, 1, 0.9, 500.0);
    add(8, 1, 0.8, 600.0);
    let found = Comparison::new(&results(3, &jobs));
    let correlation = &found.correlations[0];
    assert_relative_eq!(correlation.rank, -1.0);
    assert_eq!((correlation.settings, correlation.folds), (3, 1));
    assert_eq!(correlation.points.iter().map(|p| p.bound).collect::<Vec<_>>(), [10.0, 20.0, 30.0]);
    assert!(found.claims.iter().any(|claim| claim.found.contains("vGPDM: -1.00 over 3 settings")));
    // Chosen on the first fold, where 12 is best, though the mean bound of 8 over its folds is higher.
    let claim = &found.claims[0].found;
    assert!(claim.starts_with("vGPDM, of 3 settings the one") && claim.contains("1.00 times"), "{claim}");
    // A setting that has only another trial: nothing to compare.
    jobs[0].job.held_out = 2;
    jobs.retain(|f| f.job.held_out != 1);
    let found = Comparison::new(&results(3, &jobs));
    assert!(found.correlations.is_empty() && found.claims.is_empty(), "{:?}", found.claims);
}

#[test]
fn does_not_mix_settings_that_differ_in_more_than_size() {
    let mut jobs = Vec::new();
    let mut add = |ips: usize, max_iterations: usize, fold: usize, mse: f64, bound: f64| {
        let candidate = Settings::Vgpdm(VariationalSettings { max_iterations, ..variational(ips) });
        jobs.push(finished(candidate, fold, 1, 0, outcome(mse, Some(bound), 100, 1.0)));
    };
    // A few iterations find worse models; those of many iterations have more results.
    for (ips, mse, bound) in [(4, 0.7, 1.0), (8, 0.8, 2.0), (12, 0.9, 3.0)] {
        add(ips, 10, 0, mse, bound);
    }
    for (ips, mse, bound) in [(4, 0.3, 11.0), (8, 0.2, 12.0), (12, 0.1, 13.0)] {
        add(ips, 800, 0, mse, bound);
        add(ips, 800, 1, mse, bound);
    }
    let found = Comparison::new(&results(2, &jobs));
    let groups: Vec<(&str, f64)> = found.correlations.iter().map(|c| (&c.label[..], c.rank)).collect();
    assert_eq!(
        groups.iter().map(|(label, _)| *label).collect::<Vec<_>>(),
        ["10 iterations", "800 iterations"]
    );
    assert_relative_eq!(groups[0].1, 1.0);
    assert_relative_eq!(groups[1].1, -1.0);
    assert_eq!(found.models[5].label, "12 + 12 inducing points, 800 iterations");
    assert_eq!(
        found.models[5].candidate,
        Settings::Vgpdm(VariationalSettings { max_iterations: 800, ..variational(12) }).into()
    );
    let texts: Vec<&str> = found.claims.iter().map(|claim| &claim.found[..]).collect();
    assert!(texts[0].contains("1.00 times") && texts[1].contains("-1.00 over 3 settings"), "{texts:?}");
}

#[test]
fn compares_times_over_the_same_folds_and_settings() {
    let mut jobs = Vec::new();
    for count in 1..=4usize {
        let frames = 100 * count;
        let cubic = (frames as f64).powi(3) * 1e-6;
        jobs.push(finished(Settings::MapCgpdm(map(false)), 0, count, 0, outcome(1.0, None, frames, cubic)));
        let linear = frames as f64 * 1e-3;
        let vcgpdm = || Settings::Vcgpdm(variational(12));
        jobs.push(finished(vcgpdm(), 0, count, 0, outcome(1.0, Some(1.0), frames, linear)));
    }
    // Another fold with only one number of trials, and another setting: neither shows growth.
    let odd = || outcome(1.0, Some(1.0), 400, 1e6);
    jobs.push(finished(Settings::Vcgpdm(variational(12)), 1, 4, 0, odd()));
    jobs.push(finished(Settings::Vcgpdm(variational(16)), 0, 4, 0, odd()));
    let found = Comparison::new(&results(5, &jobs));
    let exponents: Vec<f64> = found.growth.iter().map(|g| g.exponent.unwrap()).collect();
    assert_relative_eq!(exponents[0], 1.0, epsilon = 1e-9);
    assert_relative_eq!(exponents[1], 3.0, epsilon = 1e-9);
    assert_relative_eq!(found.growth[0].points[3].seconds, 0.04);
    assert_eq!(answer(&found, "supplement", "power 1.00 (1.00 to 1.00)"), ClaimAnswer::Yes);
    assert_eq!(answer(&found, "supplement", "power 3.00 (3.00 to 3.00)"), ClaimAnswer::Yes);
    // More frames can need more iterations: a training then grows faster than an iteration.
    for finished in &mut jobs {
        let count = finished.job.training_trials;
        let outcome = finished.outcome.as_mut().unwrap();
        outcome.iterations *= count;
        outcome.seconds *= count as f64;
        // The second is the sentence of an earlier version.
        let settled = [EndReason::BoundSettled.to_string(), "the weighted bound no longer rises".to_owned()];
        outcome.reason = Some(settled[count % 2].clone());
    }
    let found = Comparison::new(&results(5, &jobs));
    let vcgpdm = &found.growth[0];
    assert_relative_eq!(vcgpdm.exponent.unwrap(), 1.0, epsilon = 1e-9);
    assert_relative_eq!(vcgpdm.training_exponent.unwrap(), 2.0, epsilon = 1e-9);
    assert_eq!(vcgpdm.converged, Some(1.0));
    let words = "training grows with the power 2.00 (2.00 to 2.00) of the frames, of an iteration with the power 1.00";
    assert_eq!(answer(&found, "supplement", words), ClaimAnswer::No);
}

#[test]
fn distinguishes_errors_on_training_trials_and_on_trials_held_out() {
    let mut jobs = Vec::new();
    for fold in 0..7 {
        // Dynamics inducing points help with what was trained on, and the bound knows; the trial held out
        // is another matter.
        for (dynamics_ips, pose_ips, trained_on, bound) in
            [(5, 5, 0.9, 1.0), (30, 5, 0.4, 3.0), (5, 30, 0.8, 2.0), (30, 30, 0.3, 4.0), (20, 5, 0.5, 2.5)]
        {
            let settings = VariationalSettings { dynamics_ips, pose_ips, ..variational(5) };
            let mut outcome = outcome(0.5 + bound, Some(bound), 100, 1.0);
            outcome.training_mse = Some(trained_on * (1.0 + 0.1 * (fold + 1) as f64));
            jobs.push(finished(Settings::Vcgpdm(settings), fold, 6, 0, outcome));
        }
    }
    let found = Comparison::new(&results(7, &jobs));
    assert_relative_eq!(found.models[0].training_mse.as_ref().unwrap().mean, 0.9 * 1.4, epsilon = 1e-12);
    assert_eq!(
        answer(&found, "supplement", ", 5 pose points: 1.00 (1.00 to 1.00) over 3 settings"),
        ClaimAnswer::No
    );
    assert_eq!(answer(&found, "figure 6B", "-1.00 (-1.00 to -1.00) over 5 settings"), ClaimAnswer::Yes);
    let words = "30 + 5 inducing points compared with 5 + 30 inducing points: 0.50 times";
    assert_eq!(answer(&found, "figure 6B", words), ClaimAnswer::Yes);
    // Results of earlier versions do not have these errors.
    for finished in &mut jobs {
        finished.outcome.as_mut().unwrap().training_mse = None;
    }
    let found = Comparison::new(&results(7, &jobs));
    assert!(found.models[0].training_mse.is_none());
    assert!(found.claims.iter().all(|claim| !claim.place.contains("6B")), "{:?}", found.claims);
}

/// The plain bound of a model that was trained with another objective is no evidence for its split.
#[test]
fn bayes_factors_and_claims_need_plain_models() {
    let found = |pose_weight: PoseWeight| {
        let mut jobs = Vec::new();
        for fold in 0..6 {
            for (kind, bound) in [(Settings::Vcgpdm as fn(_) -> _, 3.0), (Settings::Vgpdm, 2.0)] {
                let candidate = kind(VariationalSettings { pose_weight, ..variational(8) });
                jobs.push(finished(candidate, fold, 5, 0, outcome(0.5, Some(bound), 100, 1.0)));
            }
        }
        Comparison::new(&results(6, &jobs))
    };
    let plain = found(PoseWeight::default());
    assert_eq!((plain.evidence.len(), plain.claims.is_empty()), (6, false));
    let balanced = found(PoseWeight::Balanced);
    assert_eq!((balanced.models.len(), balanced.evidence.len(), balanced.claims.len()), (2, 0, 0));
}
