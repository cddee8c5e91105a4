//! `gamow`: parses the command line, dispatches, and turns an error into one line and exit status 2.

use std::process::ExitCode;

use clap::Parser as _;
use gamow::cli::Cli;

fn main() -> ExitCode {
    env_logger::init();
    match gamow::cli::run(Cli::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("gamow: {error:#}");
            ExitCode::from(2)
        }
    }
}
