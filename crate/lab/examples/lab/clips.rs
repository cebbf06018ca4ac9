//! Clips of the command line.

use std::path::PathBuf;
use vcgpdm::motion::{Clip, bvh};

/// Reads files, and the BVH files of folders in the order of their names. A clip is read when the iterator
/// reaches it.
pub fn read_clips(paths: &[PathBuf]) -> impl Iterator<Item = Clip> {
    let files = paths.iter().flat_map(|path| {
        if !path.is_dir() {
            return vec![path.clone()];
        }
        let entries = std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path());
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
