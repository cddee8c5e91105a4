//! `gamow lesson`: what goes with a lesson on paper.

pub mod list;

use std::io::Write as _;
use std::path::PathBuf;

use clap::{ArgGroup, Args};
use gamow_platform::{messages, progress};

use crate::files::whole::{ensure_ending, write_whole};
use crate::lesson::Library;
use crate::lesson::class::{self, Collected};
use crate::lesson::worksheet::{self, SheetKind};

/// Writes what goes with a lesson on paper: the worksheet with its questions, the task and the data of its
/// lab, a page for whoever teaches, and a page of the class's answers. At least one of them must be named.
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
    /// Write the class's page to this file: how its pupils have answered each question.
    #[arg(long, value_name = "FILE.html", group = "sheets", requires = "from")]
    class: Option<PathBuf>,
    /// Files with the pupils' answers, for the class's page: texts and tables with their links, reports. `-`
    /// is standard input.
    #[arg(long, value_name = "FILE", num_args = 1.., requires = "class")]
    from: Vec<PathBuf>,
    /// A folder with your own lessons, beside the program's.
    #[arg(long, value_name = "DIR")]
    lessons: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  gamow lesson rods --worksheet rods.html
  gamow lesson rods --worksheet rods-answers.html --answers
  gamow lesson rods --teacher rods-teacher.html --lab rods-lab.html
  gamow lesson rods --class rods-class.html --from answers.csv";

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
    let named = sheets
        .iter()
        .map(|(flag, path, _)| (*flag, *path))
        .chain(args.class.iter().map(|path| ("--class", path)));
    for (flag, path) in named {
        ensure_ending(flag, path, "html")?;
    }
    let library = Library::new(args.lessons.as_deref())?;
    let opened = library.open(&args.name)?;
    let lesson = opened.worked_out()?;
    // All are made before one is written.
    let progress = progress::bar((sheets.len() * lesson.steps.len()) as u64, "steps");
    let page = |sheet| worksheet::page(&lesson, sheet, || progress.inc(1));
    let pages = sheets.iter().map(|(_, path, sheet)| Ok((*path, page(*sheet)?)));
    let mut pages = pages.collect::<anyhow::Result<Vec<_>>>()?;
    if let Some(path) = &args.class {
        let mut collected = Collected::default();
        for file in &args.from {
            collected.add_file(file)?;
        }
        pages.push((path, class::page(&[&opened], &collected, || {})?));
        for unread in &collected.unread {
            messages::remark(format_args!("gamow: {unread}"));
        }
    }
    progress.finish_and_clear();
    for (path, page) in pages {
        write_whole(path, |file| Ok(file.write_all(page.as_bytes())?))?;
    }
    Ok(())
}
