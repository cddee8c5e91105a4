//! The help of the commands: its examples run.

use std::fs;

use super::{shell, words};

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
fn the_help_of_every_command_begins_with_an_example() {
    let commands =
        ["", "eval", "curve", "fit", "lesson", "measure", "paper", "rectify", "render", "accuracy"];
    for command in commands {
        let help = words(&format!("{command} --help")).text();
        assert!(help.starts_with("Examples:\n  "), "{command}: {}", help.lines().next().unwrap_or_default());
    }
}

#[test]
fn help_names_every_column() {
    let help = words("eval --help").text();
    for name in
        ["x", "t", "doppler", "intensity", "phi", "theta", "dphi", "dtheta", "tau", "stereo_gain", "stereo_x"]
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
