//! The file dialog: the file to open or to write is chosen in a dialog of the system, or typed.

mod answer;
#[cfg(not(feature = "desktop"))]
mod page;
#[cfg(feature = "desktop")]
mod system;

use std::path::{Path, PathBuf};

use eframe::egui::Context;
use gamow_platform::{environment, files};

use self::answer::DialogAnswer;
#[cfg(not(feature = "desktop"))]
use self::page::Dialog;
#[cfg(feature = "desktop")]
use self::system::Dialog;
use crate::app::commands::{Command, FileCommand};
use crate::app::state::State;
use crate::app::state::files::purpose::{Product, Purpose};
use crate::app::state::orders::Saving;
use crate::flags::choices::Size;
use crate::settings::is_link;
use crate::studio::film::FilmKind;

/// The file that is being chosen: what is typed, and the dialog of the system.
#[derive(Default)]
pub struct Chooser {
    /// Purpose of the choice.
    pub purpose: Option<Purpose>,
    /// Text typed for the path.
    pub path: String,
    /// Text typed for the size of an eye's picture.
    pub size: String,
    /// Whether the keyboard should be given to the path.
    pub wants_focus: bool,
    /// Problem with the text typed, or reason why there is no dialog.
    pub remark: Option<String>,
    /// A file that is there already, and would be replaced.
    pub replaced: Option<PathBuf>,
    /// Folder in which a file was last chosen.
    folder: Option<PathBuf>,
    dialog: Option<Dialog>,
}

impl Chooser {
    /// Opens or closes as `state` requires, and reads the answer of the system's dialog.
    pub fn update(&mut self, state: &State, commands: &mut Vec<Command>) {
        if self.purpose != state.scratch.chooser {
            self.begin(state);
        }
        match self.dialog.as_ref().and_then(Dialog::answer) {
            None => return,
            Some(DialogAnswer::Path(path)) => {
                self.path = path.display().to_string();
                // The dialog has asked whether it may be replaced.
                commands.extend(self.confirmed(Some(&path)));
            }
            Some(DialogAnswer::None) => {}
            Some(DialogAnswer::NoDialog) => {
                self.remark = Some(
                    "The system has no file dialog to offer (it takes a desktop portal): type the path."
                        .to_owned(),
                );
                self.wants_focus = true;
            }
        }
        self.dialog = None;
    }

    fn begin(&mut self, state: &State) {
        let folder = self.folder.take().or_else(|| files::canonical(Path::new(".")).ok()).unwrap_or_default();
        self.purpose = state.scratch.chooser;
        // The scene of a model belongs beside it.
        let model = state.scene_file().filter(|_| self.purpose == Some(Purpose::Save(Product::Scene)));
        let folder = model.map_or(folder, |model| files::folder_of(model).to_owned());
        self.path = match self.purpose {
            Some(Purpose::Save(product)) => {
                let scene = Path::new(&state.document.settings.scene).file_stem().unwrap_or_default();
                let is_of_lesson = product == Product::Report || product.sheet().is_some();
                let lesson =
                    state.course().filter(|_| is_of_lesson).map(|course| course.lesson().name.clone());
                let answered = state.answered_lessons().first().map(|lesson| lesson.name.clone());
                let lesson = lesson.or(answered.filter(|_| product == Product::ClassPage));
                let subject = lesson.unwrap_or_else(|| scene.to_string_lossy().into_owned());
                folder.join(product.file_name(&subject)).display().to_string()
            }
            _ => folder.join("").display().to_string(),
        };
        self.folder = Some(folder);
        self.size = Size(match self.purpose {
            Some(Purpose::Save(Product::Film)) => within(FILM_WIDTH, state.frame.picture.size),
            Some(Purpose::Save(Product::TenSeconds)) => within(SLIDE_WIDTH, state.frame.picture.size),
            _ => state.frame.picture.size,
        })
        .to_string();
        self.wants_focus = true;
        (self.remark, self.replaced, self.dialog) = (None, None, None);
    }

    /// Asks the system for a dialog.
    pub fn browse(&mut self, ctx: &Context) {
        if let Some(purpose) = self.purpose {
            self.dialog = Some(Dialog::open(ctx, purpose, Path::new(&self.path)));
        }
    }

    /// Whether the system has a dialog for the choice.
    #[must_use]
    pub fn has_dialog(&self) -> bool {
        self.purpose.is_some_and(Dialog::is_for)
    }

    /// Whether the system's dialog is open.
    #[must_use]
    pub const fn is_browsing(&self) -> bool {
        self.dialog.is_some()
    }

    /// Returns the beginning of the file's name in its path, and that of its ending; characters.
    #[must_use]
    pub fn stem(&self) -> [usize; 2] {
        let letters = |text: &str| text.chars().count();
        let name = self.path.rfind(std::path::is_separator).map_or(0, |slash| slash + 1);
        let ending = self.path[name..].rfind('.').map_or(self.path.len(), |dot| name + dot);
        [letters(&self.path[..name]), letters(&self.path[..ending])]
    }

