//! `gamow man`: the manual pages, made from the flags.

use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::Context as _;
use clap::{Args, Command};
use clap_mangen::Man;
use gamow_platform::files;

use crate::files::whole::write_whole;

/// Writes the manual pages of the program and of its commands.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES)]
pub struct ManArgs {
    /// Folder to write to; it is created if it does not exist.
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  gamow man man1 && man -l man1/gamow-render.1
  gamow man ~/.local/share/man/man1";

/// Runs the command `gamow man` for the whole `program`.
pub fn run(args: &ManArgs, program: &Command) -> anyhow::Result<()> {
    files::create_folder(&args.folder).with_context(|| files::shown(&args.folder))?;
    let own = program.get_subcommands().filter(|command| command.get_name() != "help");
    for command in [program].into_iter().chain(own) {
        let page = page(command)?;
        let path = args.folder.join(format!("{}.1", page_name(command)));
        write_whole(&path, |file| Ok(file.write_all(&page)?))?;
    }
    Ok(())
}

/// The name of the page of a command: `gamow-render`.
fn page_name(command: &Command) -> &str {
    command.get_display_name().unwrap_or_else(|| command.get_name())
}

/// Returns the manual page of `command`, in roff.
fn page(command: &Command) -> anyhow::Result<Vec<u8>> {
    let usage = command.clone().render_usage().to_string();
    let named = command.clone().override_usage(usage.trim_start_matches("Usage: ").to_owned());
    let version = concat!("gamow ", env!("CARGO_PKG_VERSION"));
    let man = Man::new(named).title(page_name(command)).source(version).manual("Gamow");
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    man.render_description_section(&mut page)?;
    let examples = command.get_before_long_help().map(ToString::to_string).unwrap_or_default();
    write_lines(&mut page, "EXAMPLES", examples.trim_start_matches("Examples:\n"))?;
    if command.has_subcommands() {
        man.render_subcommands_section(&mut page)?;
    }
    man.render_options_section(&mut page)?;
    let notes = command.get_after_long_help().or_else(|| command.get_after_help());
    write_section(&mut page, "NOTES", &notes.map(ToString::to_string).unwrap_or_default())?;
    let others = program_pages(command);
    write_section(&mut page, "SEE ALSO", &others)?;
    Ok(page)
}

/// The pages that somebody who reads that of `command` looks for next.
fn program_pages(command: &Command) -> String {
    let own = command.get_subcommands().filter(|command| command.get_name() != "help");
    let own: Vec<_> = own.map(|command| format!("{}(1)", page_name(command))).collect();
    if own.is_empty() { "gamow(1)".to_owned() } else { own.join(", ") }
}

/// Writes a section whose lines stand as they are.
fn write_lines(page: &mut impl Write, title: &str, text: &str) -> io::Result<()> {
    if text.is_empty() {
        return Ok(());
    }
    writeln!(page, ".SH \"{title}\"\n.nf")?;
    text.lines().try_for_each(|line| writeln!(page, "{}", roff(line.trim())))?;
    writeln!(page, ".fi")
}

/// Writes a section of paragraphs, and of lists whose lines are indented: a term, and behind two blanks what
/// it is.
fn write_section(page: &mut impl Write, title: &str, text: &str) -> io::Result<()> {
    if text.is_empty() {
        return Ok(());
    }
    writeln!(page, ".SH \"{title}\"")?;
    let mut is_in_list = false;
    for line in text.lines() {
        let term = line
            .strip_prefix("  ")
            .and_then(|line| line.split_once("  "))
            .filter(|(term, _)| !term.is_empty());
        match term {
            Some((term, text)) => writeln!(page, ".TP\n\\fB{}\\fR\n{}", roff(term), roff(text.trim()))?,
            None if line.is_empty() => writeln!(page, ".PP")?,
            None if is_in_list && !line.starts_with(' ') => writeln!(page, ".PP\n{}", roff(line))?,
            None => writeln!(page, "{}", roff(line.trim()))?,
        }
        is_in_list = line.starts_with(' ');
    }
    Ok(())
}

/// Returns a line of text in which roff finds no request.
fn roff(line: &str) -> String {
    let escaped = line.replace('\\', "\\e").replace('-', "\\-");
    if escaped.starts_with(['.', '\'']) { format!("\\&{escaped}") } else { escaped }
}
