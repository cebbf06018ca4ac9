//! Parses JSON (RFC 8259).

use crate::json::value::Value;
use thiserror::Error;

/// Deepest nesting: a deeper one could overflow the stack.
const DEEPEST: usize = 100;

/// Why a text is not JSON.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("line {line}, column {column}: expected {expected}, found {found}")]
pub struct JsonError {
    /// Counted from 1.
    pub line: usize,
    /// Counted from 1, in characters.
    pub column: usize,
    /// What was expected.
    pub expected: &'static str,
    /// What was found.
    pub found: String,
}

/// Parses a text that consists of one value.
pub fn parse(text: &str) -> Result<Value, JsonError> {
    let mut parser = Parser::new(text);
    let value = parser.value(0)?;
    match parser.peek() {
        None => Ok(value),
        Some(_) => Err(parser.wrong("the end of the text")),
    }
}

/// The fields of the object that a text consists of. Strings have their value; all other values are skipped
/// and are null here.
pub fn outline(text: &str) -> Result<Vec<(String, Value)>, JsonError> {
    let mut parser = Parser::new(text);
    if parser.peek() != Some(b'{') {
        return Err(parser.wrong("\"{\""));
    }
    parser.fields(|parser| match parser.peek() {
        Some(b'"') => Ok(Value::Text(parser.string()?)),
        _ => parser.skip(),
    })
}

struct Parser<'a> {
    text: &'a str,
    /// The index of the next byte.
    at: usize,
}

impl<'a> Parser<'a> {
    fn new(text: &'a str) -> Self {
        // Some editors write a byte-order mark, which means nothing in UTF-8.
        let at = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Self { text, at }
    }

    /// Skips blanks and returns the next byte, which stays the next byte.
    fn peek(&mut self) -> Option<u8> {
        while let Some(b' ' | b'\t' | b'\n' | b'\r') = self.byte() {
            self.at += 1;
        }
        self.byte()
    }

