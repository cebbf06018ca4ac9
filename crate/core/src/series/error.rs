//! Why a table, or a split of its columns, cannot be used.

use thiserror::Error;

/// Why a table, or a split of its columns, cannot be used.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SeriesError {
    /// A line of a file is wrong.
    #[error("{file}, line {line}: {problem}")]
    Line {
        /// The name of the file.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// What was expected and found.
        problem: String,
    },
    /// A number of a file is wrong.
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
        expected: String,
        /// The text found.
        found: String,
    },
    /// Tables with different columns or rates.
    #[error("{file} cannot be trained together with {first}: {problem}")]
    Differs {
        /// The table that differs.
        file: String,
        /// The table it was compared with.
        first: String,
        /// The difference.
        problem: String,
    },
    /// A table that does not come from a file is wrong, or columns cannot be left out.
    #[error("{table}: {problem}")]
    Table {
        /// The name of the table.
        table: String,
        /// What was expected and found.
        problem: String,
    },
    /// An invalid split of the columns into parts.
    #[error("{0}")]
    Parts(String),
    /// There is no table.
    #[error("expected at least one table to train on, found none")]
    Empty,
}

crate::coded!(SeriesError { Self::Parts(_) => Parts, _ => Table });
