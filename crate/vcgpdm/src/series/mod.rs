//! Time series that are no body: tables of numbers from CSV, their columns, and which columns belong to which
//! part.
//!
//! [`read`] makes a [`Table`] of a file, one trial each; [`parts_from_words`] and [`parts_from_json`] say how
//! the columns are split. A [`Dataset`](crate::models::Dataset) of tables is trained on like one of clips.

mod columns;
mod csv;
mod error;
mod parts;
mod table;
#[cfg(test)]
mod tests;

pub use columns::Columns;
pub use csv::{read, write};
pub use error::SeriesError;
pub use parts::{check_parts, parts_from_json, parts_from_words, whole};
pub use table::Table;
