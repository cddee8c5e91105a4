//! The library of lessons: the program's own, those in a folder of the user's, and the presets, which are
//! lessons of one step.

use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

use gamow_platform::shipped::ShippedFile;
use gamow_platform::{files, shipped_file};

use super::error::LessonError;
use super::plan::Lesson;
use crate::scene::looks_like_a_name;
use crate::settings::Preset;
use crate::similar::did_you_mean;

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        [$((
            $name,
            include_str!(concat!("../../assets/lessons/", $name, ".md")),
            shipped_file!("assets/cards/", $name, ".jpg"),
        )),*]
    };
}

/// The names of the program's own, their files and the pictures of their cards, in their order.
const OWN: [(&str, &str, ShippedFile); 21] = files![
    "rods",
    "what-gamow-drew",
    "light-is-late",
    "turned",
    "colour",
    "headlight",
    "slide",
    "clocks",
    "two-eyes",
    "depth",
    "red-below",
    "measure-speed",
    "parallax",
    "ride-crowd",
    "ride-length",
    "ride-home",
    "ride-contracted",
    "ride-away",
    "ride-gate",
    "seasons",
    "goes-dark",
];

/// Returns the file of the picture on the card of the program's own lesson of this name.
pub(super) fn card(name: &str) -> Option<ShippedFile> {
    OWN.iter().find(|(own, ..)| *own == name).map(|(.., card)| *card)
}

/// The lessons that there are.
#[derive(Debug, Clone, PartialEq)]
pub struct Library {
    lessons: Vec<Arc<Lesson>>,
    /// Lessons of the folder that cannot be read, by name.
    pub refused: Vec<Refused>,
}

/// A chapter: lessons that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Chapter<'a> {
    /// Title of the chapter.
    pub title: &'a str,
    /// The chapter's lessons, each with its number among all lessons, from 1.
    pub lessons: Vec<(usize, &'a Arc<Lesson>)>,
}

/// A lesson of a folder that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused {
    /// The name of the refused file, without the extension.
    pub name: String,
    /// Why the file could not be read.
    pub error: LessonError,
}

static OWN_LIBRARY: LazyLock<Arc<Library>> = LazyLock::new(|| {
    Arc::new(Library::new(None).unwrap_or_else(|error| unreachable!("tests read every lesson: {error}")))
});

impl Library {
    /// Returns the program's own library.
    #[must_use]
    pub fn own() -> Arc<Self> {
        Arc::clone(&OWN_LIBRARY)
    }

    /// The program's own, and those in `folder`, if one is named; then the presets.
    ///
    /// # Errors
    /// A folder that cannot be listed, or a lesson in it that cannot be read.
    pub fn new(folder: Option<&Path>) -> Result<Self, LessonError> {
        let own = OWN.map(|(name, text, _)| Lesson::read(name, text, &format!("{name}.md")));
        let mut lessons = own.into_iter().collect::<Result<Vec<_>, _>>()?;
        let mut refused = Vec::new();
        for path in folder.map(files_in).transpose()?.unwrap_or_default() {
            let lesson = match Lesson::load(&path) {
                Ok(lesson) => lesson,
                Err(error) => {
                    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
                    refused.push(Refused { name, error });
                    continue;
                }
            };
            // One of somebody's own takes the place of one of the program's.
            lessons.retain(|known| known.name != lesson.name);
            lessons.push(lesson);
        }
        lessons.sort_by_key(|lesson| lesson.order);
        lessons.extend(Preset::all().iter().map(Lesson::of_preset));
        Ok(Self { lessons: lessons.into_iter().map(Arc::new).collect(), refused })
    }

    /// Returns all lessons in their order, then the presets.
    #[must_use]
    pub fn all(&self) -> &[Arc<Lesson>] {
        &self.lessons
    }

    /// Returns the chapters, in the order of their first lessons.
    #[must_use]
    pub fn chapters(&self) -> Vec<Chapter<'_>> {
        let mut chapters: Vec<Chapter<'_>> = Vec::new();
        let lessons = self.lessons.iter().filter(|lesson| !lesson.is_a_preset());
        for (index, lesson) in lessons.enumerate() {
            let numbered = (index + 1, lesson);
            match chapters.iter_mut().find(|chapter| chapter.title == lesson.chapter) {
                Some(chapter) => chapter.lessons.push(numbered),
                None => chapters.push(Chapter { title: &lesson.chapter, lessons: vec![numbered] }),
            }
        }
        chapters
    }

    /// The lesson after the one of this name; no preset.
    #[must_use]
    pub fn after(&self, name: &str) -> Option<&Arc<Lesson>> {
        let later = self.lessons.iter().skip_while(|lesson| lesson.name != name).nth(1);
        later.filter(|lesson| !lesson.is_a_preset())
    }

    /// The one of this name, or in the file there.
    ///
    /// # Errors
    /// No such lesson, or what is wrong in it.
    pub fn open(&self, name_or_path: impl AsRef<Path>) -> Result<Arc<Lesson>, LessonError> {
        let path = name_or_path.as_ref();
        let name = path.to_str();
        if let Some(refused) = self.refused.iter().find(|refused| name == Some(&refused.name)) {
            return Err(refused.error.clone());
        }
        if let Some(known) = self.lessons.iter().find(|lesson| name == Some(&lesson.name)) {
            return Ok(Arc::clone(known));
        }
        if let Some(name) = name.filter(|name| looks_like_a_name(name)) {
            let meant = did_you_mean(self.lessons.iter().map(|lesson| lesson.name.as_str()), name);
            // A preset opens as a lesson, too, but is none.
            let lessons = self.lessons.iter().filter(|lesson| !lesson.is_a_preset());
            let known = lessons.map(|lesson| lesson.name.as_str()).collect::<Vec<_>>().join(", ");
            return Err(LessonError::Unknown { name: name.to_owned(), meant, known });
        }
        Lesson::load(path).map(Arc::new)
    }
}

