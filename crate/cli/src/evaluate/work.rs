//! Jobs that the threads of this program, and other programs on the same file, compute one after the other.

use crate::store::{Next, Store};
use crate::task::Task;
use std::collections::HashMap;
use std::error::Error;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};
use vcgpdm_core::models::Progress as Training;
use vcgpdm_lab::evaluation::{Finished, Fold, Job};

/// How often a thread without a job looks whether another program has finished or given up one.
const POLL: Duration = Duration::from_secs(1);

/// Jobs that are shared among threads, and among programs that write the same file.
pub struct Work {
    /// Number of the jobs.
    pub jobs: usize,
    pub task: Task,
    state: Mutex<State>,
}

/// How far the work is.
pub struct State {
    store: Store,
    /// Jobs that are neither finished nor computed by this program.
    open: Vec<Job>,
    /// How far the job of each thread is, 0 to 1. A thread without a job has no entry.
    fractions: HashMap<usize, f64>,
    pub computed: usize,
    /// Each failed job with the reason.
    pub failures: Vec<String>,
    pub problem: Option<String>,
    waited: bool,
}

impl State {
    /// Says once that this program only waits for others.
    fn say_waiting(&mut self, task: &Task) {
        if self.fractions.is_empty() && !self.waited {
            self.waited = true;
            let jobs = self.open.len();
            task.note(&format!("waiting for other programs, which compute {jobs} of the jobs"));
        }
    }

    /// Number of the jobs that are not finished.
    pub fn left(&self) -> usize {
        self.open.len() + self.fractions.len()
    }
}

impl Work {
    pub fn new(open: Vec<Job>, store: Store) -> Result<Self, Box<dyn Error>> {
        let jobs = open.len();
        let state = State {
            store,
            open,
            fractions: HashMap::new(),
            computed: 0,
            failures: Vec::new(),
            problem: None,
            waited: false,
        };
        Ok(Self { jobs, task: Task::new("about")?, state: Mutex::new(state) })
    }

    pub fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Computes one job after the other until none is left, or until Ctrl-C.
    pub fn compute(&self, thread: usize, folds: &HashMap<(usize, usize), Fold>) {
        while !self.task.is_stopped() {
            let mut state = self.state();
            let State { store, open, .. } = &mut *state;
            let job = match store.claim(open) {
                Ok(Next::Job(job)) => job,
                Ok(Next::Wait) => {
                    state.say_waiting(&self.task);
                    drop(state);
                    thread::sleep(POLL);
                    continue;
                }
                Ok(Next::Done) => return,
                Err(error) => return self.fail(&mut state, error.as_ref()),
            };
            state.fractions.insert(thread, 0.0);
            drop(state);
            let Some(fold) = folds.get(&(job.held_out, job.training_trials)) else { return };
            let begin = Instant::now();
            let seconds = || begin.elapsed().as_secs_f64();
            let mut watch = |progress: &Training| {
                self.show(thread, progress.fraction);
                !self.task.is_stopped()
            };
            let result = match fold.evaluate(&job.candidate, job.seed, &seconds, &mut watch) {
                Ok(Some(outcome)) => Ok(outcome),
                Ok(None) => return,
                Err(error) => Err(error.to_string()),
            };
            let mut state = self.state();
            let ending = match &result {
                Ok(_) => "done".to_owned(),
                Err(reason) => {
                    state.failures.push(format!("{job}: {reason}"));
                    format!("failed: {reason}")
                }
            };
            let (id, trial, seed) = (job.candidate.kind().id(), job.held_out + 1, job.seed);
            if let Err(error) = state.store.add(Finished::new(job, result)) {
                return self.fail(&mut state, error.as_ref());
            }
            state.fractions.remove(&thread);
            state.computed += 1;
            let (done, jobs) = (self.jobs - state.left(), self.jobs);
            self.task.log(|| {
                let seconds = seconds();
                format!("{done} of {jobs} jobs: {id}, trial {trial} held out, seed {seed}, {ending} in {seconds:.1} s")
            });
            self.show_state(&mut state);
        }
    }

    /// Stops all threads because of an error of the results file.
    fn fail(&self, state: &mut State, error: &dyn Error) {
        state.problem = Some(error.to_string());
        self.task.stop();
    }

    fn show(&self, thread: usize, fraction: f64) {
        let mut state = self.state();
        state.fractions.insert(thread, fraction);
        self.show_state(&mut state);
    }

    fn show_state(&self, state: &mut State) {
        let (done, jobs) = (self.jobs - state.left(), self.jobs);
        let fraction = (done as f64 + state.fractions.values().sum::<f64>()) / jobs.max(1) as f64;
        self.task.show(fraction, || format!("{done} of {jobs} jobs"));
    }
}
