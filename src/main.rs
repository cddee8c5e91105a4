//! `gamow`: parses the command line, dispatches, and turns an error into one line and exit status 2.

use std::io::{self, Write as _};
use std::process::ExitCode;

use gamow_platform::clock::Instant;
use gamow_platform::{environment, interrupt, limits, messages};

use gamow::cli;

fn main() -> ExitCode {
    limits::fail_beyond_file_size();
    interrupt::handle();
    let start = Instant::now();
    // The graphics libraries log as errors what they then get over, or what is reported below.
    let quiet = env_logger::Env::default().default_filter_or("error,eframe=off,wgpu_hal=off,rfd=off");
    env_logger::Builder::from_env(quiet)
        .format(move |out, record| {
            let (after, text) = (start.elapsed().as_secs_f64(), record.args().to_string());
            let (level, target) = (record.level(), record.target());
            writeln!(out, "[{after:.3} s {level} {target}] {}", messages::shown(&text))
        })
        .init();
    match cli::run(environment::arguments().collect()) {
        Ok(code) => code,
        Err(error) if reader_has_gone(&error) => ExitCode::SUCCESS,
        Err(error) => ExitCode::from(messages::failure(&error)),
    }
}

/// Whether output stopped because nobody reads it any more, as in `gamow curve | head`.
fn reader_has_gone(error: &anyhow::Error) -> bool {
    error
        .chain()
        .filter_map(|cause| cause.downcast_ref::<io::Error>())
        .any(|cause| cause.kind() == io::ErrorKind::BrokenPipe)
}
