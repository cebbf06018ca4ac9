//! The file of an evaluation. Finished jobs are added one by one, so that a stopped evaluation goes on where it was, and so
//! that several processes can work on one file.

use crate::files;
use std::error::Error;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use vcgpdm::evaluation::{Finished, Results, Setting};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Reads a file.
pub fn read(path: &Path) -> Result<Results> {
    let text = files::read_text(path)?;
    let results: Results = serde_json::from_str(&text)
        .map_err(|error| format!("{}: expected the results of an evaluation: {error}", path.display()))?;
    results.check().map_err(|error| files::about(path, &error))?;
    Ok(results)
}

/// The file, to which finished jobs are added.
pub struct Store {
    path: PathBuf,
    results: Results,
}

impl Store {
    /// Opens the file, or will write a new one.
    pub fn open(path: &Path, setting: Setting) -> Result<Self> {
        let mut store = Self { path: path.to_owned(), results: Results::new(setting) };
        files::check_writable(path)?;
        store.take_over()?;
        Ok(store)
    }

    pub fn results(&self) -> &Results {
        &self.results
    }

    fn take_over(&mut self) -> Result<()> {
        if self.path.exists() {
            self.results.merge(read(&self.path)?).map_err(|error| files::about(&self.path, &error))?;
        }
        Ok(())
    }

    /// Adds a finished job. Another process may have added some meanwhile; they stay.
    pub fn add(&mut self, finished: Finished) -> Result<()> {
        let lock_path = self.beside("lock");
        let lock = File::create(&lock_path).map_err(|error| files::about(&lock_path, &error))?;
        lock.lock().map_err(|error| files::about(&lock_path, &error))?;
        self.take_over()?;
        self.results.finished.push(finished);
        // A new file takes the old one's place at once: nobody ever sees half of it.
        let new = self.beside("new");
        files::write_text(&new, &(serde_json::to_string(&self.results)? + "\n"))?;
        fs::rename(&new, &self.path).map_err(|error| files::about(&self.path, &error))
    }

    fn beside(&self, ending: &str) -> PathBuf {
        let mut name = self.path.clone().into_os_string();
        name.push(".");
        name.push(ending);
        name.into()
    }
}

impl Drop for Store {
    fn drop(&mut self) {
        let _ = fs::remove_file(self.beside("lock"));
    }
}
