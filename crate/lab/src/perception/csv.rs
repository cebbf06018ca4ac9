//! Tables of answers: CSV whose rows have as many fields as the header.

use thiserror::Error;
use vcgpdm_core::series::records::records;

/// Why a text is not a table.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("line {line}: expected {expected}, found {found}")]
pub struct CsvError {
    /// The line, counted from 1.
    pub line: usize,
    /// The expectation that the line does not meet.
    pub expected: String,
    /// What the line contains instead.
    pub found: String,
}

/// All rows with the lines on which they begin, the header first.
pub(super) fn rows(text: &str) -> Result<Vec<(usize, Vec<String>)>, CsvError> {
    let rows = records(text.strip_prefix('\u{feff}').unwrap_or(text), ',').map_err(|line| CsvError {
        line,
        expected: "a quote that closes the field".to_owned(),
        found: "the end of the text".to_owned(),
    })?;
    let columns = rows.first().map_or(0, |(_, header)| header.len());
    match rows.iter().find(|(_, fields)| fields.len() != columns) {
        Some((line, fields)) => {
            let expected = format!("{columns} fields, as in the first line");
            Err(CsvError { line: *line, expected, found: fields.len().to_string() })
        }
        None => Ok(rows),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_quoted_fields_and_their_lines() {
        let row = |line: usize, fields: [&str; 2]| (line, fields.map(str::to_owned).to_vec());
        let text = "\u{feff}\"a\",b\r\n\"1,\"\"2\"\"\",\n\"x\r\ny\",é\nz,1";
        let expected =
            [row(1, ["a", "b"]), row(2, ["1,\"2\"", ""]), row(3, ["x\r\ny", "é"]), row(5, ["z", "1"])];
        assert_eq!(rows(text).unwrap(), expected);
        assert_eq!(rows("").unwrap(), []);
    }

    #[test]
    fn names_the_line_of_an_error() {
        let error = |text: &str| rows(text).unwrap_err().to_string();
        assert_eq!(error("a,b\n1\n"), "line 2: expected 2 fields, as in the first line, found 1");
        assert_eq!(
            error("a\n\"x\n"),
            "line 2: expected a quote that closes the field, found the end of the text"
        );
    }
}
