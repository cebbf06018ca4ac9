//! Numbers of the command line. Every error about a number states its range.

use crate::usage::usage;
use std::error::Error;
use std::fmt::Display;
use std::num::{IntErrorKind, ParseIntError};
use std::ops::{Bound, RangeBounds, RangeInclusive};
use std::str::FromStr;
use vcgpdm_core::motion::Clip;

/// Reads a whole number of a range that has a lowest number and includes its ends.
pub fn whole<T>(
    range: impl RangeBounds<T> + Clone + Send + Sync + 'static,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static
where
    T: FromStr<Err = ParseIntError> + PartialOrd + Display,
{
    move |text| match text.trim().parse::<T>() {
        Ok(number) if range.contains(&number) => Ok(number),
        found => Err(match (range.start_bound(), range.end_bound(), found) {
            (Bound::Included(lowest), Bound::Included(highest), _) => {
                format!("expected a whole number from {lowest} to {highest}")
            }
            (_, _, Err(reason)) if *reason.kind() == IntErrorKind::PosOverflow => {
                "expected a smaller number".to_owned()
            }
            (Bound::Included(lowest), ..) => format!("expected a whole number from {lowest}"),
            _ => "expected a whole number".to_owned(),
        }),
    }
}

/// Refuses a value of the option outside its range. `unit` is what is counted, such as seconds.
pub fn check_within(
    option: &str,
    unit: &str,
    range: RangeInclusive<f64>,
    found: f64,
) -> Result<(), Box<dyn Error>> {
    if range.contains(&found) {
        return Ok(());
    }
    let (lowest, highest) = range.into_inner();
    let found = short(found);
    Err(usage(format!("{option}: expected {unit} from {lowest} to {highest}, found {found}")))
}

/// A number for a message, never with hundreds of digits.
fn short(number: f64) -> String {
    let is_usual = number == 0.0 || !number.is_finite() || (1e-6..1e15).contains(&number.abs());
    if is_usual { number.to_string() } else { format!("{number:e}") }
}

/// Refuses a value of `--fps` to which no clip can be resampled.
pub fn check_fps(found: f64) -> Result<(), Box<dyn Error>> {
    check_within("--fps", "frames a second", Clip::RATES, found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_messages_are_short() {
        let texts = [0.0, -1.5, 30.0, 1e-300, -1e300, f64::NAN].map(short);
        assert_eq!(texts, ["0", "-1.5", "30", "1e-300", "-1e300", "NaN"]);
    }

    #[test]
    fn states_the_range_in_every_error() {
        for wrong in ["0", "101", "-1", "1.5", "many", "", "99999999999999999999"] {
            assert_eq!(
                whole(1..=100_usize)(wrong),
                Err("expected a whole number from 1 to 100".to_owned()),
                "{wrong}"
            );
        }
        assert_eq!(whole(1..=100_usize)("100"), Ok(100));
        assert_eq!(whole(3_u32..)("2"), Err("expected a whole number from 3".to_owned()));
        assert_eq!(whole(3_u32..)("4294967296"), Err("expected a smaller number".to_owned()));
    }
}
