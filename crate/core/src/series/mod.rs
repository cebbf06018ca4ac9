//! Time series other than motions of a body: tables of numbers from CSV, and the parts of their columns.
//!
//! [`read`] reads a [`Table`] from a file. [`parse_parts`] and [`parts_from_json`] split its columns
//! into parts. A model is trained on a [`Dataset`](crate::models::Dataset) of tables as on one of clips.

mod clock;
mod csv;
mod error;
mod parts;
pub mod records;
mod table;
#[cfg(test)]
mod tests;

pub use csv::{read, write};
pub use error::SeriesError;
pub use parts::Columns;
pub use parts::{check_parts, parse_parts, parts_from_json, whole};
pub use table::Table;
