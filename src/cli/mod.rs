//! The command line, and its dispatch. Each command's own flags are beside its code in `commands`.

mod errors;
mod help;

use std::ffi::OsString;
use std::process::ExitCode;

use anyhow::Context as _;
use clap::parser::ValueSource;
use clap::{ArgMatches, Args, Command, CommandFactory as _, FromArgMatches as _, Parser, Subcommand};
use gamow_platform::{environment, messages, threads};

use crate::app::shell::args::WindowArgs;
use crate::app::shell::launch;
use crate::commands;

/// Interactive stereo viewer of special relativity: what each eye sees, exactly.
///
/// Without a command it opens the window, as it was left but for what the flags set.
#[derive(Debug, Parser)]
#[command(version, override_usage = USAGE, before_long_help = EXAMPLES, after_help = CONVENTIONS)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<HeadlessCommand>,
    #[command(flatten)]
    process: ProcessArgs,
    #[command(flatten)]
    window: WindowArgs,
}

/// Flags of the window and of every command, before or behind its name.
#[derive(Debug, Clone, Copy, Args)]
struct ProcessArgs {
    /// Number of threads that compute, 1 to 1024 [default: one for each processor]
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Say nothing beside results and errors: no remarks, no progress.
    #[arg(long, global = true)]
    quiet: bool,
}

const USAGE: &str = "gamow [OPTIONS]\n       gamow <COMMAND>";

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

`gamow COMMAND --help` tells more, `gamow COMMAND -h` in short, `gamow --help ride` of one section of flags or of one flag.";

/// The commands that need no window.
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
    Completions(commands::completions::CompletionsArgs),
    Man(commands::man::ManArgs),
}

/// Runs the command line of these `words`, the first of which names the program. Gives the exit status.
///
/// # Errors
///
/// Those of the command, and help that does not exist or cannot be written.
pub fn run(mut words: Vec<OsString>) -> anyhow::Result<ExitCode> {
    let command = help::as_wanted(Cli::command(), &mut words)?;
    match parsed(command, &words) {
        Ok(cli) => cli.run().map(|()| ExitCode::SUCCESS),
        Err(error) if error.use_stderr() => {
            let words: Vec<_> = words.iter().map(|word| word.to_string_lossy().into_owned()).collect();
            anyhow::bail!(errors::in_one_line(&built(), &words, &error))
        }
        Err(help) => help.print().context("standard output").map(|()| ExitCode::SUCCESS),
    }
}

/// Returns what the `words` mean to `command`, which is that of [`Cli`].
fn parsed(command: Command, words: &[OsString]) -> Result<Cli, clap::Error> {
    let matches = command.try_get_matches_from(words)?;
    check_place(&matches)?;
    Cli::from_arg_matches(&matches)
}

/// Refuses flags of the window before the name of a command, which has its own behind it.
fn check_place(matches: &ArgMatches) -> Result<(), clap::Error> {
    let Some((name, _)) = matches.subcommand() else { return Ok(()) };
    let command = Cli::command();
    let is_given =
        |flag: &&clap::Arg| matches.value_source(flag.get_id().as_str()) == Some(ValueSource::CommandLine);
    match command.get_arguments().filter(|flag| !flag.is_global_set()).find(is_given) {
        None => Ok(()),
        Some(flag) => Err(errors::misplaced(flag.get_long().unwrap_or_default(), name)),
    }
}

/// The whole command line, with the flags that all commands share in each.
fn built() -> Command {
    let mut command = Cli::command();
    command.build();
    command
}

impl Cli {
    /// Runs what the command line asks for.
    fn run(self) -> anyhow::Result<()> {
        if self.draws_without_a_window() {
            environment::settle_without_session();
        }
        if self.process.quiet {
            messages::be_quiet();
        }
        self.process.threads.map_or(Ok(()), |threads| threads::limit(threads.into()))?;
        match self.command {
            None if self.window.list => match self.window.named_scene()? {
                Some(scene) => commands::lesson::list::list_bodies(&scene, self.window.json),
                None => commands::lesson::list::list(&self.window.library()?, self.window.json),
            },
            None => launch::launch(&self.window),
            Some(HeadlessCommand::Eval(args)) => commands::eval::run(&args),
            Some(HeadlessCommand::Curve(args)) => commands::curve::run(&args),
            Some(HeadlessCommand::Fit(args)) => commands::fit::run(&args),
            Some(HeadlessCommand::Lesson(args)) => commands::lesson::run(&args),
            Some(HeadlessCommand::Measure(args)) => commands::measure::run(&args),
            Some(HeadlessCommand::Paper(args)) => commands::paper::run(&args),
            Some(HeadlessCommand::Rectify(args)) => commands::rectify::run(&args),
            Some(HeadlessCommand::Render(args)) => commands::render::run(&args),
            Some(HeadlessCommand::Accuracy(args)) => commands::accuracy::run(&args),
            Some(HeadlessCommand::Completions(args)) => commands::completions::run(&args, built()),
            Some(HeadlessCommand::Man(args)) => commands::man::run(&args, &built()),
        }
    }

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
                | HeadlessCommand::Rectify(_)
                | HeadlessCommand::Completions(_)
                | HeadlessCommand::Man(_),
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
