//! `gamow accuracy`: what each method costs on this machine, how far it is from the truth, and what to use.

mod advice;
#[cfg(test)]
mod bound;
mod effects;
mod measure;
mod plot;
mod report;
mod table;

use std::io::Write as _;
use std::path::PathBuf;

use clap::Args;

use crate::files::whole::{ReportArgs, ensure_ending, write_whole};
use crate::flags::choices::Size;
use crate::scene::Scene;
use crate::settings::SCENE_HELP;

/// Measures speed against accuracy: each method's cost on this machine, its error against the f64 reference, and
/// what follows for its use.
///
/// Views are of the tracked point seen approaching (at x = -3 R, R being its distance at x = 0), abreast (x = 0) and
/// receding (x = +3 R), from rest to gamma = 1000. Nothing is stored from earlier runs. Costs are those of the
/// fastest of several runs; they mean something only in a release build. Costs, and what rests on them, differ from
/// run to run; errors do not. In JSON `timed` names what differs.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES, after_long_help = HELP)]
pub struct AccuracyArgs {
    #[arg(long, help = SCENE_HELP, default_value = "cyclist", value_name = "PRESET|FILE")]
    scene: String,
    /// Size of one eye's picture, pixels.
    #[arg(long, default_value_t = Size([480, 360]), value_name = "WxH")]
    size: Size,
    /// Measure fewer views, places and runs.
    #[arg(long)]
    quick: bool,
    /// Draw cost against error into this SVG file.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    report: ReportArgs,
}

const HELP: &str = "\
What is measured:
  outline        how far outlines are displaced, pixels: at places found on the reference's
                 by bisection, the method draws a strip across, up to 4096 times magnified
  line of sight  angle between a pixel's line of sight and that along which the point it
                 shows is really seen, by the light cone in f64, arcseconds
  D              relative error of the Doppler factor, in each view, and the worst at each speed
  wrong body     pixels that show another body than the reference, per pixel that shows
                 one; where two bodies share a surface, that of the first is right";

const EXAMPLES: &str = "\
Examples:
  gamow accuracy
  gamow accuracy --plot frontier.svg --json --out frontier.json
  gamow accuracy --scene two-balls --size 960x720 --quick";

/// Runs the command `gamow accuracy`.
pub fn run(args: &AccuracyArgs) -> anyhow::Result<()> {
    if let Some(path) = &args.plot {
        ensure_ending("--plot", path, "svg")?;
    }
    let scene = Scene::open(&args.scene)?;
    let report = measure::report(&scene, &args.scene, args.size.0, args.quick)?;
    if let Some(path) = &args.plot {
        write_whole(path, |file| Ok(file.write_all(plot::drawing(&report).as_bytes())?))?;
    }
    args.report.write(&report)
}
