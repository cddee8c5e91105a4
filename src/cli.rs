//! The command line, and its dispatch. Each command's own flags are beside its code in `commands`.

use std::process::ExitCode;

use anyhow::Context as _;
use clap::builder::Styles;
use clap::{CommandFactory as _, Parser, Subcommand};
use gamow_platform::{environment, messages};

use crate::app::shell::args::WindowArgs;
use crate::app::shell::launch;
use crate::commands;

/// Interactive stereo viewer of special relativity: what each eye sees, exactly.
///
/// Without a command it opens the window, as it was left but for what the flags set.
#[derive(Debug, Parser)]
#[command(version, before_help = EXAMPLES, after_help = CONVENTIONS, args_conflicts_with_subcommands = true)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<HeadlessCommand>,
    #[command(flatten)]
    window: WindowArgs,
}

const EXAMPLES: &str = "\
Examples:
  gamow
  gamow --scene street --beta 0.99 --time 1 --screenshot window.png
  gamow curve --beta 0.9 --d 0.3 --y 0.5 --z 0.5 --from -2 --to 5
  gamow curve --samples 1000 --out curve.csv
  gamow curve | cut -d, -f 1-6 | gamow eval --model published";

const CONVENTIONS: &str = "\
Conventions: c = 1; lengths and times share one unit; angles are radians. x points along the motion, y forward, z up. \
The eyes rest at x = -d/2 (left) and x = +d/2 (right).

`gamow COMMAND --help` tells more.";

/// A headless command.
#[derive(Debug, Subcommand)]
enum HeadlessCommand {
    Eval(commands::eval::EvalArgs),
    Curve(commands::curve::CurveArgs),
    Fit(commands::fit::FitArgs),
    Lesson(commands::lesson::LessonArgs),
    Measure(commands::measure::MeasureArgs),
    Paper(commands::paper::PaperArgs),
    Rectify(commands::rectify::RectifyArgs),
    Render(Box<commands::render::RenderArgs>),
    Accuracy(commands::accuracy::AccuracyArgs),
}

/// Runs what the command line asks for.
pub fn run(cli: Cli) -> anyhow::Result<()> {
    if cli.draws_without_a_window() {
        environment::settle_without_session();
    }
    match cli.command {
        None if cli.window.list => match cli.window.named_scene()? {
            Some(scene) => commands::lesson::list::list_bodies(&scene),
            None => commands::lesson::list::list(&cli.window.library()?),
        },
        None => launch::launch(&cli.window),
        Some(HeadlessCommand::Eval(args)) => commands::eval::run(&args),
        Some(HeadlessCommand::Curve(args)) => commands::curve::run(&args),
        Some(HeadlessCommand::Fit(args)) => commands::fit::run(&args),
        Some(HeadlessCommand::Lesson(args)) => commands::lesson::run(&args),
        Some(HeadlessCommand::Measure(args)) => commands::measure::run(&args),
        Some(HeadlessCommand::Paper(args)) => commands::paper::run(&args),
        Some(HeadlessCommand::Rectify(args)) => commands::rectify::run(&args),
        Some(HeadlessCommand::Render(args)) => commands::render::run(&args),
        Some(HeadlessCommand::Accuracy(args)) => commands::accuracy::run(&args),
    }
}

/// Says what `error` has in place of a command: help on standard output, or what is wrong with the command
/// line. Gives the exit status.
///
/// # Errors
///
/// Help that cannot be written.
pub fn explain(error: &clap::Error) -> anyhow::Result<ExitCode> {
    if !error.use_stderr() {
        error.print().context("standard output")?;
        return Ok(ExitCode::SUCCESS);
    }
    match quoted(environment::arguments().map(|word| word.to_string_lossy().into_owned()).collect()) {
        Some(text) => messages::remark_lines(&text),
        // Where that cannot be written to, nobody is told.
        None => drop(error.print()),
    }
    Ok(ExitCode::from(USAGE))
}

/// Exit status of a command line that makes no sense.
const USAGE: u8 = 2;

/// Returns the error in the command line of these `words`, if any of them would have to be quoted: then
/// without colours, since these are what a terminal obeys too.
fn quoted(words: Vec<String>) -> Option<String> {
    let mut odd = words.clone();
    odd.retain(|word| messages::shown(word) != *word);
    if odd.is_empty() {
        return None;
    }
    let error = Cli::command().styles(Styles::plain()).try_get_matches_from(words).err()?;
    let mut text = error.render().ansi().to_string();
    for word in odd {
        let value = word.split_once('=').map_or(word.as_str(), |(_, value)| value);
        for part in [word.as_str(), value].into_iter().filter(|part| !part.trim().is_empty()) {
            text = text.replace(part, &messages::shown(part));
        }
    }
    Some(messages::shown_lines(&text))
}

impl Cli {
    /// Returns whether a graphics device may be used although no window is to appear.
    const fn draws_without_a_window(&self) -> bool {
        match self.command {
            None => self.window.screenshot.is_some(),
            Some(HeadlessCommand::Paper(_) | HeadlessCommand::Render(_) | HeadlessCommand::Accuracy(_)) => {
                true
            }
            Some(
                HeadlessCommand::Eval(_)
                | HeadlessCommand::Curve(_)
                | HeadlessCommand::Fit(_)
                | HeadlessCommand::Lesson(_)
                | HeadlessCommand::Measure(_)
                | HeadlessCommand::Rectify(_),
            ) => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::{Arg, Command, CommandFactory as _};

    use crate::cli::*;

    /// Words with which no sentence ends.
    const UNFINISHED: [&str; 15] =
        ["a", "an", "and", "as", "by", "for", "from", "if", "in", "of", "or", "out", "the", "to", "with"];

    fn assert_finished(place: &str, text: &str) {
        // What says a default, and what follows, comes after the sentence.
        let sentence = text.split(" [default").next().unwrap_or_default().trim_end_matches('.');
        let last = sentence.rsplit([' ', ',']).next().unwrap_or_default();
        assert!(!UNFINISHED.contains(&last), "{place}: {text}");
        assert!(
            sentence.starts_with(char::is_alphabetic) && !sentence.ends_with([',', ':', ';']),
            "{place}: {text}"
        );
        assert_eq!(sentence.matches('(').count(), sentence.matches(')').count(), "{place}: {text}");
        assert_eq!(sentence.matches('`').count() % 2, 0, "{place}: {text}");
    }

    fn assert_flags_finished(command: &Command) {
        let about = [command.get_about(), command.get_long_about()];
        about.into_iter().flatten().for_each(|text| assert_finished(command.get_name(), &text.to_string()));
        for flag in command.get_arguments() {
            let place = format!("{} {}", command.get_name(), flag.get_id());
            let texts = [flag.get_help(), flag.get_long_help()];
            texts.into_iter().flatten().for_each(|text| assert_finished(&place, &text.to_string()));
            assert!(flag.get_help().is_some() || is_claps(flag), "{place} has no help");
            for value in flag.get_possible_values() {
                value.get_help().into_iter().for_each(|text| assert_finished(&place, &text.to_string()));
            }
        }
        command.get_subcommands().for_each(assert_flags_finished);
    }

    fn is_claps(flag: &Arg) -> bool {
        ["help", "version", "subcommand"].contains(&flag.get_id().as_str())
    }

    #[test]
    fn no_help_ends_in_mid_sentence() {
        let mut command = Cli::command();
        command.build();
        assert_flags_finished(&command);
    }
}
