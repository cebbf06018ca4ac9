//! Results of models, compared with those of earlier versions by their fingerprints. If a change of them is wanted, the
//! new fingerprints go into the test.

mod changed_documents;
#[path = "../../shared/fingerprint.rs"]
mod fingerprint;
mod limits;
mod trained;

use crate::combinations;
use crate::documents::{DOCUMENTS, is_library};
use crate::start_model::start_model;
use fingerprint::{fingerprint, numbers, without_sign_of_zero};
use std::fmt::{Debug, Display};
use std::sync::Arc;
use vcgpdm_core::document::Document;
use vcgpdm_core::models::library::CouplingTrainer;
use vcgpdm_core::models::{Cut, Endless, Handles, Model, PosePush, Push, Reading, RolloutRequest};
use vcgpdm_core::motion::{Clip, samples, sha256};

/// The results of one subject, one a line.
#[derive(Default)]
struct Lines(Vec<String>);

impl Lines {
    fn numbers<'a>(&mut self, what: &str, values: impl IntoIterator<Item = &'a f64>) {
        self.0.push(format!("{what}: {}", numbers(values)));
    }

    fn places(&mut self, what: &str, places: &[f32]) {
        let places: Vec<f64> = places.iter().map(|place| f64::from(*place)).collect();
        self.numbers(what, &places);
    }

    fn said(&mut self, what: &str, value: impl Debug) {
        self.0.push(without_sign_of_zero(&format!("{what}: {value:.3?}")));
    }

    /// Whether a request was carried out, or the error.
    fn answer<T, E: Display>(&mut self, what: &str, answer: Result<T, E>) {
        let text = answer.err().map_or_else(|| "yes".to_owned(), |error| error.to_string());
        self.0.push(format!("{what}: {text}"));
    }
}

fn short(id: &str, frames: usize) -> Clip {
    samples::clip(id).unwrap().resample(30.0).unwrap().cut(0, frames).unwrap()
}

/// Rollouts under couplings as learned, a tenth of them and a thousand times them: poses, health, log density, samples.
fn rollouts(model: &Model) -> Lines {
    let mut lines = Lines::default();
    let coupled = model.coupled().unwrap();
    let learned = &coupled.model.alpha;
    for (factor, reading) in
        [(0.1, Reading::AsLearned), (1.0, Reading::AsLearned), (1e3, Reading::ReInferred)]
    {
        let others = learned.map_with_location(|j, i, alpha| if i == j { alpha } else { factor * alpha });
        let request =
            RolloutRequest { frames: 90, alpha: Some(others), reading, ..RolloutRequest::default() };
        let rollout = coupled.rollout(&request).unwrap();
        lines.numbers("columns", &rollout.y);
        lines.numbers("weights", &rollout.weights);
        let positions = coupled.positions(&rollout).unwrap();
        lines.places("positions", &positions);
        lines.said("health", coupled.health(&rollout, &request, &positions).unwrap());
        lines.said("log density", coupled.latent_log_density(&rollout).unwrap());
        lines.said(
            "familiarity",
            coupled.model.familiarity(&rollout.latents).unwrap().concat().iter().sum::<f64>(),
        );
        let few = RolloutRequest { frames: 30, ..request.clone() };
        let moments = coupled.moments(&few).unwrap();
        lines.numbers("means", moments.means.iter().flatten());
        lines.numbers("covariances", moments.covariances.iter().flatten().flatten());
        for sampled in coupled.sampled_rollouts(&few, [3, 4]).unwrap() {
            lines.numbers("sample", &sampled.unwrap().y);
        }
        let points = rollout.latents[0].rows(20, 9) * 1.1;
        let field = coupled.model.latent_field(0, &points, &rollout.latents, &request).unwrap();
        lines
            .numbers("field", field.steps.iter().chain(&field.pose_variance).chain(&field.dynamics_variance));
        lines.places("pose", &coupled.pose(1, rollout.latents[1].row(5).transpose().as_slice()).unwrap());
    }
    let disturbed = RolloutRequest {
        frames: 60,
        cuts: vec![Cut { source: 0, target: 1, from: 12, to: 30 }],
        pushes: vec![Push { part: 1, frame: 20, ahead: -2.5, ..Push::default() }],
        ..RolloutRequest::default()
    };
    lines.numbers("disturbed", &coupled.rollout(&disturbed).unwrap().y);
    let cycle = coupled.model.cycle(0).unwrap().unwrap();
    lines.said("cycle", (cycle.period(), cycle.latents(0, 0.3)));
    lines
}

/// What a model infers from a clip that moves under other couplings.
fn observed(model: &Model) -> Lines {
    let mut lines = Lines::default();
    let coupled = model.coupled().unwrap();
    let alpha = Some(coupled.model.alpha.map(f64::sqrt));
    let other = coupled.rollout(&RolloutRequest { frames: 40, alpha, ..RolloutRequest::default() }).unwrap();
    let clip = coupled.clip(&other, "other.bvh").unwrap();
    for latents in coupled.latents_of_clip(&clip, 12).unwrap() {
        lines.numbers("latents", &latents);
    }
    let columns = coupled.body.encode(&clip).unwrap();
    for (given, cut) in [(0, None), (1, Some(25))] {
        let completion = coupled.complete(&RolloutRequest::default(), &columns, &[given], cut).unwrap();
        lines.numbers("completed", &completion.y);
        lines.said("errors", completion.parts);
    }
    let mut gaps = columns.clone();
    gaps.view_mut((10, 3), (8, 5)).fill(f64::NAN);
    lines.numbers("filled", &coupled.fill(&RolloutRequest::default(), &gaps).unwrap().y);
    lines
}

