//! Everything that somebody entered in lessons, each answer with its date. Two windows that know different answers are merged
//! without losing any: merging is commutative, associative and idempotent.

mod dated;
mod progress;

use std::collections::BTreeMap;

use gamow_platform::sizes::TEXT_BYTES;
use serde::{Deserialize, Serialize};

use super::course::Course;
use super::plan::Lesson;
use dated::{Dated, LAST};
use progress::{Draft, named};

pub use dated::Timestamp;
pub use progress::LessonProgress;

/// At most this many ways through lessons are stored, the latest ones.
const MOST_WAYS: usize = 64;

/// The ways through all lessons, by the lesson's name, or by its file if it was read from one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Answers(BTreeMap<String, LessonProgress>);

impl Answers {
    /// Returns the way through `lesson`, if anything was done in it.
    #[must_use]
    pub fn progress(&self, lesson: &Lesson) -> Option<&LessonProgress> {
        self.0.get(&named(lesson)).filter(|way| way.is_begun())
    }

    /// Returns whether there are none, and none were cleared.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Notes what changed in a course from `before` to `after`, entered `now`. Only changes are dated: what another window
    /// answered in the meantime is not replaced by what this one has shown all along.
    pub fn note(&mut self, before: &Course, after: &Course, now: Timestamp) {
        let lesson = after.lesson();
        if lesson.is_a_preset() || named(before.lesson()) != named(lesson) || before == after {
            return;
        }
        let at = self.date(now);
        let way = self.0.entry(named(lesson)).or_default();
        let old = |number: usize| before.records().get(number);
        for (number, record) in after.records().iter().enumerate() {
            let is_new = (
                record.outcome.is_some() && old(number).is_none_or(|old| old.outcome != record.outcome),
                record.observed.is_some() && old(number).is_none_or(|old| old.observed != record.observed),
            );
            if is_new == (false, false) {
                continue;
            }
            let Some(step) = way.step(lesson, number) else { continue };
            if let Some(value) = record.outcome.clone().filter(|value| is_new.0 && can_be_read_again(value)) {
                step.outcome = Some(Dated { at, value });
            }
            if let Some(value) = record.observed.filter(|_| is_new.1) {
                step.observed = Some(Dated { at, value });
            }
        }
        if before.place() != after.place() {
            way.place = Some(Dated { at, value: after.place() });
        }
        if (&before.draft, before.confidence) != (&after.draft, after.confidence) {
            let answer = after.draft.clone().filter(can_be_read_again);
            let value = Draft { place: after.place(), answer, confidence: after.confidence };
            way.draft = Some(Dated { at, value });
        }
        way.drop_cleared();
    }

    /// Forgets what was done in `lesson`, in every window, up to `now`.
    pub fn clear(&mut self, lesson: &Lesson, now: Timestamp) {
        if lesson.is_a_preset() {
            return;
        }
        let at = self.date(now);
        let way = self.0.entry(named(lesson)).or_default();
        way.cleared = at;
        way.drop_cleared();
    }

    /// Merges `other` into the answers: of each answer the later one stays.
    pub fn merge(&mut self, other: &Self) {
        for (name, way) in &other.0 {
            self.0.entry(name.clone()).or_default().merge(way);
        }
    }

    /// Returns the date of the latest change; without drafts, which change with every stroke of a key.
    #[must_use]
    pub fn latest_answer(&self) -> Timestamp {
        self.0.values().map(LessonProgress::latest_answer).max().unwrap_or(0)
    }

    /// Returns the date of the latest change, drafts included.
    #[must_use]
    pub fn latest(&self) -> Timestamp {
        self.0.values().map(LessonProgress::latest).max().unwrap_or(0)
    }

    /// Returns the date of what is entered `now`: later than everything that is known.
    fn date(&self, now: Timestamp) -> Timestamp {
        now.max(self.latest() + 1)
    }

    /// Returns the text of a file of them, which is never longer than what is read of one: the oldest ways are left out.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut ways: Vec<_> = self.0.iter().collect();
        ways.sort_by_key(|(_, way)| std::cmp::Reverse(way.latest()));
        ways.truncate(MOST_WAYS);
        let text = |count: usize| {
            let kept: BTreeMap<_, _> = ways[..count].iter().copied().collect();
            serde_json::to_string(&kept).unwrap_or_default() + "\n"
        };
        let all = text(ways.len());
        if all.len() as u64 <= TEXT_BYTES {
            return all;
        }
        let counts: Vec<usize> = (1..=ways.len()).collect();
        text(counts.partition_point(|count| text(*count).len() as u64 <= TEXT_BYTES))
    }

    /// Reads the text of such a file.
    ///
    /// # Errors
    /// What is wrong in it.
    pub fn of_text(text: &str) -> Result<Self, String> {
        let mut answers: Self = serde_json::from_str(text).map_err(|error| error.to_string())?;
        for (name, way) in &mut answers.0 {
            if !way.put_in_order() {
                return Err(format!("two entries for one question of {name}"));
            }
            if way.latest() >= LAST {
                return Err(format!("a date in {name} must be below {LAST}"));
            }
        }
        Ok(answers)
    }
}

/// Whether a file gives `value` back as it was written. Numbers that are none are not kept, which would spoil the whole file.
fn can_be_read_again<T: Serialize + for<'de> Deserialize<'de> + PartialEq>(value: &T) -> bool {
    let text = serde_json::to_string(value);
    text.is_ok_and(|text| serde_json::from_str::<T>(&text).is_ok_and(|read| read == *value))
}

#[cfg(test)]
mod tests;
