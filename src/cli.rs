//! What the command line asks for, handed to whom it concerns. Each command's own flags live beside its code in `commands`.

use clap::{Parser, Subcommand};

use crate::app::{self, args::WindowArgs};
use crate::commands;

/// Interactive stereo viewer of special relativity: what each eye sees, exactly.
///
/// Without a command it opens the window, in which what no flag sets is as it was left.
#[derive(Debug, Parser)]
#[command(version, after_help = EXAMPLES, args_conflicts_with_subcommands = true)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    window: WindowArgs,
}

const EXAMPLES: &str = "\
Conventions: c = 1; lengths and times share one unit; angles are radians. x points along the motion, y forward, z up. \
The eyes rest at x = -d/2 (left) and x = +d/2 (right).

Examples:
  gamow
  gamow --scene street --beta 0.99 --time 1 --screenshot window.png
  gamow curve --beta 0.9 --d 0.3 --y 0.5 --z 0.5 --from -2 --to 5
  gamow curve --samples 1000 --out curve.csv
  gamow curve | cut -d, -f 1-6 | gamow eval --model published

`gamow COMMAND --help` tells more.";

/// The headless commands.
#[derive(Debug, Subcommand)]
enum Command {
    Eval(commands::eval::EvalArgs),
    Curve(commands::curve::CurveArgs),
    Fit(commands::fit::FitArgs),
    Measure(commands::measure::MeasureArgs),
    Paper(commands::paper::PaperArgs),
    Rectify(commands::rectify::RectifyArgs),
    Render(Box<commands::render::RenderArgs>),
    Accuracy(commands::accuracy::AccuracyArgs),
}

/// Runs what the command line asks for.
pub fn run(cli: Cli) -> anyhow::Result<()> {
    match cli.command {
        None => app::launch::launch(&cli.window),
        Some(Command::Eval(args)) => commands::eval::run(&args),
        Some(Command::Curve(args)) => commands::curve::run(&args),
        Some(Command::Fit(args)) => commands::fit::run(&args),
        Some(Command::Measure(args)) => commands::measure::run(&args),
        Some(Command::Paper(args)) => commands::paper::run(&args),
        Some(Command::Rectify(args)) => commands::rectify::run(&args),
        Some(Command::Render(args)) => commands::render::run(&args),
        Some(Command::Accuracy(args)) => commands::accuracy::run(&args),
    }
}
