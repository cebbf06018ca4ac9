//! Why Acclaim files cannot be read.

use thiserror::Error;

/// Why Acclaim files cannot be read, and where.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{file}, line {line}: expected {expected}, found {found}")]
pub struct AsfError {
    /// The name of the file.
    pub file: String,
    /// The line, counted from 1.
    pub line: usize,
    /// What was expected.
    pub expected: String,
    /// What was found.
    pub found: String,
}
