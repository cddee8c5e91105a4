//! `gamow accuracy`: what each method costs on this machine, and how far it is from the truth.

#[cfg(test)]
mod bound;
mod measure;
mod report;
mod table;

use clap::Args;

use crate::files::whole::ReportArgs;
use crate::flags::choices::Size;
use crate::scene::Scene;
use crate::settings::SCENE_HELP;

/// Measures speed against accuracy: what rays, packets and the f64 reference cost on this machine, and how
/// far rays and packets are off that.
///
/// Views are of the tracked point seen approaching (at x = -3 R, R being its distance at x = 0), abreast
/// (x = 0) and receding (x = +3 R), from rest to gamma = 1000. Nothing is stored from earlier runs. Costs are
/// those of the fastest of several runs; they mean something only in a release build. Costs differ from run
/// to run; errors do not. In JSON `timed` names what differs.
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
                 one; where two bodies share a surface, that of the first is right

Colours are not measured here. Those of paint come from tables: in daylight at most 1 of 255
levels off their integrals, for what moves through the street's daylight as much up to 0.9 c
and at most 4 at 0.99 c (smooth paint; of measured materials see docs/real-light.md).";

const EXAMPLES: &str = "\
Examples:
  gamow accuracy
  gamow accuracy --json --out accuracy.json
  gamow accuracy --scene two-balls --size 960x720 --quick";

/// Runs the command `gamow accuracy`.
pub fn run(args: &AccuracyArgs) -> anyhow::Result<()> {
    let scene = Scene::open(&args.scene)?;
    args.report.write(&measure::report(&scene, &args.scene, args.size.0, args.quick)?)
}
