//! Help in parts: the short help, which fits a screen, and the help of one section of flags.

use std::ffi::OsString;

use clap::builder::Str;
use clap::{Arg, ArgAction, Command};
use gamow_platform::messages;

use crate::similar::did_you_mean;

/// Width of the short help, characters, and the blanks around the names of flags and of commands.
const WIDTH: usize = 80;
const BLANKS: usize = 8;
const BLANKS_OF_COMMAND: usize = 6;
/// Greatest length of the name of a value in the short help, characters.
const VALUE_LETTERS: usize = 11;

/// Returns `command` as the `words` of a command line want its help: shortened for `-h`, narrowed to one
/// section by `--help SECTION`, else as it is. Words that name a section are replaced by those that ask for
/// the help.
///
/// # Errors
///
/// A section that does not exist.
pub fn as_wanted(command: Command, words: &mut Vec<OsString>) -> anyhow::Result<Command> {
    let texts: Vec<_> = words.iter().skip(1).map_while(|word| word.to_str()).collect();
    let texts = texts.split(|word| *word == "--").next().unwrap_or_default();
    let asks = |word: &&str| *word == "-h" || *word == "--help" || word.starts_with("--help=");
    let Some(place) = texts.iter().position(asks) else { return Ok(command) };
    let own = texts[..place].iter().find_map(|word| command.find_subcommand(word)).unwrap_or(&command);
    let name = own.get_name().to_owned();
    let given = texts[place].strip_prefix("--help=").or_else(|| texts.get(place + 1).copied());
    let topic = match given.filter(|word| !word.starts_with('-')) {
        _ if texts[place] == "-h" => return Ok(shortened(command)),
        None => return Ok(command),
        Some(topic) => topic.to_lowercase(),
    };
    if own.find_subcommand(&topic).is_some() {
        *words = ["gamow", &topic, "--help"].map(OsString::from).into();
        return Ok(command);
    }
    let section = section(own, &topic)?;
    let of_command = Some(&name).filter(|name| *name != command.get_name());
    *words = ["gamow"]
        .into_iter()
        .chain(of_command.map(String::as_str))
        .chain(["--help"])
        .map(OsString::from)
        .collect();
    let narrow = |command: Command| narrowed(command, section.as_deref());
    Ok(match of_command {
        // Flags of all commands are those of the whole program.
        Some(name) => command.mut_args(|flag| flag.hide(true)).mut_subcommand(name, narrow),
        None => narrow(command),
    })
}

/// Returns the headings of the sections of flags, in order.
fn sections(command: &Command) -> Vec<&str> {
    let mut sections = Vec::new();
    for heading in
        command.get_arguments().filter(|flag| !flag.is_hide_set()).filter_map(Arg::get_help_heading)
    {
        if !sections.contains(&heading) {
            sections.push(heading);
        }
    }
    sections
}

/// Returns the heading of the section of `command` that is called `topic`, or that has a flag of that name;
/// `None` for that without a heading.
fn section(command: &Command, topic: &str) -> anyhow::Result<Option<String>> {
    let sections = sections(command);
    if let Some(section) = sections.iter().find(|section| section.to_lowercase() == topic) {
        return Ok(Some((*section).to_owned()));
    }
    let shown = || command.get_arguments().filter(|flag| !flag.is_hide_set());
    if let Some(flag) = shown().find(|flag| flag.get_long() == Some(topic)) {
        return Ok(flag.get_help_heading().map(str::to_owned));
    }
    let names: Vec<_> = sections.iter().map(|section| section.to_lowercase()).collect();
    let known = names.iter().map(String::as_str).chain(shown().filter_map(Arg::get_long));
    let (near, topic) = (did_you_mean(known, topic), messages::excerpt(topic));
    let there_are =
        if names.is_empty() { "it has none".to_owned() } else { format!("there are {}", names.join(", ")) };
    anyhow::bail!("--help: there is no section and no flag called `{topic}`{near}: {there_are}")
}

