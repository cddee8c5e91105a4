//! CSV rows in: which column is which, the numbers in them, and where in the file a fault is.
//!
//! Comma-separated as in RFC 4180, with any line ending; a byte order mark and blank lines are skipped. Where
//! the header has semicolons or tabs instead, as spreadsheets write in half of Europe, these separate, and
//! numbers may have decimal commas. There are no comments: a line that starts with `#` is a row. Numbers may
//! be quoted or padded with blanks. Columns that mean nothing here may hold any bytes. A row is refused once
//! it is longer than [`sizes::ROW_BYTES`], so that a file takes no more memory than that, whatever is in it.

use std::io::{self, Chain, Cursor, Read};
use std::path::Path;

use anyhow::Context as _;
use csv::ByteRecord;
use gamow_platform::{environment, files, messages, sizes};
use thiserror::Error;

use super::csv_out::io_error;

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

/// Reads rows, and knows the line of the last one.
pub struct CsvReader<R> {
    csv: csv::Reader<Tap<Chain<Cursor<Vec<u8>>, R>>>,
    has_decimal_commas: bool,
}

impl<R: Read> CsvReader<R> {
    /// Reads `reader` as far as its header, which determines the field separator.
    ///
    /// # Errors
    ///
    /// Those of what is read.
    pub fn new(mut reader: R) -> io::Result<Self> {
        let begin = header_in(&mut reader)?;
        let separator = separator(&begin);
        let csv = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true) // rows of the wrong length get an error of ours
            .delimiter(separator)
            .buffer_capacity(BUFFER_BYTES)
            .from_reader(Tap::new(Cursor::new(begin).chain(reader)));
        Ok(Self { csv, has_decimal_commas: separator != b',' })
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
        if self.has_decimal_commas && row.as_slice().contains(&b',') {
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
        end.line() - breaks_inside - u64::from(break_at_end)
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

/// The beginning of what `reader` gives: as much as has its first line that is not blank, or all that can be
/// in one row.
fn header_in(reader: &mut impl Read) -> io::Result<Vec<u8>> {
    let mut begin = Vec::new();
    let mut chunk = vec![0; BUFFER_BYTES];
    while !header_of(&begin).1 && begin.len() as u64 <= sizes::ROW_BYTES {
        match reader.read(&mut chunk) {
            Ok(0) => break,
            Ok(count) => begin.extend_from_slice(&chunk[..count]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(begin)
}

/// The first line of `text` that is not blank, and whether it ends there.
fn header_of(text: &[u8]) -> (&[u8], bool) {
    const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();
    let is_break = |byte: &u8| matches!(byte, b'\r' | b'\n');
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    let begin = text.iter().position(|byte| !is_break(byte)).unwrap_or(text.len());
    let header = &text[begin..];
    let end = header.iter().position(is_break);
    (&header[..end.unwrap_or(header.len())], end.is_some())
}

/// The byte that separates the fields of the first line in `text`: the one of comma, semicolon and tab that
/// is there most.
fn separator(text: &[u8]) -> u8 {
    let header = header_of(text).0;
    let count = |separator: u8| header.split(|&byte| byte == separator).count();
    // Of several that are there as often it is the last, the comma.
    [b'\t', b';', b','].into_iter().max_by_key(|&separator| count(separator)).unwrap_or(b',')
}

/// `field` with a point in place of its comma if that makes it a number.
fn with_decimal_point(field: &[u8]) -> Vec<u8> {
    let pointed: Vec<u8> = field.iter().map(|&byte| if byte == b',' { b'.' } else { byte }).collect();
    let is_number = std::str::from_utf8(&pointed).is_ok_and(|text| text.trim_ascii().parse::<f64>().is_ok());
    if is_number { pointed } else { field.to_owned() }
}

/// A reader that remembers what it gave last.
struct Tap<R> {
    inner: R,
    chunk: Vec<u8>,
    bytes: u64,
    has_ended: bool,
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
    const fn new(inner: R) -> Self {
        Self { inner, chunk: Vec::new(), bytes: 0, has_ended: false, row: (0, 1), is_begun: false }
    }

    /// Notes that a row is read now, from `start` in the file, which is in this `line`.
    const fn begin_row(&mut self, start: u64, line: u64) {
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
        let most = sizes::ROW_BYTES >> 20;
        let problem =
            format!("the row that starts in line {line} is longer than {most} MB, the limit for a row");
        Err(io::Error::new(io::ErrorKind::InvalidData, problem))
    }

    /// Returns the bytes that it gave last, before `position` in the file.
    fn before(&self, position: u64) -> &[u8] {
        self.chunk.split_at(self.place(position)).0
    }

    /// Returns the bytes that it gave last, from `position` in the file on.
    fn after(&self, position: u64) -> &[u8] {
        self.chunk.split_at(self.place(position)).1
    }

    fn place(&self, position: u64) -> usize {
        // csv buffers nothing but what it was given last, so `position` is within it.
        self.chunk.len() - (self.bytes - position) as usize
    }
}

/// The columns' names, and the cells under them.
#[derive(Debug)]
pub struct Names(ByteRecord);

impl Names {
    /// The names in the first row.
    pub fn new(row: ByteRecord) -> Result<Self, HeaderError> {
        if row.is_empty() { Err(HeaderError::Empty) } else { Ok(Self(row)) }
    }

    /// The place of the column `name`, blanks around it aside.
    pub fn place(&self, name: &'static str) -> Result<Option<usize>, HeaderError> {
        let mut places = (0..self.0.len()).filter(|&place| self.0[place].trim_ascii() == name.as_bytes());
        let (first, second) = (places.next(), places.next());
        match (first, second) {
            (Some(first), Some(second)) => {
                Err(HeaderError::Duplicate { name, first: first + 1, second: second + 1 })
            }
            _ => Ok(first),
        }
    }

    /// The names that begin with `prefix`, blanks around them aside; legible.
    pub fn that_begin_with<'a>(&'a self, prefix: &'a str) -> impl Iterator<Item = String> + 'a {
        let names = self.0.iter().map(<[u8]>::trim_ascii);
        names.filter(|name| name.starts_with(prefix.as_bytes())).map(legible)
    }

    /// The place of the column `name`, one of those `needed`.
    pub fn needed_place(&self, name: &'static str, needed: &'static str) -> Result<usize, HeaderError> {
        self.place(name)?.ok_or_else(|| self.missing(name, needed))
    }

    /// Returns the error for a missing column `name`, one of those `needed`.
    pub fn missing(&self, name: &'static str, needed: &'static str) -> HeaderError {
        let found = self.0.iter().map(legible).collect::<Vec<_>>().join(", ");
        HeaderError::Missing { name, needed, found: messages::excerpt(&found) }
    }

    /// Refuses a row that has not as many fields as there are names.
    pub fn check_length(&self, row: &ByteRecord) -> Result<(), RowError> {
        let (fields, columns) = (row.len(), self.0.len());
        if fields < columns {
            let column = legible(&self.0[fields]);
            return Err(RowError::TooShort { fields, columns, column });
        }
        if fields > columns {
            let value = legible(&row[columns]);
            return Err(RowError::TooLong { fields, columns, value });
        }
        Ok(())
    }

    /// Returns the error for a number at `place` in `row` that is outside `range`.
    #[must_use]
    pub fn out_of_range(&self, row: &ByteRecord, place: usize, range: &'static str) -> RowError {
        RowError::OutOfRange { column: legible(&self.0[place]), value: legible(&row[place]), range }
    }

    /// The number at `place` in `row`.
    pub fn number(&self, row: &ByteRecord, place: usize) -> Result<f64, RowError> {
        let fault = |problem| RowError::Value {
            column: legible(&self.0[place]),
            value: legible(&row[place]),
            problem,
        };
        let text = row[place].trim_ascii();
        if text.is_empty() {
            return Err(fault("is empty; it should be a number"));
        }
        let number = std::str::from_utf8(text).ok().and_then(|text| text.parse::<f64>().ok());
        match number {
            Some(number) if number.is_finite() => Ok(number),
            Some(_) => Err(fault(NOT_FINITE)),
            None => Err(fault("is not a number; it should be one such as 0.9 or 1e-3")),
        }
    }

    /// Returns `number`, a value of the column at `place`, if it is finite.
    #[inline]
    pub fn finite(&self, number: f64, place: usize) -> Result<f64, RowError> {
        if number.is_finite() {
            return Ok(number);
        }
        let (column, value) = (legible(&self.0[place]), number.to_string());
        Err(RowError::Value { column, value, problem: NOT_FINITE })
    }
}

/// The problem with an infinite number, or with none.
const NOT_FINITE: &str = "is not finite; it should be a number that a 64-bit float can hold";

/// A header that does not say where the inputs are, each of them once.
#[derive(Debug, PartialEq, Error)]
pub enum HeaderError {
    /// There is no row at all.
    #[error("there is no header; it should name the columns, as in beta,d,y,z,T")]
    Empty,
    /// A column is not there.
    #[error("column {name} is missing; the header should name {needed}, and it names {found}")]
    Missing {
        /// The first needed column that the header does not name.
        name: &'static str,
        /// Names of the columns that are needed.
        needed: &'static str,
        /// Names of the columns that exist.
        found: String,
    },
    /// A column is there twice.
    #[error("column {name} is there twice, as fields {first} and {second}; it should be there once")]
    Duplicate {
        /// The name that two fields have.
        name: &'static str,
        /// First place of the column, from 1.
        first: usize,
        /// Second place of the column, from 1.
        second: usize,
    },
}

/// A row that disagrees with its header.
#[derive(Debug, PartialEq, Error)]
pub enum RowError {
    /// Fields are missing at its end.
    #[error("column {column} has no value; the row has {fields} of {columns} fields")]
    TooShort {
        /// Number of fields in the row.
        fields: usize,
        /// Number of fields in the header.
        columns: usize,
        /// The first column without a value.
        column: String,
    },
    /// There are more fields than columns.
    #[error("\"{value}\" belongs to no column; the row has {fields} fields, and should have {columns}")]
    TooLong {
        /// Number of fields in the row.
        fields: usize,
        /// Number of fields in the header.
        columns: usize,
        /// The first value without a column.
        value: String,
    },
    /// The file ends inside a quoted field.
    #[error("the quote that opens \"{value}\" is never closed")]
    Unclosed {
        /// Beginning of the field, after its quote.
        value: String,
    },
    /// A value is a number that it cannot be.
    #[error("column {column}: {value} is out of range: it must be {range}")]
    OutOfRange {
        /// Name of the column.
        column: String,
        /// The field, as it stands in the file.
        value: String,
        /// The values that it may have, in words.
        range: &'static str,
    },
    /// A value is no finite number.
    #[error("column {column}: \"{value}\" {problem}")]
    Value {
        /// Name of the column.
        column: String,
        /// The field, as it stands in the file.
        value: String,
        /// Problem with the value, in words.
        problem: &'static str,
    },
}

/// `field` as it can stand in a message.
fn legible(field: &[u8]) -> String {
    messages::excerpt(&String::from_utf8_lossy(field.trim_ascii()).escape_debug().to_string())
}
