//! The shared model as a versioned JSON document. No I/O.
//!
//! It holds what a rollout needs and no training clip: skeleton and pose mapping, column means, parts with
//! their pose maps, the dynamics into each part, couplings, the sums from which experts can be inferred
//! again, start latents and provenance. A document of tables has the names and units of their columns in the
//! place of skeleton and pose mapping ([`Document`] reads both). A document of another kind holds the same
//! about the body, and under "model" what that kind needs to roll out; that of a library holds pose maps,
//! primitives and movements.

mod error;
mod library;
mod read;
mod subject;
mod write;

pub use error::{DocumentError, FORMAT, LIBRARY};

use crate::json::{Field, FieldError, NotFinite, Value};
use crate::models::library::TrainedLibrary;
use crate::models::{Coupled, Model, ModelKind, SeriesModel, Settings};
use error::MOST_BYTES;

impl Coupled<'_> {
    /// The model as a JSON document.
    ///
    /// # Errors
    ///
    /// When it holds a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&write::variational(*self))
    }

    /// SHA-256 of that document, in lower-case hexadecimal: links and saved motions name a model by it.
    ///
    /// # Errors
    ///
    /// When it holds a number that is not finite.
    pub fn sha256(&self) -> Result<String, DocumentError> {
        Ok(crate::motion::sha256(self.to_json()?.as_bytes()))
    }
}

impl SeriesModel {
    /// The model as a JSON document.
    ///
    /// # Errors
    ///
    /// When it holds a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&write::document(self))
    }
}

/// A document of any kind, of a body or of tables.
#[derive(Clone, Debug)]
pub enum Document {
    /// A model of a body.
    Body(Box<Model>),
    /// A model of tables.
    Series(Box<SeriesModel>),
}

impl Document {
    /// Reads a document of any kind; nothing but a whole and consistent model is accepted.
    ///
    /// # Errors
    ///
    /// When the text is not such a document, with the path of the field that is wrong.
    pub fn from_json(text: &str) -> Result<Self, DocumentError> {
        let value = parsed(text)?;
        Ok(match read::is_of_columns(&value) {
            true => Document::Series(Box::new(read::document(&value)?)),
            false => Document::Body(Box::new(read::document(&value)?)),
        })
    }
}

impl Model {
    /// The model as a JSON document.
    ///
    /// # Errors
    ///
    /// When it holds a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&write::document(self))
    }

    /// Reads the document of a vCGPDM or vGPDM. A program that reads no other kind need not hold their code.
    ///
    /// # Errors
    ///
    /// When the text is not such a document, with the path of the field that is wrong.
    pub fn coupled_from_json(text: &str) -> Result<Self, DocumentError> {
        read::vcgpdm_document(&parsed(text)?)
    }

    /// Reads a document of any kind of model of a body; nothing but a whole and consistent model is accepted.
    ///
    /// # Errors
    ///
    /// When the text is not such a document, with the path of the field that is wrong.
    pub fn from_json(text: &str) -> Result<Self, DocumentError> {
        read::document(&parsed(text)?)
    }
}

impl TrainedLibrary {
    /// The library as a JSON document.
    ///
    /// # Errors
    ///
    /// When it holds a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&library::document(self))
    }

    /// Reads the document of a library; nothing but a whole and consistent one is accepted.
    ///
    /// # Errors
    ///
    /// When the text is not such a document, with the path of the field that is wrong.
    pub fn from_json(text: &str) -> Result<Self, DocumentError> {
        read::library_document(&parsed(text)?)
    }
}

/// Names and values of what a training was asked for, as documents hold them.
pub fn settings_value(settings: &Settings, seed: u32) -> Value {
    write::settings(settings, seed)
}

/// The same, read again: settings of that kind of model, and the seed.
pub fn settings_of(field: Field, kind: ModelKind) -> Result<(Settings, u32), FieldError> {
    read::settings(field, kind)
}

fn parsed(text: &str) -> Result<Value, DocumentError> {
    if text.len() > MOST_BYTES {
        return Err(DocumentError::Size { found: text.len() });
    }
    crate::json::parse(text).map_err(DocumentError::Json)
}

fn text(document: &Value) -> Result<String, DocumentError> {
    crate::json::write(document).map_err(|NotFinite(v)| DocumentError::NotFinite(v))
}

#[cfg(test)]
mod tests;
