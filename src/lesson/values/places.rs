//! The places for values in a text, `{ASKED:.N}`, and what is wrong with them.

use std::ops::Range;

use gamow_platform::messages;
use pulldown_cmark::{Event, Parser};

use crate::caption::decimal;
use crate::formula::markdown::OPTIONS;

/// Letters of the shortest name that is no sign of a formula, where braces are TeX's.
const SHORTEST: usize = 3;

/// Returns `markdown` with a number in each place `{REQUEST:.N}`; or the error, with its line, from 0. `is_value` knows the names of values.
pub fn filled(
    markdown: &str,
    is_value: impl Fn(&str) -> bool,
    value: impl Fn(&str) -> Result<f64, String>,
) -> Result<String, (usize, String)> {
    let line = |place: usize| markdown[..place].matches('\n').count();
    if let Some((place, problem)) = broken_place(markdown, is_value) {
        return Err((line(place), problem));
    }
    let (mut done, mut from) = (String::new(), 0);
    while let Some((begin, asked, decimals, end)) = next_place(&markdown[from..]) {
        done += &markdown[from..from + begin];
        done += &decimal(value(asked).map_err(|problem| (line(from + begin), problem))?, decimals);
        from += end;
    }
    Ok(done + &markdown[from..])
}

/// The next place `{ASKED:.N}` in `text`: where it begins, what it asks for, with how many decimals, where it ends. Other
/// braces are TeX's.
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

/// Finds the first braces that were meant for a value and request none, and returns the correction.
fn broken_place(markdown: &str, is_value: impl Fn(&str) -> bool) -> Option<(usize, String)> {
    let (mut formulas, mut code): (Vec<Range<usize>>, Vec<Range<usize>>) = (Vec::new(), Vec::new());
    for (event, range) in Parser::new_ext(markdown, OPTIONS).into_offset_iter() {
        match event {
            Event::InlineMath(_) | Event::DisplayMath(_) => formulas.push(range),
            Event::Code(_) => code.push(range),
            _ => {}
        }
    }
    let is_in = |all: &[Range<usize>], place: usize| all.iter().any(|range| range.contains(&place));
    markdown.match_indices('{').find_map(|(begin, _)| {
        let inside = inside(markdown, begin)?;
        let is_escaped = markdown[..begin].ends_with('\\');
        if place(inside).is_some() || is_escaped || is_in(&code, begin) {
            return None;
        }
        let asked = inside.split_once(':').map_or(inside, |(asked, _)| asked).trim();
        let is_value = is_value(asked);
        if is_in(&formulas, begin) && !(is_value && asked.len() >= SHORTEST) {
            return None;
        }
        let example = if is_value { asked } else { "gamma" };
        let problem = format!(
            "`{{{}}}` is no place for a value: `{{{example}:.2}}` is one, with two decimals (0 to 9); `\\{{` is a brace",
            messages::excerpt(inside)
        );
        Some((begin, problem))
    })
}

/// The line, from 0, of the first `$` in `markdown` that begins no formula.
pub fn line_of_lone_dollar(markdown: &str) -> Option<usize> {
    Parser::new_ext(markdown, OPTIONS).into_offset_iter().find_map(|(event, range)| {
        let Event::Text(_) = event else { return None };
        let place = markdown[range.clone()].find('$')? + range.start;
        let is_escaped = markdown[..place].ends_with('\\');
        (!is_escaped).then(|| markdown[..place].matches('\n').count())
    })
}
