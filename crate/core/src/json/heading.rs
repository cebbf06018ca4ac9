//! The heading of a document of this project: its format and version.

use crate::json::field::{FieldError, Object};
use crate::json::value::Value;
use crate::json::value::write;
use std::ops::RangeInclusive;

/// Why a document does not have the expected format or version.
#[derive(Clone, Debug, PartialEq)]
pub enum HeadingError {
    /// Another format, or none.
    Format {
        /// The format found, at most 60 characters.
        found: String,
    },
    /// Written by a newer program.
    Newer {
        /// Its version.
        found: usize,
    },
    /// The version is missing or invalid.
    Field(FieldError),
}

impl From<FieldError> for HeadingError {
    fn from(error: FieldError) -> Self {
        Self::Field(error)
    }
}

/// Checks the fields "format" and "version" of a document.
///
/// # Errors
///
/// A [`HeadingError`] when the format differs, or the version is not in the range.
pub fn check_heading(
    document: &mut Object,
    format: &str,
    versions: RangeInclusive<usize>,
) -> Result<(), HeadingError> {
    match document.optional("format").map(|field| field.value().clone()) {
        Some(Value::Text(found)) if found == format => {}
        Some(other) => {
            let found = write(&other).unwrap_or_default().chars().take(60).collect();
            return Err(HeadingError::Format { found });
        }
        None => return Err(HeadingError::Format { found: "no format".to_owned() }),
    }
    let version = document.get("version")?;
    let (first, last) = versions.into_inner();
    match version.whole()? {
        found if found > last => Err(HeadingError::Newer { found }),
        found if found >= first => Ok(()),
        _ if first == last => Err(version.wrong(&first.to_string()).into()),
        _ => Err(version.wrong(&format!("from {first} to {last}")).into()),
    }
}
