//! What the start page says.

use std::sync::Arc;

use crate::lesson::{Course, Lesson};

/// What this is.
pub const HEADING: &str = "What do two eyes see at nearly the speed of light?";
pub const INTRODUCTION: &str = "Gamow shows what each eye sees of a cyclist who rides past at nearly the speed of light, \
    and what two eyes make of it. A lesson asks what you expect, shows what is seen, and explains it. Begin with the \
    first, or look around.";

/// That there can be more.
pub const OWN: &str = "A lesson is a text file. Write one of your own, and drop it onto the window.";

/// How many `lessons` there are, and how long they take together.
pub fn extent(lessons: &[&Arc<Lesson>]) -> String {
    let minutes: u32 = lessons.iter().map(|lesson| lesson.minutes).sum();
    format!("{} of them, {minutes} minutes together. Later ones build on earlier ones.", lessons.len())
}

/// What `lesson` serves, and how long it takes.
pub fn details(lesson: &Lesson) -> String {
    let minutes = format!("{} min", lesson.minutes);
    if lesson.concept.is_empty() { minutes } else { format!("{}  ·  {minutes}", lesson.concept) }
}

/// Where somebody is in a lesson.
pub fn place(course: &Course) -> String {
    let steps = course.lesson().steps.len();
    match course.place().step + 1 {
        step if step > steps => "Open: at its end".to_owned(),
        step => format!("Open: step {step} of {steps}"),
    }
}

/// The first sentence of `markdown`.
pub fn summary(markdown: &str) -> String {
    let plain = plain(markdown);
    let ends = [". ", "? ", ": "].into_iter().filter_map(|end| plain.find(end)).min();
    ends.map_or(plain.as_str(), |end| &plain[..=end]).trim_end_matches(':').to_owned()
}

/// `markdown` without its signs, in one paragraph.
pub fn plain(markdown: &str) -> String {
    let signs = ['*', '`', '$'];
    let text: String = markdown.chars().filter(|sign| !signs.contains(sign)).collect();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_summary_is_the_first_sentence() {
        for (markdown, expected) in [
            ("Rods come\nand *go*. Which is longer?", "Rods come and go."),
            ("At 0.7 c.", "At 0.7 c."),
            ("Why is it red? It goes. ", "Why is it red?"),
            ("", ""),
        ] {
            assert_eq!(summary(markdown), expected);
        }
    }
}
