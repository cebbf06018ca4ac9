//! `vcgpdm bound`: the bound of a golden case, and the other numbers that a case checks.

use crate::files;
use crate::numbers::whole;
use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm_lab::evaluation::stats::median;
use vcgpdm_lab::golden::Case;

/// Print the bound of a case, its terms, gradient, posteriors and rollouts as one JSON object.
#[derive(clap::Args)]
pub struct Arguments {
    /// Data and parameters, as JSON with an "input".
    #[arg(value_name = "CASE.json")]
    case: PathBuf,
    /// Compute the bound with its gradient N times and add the median time, in milliseconds.
    #[arg(long, value_name = "N", value_parser = whole(1..=u32::MAX))]
    repeat: Option<u32>,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let text = files::read_text(&arguments.case)?;
    let named = |error| files::with_path(&arguments.case, &error);
    let case = Case::from_json(&text).map_err(named)?;
    let mut result = case.evaluate().map_err(named)?;
    if let Some(repeat) = arguments.repeat {
        let mut workspace = case.objective.workspace(&case.params);
        let mut times = Vec::new();
        for _ in 0..repeat {
            let begin = Instant::now();
            case.objective.compute_with_gradient(std::hint::black_box(&case.params), &mut workspace)?;
            times.push(1e3 * begin.elapsed().as_secs_f64());
        }
        result.median_ms = Some(median(&times));
    }
    files::print_json(&result)
}
