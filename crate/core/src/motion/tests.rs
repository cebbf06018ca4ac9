//! What this module says of many changed bodies, against what earlier versions said: a change that no other test
//! notices. A failed test prints its lines; compare them with those of the version before. If the change is wanted,
//! the new fingerprints go into [`EARLIER`].

use super::*;
use crate::motion::limbs::is_within;
use crate::motion::pose::PoseMapping;
use crate::motion::stage_axes::UpAxis;
use nalgebra::Vector3;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// The subject of each line, and a fingerprint of all lines of this subject.
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
    let turn = up.to_y_up().inverse();
    for joint in &mut skeleton.joints {
        joint.offset = (unit * (turn * Vector3::from(joint.offset))).into();
        for end in &mut joint.end_sites {
            *end = (unit * (turn * Vector3::from(*end))).into();
        }
    }
    let starts = skeleton.channel_starts();
    let away = [0.0, 0.0, 300.0][choice(random, 3)];
    for frame in 0..values.nrows() {
        for (joint, start) in skeleton.joints.iter().zip(&starts) {
            let columns = || (*start..).zip(&joint.channels);
            let rotations: Vec<usize> =
                columns().filter(|(_, c)| c.is_rotation()).map(|(column, _)| column).collect();
            let axes: Vec<usize> = joint.rotation_axes().collect();
            let degrees: Vec<f64> = rotations.iter().map(|&column| values[(frame, column)]).collect();
            let own = axes
                .iter()
                .zip(&degrees)
                .fold(nalgebra::UnitQuaternion::identity(), |own, (axis, degrees)| {
                    own * rotation::about_axis(*axis, degrees.to_radians())
                });
            let turned = rotation::angles_near(&(turn * own * turn.inverse()), &axes, &[0.0; 3]);
            for (column, radians) in rotations.into_iter().zip(turned) {
                values[(frame, column)] = radians.to_degrees();
            }
            let places: Vec<usize> =
                columns().filter(|(_, c)| !c.is_rotation()).map(|(column, _)| column).collect();
            if places.len() == 3 {
                let place = Vector3::from_fn(|axis, _| values[(frame, places[axis])] + away);
                let place = factor * unit * (turn * place);
                places.iter().zip(place.iter()).for_each(|(&column, x)| values[(frame, column)] = *x);
            }
        }
    }
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
    Recording::new(&format!("{seed}.bvh"), skeleton, clip.frame_time, values)
}

/// Mean and size of some numbers, to five digits: fewer than differ between processors.
fn numbers<'a>(values: impl Iterator<Item = &'a f64> + Clone) -> String {
    let count = values.clone().count().max(1) as f64;
    let mean = values.clone().sum::<f64>() / count;
    let size = values.map(|value| value * value).sum::<f64>() / count;
    let [mean, size] = [mean, size].map(|value| if value.abs() < 1e-9 { 0.0 } else { value });
    format!("{mean:.4e} {size:.4e}")
}

/// The lines about a recording, in the order of [`EARLIER`]. `first`: another clip.
fn lines(recording: Recording, first: &Clip) -> [String; 8] {
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
    // Whether nothing is above or below 0 is chance.
    all.map(|line| line.replace("-0.000", "0.000"))
}

#[test]
fn many_bodies_are_what_they_were_in_earlier_versions() {
    let first = samples::clip("walk-1").unwrap().resample(12.0).unwrap();
    let all: Vec<_> = (0..BODIES as u64).map(|seed| lines(recording(seed), &first)).collect();
    let found: Vec<(&str, String)> = (EARLIER.iter().enumerate())
        .map(|(place, (subject, _))| {
            let lines: Vec<String> = all.iter().map(|lines| lines[place].clone()).collect();
            for (seed, line) in lines.iter().enumerate() {
                println!("{subject}, {seed}: {line}");
            }
            (*subject, sha256(lines.join("\n").as_bytes())[..8].to_owned())
        })
        .collect();
    let earlier: Vec<(&str, String)> =
        EARLIER.iter().map(|(subject, hash)| (*subject, (*hash).to_owned())).collect();
    assert_eq!(found, earlier);
}
