//! Everything that somebody entered in lessons: for each lesson the way through it, whole.

mod progress;

use std::collections::BTreeMap;

use super::course::Course;
use super::plan::Lesson;

pub use progress::LessonProgress;
pub(super) use progress::asked;

/// The ways through all lessons, by their lessons.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Answers(BTreeMap<String, LessonProgress>);

impl Answers {
    /// Returns the way through `lesson`, if anything was done in it.
    #[must_use]
    pub fn progress(&self, lesson: &Lesson) -> Option<&LessonProgress> {
        self.of(&progress::key(lesson)).filter(|way| way.is_begun())
    }

    /// Returns the way through the lesson with this `key`.
    #[must_use]
    pub fn of(&self, key: &str) -> Option<&LessonProgress> {
        self.0.get(key)
    }

    /// Returns the ways through all lessons.
    pub fn all(&self) -> impl Iterator<Item = &LessonProgress> {
        self.0.values()
    }

    /// Puts `way` in the place of what was known of its lesson.
    pub fn set(&mut self, way: LessonProgress) {
        self.0.insert(way.key().to_owned(), way);
    }

    /// Notes how far the course is, if it has changed from `before` to `after`.
    pub fn note(&mut self, before: &Course, after: &Course) {
        let [old, lesson] = [before, after].map(Course::lesson);
        if !lesson.is_a_preset() && progress::key(old) == progress::key(lesson) && before != after {
            self.set(after.progress());
        }
    }
}

#[cfg(test)]
mod tests;
