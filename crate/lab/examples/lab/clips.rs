//! Clips of the command line.

use clap::Args;
use std::path::PathBuf;
use vcgpdm::motion::{Clip, bvh};

/// Trainings on each of several folders.
#[derive(Args)]
pub struct FolderTrainings {
    /// Folders of clips (.bvh), one for each movement of a person.
    #[arg(required = true)]
    pub folders: Vec<PathBuf>,
    /// Train from this number of seeds.
    #[arg(long, default_value_t = 5)]
    pub seeds: u32,
    /// Train this number of models at the same time.
    #[arg(long, default_value_t = 2)]
    pub threads: usize,
}

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
