//! Tables as CSV (RFC 4180, also with semicolons or tabs): a header row with names, then a row of numbers a
//! moment.

use crate::motion::sha256;
use crate::series::error::SeriesError;
use crate::series::table::Table;
use nalgebra::DMatrix;
use std::fmt::Write;

/// Numbers of absurd size: squares of larger ones could drown all others.
const LARGEST: f64 = 1e9;
/// More numbers than can be trained on.
const MOST_NUMBERS: usize = 20_000_000;
/// More columns than a model can have.
const MOST_COLUMNS: usize = 10_000;
/// How far, as a share of a step, a time may be from where equal steps would have it.
const UNEVEN: f64 = 0.05;

impl Table {
    /// A trial of numbers [rows x columns] that a program has at hand, `frame_time` seconds from row to row.
    /// It is known by the hash of what [`write`](write()) makes of it.
    pub fn new(name: &str, columns: Vec<String>, values: DMatrix<f64>, frame_time: f64) -> Table {
        let sha256 = sha256(write(&columns, &values, frame_time).as_bytes());
        Table { name: name.to_owned(), sha256, columns, values, frame_time: Some(frame_time) }
    }
}

/// Reads a trial. A column `time` (or `t`, `seconds`) holds seconds and says how far rows are apart; it and a
/// column `frame` are not numbers to learn.
///
/// ```
/// let table = vcgpdm::series::read("trial.csv", b"time,x,y\n0,1,2\n0.5,3,4\n")?;
/// assert_eq!((table.columns.join(" "), table.frame_time), ("x y".to_owned(), Some(0.5)));
/// # Ok::<(), vcgpdm::series::SeriesError>(())
/// ```
///
/// # Errors
///
/// When it is no such text, with the line and the column.
pub fn read(file: &str, bytes: &[u8]) -> Result<Table, SeriesError> {
    let about = |line: usize, problem: &str| SeriesError::Line {
        file: file.to_owned(),
        line,
        problem: problem.to_owned(),
    };
    let text =
        std::str::from_utf8(bytes).map_err(|_| about(1, "expected text in UTF-8, found other bytes"))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let first = text.lines().next().unwrap_or_default();
    let separator =
        [';', '\t'].into_iter().find(|c| first.contains(*c) && !first.contains(',')).unwrap_or(',');
    let records =
        records(text, separator).map_err(|line| about(line, "expected a closing quote, found none"))?;
    let mut records = records.into_iter().filter(|(_, fields)| fields.iter().any(|field| !field.is_empty()));
    let (line, names) = records
        .next()
        .ok_or_else(|| about(1, "expected a row with the names of the columns, found nothing"))?;
    check_names(&names).map_err(|problem| about(line, &problem))?;

    // Blank lines are no rows: each row has the line on which it stands.
    let (mut rows, mut lines) = (Vec::new(), Vec::new());
    for (line, fields) in records {
        if fields.len() != names.len() {
            let problem =
                format!("expected {} fields, as in the first row, found {}", names.len(), fields.len());
            return Err(about(line, &problem));
        }
        if (rows.len() + 1) * names.len() > MOST_NUMBERS {
            return Err(about(line, &format!("expected a table of at most {MOST_NUMBERS} numbers")));
        }
        let numbers = fields.iter().zip(&names).enumerate().map(|(k, (field, name))| {
            number(field).map_err(|expected| SeriesError::Number {
                file: file.to_owned(),
                line,
                column: k + 1,
                name: name.clone(),
                expected,
                found: field.chars().take(40).collect(),
            })
        });
        rows.push(numbers.collect::<Result<Vec<f64>, _>>()?);
        lines.push(line);
    }
    if rows.len() < 2 {
        return Err(about(
            lines.last().copied().unwrap_or(line),
            &format!("expected at least two rows of numbers, found {}", rows.len()),
        ));
    }
    let role = |name: &str| name.trim().to_ascii_lowercase();
    let is_time = |name: &String| ["time", "t", "seconds"].contains(&role(name).as_str());
    let time = names.iter().position(is_time);
    let frame_time =
        time.map(|k| step(&rows, k)).transpose().map_err(|(row, expected)| SeriesError::Number {
            file: file.to_owned(),
            line: lines[row],
            column: time.unwrap_or(0) + 1,
            name: time.map_or_else(String::new, |k| names[k].clone()),
            expected,
            found: rows[row][time.unwrap_or(0)].to_string(),
        })?;
    let kept: Vec<usize> =
        (0..names.len()).filter(|&k| Some(k) != time && role(&names[k]) != "frame").collect();
    if kept.is_empty() {
        return Err(about(line, "expected a column of numbers beside the times, found none"));
    }
    let values = DMatrix::from_fn(rows.len(), kept.len(), |row, column| rows[row][kept[column]]);
    let columns = kept.iter().map(|&k| names[k].trim().to_owned()).collect();
    Ok(Table { name: file.to_owned(), sha256: sha256(bytes), columns, values, frame_time })
}

