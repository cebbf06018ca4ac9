//! How a document of this project begins: what it is, and in which version.

use crate::json::field::{FieldError, Object};
use crate::json::value::Value;
use crate::json::write::write;
use std::ops::RangeInclusive;

/// Why a document is not one of the asked form.
#[derive(Clone, Debug, PartialEq)]
pub enum HeadingError {
    /// It says that it is something else, or says nothing.
    Format {
        /// What it says, cut to 60 letters.
        found: String,
    },
    /// From a later program.
    Newer {
        /// The version that it names.
        found: usize,
    },
    /// The version is missing, or none that there ever was.
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
/// When the format is another one, or the version is not in the range.
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