    fn byte(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Takes the byte if it is the next one.
    fn take(&mut self, byte: u8) -> bool {
        let found = self.byte() == Some(byte);
        self.at += usize::from(found);
        found
    }

    fn wrong(&self, expected: &'static str) -> JsonError {
        let mut at = self.at;
        while !self.text.is_char_boundary(at) {
            at -= 1;
        }
        let (before, after) = self.text.split_at(at);
        let found = match after.chars().next() {
            None => "the end of the text".to_owned(),
            Some(c) if c.is_ascii_control() => format!("the control character {}", u32::from(c)),
            Some(c) => format!("\"{c}\""),
        };
        self.error(before, expected, found)
    }

    fn error(&self, before: &str, expected: &'static str, found: String) -> JsonError {
        let line = 1 + before.bytes().filter(|b| *b == b'\n').count();
        let column = 1 + before.chars().rev().take_while(|c| *c != '\n').count();
        JsonError { line, column, expected, found }
    }

    fn value(&mut self, depth: usize) -> Result<Value, JsonError> {
        let first = self.peek();
        if depth > DEEPEST {
            return Err(self.wrong("at most 100 arrays and objects inside each other"));
        }
        match first {
            Some(b'{') => self.object(depth),
            Some(b'[') => self.list(depth),
            Some(b'"') => Ok(Value::Text(self.string()?)),
            Some(b'-' | b'0'..=b'9') => self.number(),
            _ => {
                let literals =
                    [("null", Value::Null), ("true", Value::Bool(true)), ("false", Value::Bool(false))];
                for (literal, value) in literals {
                    if self.text.as_bytes()[self.at..].starts_with(literal.as_bytes()) {
                        self.at += literal.len();
                        return Ok(value);
                    }
                }
                Err(self.wrong("a value"))
            }
        }
    }

    fn list(&mut self, depth: usize) -> Result<Value, JsonError> {
        self.at += 1;
        let mut items = Vec::new();
        if self.peek() == Some(b']') {
            self.at += 1;
            return Ok(Value::List(items));
        }
        loop {
            items.push(self.value(depth + 1)?);
            self.peek();
            if self.take(b']') {
                return Ok(Value::List(items));
            }
            if !self.take(b',') {
                return Err(self.wrong("\",\" or \"]\""));
            }
        }
    }

    fn object(&mut self, depth: usize) -> Result<Value, JsonError> {
        self.fields(|parser| parser.value(depth + 1)).map(Value::Object)
    }

    /// The names of the fields of an object, with their values read by `read`.
    fn fields(
        &mut self,
        read: impl Fn(&mut Self) -> Result<Value, JsonError>,
    ) -> Result<Vec<(String, Value)>, JsonError> {
        self.at += 1;
        let mut fields = Vec::new();
        if self.peek() == Some(b'}') {
            self.at += 1;
            return Ok(fields);
        }
        loop {
            if self.peek() != Some(b'"') {
                return Err(self.wrong("the name of a field in quotes"));
            }
            let name = self.string()?;
            self.peek();
            if !self.take(b':') {
                return Err(self.wrong("\":\""));
            }
            fields.push((name, read(self)?));
            self.peek();
            if self.take(b'}') {
                return Ok(fields);
            }
            if !self.take(b',') {
                return Err(self.wrong("\",\" or \"}\""));
            }
        }
    }

    /// Moves to the end of a value. Only strings and brackets are checked.
    fn skip(&mut self) -> Result<Value, JsonError> {
        let mut depth = 0_usize;
        while let Some(byte) = self.byte() {
            match byte {
                b',' | b'}' | b']' if depth == 0 => break,
                b'"' => {
                    self.string()?;
                    continue;
                }
                b'{' | b'[' => depth += 1,
                b'}' | b']' => depth -= 1,
                _ => {}
            }
            self.at += 1;
        }
        Ok(Value::Null)
    }

    fn number(&mut self) -> Result<Value, JsonError> {
        let start = self.at;
        self.take(b'-');
        if !self.take(b'0') {
            self.digits()?;
        }
        if self.take(b'.') {
            self.digits()?;
        }
        if self.take(b'e') || self.take(b'E') {
            let _ = self.take(b'-') || self.take(b'+');
            self.digits()?;
        }
        let text = &self.text[start..self.at];
        match text.parse() {
            Ok(number) if f64::is_finite(number) => Ok(Value::Number(number)),
            _ => Err(self.error(
                &self.text[..start],
                "a number of at most 1.8e308 in size",
                format!("{} (out of range)", text.chars().take(30).collect::<String>()),
            )),
        }
    }

    fn digits(&mut self) -> Result<(), JsonError> {
        let start = self.at;
        while let Some(b'0'..=b'9') = self.byte() {
            self.at += 1;
        }
        if self.at == start { Err(self.wrong("a digit")) } else { Ok(()) }
    }

    fn string(&mut self) -> Result<String, JsonError> {
        self.at += 1;
        let mut out = String::new();
        loop {
            let start = self.at;
            while self.byte().is_some_and(|b| b >= 0x20 && b != b'"' && b != b'\\') {
                self.at += 1;
            }
            out.push_str(&self.text[start..self.at]);
            if self.take(b'"') {
                return Ok(out);
            }
            if !self.take(b'\\') {
                return Err(self.wrong("the closing quote of a string"));
            }
            out.push(self.escaped()?);
        }
    }

    /// The character of an escape sequence, behind its backslash.
    fn escaped(&mut self) -> Result<char, JsonError> {
        const EXPECTED: &str = "one of \" \\ / b f n r t u after the \\ in a string";
        let escape = self.byte();
        let c = match escape {
            Some(b'"') => '"',
            Some(b'\\') => '\\',
            Some(b'/') => '/',
            Some(b'b') => '\u{8}',
            Some(b'f') => '\u{c}',
            Some(b'n') => '\n',
            Some(b'r') => '\r',
            Some(b't') => '\t',
            Some(b'u') => {
                self.at += 1;
                return self.code_point();
            }
            _ => return Err(self.wrong(EXPECTED)),
        };
        self.at += 1;
        Ok(c)
    }

    /// The character of `XXXX`, or of the pair `XXXX\uXXXX` for a character beyond U+FFFF.
    fn code_point(&mut self) -> Result<char, JsonError> {
        const PAIR: &str = "a second \\u escape that completes the character";
        let mut code = self.unit()?;
        if (0xD800..0xDC00).contains(&code) {
            if !(self.take(b'\\') && self.take(b'u')) {
                return Err(self.wrong(PAIR));
            }
            let low = self.unit()?;
            if !(0xDC00..0xE000).contains(&low) {
                return Err(self.wrong(PAIR));
            }
            code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
        }
        char::from_u32(code).ok_or_else(|| self.wrong("a \\u escape that is a character"))
    }

    /// Four hexadecimal digits.
    fn unit(&mut self) -> Result<u32, JsonError> {
        let mut unit = 0;
        for _ in 0..4 {
            let digit = self.byte().and_then(|b| char::from(b).to_digit(16));
            unit = 16 * unit + digit.ok_or_else(|| self.wrong("four hexadecimal digits after \\u"))?;
            self.at += 1;
        }
        Ok(unit)
    }
}
