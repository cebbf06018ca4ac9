//! Tables as CSV (RFC 4180; also with semicolons or tabs): a header row with names, then rows of numbers.

use crate::encoding::utf16;
use crate::motion::sha256;
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
/// Largest deviation of a time step from the mean step, as a fraction of the mean step.
const UNEVEN: f64 = 0.05;

impl Table {
    /// A table of values [rows x columns] with `frame_time` seconds from row to row. Its hash is that of the
    /// text that [`write`](write()) returns.
    pub fn new(name: &str, columns: Vec<String>, values: DMatrix<f64>, frame_time: f64) -> Table {
        let sha256 = sha256(write(&columns, &values, frame_time).as_bytes());
        Table { name: name.to_owned(), sha256, columns, values, frame_time: Some(frame_time) }
    }

    /// As [`Table::new`], of values [rows x columns] from another program, under the rules for files.
    ///
    /// # Errors
    ///
    /// [`SeriesError::Table`] when there are fewer than two rows, no columns, two columns of one name, or a
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
        if let Err(problem) = check_names(&columns) {
            return refuse(problem);
        }
        if rows < 2 {
            return refuse(format!("expected at least two rows of numbers, found {rows}"));
        }
        if rows.saturating_mul(width) > MOST_NUMBERS {
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

/// Reads a table from text in UTF-8 or UTF-16. A column `time` (or `t`, `seconds`) holds the time of each row
/// in seconds. Neither this column nor a column `frame` becomes a column of the table.
///
/// ```
/// let table = vcgpdm::series::read("trial.csv", b"time,x,y\n0,1,2\n0.5,3,4\n")?;
/// assert_eq!((table.columns.join(" "), table.frame_time), ("x y".to_owned(), Some(0.5)));
/// # Ok::<(), vcgpdm::series::SeriesError>(())
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
    let first = text.trim_start().split(['\r', '\n']).next().unwrap_or_default();
    let separator =
        [';', '\t'].into_iter().find(|c| first.contains(*c) && !first.contains(',')).unwrap_or(',');
    let records =
        records(text, separator).map_err(|line| error_at(line, "expected a closing quote, found none"))?;
    let mut records = records.into_iter();
    let (line, names) = records
        .next()
        .ok_or_else(|| error_at(1, "expected a row with the names of the columns, found nothing"))?;
    check_names(&names).map_err(|problem| error_at(line, &problem))?;

    let (mut rows, mut lines) = (Vec::new(), Vec::new());
    for (line, fields) in records {
        if fields.len() != names.len() {
            let problem =
                format!("expected {} fields, as in the first row, found {}", names.len(), fields.len());
            return Err(error_at(line, &problem));
        }
        if (rows.len() + 1) * names.len() > MOST_NUMBERS {
            return Err(error_at(line, &format!("expected a table of at most {MOST_NUMBERS} numbers")));
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
        return Err(error_at(
            lines.last().copied().unwrap_or(line),
            &format!("expected at least two rows of numbers, found {}", rows.len()),
        ));
    }
    let lower_case = |name: &str| name.to_ascii_lowercase();
    let is_time = |name: &String| ["time", "t", "seconds"].contains(&lower_case(name).as_str());
    let time = names.iter().position(is_time);
    let frame_time =
        time.map(|k| time_step(&rows, k)).transpose().map_err(|(row, expected)| SeriesError::Number {
            file: file.to_owned(),
            line: lines[row],
            column: time.unwrap_or(0) + 1,
            name: time.map_or_else(String::new, |k| names[k].clone()),
            expected,
            found: rows[row][time.unwrap_or(0)].to_string(),
        })?;
    let used: Vec<usize> =
        (0..names.len()).filter(|&k| Some(k) != time && lower_case(&names[k]) != "frame").collect();
    if used.is_empty() {
        return Err(error_at(line, "expected a column of numbers other than times, found none"));
    }
    let values = DMatrix::from_fn(rows.len(), used.len(), |row, column| rows[row][used[column]]);
    let columns = used.iter().map(|&k| names[k].clone()).collect();
    Ok(Table { name: file.to_owned(), sha256: sha256(bytes), columns, values, frame_time })
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
    if name.starts_with(['=', '+', '-', '@', '\t']) { format!("'{name}") } else { name.to_owned() }
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

/// Whether the number is finite and not too large.
fn is_usable(number: f64) -> bool {
    number.abs() <= LARGEST
}

/// The number in a field, or the expectation that it does not meet.
fn number(field: &str) -> Result<f64, &'static str> {
    match field.parse::<f64>() {
        Ok(number) if is_usable(number) => Ok(number),
        Ok(_) => Err(USABLE),
        Err(_) if field.contains(',') => Err("a number with a point, such as 1.5"),
        Err(_) if field.is_empty() => Err("a number (fill gaps before)"),
        Err(_) => Err("a number"),
    }
}

/// The mean time step of a column of times; or the first row with a wrong time, and what was expected.
fn time_step(rows: &[Vec<f64>], column: usize) -> Result<f64, (usize, &'static str)> {
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
