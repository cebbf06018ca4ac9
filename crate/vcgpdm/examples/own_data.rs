//! Trains a model on a plain matrix of numbers, without a body and without BVH:
//!
//! ```sh
//! cargo run --example own_data -- FOLDER
//! ```
//!
//! What the model needs: rows that follow each other in time, columns that are divided into parts, and columns whose mean
//! is zero. Here two made-up machines are measured; the second follows the first a little later.

#![allow(clippy::disallowed_methods)]

use nalgebra::DMatrix;
use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm::models::variational::Trainer;
use vcgpdm::models::{VariationalSettings, coupling_weight_matrix};

fn main() -> Result<(), Box<dyn Error>> {
    run(&std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from))
}

/// Trains and writes FOLDER/predicted.csv.
pub fn run(folder: &Path) -> Result<(), Box<dyn Error>> {
    // Two recordings of 100 rows, one below the other: [200 x 5]. Read yours from a file of numbers.
    let lengths = vec![100, 100];
    let data = DMatrix::from_fn(200, 5, |row, column| measured(row / 100, row % 100, column));

    // Columns 0 to 2 are the first part, columns 3 and 4 the second; each column without its mean.
    let means = data.row_mean();
    let mut centred = data.clone();
    for (mut column, mean) in centred.column_iter_mut().zip(means.iter()) {
        column.add_scalar_mut(-mean);
    }
    let y = vec![centred.columns(0, 3).into_owned(), centred.columns(3, 2).into_owned()];

    // Two latent dimensions for each part; the last two states predict the next one (order 2).
    let settings =
        VariationalSettings { latent: 2, order: 2, dynamics_ips: 10, pose_ips: 10, max_iterations: 200 };
    let mut trainer = Trainer::new(y, lengths, &settings, 1)?;
    while !trainer.step().done {}
    let model = trainer.model()?;
    // Two parts in step can explain each other equally well, so such weights say what the model uses, not what the cause is.
    let weights = coupling_weight_matrix(&model.alpha);
    println!(
        "part 1 drives part 2 with weight {:.2}, itself with weight {:.2}",
        weights[(0, 1)],
        weights[(0, 0)]
    );
    println!(
        "part 2 drives part 1 with weight {:.2}, itself with weight {:.2}",
        weights[(1, 0)],
        weights[(1, 1)]
    );

    // The mean rollout from the start of the second recording: centred columns of each part, to which the means belong.
    let parts = model.rollout(1, 100)?;
    let predicted = DMatrix::from_fn(100, 5, |row, column| {
        means[column] + if column < 3 { parts[0][(row, column)] } else { parts[1][(row, column - 3)] }
    });
    let error = (&predicted - data.rows(100, 100)).norm_squared() / centred.rows(100, 100).norm_squared();
    println!("error of the rollout, as a share of the variance of the recording: {error:.3}");

    let mut csv = String::from("a,b,c,d,e\n");
    for row in predicted.row_iter() {
        let numbers: Vec<String> = row.iter().map(|value| format!("{value:.4}")).collect();
        csv += &(numbers.join(",") + "\n");
    }
    let path = folder.join("predicted.csv");
    std::fs::write(&path, csv)?;
    println!("the rollout is in {}", path.display());
    Ok(())
}

/// What would be measured: an oscillation in the first part, and in the second what follows it.
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
