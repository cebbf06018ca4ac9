//! A study as a versioned JSON document. No I/O.

use crate::perception::error::{MOST_BYTES, StudyError};
use crate::perception::read;
use crate::perception::study::Study;
use crate::perception::write::{document, shown};
use vcgpdm::internals::json::{NotFinite, Value, parse, write};

impl Study {
    /// Reads a document; nothing but a whole and consistent study is accepted.
    ///
    /// # Errors
    /// The text is not such a document, with the path of the field that is wrong.
    pub fn from_json(text: &str) -> Result<Self, StudyError> {
        if text.len() > MOST_BYTES {
            return Err(StudyError::Size { found: text.len() });
        }
        read::study(&parse(text).map_err(StudyError::Json)?)
    }

    /// The study as a JSON document.
    ///
    /// # Errors
    /// It holds a number that is not finite.
    pub fn to_json(&self) -> Result<String, StudyError> {
        text(&document(self))
    }

    /// SHA-256 of what is shown, in lower-case hexadecimal: of the figure and the movements, their models and
    /// scores, not of the design, the texts and the marks of failures. Answers name the study by it.
    ///
    /// # Errors
    /// It holds a number that is not finite.
    pub fn hash(&self) -> Result<String, StudyError> {
        Ok(vcgpdm::internals::sha256(text(&shown(self))?.as_bytes()))
    }
}

fn text(value: &Value) -> Result<String, StudyError> {
    write(value).map_err(|NotFinite(number)| StudyError::NotFinite(number))
}
