//! `gamow paper`: every figure and number of the paper, beside those of the published and the exact model.
//!
//! The paper: E. A. Cryer-Jenkins and P. D. Stevenson, *Gamow's cyclist: a new look at relativistic
//! measurements for a binocular observer*, Proc. R. Soc. A 476 (2020), doi 10.1098/rspa.2019.0703.

mod bicycle;
mod curves;
mod figures;
mod fits;
mod numbers;
mod report;
mod stereo;
mod values;

use std::path::PathBuf;

use anyhow::Context as _;
use clap::Args;
use gamow_platform::{files, progress, sizes};

use crate::files::html::{HtmlPage, PageStyle};
use crate::files::whole::say;
use crate::formula::markdown::Markdown;

/// Reproduces the paper: its figures as SVG, CSV and PNG, and a report with its numbers beside ours.
///
/// Every number that the paper states stands beside that of its own model (Appendix A) and of the exact
/// model, with its errata explained. The report names what cannot be reproduced. It is written as
/// report.html, one page with its figures, and as report.md.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES)]
pub struct PaperArgs {
    /// Folder to write to; it is created if it does not exist.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  gamow paper --out paper";

/// Runs the command `gamow paper`.
pub fn run(args: &PaperArgs) -> anyhow::Result<()> {
    let folder = args.out.as_path();
    files::create_folder(folder).with_context(|| files::shown(folder))?;
    let progress = progress::bar(stereo::frames() + 1, "frames and fits");
    figures::write_all(folder)?;
    let fits = fits::write_all(folder)?;
    progress.inc(1);
    let frames = stereo::write_all(folder, || progress.inc(1))?;
    let errors = fits::errors_of_published()?;
    progress.finish_and_clear();
    let report = report::PaperReport {
        numbers: numbers::rows()?,
        fits,
        errors,
        bias: fits::bias_of_published()?,
        frames: stereo::FIGURES.iter().zip(frames).collect(),
    };
    let text = report.to_string();
    let mut page = HtmlPage::new("Gamow's cyclist, reproduced", PageStyle::Screen);
    page.markdown(&Markdown::new(&*text), |figure| {
        Ok(String::from_utf8(files::read(&folder.join(figure), sizes::FILE_BYTES)?)?)
    })?;
    figures::write_text(folder, "report.md", &text)?;
    figures::write_text(folder, "report.html", &page.finish())?;
    say(|out| Ok(writeln!(out, "{}", files::shown(&folder.join("report.html")))?))
}
