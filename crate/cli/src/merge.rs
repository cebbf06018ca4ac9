//! `vcgpdm results`: what can be done with files of results themselves.

use crate::{files, results};
use serde_json::json;
use std::error::Error;
use std::path::{Path, PathBuf};

/// Put files of results together.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    Merge(Merge),
}

/// Put results of the same trials together into one file.
///
/// A job that several files have stands there once: with its outcome, where one of them has it.
#[derive(clap::Args)]
struct Merge {
    /// Files that `evaluate` wrote.
    #[arg(value_name = "RESULTS.json", required = true)]
    results: Vec<PathBuf>,
    /// Write all results to this file.
    #[arg(long, value_name = "RESULTS.json")]
    out: PathBuf,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let Command::Merge(merge) = &arguments.command;
    files::check_writable(&merge.out, merge.results.iter().map(PathBuf::as_path))?;
    let mut all = results::read(&merge.results[0])?;
    for path in &merge.results[1..] {
        all.merge(results::read(path)?).map_err(|error| files::about(path, &error))?;
    }
    files::write_text(&merge.out, &(all.to_json()? + "\n"))?;
    let jobs = all.finished().len();
    let failed = all.finished().iter().filter(|finished| finished.failure.is_some()).count();
    files::print_summary(&json!({ "jobs": jobs, "failed": failed }), &[Path::new(&merge.out)])
}
