//! The terminal program from outside. One program: it is linked once.
#![allow(clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

mod call;
mod clips;
mod columns;
mod commands;
mod complete;
mod evaluate;
mod files;
mod library;
mod models;
mod moving;
mod perception;
mod recordings;
mod reproduce;
mod rollout;
mod streams;
