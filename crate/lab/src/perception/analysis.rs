//! Analysis of answers: rates of the models, and their prediction from scores.

use crate::perception::answers::Answer;
use crate::perception::beta::Rate;
use crate::perception::counts::{Counted, participants, settings};
use crate::perception::error_curve::error_curves;
use crate::perception::ordering::ordering;
use crate::perception::paper::{trials_for_precision, trials_to_tell};
use crate::perception::regression::{Curve, Point, Standard};
use crate::perception::results::{
    AnalysisOptions, Best, Catch, Confusion, Needed, Order, PerceptionResults, Regression, ScoreKind,
    SettingResult,
};
use crate::perception::study::Study;
use crate::perception::trials::TrialKind;
use crate::perception::validation::log_bayes_factors;
use thiserror::Error;
use vcgpdm_core::models::ModelKind;

/// Orders with a smaller probability are not listed.
const UNLIKELY: f64 = 1e-3;

/// Why answers cannot be analysed.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum AnalysisError {
    /// An option out of its range.
    #[error("the {what}: expected {expected}, found {found}")]
    Option {
        /// The option.
        what: &'static str,
        /// Its range.
        expected: &'static str,
        /// The value found.
        found: f64,
    },
    /// No participant is left.
    #[error("expected an answered comparison of a participant who passed the attention checks, found none")]
    Empty,
}

impl PerceptionResults {
    /// The results of these answers to the study.
    ///
    /// # Errors
    /// An option is out of its range, or no participant is left who answered a comparison.
    pub fn new(study: &Study, answers: &[Answer], options: AnalysisOptions) -> Result<Self, AnalysisError> {
        check(&options)?;
        let participants = participants(study, answers, options.attention);
        let counted = Counted::new(study, answers, &participants);
        let all = counted.rate(|answer| answer.kind == TrialKind::Comparison);
        if all.trials == 0 {
            return Err(AnalysisError::Empty);
        }
        let settings = settings(&counted);
        let best = best(&settings);
        let rates: Vec<Rate> =
            best.iter().map(|best| Rate::new(best.confusion.hits, best.confusion.trials)).collect();
        let ordering = ordering(&rates, options.draws, options.seed);
        let likely = ordering.orders.into_iter().filter(|(_, probability)| *probability >= UNLIKELY);
        let orders = likely.map(|(order, probability)| Order {
            models: order.iter().map(|&place| best[place].model).collect(),
            probability,
        });
        let catch = counted.rate(|answer| answer.kind == TrialKind::Catch);
        Ok(Self {
            format: Self::FORMAT,
            version: Self::VERSION,
            engine: Self::ENGINE,
            title: study.title.clone(),
            study: study.hash().unwrap_or_default(),
            options,
            all: Confusion::new(all),
            regressions: regressions(&settings, &options),
            error_curves: error_curves(&settings),
            orders: orders.collect(),
            pairs: ordering.pairs,
            catch: (catch.trials > 0)
                .then(|| Catch { confusion: Confusion::new(catch), is_half: catch.is_half() }),
            needed: Needed {
                to_tell: trials_to_tell(0.1, 0.8),
                for_precision: trials_for_precision(0.1, 0.8),
            },
            participants,
            settings,
            best,
        })
    }
}

fn check(options: &AnalysisOptions) -> Result<(), AnalysisError> {
    let AnalysisOptions { ceiling, folds, draws, attention, .. } = *options;
    for (fits, what, expected, found) in [
        (ceiling > 0.0 && ceiling <= 1.0, "ceiling", "a number above 0, up to 1", ceiling),
        (AnalysisOptions::FOLDS.contains(&folds), "blocks", "from 2 to 1000", folds as f64),
        (AnalysisOptions::DRAWS.contains(&draws), "draws", "from 1 to 10000000", draws as f64),
        ((0.0..=1.0).contains(&attention), "attention", "a share from 0 to 1", attention),
    ] {
        if !fits {
            return Err(AnalysisError::Option { what, expected, found });
        }
    }
    Ok(())
}

/// The setting of each kind with the highest rate.
fn best(settings: &[SettingResult]) -> Vec<Best> {
    let of_kind = |kind: ModelKind| {
        let rated = settings.iter().enumerate().filter(|(_, setting)| setting.model == kind);
        let rated = rated.filter_map(|(place, setting)| Some((place, setting, setting.confusion?)));
        let (setting, result, confusion) = rated.max_by(|a, b| {
            let order = a.2.mean.total_cmp(&b.2.mean).then(a.2.trials.cmp(&b.2.trials));
            // The first of equal ones.
            order.then(b.0.cmp(&a.0))
        })?;
        Some(Best { model: kind, setting, label: result.label.clone(), confusion })
    };
    ModelKind::ALL.into_iter().filter_map(of_kind).collect()
}

fn regressions(settings: &[SettingResult], options: &AnalysisOptions) -> Vec<Regression> {
    let kinds = ModelKind::ALL.into_iter().map(Some).chain([None]);
    let pairs = kinds.flat_map(|kind| ScoreKind::ALL.map(|score| (kind, score)));
    pairs.filter_map(|(kind, score)| regression(settings, kind, score, options)).collect()
}

