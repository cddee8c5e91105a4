//! Errors of the command line, each in one line as all errors of the program are.

use clap::Command;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use gamow_platform::messages;

use crate::settings::problem_of_flags;
use crate::similar::did_you_mean;

/// Returns the `error` in a command line of the commands of `program`, with its first `words`, in one line:
/// what is wrong, what would be right, and which help says more.
pub fn in_one_line(program: &Command, words: &[String], error: &clap::Error) -> String {
    let command = words.iter().skip(1).find_map(|word| program.find_subcommand(word)).unwrap_or(program);
    let name = if std::ptr::eq(command, program) {
        "gamow".to_owned()
    } else {
        format!("gamow {}", command.get_name())
    };
    let wrong = |kind| match error.get(kind) {
        Some(ContextValue::String(word)) => word.as_str(),
        _ => "",
    };
    let problem = match error.kind() {
        ErrorKind::UnknownArgument => unknown(command, wrong(ContextKind::InvalidArg)),
        ErrorKind::InvalidSubcommand => no_command(program, wrong(ContextKind::InvalidSubcommand)),
        _ => problem_of_flags(error),
    };
    format!("{problem}; `{name} --help` says more")
}

/// Returns the problem with a flag or a word that means nothing to `command`.
fn unknown(command: &Command, word: &str) -> String {
    let flags = command.get_arguments().filter_map(clap::Arg::get_long);
    match word.strip_prefix("--") {
        Some(flag) => {
            let near = did_you_mean(flags, flag).replacen('`', "`--", 1);
            format!("there is no flag {}{near}", messages::excerpt(word))
        }
        None if word.starts_with('-') => format!("there is no flag {}", messages::excerpt(word)),
        None if command.has_subcommands() => no_command(command, word),
        None => format!("`{}` is one word too many", messages::excerpt(word)),
    }
}

/// Returns the problem with a word that is no command.
fn no_command(program: &Command, word: &str) -> String {
    let near = did_you_mean(program.get_subcommands().map(Command::get_name), word);
    format!("there is no command `{}`{near}", messages::excerpt(word))
}

/// Returns the error of a `flag` of the window before the name of the `command`.
pub fn misplaced(flag: &str, command: &str) -> clap::Error {
    let text = format!(
        "--{flag} before {command} is a flag of the window: those of a command stand behind its name, as in `gamow \
            {command} --{flag}`"
    );
    clap::Error::raw(ErrorKind::ArgumentConflict, text)
}
