//! The file of the answers that were given in lessons. Each answer is written when it is given, after what another window has
//! written meanwhile has been merged with it.

use std::path::{Path, PathBuf};
use std::time::Duration;

use gamow_platform::{files, locks};

use super::kept_file::KeptFile;
use crate::lesson::{Answers, Timestamp};

/// The name of the file of answers.
pub const NAME: &str = "answers.json";
/// The file that is locked while it is read and written. It is another one, since each writing replaces the first.
const LOCK: &str = "answers.lock";
/// The longest wait for another window, which takes milliseconds to write.
const LONGEST: Duration = Duration::from_secs(2);

/// The file, and how much of it is written.
#[derive(Debug)]
pub struct AnswersFile {
    file: KeptFile,
    lock: PathBuf,
    /// The date of the latest entry that was written.
    written: Timestamp,
    /// The dates of the latest answer and of the latest entry that there was an attempt to write.
    attempted: [Timestamp; 2],
}

impl AnswersFile {
    /// The one in `folder`.
    pub fn new(folder: &Path) -> Self {
        Self { file: KeptFile::new(folder, NAME), lock: folder.join(LOCK), written: 0, attempted: [0; 2] }
    }

    /// Whether `answers` has an answer that nobody has tried to write.
    pub fn lacks_an_answer(&self, answers: &Answers) -> bool {
        answers.latest_answer() > self.attempted[0]
    }

    /// Whether `answers` has an entry that nobody has tried to write, be it half entered.
    pub fn lacks_an_entry(&self, answers: &Answers) -> bool {
        answers.latest() > self.attempted[1]
    }

    /// Whether `answers` has anything that is not written.
    pub fn lacks_anything(&self, answers: &Answers) -> bool {
        answers.latest() > self.written
    }

    /// Reads the answers that the last window has left, and a message if they cannot be read.
    pub fn load(&mut self) -> (Answers, Option<String>) {
        let (answers, message) = self.read();
        self.written = answers.latest();
        self.attempted = [answers.latest_answer(), self.written];
        (answers, message)
    }

    fn read(&mut self) -> (Answers, Option<String>) {
        let read = self.file.read().and_then(|text| match text {
            Some(text) => {
                Answers::of_text(&text).map_err(|problem| format!("it holds no answers ({problem})"))
            }
            None => Ok(Answers::default()),
        });
        match read {
            Ok(answers) => (answers, None),
            Err(problem) => {
                let where_it_is = self.file.set_aside();
                let text = format!(
                    "This window starts without the answers in lessons: {}: {problem}. {where_it_is}",
                    self.file.shown()
                );
                (Answers::default(), Some(text))
            }
        }
    }

    /// Merges `answers` with those in the file, and writes both. Also gives a message if the file could not be read.
    ///
    /// # Errors
    /// The path and the reason why they are not written; the file is then as it was.
    pub fn merge(&mut self, answers: &mut Answers) -> Result<Option<String>, String> {
        self.attempted = [answers.latest_answer(), answers.latest()];
        // A folder that is not there is made when the file is written, which also says why it cannot be.
        let _ = files::create_folder(files::folder_of(&self.lock));
        let lock = match locks::lock(&self.lock, LONGEST) {
            Err(error) if error.kind() == std::io::ErrorKind::WouldBlock => {
                return Err(format!("{}: {error}", files::shown(&self.lock)));
            }
            // Where there can be no lock, writing shows whether anything can be written.
            lock => lock.ok(),
        };
        let (kept, message) = self.read();
        answers.merge(&kept);
        if !(answers.is_empty() && kept.is_empty()) {
            self.file.write(&answers.to_text())?;
        }
        drop(lock);
        // Those of other windows, too, which are in the file already.
        self.written = answers.latest();
        self.attempted = [answers.latest_answer(), self.written];
        Ok(message)
    }
}
