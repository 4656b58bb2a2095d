//! The bytes of a file on their way through the JSON parser: polled, counted, and looked back at.

use super::super::text::{at_line, shown};
use crate::error::Error;
use crate::job::Run;
use serde_core::de;
use serde_json::error::Category;
use std::cell::{Cell, RefCell};
use std::io::{self, Read};

/// The bytes between two reports of progress: well below 10 ms of parsing.
const TICK_BYTES: usize = 1 << 15;
/// The most characters of a message that the parser made.
const MESSAGE: usize = 200;

/// A file's bytes, how far they are read, and what stopped the reading if it was not the parser.
pub(super) struct Source<'a> {
    bytes: &'a [u8],
    at: Cell<usize>,
    pub run: &'a Run<'a>,
    stopped: RefCell<Option<Error>>,
}

impl<'a> Source<'a> {
    pub fn new(bytes: &'a [u8], run: &'a Run<'a>) -> Self {
        let bom = bytes.starts_with(b"\xef\xbb\xbf");
        let at = Cell::new(if bom { 3 } else { 0 });
        Source { bytes, at, run, stopped: RefCell::new(None) }
    }

    pub fn reader(&self) -> Reader<'_, 'a> {
        Reader(self)
    }

    /// Keeps an error for the end, and returns one that stops the parser.
    pub fn stop<E: de::Error>(&self, error: Error) -> E {
        self.stopped.replace(Some(error));
        E::custom("stopped")
    }

    /// What the parser's error is to a caller.
    pub fn error(&self, error: &serde_json::Error) -> Error {
        if let Some(stopped) = self.stopped.take() {
            return stopped;
        }
        let text = error.to_string();
        let text = text.rsplit_once(" at line ").map_or(&text[..], |(message, _)| message);
        let message: String = text.chars().take(MESSAGE).collect();
        match error.classify() {
            Category::Eof => {
                at_line(error.line().max(1) as u64, format!("{message}: the file ends here"))
            }
            _ => at_line(error.line().max(1) as u64, message),
        }
    }

    /// A number that the parser has just read, unless it made 0 of one that is not.
    pub fn number<E: de::Error>(&self, value: f64) -> Result<f64, E> {
        if value == 0.0 {
            let word = self.word();
            let mut digits = word.iter().take_while(|b| !b.eq_ignore_ascii_case(&b'e'));
            if digits.any(|b| (b'1'..=b'9').contains(b)) {
                let shown = shown(word);
                return Err(E::custom(format!(
                    "a number is too small for double precision: {shown}"
                )));
            }
        }
        Ok(value)
    }

    /// The number that ends here. The parser may have seen the character behind it.
    fn word(&self) -> &'a [u8] {
        let is_part = |b: &u8| b.is_ascii_digit() || b"+-.eE".contains(b);
        let read = &self.bytes[..self.at.get()];
        let read = match read.last() {
            Some(last) if !is_part(last) => &read[..read.len() - 1],
            _ => read,
        };
        let begin = read.iter().rposition(|b| !is_part(b)).map_or(0, |before| before + 1);
        &read[begin..]
    }
}

/// Gives the bytes to the parser, which asks for one at a time.
pub(super) struct Reader<'s, 'a>(&'s Source<'a>);

impl Read for Reader<'_, '_> {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        let source = self.0;
        let at = source.at.get();
        let rest = &source.bytes[at..];
        // Never past a place where the job is asked.
        let count = to.len().min(rest.len()).min(TICK_BYTES - at % TICK_BYTES);
        if at.is_multiple_of(TICK_BYTES) {
            source.run.tick(at, source.bytes.len()).map_err(|error| {
                source.stopped.replace(Some(error));
                io::Error::other("stopped")
            })?;
        }
        to[..count].copy_from_slice(&rest[..count]);
        source.at.set(at + count);
        Ok(count)
    }
}
