//! Finds the column of a table that holds its times, and the columns that count its rows.

/// Largest deviation of a time step from the mean step, as a fraction of the mean step.
const UNEVEN: f64 = 0.05;
/// Times may be rounded to a unit of at most this fraction of the step, such as whole milliseconds.
const COARSEST: f64 = 0.25;
/// Seconds from row to row.
pub(super) const STEPS: std::ops::RangeInclusive<f64> = 1e-5..=10.0;
/// Seconds of a row outside which the unit of the times is doubtful.
const USUAL: std::ops::Range<f64> = 1e-4..1.0;
/// A column whose steps differ by at most this fraction is a clock or a counter, whatever its name.
const STEADY: f64 = 0.01;
/// Fewer rows can grow steadily by chance.
const FEWEST_ROWS: usize = 10;

const TIMES: [&str; 12] = [
    "time",
    "times",
    "t",
    "timestamp",
    "timestamps",
    "stamp",
    "elapsed",
    "clock",
    "epoch",
    "uptime",
    "zeit",
    "zeitstempel",
];
/// Words beside those of [`TIMES`] that leave a name the name of a clock.
const BESIDE: [&str; 15] = [
    "unix", "utc", "ros", "system", "sim", "video", "frame", "sample", "sensor", "device", "since", "start",
    "in", "header", "field",
];
/// Words for units, and their seconds.
const UNITS: [(&[&str], f64); 4] = [
    (&["s", "sec", "secs", "second", "seconds", "sekunden"], 1.0),
    (&["ms", "msec", "msecs", "millis", "millisecond", "milliseconds", "millisekunden"], 1e-3),
    (&["us", "µs", "μs", "usec", "micros", "microsecond", "microseconds"], 1e-6),
    (&["ns", "nsec", "nsecs", "nanos", "nanosecond", "nanoseconds"], 1e-9),
];
const COUNTERS: [&str; 9] =
    ["frame", "frames", "index", "idx", "row", "rows", "sample", "samples", "unnamed"];
/// Words beside those of [`COUNTERS`] that leave a name the name of a counter.
const BESIDE_COUNTERS: [&str; 8] = ["number", "no", "nr", "num", "id", "count", "counter", "0"];

/// What the columns say about the times of the rows.
pub(super) struct Timing {
    /// Seconds from row to row; `None` without a column of times.
    pub(super) frame_time: Option<f64>,
    /// The columns that are neither times nor counters.
    pub(super) used: Vec<usize>,
    pub(super) warnings: Vec<String>,
}

/// A time that is wrong.
pub(super) struct WrongTime {
    pub(super) row: usize,
    pub(super) column: usize,
    pub(super) expected: String,
}

/// Whether a column of this name may hold times, so that its numbers may be large.
pub(super) fn is_clock(name: &str) -> bool {
    unit(name).is_some()
}

/// The timing of rows [rows x columns], which are on these lines of the file.
pub(super) fn timing(names: &[String], rows: &[Vec<f64>], lines: &[usize]) -> Result<Timing, WrongTime> {
    let steps = |column: usize| rows.windows(2).map(move |pair| pair[1][column] - pair[0][column]);
    let grows = |column: &usize| steps(*column).all(|step| step > 0.0);
    let all = || 0..names.len();
    let clock = all().find(|column| is_clock(&names[*column]) && grows(column));
    // These names have always meant times: a column of them that falls is a fault.
    let clock = clock.or_else(|| all().find(|k| is_plain(&names[*k], &["time", "t", "seconds"])));
    let mut warnings = Vec::new();
    let frame_time = match clock {
        None => None,
        Some(column) => Some(time_step(&names[column], rows, column, &mut warnings)?),
    };
    let is_whole = |column: usize| rows.iter().all(|row| row[column].fract() == 0.0);
    // The index that pandas writes is first and has no name.
    let may_count = |column: usize| {
        let words = words(&names[column]);
        is_counter(&words) || words.is_empty() && column == 0
    };
    let counts = |column: &usize| {
        let is_frame = is_plain(&names[*column], &["frame"]);
        is_frame || may_count(*column) && is_whole(*column) && grows(column)
    };
    let (mut used, mut counter) = (Vec::new(), None);
    for column in all().filter(|column| Some(*column) != clock) {
        let name = &names[column];
        let first = steps(column).next().unwrap_or_default();
        if counts(&column) {
            counter = counter.or(Some(name)).filter(|name| !name.is_empty());
            if let Some(at) = steps(column).position(|step| step != first) {
                let (before, after) = (rows[at][column], rows[at + 1][column]);
                warnings.push(format!(
                    "line {}: the column {name:?} goes from {before} to {after}, not to {}: rows are missing there, \
                     or another trial begins",
                    lines[at + 1],
                    before + first
                ));
            }
            continue;
        }
        if clock.is_none() && is_clock(name) {
            warnings.push(format!(
                "the column {name:?} has the name of a clock, but does not grow from row to row, so it is taken for \
                 data: state the rate (--fps; 30 rows a second without it), or join seconds and their fraction to \
                 one column"
            ));
        }
        let is_steady = |step: f64| (step - first).abs() <= STEADY * first;
        if rows.len() >= FEWEST_ROWS && first > 0.0 && steps(column).all(is_steady) {
            warnings.push(format!(
                "the column {name:?} grows by {} in each row, as a clock or a counter does, but is taken for \
                 data: name it time_s, time_ms or frame, or leave it out",
                rounded(first)
            ));
        }
        used.push(column);
    }
    if let (Some(name), None) = (counter, clock) {
        warnings.push(format!(
            "the column {name:?} counts rows, but no column holds times: the rate is the one that you state (--fps; \
             30 rows a second without it)"
        ));
    }
    Ok(Timing { frame_time, used, warnings })
}

