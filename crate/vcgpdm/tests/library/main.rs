//! Tests of the library from outside. They are one program, which is linked once.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::disallowed_methods)]

mod acclaim;
mod combinations;
mod documents;
mod live;
mod recognition;
mod recordings;
mod series;
#[path = "../shared/start_model.rs"]
mod start_model;
mod t_pose;
mod training;
mod unchanged;
