//! `gamow eval`: the sightings and disparities of each row of a CSV file.

use clap::Args;

/// Flags of `gamow eval`.
#[derive(Debug, Args)]
pub struct EvalArgs {}

/// Runs `gamow eval`.
pub fn run(_args: &EvalArgs) -> anyhow::Result<()> {
    Ok(())
}
