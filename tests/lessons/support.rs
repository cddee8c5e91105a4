//! The lessons as the program works them out.

use std::sync::Arc;

use gamow::lesson::{Lesson, Library};

/// The lesson of this name, with its values in their places.
pub fn lesson(name: &str) -> Lesson {
    let lesson: Arc<Lesson> = Library::own().open(name).expect("a lesson of the program's own");
    lesson.worked_out().unwrap_or_else(|error| panic!("{error}"))
}
