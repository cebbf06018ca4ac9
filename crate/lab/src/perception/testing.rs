//! A small study for tests: bodies that sway from side to side.

use crate::perception::design::Preset;
use crate::perception::movement::FigureMovement;
use crate::perception::stimulus::{Generated, MovementSource, Scores, Stimulus};
use crate::perception::study::{Figure, Look, Study, Texts};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use vcgpdm_core::models::variational::BoundTerms;
use vcgpdm_core::models::{DmpSettings, Settings, TmpSettings, VariationalSettings};
use vcgpdm_core::motion::landmarks::Landmarks;

const FRAMES: usize = 36;

fn movement(width: f32) -> FigureMovement {
    let places = (0..FRAMES).flat_map(|frame| {
        let x = width * (0.3 * frame as f32).sin();
        [x, 1.0, 0.0, x, 1.7, 0.0]
    });
    FigureMovement::new(&places.collect::<Vec<_>>(), 2, 0.001).unwrap()
}

/// The candidates of the study, each with predictions of two trials.
pub fn candidates() -> Vec<Settings> {
    let ips = |dynamics_ips, pose_ips| VariationalSettings {
        dynamics_ips,
        pose_ips,
        ..VariationalSettings::default()
    };
    let tmp = |count| Settings::Tmp(TmpSettings { primitives: Some(count), normalised_time: false });
    vec![
        Settings::Vgpdm(ips(4, 4)),
        Settings::Vgpdm(ips(8, 4)),
        Settings::Vgpdm(ips(4, 8)),
        Settings::Vcgpdm(ips(8, 8)),
        tmp(3),
        tmp(5),
        tmp(7),
        Settings::DmpDiscrete(DmpSettings { bases: 10 }),
        Settings::DmpDiscrete(DmpSettings { bases: 25 }),
    ]
}

/// Four natural movements, one of them unseen, two movements of each candidate, and a failed one.
pub fn study() -> Study {
    let natural = |k: usize| Stimulus {
        id: format!("natural-{k}"),
        trial: format!("walk {k}"),
        source: MovementSource::Natural { seen: k < 4 },
        speed: 1.25,
        movement: movement(0.1 * k as f32),
    };
    let mut stimuli: Vec<Stimulus> = (1..=4).map(natural).collect();
    let mut add = |name: &str, candidate: &Settings, trial: usize, failed: bool, mse: f64| {
        let variational = matches!(candidate, Settings::Vcgpdm(_) | Settings::Vgpdm(_));
        let terms = BoundTerms {
            kinematics: vec![500.0 - 10.0 * mse],
            dynamics: vec![-20.0 * mse],
            initial: -3.5,
            entropy: 40.25,
        };
        let bound = match candidate {
            Settings::Tmp(_) => Some(400.0 - 30.0 * mse),
            _ => variational.then(|| terms.total()),
        };
        let terms = variational.then_some(terms);
        let scores = Scores { mse: 2.0 * mse, dtw_mse: mse, training_mse: Some(0.5 * mse), bound, terms };
        let generated = Generated {
            candidate: candidate.clone(),
            seed: if candidate.is_random() { 3 } else { 0 },
            failed,
            scores,
        };
        stimuli.push(Stimulus {
            id: format!("{name}-trial-{trial}"),
            trial: format!("walk {trial}"),
            source: MovementSource::Generated(Box::new(generated)),
            speed: 1.3,
            movement: movement(0.1 + mse as f32),
        });
    };
    for (k, candidate) in candidates().iter().enumerate() {
        for trial in 1..=2 {
            add(&format!("c{k}"), candidate, trial, false, 0.1 * (k + trial) as f64);
        }
    }
    add("failed", &candidates()[0], 3, true, 9.0);
    Study {
        title: "Sways".to_owned(),
        look: Look::Figure,
        frames_per_second: 30,
        seconds: 1.2,
        cross_seconds: 0.75,
        texts: Texts::default(),
        design: Preset::Class.design(5),
        figure: Figure {
            names: vec!["hips".to_owned(), "hips end".to_owned()],
            parents: vec![None, Some(0)],
            joints: 1,
            landmarks: Landmarks { head: Some(1), feet: None, dots: vec![0, 1] },
        },
        height: 1.7,
        unit: 0.001,
        stimuli,
    }
}

/// The answers of a participant, as jsPsych writes them. `rate` is how often a movement is taken for the
/// natural one. A participant who does not look answers at random.
pub fn answers(
    study: &Study,
    name: &str,
    seed: u32,
    looks: bool,
    rate: &dyn Fn(&Generated) -> f64,
) -> String {
    let mut random = ChaCha8Rng::seed_from_u64(seed.into());
    let mut uniform = || f64::from(random.next_u32()) / f64::from(u32::MAX);
    let mut text = "\"rt\",\"trial_type\",\"trial_index\",\"participant\",\"study\",\"block\",\"kind\",\"left\",\"right\",\"natural_side\",\
                    \"response\",\"heading\",\"started_apart_ms\",\"lasted_ms\"\r\n\"1234\",\"html-button-response\",\"0\",\"\",\"\",\"\",\"\",\
                    \"\",\"\",\"\",\"0\",\"\",\"\",\"\"\r\n"
        .to_owned();
    let hash = study.hash().unwrap();
    for (k, trial) in study.trials(seed).iter().enumerate() {
        let (left, right) = (&study.stimuli[trial.left], &study.stimuli[trial.right]);
        let fooled = match left.generated().or(right.generated()) {
            _ if !looks => uniform() < 0.5,
            None => uniform() < 0.5,
            Some(generated) if generated.failed => false,
            Some(generated) => uniform() < rate(generated),
        };
        let generated_left = left.natural() != Some(true);
        let response = if fooled == generated_left { "left" } else { "right" };
        let fields = [
            "4100.5".to_owned(),
            "side-by-side".to_owned(),
            (k + 1).to_string(),
            name.to_owned(),
            hash.clone(),
            trial.block.to_string(),
            trial.kind.id().to_owned(),
            left.id.clone(),
            right.id.clone(),
            trial.natural_side.id().to_owned(),
            response.to_owned(),
            trial.heading_degrees.to_string(),
            "0.3".to_owned(),
            "1200".to_owned(),
        ];
        text += &(fields.map(|field| format!("\"{field}\"")).join(",") + "\r\n");
    }
    text
}
