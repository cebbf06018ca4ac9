//! A study as a versioned JSON document. No I/O.

use crate::perception::error::{MOST_BYTES, StudyError};
use crate::perception::read;
use crate::perception::study::Study;
use crate::perception::write::{content, document};
use vcgpdm_core::json::{NotFinite, Value, parse, write};

impl Study {
    /// Reads a document. Every field is checked.
    ///
    /// # Errors
    /// The text is not a study. The error names the path of the wrong field.
    pub fn from_json(text: &str) -> Result<Self, StudyError> {
        if text.len() > MOST_BYTES {
            return Err(StudyError::Size { found: text.len() });
        }
        read::study(&parse(text).map_err(StudyError::Json)?)
    }

    /// The study as a JSON document.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn to_json(&self) -> Result<String, StudyError> {
        text(&document(self))
    }

    /// SHA-256 of the figure and the movements with their models and scores, in lower-case hexadecimal; not
    /// of the design, the texts, the marks of failures and the errors on the training trials, which studies of
    /// earlier versions lack. Answers name the study by this hash.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn hash(&self) -> Result<String, StudyError> {
        Ok(vcgpdm_core::motion::sha256(text(&content(self))?.as_bytes()))
    }
}

fn text(value: &Value) -> Result<String, StudyError> {
    write(value).map_err(|NotFinite(number)| StudyError::NotFinite(number))
}
