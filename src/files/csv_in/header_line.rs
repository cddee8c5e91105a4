//! The line with the columns' names: where it is, and what separates its fields.

use std::io::{self, Read};

use csv::ByteRecord;
use gamow_platform::sizes;

use super::names::Names;

/// Marks of a line that is a comment.
pub const COMMENTS: [u8; 2] = *b"#%";
/// Lines with text among which the header is looked for.
const MOST_LINES: usize = 200;
/// Bytes that are read at a time.
const CHUNK_BYTES: usize = 1 << 16;
const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// Where the header begins, and what stands before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct HeaderLine {
    /// Place of its first byte, behind the mark of a comment.
    pub start: usize,
    /// The byte that separates its fields; a blank stands for any number of them.
    pub separator: u8,
    /// Number of lines before it.
    pub lines: u64,
    /// Whether any of these has text.
    pub has_text: bool,
    /// Whether it stands behind the mark of a comment.
    pub is_commented: bool,
}

/// Reads `reader` until the first line is there that `is_header`, and returns what was read and where that
/// line is.
///
/// A line behind a mark of a comment counts if the next one without is none.
pub(super) fn find(
    reader: &mut impl Read,
    is_header: impl Fn(&Names) -> bool,
) -> io::Result<(Vec<u8>, HeaderLine)> {
    let mut begin = Vec::new();
    let mut chunk = vec![0; CHUNK_BYTES];
    loop {
        let count = match reader.read(&mut chunk) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            other => other?,
        };
        let chunk = &chunk[..count];
        begin.extend_from_slice(chunk);
        let has_ended = count == 0 || begin.len() as u64 > sizes::ROW_BYTES;
        let has_break = chunk.iter().any(|byte| is_break(*byte));
        if (has_break || has_ended)
            && let Some(found) = header_in(&begin, has_ended, &is_header)
        {
            return Ok((begin, found));
        }
    }
}

/// The header in `text`; `None` if more has to be read to know.
fn header_in(text: &[u8], has_ended: bool, is_header: &impl Fn(&Names) -> bool) -> Option<HeaderLine> {
    let (mut commented, mut plain, mut first): (Option<HeaderLine>, _, _) = (None, None, None);
    for (number, (line, found)) in Lines::new(text).filter(|(line, ..)| !line.is_empty()).enumerate() {
        let is_whole = found.start + line.len() < text.len();
        if (!is_whole && !has_ended) || number == MOST_LINES {
            break;
        }
        let here = HeaderLine { has_text: number > 0, ..found };
        first.get_or_insert(HeaderLine { separator: most_frequent(line), ..here });
        let marks = line.iter().take_while(|byte| COMMENTS.contains(byte)).count();
        // A mark alone is the name of a column.
        let is_comment = marks > 0 && !matches!(line.get(marks), Some(b',' | b';' | b'\t'));
        if !is_comment {
            if let Some(separator) = separator(line, is_header) {
                return Some(HeaderLine { separator, ..here });
            }
            if commented.is_some() {
                return commented;
            }
            plain.get_or_insert(HeaderLine { separator: most_frequent(line), ..here });
            continue;
        }
        let marks = marks + line[marks..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        if let Some(separator) = separator(&line[marks..], is_header) {
            commented = Some(HeaderLine { start: here.start + marks, separator, is_commented: true, ..here });
        }
    }
    let is_enough = has_ended || Lines::new(text).filter(|(line, ..)| !line.is_empty()).count() > MOST_LINES;
    // There is none: what is wrong is said of the first line that may have been meant.
    let start = HeaderLine { start: 0, separator: b',', lines: 0, has_text: false, is_commented: false };
    is_enough.then(|| commented.or(plain).or(first).unwrap_or(start))
}

/// Lines of a text, each with its place; a mark of the byte order is passed over.
struct Lines<'a> {
    text: &'a [u8],
    place: usize,
    number: u64,
}

impl<'a> Lines<'a> {
    fn new(text: &'a [u8]) -> Self {
        Self {
            text,
            place: if text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 },
            number: 0,
        }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (&'a [u8], HeaderLine);

    fn next(&mut self) -> Option<Self::Item> {
        let rest = self.text.get(self.place..).filter(|rest| !rest.is_empty())?;
        let end = rest.iter().position(|byte| is_break(*byte)).unwrap_or(rest.len());
        let found = HeaderLine {
            start: self.place,
            separator: b',',
            lines: self.number,
            has_text: false,
            is_commented: false,
        };
        let ending = if rest[end..].starts_with(b"\r\n") { 2 } else { 1 };
        self.place += end + ending;
        self.number += u64::from(rest.get(end + ending - 1) == Some(&b'\n'));
        Some((&rest[..end], found))
    }
}

const fn is_break(byte: u8) -> bool {
    matches!(byte, b'\r' | b'\n')
}

/// The byte by which the fields of `line` are those of a header.
fn separator(line: &[u8], is_header: &impl Fn(&Names) -> bool) -> Option<u8> {
    [most_frequent(line), b' ']
        .into_iter()
        .find(|&separator| fields(line, separator).is_some_and(|row| is_header(&row)))
}

/// The one of comma, semicolon and tab that is there most.
fn most_frequent(line: &[u8]) -> u8 {
    let count = |separator: u8| line.split(|&byte| byte == separator).count();
    // Of several that are there as often it is the last, the comma.
    [b'\t', b';', b','].into_iter().max_by_key(|&separator| count(separator)).unwrap_or(b',')
}

fn fields(line: &[u8], separator: u8) -> Option<Names> {
    let mut csv = csv::ReaderBuilder::new().has_headers(false).delimiter(separator).from_reader(line);
    let mut row = ByteRecord::new();
    csv.read_byte_record(&mut row).ok().filter(|is_read| *is_read)?;
    Names::new(if separator == b' ' { without_blanks(&row) } else { row }).ok()
}

/// `row` without the empty fields between blanks; a unit in brackets belongs to the name before it.
pub(super) fn without_blanks(row: &ByteRecord) -> ByteRecord {
    let mut fields: Vec<Vec<u8>> = Vec::new();
    for field in row.iter().filter(|field| !field.is_empty()) {
        match fields.last_mut().filter(|_| matches!(field[0], b'(' | b'[')) {
            Some(name) => name.extend([b" ", field].concat()),
            None => fields.push(field.to_owned()),
        }
    }
    ByteRecord::from(fields)
}
