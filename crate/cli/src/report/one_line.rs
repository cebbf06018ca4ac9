//! Cells of tables: text of strangers on one line, and means with their errors.

use vcgpdm_lab::evaluation::{Spread, fixed};

/// A stranger's text for a line or a cell of Markdown: without line breaks and with escaped bars.
pub fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "\\|")
}

/// Mean and standard error.
pub fn spread(spread: &Spread, digits: usize) -> String {
    match spread.standard_error {
        Some(error) => format!("{} ± {}", fixed(spread.mean, digits), fixed(error, digits)),
        None => fixed(spread.mean, digits),
    }
}

#[cfg(test)]
mod tests {
    use super::one_line;

    #[test]
    fn keeps_line_breaks_and_bars_out_of_tables() {
        assert_eq!(one_line("expected a | b,\n\n| found |\r\n c"), "expected a \\| b, \\| found \\| c");
    }
}
