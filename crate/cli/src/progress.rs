//! Progress on stderr: a bar on a terminal; in a log, such as that of a scheduler, a line every minute.

use crate::files;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

/// Time between two lines of a log.
const INTERVAL: Duration = Duration::from_secs(60);

/// Steps of the bar.
const STEPS: f64 = 1000.0;

pub struct Progress {
    bar: ProgressBar,
    /// Absent on a terminal.
    log: Option<Log>,
}

impl Progress {
    /// `precision` of the estimated time that is left: "at most" or "about".
    pub fn new(precision: &str) -> Self {
        let bar = ProgressBar::new(STEPS as u64);
        let template = format!("{{bar:30}} {{msg}}  {{elapsed}} ({precision} {{eta}} left)");
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style);
        }
        Self { bar, log: (!std::io::stderr().is_terminal()).then(|| Log { last: Instant::now() }) }
    }

    /// Shows the finished fraction of the work, 0 to 1, and a message.
    pub fn show(&mut self, fraction: f64, message: impl FnOnce() -> String) {
        match &mut self.log {
            Some(log) => {
                if log.is_due(Instant::now()) {
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
    pub fn log(&mut self, message: impl FnOnce() -> String) {
        if let Some(log) = &mut self.log {
            log.last = Instant::now();
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
