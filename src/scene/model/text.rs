//! The text of OBJ files and their material libraries, as programs and people write it: statements, whatever
//! the encoding and the line ends.

use std::borrow::Cow;
use std::io::Read as _;
use std::str::Lines;

use crate::files::utf16::Decoded;

/// Returns the text of a file without the mark at its beginning, its lines ended by line feeds: UTF-8, UTF-16
/// after a mark, and a line in another encoding letter by letter, as in Latin-1.
pub fn text_of(bytes: &[u8]) -> Cow<'_, str> {
    let text = match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => from_utf16(bytes).into(),
        [0xef, 0xbb, 0xbf, rest @ ..] => from_bytes(rest),
        _ => from_bytes(bytes),
    };
    let is_alone = |(place, _)| text.as_bytes().get(place + 1) != Some(&b'\n');
    if text.match_indices('\r').any(is_alone) {
        return text.replace("\r\n", "\n").replace('\r', "\n").into();
    }
    text
}

fn from_utf16(bytes: &[u8]) -> String {
    let mut text = String::new();
    // From memory: reading does not fail.
    let _ = Decoded::new(bytes).and_then(|mut decoded| decoded.read_to_string(&mut text));
    text
}

fn from_bytes(bytes: &[u8]) -> Cow<'_, str> {
    if let Ok(text) = std::str::from_utf8(bytes) {
        return text.into();
    }
    let mut text = String::with_capacity(bytes.len());
    for line in bytes.split_inclusive(|byte| matches!(byte, b'\n' | b'\r')) {
        match std::str::from_utf8(line) {
            Ok(line) => text.push_str(line),
            Err(_) => text.extend(letters(line)),
        }
    }
    text.into()
}

/// Returns the letters of a line that is not UTF-8, one for each byte: equal names stay equal, and others
/// differ.
fn letters(line: &[u8]) -> impl Iterator<Item = char> {
    let end = line.trim_ascii_end().len();
    // In Shift JIS the second byte of a letter may be that of a backslash, which would continue the line.
    let is_half = move |at: usize| at + 1 == end && line[at] == b'\\' && at > 0 && !line[at - 1].is_ascii();
    line.iter().enumerate().map(move |(at, &byte)| if is_half(at) { '¥' } else { char::from(byte) })
}

/// The statements of a text: its lines, those joined that a backslash at their end continues.
pub struct Statements<'a> {
    lines: Lines<'a>,
    read: usize,
}

impl<'a> Statements<'a> {
    /// Returns the statements of `text`.
    pub fn new(text: &'a str) -> Self {
        Self { lines: text.lines(), read: 0 }
    }
}

impl<'a> Iterator for Statements<'a> {
    /// A statement, and the number of its first line, from 1.
    type Item = (usize, Cow<'a, str>);

    fn next(&mut self) -> Option<Self::Item> {
        let line = self.lines.next()?;
        self.read += 1;
        let (first, mut statement) = (self.read, Cow::from(line));
        // The name of a folder may end a comment.
        while statement.ends_with('\\') && !statement.contains('#') {
            let joined = statement.to_mut();
            joined.pop();
            let Some(line) = self.lines.next() else { break };
            joined.extend([" ", line]);
            self.read += 1;
        }
        Some((first, statement))
    }
}

/// Returns the first word of a statement, and the name after it: without a comment, blanks around it and
/// quotation marks.
pub fn word_and_name(statement: &str) -> (&str, &str) {
    let statement = statement.trim();
    let (word, rest) = statement.split_once(char::is_whitespace).unwrap_or((statement, ""));
    let is_comment = |&(place, _): &(usize, &str)| rest[..place].ends_with(char::is_whitespace) || place == 0;
    let end = rest.match_indices('#').find(is_comment).map_or(rest.len(), |(place, _)| place);
    let name = rest[..end].trim();
    (word, name.strip_prefix('"').and_then(|name| name.strip_suffix('"')).unwrap_or(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn statements(text: &str) -> Vec<(usize, String)> {
        Statements::new(text).map(|(line, statement)| (line, statement.into_owned())).collect()
    }

    #[test]
    fn marks_line_ends_and_encodings_do_not_change_a_text() {
        let text = "v 1 2 3\nusemtl Größe\nf 1 2 3\n";
        let marked = [&b"\xef\xbb\xbf"[..], text.as_bytes()].concat();
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        let latin: Vec<u8> = text.chars().map(|letter| u32::from(letter) as u8).collect();
        let files = [
            text.as_bytes().to_vec(),
            marked,
            [&b"\xff\xfe"[..], &little].concat(),
            [&b"\xfe\xff"[..], &big].concat(),
            latin,
            text.replace('\n', "\r").into_bytes(),
        ];
        for file in files {
            assert_eq!(text_of(&file), text, "{file:?}");
        }
        let windows = text.replace('\n', "\r\n");
        assert_eq!(text_of(windows.as_bytes()), windows);
        assert_eq!(statements(&windows), statements(text));
        // One line of another encoding does not change the others.
        assert_eq!(text_of("# \u{fc}\n# x\n".as_bytes()), "# ü\n# x\n");
        assert_eq!(text_of(b"# \xfc\n# \xc3\xbc\n"), "# ü\n# ü\n");
        // Two letters of Shift JIS.
        assert_eq!(statements(&text_of(b"g \x95\x5c\nv 1")).len(), 2);
    }

    #[test]
    fn a_backslash_continues_a_line_and_no_comment() {
        assert_eq!(statements("f 1 2\\\r\n3\\\n 4\nv"), [(1, "f 1 2 3  4".to_owned()), (4, "v".to_owned())]);
        assert_eq!(statements("# C:\\models\\\nv 1").len(), 2);
        assert_eq!(statements("v 1 \\"), [(1, "v 1 ".to_owned())]);
    }

    #[test]
    fn names_may_have_blanks_and_number_signs() {
        for (statement, name) in [
            ("usemtl  a b \t# c", "a b"),
            ("usemtl a#2", "a#2"),
            ("usemtl \"a b\"", "a b"),
            ("usemtl #a", ""),
            ("usemtl", ""),
        ] {
            assert_eq!(word_and_name(statement), ("usemtl", name), "{statement}");
        }
    }
}
