//! The places for values in a text, `{ASKED:.N}`, and what is wrong with them.

use std::ops::Range;

use gamow_platform::messages;
use pulldown_cmark::{Event, Tag};

use crate::caption::decimal;
use crate::formula::markdown::Markdown;

/// Letters of the shortest name that is no sign of a formula, where braces are TeX's.
const SHORTEST: usize = 3;

/// Returns `markdown` with a number in each place `{REQUEST:.N}`; or the error, with its line, from 0.
pub fn filled(
    markdown: &str,
    value: impl Fn(&str) -> Result<f64, String>,
) -> Result<String, (usize, String)> {
    let line = |place: usize| markdown[..place].matches('\n').count();
    let (mut done, mut from) = (String::new(), 0);
    while let Some((begin, asked, decimals, end)) = next_place(&markdown[from..]) {
        done += &markdown[from..from + begin];
        done += &decimal(value(asked).map_err(|problem| (line(from + begin), problem))?, decimals);
        from += end;
    }
    Ok(done + &markdown[from..])
}

/// The next place `{ASKED:.N}` in `text`: where it begins, what it asks for, with how many decimals, where it
/// ends. Other braces are TeX's.
fn next_place(text: &str) -> Option<(usize, &str, u8, usize)> {
    text.match_indices('{').find_map(|(begin, _)| {
        let inside = inside(text, begin)?;
        let (asked, decimals) = place(inside)?;
        Some((begin, asked, decimals, begin + inside.len() + 2))
    })
}

/// Returns the text inside the braces that begin there, unless others begin in it.
fn inside(text: &str, begin: usize) -> Option<&str> {
    let inside = &text[begin + 1..begin + text[begin..].find('}')?];
    (!inside.contains('{')).then_some(inside)
}

/// Returns the request in the braces, and its decimals.
fn place(inside: &str) -> Option<(&str, u8)> {
    let (asked, format) = inside.rsplit_once(":.")?;
    let decimals = format.parse::<u8>().ok().filter(|decimals| *decimals <= 9)?;
    Some((asked, decimals))
}

/// Returns `text`, whose values are in their places, if all of it can be shown; or the first problem, with
/// its line, from 0. `is_value` knows the names of values.
pub fn checked(text: Markdown, is_value: impl Fn(&str) -> bool) -> Result<Markdown, (usize, String)> {
    let problem = text.events_outside_code().find_map(|(event, range)| match event {
        Event::Start(Tag::Image { .. }) => {
            let problem = "a lesson's pictures are the program's: a text holds none";
            Some((text.line(range.start), problem.to_owned()))
        }
        Event::Text(_) | Event::Html(_) | Event::InlineHtml(_) => {
            broken_place(&text, range, false, &is_value)
        }
        Event::InlineMath(_) | Event::DisplayMath(_) => broken_place(&text, range, true, &is_value),
        _ => None,
    });
    match problem.or_else(|| text.first_fault().map(|(line, fault)| (line, fault.to_string()))) {
        Some(problem) => Err(problem),
        None => Ok(text),
    }
}

/// Finds the first braces in a `range` of `text` that were meant for a value and request none, and returns
/// the correction. In a formula other braces are TeX's.
fn broken_place(
    text: &Markdown,
    range: &Range<usize>,
    is_formula: bool,
    is_value: impl Fn(&str) -> bool,
) -> Option<(usize, String)> {
    let source = text.source();
    source[range.clone()].match_indices('{').find_map(|(begin, _)| {
        let begin = range.start + begin;
        let inside = inside(source, begin).filter(|_| !text.is_escaped(begin))?;
        let asked = inside.split_once(':').map_or(inside, |(asked, _)| asked).trim();
        let is_value = is_value(asked);
        if is_formula && !(is_value && asked.len() >= SHORTEST) {
            return None;
        }
        let example = if is_value { asked } else { "gamma" };
        let problem = format!(
            "`{{{}}}` is no place for a value: `{{{example}:.2}}` is one, with two decimals (0 to 9); `\\{{` is a brace",
            messages::excerpt(inside)
        );
        Some((text.line(begin), problem))
    })
}
