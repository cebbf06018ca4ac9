//! Why a table, or a split of its columns, cannot be used.

use thiserror::Error;

/// Why a table, or a split of its columns, cannot be used.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SeriesError {
    /// The text of a file.
    #[error("{file}, line {line}: {problem}")]
    Line {
        /// The name of the file.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// What was expected and found.
        problem: String,
    },
    /// A number of a file.
    #[error("{file}, line {line}, column {column} ({name}): expected {expected}, found {found:?}")]
    Number {
        /// The name of the file.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The column, counted from 1.
        column: usize,
        /// Its name.
        name: String,
        /// What was expected.
        expected: &'static str,
        /// What stands there.
        found: String,
    },
    /// Tables that do not go together.
    #[error("{file} cannot be trained together with {first}: {problem}")]
    Differs {
        /// The table that differs.
        file: String,
        /// The one it was compared with.
        first: String,
        /// How.
        problem: String,
    },
    /// A split of the columns.
    #[error("{0}")]
    Parts(String),
    /// No table at all.
    #[error("expected at least one table to train on, found none")]
    Empty,
}
