//! Walks of any number of frames.

use nalgebra::DMatrix;
use vcgpdm::models::{Dataset, Source};
use vcgpdm::motion::{parts, samples};

/// All columns of the sample walks, repeated to `frames` frames, and the lengths of the sequences.
pub fn walks(frames: usize) -> (DMatrix<f64>, Vec<usize>) {
    let clips: Vec<_> = samples::list().iter().take(6).map(|s| samples::clip(s.id).unwrap()).collect();
    let sources: Vec<Source> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let parts = parts::presets(&clips[0].skeleton).remove(0).parts;
    let dataset = Dataset::new(&sources, &parts, 30.0).unwrap();
    let (all, lengths) = (&dataset.y[0], dataset.lengths());
    let mut y = DMatrix::zeros(frames, all.ncols());
    let mut sequences = Vec::new();
    let mut at = 0;
    while at < frames {
        let round = sequences.len() / lengths.len();
        let k = sequences.len() % lengths.len();
        let first: usize = lengths[..k].iter().sum();
        let rest = frames - at;
        // The last sequence must be long enough for dynamics.
        let length = if rest < lengths[k] + 10 { rest.min(lengths[k]) } else { lengths[k] };
        let scale = 1.0 + 0.03 * (round as f64).sin();
        y.rows_mut(at, length).copy_from(&(all.rows(first, length) * scale));
        at += length;
        sequences.push(length);
    }
    (y, sequences)
}

/// The columns in `parts` groups of about the same size.
pub fn split(y: &DMatrix<f64>, parts: usize) -> Vec<DMatrix<f64>> {
    let begin = |part: usize| part * y.ncols() / parts;
    (0..parts).map(|part| y.columns(begin(part), begin(part + 1) - begin(part)).into_owned()).collect()
}