/// Returns `command` with a help that shows the flags of one section alone.
fn narrowed(command: Command, section: Option<&str>) -> Command {
    let help = Arg::new("help").long("help").action(ArgAction::HelpLong).hide(true);
    command
        .mut_args(|flag| {
            let is_hidden = flag.is_hide_set() || flag.get_help_heading() != section;
            flag.hide(is_hidden)
        })
        .mut_subcommands(|command| command.hide(true))
        .disable_help_flag(true)
        .disable_version_flag(true)
        .disable_help_subcommand(true)
        .arg(help)
        .help_template("{all-args}")
}

/// Returns `command` and its own commands with a help that fits a screen: a line for each flag without a
/// heading, and the names of the sections.
fn shortened(command: Command) -> Command {
    let name = command.get_bin_name().unwrap_or_else(|| command.get_name()).to_owned();
    let sections: Vec<_> = sections(&command).iter().map(|section| section.to_lowercase()).collect();
    let more = match sections.as_slice() {
        [] => format!("More: {name} --help"),
        [first, ..] => {
            format!("More: {name} --help, or a section, as by --help {first}: {}", sections.join(", "))
        }
    };
    let commands = command.get_subcommands().map(|command| command.get_name().len()).max();
    let left_of_command = WIDTH - BLANKS_OF_COMMAND - commands.unwrap_or_default();
    let command =
        command.before_help(None::<&str>).after_help(more).mut_args(with_short_value).mut_subcommands(
            |command| {
                let name = format!("{name} {}", command.get_name());
                let about = command.get_about().map(|about| begin(&about.to_string(), left_of_command));
                shortened(command.bin_name(name)).about(about.unwrap_or_default())
            },
        );
    let shown = |flag: &&Arg| !flag.is_hide_set() && !flag.is_positional();
    let longest = command.get_arguments().filter(shown).map(width).max();
    let left = WIDTH - BLANKS - longest.unwrap_or_default();
    command.mut_args(|flag| {
        let text = flag.get_help().map(ToString::to_string).unwrap_or_default();
        let defaults = flag.get_default_values().iter().map(|value| " [default: ]".len() + value.len()).sum();
        flag.help(begin(&text, left.saturating_sub(defaults)))
    })
}

/// Returns the width of a flag with its value in the help: `--scene <FILE>`.
fn width(flag: &Arg) -> usize {
    let value =
        flag.get_value_names().and_then(|names| names.first()).filter(|_| flag.get_action().takes_values());
    flag.get_long().map_or(0, |long| long.len() + "--".len())
        + value.map_or(0, |value| value.len() + " <>".len())
}

/// Returns `flag` as the short help shows it: not at all with a heading, without a list of its values, and
/// without a name of its value that is long.
fn with_short_value(flag: Arg) -> Arg {
    let is_hidden = flag.is_hide_set() || flag.get_help_heading().is_some();
    let flag = flag.hide(is_hidden);
    if !flag.get_action().takes_values() {
        return flag;
    }
    let has_long_name = |name: &Str| name.len() > VALUE_LETTERS;
    let is_long =
        !flag.is_positional() && flag.get_value_names().is_some_and(|names| names.iter().any(has_long_name));
    let flag = flag.hide_possible_values(true);
    if is_long { flag.value_name("...") } else { flag }
}

/// Returns the begin of a sentence, without brackets: at most this number of `letters`, if it can be cut
/// between its clauses; else the first of these.
fn begin(sentence: &str, letters: usize) -> String {
    let fits = |text: &str| text.chars().count() <= letters;
    let whole = sentence.trim_end_matches('.');
    let bare = whole.find(" (").into_iter().chain(whole.find(" [")).min().map_or(whole, |end| &whole[..end]);
    if let Some(text) = [whole, bare].into_iter().find(|text| fits(text)) {
        return text.to_owned();
    }
    // At a comma may be the middle of a list.
    [[": ", "; ", ". "], [", "; 3]]
        .iter()
        .find_map(|ends| {
            let mut places: Vec<_> =
                ends.iter().flat_map(|end| bare.match_indices(end).map(|(at, _)| &bare[..at])).collect();
            places.sort_unstable_by_key(|text| text.len());
            places.into_iter().rfind(|text| fits(text))
        })
        .unwrap_or(bare)
        .to_owned()
}
