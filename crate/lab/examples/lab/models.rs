//! The models of the measurements: the first model of the page, and models of the sample walks.

use std::path::Path;
use vcgpdm::motion::parts::{PartSpec, presets};
use vcgpdm::motion::{Clip, samples};
use vcgpdm::{Dataset, Model, Source, Trainer, VariationalSettings};

const FRAMES_PER_SECOND: f64 = 30.0;

/// The text of a file that the page opens with.
pub fn read_first(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../www/first").join(file);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The first model of the page.
pub fn start() -> Model {
    Model::from_json(&read_first("model.json")).unwrap()
}

/// Models of the sample walks, with the default settings and their titles.
pub fn sample_models() -> Vec<(&'static str, Model)> {
    let clips = |movement: &str| -> Vec<Clip> {
        let samples = samples::list().into_iter().filter(|sample| sample.movement == movement);
        samples.map(|sample| samples::clip(sample.id).unwrap()).collect()
    };
    let (walks, waves) = (clips("walk"), clips("walk and wave"));
    let train = |clips: &[Clip], parts: &[PartSpec]| {
        train(clips, parts, 1, VariationalSettings::default().max_iterations)
    };
    vec![
        ("Sample walks, lower and upper body", train(&walks, &lower_upper(&walks[0]))),
        ("Sample walks, five parts", train(&walks, &five_parts(&walks[0]))),
        ("Sample walks with waving, lower and upper body", train(&waves, &lower_upper(&waves[0]))),
    ]
}

/// Trains a model on clips.
pub fn train(clips: &[Clip], parts: &[PartSpec], seed: u32, max_iterations: usize) -> Model {
    let sources: Vec<Source> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let dataset = Dataset::new(&sources, parts, FRAMES_PER_SECOND).unwrap();
    let settings = VariationalSettings { max_iterations, ..VariationalSettings::default() };
    let mut trainer = Trainer::new(&dataset, &settings.into(), seed).unwrap();
    trainer.run();
    trainer.finish().unwrap()
}

/// Lower and upper body.
pub fn lower_upper(clip: &Clip) -> Vec<PartSpec> {
    preset(clip, "lower-upper")
}

/// Trunk, left leg, right leg, left arm, right arm.
fn five_parts(clip: &Clip) -> Vec<PartSpec> {
    let parts = preset(clip, "legs-trunk-arms");
    let joints = |name: &str| parts.iter().find(|part| part.name == name).unwrap().joints.clone();
    let leg = |side: &str| -> Vec<usize> {
        let legs = joints("legs").into_iter();
        legs.filter(|&joint| clip.skeleton.joints[joint].name.starts_with(side)).collect()
    };
    let (left, right) = (leg("Left"), leg("Right"));
    let hips = joints("legs").into_iter().filter(|joint| !left.contains(joint) && !right.contains(joint));
    let mut trunk: Vec<usize> = hips.chain(joints("trunk")).collect();
    trunk.sort_unstable();
    let named = |name: &str, joints| PartSpec { name: name.to_owned(), joints };
    vec![
        named("trunk", trunk),
        named("left leg", left),
        named("right leg", right),
        named("left arm", joints("left arm")),
        named("right arm", joints("right arm")),
    ]
}

fn preset(clip: &Clip, id: &str) -> Vec<PartSpec> {
    let presets = presets(&clip.skeleton);
    presets.into_iter().find(|preset| preset.id == id).unwrap().parts
}
