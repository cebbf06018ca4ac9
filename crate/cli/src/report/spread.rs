//! Means with their standard errors in tables.

use vcgpdm_lab::evaluation::{Spread, fixed};

/// Mean and standard error.
pub fn spread(spread: &Spread, digits: usize) -> String {
    match spread.standard_error {
        Some(error) => format!("{} ± {}", fixed(spread.mean, digits), fixed(error, digits)),
        None => fixed(spread.mean, digits),
    }
}
