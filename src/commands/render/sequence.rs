//! Sequences of frames in a folder, which can be broken off and taken up again.

use std::path::Path;

use anyhow::Context as _;
use clap::Args;

use super::vr180;
use crate::flags::choices::FileKind;
use crate::flags::finite_number;
use crate::passage::{passage_times, time_within};
use crate::platform::{files, progress};
use crate::studio::Studio;
use crate::studio::film::frame_path;

/// Flags of a sequence.
#[derive(Debug, Clone, Args)]
pub struct TimeArgs {
    /// Make a sequence of N frames.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..), conflicts_with = "time")]
    pub frames: Option<u32>,
    /// Make the frames of a sequence .exr files of what every pixel shows, not .png pictures.
    #[arg(long, requires = "frames")]
    exr: bool,
    /// Observation time of the first frame [default: when the tracked point is seen at x = -2 R, R being
    /// its distance at x = 0]
    #[arg(long, value_name = "T", value_parser = finite_number, allow_hyphen_values = true, requires = "frames")]
    from: Option<f64>,
    /// Observation time of the last frame [default: when the tracked point is seen at x = +2 R]
    #[arg(long, value_name = "T", value_parser = finite_number, allow_hyphen_values = true, requires = "frames")]
    to: Option<f64>,
}

impl TimeArgs {
    /// Observation times of the first and the last frame.
    fn range(&self, studio: &Studio) -> anyhow::Result<[f64; 2]> {
        if let (Some(from), Some(to)) = (self.from, self.to) {
            return Ok([from, to]);
        }
        let settings = studio.settings();
        let passage = passage_times(
            &settings.velocity(studio.tracked().motion).speed,
            settings.source(&studio.tracked()),
            settings.pair(),
        )?;
        let passage = passage.context("a scene at rest passes at no time; --from and --to are needed")?;
        Ok([self.from.unwrap_or(passage[0]), self.to.unwrap_or(passage[1])])
    }
}

/// Draws the frames into `folder` as `frame_00000.png` (or .exr) and so on. Frames that are there already, whole and
/// with the same parameters, are kept. (Those for headsets have longer names.)
pub fn run(studio: &mut Studio, times: &TimeArgs, folder: &Path) -> anyhow::Result<()> {
    let frames = times.frames.unwrap_or(1);
    let range = times.range(studio)?;
    files::create_folder(folder).with_context(|| folder.display().to_string())?;
    let progress = progress::bar(frames.into(), "frames");
    let kind = if times.exr { FileKind::Exr } else { FileKind::Png };
    let mut kept = 0;
    for frame in 0..frames {
        let time = time_within(range, f64::from(frame) / f64::from(frames.max(2) - 1));
        let path = vr180::named(studio.settings(), &frame_path(folder, frame, kind));
        let frame = studio.frame(Some(time))?;
        if frame.is_made(kind, &path) {
            kept += 1;
        } else {
            studio.make_file(&frame, kind, &path)?;
        }
        progress.inc(1);
    }
    progress.finish_and_clear();
    eprintln!("{} frames drawn and {kept} kept in {}", frames - kept, folder.display());
    Ok(())
}
