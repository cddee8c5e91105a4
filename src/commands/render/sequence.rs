//! Sequences of frames in a folder, which can be broken off and taken up again.

use std::fmt;
use std::path::Path;
use std::str::FromStr;

use anyhow::Context as _;
use clap::Args;
use gamow_platform::progress::{self, ProgressBar};
use gamow_platform::{files, messages};

use super::vr180;
use crate::flags::choices::{FileKind, RendererChoice, Size};
use crate::flags::finite_number;
use crate::number_text;
use crate::studio::Studio;
use crate::studio::film::{FilmKind, Written, frame_path};
use crate::time_range::{passage_times, time_within};

/// Flags of a sequence.
#[derive(Debug, Clone, Args)]
pub struct TimeArgs {
    /// Make a sequence of N frames, 1 to 1000000.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000), conflicts_with = "time")]
    pub frames: Option<u32>,
    /// Draw one part of a sequence alone: every Kth frame, beginning with the Ith. K runs with I from 1 to K,
    /// on any machines that share the folder, draw each frame once. The renderer must be named, so that all
    /// parts are drawn alike.
    #[arg(long, value_name = "I/K", requires = "frames")]
    part: Option<SequencePart>,
    /// Make .exr files of what every pixel shows: the frames of a sequence, in place of .png pictures.
    #[arg(long, requires = "frames")]
    exr: bool,
    /// Observation time of the first frame [default: when the tracked point is seen at x = -2 R, R being
    /// its distance at x = 0; 0 on a ride that changes its speed]
    #[arg(long, value_name = "T", value_parser = finite_number, allow_hyphen_values = true, requires = "frames")]
    from: Option<f64>,
    /// Observation time of the last frame [default: when the tracked point is seen at x = +2 R, or the ride
    /// ends]
    #[arg(long, value_name = "T", value_parser = finite_number, allow_hyphen_values = true, requires = "frames")]
    to: Option<f64>,
}

/// A part of the frames of a sequence: part `index`, from 0, of `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct SequencePart {
    index: u32,
    count: u32,
}

impl SequencePart {
    const WHOLE: Self = Self { index: 0, count: 1 };

    /// Returns the numbers of the frames in this part of a sequence of `frames` frames.
    fn frames(self, frames: u32) -> impl Iterator<Item = u32> {
        (self.index..frames).step_by(self.count as usize)
    }
}

impl FromStr for SequencePart {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let numbers = text.split_once('/').map(|(index, count)| [index.parse(), count.parse()]);
        match numbers {
            Some([Ok(number), Ok(count)]) if (1..=count).contains(&number) => {
                Ok(Self { index: number - 1, count })
            }
            _ => Err("must be I/K, such as 2/8: part I, from 1 to K, of K parts"),
        }
    }
}

impl fmt::Display for SequencePart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index + 1, self.count)
    }
}

impl TimeArgs {
    /// Observation times of the first and the last frame.
    fn range(&self, studio: &Studio) -> anyhow::Result<[f64; 2]> {
        if let (Some(from), Some(to)) = (self.from, self.to) {
            return Ok([from, to]);
        }
        let settings = studio.settings();
        let passage = match settings.passage(&studio.tracked) {
            Some((velocity, place)) => passage_times(&velocity.speed, place, settings.pair())?,
            None => Some([0.0, settings.ride.duration()]),
        };
        let passage = passage.context("a scene at rest never passes; --from and --to are needed")?;
        Ok([self.from.unwrap_or(passage[0]), self.to.unwrap_or(passage[1])])
    }
}

impl TimeArgs {
    /// Returns the numbers of the frames to draw, of a sequence of `frames` frames.
    fn numbers(&self, frames: u32) -> Vec<u32> {
        self.part.unwrap_or(SequencePart::WHOLE).frames(frames).collect()
    }

    /// Refuses a part of a sequence whose frames each machine would draw in its own way.
    ///
    /// # Errors
    ///
    /// A part without a named renderer.
    pub fn check_renderer(&self, renderer: RendererChoice) -> anyhow::Result<()> {
        match self.part {
            Some(part) if renderer == RendererChoice::Auto => anyhow::bail!(
                "--part {part}: --renderer is needed (rays, packets, mesh or reference), so that all parts are drawn alike"
            ),
            _ => Ok(()),
        }
    }
}

