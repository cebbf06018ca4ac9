//! How far the work is, on stderr: a bar on a terminal; elsewhere, as in the log of a scheduler, a line now
//! and then.

use crate::files;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

/// A log gets a line at least so often.
const EVERY: Duration = Duration::from_secs(60);

/// Steps of the bar for one piece of work.
const FINE: f64 = 1000.0;

pub struct Progress {
    bar: ProgressBar,
    /// Absent on a terminal.
    log: Option<Log>,
}

impl Progress {
    /// `left` says what the estimate of the time left is: "at most" or "about".
    pub fn new(left: &str) -> Self {
        let bar = ProgressBar::new(FINE as u64);
        let template = format!("{{bar:30}} {{msg}}  {{elapsed}} ({left} {{eta}} left)");
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style);
        }
        Self { bar, log: (!std::io::stderr().is_terminal()).then(|| Log { last: Instant::now() }) }
    }

    /// Shows how far all of the work is, 0 to 1, and in words.
    pub fn show(&mut self, fraction: f64, words: impl FnOnce() -> String) {
        match &mut self.log {
            Some(log) => {
                if log.is_due(Instant::now()) {
                    say(&words());
                }
            }
            None => {
                self.bar.set_position((fraction * FINE) as u64);
                self.bar.set_message(words());
            }
        }
    }

    /// Says what has come to its end: where there is no bar that shows it.
    pub fn ended(&mut self, words: impl FnOnce() -> String) {
        if let Some(log) = &mut self.log {
            log.last = Instant::now();
            say(&words());
        }
    }

    /// Says something once, beside the bar.
    pub fn note(&self, words: &str) {
        self.bar.suspend(|| say(words));
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// A line on stderr, beside whatever bar there is.
pub fn say(words: &str) {
    // Nobody is left to tell when stderr is closed.
    let _ = writeln!(std::io::stderr(), "vcgpdm: {}", files::escape(words));
}

/// When the last line was written.
struct Log {
    last: Instant,
}

impl Log {
    /// Whether it is time for the next line, which then counts as written.
    fn is_due(&mut self, now: Instant) -> bool {
        let due = now.duration_since(self.last) >= EVERY;
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
    fn a_log_gets_a_line_a_minute() {
        let begin = Instant::now();
        let mut log = Log { last: begin };
        let lines = (0..300).filter(|s| log.is_due(begin + Duration::from_secs(*s))).collect::<Vec<_>>();
        assert_eq!(lines, [60, 120, 180, 240]);
    }
}
