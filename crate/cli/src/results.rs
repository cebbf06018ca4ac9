//! `vcgpdm results`, and files of results: reading one, and putting several together.

use crate::files;
use serde_json::json;
use std::collections::HashMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm_lab::evaluation::{Difference, Job, Results};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Reads a file.
pub fn read(path: &Path) -> Result<Results> {
    Results::from_json(&files::read_text(path)?).map_err(|error| files::with_path(path, &error))
}

/// Which file counts where two files hold different numbers of the same job.
#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
pub enum Preferred {
    First,
    Last,
}

/// Results of several files of the same trials.
pub struct Merged {
    pub results: Results,
    /// The file of each outcome.
    sources: HashMap<Job, PathBuf>,
}

impl Merged {
    pub fn new(path: &Path, results: Results) -> Self {
        let mut merged = Self { results, sources: HashMap::new() };
        merged.sources.extend(outcomes(&merged.results, path));
        merged
    }

    /// Adds the results of another file.
    ///
    /// # Errors
    /// The results are of other trials, or hold other numbers of a job and no file is preferred.
    pub fn add(&mut self, path: &Path, mut results: Results, preferred: Option<Preferred>) -> Result<()> {
        if preferred.is_none()
            && let Some(found) = self.results.disagreement(&results)
        {
            let Difference { name, first, second } = found.difference;
            let source = self.sources.get(&found.job).map_or_else(String::new, |p| p.display().to_string());
            return Err(format!(
                "{source} and {}: expected the same numbers of the job {}, found {name} {first} and {second} \
                 (--prefer first, or last, chooses a file)",
                path.display(),
                found.job
            )
            .into());
        }
        let of_other: Vec<_> = outcomes(&results, path).collect();
        if preferred == Some(Preferred::Last) {
            std::mem::swap(&mut self.results, &mut results);
            self.sources.extend(of_other);
        } else {
            for (job, path) in of_other {
                self.sources.entry(job).or_insert(path);
            }
        }
        self.results.merge(results).map_err(|error| files::with_path(path, &error))
    }
}

/// The jobs with an outcome, each with the file.
fn outcomes(results: &Results, path: &Path) -> impl Iterator<Item = (Job, PathBuf)> {
    let finished = results.finished().iter().filter(|finished| finished.outcome.is_some());
    finished.map(|finished| (finished.job.clone(), path.to_owned()))
}

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

pub fn run(arguments: &Arguments) -> Result<()> {
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
