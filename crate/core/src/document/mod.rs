//! Models and libraries as versioned JSON documents. No I/O.
//!
//! A document has all that a rollout needs, and no training clip. That of a variational model has the
//! skeleton and pose mapping, column means, parts with their pose maps, the dynamics into each part,
//! couplings, the sums from which experts can be inferred again, start latents and provenance. A model of
//! tables has the names and units of columns instead of skeleton and pose mapping ([`Document`] reads both).
//! A model of another kind has its own fields under "model". A library has pose maps, primitives and
//! movements.

mod error;
mod library;
mod read;
mod settings;
mod subject;
mod write;

pub use error::{DocumentError, FORMAT, LIBRARY};
pub use settings::{read_settings, write_settings};

use crate::json::{NotFinite, Value};
use crate::models::library::TrainedLibrary;
use crate::models::{Coupled, Model, SeriesModel};
use error::MOST_BYTES;

impl Coupled<'_> {
    /// The model as a JSON document.
    ///
    /// # Errors
    ///
    /// [`DocumentError::NotFinite`] when the model has a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&write::variational(*self))
    }

    /// SHA-256 of that document in lower-case hexadecimal. Links and saved motions name a model by it.
    ///
    /// # Errors
    ///
    /// [`DocumentError::NotFinite`] when the model has a number that is not finite.
    pub fn sha256(&self) -> Result<String, DocumentError> {
        Ok(crate::motion::sha256(self.to_json()?.as_bytes()))
    }
}

impl SeriesModel {
    /// The model as a JSON document.
    ///
    /// # Errors
    ///
    /// [`DocumentError::NotFinite`] when the model has a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&write::document(self))
    }
}

/// A model read from a document.
#[derive(Clone, Debug)]
pub enum Document {
    /// A model of a body.
    Body(Box<Model>),
    /// A model of tables.
    Series(Box<SeriesModel>),
}

impl Document {
    /// Reads the document of a model of any kind, and checks that it is complete and consistent.
    ///
    /// # Errors
    ///
    /// A [`DocumentError`], with the path of the field that is wrong.
    pub fn from_json(text: &str) -> Result<Self, DocumentError> {
        let value = parsed(text)?;
        Ok(match read::has_columns(&value) {
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
    /// [`DocumentError::NotFinite`] when the model has a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&write::document(self))
    }

    /// Reads the document of a vCGPDM or vGPDM. A program that reads no other kind does not contain the code
    /// of the others.
    ///
    /// # Errors
    ///
    /// A [`DocumentError`], with the path of the field that is wrong.
    pub fn coupled_from_json(text: &str) -> Result<Self, DocumentError> {
        read::vcgpdm_document(&parsed(text)?)
    }

    /// Reads the document of a model of a body, of any kind, and checks that it is complete and consistent.
    ///
    /// # Errors
    ///
    /// A [`DocumentError`], with the path of the field that is wrong.
    pub fn from_json(text: &str) -> Result<Self, DocumentError> {
        read::document(&parsed(text)?)
    }
}

impl TrainedLibrary {
    /// The library as a JSON document.
    ///
    /// # Errors
    ///
    /// [`DocumentError::NotFinite`] when the model has a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&library::document(self))
    }

    /// Reads the document of a library, and checks that it is complete and consistent.
    ///
    /// # Errors
    ///
    /// A [`DocumentError`], with the path of the field that is wrong.
    pub fn from_json(text: &str) -> Result<Self, DocumentError> {
        read::library_document(&parsed(text)?)
    }
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
