//! Time series that are no body: trained on, written, read, rolled out.

use nalgebra::DMatrix;
use vcgpdm::document::Document;
use vcgpdm::models::{
    Dataset, DmpSettings, MapSettings, Model, SeriesModel, Settings, TmpSettings, Trainer,
    VariationalSettings,
};
use vcgpdm::series::{Table, parts_from_words, read, write};

/// Two machines, the second of which follows the first; one column is counted in other units.
fn tables(size: f64) -> Vec<Table> {
    let names = ["x", "y", "follower"].map(str::to_owned);
    (0..2)
        .map(|trial| {
            let values = DMatrix::from_fn(60, 3, |row, column| {
                let phase = 0.25 * row as f64 + f64::from(trial);
                match column {
                    0 => 10.0 + phase.sin(),
                    1 => size * phase.cos(),
                    _ => 5.0 + 0.8 * (phase - 0.7).sin(),
                }
            });
            read(&format!("trial-{trial}.csv"), write(&names, &values, 0.02).as_bytes()).unwrap()
        })
        .collect()
}

fn trained(size: f64, settings: Settings, words: &str) -> SeriesModel {
    let tables = tables(size);
    let parts = parts_from_words(words, &tables[0].columns).unwrap();
    let dataset = Dataset::of_tables(&tables, &parts, 30.0).unwrap();
    let mut trainer = Trainer::new(&dataset, &settings, 1).unwrap();
    trainer.run();
    trainer.finish().unwrap()
}

const SMALL: VariationalSettings =
    VariationalSettings { latent: 2, order: 2, dynamics_ips: 6, pose_ips: 6, max_iterations: 40 };
const TWO: &str = "machine=x,y;follower=follower";

#[test]
fn models_of_tables_are_saved_and_opened_like_others() {
    let point = MapSettings { latent: 2, order: 2, max_iterations: 5, balanced: false, linear: false };
    let kinds = [
        (Settings::Vcgpdm(SMALL), TWO),
        (Settings::Vgpdm(SMALL), "all=*"),
        (Settings::MapCgpdm(point), TWO),
        (Settings::Tmp(TmpSettings { primitives: Some(3), normalised_time: false }), TWO),
        (Settings::DmpDiscrete(DmpSettings { bases: 5 }), TWO),
        (Settings::DmpRhythmic(DmpSettings { bases: 5 }), TWO),
    ];
    for (settings, words) in kinds {
        let id = settings.kind().id();
        let model = trained(1.0, settings, words);
        let text = model.to_json().unwrap();
        let Document::Series(again) = Document::from_json(&text).unwrap() else { panic!("{id}: of a body") };
        assert_eq!(again.to_json().unwrap(), text, "{id}");
        let (one, other) = (model.rollout(1, 50).unwrap(), again.rollout(1, 50).unwrap());
        assert_eq!(one.shape(), (50, 3), "{id}");
        assert!((&one - &other).abs().max() < 1e-9, "{id}");
        assert!(
            (9.0..11.0).contains(&one[(0, 0)]) && (4.0..6.0).contains(&one[(0, 2)]),
            "{id}: {}",
            one.row(0)
        );
        let refused = Model::from_json(&text).unwrap_err().to_string();
        assert_eq!(refused, "expected a model of a body, found a model of tables", "{id}");
    }
}

/// A power of two is exact: nothing is rounded otherwise on the way.
#[test]
fn a_column_counts_by_its_spread_and_not_by_its_unit() {
    let rolled = |size: f64| trained(size, Settings::Vcgpdm(SMALL), TWO).rollout(0, 40).unwrap();
    let (large, small) = (rolled(1.0), rolled(1024.0));
    for row in 0..40 {
        assert!((1024.0 * large[(row, 1)] - small[(row, 1)]).abs() < 1e-9, "row {row}");
        assert!((large[(row, 2)] - small[(row, 2)]).abs() < 1e-12, "row {row}");
    }
}

#[test]
fn couplings_of_tables_can_be_changed() {
    let model = trained(1.0, Settings::Vcgpdm(SMALL), TWO);
    let model = model.coupled().unwrap();
    let request = |alpha| vcgpdm::models::RolloutRequest { frames: 30, alpha, ..Default::default() };
    let learned = model.rollout(&request(None)).unwrap();
    assert_eq!((learned.latents.len(), learned.y.shape()), (2, (30, 3)));
    let mut alpha = model.model.alpha.clone();
    alpha[(0, 1)] = 100.0;
    assert!((&model.rollout(&request(Some(alpha))).unwrap().y - &learned.y).abs().max() > 1e-6);
}

#[test]
fn documents_of_tables_that_are_odd_are_refused() {
    let text = trained(1.0, Settings::DmpDiscrete(DmpSettings { bases: 5 }), TWO).to_json().unwrap();
    let refusal = |from: &str, to: &str| {
        assert!(text.contains(from), "{from} in {text}");
        Document::from_json(&text.replacen(from, to, 1)).err().unwrap().to_string()
    };
    assert!(
        refusal("\"columns\":[0,1]", "\"columns\":[0]")
            .contains("at parts: expected each column in one part")
    );
    assert!(refusal("{\"name\":\"x\",\"unit\":", "{\"name\":\"x\",\"unit\":-").contains("columns[0].unit"));
    assert!(refusal("\"version\":3", "\"version\":4").contains("version 3 or earlier"));
    let body = include_str!("documents/vcgpdm.json");
    assert!(matches!(Document::from_json(body), Ok(Document::Body(_))));
    assert!(Model::coupled_from_json(body).is_ok());
}
