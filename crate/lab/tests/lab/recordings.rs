//! TMP and DMP on recorded walks: what they predict of a trial of which they saw five frames.
//!
//! The walks are not part of the project: they lie in the folder that VCGPDM_CLIPS names.

use nalgebra::DMatrix;
use std::path::PathBuf;
use vcgpdm_core::models::{
    Dataset, DmpSettings, FittedModel, Movements, Sequence, Settings, Source, TmpSettings,
};
use vcgpdm_core::motion::{bvh, parts};
use vcgpdm_lab::evaluation::{Score, dtw_mse};

/// All but one walk and five frames of that one; and all of it.
fn walks(held_out: usize, trials: usize) -> (Movements, DMatrix<f64>) {
    let folder = std::env::var_os("VCGPDM_CLIPS").expect("VCGPDM_CLIPS names the folder of the recordings");
    let folder = PathBuf::from(folder).join("cmu-walk");
    let read = |k: usize| {
        let name = format!("35_{k:02}.bvh");
        bvh::read(&name, &std::fs::read(folder.join(&name)).unwrap()).unwrap().into_clip()
    };
    let mut clips: Vec<_> = (1..=trials).filter(|&k| k != held_out).map(read).collect();
    clips.push(read(held_out));
    let last = clips.len() - 1;
    let sources: Vec<Source> = clips
        .iter()
        .enumerate()
        .map(|(k, clip)| Source { clip, first_frames: (k == last).then_some(5) })
        .collect();
    let parts = &parts::presets(&clips[0].skeleton)[1].parts;
    let data = Dataset::new(&sources, parts, 30.0).unwrap();
    let trial = data.mapping.encode(&clips[last].resample(30.0).unwrap()).unwrap().y;
    let sequences =
        data.lengths().into_iter().enumerate().map(|(k, frames)| Sequence { frames, whole: k < last });
    // The order of columns of the trial is that of the mapping; the parts' is put back for the score.
    let actual = data.layout.split(&trial);
    let all = Movements { y: actual, sequences: Vec::new() }.as_one_part().y.swap_remove(0);
    (Movements { y: data.y, sequences: sequences.collect() }, all)
}

fn score(model: &FittedModel, sequence: usize, actual: &DMatrix<f64>) -> Score {
    let y = model.rollout(sequence, actual.nrows()).unwrap();
    let y = Movements { y, sequences: Vec::new() }.as_one_part().y.swap_remove(0);
    dtw_mse(&y, actual).unwrap()
}

#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn a_held_out_walk_is_predicted_from_its_first_five_frames() {
    let (movements, actual) = walks(6, 6);
    for settings in [
        Settings::Tmp(TmpSettings { primitives: Some(6), ..TmpSettings::default() }),
        Settings::DmpRhythmic(DmpSettings::default()),
    ] {
        let mut learner = settings.learner(&movements, 0).unwrap();
        while !learner.step().done {}
        let s = score(&learner.model().unwrap(), 5, &actual);
        // A motionless prediction scores the variance, the vCGPDM 0.0007.
        assert!((s.variance - 0.00586).abs() < 1e-5 && s.dtw_mse < 0.0011, "{s:?}");
    }
}
