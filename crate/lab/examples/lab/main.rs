//! The measurements behind the documents, as Markdown tables. `npm run lab -- NAME` writes them into docs or
//! prints them; this program prints them:
//!
//! ```sh
//! cargo run --release --package vcgpdm-lab --example lab -- --help
//! ```
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

mod clips;
mod effects;
mod models;
mod modularity;
mod objectives;
mod own_rollouts;
mod parallel;
mod ratio;
mod recognition;
mod scaling;
mod seeds;
mod splits;
mod synthetic;
mod uncertainty;

use clap::Parser;
use std::path::PathBuf;

#[derive(Parser)]
enum Measurement {
    /// How each coupling changes the body's movement.
    Effects(effects::Arguments),
    /// A combination of primitives that was never recorded, compared with other models.
    Combination,
    /// A library that shares its walking primitive, compared with a model of each movement.
    Modularity {
        /// Write the figure to this file.
        picture: Option<PathBuf>,
    },
    /// Primitives learned again under the pose maps of another library.
    Imports,
    /// Models with weighted pose terms, and uncoupled models, compared with plain ones.
    Objectives(clips::FolderTrainings),
    /// Models that learned from their own rollouts, compared with the same models before.
    OwnRollouts(own_rollouts::Arguments),
    /// Which movement of a library a clip shows.
    Recognition {
        /// Folders of clips (.bvh), one for each movement; absent: the project's own walks.
        folders: Vec<PathBuf>,
    },
    /// How time and memory grow with the size of the data and of the model.
    Scaling(scaling::Arguments),
    /// How many seeds lead to a model that keeps moving.
    Seeds(seeds::Arguments),
    /// When two parts predict better than one: walks whose upper bodies have another timing.
    Splits {
        /// Folders of clips (.bvh), one for each person.
        folders: Vec<PathBuf>,
    },
    /// Whether training finds the coupling of synthetic data.
    Synthetic(synthetic::Arguments),
    /// The spread of sampled rollouts, compared with the Gaussian approximation.
    Uncertainty,
}

fn main() {
    match Measurement::parse() {
        Measurement::Effects(arguments) => effects::run(&arguments),
        Measurement::Combination => modularity::run_combination(),
        Measurement::Modularity { picture } => modularity::run(picture.as_deref()),
        Measurement::Imports => modularity::run_imports(),
        Measurement::Objectives(arguments) => objectives::run(&arguments),
        Measurement::OwnRollouts(arguments) => own_rollouts::run(&arguments),
        Measurement::Recognition { folders } => recognition::run(&folders),
        Measurement::Scaling(arguments) => scaling::run(&arguments),
        Measurement::Seeds(arguments) => seeds::run(&arguments),
        Measurement::Splits { folders } => splits::run(&folders),
        Measurement::Synthetic(arguments) => synthetic::run(&arguments),
        Measurement::Uncertainty => uncertainty::run(),
    }
}
