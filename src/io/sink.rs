//! Where writers put their bytes: counted rows, so that a job sees progress and can stop them.

use crate::error::Result;
use crate::job::Run;
use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;
use std::fmt::Arguments;
use std::io::Write;

/// The rows between two reports of progress: well below 10 ms of writing.
const TICK_ROWS: usize = 4096;

/// The output of one writer.
pub(super) struct Sink<'a> {
    out: &'a mut dyn Write,
    run: &'a Run<'a>,
    done: usize,
    total: usize,
    warnings: Vec<String>,
}

impl<'a> Sink<'a> {
    /// A sink that expects `total` rows.
    pub fn new(out: &'a mut dyn Write, total: usize, run: &'a Run<'a>) -> Self {
        Sink { out, run, done: 0, total, warnings: Vec::new() }
    }

    /// The run that the writing is part of.
    pub fn run(&self) -> &'a Run<'a> {
        self.run
    }

    pub fn bytes(&mut self, bytes: &[u8]) -> Result<()> {
        Ok(self.out.write_all(bytes)?)
    }

    pub fn text(&mut self, text: Arguments<'_>) -> Result<()> {
        Ok(self.out.write_fmt(text)?)
    }

    /// Everything that `write` puts into the sink it is given, as base64.
    pub fn base64(&mut self, write: impl FnOnce(&mut Sink<'_>) -> Result<()>) -> Result<()> {
        let mut encoder = EncoderWriter::new(&mut *self.out, &STANDARD);
        let mut inner = Sink {
            out: &mut encoder,
            run: self.run,
            done: self.done,
            total: self.total,
            warnings: Vec::new(),
        };
        write(&mut inner)?;
        self.done = inner.done;
        encoder.finish()?;
        Ok(())
    }

    /// Says what the file does not hold.
    pub fn warn(&mut self, warning: String) {
        self.warnings.push(warning);
    }

    /// Ends the writing and returns the warnings.
    pub fn finish(self) -> Result<Vec<String>> {
        self.out.flush()?;
        Ok(self.warnings)
    }

    /// Says that a row is written.
    pub fn row(&mut self) -> Result<()> {
        self.done += 1;
        if self.done.is_multiple_of(TICK_ROWS) {
            self.run.tick(self.done, self.total)?;
        }
        Ok(())
    }
}
