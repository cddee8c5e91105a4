//! `gamow`: parses the command line, dispatches, and turns an error into one line and exit status 2.

use std::io;
use std::process::ExitCode;

use clap::Parser as _;
use gamow::cli::Cli;

fn main() -> ExitCode {
    // The graphics libraries log as errors what they then get over, or what is reported below.
    let quiet = env_logger::Env::default().default_filter_or("error,eframe=off,wgpu_hal=off,rfd=off");
    env_logger::Builder::from_env(quiet).init();
    match gamow::cli::run(Cli::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if reader_has_gone(&error) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("gamow: {error:#}");
            ExitCode::from(2)
        }
    }
}

/// Whether output stopped because nobody reads it any more, as in `gamow curve | head`.
fn reader_has_gone(error: &anyhow::Error) -> bool {
    error
        .chain()
        .filter_map(|cause| cause.downcast_ref::<io::Error>())
        .any(|cause| cause.kind() == io::ErrorKind::BrokenPipe)
}
