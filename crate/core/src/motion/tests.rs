//! Results of this module for many changed bodies, compared with those of earlier versions by their fingerprints. If a
//! change of them is wanted, the new fingerprints go into [`EARLIER`].

#[path = "../../../vcgpdm/tests/shared/fingerprint.rs"]
mod fingerprint;

use super::*;
use crate::motion::limbs::is_within;
use crate::motion::pose::PoseMapping;
use crate::motion::stage_axes::UpAxis;
use crate::motion::up_axis::tests::in_world;
use fingerprint::{fingerprint, numbers, without_sign_of_zero};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Each subject, and the fingerprint of the results of all bodies.
const EARLIER: [(&str, &str); 8] = [
    ("read", "5dc66f5b"),
    ("stage", "fef6700b"),
    ("parts", "5a7bd3af"),
    ("landmarks", "b9b92c8e"),
    ("measures", "f90e5d2c"),
    ("poses", "6e412cd7"),
    ("same body", "cb769403"),
    ("written", "7afc8452"),
];

const BODIES: usize = 96;

/// One of some equally likely choices.
fn choice(random: &mut ChaCha8Rng, choices: usize) -> usize {
    random.next_u32() as usize % choices
}

/// A skeleton without a joint and all below it, and the columns that remain.
fn without(skeleton: &Skeleton, removed: usize) -> (Skeleton, Vec<usize>) {
    let kept: Vec<usize> =
        (0..skeleton.joints.len()).filter(|&joint| !is_within(skeleton, joint, removed)).collect();
    let starts = skeleton.channel_starts();
    let columns =
        kept.iter().flat_map(|&joint| (starts[joint]..).take(skeleton.joints[joint].channels.len()));
    let place = |joint: usize| kept.iter().position(|&other| other == joint);
    let joints = kept.iter().map(|&joint| {
        let own = skeleton.joints[joint].clone();
        skeleton::Joint { parent: own.parent.and_then(place), ..own }
    });
    (Skeleton { joints: joints.collect() }, columns.collect())
}

/// A recording of a sample clip whose names, bones, unit, world, place and rows are changed at random.
fn recording(seed: u64) -> Recording {
    let random = &mut ChaCha8Rng::seed_from_u64(seed);
    let ids = ["walk-1", "walk-2", "walk-wave-1", "stand-wave-1", "bottle-1"];
    let clip = samples::clip(ids[choice(random, ids.len())]).unwrap().resample(12.0).unwrap();
    let (mut skeleton, mut values) = (clip.skeleton, clip.values);
    if choice(random, 3) == 0 {
        let removed = 1 + choice(random, skeleton.joints.len() - 1);
        let (rest, columns) = without(&skeleton, removed);
        (skeleton, values) = (rest, values.select_columns(&columns));
    }
    let naming = choice(random, 6);
    for (place, joint) in skeleton.joints.iter_mut().enumerate() {
        joint.name = match naming {
            0 => format!("joint{place}"),
            1 => joint.name.to_lowercase(),
            2 => format!("mixamorig:{}", joint.name),
            3 if joint.name.starts_with("Left") => format!("{}_L", &joint.name[4..]),
            3 if joint.name.starts_with("Right") => format!("{}_R", &joint.name[5..]),
            _ => joint.name.clone(),
        };
    }
    if choice(random, 4) == 0 {
        let place = choice(random, skeleton.joints.len());
        skeleton.joints[place].offset = skeleton.joints[place].offset.map(|x| 1.3 * x + 1.0);
    }
    let unit = [1.0, 1.0, 0.01, 10.0, 0.394][choice(random, 5)];
    let factor = [1.0, 1.0, 1.0, 10.0, 0.1][choice(random, 5)];
    let up = [UpAxis::Y, UpAxis::Y, UpAxis::Z, UpAxis::X, UpAxis::new(1, true)][choice(random, 5)];
    for joint in &mut skeleton.joints {
        joint.offset = joint.offset.map(|x| unit * x);
        joint.end_sites.iter_mut().for_each(|end| *end = end.map(|x| unit * x));
    }
    let away = [0.0, 0.0, 300.0][choice(random, 3)];
    for (column, channel) in skeleton.joints[0].channels.iter().enumerate() {
        if !channel.is_rotation() {
            values.column_mut(column).apply(|x| *x = factor * unit * (*x + away));
        }
    }
    let clip = Clip::new(&format!("{seed}.bvh"), skeleton, clip.frame_time, values);
    let Clip { name, skeleton, frame_time, mut values, .. } = in_world(&clip, up.to_y_up().inverse(), true);
    match choice(random, 6) {
        // A T-pose before the motion, rows of zeros, the same row at the end.
        0 => values = values.insert_row(0, 0.0),
        1 => values.row_mut(7).fill(0.0),
        2 => {
            let row = values.row(20).into_owned();
            (21..values.nrows()).for_each(|frame| values.row_mut(frame).copy_from(&row));
        }
        _ => {}
    }
    Recording::new(&name, skeleton, frame_time, values)
}

