//! The help and the README: their examples run, and print what they are said to.

use std::env;
use std::fs;
use std::path::Path;
use std::process::Command;

use super::{Outcome, run, words};

/// Runs `line` as a shell in the folder `scratch` does, with `gamow` on the path.
fn shell(line: &str, scratch: &Path) -> Outcome {
    let program = Path::new(env!("CARGO_BIN_EXE_gamow"));
    let folder = program.parent().expect("a program is in a folder");
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = [folder.to_owned()].into_iter().chain(env::split_paths(&path));
    run(
        Command::new("sh")
            .args(["-c", line])
            .current_dir(scratch)
            .env("PATH", env::join_paths(folders).expect("paths join")),
        b"",
    )
}

fn assert_example_runs(line: &str) {
    let scratch = tempfile::tempdir().expect("there is a folder for temporary files");
    let outcome = shell(line, scratch.path());
    assert_eq!((outcome.status, outcome.stderr.as_str()), (Some(0), ""), "{line}");
    let files = fs::read_dir(scratch.path()).expect("the folder is there").count();
    assert!(outcome.stdout.len() > 200 || files == 1, "{line} shows nothing");
}

/// Those examples need a display or a GPU: `tests/ui` has their twins.
fn opens_the_window(line: &str) -> bool {
    line == "gamow" || line.contains("--screenshot")
}

#[test]
#[cfg_attr(not(unix), ignore = "the examples are for a Unix shell")]
fn every_example_in_the_help_runs() {
    for arguments in ["--help", "eval --help", "curve --help"] {
        let help = words(arguments).text();
        let (_, examples) = help.split_once("Examples:\n").expect("there are examples");
        let lines = examples.lines().map_while(|line| line.strip_prefix("  "));
        let lines: Vec<_> = lines.filter(|line| !opens_the_window(line)).collect();
        assert!(lines.len() >= 3, "{arguments}");
        lines.into_iter().for_each(assert_example_runs);
    }
}

#[test]
#[cfg_attr(not(unix), ignore = "the examples are for a Unix shell")]
fn every_example_in_the_readme_prints_what_is_shown() {
    let readme = include_str!("../../README.md");
    let blocks: Vec<_> = readme.split("```console\n$ ").skip(1).collect();
    assert!(blocks.len() >= 3);
    for block in blocks {
        let (block, _) = block.split_once("```").expect("the block ends");
        let (line, shown) = block.split_once('\n').expect("the output follows");
        let scratch = tempfile::tempdir().expect("there is a folder for temporary files");
        let outcome = shell(line, scratch.path());
        assert_eq!(String::from_utf8_lossy(&outcome.stdout) + outcome.stderr.as_str(), shown, "{line}");
    }
}

#[test]
fn help_names_every_column() {
    let help = words("eval --help").text();
    for name in
        ["x", "t", "doppler", "intensity", "phi", "theta", "dphi", "dtheta", "own", "stereo_gain", "stereo_x"]
    {
        assert!(help.lines().any(|line| line.trim_start().starts_with(name)), "{name}");
    }
}

#[test]
fn short_help_of_a_command_fits_a_screen() {
    for arguments in ["eval -h", "curve -h"] {
        assert!(words(arguments).text().lines().count() <= 40, "{arguments}");
    }
}