/// Draws the frames as one animated file at `path`, each shown for 1/25 s.
pub fn run_film(studio: &mut Studio, times: &TimeArgs, kind: FilmKind, path: &Path) -> anyhow::Result<()> {
    anyhow::ensure!(
        !times.exr,
        "--exr: an animation shows pictures; measurements of every pixel need a folder"
    );
    if let Some(part) = times.part {
        anyhow::bail!("--part {part}: an animation is one file; parts of a sequence need a folder");
    }
    let frames = times.frames.unwrap_or(1);
    let range = times.range(studio)?;
    let progress = progress::bar(frames.into(), "frames");
    let times: Vec<f64> = (0..frames).map(|frame| time_of(frame, frames, range)).collect();
    let (size, mut is_forecast) = (studio.settings().picture.size, false);
    let bytes = studio.make_film(&times, kind, path, |written| {
        progress.set_position(written.drawn.into());
        let Some(bytes) = written.forecast(frames) else { return true };
        progress.set_message(format!(", about {} in all", number_text::bytes(bytes, 2)));
        // The first frames alone may be much dearer than the rest.
        if !is_forecast && written.frames > frames / 4 {
            is_forecast = true;
            forecast(&progress, frames, size, bytes, format_args!("the first {}", written.frames));
        }
        true
    })?;
    progress.finish_and_clear();
    messages::remark(format_args!(
        "{frames} frames in {}: {}",
        files::shown(path),
        number_text::bytes(bytes, 3)
    ));
    Ok(())
}

/// Says that all of so many `frames`, of this `size`, will have about so many `bytes`, judging by the `made`
/// ones.
fn forecast(progress: &ProgressBar, frames: u32, size: Size, bytes: u64, made: impl fmt::Display) {
    let estimate = number_text::bytes(bytes, 2);
    progress.suspend(|| {
        messages::remark(format_args!(
            "{frames} frames, {size} per eye: about {estimate}, estimated from {made}"
        ));
    });
}

/// Returns T of one of `frames` frames: those of the first and the last are the ends of `range`.
fn time_of(frame: u32, frames: u32, range: [f64; 2]) -> f64 {
    time_within(range, f64::from(frame) / f64::from(frames.max(2) - 1))
}

/// Draws the frames into `folder` as `frame_00000.png` (or .exr) and so on. Frames that are there already,
/// whole and with the same parameters, are kept. (Those for headsets have longer names.)
pub fn run(studio: &mut Studio, times: &TimeArgs, folder: &Path) -> anyhow::Result<()> {
    let frames = times.frames.unwrap_or(1);
    let range = times.range(studio)?;
    files::create_folder(folder).with_context(|| files::shown(folder))?;
    let numbers = times.numbers(frames);
    let count = numbers.len() as u32;
    let progress = progress::bar(count.into(), "frames");
    let kind = if times.exr { FileKind::Exr } else { FileKind::Png };
    let (mut kept, mut written) = (0, Written::default());
    let probes = probes(count);
    let others = (0..count).filter(|place| !probes.contains(place));
    for place in probes.iter().copied().chain(others) {
        let number = numbers[place as usize];
        let path = vr180::named(studio.settings(), &frame_path(folder, number, kind));
        let frame = studio.frame(Some(time_of(number, frames, range)))?;
        if studio.has_made(&frame, kind, &path) {
            kept += 1;
        } else {
            // Only what is named on the command line may be a pipe that waits for its reader.
            files::check_replaceable(&path).with_context(|| files::shown(&path))?;
            studio.make_file(&frame, kind, &path)?;
        }
        written.frames += 1;
        written.bytes += files::size(&path).with_context(|| files::shown(&path))?;
        progress.inc(1);
        let made = written.frames;
        let is_probed = made as usize == probes.len() && made < count;
        if let Some(bytes) = written.expected_bytes(count).filter(|_| is_probed) {
            let size = studio.settings().picture.size;
            forecast(&progress, count, size, bytes, format_args!("{made} of them"));
        }
    }
    progress.finish_and_clear();
    let (drawn, total) = (count - kept, number_text::bytes(written.bytes, 3));
    messages::remark(format_args!(
        "{drawn} frames drawn and {kept} kept in {}: {total}",
        files::shown(folder)
    ));
    Ok(())
}

/// Returns the places of the frames that are made first, by which the size of all is estimated: the first
/// one, one that approaches, and the one in the middle.
fn probes(frames: u32) -> Vec<u32> {
    let mut probes = if frames == 0 { Vec::new() } else { vec![0, frames / 4, frames / 2] };
    probes.dedup();
    probes
}
