//! The fields that tell which document a JSON text is, and of which version.

use serde::Deserialize;

/// The format and version of a document.
#[derive(Deserialize)]
pub(crate) struct DocumentHead {
    pub(crate) format: String,
    pub(crate) version: u32,
}

impl DocumentHead {
    /// Reads the head of a document, whose other fields may be of any kind.
    pub(crate) fn read(text: &str) -> Option<Self> {
        serde_json::from_str(text).ok()
    }
}
