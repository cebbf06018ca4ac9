//! A long task of the program: its progress on stderr, and whether it is to stop.
//!
//! On a terminal the progress is a bar; in a log, such as that of a scheduler, a line every minute.

use crate::files;
use indicatif::{ProgressBar, ProgressStyle};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::error::Error;
use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Time between two lines of a log.
const INTERVAL: Duration = Duration::from_secs(60);

/// Steps of the bar.
const STEPS: f64 = 1000.0;

/// A task that several threads may do. It stops at Ctrl-C or SIGTERM, and keeps the best so far.
pub struct Task {
    stopped: Arc<AtomicBool>,
    bar: ProgressBar,
    /// Absent on a terminal.
    log: Option<Mutex<Log>>,
}

impl Task {
    /// `precision` of the estimated time that is left: "at most" or "about". The first Ctrl-C or SIGTERM (the end of
    /// a Slurm job's time) asks the task to stop, a second one ends the program at once. SIGHUP, the end of the
    /// terminal, keeps its default action, so that `nohup` can switch it off.
    pub fn new(precision: &str) -> Result<Self, Box<dyn Error>> {
        let stopped = Arc::new(AtomicBool::new(false));
        for signal in [SIGINT, SIGTERM] {
            // The order matters: at the first signal the flag must still be false.
            flag::register_conditional_shutdown(signal, 1, Arc::clone(&stopped))?;
            flag::register(signal, Arc::clone(&stopped))?;
        }
        let bar = ProgressBar::new(STEPS as u64);
        let template = format!("{{bar:30}} {{msg}}  {{elapsed}} ({precision} {{eta}} left)");
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style);
        }
        let log = (!std::io::stderr().is_terminal()).then(|| Mutex::new(Log { last: Instant::now() }));
        Ok(Self { stopped, bar, log })
    }

    /// Whether the task is to stop.
    pub fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// Asks all threads of the task to stop.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Shows the finished fraction of the work, 0 to 1, and a message.
    pub fn show(&self, fraction: f64, message: impl FnOnce() -> String) {
        match &self.log {
            Some(log) => {
                if log.lock().unwrap_or_else(PoisonError::into_inner).is_due(Instant::now()) {
                    say(&message());
                }
            }
            None => {
                self.bar.set_position((fraction * STEPS) as u64);
                self.bar.set_message(message());
            }
        }
    }

    /// Writes to a log that a piece of the work has ended. On a terminal the bar shows this.
    pub fn log(&self, message: impl FnOnce() -> String) {
        if let Some(log) = &self.log {
            log.lock().unwrap_or_else(PoisonError::into_inner).last = Instant::now();
            say(&message());
        }
    }

    /// Writes a line above the bar.
    pub fn note(&self, message: &str) {
        self.bar.suspend(|| say(message));
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// Writes a line to stderr.
pub fn say(message: &str) {
    // An error on stderr cannot be reported anywhere.
    let _ = writeln!(std::io::stderr(), "vcgpdm: {}", files::escape(message));
}

/// The lines of a log.
struct Log {
    /// When the last line was written.
    last: Instant,
}

impl Log {
    /// Whether the next line is due. If so, it counts as written.
    fn is_due(&mut self, now: Instant) -> bool {
        let due = now.duration_since(self.last) >= INTERVAL;
        if due {
            self.last = now;
        }
        due
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_a_line_to_a_log_every_minute() {
        let begin = Instant::now();
        let mut log = Log { last: begin };
        let lines = (0..300).filter(|s| log.is_due(begin + Duration::from_secs(*s))).collect::<Vec<_>>();
        assert_eq!(lines, [60, 120, 180, 240]);
    }
}
