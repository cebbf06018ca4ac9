//! Tables of text with commas (RFC 4180): quoted fields, doubled quotes, either kind of line end.

use thiserror::Error;

/// Why a text is no table.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("line {line}: expected {expected}, found {found}")]
pub struct CsvError {
    /// Counted from 1.
    pub line: usize,
    /// What was expected.
    pub expected: String,
    /// What was found.
    pub found: String,
}

/// A row, and the line on which it begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Row {
    pub line: usize,
    pub fields: Vec<String>,
}

/// All rows, the header first; each has as many fields as it.
pub(super) fn rows(text: &str) -> Result<Vec<Row>, CsvError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut rows: Vec<Row> = Vec::new();
    let (mut rest, mut line) = (text, 1);
    while !rest.is_empty() {
        let begin = line;
        let mut fields = Vec::new();
        loop {
            let (field, after) = field(rest, &mut line)?;
            fields.push(field);
            match after.strip_prefix(',') {
                Some(after) => rest = after,
                None => {
                    rest = after.strip_prefix("\r\n").or_else(|| after.strip_prefix('\n')).unwrap_or(after);
                    line += 1;
                    break;
                }
            }
        }
        if let Some(header) = rows.first()
            && header.fields.len() != fields.len()
        {
            let expected = format!("{} fields, as in the first line", header.fields.len());
            return Err(CsvError { line: begin, expected, found: fields.len().to_string() });
        }
        rows.push(Row { line: begin, fields });
    }
    Ok(rows)
}

/// The next field and what stands after it: a comma, a line end, or nothing.
fn field<'a>(rest: &'a str, line: &mut usize) -> Result<(String, &'a str), CsvError> {
    let Some(mut inside) = rest.strip_prefix('"') else {
        let end = rest.find([',', '\n']).unwrap_or(rest.len());
        let plain = &rest[..end];
        // The end of a line may have two characters.
        let plain =
            if rest[end..].starts_with('\n') { plain.strip_suffix('\r').unwrap_or(plain) } else { plain };
        if let Some(at) = plain.find('"') {
            let found = plain[at..].chars().take(20).collect();
            let expected = "a field without quotes, or one that begins with one".to_owned();
            return Err(CsvError { line: *line, expected, found });
        }
        return Ok((plain.to_owned(), &rest[plain.len()..]));
    };
    let begin = *line;
    let mut field = String::new();
    loop {
        let Some(end) = inside.find('"') else {
            let expected = "a quote that closes the field".to_owned();
            return Err(CsvError { line: begin, expected, found: "the end of the text".to_owned() });
        };
        field.push_str(&inside[..end]);
        *line += inside[..end].matches('\n').count();
        inside = &inside[end + 1..];
        match inside.strip_prefix('"') {
            Some(after) => {
                field.push('"');
                inside = after;
            }
            None => break,
        }
    }
    if inside.is_empty() || inside.starts_with([',', '\n']) || inside.starts_with("\r\n") {
        return Ok((field, inside));
    }
    let expected = "a comma or the end of the line after a quoted field".to_owned();
    Err(CsvError { line: *line, expected, found: inside.chars().take(20).collect() })
}

/// A field as it is written: quoted where it must be.
pub(super) fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn fields(text: &str) -> Vec<Vec<String>> {
        rows(text).unwrap().into_iter().map(|row| row.fields).collect()
    }

    #[test]
    fn quotes_commas_and_line_ends() {
        let found = fields("\u{feff}\"a\",b\r\n\"1,\"\"2\"\"\",\n\"x\r\ny\",é");
        assert_eq!(found, [["a", "b"], ["1,\"2\"", ""], ["x\r\ny", "é"]]);
        let lines: Vec<usize> = rows("a\n\"x\ny\"\nz\n").unwrap().iter().map(|row| row.line).collect();
        assert_eq!(lines, [1, 2, 4]);
        assert_eq!(fields(""), Vec::<Vec<String>>::new());
    }

    #[test]
    fn errors_name_the_line() {
        let error = |text: &str| rows(text).unwrap_err().to_string();
        assert_eq!(error("a,b\n1\n"), "line 2: expected 2 fields, as in the first line, found 1");
        assert_eq!(
            error("a\n\"x\n"),
            "line 2: expected a quote that closes the field, found the end of the text"
        );
        assert_eq!(
            error("a\n\"x\ny\"z"),
            "line 3: expected a comma or the end of the line after a quoted field, found z"
        );
        assert_eq!(
            error("a\nx\"y"),
            "line 2: expected a field without quotes, or one that begins with one, found \"y"
        );
    }

    proptest! {
        #[test]
        fn any_fields_come_back(table in prop::collection::vec(prop::collection::vec("[a,\"\r\né ]{0,5}", 2), 1..5)) {
            let line = |row: &Vec<String>| row.iter().map(|field| quoted(field)).collect::<Vec<_>>().join(",") + "\r\n";
            let text: String = table.iter().map(line).collect();
            prop_assert_eq!(fields(&text), table);
        }

        #[test]
        fn no_text_panics(text in "[a,\"\r\n]{0,30}") {
            let _ = rows(&text);
        }
    }
}