    /// Clears the remark on the text typed before.
    pub fn edited(&mut self) {
        (self.remark, self.replaced) = (None, None);
    }

    /// Returns the command for the text typed; `None`, with a remark or a question, if it cannot be done yet.
    /// The file at `may_replace` may be there already.
    pub fn confirmed(&mut self, may_replace: Option<&Path>) -> Option<Command> {
        self.edited();
        match self.command(may_replace) {
            Ok(command) => command,
            Err(remark) => {
                self.remark = Some(remark);
                None
            }
        }
    }

    fn command(&mut self, may_replace: Option<&Path>) -> Result<Option<Command>, String> {
        let Some(purpose) = self.purpose else { return Ok(None) };
        let link = Path::new(self.path.trim());
        if purpose == Purpose::Open && is_link(link) {
            return Ok(Some(Command::File(FileCommand::Open(link.to_owned()))));
        }
        let path = typed_path(&self.path)?;
        if let Some(folder) = path.parent().filter(|folder| *folder != Path::new("")) {
            if !files::is_folder(folder) {
                return Err(format!("There is no folder {}.", folder.display()));
            }
            self.folder = Some(folder.to_owned());
        }
        let Purpose::Save(product) = purpose else {
            if !files::is_there(&path) || files::is_folder(&path) {
                return Err(format!("There is no file {}.", path.display()));
            }
            let is_data = purpose == Purpose::OpenData;
            return Ok(Some(if is_data {
                Command::File(FileCommand::OpenData(path))
            } else {
                Command::File(FileCommand::Open(path))
            }));
        };
        let path = product.with_ending(&path)?;
        let is_folder = product.can_be_a_folder() && FilmKind::from_path(&path) == Some(FilmKind::Folder);
        if is_folder && !files::HAS_FOLDERS {
            let endings = FilmKind::NAMED_ENDINGS;
            return Err(format!("A browser saves no folders: the name of a film must end in {endings}."));
        }
        if files::is_folder(&path) && !is_folder {
            return Err(format!("{} is a folder.", path.display()));
        }
        let size = if product.has_size() { self.size.trim().parse::<Size>()?.0 } else { [1, 1] };
        if files::is_there(&path) && may_replace != Some(path.as_path()) {
            self.replaced = Some(path);
            return Ok(None);
        }
        Ok(Some(Command::File(FileCommand::Save(Saving { product, path, size }))))
    }
}

/// Width of a film that is proposed, pixels: it has hundreds of frames, and one as large as the window would
/// take 100 MB.
const FILM_WIDTH: u32 = 480;
/// The same of a film of ten seconds, which is shown on a slide.
const SLIDE_WIDTH: u32 = 640;

/// `size` made so small that it is no wider than this, in the same shape.
fn within(width: u32, size: [u32; 2]) -> [u32; 2] {
    let factor = f64::from(width.min(size[0])) / f64::from(size[0].max(1));
    size.map(|side| ((f64::from(side) * factor).round() as u32).max(1))
}

/// Parses a typed path, in which `~/` is the home folder. A full path typed behind the prefilled folder
/// starts afresh: `/home/me//tmp/a.csv` is `/tmp/a.csv`.
fn typed_path(text: &str) -> Result<PathBuf, String> {
    let text = text.trim();
    let again = ["//", "/~/"].into_iter().filter_map(|begin| text.rfind(begin)).max();
    let text = again.map_or(text, |at| &text[at + 1..]);
    if text.is_empty() {
        return Err("A path is needed.".to_owned());
    }
    let home = || environment::variable("HOME").map(PathBuf::from);
    Ok(match text.strip_prefix("~/").zip(home()) {
        Some((rest, home)) => home.join(rest),
        None => PathBuf::from(text),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn a_path_typed_behind_a_folder_begins_anew() {
        let home = PathBuf::from(std::env::var_os("HOME").expect("there is a home"));
        for (typed, meant) in [
            ("/home/me/a.csv", PathBuf::from("/home/me/a.csv")),
            (" /home/me//tmp/a.csv", PathBuf::from("/tmp/a.csv")),
            ("/home/me/~/a.csv", home.join("a.csv")),
            ("~/a.csv", home.join("a.csv")),
            ("a.csv", PathBuf::from("a.csv")),
        ] {
            assert_eq!(typed_path(typed), Ok(meant), "{typed}");
        }
        assert!(typed_path(" ").is_err());
    }

    #[test]
    fn a_film_is_proposed_in_the_shape_of_the_window() {
        assert_eq!(within(480, [1560, 508]), [480, 156]);
        assert_eq!(within(480, [300, 200]), [300, 200]);
        assert_eq!(within(480, [5000, 1]), [480, 1]);
    }
}
