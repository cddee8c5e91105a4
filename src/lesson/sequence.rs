//! A presenter's own sequence: presets, states, links and lessons in an order of one's own, from a text file.

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use gamow_platform::{files, messages};

use super::error::LessonError;
use super::library::Library;
use super::plan::Lesson;
use crate::settings::{Preset, Settings, is_link};
use crate::similar::nearest;

/// A sequence of things to show.
#[derive(Debug, Clone, PartialEq)]
pub struct Sequence {
    /// Name of the file, without its folder.
    pub name: String,
    /// Everything that is shown, in its order; at least one.
    entries: Vec<SequenceEntry>,
}

/// A line of a sequence.
#[derive(Debug, Clone, PartialEq)]
pub enum SequenceEntry {
    /// A preset.
    Preset(&'static Preset),
    /// A state: the path of its file, or a link.
    State(PathBuf),
    /// A lesson: the numbers of its steps, from 0. That behind the last is its end.
    Lesson(Arc<Lesson>, RangeInclusive<usize>),
}

/// The form of a line, for messages.
const FORM: &str = "a line is the name of a preset, a file of a state with its ending, a link (gamow:?…), or \
    `lesson NAME` with the number of a step, as in `lesson rods 2`";

/// The word that begins the line of a lesson.
const LESSON: &str = "lesson";
/// Greatest number of entries.
const MOST: usize = 1000;

impl Sequence {
    /// Reads the sequence in the file at `path`, whose lessons are in `library`.
    ///
    /// # Errors
    /// The file cannot be read, or a line names nothing that there is.
    pub fn load(path: &Path, library: &Library) -> Result<Self, LessonError> {
        let source_name = files::shown(path);
        let text = files::read_to_string(path).map_err(|reason| LessonError::Read {
            source_name: source_name.clone(),
            what: "sequence",
            reason: reason.to_string(),
        })?;
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let folder = path.parent().unwrap_or(Path::new(""));
        let lines = text.lines().enumerate().map(|(number, line)| (number + 1, without_comment(line)));
        let mut entries = Vec::new();
        for (line, text) in lines.filter(|(_, text)| !text.is_empty()) {
            let wrong = |problem| LessonError::Content { source_name: source_name.clone(), line, problem };
            entries.push(SequenceEntry::read(text, folder, library).map_err(wrong)?);
            if entries.len() > MOST {
                return Err(wrong(format!(
                    "this would be number {}, and a sequence has at most {MOST}",
                    entries.len()
                )));
            }
        }
        if entries.is_empty() {
            let problem = format!("the sequence is empty: {FORM}");
            return Err(LessonError::Content { source_name, line: 1, problem });
        }
        Ok(Self { name, entries })
    }

    /// Returns the number of entries.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.entries.len()
    }

    /// Returns the entry of this number, from 0.
    #[must_use]
    pub fn entry(&self, number: usize) -> Option<&SequenceEntry> {
        self.entries.get(number)
    }
}

impl SequenceEntry {
    /// Reads the entry in a line's `text`, whose files are named from `folder`.
    fn read(text: &str, folder: &Path, library: &Library) -> Result<Self, String> {
        if is_link(Path::new(text)) {
            return state(PathBuf::from(text));
        }
        if let Some(rest) = text.strip_prefix(LESSON).filter(|rest| rest.starts_with(char::is_whitespace)) {
            return lesson(rest.trim(), folder, library);
        }
        if let Some(preset) = Preset::all().iter().find(|preset| preset.name == text) {
            return Ok(Self::Preset(preset));
        }
        let path = folder.join(text);
        if files::is_file(&path) {
            let is_lesson = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("md"));
            return if is_lesson { lesson(text, folder, library) } else { state(path) };
        }
        let named = messages::excerpt(text);
        if library.all().iter().any(|lesson| lesson.name == text) {
            return Err(format!("`{named}` is a lesson: write `{LESSON} {named}`"));
        }
        if text.contains(['.', '/']) {
            return Err(format!("there is no file {}: {FORM}", files::shown(&path)));
        }
        let known = nearest(Preset::all().iter().map(|preset| preset.name), text);
        Err(format!("no preset is called `{named}`, the nearest are {known}: {FORM}"))
    }
}

/// The state in the file at `path`, or in a link, if it can be shown.
fn state(path: PathBuf) -> Result<SequenceEntry, String> {
    Settings::default().with_file(&path).map_err(|error| error.to_string())?;
    Ok(SequenceEntry::State(path))
}

