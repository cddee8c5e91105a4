//! Keys and syntax errors in TOML: an American spelling is read as the British one, and an error is one line
//! that gives the correction.

use std::borrow::Cow;
use std::ops::Range;

use gamow_platform::messages;
use toml::de::Error;

use crate::number_text;

/// The name of a key, a flag or a keyword in the spelling that it has here: `centre` for `center`, `colour`
/// for `color`.
#[must_use]
pub fn british(name: &str) -> Cow<'_, str> {
    if name.contains("center") || name.contains("color") {
        Cow::Owned(name.replace("center", "centre").replace("color", "colour"))
    } else {
        Cow::Borrowed(name)
    }
}

/// The name of a key in American spelling, if that is another.
#[must_use]
pub fn american(name: &str) -> Option<&'static str> {
    match name {
        "centre" => Some("center"),
        "colour" => Some("color"),
        _ => None,
    }
}

/// Returns the problem that the TOML reader found in `text`, and its range of bytes.
#[must_use]
pub fn problem(text: &str, error: &Error) -> (Range<usize>, String) {
    let span = error.span().unwrap_or_default();
    let found = || with_short_quotations(&error.message().lines().collect::<Vec<_>>().join("; "));
    let problem = decimal_comma(line_at(text, span.start)).unwrap_or_else(found);
    (span, problem)
}

/// `message` with short beginnings of what it quotes of the file.
fn with_short_quotations(message: &str) -> String {
    let parts = message.split('`').enumerate();
    let short = parts.map(|(number, part)| match number % 2 {
        0 => part.to_owned(),
        _ => messages::excerpt(part),
    });
    short.collect::<Vec<_>>().join("`")
}

/// The line of `text` that has the byte at `offset`.
fn line_at(text: &str, offset: usize) -> &str {
    let Some((before, after)) = text.split_at_checked(offset) else { return "" };
    let start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let end = after.find('\n').map_or(text.len(), |newline| offset + newline);
    &text[start..end]
}

/// Returns the correction of a line like `beta = 0,8`.
fn decimal_comma(line: &str) -> Option<String> {
    let (key, value) = line.split_once('=')?;
    let value = value.split('#').next().unwrap_or(value).trim();
    let number = number_text::with_point(value);
    let is_meant = value.contains(',') && number.parse::<f64>().is_ok();
    let [key, value, number] = [key, value, &number].map(messages::excerpt);
    is_meant.then(|| format!("{value} is not a number: with a decimal point it is {key} = {number}"))
}

#[cfg(test)]
mod tests {
    use toml::de::DeTable;

    use super::*;

    fn found(text: &str) -> String {
        problem(text, &DeTable::parse(text).expect_err("it is wrong")).1
    }

    #[test]
    fn a_decimal_comma_is_named_with_what_would_be_right() {
        let expected = "0,8 is not a number: with a decimal point it is beta = 0.8";
        for text in ["beta = 0,8", "[motion]\nd = 1\nbeta=0,8 # fast\nroll = 2", "beta = 0,8\r\n"] {
            assert_eq!(found(text), expected, "{text}");
        }
    }

    #[test]
    fn what_else_is_wrong_is_as_the_reader_says_it() {
        for text in ["d = 1,2,3", "d = = 2", "d = [1, 2", "\u{e4} = ,", "d = 'x,1", ""] {
            if DeTable::parse(text).is_err() {
                assert!(!found(text).contains("decimal point") && !found(text).contains('\n'), "{text}");
            }
        }
    }
}
