//! Clips that the command line names.

use std::path::PathBuf;
use vcgpdm::motion::{Clip, bvh};

/// The clips of these files, and of the files of these folders in the order of their names; each is read when
/// it is its turn.
pub fn read_clips(places: &[PathBuf]) -> impl Iterator<Item = Clip> {
    let files = places.iter().flat_map(|place| {
        if !place.is_dir() {
            return vec![place.clone()];
        }
        let entries = std::fs::read_dir(place).unwrap().map(|entry| entry.unwrap().path());
        let mut files: Vec<PathBuf> =
            entries.filter(|file| file.extension().is_some_and(|ending| ending == "bvh")).collect();
        files.sort();
        files
    });
    let read = |file: PathBuf| {
        let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        bvh::read(&name, &std::fs::read(&file).unwrap()).unwrap().into_clip()
    };
    files.map(read)
}
