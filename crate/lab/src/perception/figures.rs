//! The data of the papers' figures, a table each, as CSV.

use crate::perception::results::{Confusion, PerceptionResults, ScoreKind, SettingResult};
use serde::Serialize;

/// The data for a figure like one of the papers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct FigureTable {
    /// A name for the file of the figure.
    pub name: &'static str,
    /// What it holds: the figure of which paper.
    pub title: &'static str,
    /// The table.
    pub csv: String,
}

impl PerceptionResults {
    /// The data of figures 2 to 8 of Knopp et al. (2019), of figure 6 of Velychko et al. (2018) and of figure 2 of
    /// Velychko et al. (2017).
    pub fn figures(&self) -> Vec<FigureTable> {
        let table = |name, title, header: &str, rows: Vec<Vec<String>>| {
            let mut writer = csv::Writer::from_writer(format!("{header}\n").into_bytes());
            for row in rows {
                // Writing to memory cannot fail.
                let _ = writer.write_record(row);
            }
            let csv = String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default();
            FigureTable { name, title, csv }
        };
        vec![
            table(
                "settings.csv",
                "Knopp et al. 2019, figures 2, 3, 4 and 7; with the training MSE, Velychko et al. 2018, figure 6: rates, scores and sizes",
                SETTINGS,
                self.settings.iter().map(setting).collect(),
            ),
            table(
                "scores.csv",
                "Knopp et al. 2019, figures 5, 6 and 7; for the training MSE, Velychko et al. 2018, figure 6A: rates over each score",
                "model,settings,score,value,trials,rate,rate_sd",
                self.scores(),
            ),
            table(
                "regressions.csv",
                "Knopp et al. 2019, figures 5, 6 and 7: the curves' weights and ln K; for the training MSE and points, with ln K in place of the negative log probability, Velychko et al. 2017, figure 2C",
                "model,score,settings,trials,centre,scale,ceiling,w0,w0_se,w1,w1_se,folds,ln_k,ln_k_se,data_ln_k,data_ln_k_se",
                self.weights(),
            ),
            table(
                "curves.csv",
                "Knopp et al. 2019, figures 5, 6 and 7; for the training MSE, Velychko et al. 2018, figure 6A: the curves",
                "model,score,value,rate",
                self.regressions
                    .iter()
                    .flat_map(|r| points(&[&model(r.model), r.score.id()], &r.curve))
                    .collect(),
            ),
            table(
                "error-curves.csv",
                "Velychko et al. 2018, figure 6B: the exponential curves of the training MSE over the bound",
                "model,bound,training_mse",
                self.error_curves.iter().flat_map(|c| points(&[c.model.id()], &c.curve)).collect(),
            ),
            table(
                "best.csv",
                "Knopp et al. 2019, figure 8, above: the best setting of each kind",
                "model,settings,hits,trials,rate,rate_sd,above_half",
                self.best_rows(),
            ),
            table(
                "pairs.csv",
                "Knopp et al. 2019, figure 8, below: the probability that the first has the higher rate",
                "first,second,probability",
                self.pair_rows(),
            ),
            table(
                "orders.csv",
                "Knopp et al. 2019, section 4.4: orders of the kinds",
                "order,probability",
                self.order_rows(),
            ),
        ]
    }

    fn scores(&self) -> Vec<Vec<String>> {
        let rated = self.settings.iter().filter_map(|s| Some((s, s.scores.as_ref()?, s.confusion.as_ref()?)));
        let rows = rated.flat_map(|(setting, scores, confusion)| {
            ScoreKind::ALL.into_iter().filter_map(move |score| {
                let mut row = vec![setting.model.id().to_owned(), setting.label.clone()];
                row.extend([score.id().to_owned(), score.value(scores)?.to_string()]);
                row.extend(rate(confusion));
                Some(row)
            })
        });
        rows.collect()
    }

    fn weights(&self) -> Vec<Vec<String>> {
        let rows = self.regressions.iter().map(|r| {
            let error = |k: usize| r.errors.map(|errors| errors[k]);
            let mut row = vec![model(r.model), r.score.id().to_owned()];
            row.extend([r.settings, r.trials].map(|count| count.to_string()));
            row.extend([r.centre, r.scale, r.ceiling].map(|value| value.to_string()));
            row.extend([Some(r.weights[0]), error(0), Some(r.weights[1]), error(1)].map(number));
            row.push(r.folds.to_string());
            row.extend([r.log_bayes_factor, r.log_bayes_factor_error].map(number));
            row.extend([r.data_log_bayes_factor, r.data_log_bayes_factor_error].map(number));
            row
        });
        rows.collect()
    }

    fn best_rows(&self) -> Vec<Vec<String>> {
        let rows = self.best.iter().map(|best| {
            let Confusion { hits, trials, mean, deviation, above_half, .. } = best.confusion;
            let mut row = vec![best.model.id().to_owned(), best.label.clone()];
            row.extend([hits.to_string(), trials.to_string()]);
            row.extend([mean, deviation, above_half].map(|number| number.to_string()));
            row
        });
        rows.collect()
    }

    fn pair_rows(&self) -> Vec<Vec<String>> {
        let name = |place: usize| self.best[place].model.id().to_owned();
        let rows = self.pairs.iter().enumerate().flat_map(|(a, row)| {
            row.iter()
                .enumerate()
                .filter(move |(b, _)| *b != a)
                .map(move |(b, probability)| vec![name(a), name(b), probability.to_string()])
        });
        rows.collect()
    }

    fn order_rows(&self) -> Vec<Vec<String>> {
        let rows = self.orders.iter().map(|order| {
            let names: Vec<&str> = order.models.iter().map(|model| model.id()).collect();
            vec![names.join(" > "), order.probability.to_string()]
        });
        rows.collect()
    }
}

const SETTINGS: &str = "model,settings,dynamics_ips,pose_ips,primitives,bases,movements,failed,mse,dtw_mse,training_mse,bound,dynamics,pose,points,hits,trials,rate,rate_sd";

fn setting(setting: &SettingResult) -> Vec<String> {
    let size = &setting.size;
    let whole = |value: Option<usize>| value.map_or(String::new(), |value| value.to_string());
    let mut row = vec![setting.model.id().to_owned(), setting.label.clone()];
    row.extend([size.dynamics_ips, size.pose_ips, size.primitives, size.bases].map(whole));
    row.extend([setting.movements.to_string(), setting.failed.to_string()]);
    let scores = setting.scores.as_ref();
    row.extend(ScoreKind::ALL.map(|score| number(scores.and_then(|scores| score.value(scores)))));
    match &setting.confusion {
        Some(confusion) => {
            row.push(confusion.hits.to_string());
            row.extend(rate(confusion));
        }
        None => row.extend(["", "", "", ""].map(str::to_owned)),
    }
    row
}

/// Trials, rate and its standard deviation.
fn rate(confusion: &Confusion) -> [String; 3] {
    [confusion.trials.to_string(), confusion.mean.to_string(), confusion.deviation.to_string()]
}

/// A row for each point of a curve, after these names.
fn points(names: &[&str], curve: &[(f64, f64)]) -> Vec<Vec<String>> {
    let row = |(x, y): &(f64, f64)| {
        names.iter().map(|name| (*name).to_owned()).chain([x.to_string(), y.to_string()]).collect()
    };
    curve.iter().map(row).collect()
}

fn number(value: Option<f64>) -> String {
    value.map_or(String::new(), |value| value.to_string())
}

fn model(kind: Option<vcgpdm_core::models::ModelKind>) -> String {
    kind.map_or("all", |kind| kind.id()).to_owned()
}
