//! The help of the commands: its examples run.

use std::fs;

use super::{gamow, run, shell, words};

const COMMANDS: [&str; 11] = [
    "accuracy",
    "completions",
    "curve",
    "eval",
    "fit",
    "lesson",
    "man",
    "measure",
    "paper",
    "rectify",
    "render",
];

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
    for command in [""].iter().chain(&COMMANDS) {
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

/// The short help of `command` where lines have 80 characters.
fn on_a_screen(command: &str) -> String {
    run(gamow().args(command.split_whitespace().chain(["-h"])).env("COLUMNS", "80"), b"").text()
}

/// A screen of 24 lines of 80 characters. The window and all commands together need twice as many.
#[test]
fn short_help_of_a_command_fits_a_screen() {
    for command in COMMANDS {
        let help = on_a_screen(command);
        assert!(help.lines().count() <= 24, "{command}: {help}");
        let is_narrow = |line: &str| line.chars().count() <= 80 || line.starts_with("Usage: ");
        assert!(help.lines().all(is_narrow), "{command}: {help}");
        assert!(help.contains(&format!("More: gamow {command} --help")), "{command}: {help}");
    }
    let help = on_a_screen("");
    assert!(help.lines().count() <= 48 && help.lines().all(|line| line.chars().count() <= 80), "{help}");
    assert!(help.contains("\n  curve        Writes what two eyes see of one point"), "{help}");
}

#[test]
fn every_section_of_the_help_can_be_had_by_itself() {
    for command in ["curve", "fit", "measure", "rectify", "render", ""] {
        let short = words(&format!("{command} -h")).text();
        let more = short.split("More: ").nth(1).expect("it says what else there is").replace('\n', " ");
        let (_, sections) = more.rsplit_once(": ").expect("there are sections");
        let whole = words(&format!("{command} --help")).text();
        // The command `fit` has the name before the window's section.
        let has_own_name = |section: &&str| !(command.is_empty() && *section == "fit");
        for section in sections.split(", ").map(str::trim).filter(has_own_name) {
            let heading = format!("{}{}:\n", section[..1].to_uppercase(), &section[1..]);
            for way in [format!("{command} --help {section}"), format!("{command} --help={section}")] {
                let help = words(&way).text();
                assert!(help.starts_with(&heading), "{way}: {help}");
                assert!(whole.contains(help.trim_end()), "{way}: {help}");
                assert!(!help.trim_end().contains("\n\n\n") && !help.contains("--help"), "{way}: {help}");
            }
        }
    }
}

#[test]
fn the_name_of_a_flag_stands_for_its_section() {
    assert_eq!(words("render --help colour").text(), words("render --help light").text());
    assert!(words("render --help out").text().starts_with("Options:\n      --out "));
    assert_eq!(words("--help curve").text(), words("curve --help").text());
    let complaint = words("render --help lookk").complaint();
    let said = "gamow: --help: there is no section and no flag called `lookk` (did you mean `look`?): there are motion, look, ";
    assert!(complaint.starts_with(said), "{complaint}");
    // Those of the window alone are no section of pictures.
    assert!(words("render --help playback").complaint().contains("no section"));
    assert!(words("--help playback").text().contains("--looping"));
}
