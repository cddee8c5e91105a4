//! `gamow render`: pictures, sequences and measurements of a scene, without a window.

mod sequence;
mod vr180;

use std::path::{Path, PathBuf};

use clap::{Arg, Args};
use gamow_platform::{files, messages, progress};

use self::sequence::TimeArgs;
pub use self::vr180::fitted;
use crate::files::whole::say;
use crate::flags::choices::FileKind;
use crate::settings::{Settings, StartArgs};
use crate::studio::Studio;
use crate::studio::film::FilmKind;

/// Draws what both eyes see, without a window, a display or a GPU.
///
/// Without flags: the cyclist at beta = 0.9 on Gamow's street, seen with d = 0.1. A `.png` file is a picture,
/// an `.exr` file holds what every pixel shows (body, distance, time of emission, proper time, place at rest,
/// angle on a wheel, triangle of a model, Doppler factor, ...), and with --frames a folder takes a sequence.
///
/// With --projection vr180 a picture is half of the sky for a headset: both eyes side by side, each square
/// (2048x2048 unless --size says another), without bar and letters, in a file whose name ends in
/// `_180x180_LR.png`.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES, mut_args(without_the_windows))]
pub struct RenderArgs {
    /// Output: FILE.png or FILE.exr; with --frames a folder, or FILE.gif, FILE.mp4 or FILE.png, an animation
    /// of 25 frames a second. Each file is written whole or not at all. An MP4 is H.264 at a fixed quality:
    /// colours have half the resolution of brightness, and a side of an odd number of pixels gets one more.
    #[arg(long, default_value = "gamow.png", value_name = "FILE|DIR")]
    out: PathBuf,
    #[command(flatten)]
    times: TimeArgs,
    /// Print how long each stage took.
    #[arg(long, conflicts_with = "frames")]
    timings: bool,
    /// Repetitions that --timings measures.
    #[arg(long, default_value_t = 5, value_name = "N", requires = "timings", value_parser = clap::value_parser!(u32).range(1..))]
    repeat: u32,
    #[command(flatten)]
    start: StartArgs,
}

/// Leaves out of the help what changes no picture.
fn without_the_windows(flag: Arg) -> Arg {
    let is_the_windows = flag
        .get_help_heading()
        .is_some_and(|section| ["Playback", "Map", "Plots", "Fit", "Window"].contains(&section));
    flag.hide(is_the_windows)
}

const EXAMPLES: &str = "\
Examples:
  gamow render --out street.png
  gamow render --state abreast --out abreast.png
  gamow render --beta 0.6 --gaze 90,0 --fov 100 --layout anaglyph --out anaglyph.png
  gamow render --gamma 100 --time 0 --colour false --out false-colour.png
  gamow render --frames 200 --size 640x480 --out ride
  gamow render --frames 200 --part 2/8 --renderer reference --out ride   (the second of eight parts, for eight machines)
  gamow render --frames 100 --size 320x240 --renderer rays --out ride.gif
  gamow render --frames 100 --size 960x720 --out ride.mp4
  gamow render --renderer reference --out hits.exr
  gamow render --geometry published --time 1.5 --layout overlay --out published.png
  gamow render --projection vr180 --time 2 --out street.png   (street_180x180_LR.png, for headsets)
  gamow render --renderer rays --timings --repeat 20";

/// Runs the command `gamow render`.
pub fn run(args: &RenderArgs) -> anyhow::Result<()> {
    let output = args.output()?;
    let settings = vr180::fitted(args.start.settings(Settings::default())?)?;
    args.times.check_renderer(settings.quality.renderer)?;
    let mut studio = Studio::new(settings)?;
    studio.scene().reports().for_each(|report| messages::remark(format_args!("gamow: {report}")));
    let kind = match output {
        RenderOutput::File(kind) => kind,
        RenderOutput::Sequence => return sequence::run(&mut studio, &args.times, &args.out),
        RenderOutput::Film(kind) => return sequence::run_film(&mut studio, &args.times, kind, &args.out),
    };
    let frame = studio.frame(None)?;
    let out = vr180::named(studio.settings(), &args.out);
    let pictures = if kind == FileKind::Exr { 2 } else { studio.settings().picture.eyes().len() };
    for _ in 0..if args.timings { args.repeat } else { 1 } {
        progress::shown_while(pictures, || studio.make_file(&frame, kind, &out))?;
    }
    if out != args.out {
        messages::remark(format_args!(
            "gamow: the picture is {}, a name that headsets know",
            files::shown(&out)
        ));
    }
    if args.timings {
        say(|out| Ok(writeln!(out, "{}", studio.report())?))?;
    }
    Ok(())
}

/// What the path of the output asks for.
enum RenderOutput {
    File(FileKind),
    Sequence,
    Film(FilmKind),
}

impl RenderArgs {
    fn output(&self) -> anyhow::Result<RenderOutput> {
        let out = files::shown(&self.out);
        match (FileKind::from_path(&self.out), FilmKind::from_path(&self.out), self.times.frames) {
            (Some(FileKind::Exr), _, Some(_)) => {
                anyhow::bail!("--out {out}: a sequence of measurements needs a folder, not a file")
            }
            (Some(kind), _, None) => Ok(RenderOutput::File(kind)),
            (None, Some(FilmKind::Gif | FilmKind::Mp4), None) => {
                anyhow::bail!("--out {out}: an animation needs --frames")
            }
            (_, Some(kind @ (FilmKind::Gif | FilmKind::Mp4 | FilmKind::Png)), Some(_)) => {
                Ok(RenderOutput::Film(kind))
            }
            (None, _, None) => {
                anyhow::bail!("--out {out}: a file must end in .png or .exr; a folder needs --frames")
            }
            (_, None, Some(_)) if is_of_another_kind(&self.out) => {
                anyhow::bail!(
                    "--out {out}: an animation must end in {}; of a folder of pictures ffmpeg makes any other",
                    FilmKind::NAMED_ENDINGS
                )
            }
            (_, _, Some(_)) => Ok(RenderOutput::Sequence),
        }
    }
}

/// Whether `path` is called what films or pictures are called that are not made here; any other name is a
/// folder's.
fn is_of_another_kind(path: &Path) -> bool {
    const KINDS: [&str; 7] = ["avi", "jpeg", "jpg", "mkv", "mov", "tif", "webm"];
    path.extension().is_some_and(|extension| KINDS.iter().any(|kind| extension.eq_ignore_ascii_case(kind)))
}
