//! The crate from outside, as the npm package and the terminal program call it. One program: it is linked
//! once.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::disallowed_methods)]

mod golden;
mod oscillators;
mod recordings;
