//! The file of an evaluation: what was compared and what came of it. Finished jobs are added one by one, so that a stopped
//! evaluation goes on where it was, and so that several processes can work on one file.

use crate::files;
use serde::{Deserialize, Serialize};
use std::error::Error;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use vcgpdm::evaluation::{Candidate, Outcome};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

const FORMAT: &str = "vcgpdm-evaluation";
const VERSION: u32 = 1;

/// A trial, by its content.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trial {
    pub name: String,
    pub sha256: String,
}

/// A group of joints.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    pub name: String,
    pub joints: Vec<usize>,
}

/// What all results of a file have in common.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Setting {
    pub trials: Vec<Trial>,
    pub parts: Vec<Part>,
    pub frames_per_second: f64,
    pub start_frames: usize,
}

/// One model in one fold with one seed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Job {
    pub candidate: Candidate,
    /// The trial held out, counted from 1.
    pub held_out: usize,
    /// How many of the others are trained on.
    pub training_trials: usize,
    pub seed: u32,
}

/// What came of a job: an outcome, or why there is none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Finished {
    pub job: Job,
    /// The program and its version that computed it.
    pub engine: String,
    pub outcome: Option<Outcome>,
    pub failure: Option<String>,
}

/// The whole file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Results {
    format: String,
    version: u32,
    pub setting: Setting,
    pub finished: Vec<Finished>,
}

impl Results {
    /// Nothing finished yet.
    pub fn new(setting: Setting) -> Self {
        Self { format: FORMAT.to_owned(), version: VERSION, setting, finished: Vec::new() }
    }

    /// Reads a file.
    pub fn read(path: &Path) -> Result<Self> {
        let text = files::read_text(path)?;
        let results: Results = serde_json::from_str(&text)
            .map_err(|error| format!("{}: expected the results of an evaluation: {error}", path.display()))?;
        if results.format != FORMAT || results.version != VERSION {
            let found = format!("{:?} version {}", results.format, results.version);
            return Err(
                format!("{}: expected {FORMAT} version {VERSION}, found {found}", path.display()).into()
            );
        }
        Ok(results)
    }

    /// What is known of a job.
    pub fn find(&self, job: &Job) -> Option<&Finished> {
        self.finished.iter().find(|finished| finished.job == *job)
    }

    /// Takes over what the other knows and this one does not; both must be of the same setting.
    pub fn merge(&mut self, other: Results, path: &Path) -> Result<()> {
        if other.setting != self.setting {
            let differs = if other.setting.trials != self.setting.trials {
                "other trials"
            } else if other.setting.parts != self.setting.parts {
                "other parts"
            } else {
                "another frame rate"
            };
            return Err(format!("{}: these results are of {differs}", path.display()).into());
        }
        for finished in other.finished {
            if self.find(&finished.job).is_none() {
                self.finished.push(finished);
            }
        }
        Ok(())
    }
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
            self.results.merge(Results::read(&self.path)?, &self.path)?;
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