/// The Markdown files in `folder` that begin as lessons do, but for a README, by name; and those that cannot
/// be read.
fn files_in(folder: &Path) -> Result<Vec<PathBuf>, LessonError> {
    let listed = files::list_folder(folder).map_err(|reason| LessonError::Read {
        what: "lesson",
        source_name: files::shown(folder),
        reason: reason.to_string(),
    })?;
    let is_lesson = |path: &PathBuf| {
        let is_markdown = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("md"));
        let is_readme = path.file_stem().is_some_and(|name| name.eq_ignore_ascii_case("readme"));
        is_markdown && !is_readme && files::read_to_string(path).map_or(true, |text| Lesson::begins(&text))
    };
    Ok(listed.into_iter().filter(is_lesson).collect())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn no_two_lessons_have_one_name() {
        let library = Library::own();
        let names: BTreeSet<_> = library.all().iter().map(|lesson| lesson.name.as_str()).collect();
        assert_eq!(names.len(), library.all().len());
        assert_eq!(names.len(), OWN.len() + Preset::all().len());
    }

    #[test]
    fn a_wrong_name_is_answered_with_the_lessons_and_not_with_the_presets() {
        let error = |name: &str| Library::own().open(name).expect_err("there is none").to_string();
        let (lesson, preset) = (error("rodds"), error("tramm"));
        assert!(lesson.contains("did you mean `rods`?") && lesson.contains("there are rods, "), "{lesson}");
        assert!(preset.contains("did you mean `tram`?") && !preset.contains("globe"), "{preset}");
    }

    #[test]
    fn every_lesson_is_in_one_chapter() {
        let library = Library::own();
        let chapters = library.chapters();
        let titles: Vec<_> = chapters.iter().map(|chapter| chapter.title).collect();
        assert_eq!(titles, ["What is seen", "Colour and light", "Two eyes measure", "From the saddle"]);
        let mut numbers: Vec<_> =
            chapters.iter().flat_map(|chapter| &chapter.lessons).map(|(number, _)| *number).collect();
        numbers.sort_unstable();
        assert_eq!(numbers, (1..=OWN.len()).collect::<Vec<_>>());
    }

    #[test]
    fn a_folder_has_lessons_beside_the_programs_own_and_in_their_place() {
        let folder = tempfile::tempdir().expect("a folder");
        let write =
            |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("it is written");
        let lesson =
            |title: &str, order| format!("---\ntitle: {title}\norder: {order}\n---\n\n## One\n\nLook.\n");
        write("rods.md", &lesson("My rods", 1));
        write("extra.MD", &lesson("Extra", 3));
        write("README.md", "No lesson.");
        write("notes.md", "");
        write("notes.txt", "None either.");
        let library = Library::new(Some(folder.path())).expect("lessons");
        let titles: Vec<_> = library.all().iter().map(|lesson| lesson.title.as_str()).collect();
        assert_eq!(titles.len(), Library::own().all().len() + 1);
        assert_eq!(titles[0], "My rods");
        assert!(titles[2..=3].contains(&"Extra"), "{titles:?}");
        let chapters: Vec<_> = library.chapters().iter().map(|chapter| chapter.title.to_owned()).collect();
        assert!(chapters.contains(&"Your own lessons".to_owned()), "{chapters:?}");
        write("broken.md", "---\n");
        write("two-eyes.md", "---\ntitle: x\n");
        std::fs::write(folder.path().join("bytes.md"), b"---\ntitle: \xff\n").expect("it is written");
        let library = Library::new(Some(folder.path())).expect("the others are lessons");
        assert_eq!(library.all().len(), titles.len());
        let refused: Vec<_> = library.refused.iter().map(|refused| refused.name.as_str()).collect();
        assert_eq!(refused, ["broken", "bytes", "two-eyes"]);
        for name in refused {
            let error = library.open(name).expect_err("it is broken").to_string();
            assert!(error.contains(&format!("{name}.md:")), "{error}");
        }
    }
}
