//! The `vcgpdm` program: the library from a terminal.
//!
//! Results go to stdout as one JSON object, progress to stderr. The exit status is 0 for success, 2 for a
//! usage error and 1 for any other failure. After a failure, one line on stderr says what was wrong and
//! where.

mod bound;
mod clip;
mod clips;
mod complete;
mod couple;
mod evaluate;
mod files;
mod health;
mod library;
mod numbers;
mod perception;
mod primitives;
mod recognise;
mod report;
mod reproduce;
mod results;
mod rollout;
mod score;
mod shell;
mod store;
mod study;
mod task;
mod train;
mod usage;

use clap::error::ErrorKind;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::error::Error;
use std::io::Write;
use std::num::ParseFloatError;
use std::process::ExitCode;
use usage::Usage;

/// Coupled Gaussian process movement primitives: train them on motion capture and roll them out.
#[derive(Parser)]
#[command(
    name = "vcgpdm",
    version,
    after_help = "A CLIP is a BVH file, or sample:ID for a clip that the program makes itself \
(sample:walk-1 to sample:walk-6, sample:walk-wave-1 to sample:walk-wave-4, \
sample:stand-wave-1 to sample:stand-wave-4, sample:bottle-1 to sample:bottle-10). \
A file called - is stdin or stdout. If a file is stdout, the summary goes to stderr. Exit status: 0 for success, 2 for a usage error, 1 for any other failure."
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
    Complete(complete::Arguments),
    Couple(couple::Arguments),
    Primitives(primitives::Arguments),
    Recognise(recognise::Arguments),
    Reproduce(reproduce::Arguments),
    Rollout(rollout::Arguments),
    Score(score::Arguments),
    Evaluate(evaluate::Arguments),
    Report(report::Arguments),
    Study(study::Arguments),
    Perception(perception::Arguments),
    Results(results::Arguments),
    Completions(shell::Completions),
    Man(shell::Man),
}

fn main() -> ExitCode {
    let result = match parse() {
        Ok(arguments) => run(arguments.command),
        // The user asked for this text, so it is no error.
        Err(help) if matches!(help.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {
            files::print(&help.render().to_string())
        }
        Err(error) => Err(Box::new(Usage(usage_message(&error))) as Box<dyn Error>),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let message: Vec<String> = error.to_string().split_whitespace().map(str::to_owned).collect();
            // An error on stderr cannot be reported anywhere.
            let _ = writeln!(std::io::stderr(), "vcgpdm: {}", files::escape(&message.join(" ")));
            if error.is::<Usage>() { ExitCode::from(2) } else { ExitCode::FAILURE }
        }
    }
}

/// The command line. Every option takes negative numbers as values, so that the error message is about the
/// number. Otherwise clap would report an unexpected argument.
fn command_line() -> clap::Command {
    Arguments::command().mut_subcommands(|command| {
        command.mut_args(|argument| {
            let takes = argument.get_action().takes_values() && !argument.is_positional();
            if takes { argument.allow_negative_numbers(true) } else { argument }
        })
    })
}

fn parse() -> Result<Arguments, clap::Error> {
    Arguments::from_arg_matches(&command_line().try_get_matches()?)
}

fn run(command: Command) -> Result<(), Box<dyn Error>> {
    match command {
        Command::Bound(arguments) => bound::run(&arguments),
        Command::Clip(arguments) => clip::run(&arguments),
        Command::Train(arguments) => train::run(&arguments),
        Command::Complete(arguments) => complete::run(&arguments),
        Command::Couple(arguments) => couple::run(&arguments),
        Command::Primitives(arguments) => primitives::run(&arguments),
        Command::Recognise(arguments) => recognise::run(&arguments),
        Command::Reproduce(arguments) => reproduce::run(&arguments),
        Command::Rollout(arguments) => rollout::run(&arguments),
        Command::Score(arguments) => score::run(&arguments),
        Command::Evaluate(arguments) => evaluate::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Study(arguments) => study::run(&arguments),
        Command::Perception(arguments) => perception::run(&arguments),
        Command::Results(arguments) => results::run(&arguments),
        Command::Completions(arguments) => shell::completions(&arguments, command_line()),
        Command::Man(arguments) => shell::man(&arguments, command_line()),
    }
}

/// The first paragraph of clap's message with clap's hints ("a similar argument exists"). The other
/// paragraphs are help.
fn usage_message(error: &clap::Error) -> String {
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        let command = command_line();
        let names: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).collect();
        return format!("expected one of the commands {} (try --help)", names.join(", "));
    }
    let text = error.render().to_string();
    let first = text.split("\n\n").next().unwrap_or_default().trim_start_matches("error: ");
    // The standard library's words for a wrong number are for programmers.
    let reason = error.source().filter(|reason| reason.is::<ParseFloatError>());
    let first =
        reason.map_or(first.to_owned(), |reason| first.replace(&reason.to_string(), "expected a number"));
    let hints = text.lines().filter_map(|line| line.trim_start().strip_prefix("tip: "));
    let parts: Vec<&str> = std::iter::once(first.as_str()).chain(hints).collect();
    format!("{} (try --help)", parts.join("; "))
}
