//! The files of the answers that were given in lessons, one for each lesson. Each answer is written when it
//! is given; of two windows in one lesson the later one's answers count, and it says so.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};

use gamow_platform::files;

use super::kept_file::KeptFile;
use crate::lesson::{Answers, LessonProgress};

/// The name of the folder of these files.
pub const FOLDER: &str = "answers";

/// The files of a folder, and how much of the answers is in them.
#[derive(Debug)]
pub struct AnswersFiles {
    folder: PathBuf,
    /// By the keys of their lessons.
    files: BTreeMap<String, KeptFile>,
    /// The answers that there was an attempt to write.
    attempted: Answers,
}

impl AnswersFiles {
    /// The files of answers in `folder`, none of them read yet.
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.join(FOLDER), files: BTreeMap::new(), attempted: Answers::default() }
    }

    /// Whether `answers` has an answer that nobody has tried to write.
    pub fn lacks_an_answer(&self, answers: &Answers) -> bool {
        answers.all().any(|way| way.is_further_than(self.attempted.of(way.key())))
    }

    /// Whether `answers` has an entry that nobody has tried to write, be it half entered.
    pub fn lacks_an_entry(&self, answers: &Answers) -> bool {
        self.attempted != *answers
    }

    /// Reads the answers that the last window has left, and adds a message to `problems` for each file that
    /// holds none.
    pub fn load(&mut self, problems: &mut Vec<String>) -> Answers {
        let mut paths = files::list_folder(&self.folder).unwrap_or_default();
        paths.retain(|path| path.extension().is_some_and(|ending| ending == "json"));
        for path in paths {
            let mut file = KeptFile::new(path);
            let read = file.read().and_then(|text| {
                serde_json::from_str::<LessonProgress>(&text.unwrap_or_default())
                    .map_err(|problem| format!("it holds no answers ({problem})"))
            });
            match read {
                Ok(way) => {
                    self.files.insert(way.key().to_owned(), file);
                    self.attempted.set(way);
                }
                Err(problem) => {
                    let begin = "This window starts without the answers in";
                    problems.push(format!("{begin} {}: {problem}. {}", file.shown(), file.set_aside()));
                }
            }
        }
        self.attempted.clone()
    }

    /// Writes `answers`, and adds a message to `replaced` for each file that another window has written
    /// since.
    ///
    /// # Errors
    /// The path and the reason why some are not written; that file is then as it was.
    pub fn write(&mut self, answers: &Answers, replaced: &mut Vec<String>) -> Result<(), String> {
        self.attempted = answers.clone();
        let mut failure = None;
        for way in answers.all() {
            let new = || KeptFile::new(self.folder.join(file_name(way.key())));
            let file = self.files.entry(way.key().to_owned()).or_insert_with(new);
            let text = serde_json::to_string(way).unwrap_or_default() + "\n";
            if !file.holds(&text) && file.was_changed(&text) {
                let begin = "Another window has written answers in this lesson since; those of this window replace them.";
                replaced.push(format!("{begin} {}", file.set_aside()));
            }
            failure = file.write(&text).err().or(failure);
        }
        failure.map_or(Ok(()), Err)
    }
}

/// Returns the name of the file of the lesson with this `key`: a name of ours, or the path of somebody's own
/// lesson.
fn file_name(key: &str) -> String {
    if key.chars().all(|letter| letter.is_ascii_lowercase() || letter == '-') {
        return format!("{key}.json");
    }
    let mut hasher = DefaultHasher::new();
    key.hash(&mut hasher);
    format!("{:016x}.json", hasher.finish())
}
