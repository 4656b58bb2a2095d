//! Text cut into lines and words, so that every error can name its line.

use crate::error::{ElementKind, Error, Result, Status};
use crate::job::Run;
use std::str::FromStr;

/// The bytes between two reports of progress: well below 10 ms of parsing.
const TICK_BYTES: usize = 1 << 16;

/// A malformed line, counted from 1.
pub(super) fn at_line(line: u64, message: impl Into<String>) -> Error {
    Error::new(Status::Format, message).at(ElementKind::Line, line)
}

/// A word as a message may show it: printable and short.
pub(super) fn shown(word: &[u8]) -> String {
    let more = if word.len() > 24 { "..." } else { "" };
    format!("'{}{more}'", word[..word.len().min(24)].escape_ascii())
}

/// The lines of a text. A line ends with LF, CR LF or CR.
pub(super) struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    number: u64,
    next_tick: usize,
    run: &'a Run<'a>,
}

/// One line without its end.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    /// Counted from 1.
    pub number: u64,
    pub bytes: &'a [u8],
}

impl<'a> Lines<'a> {
    pub fn new(bytes: &'a [u8], run: &'a Run<'a>) -> Self {
        let bom = bytes.starts_with(b"\xef\xbb\xbf");
        Lines { bytes, at: if bom { 3 } else { 0 }, number: 0, next_tick: 0, run }
    }

    /// The lines from byte `at` on, the first of which has the number after `number`.
    pub fn from(bytes: &'a [u8], at: usize, number: u64, run: &'a Run<'a>) -> Self {
        Lines { bytes, at, number, next_tick: 0, run }
    }

    /// The next line, whatever it holds.
    pub fn next(&mut self) -> Result<Option<Line<'a>>> {
        if self.at >= self.next_tick {
            self.run.tick(self.at, self.bytes.len())?;
            self.next_tick = self.at + TICK_BYTES;
        }
        let rest = &self.bytes[self.at..];
        if rest.is_empty() {
            return Ok(None);
        }
        let end = rest.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(rest.len());
        let pair = rest[end..].starts_with(b"\r\n");
        self.at = (self.at + end + if pair { 2 } else { 1 }).min(self.bytes.len());
        self.number += 1;
        Ok(Some(Line { number: self.number, bytes: &rest[..end] }))
    }

    /// The next line that holds a word.
    pub fn next_filled(&mut self) -> Result<Option<Line<'a>>> {
        loop {
            match self.next()? {
                Some(line) if line.words().is_at_end() => {}
                line => return Ok(line),
            }
        }
    }

    /// The next line that holds a word; at the end of the file, the error that `what` is missing.
    pub fn expect(&mut self, what: &str) -> Result<Line<'a>> {
        self.next_filled()?.ok_or_else(|| self.ended(what))
    }

    /// The error that the file ends too early.
    pub fn ended(&self, what: &str) -> Error {
        at_line(self.number(), format!("the file ends here, before {what}"))
    }

    /// Checks that `count` rows of at least `row` bytes each, line end included, can follow.
    pub fn check_room(&self, count: u64, row: u64, what: &str) -> Result<()> {
        self.check_bytes(count.saturating_mul(row), &format!("{count} {what}"))
    }

    /// Checks that at least `needed` bytes follow.
    pub fn check_bytes(&self, needed: u64, what: &str) -> Result<()> {
        let left = (self.bytes.len() - self.at) as u64;
        // The last line may lack its end.
        if needed > left + 1 {
            let message = format!("only {left} bytes follow, too few for the {what} promised");
            return Err(at_line(self.number(), message));
        }
        Ok(())
    }

    /// Checks that nothing but blank and comment lines follows.
    pub fn finish(&mut self, what: &str) -> Result<()> {
        match self.next_filled()? {
            None => Ok(()),
            Some(line) => Err(at_line(
                line.number,
                format!("{} follows {what}", shown(line.words().next().unwrap_or_default())),
            )),
        }
    }

    /// The number of the last line, at least 1.
    pub fn number(&self) -> u64 {
        self.number.max(1)
    }

    /// Where the next line begins.
    pub fn position(&self) -> usize {
        self.at
    }
}

