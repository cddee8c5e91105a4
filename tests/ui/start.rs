//! Starting in a state: flags, screenshots, and what is said where no window can open.

use std::path::Path;
use std::process::{Command, Output};

use gamow::settings::Settings;

use super::Test;
use super::support::sweep;

pub const TESTS: &[Test] = trials![
    a_screenshot_has_the_size_asked_for_and_shows_the_state,
    a_screenshot_that_cannot_be_written_leaves_nothing,
    an_adapter_that_is_not_there_is_named,
    bad_flags_are_named_before_anything_is_drawn,
    without_a_display_it_says_what_to_do,
];

fn gamow(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    for display in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        command.env_remove(display);
    }
    command.args(arguments).output().expect("the program starts")
}

fn screenshot(folder: &Path, name: &str, arguments: &[&str]) -> (png::OutputInfo, Vec<u8>) {
    let path = folder.join(name);
    let flags = ["--screenshot", path.to_str().expect("a plain path"), "--window-size", "640x480"];
    let output = gamow(&[&flags, arguments].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let file = std::io::BufReader::new(std::fs::File::open(path).expect("it is there"));
    let mut reader = png::Decoder::new(file).read_info().expect("a PNG file");
    let mut pixels = vec![0; reader.output_buffer_size().expect("it fits")];
    let info = reader.next_frame(&mut pixels).expect("a whole PNG file");
    (info, pixels)
}

fn a_screenshot_has_the_size_asked_for_and_shows_the_state() {
    let folder = tempfile::tempdir().expect("a folder");
    let (info, fast) = screenshot(folder.path(), "fast.png", &["--beta", "0.9", "--time", "1", "--paused"]);
    assert_eq!((info.width, info.height), (640, 480));
    let (_, again) = screenshot(folder.path(), "again.png", &["--beta", "0.9", "--time", "1"]);
    assert!(fast == again, "the same state is drawn the same");
    let others: [&[&str]; 9] = [
        &["--beta", "0.5", "--time", "1"],
        &["--beta", "0.9", "--time", "2"],
        &["--beta", "0.9", "--time", "1", "--d", "0.5"],
        &["--beta", "0.9", "--time", "1", "--scene", "cyclist"],
        &["--beta", "0.9", "--time", "1", "--plot", "fit"],
        &["--beta", "0.9", "--time", "1", "--corrected"],
        &["--beta", "0.9", "--time", "1", "--renderer", "reference"],
        &["--beta", "0.9", "--time", "1", "--renderer", "mesh"],
        &["--beta", "0.9", "--time", "1", "--geometry", "published"],
    ];
    for arguments in others.into_iter().step_by(sweep([3, 1])) {
        let (_, other) = screenshot(folder.path(), "other.png", arguments);
        assert!(other != fast, "{arguments:?} changes nothing");
    }
    let file = folder.path().join("fast.png");
    let text = Settings::default().with_file(&file).expect("it is recorded").to_toml();
    let written = folder.path().join("fast.toml");
    std::fs::write(&written, text).expect("the folder is there");
    for state in [file, written] {
        let arguments = ["--state", state.to_str().expect("a plain path")];
        let (_, opened) = screenshot(folder.path(), "opened.png", &arguments);
        assert!(opened == fast, "{} opens as it was", state.display());
    }
    // What is made in the background is waited for.
    let background =
        ["--beta", "0.9", "--time", "1", "--plot", "fit", "--corrected", "--renderer", "reference"];
    let [(_, fit), (_, again)] = [0, 1].map(|_| screenshot(folder.path(), "fit.png", &background));
    assert!(fit == again, "the same fit is drawn the same");
}

fn a_screenshot_that_cannot_be_written_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("nowhere").join("window.png");
    let output = gamow(&["--screenshot", path.to_str().expect("a plain path")]);
    assert_eq!(output.status.code(), Some(2));
    assert!(std::fs::read_dir(folder.path()).expect("it is there").next().is_none());
}

fn bad_flags_are_named_before_anything_is_drawn() {
    for (arguments, part) in [
        (["--scene", "bicycle"], "bicycle"),
        (["--gamma", "0.5"], "gamma = 0.5"),
        (["--d", "-1"], "--d"),
        (["--window-size", "wide"], "from 64 to 8192"),
    ] {
        let output = gamow(&arguments);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(part), "{message}");
    }
}

fn an_adapter_that_is_not_there_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("window.png");
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    let output = command.env("WGPU_ADAPTER_NAME", "nothing").arg("--screenshot").arg(&path).output();
    let output = output.expect("it starts");
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    let lines: Vec<&str> = message.lines().filter(|line| line.starts_with("gamow:")).collect();
    assert!(lines.len() == 1 && lines[0].contains(r#"WGPU_ADAPTER_NAME="nothing""#), "{message}");
    assert!(!message.contains("panicked") && !path.exists(), "{message}");
}

fn without_a_display_it_says_what_to_do() {
    if !cfg!(target_os = "linux") {
        return;
    }
    let output = gamow(&[]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in ["no display", "mesa-vulkan-drivers", "gamow render --out cyclist.png", "gamow curve"] {
        assert!(message.contains(part), "{message}");
    }
    let lines = message.lines().filter(|line| line.starts_with("gamow:")).count();
    assert_eq!(lines, 1, "{message}");
}
