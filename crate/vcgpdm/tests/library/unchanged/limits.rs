//! Requests with a number at its limit or just beyond it: each is carried out, or refused with an error.

use super::Lines;
use crate::documents::DOCUMENTS;
use nalgebra::DMatrix;
use std::sync::Arc;
use vcgpdm_core::document::Document;
use vcgpdm_core::models::{Cut, Endless, Handles, Model, PosePush, Push, RolloutError, RolloutRequest};

pub fn limits(model: Model) -> Lines {
    let mut lines = Lines::default();
    let owner = Arc::new(model);
    let coupled = owner.coupled().unwrap();
    let (parts, order) = (coupled.model.part_count(), coupled.model.order);
    let usual = || RolloutRequest { frames: 30, ..RolloutRequest::default() };
    let last = coupled.model.start_frames(0) - 1;
    let start = coupled.model.start(0, 0).unwrap();
    let tall = |rows: usize| start.iter().map(|x| x.clone().resize_vertically(rows, 0.1)).collect::<Vec<_>>();
    let couplings = |value: f64| {
        let mut alpha = coupled.model.alpha.clone();
        alpha[(1, 0)] = value;
        Some(alpha)
    };
    let cut = |from, to| vec![Cut { source: 0, target: 1, from, to }];
    let push = |frame, part, by: Vec<f64>, ahead| vec![Push { part, frame, by, ahead }];
    let dimensions = coupled.model.latent_dimensions()[1];
    let requests = [
        ("no frames", RolloutRequest { frames: 0, ..usual() }),
        ("one frame", RolloutRequest { frames: 1, ..usual() }),
        ("too many frames", RolloutRequest { frames: 1_000_001, ..usual() }),
        ("the next sequence", RolloutRequest { sequence: coupled.model.starts.len(), ..usual() }),
        ("the last frame", RolloutRequest { frame: last, ..usual() }),
        ("a later frame", RolloutRequest { frame: last + 1, ..usual() }),
        ("a start and a frame", RolloutRequest { start: Some(tall(order)), frame: 1, ..usual() }),
        ("a short start", RolloutRequest { start: Some(tall(order - 1)), ..usual() }),
        ("a start", RolloutRequest { start: Some(tall(order)), ..usual() }),
        ("a long start", RolloutRequest { start: Some(tall(40)), ..usual() }),
        ("a start of one part", RolloutRequest { start: Some(tall(order)[..1].to_vec()), ..usual() }),
        ("a coupling of 0", RolloutRequest { alpha: couplings(0.0), ..usual() }),
        ("the smallest coupling", RolloutRequest { alpha: couplings(1e-100), ..usual() }),
        ("the largest coupling", RolloutRequest { alpha: couplings(1e100), ..usual() }),
        ("no coupling", RolloutRequest { alpha: couplings(f64::INFINITY), ..usual() }),
        ("one part too many", RolloutRequest { alpha: Some(DMatrix::from_element(3, 3, 1.0)), ..usual() }),
        ("a cut in the start", RolloutRequest { cuts: cut(order - 1, 10), ..usual() }),
        ("a cut from the first frame", RolloutRequest { cuts: cut(order, 10), ..usual() }),
        ("a cut to the end", RolloutRequest { cuts: cut(29, 30), ..usual() }),
        ("a cut after the end", RolloutRequest { cuts: cut(30, 31), ..usual() }),
        ("an empty cut", RolloutRequest { cuts: cut(9, 9), ..usual() }),
        ("a push in the start", RolloutRequest { pushes: push(order - 1, 1, vec![], 1.0), ..usual() }),
        ("a push of the first frame", RolloutRequest { pushes: push(order, 1, vec![], 1.0), ..usual() }),
        ("a push of the last frame", RolloutRequest { pushes: push(29, 1, vec![], 1.0), ..usual() }),
        ("a push after it", RolloutRequest { pushes: push(30, 1, vec![], 1.0), ..usual() }),
        ("a push of no part", RolloutRequest { pushes: push(9, parts, vec![], 1.0), ..usual() }),
        ("a push by one number", RolloutRequest { pushes: push(9, 1, vec![0.1], 0.0), ..usual() }),
        ("a push", RolloutRequest { pushes: push(9, 1, vec![0.1; dimensions], 0.0), ..usual() }),
        ("a push by NaN", RolloutRequest { pushes: push(9, 1, vec![], f64::NAN), ..usual() }),
    ];
    for (what, request) in requests {
        lines.answer(what, coupled.rollout(&request));
        lines.answer(what, coupled.moments(&request));
    }
    let rollout = coupled.rollout(&usual()).unwrap();
    let columns = rollout.y.ncols();
    for (given, cut) in [
        (vec![], None),
        (vec![0, 1], None),
        (vec![parts], None),
        (vec![1], Some(order - 1)),
        (vec![1], Some(order)),
        (vec![1], Some(29)),
        (vec![1], Some(30)),
    ] {
        let completed = coupled.complete(&usual(), &rollout.y, &given, cut);
        lines.answer(&format!("{given:?} {cut:?}"), completed);
    }
    for count in [dimensions, parts * dimensions - 1, parts * dimensions] {
        let latents = vec![0.1; count];
        lines.answer("pose", coupled.pose(1, &latents));
        lines.answer("body", coupled.body_pose(&latents));
    }
    for frame in [order - 2, 29, 30] {
        let begun = Endless::after(owner.clone(), &rollout, frame, 0);
        lines.answer("after", begun);
    }
    let node = coupled.body.mapping.skeleton().node_count();
    type Change<'a> = (&'a str, Box<dyn Fn(&mut Endless) -> Result<(), RolloutError> + 'a>);
    let latents = |rows, columns| DMatrix::from_element(rows, columns, 0.1);
    let changes: Vec<Change> = vec![
        ("cut off", Box::new(|live| live.cut(0, 1, true).and(live.cut(1, 1, true)))),
        ("cut a part that is not there", Box::new(|live| live.cut(0, parts, true))),
        ("slowest", Box::new(|live| live.set_tempo(1, 0.25))),
        ("slower", Box::new(|live| live.set_tempo(1, 0.24))),
        ("fastest", Box::new(|live| live.set_tempo(1, 2.0))),
        ("faster", Box::new(|live| live.set_tempo(1, 2.01))),
        ("tempo of no part", Box::new(|live| live.set_tempo(parts, 1.0))),
        ("a recording", Box::new(|live| live.record(1, latents(2 * order, dimensions)))),
        ("a short recording", Box::new(|live| live.record(1, latents(2 * order - 1, dimensions)))),
        ("a wide recording", Box::new(|live| live.record(1, latents(2 * order, dimensions + 1)))),
        ("the last node", Box::new(|live| live.reach(node - 1, [0.0; 3]))),
        ("no node", Box::new(|live| live.reach(node, [0.0; 3]))),
        ("no place", Box::new(|live| live.reach(0, [0.0, f64::INFINITY, 0.0]))),
        ("nothing to take back", Box::new(|live| live.rewind(0))),
        ("too much to take back", Box::new(|live| live.rewind(1))),
    ];
    let live = Endless::after(owner.clone(), &rollout, 20, 0).unwrap();
    for (what, change) in changes {
        lines.answer(what, change(&mut live.clone()));
    }
    let handles = |tempo, goal, push| Handles { tempo, goal, push };
    for (name, text) in DOCUMENTS.iter().filter(|(name, _)| ["tmp", "dmp-discrete"].contains(name)) {
        let Document::Body(model) = Document::from_json(text).unwrap() else { continue };
        let width = model.rollout(0, 2).unwrap().ncols();
        for handles in [
            handles(0.25, None, None),
            handles(2.1, None, None),
            handles(f64::NAN, None, None),
            handles(1.0, Some(vec![0.0; width + 1]), None),
            handles(1.0, None, Some(PosePush { frame: 14, by: vec![0.0; width] })),
            handles(1.0, None, Some(PosePush { frame: 15, by: vec![0.0; width] })),
            handles(1.0, None, Some(PosePush { frame: 3, by: vec![f64::NAN; width] })),
        ] {
            lines.answer(name, model.rollout_with(0, 15, &handles));
        }
    }
    lines.answer(
        "handles",
        owner.rollout_with(0, 15, &handles(0.5, None, Some(PosePush { frame: 3, by: vec![0.0; columns] }))),
    );
    lines
}