/// The results for a recording, in the order of [`EARLIER`]. `first`: another clip.
fn results(recording: Recording, first: &Clip) -> [String; 8] {
    let skipped = recording.rows_before_motion();
    let clip = recording.into_clip().with_checked_axis();
    let read = format!("{skipped} {:?} {}", clip.warnings, numbers(clip.values.iter()));
    let stage = clip.stage();
    let stage = format!("{} {}", stage.up.name(), numbers([stage.height, stage.ground].iter()));
    let parts = format!("{:?}", parts::presets(&clip.skeleton));
    let positions = clip.stage_positions();
    let landmarks = format!("{:?} {:.3?}", clip.landmarks(), landmarks::facing(&clip.skeleton, &positions));
    let measured = measures::measures(&clip.skeleton, &positions, clip.frame_time);
    let rests = measures::rests_from(&clip.skeleton, &positions, clip.frame_time);
    let measures = format!("{measured:.3?} {rests:.3?}");
    let mapping = PoseMapping::new(&clip);
    let poses = mapping.encode(&clip).map_or_else(
        |error| error.to_string(),
        |encoded| {
            let decoded = mapping.decode(&encoded.y, &encoded.start, clip.frame_time).unwrap();
            let [own, back] = [&encoded.y, &decoded.values].map(|values| numbers(values.iter()));
            format!("{own} {back} {:?} {:.3?}", encoded.warnings, mapping.climb(&encoded.y))
        },
    );
    let onto = clip.onto(first).map_or_else(|error| error.to_string(), |clip| numbers(clip.values.iter()));
    let same =
        first.skeleton.same_body(&clip.skeleton).map_or_else(|error| error.to_string(), |()| "yes".into());
    let written = bvh::read("again.bvh", bvh::write(&clip.clone().with_plain_names()).as_bytes()).unwrap();
    let names: Vec<&str> = written.skeleton.joints.iter().map(|joint| joint.name.as_str()).collect();
    let written = format!("{names:?} {}", numbers(written.values.iter()));
    let all = [read, stage, parts, landmarks, measures, poses, format!("{same} {onto}"), written];
    all.map(|result| without_sign_of_zero(&result))
}

#[test]
fn many_bodies_are_what_they_were_in_earlier_versions() {
    let first = samples::clip("walk-1").unwrap().resample(12.0).unwrap();
    let all: Vec<_> = (0..BODIES as u64).map(|seed| results(recording(seed), &first)).collect();
    let found = EARLIER.iter().enumerate().map(|(place, (subject, _))| {
        let of_subject: Vec<String> = all.iter().map(|results| results[place].clone()).collect();
        (*subject, fingerprint(subject, &of_subject))
    });
    let found: Vec<(&str, String)> = found.collect();
    let earlier = EARLIER.map(|(subject, fingerprint)| (subject, fingerprint.to_owned()));
    assert_eq!(found, earlier);
}
