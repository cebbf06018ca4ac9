//! The measurements behind the documents, as Markdown tables. `npm run lab -- NAME` writes them into docs or
//! prints them; this program prints them:
//!
//! ```sh
//! cargo run --release --package vcgpdm-lab --example lab -- --help
//! ```
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

mod modularity;
mod parallel;
mod scaling;
mod seeds;
mod synthetic;

use clap::Parser;
use std::path::PathBuf;

#[derive(Parser)]
enum Measurement {
    /// A library that shares its walking primitive, compared with a model of each movement.
    Modularity {
        /// Write the figure to this file.
        picture: Option<PathBuf>,
    },
    /// How time and memory grow with the size of the data and of the model.
    Scaling(scaling::Arguments),
    /// How many seeds lead to a model that keeps moving.
    Seeds(seeds::Arguments),
    /// Whether training finds the coupling of synthetic data.
    Synthetic(synthetic::Arguments),
}

fn main() {
    match Measurement::parse() {
        Measurement::Modularity { picture } => modularity::run(picture.as_deref()),
        Measurement::Scaling(arguments) => scaling::run(&arguments),
        Measurement::Seeds(arguments) => seeds::run(&arguments),
        Measurement::Synthetic(arguments) => synthetic::run(&arguments),
    }
}
