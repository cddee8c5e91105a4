//! Settings in files: TOML out and in, and what pictures record.

use std::ops::Range;
use std::path::Path;

use gamow_platform::names::problem_in_a_file;
use gamow_platform::{files, messages};
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::all::Settings;
use super::entries::{SCENE, names};
use super::error::{SettingProblem, SettingsError};
use super::link::is_link;
use crate::files::{exr, png, syntax};
use crate::flags::choices::FileKind;
use crate::scene::{Scene, SceneError, looks_like_a_name};
use crate::similar::did_you_mean;

impl Settings {
    /// Writes all settings as a file.
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "it cannot fail: a test writes a thousand")]
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("settings are numbers, words and lists of them")
    }

    /// Returns these settings with those in `text`, a file called `source_name`, on top.
    ///
    /// # Errors
    /// One line that names the file, the line in it, what is wrong and what would be right.
    pub fn with_toml(mut self, text: &str, source_name: &str) -> Result<Self, SettingsError> {
        let place = |span: Range<usize>| place(text, source_name, &span);
        let given = given(text).and_then(|all| all.into_iter().collect::<Result<Vec<_>, _>>());
        let given = given.map_err(|(span, text)| SettingProblem { key: None, text }.at(place(span)))?;
        let flags = given.iter().map(FileSetting::flag).collect();
        self.set(flags).map_err(|problem| {
            // An error that names no setting begins with it.
            let is_meant = |given: &&FileSetting| {
                problem.key.as_deref().map_or(problem.text.starts_with(&given.key), |key| key == given.key)
            };
            let span = given.iter().find(is_meant).map_or(0..0, |given| given.span.clone());
            problem.at(place(span))
        })?;
        Ok(self)
    }

    /// Returns the settings in `text` as far as they are valid, else defaults; and each invalid one in a
    /// line.
    #[must_use]
    pub fn as_far_as_told(text: &str) -> (Self, Vec<String>) {
        let mut settings = Self::default();
        let given = given(text).unwrap_or_else(|problem| vec![Err(problem)]);
        let set = |given: Result<FileSetting, LocatedProblem>| match given {
            Ok(given) => settings.set(vec![given.flag()]).err().map(|problem| problem.text),
            Err((_, problem)) => Some(problem),
        };
        let problems = given.into_iter().filter_map(set).collect();
        (settings, problems)
    }

    /// Returns these settings with those in the file at `path` on top: settings in TOML, or a picture (.png)
    /// or measurements (.exr) by `gamow render`; a link is no file, and says itself what it opens. A relative
    /// path to a scene is looked for beside the file, then where the program runs.
    ///
    /// # Errors
    /// One line that names the file and what is wrong with it.
    pub fn with_file(self, path: &Path) -> Result<Self, SettingsError> {
        if let Some(link) = path.to_str().filter(|_| is_link(path)) {
            return self.with_link(link);
        }
        let source_name = files::shown(path);
        let unreadable = |reason: String| SettingsError::Read { source_name: source_name.clone(), reason };
        if let Some(kind) = FileKind::from_path(path) {
            let command = match kind {
                FileKind::Png => png::command(path),
                FileKind::Exr => exr::command(path),
            };
            let command = command.map_err(|error| unreadable(format!("{error:#}")))?;
            let mut settings = self.with_command(&command, &source_name)?;
            let found = settings.find_scene_beside(path);
            found.map_err(|problem| SettingsError::Content { place: source_name, problem })?;
            return Ok(settings);
        }
        let text = files::read_to_string(path).map_err(|reason| unreadable(reason.to_string()))?;
        let mut settings = self.with_toml(&text, &source_name)?;
        let given = given(&text).unwrap_or_default().into_iter().flatten().find(|given| given.key == SCENE);
        let Some(FileSetting { span, .. }) = given else { return Ok(settings) };
        let found = settings.find_scene_beside(path);
        found.and_then(|()| settings.check_scene()).map_err(|problem| {
            let place = place(&text, &source_name, &span);
            SettingsError::Content { place, problem }
        })?;
        Ok(settings)
    }

    /// Whether a scene that they give by its name is a preset.
    fn check_scene(&self) -> Result<(), String> {
        if !looks_like_a_name(&self.scene) || Scene::preset(&self.scene).is_some() {
            return Ok(());
        }
        Err(SceneError::UnknownPreset(self.scene.clone()).to_string())
    }

    /// Has a scene that the file at `path` names by a relative path where it is: beside the file, else where
    /// the program runs; beside the file as well if it is nowhere.
    ///
    /// # Errors
    /// A name, one of Windows, that must not be looked for because somebody else may have written it.
    pub fn find_scene_beside(&mut self, path: &Path) -> Result<(), String> {
        if Scene::preset(&self.scene).is_some() {
            return Ok(());
        }
        if let Some(problem) = problem_in_a_file(&self.scene).filter(|_| cfg!(windows)) {
            return Err(format!("{SCENE} = {}: {problem}", messages::excerpt(&self.scene)));
        }
        let beside = files::folder_of(path).join(&self.scene);
        let is_nowhere = || !looks_like_a_name(&self.scene) && !files::is_there(Path::new(&self.scene));
        if (files::is_file(&beside) || is_nowhere())
            && let Some(scene) = beside.to_str()
        {
            scene.clone_into(&mut self.scene);
        }
        Ok(())
    }

    /// Returns these settings as the file at `path` should contain them: with the name of their scene's file
    /// relative to it. They are found again wherever both files go, and do not reveal where they lay.
    #[must_use]
    pub fn relative_to(&self, path: &Path) -> Self {
        let mut relative = self.clone();
        if Scene::preset(&self.scene).is_none()
            && let Some(name) = files::name_from(files::folder_of(path), Path::new(&self.scene))
        {
            // What looks like the name of a preset is taken for one.
            relative.scene = if looks_like_a_name(&name) { format!("./{name}") } else { name };
        }
        relative
    }
}

