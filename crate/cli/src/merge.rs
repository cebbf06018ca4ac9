//! `vcgpdm results`: commands for files of results.

use crate::files;
use crate::results::{Merged, Preferred, read};
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
/// A job that several files have is in the output once: with its outcome, if one of the files has an outcome.
/// Files with different numbers of the same job are refused, unless --prefer chooses one.
#[derive(clap::Args)]
struct Merge {
    /// Files that `evaluate` wrote.
    #[arg(value_name = "RESULTS.json", required = true)]
    results: Vec<PathBuf>,
    /// Which file counts where files hold different numbers of the same job.
    #[arg(long)]
    prefer: Option<Preferred>,
    /// Write all results to this file.
    #[arg(long, value_name = "RESULTS.json")]
    out: PathBuf,
}

pub fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let Command::Merge(merge) = &arguments.command;
    files::check_writable(&merge.out, merge.results.iter().map(PathBuf::as_path))?;
    let mut merged = Merged::new(&merge.results[0], read(&merge.results[0])?);
    for path in &merge.results[1..] {
        merged.add(path, read(path)?, merge.prefer)?;
    }
    let all = merged.results;
    files::write_text(&merge.out, &(all.to_json()? + "\n"))?;
    let jobs = all.finished().len();
    let failed = all.finished().iter().filter(|finished| finished.failure.is_some()).count();
    files::print_summary(&json!({ "jobs": jobs, "failed": failed }), &[Path::new(&merge.out)])
}
