//! Text of strangers in tables.

/// A stranger's text for a line or a cell of Markdown: without line breaks and with escaped bars.
pub fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "\\|")
}

#[cfg(test)]
mod tests {
    use super::one_line;

    #[test]
    fn keeps_line_breaks_and_bars_out_of_tables() {
        assert_eq!(one_line("expected a | b,\n\n| found |\r\n c"), "expected a \\| b, \\| found \\| c");
    }
}
