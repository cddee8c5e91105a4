//! `gamow --list`: all lessons and presets, or all bodies of a scene.

use std::collections::BTreeSet;
use std::fmt;

use gamow_platform::messages;
use serde::Serialize;

use crate::files::whole::{write_out, write_report};
use crate::lesson::{Lesson, Library, Refused};
use crate::scene::Scene;

/// Writes all of `library`, a line each: its name, how long it takes, the concept that it serves, its title;
/// and for each lesson that cannot be read why. In JSON the members have names.
///
/// # Errors
///
/// Those of standard output.
pub fn list(library: &Library, is_json: bool) -> anyhow::Result<()> {
    let rows = library.all().iter().map(|lesson| ListedLesson::new(lesson));
    let table = LessonTable(rows.chain(library.refused.iter().map(ListedLesson::refused)).collect());
    write_out(|out| write_report(&table, is_json, out))
}

/// Writes the names of the bodies of `scene`, a line each, or as a list in JSON.
///
/// # Errors
///
/// Those of standard output.
pub fn list_bodies(scene: &Scene, is_json: bool) -> anyhow::Result<()> {
    write_out(|out| write_report(&BodyNames(scene.body_names()), is_json, out))
}

/// The names of bodies.
#[derive(Debug, Serialize)]
struct BodyNames<'a>(BTreeSet<&'a str>);

impl fmt::Display for BodyNames<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|name| writeln!(f, "{}", messages::shown(name)))
    }
}

/// A lesson or a preset in the list.
#[derive(Debug, Serialize)]
struct ListedLesson<'a> {
    name: &'a str,
    /// `lesson`, `preset`, or `refused` of a lesson that cannot be read.
    kind: &'static str,
    minutes: Option<u32>,
    concept: Option<&'a str>,
    title: Option<&'a str>,
    /// Why it cannot be read.
    error: Option<String>,
}

impl<'a> ListedLesson<'a> {
    fn new(lesson: &'a Lesson) -> Self {
        let is_lesson = !lesson.is_a_preset();
        Self {
            name: &lesson.name,
            kind: if is_lesson { "lesson" } else { "preset" },
            minutes: is_lesson.then_some(lesson.minutes),
            concept: is_lesson.then_some(&lesson.concept),
            title: Some(&lesson.title),
            error: None,
        }
    }

    fn refused(Refused { name, error }: &'a Refused) -> Self {
        let error = Some(error.to_string());
        Self { name, kind: "refused", minutes: None, concept: None, title: None, error }
    }

    /// The row in text: what may be that of a file of one's own commands no terminal.
    fn row(&self) -> [String; 4] {
        let minutes = self.minutes.map_or_else(String::new, |minutes| format!("{minutes} min"));
        let concept = self.concept.map_or_else(|| format!("({})", self.kind), messages::shown);
        let last = self.error.as_deref().map(|error| messages::in_short(&messages::shown(error)));
        let last = last.unwrap_or_else(|| messages::shown(self.title.unwrap_or_default()));
        [messages::shown(self.name), minutes, concept, last]
    }
}

/// Lessons in rows, in columns as wide as they need.
#[derive(Debug, Serialize)]
struct LessonTable<'a>(Vec<ListedLesson<'a>>);

impl fmt::Display for LessonTable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows: Vec<_> = self.0.iter().map(ListedLesson::row).collect();
        let [names, minutes, concepts] = [0, 1, 2].map(|column: usize| {
            rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default()
        });
        rows.iter().try_for_each(|[name, time, concept, title]| {
            writeln!(f, "{name:names$}  {time:>minutes$}  {concept:concepts$}  {title}")
        })
    }
}
