//! `vcgpdm completions` and `vcgpdm man`: completions for shells, and pages for `man`.

use crate::files;
use crate::usage::usage;
use clap::Command;
use clap_complete::Shell;
use std::error::Error;

/// Print completions of the commands and options for a shell.
#[derive(clap::Args)]
pub struct Completions {
    /// The shell.
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

/// Print a page for `man`.
#[derive(clap::Args)]
pub struct Man {
    /// The page of this command; absent: the page of the program.
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

pub fn completions(arguments: &Completions, mut command: Command) -> Result<(), Box<dyn Error>> {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, "vcgpdm", &mut text);
    files::print(&String::from_utf8(text)?)
}

pub fn man(arguments: &Man, mut command: Command) -> Result<(), Box<dyn Error>> {
    // This gives commands their full names, such as vcgpdm-train.
    command.build();
    let page = match &arguments.command {
        None => command,
        Some(name) => command.find_subcommand(name).cloned().ok_or_else(|| {
            let names: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
            usage(format!("man {name}: expected one of the commands {}", names.join(", ")))
        })?,
    };
    let mut text = Vec::new();
    clap_mangen::Man::new(page).render(&mut text)?;
    files::print(&String::from_utf8(text)?)
}
