//! The help: its examples run.

use std::env;
use std::fs;
use std::path::Path;
use std::process::Command;

use super::{run, words};

/// Runs `line` as a shell in an empty folder does, with `gamow` on the path.
fn assert_example_runs(line: &str) {
    let program = Path::new(env!("CARGO_BIN_EXE_gamow"));
    let folder = program.parent().expect("a program is in a folder");
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = [folder.to_owned()].into_iter().chain(env::split_paths(&path));
    let scratch = tempfile::tempdir().expect("there is a folder for temporary files");
    let outcome = run(
        Command::new("sh")
            .args(["-c", line])
            .current_dir(scratch.path())
            .env("PATH", env::join_paths(folders).expect("paths join")),
        b"",
    );
    assert_eq!((outcome.status, outcome.stderr.as_str()), (Some(0), ""), "{line}");
    let files = fs::read_dir(scratch.path()).expect("the folder is there").count();
    assert!(outcome.stdout.len() > 200 || files == 1, "{line} shows nothing");
}

#[test]
#[cfg_attr(not(unix), ignore = "the examples are for a Unix shell")]
fn every_example_in_the_help_runs() {
    for arguments in ["--help", "eval --help", "curve --help"] {
        let help = words(arguments).text();
        let (_, examples) = help.split_once("Examples:\n").expect("there are examples");
        let lines: Vec<_> = examples.lines().map_while(|line| line.strip_prefix("  ")).collect();
        assert!(lines.len() >= 3, "{arguments}");
        lines.into_iter().for_each(assert_example_runs);
    }
}

#[test]
fn help_names_every_column() {
    let help = words("eval --help").text();
    for name in ["x", "t", "doppler", "intensity", "phi", "theta", "dphi", "dtheta"] {
        assert!(help.lines().any(|line| line.trim_start().starts_with(name)), "{name}");
    }
}

#[test]
fn short_help_fits_a_screen() {
    for arguments in ["-h", "eval -h", "curve -h"] {
        assert!(words(arguments).text().lines().count() <= 40, "{arguments}");
    }
}
