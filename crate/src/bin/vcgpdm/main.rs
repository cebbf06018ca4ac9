//! The `vcgpdm` program: the library from a terminal.
//!
//! Results go to stdout as one JSON object, progress to stderr. The exit status is 0, or 1 with one line on stderr that
//! says what was wrong and where.

mod bound;
mod clip;
mod evaluate;
mod files;
mod interrupt;
mod report;
mod results;
mod rollout;
mod score;
mod train;

use clap::error::ErrorKind;
use clap::{Parser, Subcommand};
use std::error::Error;
use std::io::Write;
use std::process::ExitCode;

/// Coupled Gaussian process movement primitives: train them on motion capture and roll them out.
#[derive(Parser)]
#[command(
    name = "vcgpdm",
    version,
    after_help = "A CLIP is a BVH file, or sample:ID for a clip that the program makes itself \
(sample:walk-1 to sample:walk-6, sample:walk-wave-1 to sample:walk-wave-4)."
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Bound(bound::Arguments),
    Clip(clip::Arguments),
    Train(train::Arguments),
    Rollout(rollout::Arguments),
    Score(score::Arguments),
    Evaluate(evaluate::Arguments),
    Report(report::Arguments),
}

fn main() -> ExitCode {
    let result = match Arguments::try_parse() {
        Ok(arguments) => run(arguments.command),
        // Asked for, so no error.
        Err(help) if matches!(help.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {
            files::print(&help.render().to_string())
        }
        Err(error) => Err(usage(&error).into()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let message: Vec<String> = error.to_string().split_whitespace().map(str::to_owned).collect();
            // Nobody is left to tell when stderr is closed.
            let _ = writeln!(std::io::stderr(), "vcgpdm: {}", message.join(" "));
            ExitCode::FAILURE
        }
    }
}

fn run(command: Command) -> Result<(), Box<dyn Error>> {
    match command {
        Command::Bound(arguments) => bound::run(&arguments),
        Command::Clip(arguments) => clip::run(&arguments),
        Command::Train(arguments) => train::run(&arguments),
        Command::Rollout(arguments) => rollout::run(&arguments),
        Command::Score(arguments) => score::run(&arguments),
        Command::Evaluate(arguments) => evaluate::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
    }
}

/// What was wrong with the command line, without the help that clap adds in further paragraphs.
fn usage(error: &clap::Error) -> String {
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return "expected one of the commands bound, clip, train, rollout, score, evaluate and report (try --help)".to_owned();
    }
    let text = error.render().to_string();
    let first = text.split("\n\n").next().unwrap_or_default();
    format!("{} (try --help)", first.trim_start_matches("error: "))
}