/// The lesson in `text`: its name or its file, and the number of a step, of several (`2-4`), or none for all.
fn lesson(text: &str, folder: &Path, library: &Library) -> Result<SequenceEntry, String> {
    let is_number = |word: &&str| word.chars().all(|sign| sign.is_ascii_digit() || sign == '-');
    let words = text.rsplit_once(char::is_whitespace).filter(|(_, last)| is_number(last));
    let (name, steps) = words.map_or((text, None), |(name, steps)| (name.trim_end(), Some(steps)));
    let path = folder.join(name);
    let opened = if files::is_file(&path) { library.open(&path) } else { library.open(name) };
    let lesson = opened.map_err(|error| error.to_string())?;
    let count = lesson.steps.len();
    let Some(steps) = steps else { return Ok(SequenceEntry::Lesson(lesson, 0..=count)) };
    let (from, to) = steps.split_once('-').unwrap_or((steps, steps));
    let number = |text: &str| text.parse::<usize>().ok().filter(|number| (1..=count).contains(number));
    match (number(from), number(to)) {
        (Some(from), Some(to)) if from <= to => Ok(SequenceEntry::Lesson(lesson, from - 1..=to - 1)),
        _ => Err(format!("{} has the steps 1 to {count}, and no {steps}", lesson.name)),
    }
}

/// What stands in a `line` before a `#` that begins it or a word of it, without spaces around it.
fn without_comment(line: &str) -> &str {
    let begins = |(at, sign): &(usize, char)| {
        *sign == '#' && line[..*at].chars().next_back().is_none_or(char::is_whitespace)
    };
    let end = line.char_indices().find(begins).map_or(line.len(), |(at, _)| at);
    line[..end].trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn load(text: &str) -> Result<Sequence, String> {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |name: &str, text: &str| {
            std::fs::write(folder.path().join(name), text).expect("it is written");
        };
        write("mine.toml", "[motion]\nbeta = 0.5\n");
        write("broken.toml", "[motion]\nbeta = 1.5\n");
        write("my.md", "---\ntitle: Mine\n---\n\n## One\n\nLook.\n");
        write("lecture.txt", text);
        Sequence::load(&folder.path().join("lecture.txt"), &Library::own()).map_err(|error| error.to_string())
    }

    #[test]
    fn a_sequence_has_presets_states_links_and_lessons_in_its_order() {
        let text = "# My lecture\n\nstreet   # to begin with\nmine.toml\ngamow:?beta=0.99&scene=globe\n  lesson rods 2\n\
            lesson rods 2-4\nlesson clocks\nlesson my.md\nstreet\n";
        let sequence = load(text).expect("all of it is there");
        let told = (0..sequence.count()).map(|number| match sequence.entry(number).expect("counted") {
            SequenceEntry::Preset(preset) => preset.name.to_owned(),
            SequenceEntry::State(path) => path.file_name().expect("a name").to_string_lossy().into_owned(),
            SequenceEntry::Lesson(lesson, steps) => format!("{} {steps:?}", lesson.name),
        });
        let expected = [
            "street",
            "mine.toml",
            "gamow:?beta=0.99&scene=globe",
            "rods 1..=1",
            "rods 1..=3",
            "clocks 0..=4",
            "my 0..=1",
            "street",
        ];
        assert_eq!(told.collect::<Vec<_>>(), expected);
        assert_eq!(sequence.name, "lecture.txt");
    }

    #[test]
    fn errors_name_the_line_and_what_would_be_right() {
        for (text, told) in [
            (
                "street\n\nstret\n",
                &["lecture.txt:3: ", "no preset is called `stret`", "street", "a line is"][..],
            ),
            ("rods", &["lecture.txt:1: ", "`rods` is a lesson: write `lesson rods`"]),
            ("#\nlesson rods 5", &["lecture.txt:2: ", "rods has the steps 1 to 4, and no 5"]),
            ("lesson rods 0", &["steps 1 to 4, and no 0"]),
            ("lesson rods 3-2", &["steps 1 to 4, and no 3-2"]),
            ("lesson rots", &["lecture.txt:1: ", "no lesson is called `rots`"]),
            ("mime.toml", &["lecture.txt:1: ", "there is no file", "mime.toml"]),
            ("broken.toml", &["lecture.txt:1: ", "broken.toml:2", "below 1"]),
            ("gamow:?beta=2", &["lecture.txt:1: ", "below 1"]),
            ("# nothing\n\n", &["lecture.txt:1: ", "the sequence is empty"]),
        ] {
            let error = load(text).expect_err(text);
            assert!(!error.contains('\n'), "{error}");
            for part in told {
                assert!(error.contains(part), "{part} in {error}");
            }
        }
        assert!(load(&"street\n".repeat(MOST + 1)).expect_err("too long").contains("at most 1000"));
    }
}
