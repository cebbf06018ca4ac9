//! Tables as CSV (RFC 4180; also with semicolons or tabs): a header row with names, then rows of numbers.

use crate::encoding::utf16;
use crate::motion::{sha256, table_of_program};
use crate::series::clock::{STEPS, Timing, WrongTime, is_clock, timing};
use crate::series::error::SeriesError;
use crate::series::records::records;
use crate::series::table::Table;
use nalgebra::DMatrix;

/// Largest size of a number: the squares of larger numbers could dominate all others.
const LARGEST: f64 = 1e9;
/// The numbers of at most this size as text.
const USABLE: &str = "a number from -1e9 to 1e9";
/// Largest number of values in a table.
const MOST_NUMBERS: usize = 20_000_000;
/// Largest number of columns of a table.
const MOST_COLUMNS: usize = 10_000;
/// A spreadsheet computes texts that begin with one of these. `www/src/figures/csv.ts` has the same list.
const FORMULA_SIGNS: &str = "=+-@\t\r\n＝＋－＠";

fn is_too_large(rows: usize, columns: usize) -> bool {
    rows.saturating_mul(columns) > MOST_NUMBERS
}

impl Table {
    /// A table of values [rows x columns] with `frame_time` seconds from row to row. Its hash is that of the
    /// text that [`write`](write()) returns.
    pub fn new(name: &str, columns: Vec<String>, values: DMatrix<f64>, frame_time: f64) -> Table {
        let sha256 = sha256(write(&columns, &values, frame_time).as_bytes());
        Table {
            name: name.to_owned(),
            sha256,
            columns,
            values,
            frame_time: Some(frame_time),
            warnings: Vec::new(),
        }
    }

    /// As [`Table::new`], of values [rows x columns] from another program, under the rules for files.
    ///
    /// # Errors
    ///
    /// [`SeriesError::Table`] when there are fewer than two rows, the frame time is not from 0.00001 to 10, no columns, two columns of one name, or a
    /// number that is not finite or too large.
    pub fn checked(
        name: &str,
        columns: Vec<String>,
        values: DMatrix<f64>,
        frame_time: f64,
    ) -> Result<Table, SeriesError> {
        let refuse = |problem: String| Err(SeriesError::Table { table: name.to_owned(), problem });
        let (rows, width) = values.shape();
        if width == 0 || width != columns.len() {
            return refuse(format!("expected one name for each column, found {} for {width}", columns.len()));
        }
        if let Err(problem) = check_names(&columns).and_then(|()| check_named(&columns, 0..width)) {
            return refuse(problem);
        }
        if !STEPS.contains(&frame_time) {
            return refuse(format!("expected 0.00001 to 10 seconds from row to row, found {frame_time}"));
        }
        if rows < 2 {
            return refuse(format!("expected at least two rows of numbers, found {rows}"));
        }
        if is_too_large(rows, width) {
            return refuse(format!("expected at most {MOST_NUMBERS} numbers, found {rows} rows of {width}"));
        }
        let wrong = |at: &usize| !is_usable(values[(at / width, at % width)]);
        if let Some(at) = (0..rows * width).find(wrong) {
            let (row, column) = (at / width, at % width);
            let found = values[(row, column)];
            let name = &columns[column];
            return refuse(format!("row {row}, column {column} ({name}): expected {USABLE}, found {found}"));
        }
        Ok(Table::new(name, columns, values, frame_time))
    }
}

