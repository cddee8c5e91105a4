//! The answers of many pupils, found in any text.

use std::collections::BTreeMap;
use std::io::Read as _;
use std::path::Path;

use anyhow::Context as _;
use gamow_platform::sizes::FILE_BYTES;

use super::pupil::PupilAnswers;
use super::token::{KEY, TokenError};
use crate::files::csv_in;
use crate::files::utf16::Decoded;

/// Greatest number of answers on one page.
const MOST: usize = 1000;
/// Greatest number of links that cannot be read and are named.
const MOST_UNREAD: usize = 1000;

/// Answers that were found.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Collected {
    /// The answers, in the order in which they were found.
    pub answers: Vec<PupilAnswers>,
    /// The links that could not be read.
    pub unread: Vec<Unread>,
    /// Number of answers that were left out since the same pupil has handed in later ones to the same lesson.
    pub replaced: usize,
    /// Number of answers that were left out since there are too many.
    pub beyond: usize,
    /// The place of each pupil's answers to a lesson among all.
    places: BTreeMap<String, usize>,
}

/// A link that could not be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unread {
    /// Name of the text that contains the link; empty if there is only one text.
    pub source: String,
    /// Number of its line there, from 1.
    pub line: usize,
    /// Why it could not be read.
    pub problem: TokenError,
}

impl std::fmt::Display for Unread {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { source, line, problem } = self;
        if source.is_empty() {
            write!(f, "line {line}: {problem}")
        } else {
            write!(f, "{source}:{line}: {problem}")
        }
    }
}

impl Collected {
    /// The answers in one `text`.
    #[must_use]
    pub fn from_text(text: &str) -> Self {
        let mut collected = Self::default();
        collected.add("", text);
        collected
    }

    /// Adds the answers in `text`, called `source` in messages: links anywhere in it, one a line or beside
    /// other words, in quotes, in a column, in the pages of reports. Of one pupil's to one lesson the last
    /// remain.
    pub fn add(&mut self, source: &str, text: &str) {
        for (number, line) in text.lines().enumerate() {
            for token in tokens(line) {
                match PupilAnswers::from_token(token) {
                    Ok(answers) => self.take(token, answers),
                    Err(problem) if self.unread.len() < MOST_UNREAD => {
                        self.unread.push(Unread { source: source.to_owned(), line: number + 1, problem });
                    }
                    Err(_) => {}
                }
            }
        }
    }

    /// Adds the answers in the file at `path`; of `-` those in standard input. Bytes that are no text are
    /// passed over.
    ///
    /// # Errors
    /// A file that cannot be read, or is larger than 64 MiB.
    pub fn add_file(&mut self, path: &Path) -> anyhow::Result<()> {
        let (name, reader) = csv_in::open(Some(path))?;
        let mut bytes = Vec::new();
        let read = Decoded::new(reader).and_then(|text| text.take(FILE_BYTES + 1).read_to_end(&mut bytes));
        read.with_context(|| name.clone())?;
        anyhow::ensure!(
            bytes.len() as u64 <= FILE_BYTES,
            "{name}: it is larger than {} MiB",
            FILE_BYTES >> 20
        );
        // The page is no place for the folders of its maker.
        let name = path
            .file_name()
            .filter(|name| *name != "-")
            .map_or(name, |name| name.to_string_lossy().into_owned());
        self.add(&name, &String::from_utf8_lossy(&bytes));
        Ok(())
    }

    fn take(&mut self, token: &str, answers: PupilAnswers) {
        let PupilAnswers { lesson, name, .. } = &answers;
        // The same link without a name may be found twice.
        let key =
            if name.is_empty() { token.to_owned() } else { format!("{lesson}\n{}", name.to_lowercase()) };
        if let Some(&place) = self.places.get(&key) {
            self.answers[place] = answers;
            self.replaced += 1;
        } else if self.answers.len() < MOST {
            self.places.insert(key, self.answers.len());
            self.answers.push(answers);
        } else {
            self.beyond += 1;
        }
    }

    /// Returns the answers to the lesson of this name.
    pub fn of<'a>(&'a self, lesson: &'a str) -> impl Iterator<Item = &'a PupilAnswers> {
        self.answers.iter().filter(move |answers| answers.lesson == lesson)
    }
}

/// The tokens in `line`: behind the word of a link, which may have been put into another link.
fn tokens(line: &str) -> impl Iterator<Item = &str> {
    line.match_indices(KEY).filter_map(|(place, word)| {
        let rest = &line[place + word.len()..];
        let rest = ["=", "%3D", "%3d"].iter().find_map(|sign| rest.strip_prefix(sign))?;
        let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '-' || c == '_'));
        Some(&rest[..end.unwrap_or(rest.len())]).filter(|token| !token.is_empty())
    })
}

#[cfg(test)]
mod tests;
