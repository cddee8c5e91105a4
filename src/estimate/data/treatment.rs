//! What was done to a file before it was fitted, in one line.

use std::fmt::Write as _;

use super::headings::Column;
use crate::files::csv_in::Preamble;

/// What was read in another way than it stands in the file, and what was left out.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Treatment {
    pub(super) notes: Vec<String>,
    /// Rows that are comments.
    pub comments: usize,
    /// Rows of empty fields.
    pub empty_rows: usize,
    /// Rows with readings and without their time.
    pub timeless: usize,
    /// Readings that were not taken.
    pub missing: usize,
}

impl Treatment {
    /// Notes what stands before the header.
    pub fn note_preamble(&mut self, Preamble { is_utf16, lines, has_text, is_commented }: Preamble) {
        if is_utf16 {
            self.notes.push("read as UTF-16".to_owned());
        }
        if is_commented {
            self.notes.push("the header is a comment".to_owned());
        }
        if has_text {
            self.notes.push(format!("{} passed over before the header", counted(lines, "line")));
        }
    }

    /// Notes the units that are turned into others, of columns by these names.
    pub fn note_units(&mut self, columns: impl Iterator<Item = (&'static str, Column)>) {
        let mut turned: Vec<(&str, &str, Vec<&str>)> = Vec::new();
        for (name, column) in columns {
            let Some(unit) = column.unit.filter(|unit| unit.factor != 1.0) else { continue };
            match turned.iter_mut().find(|(from, ..)| *from == unit.name) {
                Some((.., names)) => names.push(name),
                None => turned.push((unit.name, unit.base, vec![name])),
            }
        }
        for (from, to, names) in turned {
            self.notes.push(format!("{} converted from {from} to {to}", names.join(", ")));
        }
    }

    /// Says what was done; `None` where the file was read as it stands.
    #[must_use]
    pub fn sentence(&self) -> Option<String> {
        let mut sentence = self.notes.join("; ");
        for (count, what, done) in [
            (self.comments, "comment", "passed over"),
            (self.empty_rows, "row of empty fields", "passed over"),
            (self.timeless, "row without a time", "left out"),
            (self.missing, "reading not taken", "left out"),
        ] {
            if count > 0 {
                let apart = if sentence.is_empty() { "" } else { "; " };
                // Writing into a string does not fail.
                let _ = write!(sentence, "{apart}{} {done}", counted(count as u64, what));
            }
        }
        Some(sentence).filter(|sentence| !sentence.is_empty())
    }
}

/// The number and the noun, whose first word takes the plural.
fn counted(count: u64, noun: &str) -> String {
    if count == 1 {
        return format!("1 {noun}");
    }
    let (first, rest) =
        noun.split_once(' ').map_or((noun, String::new()), |(first, rest)| (first, format!(" {rest}")));
    format!("{count} {first}s{rest}")
}
