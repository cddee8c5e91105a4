//! A reader that remembers what it gave last, to find places in a file again.

use std::io::{self, Read};

use gamow_platform::sizes;

/// A reader that remembers what it gave last.
pub(super) struct Tap<R> {
    inner: R,
    /// Number of lines before what is read.
    lines_before: u64,
    pub(super) chunk: Vec<u8>,
    bytes: u64,
    pub(super) has_ended: bool,
    /// Start of the row that is being read, and its line.
    row: (u64, u64),
    /// Whether a row has been begun, by more than blank lines, in what was given.
    is_begun: bool,
}

impl<R: Read> Read for Tap<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.check_row()?;
        let count = self.inner.read(buffer)?;
        self.has_ended = count == 0;
        if !self.has_ended {
            self.chunk.clear();
            self.chunk.extend_from_slice(&buffer[..count]);
            self.bytes += count as u64;
        }
        Ok(count)
    }
}

impl<R> Tap<R> {
    pub const fn new(inner: R, lines_before: u64) -> Self {
        Self {
            inner,
            lines_before,
            chunk: Vec::new(),
            bytes: 0,
            has_ended: false,
            row: (0, 1),
            is_begun: false,
        }
    }

    /// Notes that a row is read now, from `start` in the file, which is in this `line`.
    pub const fn begin_row(&mut self, start: u64, line: u64) {
        self.row = (start, line);
        self.is_begun = false;
    }

    /// Refuses a row that needs more than what was given if that is long enough for any.
    fn check_row(&mut self) -> io::Result<()> {
        if !self.is_begun {
            let (start, line) = self.row;
            let given = self.after(start);
            let blank = given.iter().take_while(|byte| matches!(byte, b'\r' | b'\n')).count();
            let lines = given[..blank].split(|byte| *byte == b'\n').count() - 1;
            self.is_begun = blank < given.len();
            self.row = (start + blank as u64, line + lines as u64);
        }
        let (start, line) = self.row;
        if self.bytes - start <= sizes::ROW_BYTES {
            return Ok(());
        }
        let (line, most) = (self.lines_before + line, sizes::ROW_BYTES >> 20);
        let problem =
            format!("the row that starts in line {line} is longer than {most} MB, the limit for a row");
        Err(io::Error::new(io::ErrorKind::InvalidData, problem))
    }

    /// Returns the bytes that it gave last, before `position` in the file.
    pub fn before(&self, position: u64) -> &[u8] {
        self.chunk.split_at(self.place(position)).0
    }

    /// Returns the bytes that it gave last, from `position` in the file on.
    pub fn after(&self, position: u64) -> &[u8] {
        self.chunk.split_at(self.place(position)).1
    }

    fn place(&self, position: u64) -> usize {
        // csv buffers nothing but what it was given last, so `position` is within it.
        self.chunk.len() - (self.bytes - position) as usize
    }
}
