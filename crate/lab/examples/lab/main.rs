//! What the project measures for its documents, as Markdown tables. `npm run lab -- NAME` writes them into
//! docs; this program prints them:
//!
//! ```sh
//! cargo run --release --package vcgpdm-lab --example lab -- --help
//! ```
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

#[path = "../shared/clips.rs"]
mod clips;
mod effects;
mod models;
mod modularity;
mod splits;
mod synthetic;
mod uncertainty;

use clap::Parser;
use std::path::PathBuf;

#[derive(Parser)]
enum Measurement {
    /// How each coupling changes the body's movement.
    Effects(effects::Arguments),
    /// A library that shares its walking primitive, beside a model of each movement.
    Modularity {
        /// Writes the figure to this file.
        picture: Option<PathBuf>,
    },
    /// Primitives learned again under the pose maps of another library.
    Imports,
    /// When two parts predict better than one body, as the parts keep their own time.
    Splits {
        /// Folders of clips (.bvh), one for each person.
        folders: Vec<PathBuf>,
    },
    /// Whether training finds a coupling that is known.
    Synthetic(synthetic::Arguments),
    /// The spread of sampled futures, beside that of the Gaussian approximation.
    Uncertainty,
}

fn main() {
    match Measurement::parse() {
        Measurement::Effects(arguments) => effects::run(&arguments),
        Measurement::Modularity { picture } => modularity::run(picture.as_deref()),
        Measurement::Imports => modularity::run_imports(),
        Measurement::Splits { folders } => splits::run(&folders),
        Measurement::Synthetic(arguments) => synthetic::run(&arguments),
        Measurement::Uncertainty => uncertainty::run(),
    }
}
