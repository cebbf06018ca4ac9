//! Splits the bytes of a file into words with line numbers, and reads numbers.

use crate::encoding::utf16;
use crate::motion::bvh::error::{BvhError, BvhProblem};
use crate::motion::skeleton::LARGEST_NUMBER;

/// The text of a file, and a warning when its encoding was not UTF-8.
pub(super) fn decode(bytes: &[u8]) -> (String, Option<String>) {
    if let Some(text) = utf16(bytes) {
        return (text, Some("the file is UTF-16; it was read as such".to_owned()));
    }
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => (text.to_owned(), None),
        // Every byte is a character of Latin-1, so old files with accented joint names can always be read.
        Err(_) => (
            bytes.iter().map(|&byte| char::from(byte)).collect(),
            Some("the file is not UTF-8; its names were read as Latin-1".to_owned()),
        ),
    }
}

/// Whether a character separates words. Ctrl-Z and NUL end some old files.
pub(super) fn is_blank(c: char) -> bool {
    c.is_whitespace() || c == '\u{1A}' || c == '\0' || c == '\u{FEFF}'
}

/// A place in the text. CR, LF and CR LF each end one line.
pub(super) struct Cursor<'a> {
    file: &'a str,
    rest: &'a str,
    /// The line of the next character, counted from 1.
    line: usize,
    /// The line of the last word, for messages.
    word_line: usize,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(file: &'a str, text: &'a str) -> Cursor<'a> {
        Cursor { file, rest: text, line: 1, word_line: 1 }
    }

    /// The line of the last word.
    pub(super) fn word_line(&self) -> usize {
        self.word_line
    }

    fn advance(&mut self, length: usize) -> &'a str {
        let (taken, rest) = self.rest.split_at(length);
        let mut bytes = taken.bytes().peekable();
        while let Some(byte) = bytes.next() {
            if byte == b'\n' || byte == b'\r' && bytes.peek().or(rest.as_bytes().first()) != Some(&b'\n') {
                self.line += 1;
            }
        }
        self.rest = rest;
        taken
    }

    fn skip_blanks(&mut self) {
        let length = self.rest.find(|c| !is_blank(c)).unwrap_or(self.rest.len());
        self.advance(length);
    }

    /// The next word: a brace, or everything up to a blank or a brace. `None` at the end of the file.
    pub(super) fn word(&mut self) -> Option<&'a str> {
        self.skip_blanks();
        self.word_line = self.line;
        let first = self.rest.chars().next()?;
        let length = if first == '{' || first == '}' {
            1
        } else {
            self.rest.find(|c| is_blank(c) || c == '{' || c == '}').unwrap_or(self.rest.len())
        };
        Some(self.advance(length))
    }

    /// The next word, which stays the next word.
    pub(super) fn peek(&mut self) -> Option<&'a str> {
        let (rest, line) = (self.rest, self.line);
        let word = self.word();
        (self.rest, self.line) = (rest, line);
        word
    }

    /// A name: the rest of the line up to a brace. Names may hold blanks.
    pub(super) fn name(&mut self) -> &'a str {
        let length = self.rest.find(['{', '\r', '\n']).unwrap_or(self.rest.len());
        self.advance(length).trim_matches(is_blank)
    }

    /// A name on the next line.
    pub(super) fn name_on_next_line(&mut self) -> &'a str {
        self.skip_blanks();
        self.name()
    }

    /// The next line that is not blank and its number; `None` at the end of the file.
    pub(super) fn line(&mut self) -> Option<(usize, &'a str)> {
        self.skip_blanks();
        if self.rest.is_empty() {
            return None;
        }
        let number = self.line;
        self.word_line = number;
        let length = self.rest.find(['\r', '\n']).unwrap_or(self.rest.len());
        Some((number, self.advance(length)))
    }

    /// The next line if it is a number alone; any other line stays the next line.
    pub(super) fn number_on_next_line(&mut self) -> Option<&'a str> {
        let before = (self.rest, self.line, self.word_line);
        let number = self.line().map(|(_, text)| text.trim_matches(is_blank));
        let number = number.filter(|text| finite(text).is_some());
        if number.is_none() {
            (self.rest, self.line, self.word_line) = before;
        }
        number
    }

    /// An error at the last word.
    pub(super) fn error(&self, problem: BvhProblem) -> BvhError {
        self.error_at(self.word_line, problem)
    }

    /// An error at a line.
    pub(super) fn error_at(&self, line: usize, problem: BvhProblem) -> BvhError {
        BvhError { file: self.file.to_owned(), line, problem }
    }

    /// Takes one word, which must be this keyword in any case.
    pub(super) fn expect(&mut self, keyword: &str) -> Result<(), BvhError> {
        match self.word() {
            Some(word) if word.eq_ignore_ascii_case(keyword) => Ok(()),
            found => Err(self.error(BvhProblem::expected(keyword, found))),
        }
    }

    /// Takes one word that is a finite number.
    pub(super) fn number(&mut self) -> Result<f64, BvhError> {
        let word = self.word();
        word.and_then(finite).ok_or_else(|| self.error(not_a_number(word)))
    }
}

/// The number that a word spells; `None` for NaN, infinities, numbers above 1e9 and other words.
pub(super) fn finite(word: &str) -> Option<f64> {
    word.parse().ok().filter(|number: &f64| number.abs() <= LARGEST_NUMBER)
}

/// The largest finite number has 309 digits before its point.
const LONGEST_NUMBER: usize = 1000;

/// The problem with a word that is not a number.
pub(super) fn not_a_number(word: Option<&str>) -> BvhProblem {
    let Some(text) = word else { return BvhProblem::expected("a number", None) };
    // Looking for two numbers in a word of a megabyte would take hours.
    if text.len() > LONGEST_NUMBER {
        return BvhProblem::expected("a number", word);
    }
    let glued = text.char_indices().skip(1).any(|(at, c)| {
        (c == '-' || c == '+') && finite(&text[..at]).is_some() && finite(&text[at..]).is_some()
    });
    let expected = match text.parse::<f64>() {
        Ok(_) => "a number from -1e9 to 1e9",
        Err(_) if glued => "a number (is a blank missing?)",
        Err(_) if finite(&text.replace(',', ".")).is_some() => "a number with a decimal point",
        Err(_) => "a number",
    };
    BvhProblem::expected(expected, word)
}
