//! Commands and flags. Each command's own flags live beside its code in `headless`.

use clap::{Args, Parser, Subcommand};
use relativity_core::Speed;

use crate::headless;

/// Interactive stereo viewer of special relativity. Without a command it opens the window.
#[derive(Debug, Parser)]
#[command(version, about)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

/// The headless commands.
#[derive(Debug, Subcommand)]
enum Command {
    /// Evaluate rows of a CSV file.
    Eval(headless::eval::EvalArgs),
}

/// Runs what the command line asks for.
pub fn run(cli: Cli) -> anyhow::Result<()> {
    match cli.command {
        None => anyhow::bail!("the window comes with the next issue"),
        Some(Command::Eval(args)) => headless::eval::run(&args),
    }
}

/// A speed, given in exactly one of three ways.
#[derive(Debug, Clone, Copy, Args)]
#[group(multiple = false)]
pub struct SpeedArgs {
    /// Speed as v/c, 0 <= beta < 1.
    #[arg(long)]
    pub beta: Option<f64>,
    /// Speed as Lorentz factor, 1 <= gamma <= 1e30.
    #[arg(long)]
    pub gamma: Option<f64>,
    /// Speed as rapidity atanh(beta), 0 to 69.77.
    #[arg(long)]
    pub rapidity: Option<f64>,
}

impl SpeedArgs {
    /// The speed asked for, or `default_beta` if none was.
    pub fn speed(&self, default_beta: f64) -> anyhow::Result<Speed> {
        Ok(match (self.beta, self.gamma, self.rapidity) {
            (Some(beta), _, _) => Speed::from_beta(beta)?,
            (_, Some(gamma), _) => Speed::from_gamma(gamma)?,
            (_, _, Some(rapidity)) => Speed::from_rapidity(rapidity)?,
            (None, None, None) => Speed::from_beta(default_beta)?,
        })
    }
}
