//! A file by name and bytes, its lines split into words, and errors that name a line.

use thiserror::Error;

/// A file: its name and its bytes.
#[derive(Clone, Copy, Debug)]
pub struct File<'a> {
    /// For messages.
    pub name: &'a str,
    /// Its content.
    pub bytes: &'a [u8],
}

/// A line of a file, as words.
#[derive(Clone, Debug)]
pub(super) struct Line<'a> {
    pub(super) file: &'a str,
    pub(super) number: usize,
    pub(super) words: Vec<&'a str>,
}

impl<'a> Line<'a> {
    pub(super) fn error(&self, expected: impl Into<String>) -> AsfError {
        let words: String = self.words.join(" ").chars().take(60).collect();
        let found = if words.is_empty() { "the end of the file".to_owned() } else { format!("{words:?}") };
        AsfError { file: self.file.to_owned(), line: self.number, expected: expected.into(), found }
    }

    /// `count` numbers after the first word.
    pub(super) fn numbers(&self, count: usize) -> Result<Vec<f64>, AsfError> {
        let read = |word: &&str| word.parse::<f64>().ok().filter(|number| number.abs() < 1e9);
        let numbers: Option<Vec<f64>> = self.words.iter().skip(1).take(count).map(read).collect();
        let numbers = numbers.filter(|numbers| numbers.len() == count);
        let first = self.words.first().copied().unwrap_or_default();
        numbers.ok_or_else(|| self.error(format!("{first:?} and {count} numbers")))
    }
}

/// All lines with words, without comments, and an empty line for the end of the file. Old files of Macs end
/// lines with CR alone.
pub(super) fn lines<'a>(file: &'a str, text: &'a str) -> Vec<Line<'a>> {
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let line = |(k, line): (usize, &'a str)| {
        let words: Vec<&str> = line.split('#').next().unwrap_or_default().split_whitespace().collect();
        Line { file, number: k + 1, words }
    };
    let text = text.strip_suffix(end).unwrap_or(text);
    let mut lines: Vec<Line> = text.split(end).enumerate().map(line).collect();
    let number = lines.len() + 1;
    lines.retain(|line| !line.words.is_empty());
    lines.push(Line { file, number, words: Vec::new() });
    lines
}

/// Why Acclaim files cannot be read, and where.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{file}, line {line}: expected {expected}, found {found}")]
pub struct AsfError {
    /// The name of the file.
    pub file: String,
    /// The line, counted from 1.
    pub line: usize,
    /// What was expected.
    pub expected: String,
    /// What was found.
    pub found: String,
}
