//! BVH files: text to [`Recording`](crate::motion::Recording), and [`Clip`](crate::motion::Clip) to text. An
//! error names the file and the line.

mod error;
mod hierarchy;
mod motion;
mod parse;
#[cfg(test)]
mod tests;
mod text;
mod write;

pub use error::{BvhError, BvhProblem};
pub use parse::{read, read_at};
pub use write::write;