/// A table as CSV: frame, time in seconds, and the columns [frames x D] under their names.
pub fn write(names: &[String], values: &DMatrix<f64>, frame_time: f64) -> String {
    let mut text = "frame,time".to_owned();
    for name in names {
        text += ",";
        text += &quoted(name);
    }
    text.push('\n');
    for (frame, row) in values.row_iter().enumerate() {
        // Writing to a String cannot fail.
        let _ = write!(text, "{frame},{}", frame as f64 * frame_time);
        for value in row.iter() {
            let _ = write!(text, ",{value}");
        }
        text.push('\n');
    }
    text
}

/// A field (RFC 4180). What a spreadsheet would compute begins with an apostrophe, which makes it a text:
/// names come from strangers' files.
fn quoted(field: &str) -> String {
    let field =
        &if field.starts_with(['=', '+', '-', '@', '\t']) { format!("'{field}") } else { field.to_owned() };
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.clone()
    }
}

/// Fields of each row, with the line on which the row begins, counted from 1; or the line of a quote that is
/// never closed.
fn records(text: &str, separator: char) -> Result<Vec<(usize, Vec<String>)>, usize> {
    let (mut records, mut fields, mut field) = (Vec::new(), Vec::new(), String::new());
    let (mut line, mut begin, mut opened) = (1, 1, None);
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        match (letter, opened) {
            ('"', Some(_)) if letters.peek() == Some(&'"') => {
                letters.next();
                field.push('"');
            }
            ('"', Some(_)) => opened = None,
            ('"', None) if field.trim().is_empty() => {
                field.clear();
                opened = Some(line);
            }
            ('\n', None) => {
                fields.push(std::mem::take(&mut field).trim().to_owned());
                records.push((begin, std::mem::take(&mut fields)));
                line += 1;
                begin = line;
            }
            (letter, None) if letter == separator => {
                fields.push(std::mem::take(&mut field).trim().to_owned())
            }
            (letter, _) => {
                line += usize::from(letter == '\n');
                field.push(letter);
            }
        }
    }
    if let Some(line) = opened {
        return Err(line);
    }
    if !field.is_empty() || !fields.is_empty() {
        fields.push(field.trim().to_owned());
        records.push((begin, fields));
    }
    Ok(records)
}

fn check_names(names: &[String]) -> Result<(), String> {
    if names.len() > MOST_COLUMNS {
        return Err(format!("expected at most {MOST_COLUMNS} columns, found {}", names.len()));
    }
    if names.iter().all(|name| name.parse::<f64>().is_ok()) {
        return Err("expected a row with the names of the columns, found numbers".to_owned());
    }
    for (k, name) in names.iter().enumerate() {
        if name.is_empty() {
            return Err(format!("expected a name for column {}, found none", k + 1));
        }
        if let Some(other) = names[..k].iter().position(|before| before == name) {
            return Err(format!(
                "expected a name of its own for column {}, found {name:?}, as column {} has",
                k + 1,
                other + 1
            ));
        }
    }
    Ok(())
}

/// The number in a field, or what was expected.
fn number(field: &str) -> Result<f64, &'static str> {
    match field.parse::<f64>() {
        Ok(number) if number.abs() <= LARGEST => Ok(number),
        Ok(_) => Err("a number from -1e9 to 1e9"),
        Err(_) if field.contains(',') => Err("a number with a point, such as 1.5"),
        Err(_) if field.is_empty() => Err("a number (fill gaps before)"),
        Err(_) => Err("a number"),
    }
}

/// Seconds from one row to the next by the times in a column; or the row that is not where it should be, and
/// where that is.
fn step(rows: &[Vec<f64>], column: usize) -> Result<f64, (usize, &'static str)> {
    let time = |row: usize| rows[row][column];
    let step = (time(rows.len() - 1) - time(0)) / (rows.len() - 1) as f64;
    if !(1e-5..=10.0).contains(&step) {
        return Err((rows.len() - 1, "seconds that grow by 0.00001 to 10 a row"));
    }
    let uneven = |row: &usize| (time(*row) - time(row - 1) - step).abs() > UNEVEN * step;
    match (1..rows.len()).find(uneven) {
        None => Ok(step),
        Some(row) => Err((row, "seconds that grow by as much from row to row (resample before)")),
    }
}
