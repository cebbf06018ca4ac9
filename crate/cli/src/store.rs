//! The results file of an evaluation, on which several programs can work at the same time. Finished jobs are
//! added one by one, so that a stopped evaluation can continue. Each program claims a job before it computes
//! it, so that no other program computes the same job.
//!
//! `RESULTS.json.lock` is locked while a program reads or writes the results or claims a job. A program that
//! computes a job keeps a file `RESULTS.json.lock-HASH` of the job locked. The system unlocks the file when the
//! program ends in whatever way, and then the job is free.

use crate::files;
use crate::results::read;
use crate::task::say;
use crate::usage::usage;
use std::collections::{HashMap, HashSet};
use std::error::Error;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};
use vcgpdm_core::motion::sha256;
use vcgpdm_lab::evaluation::{Finished, Job, Results, Setting};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// After so long a program says that it waits for the lock.
const PATIENCE: Duration = Duration::from_secs(2);

/// The job to compute next.
pub enum Next {
    Job(Job),
    /// Other programs compute all jobs that are left.
    Wait,
    /// No job is left.
    Done,
}

/// The results file.
pub struct Store {
    path: PathBuf,
    results: Results,
    /// Jobs that had failed when the file was opened. They are computed again.
    failed_before: HashSet<Job>,
    /// The locked files of the jobs that this program computes.
    claims: HashMap<Job, (PathBuf, File)>,
}

impl Store {
    /// Opens the file, or writes a new one: a scheduler waits for the file of a share without jobs too.
    pub fn open(path: &Path, setting: Setting) -> Result<Self> {
        if files::is_standard(path) {
            return Err(usage("--out -: expected a file, to which finished jobs are added one by one"));
        }
        let (path, results) = (path.to_owned(), Results::new(setting));
        let mut store = Self { path, results, failed_before: HashSet::new(), claims: HashMap::new() };
        let lock = lock(&store.path)?;
        files::check_writable(&store.path, [])?;
        store.read()?;
        if !store.path.exists() {
            store.write()?;
        }
        drop(lock);
        let failed = store.results.finished().iter().filter(|finished| finished.failure.is_some());
        store.failed_before = failed.map(|finished| finished.job.clone()).collect();
        Ok(store)
    }

    /// Whether a job is not computed again.
    pub fn is_complete(&self, job: &Job) -> bool {
        self.results.has_outcome(job)
    }

    /// Claims the first of the jobs that is neither finished nor claimed by another program. Finished jobs
    /// are removed from the list, and so is the claimed one.
    pub fn claim(&mut self, jobs: &mut Vec<Job>) -> Result<Next> {
        let _lock = lock(&self.path)?;
        self.read()?;
        let finished: HashSet<&Job> =
            self.results.finished().iter().filter(|f| self.is_over(f)).map(|f| &f.job).collect();
        jobs.retain(|job| !finished.contains(job));
        for place in 0..jobs.len() {
            let path = self.path_of(&jobs[place]);
            if let Some(file) = try_lock(&path)? {
                let job = jobs.remove(place);
                self.claims.insert(job.clone(), (path, file));
                return Ok(Next::Job(job));
            }
        }
        Ok(if jobs.is_empty() { Next::Done } else { Next::Wait })
    }

    /// Adds a finished job and gives up its claim. Jobs that other programs have added stay.
    pub fn add(&mut self, finished: Finished) -> Result<()> {
        let _lock = lock(&self.path)?;
        self.read()?;
        let claim = self.claims.remove(&finished.job);
        self.results.add(finished)?;
        self.write()?;
        claim.iter().for_each(give_up);
        Ok(())
    }

    fn is_over(&self, finished: &Finished) -> bool {
        finished.outcome.is_some() || !self.failed_before.contains(&finished.job)
    }

    /// The file that is locked while a program computes the job.
    fn path_of(&self, job: &Job) -> PathBuf {
        with_ending(&self.path, &format!(".lock-{}", &sha256(job.to_string().as_bytes())[..16]))
    }

    fn read(&mut self) -> Result<()> {
        if self.path.exists() {
            self.results.merge(read(&self.path)?).map_err(|error| files::with_path(&self.path, &error))?;
        }
        Ok(())
    }

    fn write(&self) -> Result<()> {
        files::write_text(&self.path, &(self.results.to_json()? + "\n"))
    }
}

fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut path = path.to_owned().into_os_string();
    path.push(ending);
    path.into()
}

/// Excludes other programs from the results in this file until the lock is dropped. The file of the lock is never
/// deleted: a program that waits for a deleted file and a program that creates a new one would not exclude each
/// other.
fn lock(results: &Path) -> Result<File> {
    let path = with_ending(results, ".lock");
    let begin = Instant::now();
    while begin.elapsed() < PATIENCE {
        if let Some(file) = try_lock(&path)? {
            return Ok(file);
        }
        thread::sleep(Duration::from_millis(20));
    }
    say(&format!("waiting for another program that writes {}", results.display()));
    let file = open(&path)?;
    file.lock().map_err(|error| files::with_path(&path, &error))?;
    Ok(file)
}

