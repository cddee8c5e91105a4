//! CSV rows in: which column is which, the numbers in them, and where in the file a fault is.
//!
//! Comma-separated as in RFC 4180, with any line ending; a byte order mark and blank lines are skipped, and
//! UTF-16 with its mark is read. Where the header has semicolons or tabs instead, as spreadsheets write in
//! half of Europe, or only blanks, as `NumPy` and R do, these separate, and numbers may have decimal commas.
//! The header may stand below lines of another kind, and behind `#`; below it, a line that starts with `#` is
//! a row. Numbers may be quoted or padded with blanks. Columns that mean nothing here may hold any bytes. A
//! row is refused once it is longer than [`sizes::ROW_BYTES`], so that a file takes no more memory than that,
//! whatever is in it.

mod header_line;
mod names;
mod tap;

use std::io::{self, Chain, Cursor, Read};
use std::path::Path;

use anyhow::Context as _;
use csv::ByteRecord;
#[cfg(doc)]
use gamow_platform::sizes;
use gamow_platform::{environment, files};

use self::header_line::HeaderLine;
use self::names::legible;
use self::tap::Tap;
use super::csv_out::io_error;
use super::utf16::Decoded;

pub use self::header_line::COMMENTS;
pub use self::names::{HeaderError, Names, RowError, number, text};

const BUFFER_BYTES: usize = 1 << 16;

/// `file`, or standard input if that is `None` or `-`; and its name in messages.
pub fn open(file: Option<&Path>) -> anyhow::Result<(String, Box<dyn Read>)> {
    let Some(file) = file.filter(|file| *file != Path::new("-")) else {
        return Ok(("standard input".to_owned(), Box::new(environment::standard_input())));
    };
    let name = files::shown(file);
    let input = files::open_stream(file).with_context(|| name.clone())?;
    Ok((name, input))
}

/// The header, which is read first, and what follows it.
type FromHeader<R> = Chain<Cursor<Vec<u8>>, Decoded<R>>;

/// Reads rows, and knows the line of the last one.
pub struct CsvReader<R> {
    csv: csv::Reader<Tap<FromHeader<R>>>,
    separator: u8,
    /// The lines before the header, and the encoding.
    pub preamble: Preamble,
}

/// The lines before the header of a file, and its encoding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Preamble {
    /// Whether the file is in UTF-16.
    pub is_utf16: bool,
    /// Number of lines before the header, blank ones included.
    pub lines: u64,
    /// Whether any of these lines has text.
    pub has_text: bool,
    /// Whether the header stands behind a mark of a comment.
    pub is_commented: bool,
}

impl<R: Read> CsvReader<R> {
    /// Reads `reader` as far as its header, the first line that `is_header`, which determines the field
    /// separator; where there is no such line, the first one with text.
    ///
    /// # Errors
    ///
    /// Those of what is read.
    pub fn new(reader: R, is_header: impl Fn(&Names) -> bool) -> io::Result<Self> {
        let mut reader = Decoded::new(reader)?;
        let (mut begin, header) = header_line::find(&mut reader, is_header)?;
        begin.drain(..header.start);
        let HeaderLine { separator, lines, has_text, is_commented, .. } = header;
        let preamble = Preamble { is_utf16: reader.is_utf16(), lines, has_text, is_commented };
        let csv = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true) // rows of the wrong length get an error of ours
            .delimiter(separator)
            .buffer_capacity(BUFFER_BYTES)
            .from_reader(Tap::new(Cursor::new(begin).chain(reader), lines));
        Ok(Self { csv, separator, preamble })
    }

    /// Reads the next row into `row`, with decimal points; false if there is none.
    ///
    /// # Errors
    ///
    /// Those of what is read; a row that is too long.
    pub fn read(&mut self, row: &mut ByteRecord) -> io::Result<bool> {
        let (start, line) = (self.csv.position().byte(), self.csv.position().line());
        self.csv.get_mut().begin_row(start, line);
        let is_read = self.csv.read_byte_record(row).map_err(io_error)?;
        if self.separator == b' ' {
            *row = header_line::without_blanks(row);
        }
        if self.separator != b',' && row.as_slice().contains(&b',') {
            *row = row.iter().map(with_decimal_point).collect();
        }
        Ok(is_read)
    }

    /// The line, from 1, on which `row`, the last one read, starts.
    ///
    /// The position that csv notes for a record is that of the line end and the blank lines before it, so
    /// we count back from its end.
    pub fn line(&self, row: &ByteRecord) -> u64 {
        let end = self.csv.position();
        let breaks_inside = row.as_slice().split(|&byte| byte == b'\n').count() as u64 - 1;
        let break_at_end =
            !self.is_unclosed(row) && self.csv.get_ref().before(end.byte()).last() == Some(&b'\n');
        self.preamble.lines + end.line() - breaks_inside - u64::from(break_at_end)
    }

    /// Refuses `row`, the last one read, if its last field has swallowed the rest of the file.
    pub fn check_closed(&self, row: &ByteRecord) -> Result<(), RowError> {
        match row.iter().next_back() {
            Some(field) if self.is_unclosed(row) => Err(RowError::Unclosed { value: legible(field) }),
            _ => Ok(()),
        }
    }

    /// Whether the file ends inside the quotes of `row`, the last one read.
    ///
    /// csv closes them without a word. Only then has a row with no line end after it line ends in its last
    /// field, and no quote at its end.
    fn is_unclosed(&self, row: &ByteRecord) -> bool {
        let file = self.csv.get_ref();
        let has_break = |field: &[u8]| field.iter().any(|byte| matches!(byte, b'\r' | b'\n'));
        file.has_ended && row.iter().next_back().is_some_and(has_break) && file.chunk.last() != Some(&b'"')
    }

    /// Whether the next read waits for input: nothing is left but, after a carriage return, a line feed.
    pub fn is_drained(&self) -> bool {
        let left = self.csv.get_ref().after(self.csv.position().byte());
        left.iter().all(|byte| matches!(byte, b'\r' | b'\n'))
    }
}

/// `field` with a point in place of its comma if that makes it a number.
fn with_decimal_point(field: &[u8]) -> Vec<u8> {
    let pointed: Vec<u8> = field.iter().map(|&byte| if byte == b',' { b'.' } else { byte }).collect();
    let is_number = std::str::from_utf8(&pointed).is_ok_and(|text| text.trim_ascii().parse::<f64>().is_ok());
    if is_number { pointed } else { field.to_owned() }
}
