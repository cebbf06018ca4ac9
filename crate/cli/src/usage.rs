//! A command line that asks for what there is not, apart from files that cannot be used: its exit status is
//! 2.

use std::error::Error;
use std::fmt;

/// What was wrong with the command line, in one sentence.
#[derive(Debug)]
pub struct Usage(pub String);

impl fmt::Display for Usage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for Usage {}

/// An error about the command line.
pub fn usage(text: impl Into<String>) -> Box<dyn Error> {
    Box::new(Usage(text.into()))
}

/// The first of these options that was given.
pub fn first_given(options: impl IntoIterator<Item = (&'static str, bool)>) -> Option<&'static str> {
    options.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
}