/// The prediction of the rates of a kind's settings from a score; absent if too few settings have the score,
/// or if it is the same for all.
fn regression(
    settings: &[SettingResult],
    model: Option<ModelKind>,
    score: ScoreKind,
    options: &AnalysisOptions,
) -> Option<Regression> {
    let of_kind = settings.iter().filter(|setting| model.is_none_or(|kind| kind == setting.model));
    let rated =
        of_kind.filter_map(|setting| Some((score.value(setting.scores.as_ref()?)?, setting.confusion?)));
    let rated: Vec<(f64, Confusion)> = rated.collect();
    let values: Vec<f64> = rated.iter().map(|(value, _)| *value).collect();
    let standard = Standard::of(&values)?;
    let point = |(value, confusion): &(f64, Confusion)| Point {
        score: standard.of_score(*value),
        hits: confusion.hits as f64,
        trials: confusion.trials as f64,
    };
    let points: Vec<Point> = rated.iter().map(point).collect();
    let curve = Curve::fit(&points, options.ceiling);
    let factors = log_bayes_factors(&points, options.ceiling, options.folds, options.seed);
    Some(Regression {
        model,
        score,
        settings: points.len(),
        trials: rated.iter().map(|(_, confusion)| confusion.trials).sum(),
        centre: standard.centre,
        scale: standard.scale,
        ceiling: options.ceiling,
        weights: curve.weights,
        errors: curve.errors(&points),
        log_bayes_factor: factors.map(|factors| factors.score.mean),
        log_bayes_factor_error: factors.map(|factors| factors.score.error),
        data_log_bayes_factor: factors.map(|factors| factors.data.mean),
        data_log_bayes_factor_error: factors.map(|factors| factors.data.error),
        folds: options.folds,
        curve: standard.drawn(|score| curve.rate(score)),
    })
}

