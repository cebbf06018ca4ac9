//! JSON, small: a tree of values that is read and written so that every number comes back bit by bit, and a
//! cursor over the tree that knows the path of the field it stands on. In the wasm it takes a fraction of the
//! space of a general library.

pub mod checks;
mod field;
mod heading;
mod parse;
pub mod rows;
mod value;
mod write;

pub use field::{Field, FieldError, Object, place};
pub use heading::{HeadingError, check_heading};
pub use parse::{JsonError, outline, parse};
pub use value::Value;
pub use write::{NotFinite, write};

#[cfg(test)]
mod tests;
