//! `gamow lesson`: what goes with a lesson on paper.

pub mod list;

use std::io::Write as _;
use std::path::PathBuf;

use clap::Args;

use crate::files::whole::{ensure_ending, write_whole};
use crate::lesson::{Library, worksheet};

/// Writes the worksheet of a lesson: one page to print, with the pictures, the questions, room for answers, and the data of
/// its lab.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct LessonArgs {
    /// Name of the lesson or preset (`gamow --list`), or a file.
    #[arg(value_name = "NAME|FILE.md")]
    name: PathBuf,
    /// The page that is written.
    #[arg(long, value_name = "FILE.html")]
    worksheet: PathBuf,
    /// With the answers, for whoever teaches.
    #[arg(long)]
    answers: bool,
    /// A folder with lessons of one's own, beside the program's.
    #[arg(long, value_name = "DIR")]
    lessons: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  gamow lesson rods --worksheet rods.html
  gamow lesson rods --worksheet rods-answers.html --answers";

/// Runs `gamow lesson`.
pub fn run(args: &LessonArgs) -> anyhow::Result<()> {
    ensure_ending("--worksheet", &args.worksheet, "html")?;
    let lesson = Library::new(args.lessons.as_deref())?.open(&args.name)?.worked_out()?;
    let page = worksheet::page(&lesson, args.answers)?;
    write_whole(&args.worksheet, |file| Ok(file.write_all(page.as_bytes())?))
}