/// Reads a table from text in UTF-8 or UTF-16. A column such as `time`, `t`, `seconds`, `Time (ms)` or
/// `timestamp` holds the time of each row, in seconds if its name has no other unit. Neither this column nor
/// columns that count rows (`frame`, `Frame#`, an index without a name) become columns of the table.
///
/// ```
/// let table = vcgpdm_core::series::read("trial.csv", b"time,x,y\n0,1,2\n0.5,3,4\n")?;
/// assert_eq!((table.columns.join(" "), table.frame_time), ("x y".to_owned(), Some(0.5)));
/// # Ok::<(), vcgpdm_core::series::SeriesError>(())
/// ```
///
/// # Errors
///
/// A [`SeriesError`] with the line, and for a wrong number with the column and its name.
pub fn read(file: &str, bytes: &[u8]) -> Result<Table, SeriesError> {
    let error_at = |line: usize, problem: &str| SeriesError::Line {
        file: file.to_owned(),
        line,
        problem: problem.to_owned(),
    };
    let text = match utf16(bytes) {
        Some(text) => text,
        None => std::str::from_utf8(bytes)
            .map_err(|_| error_at(1, "expected text in UTF-8 or UTF-16, found other bytes"))?
            .to_owned(),
    };
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    if let Some(program) = table_of_program(text) {
        let problem = format!(
            "expected a row with the names of the columns, found {program}, which begins with other rows: leave \
             one row with a name for each column, and the rows of numbers"
        );
        return Err(error_at(1, &problem));
    }
    let separator = separator(text);
    let records =
        records(text, separator).map_err(|line| error_at(line, "expected a closing quote, found none"))?;
    let mut records = records.into_iter();
    let (line, names) = records
        .next()
        .ok_or_else(|| error_at(1, "expected a row with the names of the columns, found nothing"))?;
    check_names(&names).map_err(|problem| error_at(line, &problem))?;
    let records: Vec<_> = records.collect();
    // In German tables, semicolons separate numbers with commas.
    let has_comma = |(_, fields): &(usize, Vec<String>)| fields.iter().any(|field| field.contains(','));
    let comma = separator != ',' && records.iter().any(has_comma);

    let (mut rows, mut lines) = (Vec::new(), Vec::new());
    for (line, fields) in records {
        if fields.len() != names.len() {
            let problem =
                format!("expected {} fields, as in the first row, found {}", names.len(), fields.len());
            return Err(error_at(line, &problem));
        }
        if is_too_large(rows.len() + 1, names.len()) {
            return Err(error_at(line, &format!("expected a table of at most {MOST_NUMBERS} numbers")));
        }
        let numbers = fields.iter().zip(&names).enumerate().map(|(k, (field, name))| {
            // The fields of a column without a name may be empty: it is left out below.
            if name.is_empty() && field.is_empty() {
                return Ok(f64::NAN);
            }
            number(field, comma, is_clock(name)).map_err(|expected| SeriesError::Number {
                file: file.to_owned(),
                line,
                column: k + 1,
                name: name.clone(),
                expected: expected.to_owned(),
                found: field.chars().take(40).collect(),
            })
        });
        rows.push(numbers.collect::<Result<Vec<f64>, _>>()?);
        lines.push(line);
    }
    if rows.len() < 2 {
        return Err(error_at(
            lines.last().copied().unwrap_or(line),
            &format!("expected at least two rows of numbers, found {}", rows.len()),
        ));
    }
    let Timing { frame_time, mut used, warnings } =
        timing(&names, &rows, &lines).map_err(|WrongTime { row, column, expected }| SeriesError::Number {
            file: file.to_owned(),
            line: lines[row],
            column: column + 1,
            name: names[column].clone(),
            expected,
            found: rows[row][column].to_string(),
        })?;
    used.retain(|&k| !(names[k].is_empty() && rows.iter().all(|row| row[k].is_nan())));
    check_named(&names, used.iter().copied()).map_err(|problem| error_at(line, &problem))?;
    if used.is_empty() {
        return Err(error_at(line, "expected a column of numbers other than times, found none"));
    }
    let values = DMatrix::from_fn(rows.len(), used.len(), |row, column| rows[row][used[column]]);
    Ok(Table {
        name: file.to_owned(),
        sha256: sha256(bytes),
        columns: used.iter().map(|&k| names[k].clone()).collect(),
        values,
        frame_time,
        warnings,
    })
}

