//! Trains a model on tables of numbers, saves it, reads it again and rolls it out:
//!
//! ```sh
//! cargo run --release --example own_data -- FOLDER
//! ```
//!
//! A table has rows at equal time steps, and columns that are divided into parts. Here the columns are those
//! of two simulated machines, of which the second follows the first with a delay. Tables are read from files
//! by `read_csv("trial.csv", &bytes)`. The same in a terminal: `vcgpdm train trial-1.csv trial-2.csv
//! --columns --parts "leader=a,b,c;follower=d,e" --out model.json`.

#![allow(clippy::disallowed_methods)]

use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm::nalgebra::DMatrix;
use vcgpdm::{
    Dataset, Document, Table, Trainer, VariationalSettings, column_parts, coupling_weight_matrix, write_csv,
};

fn main() -> Result<(), Box<dyn Error>> {
    run(&std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from))
}

/// Trains and writes FOLDER/own-data.json and FOLDER/predicted.csv.
pub fn run(folder: &Path) -> Result<(), Box<dyn Error>> {
    // Two recordings of 100 rows, a fiftieth of a second from row to row.
    let names = ["a", "b", "c", "d", "e"].map(str::to_owned);
    let recording = |number: usize| {
        let values = DMatrix::from_fn(100, 5, |row, column| measured(number, row, column));
        Table::new(&format!("recording {number}"), names.to_vec(), values, 0.02)
    };
    let recordings = [recording(0), recording(1)];

    // The columns of each part. A data set subtracts the mean of each column and divides by its standard
    // deviation.
    let parts = column_parts("leader=a,b,c;follower=d,e", &names)?;
    let dataset = Dataset::of_tables(&recordings, &parts, 50.0)?;

    // Two latent dimensions for each part; the last two states predict the next one (order 2).
    let settings = VariationalSettings {
        latent: 2,
        order: 2,
        dynamics_ips: 10,
        pose_ips: 10,
        max_iterations: 200,
        ..Default::default()
    };
    let mut trainer = Trainer::new(&dataset, &settings.into(), 1)?;
    trainer.run();
    let model = trainer.finish()?;
    // Parts that move in step can explain each other equally well. So the weights say what the model uses,
    // not which part is the cause.
    let coupled = model.coupled().ok_or("a vCGPDM has couplings")?;
    let weights = coupling_weight_matrix(coupled.alpha());
    for (i, part) in parts.iter().enumerate() {
        let (own, other) = (weights[(i, i)], weights[(i, 1 - i)]);
        println!(
            "{} drives {} with weight {other:.2}, itself with weight {own:.2}",
            part.name,
            parts[1 - i].name
        );
    }

    // The document has all that a rollout needs, and none of the recordings.
    let saved = folder.join("own-data.json");
    std::fs::write(&saved, model.to_json()?)?;
    let Document::Series(model) = Document::from_json(&std::fs::read_to_string(&saved)?)? else {
        return Err("expected a model of tables".into());
    };

    // The mean rollout from the start of the second recording, in the units of the recordings.
    let predicted = model.rollout(1, 100)?;
    let actual = &recordings[1].values;
    let error = (&predicted - actual).column_iter().map(|column| column.norm_squared()).sum::<f64>();
    let means = actual.row_mean();
    let spread: f64 = actual.row_iter().map(|row| (row - &means).norm_squared()).sum();
    println!("error of the rollout divided by the variance of the recording: {:.3}", error / spread);
    let path = folder.join("predicted.csv");
    std::fs::write(&path, write_csv(&names, &predicted, model.body.frame_time))?;
    println!("the model is in {}, the rollout in {}", saved.display(), path.display());
    Ok(())
}

/// The simulated measurements: an oscillation in the first part, which the second part follows.
fn measured(recording: usize, row: usize, column: usize) -> f64 {
    let phase = 0.25 * row as f64 + 1.5 * recording as f64;
    match column {
        0 => 10.0 + phase.sin(),
        1 => 2.0 * phase.cos(),
        2 => (phase + 0.5).sin().tanh(),
        3 => 5.0 + 0.8 * (phase - 0.7).sin(),
        _ => 0.5 * (2.0 * (phase - 0.7)).cos(),
    }
}
