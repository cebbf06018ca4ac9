//! Models of tables: training, documents and rollouts.

use nalgebra::DMatrix;
use vcgpdm_core::document::Document;
use vcgpdm_core::models::{
    Dataset, DmpSettings, MapSettings, Model, RolloutRequest, SeriesModel, Settings, TmpSettings, Trainer,
    VariationalSettings,
};
use vcgpdm_core::series::{Table, parse_parts, read, write};

/// Two trials of two machines, the second of which follows the first. `size` scales the second column.
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

fn trained(size: f64, settings: Settings, split: &str) -> SeriesModel {
    let tables = tables(size);
    let parts = parse_parts(split, &tables[0].columns).unwrap();
    let dataset = Dataset::of_tables(&tables, &parts, 30.0).unwrap();
    let mut trainer = Trainer::new(&dataset, &settings, 1).unwrap();
    trainer.run();
    trainer.finish().unwrap()
}

const SMALL: VariationalSettings = VariationalSettings {
    latent: 2,
    order: 2,
    dynamics_ips: 6,
    pose_ips: 6,
    max_iterations: 40,
    pose_weight: vcgpdm::PoseWeight::Fixed(1.0),
    uncoupled: false,
    own_rollouts: false,
};
const TWO_PARTS: &str = "machine=x,y;follower=follower";

#[test]
fn models_of_tables_are_read_as_they_were_written() {
    let point = MapSettings { latent: 2, order: 2, max_iterations: 5, balanced: false, linear: false };
    let kinds = [
        (Settings::Vcgpdm(SMALL), TWO_PARTS),
        (Settings::Vgpdm(SMALL), "all=*"),
        (Settings::MapCgpdm(point), TWO_PARTS),
        (Settings::Tmp(TmpSettings { primitives: Some(3), normalised_time: false }), TWO_PARTS),
        (Settings::DmpDiscrete(DmpSettings { bases: 5 }), TWO_PARTS),
        (Settings::DmpRhythmic(DmpSettings { bases: 5 }), TWO_PARTS),
    ];
    for (settings, split) in kinds {
        let id = settings.kind().id();
        let model = trained(1.0, settings, split);
        let text = model.to_json().unwrap();
        let Document::Series(again) = Document::from_json(&text).unwrap() else { panic!("{id}: of a body") };
        assert_eq!(again.to_json().unwrap(), text, "{id}");
        let (rollout, rollout_again) = (model.rollout(1, 50).unwrap(), again.rollout(1, 50).unwrap());
        assert_eq!(rollout.shape(), (50, 3), "{id}");
        assert!((&rollout - &rollout_again).abs().max() < 1e-9, "{id}");
        assert!(
            (9.0..11.0).contains(&rollout[(0, 0)]) && (4.0..6.0).contains(&rollout[(0, 2)]),
            "{id}: {}",
            rollout.row(0)
        );
        let refused = Model::from_json(&text).unwrap_err().to_string();
        assert_eq!(refused, "expected a model of a body, found a model of tables", "{id}");
    }
}

/// The factor is a power of two, so that it changes no rounding.
#[test]
fn scaling_a_column_scales_its_rollout_and_changes_no_other_column() {
    let rollout = |size: f64| trained(size, Settings::Vcgpdm(SMALL), TWO_PARTS).rollout(0, 40).unwrap();
    let (large, small) = (rollout(1.0), rollout(1024.0));
    for row in 0..40 {
        assert!((1024.0 * large[(row, 1)] - small[(row, 1)]).abs() < 1e-9, "row {row}");
        assert!((large[(row, 2)] - small[(row, 2)]).abs() < 1e-12, "row {row}");
    }
}

#[test]
fn couplings_of_tables_can_be_changed() {
    let model = trained(1.0, Settings::Vcgpdm(SMALL), TWO_PARTS);
    let model = model.coupled().unwrap();
    let request = |alpha| vcgpdm_core::models::RolloutRequest { frames: 30, alpha, ..Default::default() };
    let learned = model.rollout(&request(None)).unwrap();
    assert_eq!((learned.latents.len(), learned.y.shape()), (2, (30, 3)));
    let mut alpha = model.model.alpha.clone();
    alpha[(0, 1)] = 100.0;
    assert!((&model.rollout(&request(Some(alpha))).unwrap().y - &learned.y).abs().max() > 1e-6);
}

#[test]
fn wrong_documents_of_tables_are_refused() {
    let text = trained(1.0, Settings::DmpDiscrete(DmpSettings { bases: 5 }), TWO_PARTS).to_json().unwrap();
    let refusal = |from: &str, to: &str| {
        assert!(text.contains(from), "{from} in {text}");
        Document::from_json(&text.replacen(from, to, 1)).err().unwrap().to_string()
    };
    assert!(
        refusal("\"columns\":[0,1]", "\"columns\":[0]")
            .contains("at parts: expected each column in one part")
    );
    assert!(refusal("{\"name\":\"x\",\"unit\":", "{\"name\":\"x\",\"unit\":-").contains("columns[0].unit"));
    assert!(refusal("\"version\":3", "\"version\":5").contains("version 4 or earlier"));
    let body = include_str!("documents/vcgpdm.json");
    assert!(matches!(Document::from_json(body), Ok(Document::Body(_))));
    assert!(Model::coupled_from_json(body).is_ok());
}

#[test]
fn a_model_of_tables_fills_in_the_column_that_is_missing() {
    let model =
        trained(1.0, Settings::Vcgpdm(VariationalSettings { max_iterations: 150, ..SMALL }), TWO_PARTS);
    let recorded = &tables(1.0)[1].values;
    let mut given = recorded.clone();
    given.column_mut(2).fill(f64::NAN);
    // A column that is given for some time only.
    given.view_mut((40, 0), (20, 2)).fill(f64::NAN);
    let model = model.coupled().unwrap();
    let found = model.fill(&RolloutRequest::default(), &given).unwrap();
    assert!(found.y.iter().all(|y| y.is_finite()));
    assert!(given.iter().zip(found.y.iter()).all(|(given, found)| given.is_nan() || given == found));
    let error = |rows: std::ops::Range<usize>| -> f64 {
        rows.map(|t| (found.y[(t, 2)] - recorded[(t, 2)]).powi(2)).sum::<f64>() / 20.0
    };
    // The follower's variance is 0.32.
    assert!(error(10..30) < 0.05 && error(40..60) < 0.15, "{} {}", error(10..30), error(40..60));
    let weights = found.weights.column_sum();
    assert!(found.latents.len() == 2 && weights.nrows() == 2, "{weights}");
    let narrow = model.fill(&RolloutRequest::default(), &given.columns(0, 1).into_owned());
    assert_eq!(narrow.unwrap_err().to_string(), "expected 3 columns, found 1");
}