/// Whether `text` holds settings, and not a scene.
#[must_use]
pub fn looks_like_settings(text: &str) -> bool {
    DeTable::parse(text).is_ok_and(|top| {
        let mut keys = top.get_ref().iter().map(|(key, _)| key.get_ref().as_ref());
        keys.any(|key| names().any(|(section, name)| key == if section.is_empty() { name } else { &section }))
    })
}

/// The contents of a settings file besides the settings.
pub(super) struct Heading {
    /// Title, as in the list of presets.
    pub title: String,
    /// A sentence or two: what is to be seen, and why.
    pub caption: String,
}

/// Keys of a [`Heading`], which are no settings.
const HEADING_KEYS: [&str; 2] = ["title", "caption"];

impl Heading {
    /// Parses these contents in a file's text; `None` where a part is missing.
    pub fn in_toml(text: &str) -> Option<Self> {
        let top = DeTable::parse(text).ok()?;
        let [title, caption] =
            HEADING_KEYS.map(|key| top.get_ref().get(key).and_then(|value| value.get_ref().as_str()));
        Some(Self { title: title?.to_owned(), caption: caption?.to_owned() })
    }
}

/// A setting in a file, with its place there for errors.
struct FileSetting {
    key: String,
    text: String,
    span: Range<usize>,
}

impl FileSetting {
    fn flag(&self) -> String {
        format!("--{}={}", self.key, self.text)
    }
}

/// Something wrong, and where.
type LocatedProblem = (Range<usize>, String);

/// The file called `source_name`, with the line of `text` in which `span` begins.
fn place(text: &str, source_name: &str, span: &Range<usize>) -> String {
    let before = text.get(..span.start).unwrap_or(text);
    format!("{source_name}:{}", before.matches('\n').count() + 1)
}

/// The settings that a file's text gives, and what in it is none.
fn given(text: &str) -> Result<Vec<Result<FileSetting, LocatedProblem>>, LocatedProblem> {
    let top = DeTable::parse(text).map_err(|error| syntax::problem(text, &error))?;
    let mut all = Vec::new();
    for (key, value) in top.get_ref() {
        match value.get_ref() {
            DeValue::Table(table) => match check_section(key) {
                Ok(()) => {
                    all.extend(table.iter().map(|(inner, value)| setting(key.get_ref(), inner, value)));
                }
                Err(problem) => all.push(Err(problem)),
            },
            DeValue::String(_) if HEADING_KEYS.contains(&key.get_ref().as_ref()) => {}
            _ => all.push(setting("", key, value)),
        }
    }
    Ok(all)
}

fn check_section(section: &Spanned<DeString>) -> Result<(), LocatedProblem> {
    let mut known: Vec<String> =
        names().map(|(section, _)| section).filter(|name| !name.is_empty()).collect();
    known.dedup();
    if known.iter().any(|name| name == section.get_ref()) {
        return Ok(());
    }
    Err((
        section.span(),
        format!(
            "unknown section [{}]{}: there are {}",
            messages::excerpt(section.get_ref()),
            did_you_mean(known.iter().map(String::as_str), section.get_ref()),
            known.join(", ")
        ),
    ))
}

fn setting(
    section: &str,
    key: &Spanned<DeString>,
    value: &Spanned<DeValue>,
) -> Result<FileSetting, LocatedProblem> {
    let known: Vec<&str> = names().filter(|(name, _)| name == section).map(|(_, key)| key).collect();
    let name = syntax::british(key.get_ref());
    if !known.contains(&&*name) {
        let owner = if section.is_empty() { "before the first section" } else { section };
        let (near, shown) = (did_you_mean(known.iter().copied(), &name), messages::excerpt(&name));
        let problem = format!("unknown setting `{shown}`{near}: {owner} has {}", known.join(", "));
        return Err((key.span(), problem));
    }
    if (section, name.as_ref()) == ("", SCENE) && value.get_ref().as_str().is_none() {
        let problem = format!("{SCENE}: must be the name of a scene or of its file, in double quotes");
        return Err((value.span(), problem));
    }
    let text = text_of(value.get_ref());
    let text =
        text.ok_or_else(|| (value.span(), format!("{name}: must be a number, a word or a list of them")))?;
    Ok(FileSetting { key: name.to_string(), text, span: value.span() })
}

/// Writes a value in the spelling of a flag.
fn text_of(value: &DeValue) -> Option<String> {
    Some(match value {
        DeValue::String(text) => text.to_string(),
        DeValue::Integer(integer) => {
            i128::from_str_radix(integer.as_str(), integer.radix()).ok()?.to_string()
        }
        DeValue::Float(number) => number.as_str().to_owned(),
        DeValue::Boolean(is_on) => if *is_on { "on" } else { "off" }.to_owned(),
        DeValue::Array(items) => {
            let items: Option<Vec<String>> = items.iter().map(|item| text_of(item.get_ref())).collect();
            // With a space, by which a list of two is told from a number with a decimal comma.
            items?.join(", ")
        }
        DeValue::Datetime(_) | DeValue::Table(_) => return None,
    })
}
