//! Commands and flags. Each command's own flags live beside its code in `headless`.

use clap::{Args, Parser, Subcommand, ValueEnum};
use relativity_core::{Speed, SpeedError};
use relativity_render::Geometry;
use serde::{Deserialize, Serialize};

use crate::app::{self, args::WindowArgs};
use crate::headless;

/// Interactive stereo viewer of special relativity. Without a command it opens the window.
#[derive(Debug, Parser)]
#[command(version, about, after_help = EXAMPLES, args_conflicts_with_subcommands = true)]
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

`gamow eval --help` and `gamow curve --help` tell more.";

/// The headless commands.
#[derive(Debug, Subcommand)]
enum Command {
    Eval(headless::eval::EvalArgs),
    Curve(headless::curve::CurveArgs),
    Fit(headless::fit::FitArgs),
    Measure(headless::measure::MeasureArgs),
    Paper(headless::paper::PaperArgs),
    Rectify(headless::rectify::RectifyArgs),
    Render(Box<headless::render::RenderArgs>),
    Accuracy(headless::accuracy::AccuracyArgs),
}

/// Runs what the command line asks for.
pub fn run(cli: Cli) -> anyhow::Result<()> {
    match cli.command {
        None => app::launch::launch(&cli.window),
        Some(Command::Eval(args)) => headless::eval::run(&args),
        Some(Command::Curve(args)) => headless::curve::run(&args),
        Some(Command::Fit(args)) => headless::fit::run(&args),
        Some(Command::Measure(args)) => headless::measure::run(&args),
        Some(Command::Paper(args)) => headless::paper::run(&args),
        Some(Command::Rectify(args)) => headless::rectify::run(&args),
        Some(Command::Render(args)) => headless::render::run(&args),
        Some(Command::Accuracy(args)) => headless::accuracy::run(&args),
    }
}

/// Which geometry a picture shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum GeometryChoice {
    /// Exactly as seen, each eye through its own light cone.
    Seen,
    /// Contracted only, as if light were instantaneous: what Gamow drew.
    Contracted,
    /// What cameras that ride along would see.
    Rest,
    /// The paper's binocular model: the right eye sees, point by point, what the left eye saw a little
    /// earlier or later, without parallax. Drawn by the mesh renderer.
    Published,
}

impl GeometryChoice {
    /// What each view shows. As published, that is the left eye's; the right eye's is defined point by point.
    #[must_use]
    pub const fn geometry(self) -> Geometry {
        match self {
            Self::Seen | Self::Published => Geometry::Seen,
            Self::Contracted => Geometry::Contracted,
            Self::Rest => Geometry::Rest,
        }
    }
}

/// What draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize, Deserialize)]
pub enum RendererChoice {
    /// A ray test per pixel on the GPU, in f32.
    #[default]
    Exact,
    /// Triangles on the GPU.
    Mesh,
    /// A ray test per pixel on the CPU, in f64.
    Reference,
}

/// The three ways to give a speed: a flag each, and a column of a CSV file each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum SpeedParameter {
    /// v/c.
    Beta,
    /// The Lorentz factor.
    Gamma,
    /// atanh(beta).
    Rapidity,
}

impl SpeedParameter {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Beta, Self::Gamma, Self::Rapidity];

    /// Its name as a flag and as a column.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Beta => "beta",
            Self::Gamma => "gamma",
            Self::Rapidity => "rapidity",
        }
    }

    /// The speed whose parameter has this `value`.
    pub fn speed(self, value: f64) -> Result<Speed, SpeedError> {
        match self {
            Self::Beta => Speed::from_beta(value),
            Self::Gamma => Speed::from_gamma(value),
            Self::Rapidity => Speed::from_rapidity(value),
        }
    }
}

/// A speed, given in exactly one of three ways.
#[derive(Debug, Clone, Copy, Args)]
#[group(multiple = false)]
pub struct SpeedArgs {
    /// Speed as v/c, 0 <= beta < 1.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true)]
    pub beta: Option<f64>,
    /// Speed as Lorentz factor, 1 <= gamma <= 1e30.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true)]
    pub gamma: Option<f64>,
    /// Speed as rapidity atanh(beta), 0 to 69.77.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true)]
    pub rapidity: Option<f64>,
}

impl SpeedArgs {
    /// The parameter given and its value.
    #[must_use]
    pub fn given(&self) -> Option<(SpeedParameter, f64)> {
        SpeedParameter::ALL
            .into_iter()
            .zip([self.beta, self.gamma, self.rapidity])
            .find_map(|(parameter, value)| Some((parameter, value?)))
    }

    /// The parameter given and its value, or `default_beta` if none was.
    #[must_use]
    pub fn parameter(&self, default_beta: f64) -> (SpeedParameter, f64) {
        self.given().unwrap_or((SpeedParameter::Beta, default_beta))
    }

    /// The speed asked for, or `default_beta` if none was.
    pub fn speed(&self, default_beta: f64) -> anyhow::Result<Speed> {
        let (parameter, value) = self.parameter(default_beta);
        Ok(parameter.speed(value)?)
    }
}

/// Parses a flag's value: f64's own parser also takes `nan` and `inf`, which no flag means.
pub fn finite_number(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err("not a finite number".to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}

/// Parses a number above 0.
pub fn positive(text: &str) -> Result<f64, String> {
    let value = finite_number(text)?;
    if value > 0.0 { Ok(value) } else { Err("must be above 0".to_owned()) }
}