impl<'a> Line<'a> {
    /// The words, parted by white space; a word that begins with `#` ends the line.
    pub fn words(&self) -> Words<'a> {
        Words { line: self.number, rest: self.bytes }
    }
}

/// The words of a line.
#[derive(Clone, Default)]
pub(super) struct Words<'a> {
    line: u64,
    rest: &'a [u8],
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let start = self.rest.iter().position(|&b| !b.is_ascii_whitespace())?;
        let rest = &self.rest[start..];
        if rest[0] == b'#' {
            self.rest = &[];
            return None;
        }
        let end = rest.iter().position(|&b| b.is_ascii_whitespace()).unwrap_or(rest.len());
        self.rest = &rest[end..];
        Some(&rest[..end])
    }
}

impl<'a> Words<'a> {
    pub fn is_at_end(&self) -> bool {
        self.clone().next().is_none()
    }

    /// The next word; at the end of the line, the error that `what` is missing.
    pub fn expect(&mut self, what: &str) -> Result<&'a [u8]> {
        let line = self.line;
        self.next().ok_or_else(|| at_line(line, format!("the line ends before {what}")))
    }

    /// The next word as a number; NaN and infinities are numbers here.
    pub fn f64(&mut self, what: &str) -> Result<f64> {
        let word = self.expect(what)?;
        number::<f64>(self.line, word, what)
    }

    /// The next three words as coordinates.
    pub fn xyz(&mut self) -> Result<[f64; 3]> {
        Ok([self.f64("x")?, self.f64("y")?, self.f64("z")?])
    }

    /// The next word as a count.
    pub fn whole(&mut self, what: &str) -> Result<u64> {
        let word = self.expect(what)?;
        if !is_count(word) {
            let message = format!("{what} must be a whole number, not {}", shown(word));
            return Err(at_line(self.line, message));
        }
        parse(word).ok_or_else(|| {
            at_line(self.line, format!("{what} is {}, more than any file holds", shown(word)))
        })
    }

    /// The next word as an index below `count`.
    pub fn index(&mut self, what: &str, count: usize) -> Result<u32> {
        let word = self.expect(what)?;
        let index = if is_count(word) { parse(word) } else { None };
        index.filter(|&index: &u32| (index as usize) < count).ok_or_else(|| {
            let shown = shown(word);
            at_line(
                self.line,
                format!("{what} must be a vertex from 0 to below {count}, not {shown}"),
            )
        })
    }

    /// Checks that the line has no further word.
    pub fn finish(&mut self, what: &str) -> Result<()> {
        match self.next() {
            None => Ok(()),
            Some(word) => Err(at_line(self.line, format!("{} follows {what}", shown(word)))),
        }
    }
}

/// A word as a number of type `T`, correctly rounded. NaN and infinities are numbers where the word names
/// them; digits that `T` makes an infinity or 0 of are an error.
pub(super) fn number<T: FromStr + Into<f64>>(line: u64, word: &[u8], what: &str) -> Result<f64> {
    let Some(value) = parse::<T>(word).map(T::into) else {
        return Err(at_line(line, format!("{what} must be a number, not {}", shown(word))));
    };
    if (value == 0.0 || value.is_infinite()) && has_digits(word) {
        let is = if value == 0.0 { "small" } else { "large" };
        let precision = if size_of::<T>() == size_of::<f32>() { "single" } else { "double" };
        let shown = shown(word);
        let message = format!("{what} is too {is} for {precision} precision: {shown}");
        return Err(at_line(line, message));
    }
    Ok(value)
}

/// Whether a number has a digit other than 0 before its exponent.
fn has_digits(word: &[u8]) -> bool {
    let mut digits = word.iter().take_while(|b| !b.eq_ignore_ascii_case(&b'e'));
    digits.any(|b| (b'1'..=b'9').contains(b))
}

fn parse<T: FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// Whether a word consists of digits.
pub(super) fn is_count(word: &[u8]) -> bool {
    !word.is_empty() && word.iter().all(u8::is_ascii_digit)
}