/// The file, locked; `None` if another program has locked it.
fn try_lock(path: &Path) -> Result<Option<File>> {
    let file = open(path)?;
    match file.try_lock() {
        Ok(()) => Ok(Some(file)),
        Err(TryLockError::WouldBlock) => Ok(None),
        Err(TryLockError::Error(error)) => Err(files::with_path(path, &error)),
    }
}

fn open(path: &Path) -> Result<File> {
    let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
    file.map_err(|error| files::with_path(path, &error))
}

/// Deletes the file of a claim, under the lock of the results: no program waits for it. An error leaves a file that
/// is not locked and claims nothing.
fn give_up((path, _): &(PathBuf, File)) {
    let _ = fs::remove_file(path);
}

impl Drop for Store {
    /// Gives up the claims of jobs that were stopped.
    fn drop(&mut self) {
        if !self.claims.is_empty()
            && let Ok(_lock) = lock(&self.path)
        {
            self.claims.values().for_each(give_up);
            // Unlocked while the results are still locked.
            self.claims.clear();
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
mod tests {
    use super::*;
    use vcgpdm_core::models::{Settings, TmpSettings};
    use vcgpdm_core::motion::samples;

    fn setting() -> Setting {
        let clips: Vec<_> = ["walk-1", "walk-2"].map(|id| samples::clip(id).unwrap()).into();
        Setting::new(&clips, &[], 30.0, 5).unwrap()
    }

    fn job(seed: u32) -> Job {
        let candidate = Settings::Tmp(TmpSettings::default()).into();
        Job { candidate, held_out: 0, training_trials: 1, seed }
    }

    fn failed(seed: u32) -> Finished {
        Finished::new(job(seed), Err("a test".to_owned()))
    }

    fn done(seed: u32) -> Finished {
        let outcome = serde_json::json!({
            "score": { "dtw_mse": 1.0, "mse": 1.0, "variance": 1.0 },
            "bound": null, "objective": 0.0, "iterations": 1, "seconds": 1.0, "frames": 9, "stored_numbers": 1,
            "reason": null,
        });
        Finished::new(job(seed), Ok(serde_json::from_value(outcome).unwrap()))
    }

    /// A folder for one test.
    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("vcgpdm-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir(&folder).unwrap();
        folder
    }

    fn files_in(folder: &Path) -> Vec<String> {
        let names = fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    }

    fn claimed(store: &mut Store, jobs: &mut Vec<Job>) -> Option<u32> {
        match store.claim(jobs).unwrap() {
            Next::Job(job) => Some(job.seed),
            Next::Wait | Next::Done => None,
        }
    }

    #[test]
    fn programs_on_one_file_compute_each_job_once_and_lose_none() {
        let folder = folder("store");
        let path = folder.join("results.json");
        let computed = std::sync::Mutex::new(Vec::new());
        thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    let mut store = Store::open(&path, setting()).unwrap();
                    let mut jobs: Vec<Job> = (0..40).map(job).collect();
                    loop {
                        match store.claim(&mut jobs).unwrap() {
                            Next::Job(job) => {
                                computed.lock().unwrap().push(job.seed);
                                store.add(done(job.seed)).unwrap();
                            }
                            Next::Wait => thread::yield_now(),
                            Next::Done => return,
                        }
                    }
                });
            }
        });
        let mut computed = computed.into_inner().unwrap();
        computed.sort_unstable();
        assert_eq!(computed, (0..40).collect::<Vec<_>>());
        assert_eq!(read(&path).unwrap().finished().len(), 40);
        assert_eq!(files_in(&folder), ["results.json", "results.json.lock"]);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn claims_of_a_program_that_stopped_or_was_killed_are_free() {
        let folder = folder("claims");
        let path = folder.join("results.json");
        let open = || (Store::open(&path, setting()).unwrap(), vec![job(0), job(1)]);
        let (mut first, mut of_first) = open();
        let (mut second, mut of_second) = open();
        assert_eq!(claimed(&mut first, &mut of_first), Some(0));
        assert_eq!(claimed(&mut second, &mut of_second), Some(1));
        assert!(matches!(second.claim(&mut of_second).unwrap(), Next::Wait));
        // A stopped program gives up its claims.
        drop(first);
        assert_eq!(claimed(&mut second, &mut of_second), Some(0));
        drop(second);
        assert_eq!(files_in(&folder), ["results.json", "results.json.lock"]);
        // A killed one leaves a file that is not locked.
        let (mut third, mut of_third) = open();
        fs::write(third.path_of(&job(0)), "").unwrap();
        assert_eq!(claimed(&mut third, &mut of_third), Some(0));
        drop(third);
        assert_eq!(files_in(&folder), ["results.json", "results.json.lock"]);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn computes_again_what_failed_before_but_not_what_fails_meanwhile() {
        let folder = folder("failures");
        let path = folder.join("results.json");
        let mut before = Store::open(&path, setting()).unwrap();
        before.add(failed(0)).unwrap();
        let mut store = Store::open(&path, setting()).unwrap();
        before.add(failed(1)).unwrap();
        let mut jobs = vec![job(1), job(0)];
        assert_eq!(claimed(&mut store, &mut jobs), Some(0));
        assert!(matches!(store.claim(&mut jobs).unwrap(), Next::Done));
        fs::remove_dir_all(&folder).unwrap();
    }
}
