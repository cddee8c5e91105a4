//! `gamow lesson`: what goes with a lesson on paper.

pub mod list;

use std::io::Write as _;
use std::path::PathBuf;

use clap::{ArgGroup, Args};
use gamow_platform::progress;

use crate::files::whole::{ensure_ending, write_whole};
use crate::lesson::Library;
use crate::lesson::worksheet::{self, SheetKind};

/// Writes what goes with a lesson on paper: the worksheet with its questions, the task and the data of its
/// lab, a page for whoever teaches. At least one of them must be named.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES, group = ArgGroup::new("sheets").required(true).multiple(true))]
pub struct LessonArgs {
    /// Name of the lesson or preset (`gamow --list`), or a file.
    #[arg(value_name = "NAME|FILE.md")]
    name: PathBuf,
    /// Write the worksheet to this file: questions with room for answers.
    #[arg(long, value_name = "FILE.html", group = "sheets")]
    worksheet: Option<PathBuf>,
    /// Write the answers in place of the worksheet.
    #[arg(long, requires = "worksheet")]
    answers: bool,
    /// Write the sheet of the lab to this file, with its data.
    #[arg(long, value_name = "FILE.html", group = "sheets")]
    lab: Option<PathBuf>,
    /// Write the teacher's page to this file: aim, minutes, what to say, what pupils answer, what can go
    /// wrong.
    #[arg(long, value_name = "FILE.html", group = "sheets")]
    teacher: Option<PathBuf>,
    /// A folder with your own lessons, beside the program's.
    #[arg(long, value_name = "DIR")]
    lessons: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  gamow lesson rods --worksheet rods.html
  gamow lesson rods --worksheet rods-answers.html --answers
  gamow lesson rods --teacher rods-teacher.html --lab rods-lab.html";

/// Runs the command `gamow lesson`.
pub fn run(args: &LessonArgs) -> anyhow::Result<()> {
    let of_questions = if args.answers { SheetKind::Answers } else { SheetKind::Questions };
    let sheets = [
        ("--worksheet", &args.worksheet, of_questions),
        ("--lab", &args.lab, SheetKind::Lab),
        ("--teacher", &args.teacher, SheetKind::Teacher),
    ];
    let sheets: Vec<_> =
        sheets.into_iter().filter_map(|(flag, path, sheet)| Some((flag, path.as_ref()?, sheet))).collect();
    for (flag, path, _) in &sheets {
        ensure_ending(flag, path, "html")?;
    }
    let lesson = Library::new(args.lessons.as_deref())?.open(&args.name)?.worked_out()?;
    // All are made before one is written.
    let progress = progress::bar((sheets.len() * lesson.steps.len()) as u64, "steps");
    let page = |sheet| worksheet::page(&lesson, sheet, || progress.inc(1));
    let pages = sheets.iter().map(|(_, path, sheet)| Ok((path, page(*sheet)?)));
    let pages = pages.collect::<anyhow::Result<Vec<_>>>()?;
    progress.finish_and_clear();
    for (path, page) in pages {
        write_whole(path, |file| Ok(file.write_all(page.as_bytes())?))?;
    }
    Ok(())
}
