//! The standard streams: the program's messages there. None of them ends it, and none commands a terminal.

use std::fmt;
use std::io::{self, IsTerminal as _, StdoutLock, Write as _};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

/// `text` as messages quote it: on one line, with nothing in it that a terminal would obey. What is not fit
/// to be shown stands as its escape.
#[must_use]
pub fn shown(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            // Marks that turn the direction of text about, or end a line without being control characters.
            '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => {
                shown.extend(c.escape_unicode());
            }
            c if c.is_control() => shown.extend(c.escape_default()),
            c => shown.push(c),
        }
    }
    shown
}

/// Returns a text of several lines as it can be shown: the lines stay, other control characters are escaped.
#[must_use]
pub fn shown_lines(text: &str) -> String {
    text.split('\n').map(shown).collect::<Vec<_>>().join("\n")
}

/// Maximum length of a quotation from a file or a flag in a message, characters.
const EXCERPT_LETTERS: usize = 60;

/// Returns the beginning of `text` as messages quote it: on one line, and never at length.
#[must_use]
pub fn excerpt(text: &str) -> String {
    // What is shown of a letter is never shorter than it.
    let begin: String = text.trim().chars().take(EXCERPT_LETTERS + 1).collect();
    let shown = shown(&begin);
    match shown.char_indices().nth(EXCERPT_LETTERS) {
        Some((end, _)) => format!("{}…", &shown[..end]),
        None => shown,
    }
}

/// Greatest length of a message, letters.
const MOST_LETTERS: usize = 4000;
/// Letters that are kept of the end of a longer one, which names the problem.
const LAST_LETTERS: usize = 500;

/// `text`, or its beginning and its end where it is too long for a message.
#[must_use]
pub fn in_short(text: &str) -> String {
    let count = text.chars().count();
    if count <= MOST_LETTERS {
        return text.to_owned();
    }
    let first: String = text.chars().take(MOST_LETTERS - LAST_LETTERS).collect();
    let last: String = text.chars().skip(count - LAST_LETTERS).collect();
    format!("{first} (and {} more letters) {last}", count - MOST_LETTERS)
}

/// Prints `remark` to standard error, ignoring a closed stream; nothing where remarks are not wanted.
pub fn remark(remark: impl fmt::Display) {
    if !is_quiet() {
        say(remark);
    }
}

/// Prints a line to standard error, ignoring a closed stream.
fn say(line: impl fmt::Display) {
    let line = in_short(&shown(&line.to_string()));
    match HELD.lock().unwrap_or_else(PoisonError::into_inner).as_mut() {
        Some(held) => held.push(line),
        None => drop(writeln!(io::stderr(), "{line}")),
    }
}

/// Whether nothing is said beside results and errors.
static IS_QUIET: AtomicBool = AtomicBool::new(false);

/// Leaves out remarks and progress from now on.
pub fn be_quiet() {
    IS_QUIET.store(true, Ordering::Relaxed);
}

/// Returns whether remarks and progress are left out.
#[must_use]
pub fn is_quiet() -> bool {
    IS_QUIET.load(Ordering::Relaxed)
}

/// Returns whether standard output is a terminal.
#[must_use]
pub fn is_stdout_a_terminal() -> bool {
    io::stdout().is_terminal()
}

/// Remarks that the host of a library takes, in place of standard error.
static HELD: Mutex<Option<Vec<String>>> = Mutex::new(None);

/// Holds remarks back from now on, until [`take_held`].
pub fn hold() {
    *HELD.lock().unwrap_or_else(PoisonError::into_inner) = Some(Vec::new());
}

/// Returns the remarks that were held back since the last time.
#[must_use]
pub fn take_held() -> Vec<String> {
    HELD.lock().unwrap_or_else(PoisonError::into_inner).as_mut().map(std::mem::take).unwrap_or_default()
}

/// Exit status of whatever could not be done.
const FAILURE: u8 = 2;

/// Prints the error in a line, and returns the exit status for it.
#[must_use]
pub fn failure(error: &anyhow::Error) -> u8 {
    say(format_args!("gamow: {error:#}"));
    FAILURE
}

/// Returns standard output, for a command's results.
pub fn stdout() -> StdoutLock<'static> {
    io::stdout().lock()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_would_obey_is_spelt_out() {
        assert_eq!(shown("a\u{1b}[31m\nb\u{202e}\u{9b}2J\u{7}"), r"a\u{1b}[31m\nb\u{202e}\u{9b}2J\u{7}");
        assert_eq!(shown("räder 車輪 'a' \"b\" \\"), "räder 車輪 'a' \"b\" \\");
        assert_eq!(shown_lines("a\u{1b}\nb\n"), "a\\u{1b}\nb\n");
    }

    #[test]
    fn an_excerpt_is_short_and_on_one_line() {
        assert_eq!(excerpt(" räder 車輪\n"), "räder 車輪");
        assert_eq!(excerpt("two\nlines\u{1b}"), r"two\nlines\u{1b}");
        let whole = "車".repeat(EXCERPT_LETTERS);
        assert_eq!(excerpt(&whole), whole);
        for long in ["車", "\u{1b}", "\n"] {
            let long = excerpt(&format!("a{}b", long.repeat(1_000_000)));
            assert_eq!((long.chars().count(), long.ends_with('…')), (EXCERPT_LETTERS + 1, true), "{long}");
        }
    }

    #[test]
    fn a_message_that_is_too_long_keeps_its_beginning_and_its_end() {
        let whole = "車".repeat(MOST_LETTERS);
        assert_eq!(in_short(&whole), whole);
        let long = format!("x.toml:2: d = {}: not a number", "7".repeat(3_000_000));
        let short = in_short(&long);
        assert!(short.starts_with("x.toml:2: d = 777") && short.ends_with("777: not a number"));
        assert!(short.contains(" (and 2996028 more letters) ") && short.len() < MOST_LETTERS + 40, "{short}");
    }
}
