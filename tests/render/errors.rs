//! What cannot be drawn, and what is drawn instead.

use std::fs;
use std::process::Command;

use super::{Png, complaint, folder, output};

#[test]
fn mistakes_are_told_in_one_line() {
    let folder = folder();
    for (flags, told) in [
        ("--out picture.jpg", ".png or .exr"),
        ("--out folder", "--frames"),
        ("--frames 2 --out hits.exr", "folder"),
        ("--frames 2 --out ride.webm", ".gif, .mp4 or .png"),
        ("--frames 2 --size 4100x2304 --renderer packets --out ride.mp4", "9.4 million pixels"),
        ("--frames 2 --beta 0 --out ride", "--from and --to"),
        ("--geometry published", "--renderer mesh"),
        ("--geometry published --renderer rays", "--renderer mesh"),
        ("--geometry one-cone --renderer rays", "--renderer mesh"),
        ("--scene cyclsit", "cyclsit"),
        ("--scene missing.toml", "missing.toml"),
        ("--beta 1", "beta = 1"),
        ("--out missing/picture.png", "missing/picture.png"),
    ] {
        let line = complaint(folder.path(), flags);
        assert!(line.contains(told), "{flags}: {line}");
    }
    assert!(fs::read_dir(folder.path()).expect("it is there").next().is_none(), "a file was left behind");
}

#[test]
fn flags_that_cannot_be_read_name_what_would_be_right() {
    let folder = folder();
    for (flags, told) in [
        ("--size 0x5", "960x540"),
        ("--fov 180", "between 1e-9 and 179.999"),
        ("--d -1", "between 0 and 1e6"),
        ("--ride 2", "2@0.5,4@0"),
        ("--ride 2@0.5,", "2@0.5,4@0"),
        ("--ride 20@1", "at most 14.6"),
        ("--ride-speed 1", "beta = 1 is out of range"),
        ("--ride-speed fast", "not a number"),
        ("--ride-speed speed:2", "gamma:10"),
        ("--gaze up", "90,0"),
        ("--gaze 0,90", "level"),
        ("--layout both", "side-by-side"),
        ("--exposure nan", "finite"),
        ("--samples 0", "1..=16"),
        ("--time 1e70", "between -1e12 and 1e12"),
        ("--time 1 --frames 2", "--frames"),
        ("--beta 0.5 --gamma 2", "--gamma"),
    ] {
        let output = output(folder.path(), flags);
        let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{flags}: {stderr}");
        assert!(stderr.contains(told), "{flags}: {stderr}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn without_an_adapter_it_draws_on_the_cpu_and_says_so() {
    let folder = folder();
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    let flags = ["render", "--size=48x36", "--samples=1", "--out=picture.png"];
    // There is no Direct3D 12 on this system.
    let output = command.current_dir(folder.path()).args(flags).env("WGPU_BACKEND", "dx12").output();
    let output = output.expect("the program starts");
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{stderr}");
    assert!(stderr.contains("drawing on the CPU") && stderr.lines().count() == 1, "{stderr}");
    let parameters = &Png::read(&folder.path().join("picture.png")).texts["Parameters"];
    assert!(parameters.contains("--renderer=packets"), "{parameters}");

    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    let demanded = command.args(flags).arg("--renderer=rays").env("WGPU_BACKEND", "dx12").output();
    assert_eq!(demanded.expect("the program starts").status.code(), Some(2));
}