vcgpdm_core::coded!(AnalysisError => Study);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::stats::mean;
    use crate::perception::answers::{AnswerFile, read};
    use crate::perception::design::Preset;
    use crate::perception::regression::DRAWN;
    use crate::perception::stimulus::Generated;
    use crate::perception::testing::{answers, study};

    /// The results of some participants, of which `blind` do not look.
    fn results(count: u32, blind: u32, rate: &dyn Fn(&Generated) -> f64) -> PerceptionResults {
        let study = study().with_preset(Preset::P3Part1);
        let texts: Vec<(String, String)> = (0..count)
            .map(|k| {
                let name = format!("p{k}");
                let text = answers(&study, &name, 100 + k, k >= blind, rate);
                (name, text)
            })
            .collect();
        let files: Vec<AnswerFile> = texts.iter().map(|(name, text)| AnswerFile { name, text }).collect();
        let options = AnalysisOptions { draws: 20_000, ..AnalysisOptions::default() };
        PerceptionResults::new(&study, &read(&study, &files).unwrap(), options).unwrap()
    }

    #[test]
    fn finds_the_score_that_observers_follow() {
        // Of the standardised test MSE of all settings.
        let mse: Vec<f64> = (0..9).map(|k| 0.2 * (f64::from(k) + 1.5)).collect();
        let centre = mean(&mse);
        let scale = (mse.iter().map(|m| (m - centre) * (m - centre)).sum::<f64>() / 9.0).sqrt();
        let truth = Curve { ceiling: 0.5, weights: [-0.3, 1.2] };
        let place = |generated: &Generated| {
            crate::perception::testing::candidates().iter().position(|c| *c == generated.candidate).unwrap()
        };
        let found = results(6, 2, &|generated| truth.rate((mse[place(generated)] - centre) / scale));
        let names: Vec<(&str, bool, usize)> =
            found.participants.iter().map(|p| (p.name.as_str(), p.excluded, p.comparisons)).collect();
        assert_eq!(
            names.iter().map(|(_, excluded, _)| *excluded).collect::<Vec<_>>(),
            [true, true, false, false, false, false]
        );
        assert!(names.iter().all(|(_, _, comparisons)| *comparisons == 620));
        assert_eq!(found.all.trials, 4 * 620);
        assert_eq!(found.settings.len(), 9);
        assert_eq!(found.settings.iter().map(|s| s.confusion.unwrap().trials).sum::<usize>(), 4 * 620);
        // A failed movement does not count for its setting.
        assert!(found.settings.iter().all(|s| s.movements == 2));
        assert_eq!(found.settings.iter().map(|s| s.failed).sum::<usize>(), 1);
        let of_all = |score: ScoreKind| {
            found.regressions.iter().find(|r| r.model.is_none() && r.score == score).unwrap()
        };
        let all = of_all(ScoreKind::Mse);
        assert_eq!((all.settings, all.trials), (9, 4 * 620));
        assert!((all.centre - centre).abs() < 1e-12 && (all.scale - scale).abs() < 1e-12);
        for (k, error) in all.errors.unwrap().into_iter().enumerate() {
            assert!((all.weights[k] - truth.weights[k]).abs() < 3.0 * error, "{all:?}");
        }
        assert!(all.log_bayes_factor.unwrap() > 5.0, "{all:?}");
        assert_eq!((all.curve.len(), all.curve[0].0), (DRAWN, mse[0]));
        for r in &found.regressions {
            assert!(r.data_log_bayes_factor >= r.log_bayes_factor, "{r:?}");
        }
        let points: Vec<f64> = found.settings.iter().filter_map(|s| s.scores.as_ref()?.points).collect();
        let soft = |k: f64, l: f64| -((-k).exp() + (-l).exp()).ln();
        let expected = [soft(8.0, 8.0), soft(4.0, 4.0), soft(4.0, 8.0), soft(8.0, 4.0)];
        let same = points.iter().zip(expected).all(|(point, expected)| (point - expected).abs() < 1e-12);
        assert!(points.len() == 4 && same, "{points:?}");
        let curves: Vec<_> = found.error_curves.iter().map(|curve| (curve.model, curve.settings)).collect();
        assert_eq!(curves, [(ModelKind::Vgpdm, 3), (ModelKind::Tmp, 3)]);
        // A curve needs three settings of a kind.
        let kinds: Vec<_> =
            found.regressions.iter().filter(|r| r.score == ScoreKind::Pose).map(|r| r.model).collect();
        assert_eq!(kinds, [Some(ModelKind::Vgpdm), None]);
        let kinds: Vec<_> =
            found.regressions.iter().filter(|r| r.score == ScoreKind::Mse).map(|r| r.model).collect();
        assert_eq!(kinds, [Some(ModelKind::Vgpdm), Some(ModelKind::Tmp), None]);
        // The lower the error, the higher the rate: the first kinds are the best.
        assert_eq!(found.best.len(), 4);
        assert_eq!(found.best.iter().map(|b| b.model).collect::<Vec<_>>()[3], ModelKind::DmpDiscrete);
        assert!(found.pairs[1][3] > 0.99 && (found.pairs[1][3] + found.pairs[3][1] - 1.0).abs() < 1e-12);
        assert!(found.orders.iter().map(|o| o.probability).sum::<f64>() > 0.98);
        let catch = found.catch.unwrap();
        assert_eq!(catch.confusion.trials, 24);
        assert_eq!(found.needed, Needed { to_tell: Some(158), for_precision: Some(162) });
    }

    #[test]
    fn gives_scores_without_information_no_weight() {
        let found = results(4, 0, &|_| 0.3);
        for r in &found.regressions {
            let factor = r.log_bayes_factor.unwrap();
            assert!((-1.0..0.8).contains(&factor), "{:?} {:?}: {factor}", r.model, r.score);
        }
        // Of settings that nobody takes for the natural one, the first with the fewest trials counts as the best.
        let never = results(1, 0, &|_| 0.0);
        for best in &never.best {
            let is_equal = |s: &SettingResult| s.model == best.model && s.confusion == Some(best.confusion);
            assert_eq!(never.settings.iter().position(is_equal), Some(best.setting));
        }
        let figures = found.figures();
        for figure in &figures {
            let mut widths =
                figure.csv.lines().map(|line| line.split("\",").count() + line.split(',').count());
            assert!(widths.next().is_some() && figure.csv.lines().count() > 1, "{}", figure.name);
        }
        assert_eq!(figures[0].csv.lines().count(), 10);
        assert!(
            serde_json::to_string(&found)
                .unwrap()
                .starts_with("{\"format\":\"vcgpdm perception\",\"version\":1,")
        );
    }

    #[test]
    fn refuses_answers_without_participants_and_odd_options() {
        let study = study();
        let text = answers(&study, "p", 1, true, &|_| 0.3);
        let found = read(&study, &[AnswerFile { name: "p", text: &text }]).unwrap();
        let error = |options| PerceptionResults::new(&study, &found, options).unwrap_err().to_string();
        let options = AnalysisOptions::default();
        let ceiling = error(AnalysisOptions { ceiling: 0.0, ..options });
        assert_eq!(ceiling, "the ceiling: expected a number above 0, up to 1, found 0");
        assert!(error(AnalysisOptions { folds: 1, ..options }).starts_with("the blocks: "));
        assert!(error(AnalysisOptions { draws: 0, ..options }).starts_with("the draws: "));
        assert!(error(AnalysisOptions { attention: f64::NAN, ..options }).starts_with("the attention: "));
        // Who passes every check passes the strictest share.
        let strict = AnalysisOptions { attention: 1.0, ..options };
        assert!(PerceptionResults::new(&study, &found, strict).is_ok());
        let study = study.with_preset(Preset::P3Part1);
        let blind = answers(&study, "q", 3, false, &|_| 0.3);
        let blind = read(&study, &[AnswerFile { name: "q", text: &blind }]).unwrap();
        assert!(PerceptionResults::new(&study, &blind, options) == Err(AnalysisError::Empty));
        assert_eq!(PerceptionResults::new(&study, &[], options), Err(AnalysisError::Empty));
    }
}
