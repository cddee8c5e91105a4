//! `gamow --list`: all lessons and presets, or all bodies of a scene.

use std::fmt;

use gamow_platform::messages;

use crate::files::whole::write_out;
use crate::lesson::{Lesson, Library, Refused};
use crate::scene::Scene;

/// Writes all of `library`, a line each: its name, how long it takes, the concept that it serves, its title;
/// and for each lesson that cannot be read why.
///
/// # Errors
///
/// Those of standard output.
pub fn list(library: &Library) -> anyhow::Result<()> {
    write_out(|out| Ok(write!(out, "{}", LessonTable(library))?))
}

/// Writes the names of the bodies of `scene`, a line each.
///
/// # Errors
///
/// Those of standard output.
pub fn list_bodies(scene: &Scene) -> anyhow::Result<()> {
    let names = scene.body_names();
    write_out(|out| Ok(names.iter().try_for_each(|name| writeln!(out, "{}", messages::shown(name)))?))
}

/// Lessons in rows, in columns as wide as they need.
struct LessonTable<'a>(&'a Library);

impl fmt::Display for LessonTable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let refused = self.0.refused().iter().map(refused_row);
        let rows: Vec<_> = self.0.all().iter().map(|lesson| row(lesson)).chain(refused).collect();
        let [names, minutes, concepts] = [0, 1, 2].map(|column: usize| {
            rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default()
        });
        rows.iter().try_for_each(|[name, time, concept, title]| {
            writeln!(f, "{name:names$}  {time:>minutes$}  {concept:concepts$}  {title}")
        })
    }
}

/// The row of a lesson that cannot be read, with the reason in place of a title.
fn refused_row(Refused { name, error }: &Refused) -> [String; 4] {
    [
        messages::shown(name),
        String::new(),
        "(refused)".to_owned(),
        messages::in_short(&messages::shown(&error.to_string())),
    ]
}

fn row(lesson: &Lesson) -> [String; 4] {
    let (time, concept) = if lesson.is_a_preset() {
        (String::new(), "(preset)".to_owned())
    } else {
        (format!("{} min", lesson.minutes), lesson.concept.clone())
    };
    // They may be those of a file of one's own.
    [&lesson.name, &time, &concept, &lesson.title].map(|text| messages::shown(text))
}