/// The sign that divides the first row into the most fields.
fn separator(text: &str) -> char {
    let first = text.trim_start_matches(['\r', '\n', ' ']).split(['\r', '\n']).next().unwrap_or_default();
    let count = |sign: char| first.split('"').step_by(2).map(|outside| outside.matches(sign).count()).sum();
    let mut best = (',', count(','));
    for sign in [';', '\t'] {
        let found: usize = count(sign);
        if found > best.1 {
            best = (sign, found);
        }
    }
    best.0
}

/// Writes a table as CSV: frame, time in seconds, and the columns of `values` [frames x D] with their names.
pub fn write(names: &[String], values: &DMatrix<f64>, frame_time: f64) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let header =
        ["frame", "time"].map(str::to_owned).into_iter().chain(names.iter().map(|name| guarded(name)));
    // Writing to memory cannot fail: the results are ignored here and below.
    let _ = writer.write_record(header);
    for (frame, row) in values.row_iter().enumerate() {
        let times = [frame.to_string(), (frame as f64 * frame_time).to_string()];
        let _ = writer.write_record(times.into_iter().chain(row.iter().map(f64::to_string)));
    }
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

/// A spreadsheet would compute a name that begins like a formula, and names come from strangers' files. An
/// apostrophe makes it text.
fn guarded(name: &str) -> String {
    if name.starts_with(|c| FORMULA_SIGNS.contains(c)) { format!("'{name}") } else { name.to_owned() }
}

/// Checks the names of columns; a column may have none.
fn check_names(names: &[String]) -> Result<(), String> {
    if names.len() > MOST_COLUMNS {
        return Err(format!("expected at most {MOST_COLUMNS} columns, found {}", names.len()));
    }
    if names.iter().all(|name| name.parse::<f64>().is_ok()) {
        return Err("expected a row with the names of the columns, found numbers".to_owned());
    }
    for (k, name) in names.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
        if let Some(other) = names[..k].iter().position(|earlier| earlier == name) {
            return Err(format!(
                "expected a name of its own for column {}, found {name:?}, as column {} has",
                k + 1,
                other + 1
            ));
        }
    }
    Ok(())
}

/// Checks that each of these columns has a name.
fn check_named(names: &[String], mut used: impl Iterator<Item = usize>) -> Result<(), String> {
    match used.find(|&k| names[k].is_empty()) {
        Some(k) => Err(format!("expected a name for column {}, found none", k + 1)),
        None => Ok(()),
    }
}

/// Whether the number is finite and not too large.
fn is_usable(number: f64) -> bool {
    number.abs() <= LARGEST
}

/// The number in a field, with a decimal comma or a point, or the expectation that it does not meet. Times
/// may be large: only their differences matter.
fn number(field: &str, comma: bool, is_time: bool) -> Result<f64, &'static str> {
    if comma && field.contains('.') {
        return Err("a number with a comma, as others in this file (a point may separate thousands)");
    }
    let parsed = if comma { field.replacen(',', ".", 1).parse() } else { field.parse::<f64>() };
    match parsed {
        Ok(number) if is_usable(number) || is_time && number.is_finite() => Ok(number),
        Ok(_) => Err(USABLE),
        Err(_) if field.contains(',') => Err("a number with a point, such as 1.5"),
        Err(_) if field.is_empty() => Err("a number (fill gaps before)"),
        Err(_) if field.contains(':') => Err("a number (times as seconds, such as 12.5)"),
        Err(_) if field.contains(char::is_whitespace) => {
            Err("a number (commas, semicolons or tabs between the columns)")
        }
        Err(_) => Err("a number"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_has_twenty_million_numbers_at_most() {
        let sizes = [(5_000, 4_000), (5_000, 4_001)];
        assert_eq!(sizes.map(|(rows, columns)| is_too_large(rows, columns)), [false, true]);
    }

    #[test]
    fn as_many_columns_and_as_large_numbers_as_the_limits_are_read() {
        let names = |count: usize| check_names(&vec![String::new(); count]).is_ok();
        assert_eq!([MOST_COLUMNS, MOST_COLUMNS + 1].map(names), [true, false]);
        assert_eq!([LARGEST, -LARGEST, 1.1 * LARGEST, f64::NAN].map(is_usable), [true, true, false, false]);
    }
}
