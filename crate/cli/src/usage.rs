//! Errors of the command line. Their exit status is 2; errors of files have the exit status 1.

use std::error::Error;
use std::fmt;

/// An error of the command line, in one sentence.
#[derive(Debug)]
pub struct Usage(pub String);

impl fmt::Display for Usage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for Usage {}

/// An error of the command line.
pub fn usage(text: impl Into<String>) -> Box<dyn Error> {
    Box::new(Usage(text.into()))
}

/// The first of these options that was given.
pub fn first_given(options: impl IntoIterator<Item = (&'static str, bool)>) -> Option<&'static str> {
    options.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
}
