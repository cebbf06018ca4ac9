//! A small JSON library: a tree of values whose numbers are read and written to the same bits, and a cursor
//! over the tree that knows the path of its field. In the wasm it is much smaller than a general library.

pub mod checks;
mod field;
mod heading;
mod parse;
pub mod rows;
mod value;

pub use field::{Field, FieldError, Object, place};
pub use heading::{HeadingError, check_heading};
pub use parse::{JsonError, outline, parse};
pub use value::Value;
pub use value::{NotFinite, write};

#[cfg(test)]
mod tests;
