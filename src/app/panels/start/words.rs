//! Words of the start page.

use pulldown_cmark::{Event, TagEnd};

use crate::formula::markdown::Markdown;
use crate::lesson::{Answers, Chapter, Course, Lesson};
use crate::settings::Preset;

/// Heading of the page, and the line below it.
pub const HEADING: &str = "See what nobody has ever seen";
pub const LINE: &str = "A street at nearly the speed of light, exactly as your two eyes would see it.";

/// Sentence about the course of a lesson.
pub const LESSON: &str = "Each lesson asks for your guess, shows you what happens, and explains it.";

/// Introduction to the presets.
pub const PRESETS: &str = "Ready-made scenes. Hover to read what each one shows.";

/// Invitation to write a lesson.
pub const OWN: &str = "A lesson is a text file. Write one of your own, and drop it onto the window.";

/// Returns the line beside the way to the presets.
pub fn presets() -> String {
    format!("{} ready-made scenes to look at and to change.", Preset::all().len())
}

/// Returns the number of the lessons of `chapter`, their duration together, and how many of them are done.
pub fn chapter(chapter: &Chapter<'_>, answers: &Answers) -> String {
    let (lessons, count) = (&chapter.lessons, chapter.lessons.len());
    let minutes: u32 = lessons.iter().map(|(_, lesson)| lesson.minutes).sum();
    let noun = if count == 1 { "lesson" } else { "lessons" };
    let done = lessons.iter().filter(|(_, lesson)| is_done(lesson, answers)).count();
    let done = if done == 0 { String::new() } else { format!(" · {done} done") };
    format!("{count} {noun} · {minutes} min{done}")
}

/// Returns the titles of the lessons of `chapter`, in lines.
pub fn titles(chapter: &Chapter<'_>) -> String {
    let lines = chapter.lessons.iter().map(|(number, lesson)| format!("{number}. {}", lesson.title));
    lines.collect::<Vec<_>>().join("\n")
}

/// Returns the subject of `lesson`, its duration, and how far its user came.
pub fn details(lesson: &Lesson, answers: &Answers) -> String {
    let reached = match answers.progress(lesson) {
        Some(_) if is_done(lesson, answers) => Some("done".to_owned()),
        Some(progress) => Some(format!("step {} of {}", progress.place().step + 1, lesson.steps.len())),
        None => None,
    };
    let concept = Some(lesson.concept.clone()).filter(|concept| !concept.is_empty());
    let parts = [concept, Some(format!("{} min", lesson.minutes)), reached];
    parts.into_iter().flatten().collect::<Vec<_>>().join("  ·  ")
}

/// Whether the end of `lesson` was reached.
fn is_done(lesson: &Lesson, answers: &Answers) -> bool {
    answers.progress(lesson).is_some_and(|progress| progress.place().step >= lesson.steps.len())
}

/// Returns the present place in a lesson.
pub fn place(course: &Course) -> String {
    let steps = course.lesson().steps.len();
    match course.place().step + 1 {
        step if step > steps => "Open: at its end".to_owned(),
        step => format!("Open: step {step} of {steps}"),
    }
}

/// Least length of a card's description, if there is more of it, letters.
const ENOUGH: usize = 40;

/// Returns the beginning of `markdown`, a sentence or so, as [`plain`].
pub fn summary(markdown: &Markdown) -> String {
    let enough = |count: &usize| plain(markdown, *count).chars().count() >= ENOUGH;
    plain(markdown, (1..=2).find(enough).unwrap_or(2))
}

/// The sentences of `markdown` in one paragraph and without its signs, but for those with formulas and with
/// values that are still to be worked out; at most so many.
pub fn plain(markdown: &Markdown, most: usize) -> String {
    let words = markdown.events().iter().map(|(event, _)| match event {
        Event::Text(text) | Event::Code(text) => text,
        Event::InlineMath(_) | Event::DisplayMath(_) => "$",
        Event::SoftBreak | Event::HardBreak | Event::End(TagEnd::Paragraph | TagEnd::Item) => " ",
        _ => "",
    });
    let text: String = words.collect();
    let words = text.split_whitespace().collect::<Vec<_>>();
    let sentences = words.split_inclusive(|word| word.ends_with(['.', '?']));
    let is_plain = |sentence: &&[&str]| !sentence.iter().any(|word| word.contains(['$', '{']));
    sentences.filter(is_plain).take(most).map(|sentence| sentence.join(" ")).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_sentence_is_told_with_the_next() {
        let long = "Light of the far end left earlier, when that was further away.";
        let summary = |text: &str| summary(&Markdown::new(text));
        assert_eq!(summary(&format!("A wheel rolls. {long} And so on.")), format!("A wheel rolls. {long}"));
        assert_eq!(summary(&format!("{long} A wheel rolls.")), long);
        assert_eq!(summary("A wheel rolls."), "A wheel rolls.");
    }

    #[test]
    fn cards_tell_sentences_without_signs_and_formulas() {
        for (markdown, one, all) in [
            (
                "Rods come\nand *go*. Which is longer?",
                "Rods come and go.",
                "Rods come and go. Which is longer?",
            ),
            ("At 0.7 c.", "At 0.7 c.", "At 0.7 c."),
            ("By {gain:.2} times. Why is it red? It goes.", "Why is it red?", "Why is it red? It goes."),
            ("Of $\\gamma = {gamma:.3}$.", "", ""),
            ("No end", "No end", "No end"),
            ("See `a * b`, [here](https://b.org).", "See a * b, here.", "See a * b, here."),
        ] {
            let plain = |most| plain(&Markdown::new(markdown), most);
            assert_eq!([plain(1), plain(usize::MAX)], [one, all], "{markdown}");
        }
    }
}
