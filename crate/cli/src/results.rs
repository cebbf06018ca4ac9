//! The file of an evaluation. Finished jobs are added one by one, so that a stopped evaluation goes on where
//! it was, and so that several processes can work on one file.

use crate::files;
use crate::usage::usage;
use std::error::Error;
use std::fs::{File, TryLockError};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};
use vcgpdm_lab::evaluation::{Finished, Results, Setting};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Reads a file.
pub fn read(path: &Path) -> Result<Results> {
    Results::from_json(&files::read_text(path)?).map_err(|error| files::about(path, &error))
}

/// The file, to which finished jobs are added.
pub struct Store {
    path: PathBuf,
    results: Results,
}

impl Store {
    /// Opens the file, or writes a new one: a scheduler waits for the file of a share in which there is
    /// nothing to do, too.
    pub fn open(path: &Path, setting: Setting) -> Result<Self> {
        if files::is_standard(path) {
            return Err(usage("--out -: expected a file, to which finished jobs are added one by one"));
        }
        let mut store = Self { path: path.to_owned(), results: Results::new(setting) };
        let lock = store.lock()?;
        files::check_writable(path, [])?;
        store.take_over()?;
        if !store.path.exists() {
            store.write()?;
        }
        drop(lock);
        Ok(store)
    }

    pub fn results(&self) -> &Results {
        &self.results
    }

    /// Keeps other processes out until it is dropped. The locked file stays beside the results for good:
    /// deleted while others wait for it, it would be one file for them and another for whoever comes next.
    fn lock(&self) -> Result<File> {
        let mut path = self.path.clone().into_os_string();
        path.push(".lock");
        let path = PathBuf::from(path);
        let lock = File::create(&path).map_err(|error| files::about(&path, &error))?;
        match lock.try_lock() {
            Ok(()) => return Ok(lock),
            Err(TryLockError::WouldBlock) => {}
            Err(TryLockError::Error(error)) => return Err(files::about(&path, &error)),
        }
        // Held for a moment as a rule; who waits for longer is told what for.
        let begin = Instant::now();
        while begin.elapsed() < Duration::from_secs(2) {
            thread::sleep(Duration::from_millis(20));
            if lock.try_lock().is_ok() {
                return Ok(lock);
            }
        }
        let name = files::shown(&self.path.display().to_string());
        // Nobody is left to tell when stderr is closed.
        let _ = writeln!(std::io::stderr(), "vcgpdm: waiting for another program that writes {name}");
        lock.lock().map_err(|error| files::about(&path, &error))?;
        Ok(lock)
    }

    fn take_over(&mut self) -> Result<()> {
        if self.path.exists() {
            self.results.merge(read(&self.path)?).map_err(|error| files::about(&self.path, &error))?;
        }
        Ok(())
    }

    /// Adds a finished job. Another process may have added some meanwhile; they stay.
    pub fn add(&mut self, finished: Finished) -> Result<()> {
        let _lock = self.lock()?;
        self.take_over()?;
        self.results.add(finished)?;
        self.write()
    }

    fn write(&self) -> Result<()> {
        files::write_text(&self.path, &(self.results.to_json()? + "\n"))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use std::fs;
    use vcgpdm::models::{Settings, TmpSettings};
    use vcgpdm::motion::samples;
    use vcgpdm_lab::evaluation::Job;

    fn setting() -> Setting {
        let clips: Vec<_> = ["walk-1", "walk-2"].map(|id| samples::clip(id).unwrap()).into();
        Setting::new(&clips, &[], 30.0, 5).unwrap()
    }

    fn finished(seed: u32) -> Finished {
        let candidate = Settings::Tmp(TmpSettings::default());
        let job = Job { candidate, held_out: 1, training_trials: 1, seed };
        Finished::new(job, Err("a test".to_owned()))
    }

    /// A folder that is there for one test.
    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("vcgpdm-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir(&folder).unwrap();
        folder
    }

    #[test]
    fn those_who_come_and_go_lose_no_job_of_others() {
        let folder = folder("store");
        let path = folder.join("results.json");
        std::thread::scope(|scope| {
            for worker in 0..8 {
                let (path, setting) = (&path, setting());
                scope.spawn(move || {
                    for k in 0..10 {
                        let mut store = Store::open(path, setting.clone()).unwrap();
                        store.add(finished(10 * worker + k)).unwrap();
                    }
                });
            }
        });
        assert_eq!(read(&path).unwrap().finished().len(), 80);
        let mut left: Vec<_> = fs::read_dir(&folder).unwrap().map(|e| e.unwrap().file_name()).collect();
        left.sort();
        assert_eq!(left, ["results.json", "results.json.lock"]);
        fs::remove_dir_all(&folder).unwrap();
    }
}
