//! Rows of CSV text, read by the crate `csv`, with the lines on which they begin.

use csv::{ReaderBuilder, StringRecord, Trim};

/// The rows of a CSV text: the line on which each begins, counted from 1, and its trimmed fields. Rows
/// without any text are left out. The line ends CR, LF and CR LF each end one line.
///
/// # Errors
///
/// The line of a row with a quote that is never closed.
pub fn records(text: &str, separator: char) -> Result<Vec<(usize, Vec<String>)>, usize> {
    let mut reader = ReaderBuilder::new()
        .delimiter(separator as u8)
        .has_headers(false)
        .flexible(true)
        .trim(Trim::All)
        .from_reader(text.as_bytes());
    let mut records = Vec::new();
    let mut record = StringRecord::new();
    let (mut begin, mut line) = (0, 1);
    // Reading from memory cannot fail, and the text is UTF-8.
    while reader.read_record(&mut record).unwrap_or(false) {
        let place = record.position().map_or(begin, |position| position.byte() as usize);
        // The position of a row is before the blank lines that precede it.
        let place = place + (text.len() - place - text[place..].trim_start_matches(['\r', '\n']).len());
        line += line_ends(&text[begin..place]);
        begin = place;
        if record.iter().any(|field| !field.is_empty()) {
            records.push((line, record.iter().map(without_quotes).collect()));
        }
    }
    // A quote that is never closed makes all that follows one field.
    if text[begin..].matches('"').count() % 2 == 1 {
        return Err(line);
    }
    Ok(records)
}

/// The crate takes quotes literally where a blank precedes them, as in `"x", "y"`.
fn without_quotes(field: &str) -> String {
    field.strip_prefix('"').and_then(|field| field.strip_suffix('"')).unwrap_or(field).to_owned()
}

fn line_ends(text: &str) -> usize {
    let lone_returns = text.split('\r').skip(1).filter(|rest| !rest.starts_with('\n')).count();
    text.matches('\n').count() + lone_returns
}