/// A motion without an end in which much is changed.
fn endless(model: Model) -> Lines {
    let mut lines = Lines::default();
    let owner = Arc::new(model);
    let coupled = owner.coupled().unwrap();
    let rollout = coupled.rollout(&RolloutRequest { frames: 40, ..RolloutRequest::default() }).unwrap();
    let mut live = Endless::after(owner.clone(), &rollout, 30, 0).unwrap();
    let latents = rollout.latents[1].rows(5, 20).into_owned();
    let node = coupled.body.mapping.skeleton().node_count() - 1;
    type Change<'a> = (&'a str, Box<dyn Fn(&mut Endless) + 'a>);
    let changes: Vec<Change> = vec![
        ("cut", Box::new(|live| live.cut(0, 1, true).unwrap())),
        ("joined", Box::new(|live| live.cut(0, 1, false).unwrap())),
        ("tempo", Box::new(|live| live.set_tempo(1, 0.7).unwrap())),
        ("push", Box::new(|live| live.push(&Push { part: 0, ahead: 3.0, ..Push::default() }).unwrap())),
        ("drive", Box::new(|live| live.drive(0, 0.4).unwrap())),
        ("released", Box::new(|live| live.release(0))),
        ("recording", Box::new(|live| live.record(1, latents.clone()).unwrap())),
        ("released again", Box::new(|live| live.release(1))),
        ("reach", Box::new(|live| live.reach(node, [0.3, 1.2, 0.4]).unwrap())),
        ("rewound", Box::new(|live| live.rewind(7).unwrap())),
        (
            "pull",
            Box::new(|live| {
                let push = live.pull(node, [0.0, 0.1, 0.1]).unwrap();
                live.push(&push).unwrap();
            }),
        ),
    ];
    for (name, change) in changes {
        change(&mut live);
        let next = live.advance(17).unwrap();
        lines.numbers(name, &next.y);
        lines.places(name, &next.positions);
        lines.said(name, (next.places.last().copied(), next.recorded.last().copied()));
    }
    lines
}

fn library() -> Lines {
    let mut lines = Lines::default();
    let trained = combinations::trained(15);
    let library = &trained.library;
    lines.said("stored", library.stored_numbers());
    let clip = short("walk-wave-3", 45);
    for uses in [[0, 2], [0, 3], [1, 2], [1, 3]] {
        let alpha = library.nearest_couplings(&uses);
        lines.numbers("couplings", &alpha);
        lines.said("starts", (library.start_sequences(&uses), library.motion(&uses, &alpha).unwrap()));
        lines.numbers("combination", &trained.combination(&uses, &alpha).unwrap().rollout(0, 60).unwrap());
        let mut endless = trained.endless_from(&uses, (1, 0, 12)).unwrap();
        lines.numbers("from", &endless.advance(20).unwrap().y);
        trained.use_primitive(&mut endless, 1, 5 - uses[1], None).unwrap();
        lines.numbers("other arms", &endless.advance(20).unwrap().y);
        let mut fit = CouplingTrainer::new(&trained, &uses, &[trained.encode(&clip).unwrap()], 6).unwrap();
        lines.said("fit", fit.run().best);
        lines.numbers("fitted", &fit.alpha());
    }
    let recognition = trained.recognise(&[&short("walk-4", 40), &clip]).unwrap();
    lines.said("segments", recognition.segments());
    lines.numbers("arms", &recognition.part_posterior(1));
    lines
}

/// Rollouts of models of the other kinds, with handles where a kind has them.
fn handles() -> Lines {
    let mut lines = Lines::default();
    for (name, text) in DOCUMENTS {
        if is_library(name) {
            continue;
        }
        let document = Document::from_json(text).unwrap();
        let roll = |frames: usize, handles: &Handles| match &document {
            Document::Body(model) => model.rollout_with(0, frames, handles),
            Document::Series(model) => model.rollout_with(0, frames, handles),
        };
        let columns = roll(2, &Handles::default()).unwrap().ncols();
        for tempo in [0.5, 1.0, 1.7] {
            for goal in [None, Some(vec![0.2; columns])] {
                let push = Some(PosePush { frame: 4, by: vec![0.1; columns] });
                match roll(15, &Handles { tempo, goal, push }) {
                    Ok(y) => lines.numbers(name, &y),
                    Err(error) => lines.0.push(error.to_string()),
                }
            }
        }
    }
    lines
}

#[test]
fn models_say_what_they_said_in_earlier_versions() {
    let model = start_model();
    let found = [
        ("rollouts", rollouts(&model)),
        ("observed", observed(&model)),
        ("endless", endless(model.clone())),
        ("library", library()),
        ("handles", handles()),
        ("limits", limits::limits(model)),
        ("trained", trained::trained()),
        ("documents", changed_documents::documents()),
    ];
    let found = found.map(|(subject, Lines(results))| (subject, fingerprint(subject, &results)));
    let earlier = [
        ("rollouts", "9a7b9ceb"),
        ("observed", "251d0b03"),
        ("endless", "68e43101"),
        ("library", "58d96208"),
        ("handles", "2e605a4b"),
        ("limits", "14da2680"),
        ("trained", "1de5b6e4"),
        ("documents", "0ebe5c3a"),
    ];
    assert_eq!(found, earlier.map(|(subject, hash)| (subject, hash.to_owned())));
}