/// The mean time step of a column of times.
fn time_step(
    name: &str,
    rows: &[Vec<f64>],
    column: usize,
    warnings: &mut Vec<String>,
) -> Result<f64, WrongTime> {
    let times: Vec<f64> = rows.iter().map(|row| row[column]).collect();
    let (first, last) = (times[0], times[times.len() - 1]);
    let stated = unit(name).flatten();
    // Times since 1970 tell their unit by their size.
    let seconds = stated.unwrap_or(match last.abs() {
        time if time >= 1e17 => 1e-9,
        time if time >= 1e14 => 1e-6,
        time if time >= 1e11 => 1e-3,
        _ => 1.0,
    });
    let wrong = |row, expected: &str| Err(WrongTime { row, column, expected: expected.to_owned() });
    let mean = (last - first) / (times.len() - 1) as f64;
    let step = mean * seconds;
    if !STEPS.contains(&step) {
        return wrong(
            times.len() - 1,
            &format!(
                "seconds that grow by 0.00001 to 10 a row, not by {} (for other units, name the column \
                 time_ms, time_us or time_ns; for numbers of frames, frame)",
                rounded(step)
            ),
        );
    }
    let is_multiple = |digit: f64| times.iter().all(|t| (t / digit - (t / digit).round()).abs() < 1e-6);
    let rounding = [1.0, 0.1, 0.01, 0.001].into_iter().find(|digit| is_multiple(*digit));
    let rounding = rounding.filter(|digit| *digit <= COARSEST * mean).unwrap_or(0.0);
    let allowed = rounding.max(UNEVEN * mean);
    let steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    if steps.iter().any(|step| (step - mean).abs() > allowed) {
        // A gap changes the mean step; the median tells where the gap is.
        let mut sorted = steps.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        let beside = |step: &f64| (step - sorted[sorted.len() / 2]).abs();
        let row = steps.iter().enumerate().max_by(|a, b| beside(a.1).total_cmp(&beside(b.1)));
        return wrong(
            row.map_or(0, |(at, _)| at + 1),
            "seconds that grow by as much from row to row (resample before)",
        );
    }
    let unit = match seconds {
        1.0 => "seconds",
        1e-3 => "milliseconds",
        1e-6 => "microseconds",
        _ => "nanoseconds",
    };
    if !USUAL.contains(&step) && (stated.is_none() || step < USUAL.start) {
        warnings.push(format!(
            "the column {name:?} is taken for {unit}, so a row lasts {} s: name the column after what it holds, \
             time_s for seconds, time_ms for milliseconds, time_us for microseconds, or frame if it counts rows",
            rounded(step)
        ));
    }
    Ok(step)
}

/// For messages.
fn rounded(number: f64) -> f64 {
    (number * 1e6).round() / 1e6
}

/// Whether a name is one of these, in any case.
fn is_plain(name: &str, plain: &[&str]) -> bool {
    plain.iter().any(|plain| name.eq_ignore_ascii_case(plain))
}

/// The seconds of the unit in the name of a clock, such as "Time (ms)"; `Some(None)` for a clock without a
/// unit, `None` for another column.
fn unit(name: &str) -> Option<Option<f64>> {
    let words = words(name);
    let unit_of =
        |word: &str| UNITS.iter().find(|(names, _)| names.contains(&word)).map(|(_, seconds)| *seconds);
    let units: Vec<f64> = words.iter().filter_map(|word| unit_of(word)).collect();
    let is_time = |word: &String| TIMES.contains(&word.as_str());
    let fits = |word: &String| is_time(word) || unit_of(word).is_some() || BESIDE.contains(&word.as_str());
    // "s" alone may be any quantity.
    let named =
        words.iter().any(is_time) || words.iter().any(|word| word.len() > 1 && unit_of(word).is_some());
    (named && units.len() < 2 && words.iter().all(fits)).then(|| units.first().copied())
}

/// Whether a column with these words in its name counts rows if its numbers do.
fn is_counter(words: &[String]) -> bool {
    let counts = |word: &String| COUNTERS.contains(&word.as_str());
    let fits = |word: &String| counts(word) || BESIDE_COUNTERS.contains(&word.as_str());
    words.iter().any(counts) && words.iter().all(fits)
}

/// The words of a name in lower case: "frameNumber", "frame_number" and "Frame (number)" have the same.
fn words(name: &str) -> Vec<String> {
    let mut spaced = String::new();
    let mut before_is_small = false;
    for c in name.chars() {
        if c.is_uppercase() && before_is_small {
            spaced.push(' ');
        }
        before_is_small = c.is_lowercase();
        spaced.extend(c.to_lowercase());
    }
    let words = spaced.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_owned).collect()
}
