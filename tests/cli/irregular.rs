//! What is no regular file: a pipe without a writer, a device, a file of the system that waits. None of them
//! is waited for, unless it is a pipe that was named to be read from.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use gamow::files::png;
use gamow::files::provenance::Provenance;
use relativity_render::Picture;

use super::{Outcome, gamow};

/// Longest that a command may take here; one that waits would take for ever.
const LONGEST: Duration = Duration::from_mins(2);

/// What `command` leaves, which is ended after [`LONGEST`].
fn ended(command: &mut Command) -> Outcome {
    let mut child = command
        .env("WGPU_BACKEND", "dx12")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let begun = Instant::now();
    while child.try_wait().expect("it is ours").is_none() {
        if begun.elapsed() > LONGEST {
            child.kill().expect("it is ours");
            panic!("{command:?} waits");
        }
        thread::sleep(Duration::from_millis(20));
    }
    let output = child.wait_with_output().expect("it has ended");
    let stderr = String::from_utf8(output.stderr).expect("messages are text");
    Outcome { status: output.status.code(), stdout: output.stdout, stderr }
}

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().expect("there is mkfifo").success());
}

/// Asserts that `gamow` with these `words` in `folder` says that `place` is no file, and writes none.
fn assert_refused(folder: &Path, words: &str, place: &str) {
    let outcome = ended(gamow().current_dir(folder).args(words.split_whitespace()));
    let complaint = outcome.complaint();
    let right = "it is a device or a pipe; an ordinary file would be right";
    assert!(complaint.contains(place) && complaint.ends_with(right), "{words}: {complaint}");
    let left = fs::read_dir(folder).expect("it is there");
    let is_new = |name: &str| name.starts_with("new") || name.starts_with(".gamow");
    let new =
        left.filter(|entry| entry.as_ref().is_ok_and(|entry| is_new(&entry.file_name().to_string_lossy())));
    assert_eq!(new.count(), 0, "{words}");
}

#[test]
fn nothing_waits_for_a_pipe_or_a_device_in_place_of_a_file() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let at = |name: &str| folder.path().join(name);
    for name in ["p.toml", "p.png", "p.exr", "p.md"] {
        pipe(&at(name));
    }
    let out = "render --renderer reference --size 8x6 --out new.png";
    for (words, place) in [
        (format!("{out} --scene p.toml"), "p.toml"),
        (format!("{out} --scene /dev/zero"), "/dev/zero"),
        (format!("{out} --state p.toml"), "p.toml"),
        (format!("{out} --state p.png"), "p.png"),
        (format!("{out} --state p.exr"), "p.exr"),
        ("lesson p.md --worksheet new.html".to_owned(), "p.md"),
        ("rectify p.png --beta 0.5 --out new.png".to_owned(), "p.png"),
        ("rectify p.exr --beta 0.5 --out new.exr".to_owned(), "p.exr"),
        ("measure p.exr --object 0".to_owned(), "p.exr"),
        ("--screenshot new.png --state p.toml".to_owned(), "p.toml"),
        ("--screenshot new.png --lesson p.md".to_owned(), "p.md"),
    ] {
        assert_refused(folder.path(), &words, place);
    }
}

#[test]
fn a_pipe_that_another_file_names_is_refused() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let at = |name: &str| folder.path().join(name);
    pipe(&at("p.toml"));
    fs::write(at("state.toml"), "scene = \"p.toml\"\n").expect("it is writable");
    let provenance = Provenance {
        title: String::new(),
        parameters: "gamow render --scene=p.toml".to_owned(),
        scene_fingerprint: String::new(),
        models: String::new(),
    };
    let picture = Picture { size: [1, 1], rgba: vec![[0; 4]] };
    let mut file = fs::File::create(at("seen.png")).expect("it is writable");
    png::write(&picture, &provenance.texts(), &mut file).expect("it is writable");
    let lesson = "---\ntitle: P\nconcept: Pipes\nminutes: 1\n---\n\nIt begins.\n\n## A step\n\n```state\nscene = \"p.toml\"\n```\n\n\
                  Look.\n\n## In a sentence\n\nIt is one.\n";
    fs::write(at("page.md"), lesson).expect("it is writable");
    let out = "render --renderer reference --size 8x6 --out new.png";
    for words in [
        format!("{out} --state state.toml"),
        format!("{out} --state seen.png"),
        "lesson page.md --worksheet new.html".to_owned(),
        "--screenshot new.png --state state.toml".to_owned(),
    ] {
        assert_refused(folder.path(), &words, "p.toml");
    }
}

#[test]
fn a_pipe_among_lessons_is_passed_over_and_one_among_frames_is_refused() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    pipe(&folder.path().join("pipe.md"));
    let listed = ended(gamow().current_dir(folder.path()).args(["--list", "--lessons", "."]));
    assert_eq!(listed.status, Some(0), "{}", listed.stderr);
    assert!(String::from_utf8_lossy(&listed.stdout).contains("rods"));
    fs::create_dir(folder.path().join("ride")).expect("it is writable");
    pipe(&folder.path().join("ride/frame_00000.png"));
    assert_refused(
        folder.path(),
        "render --renderer reference --size 8x6 --frames 2 --out ride",
        "frame_00000.png",
    );
}

#[test]
fn rows_are_read_from_a_pipe_that_is_named_and_written_to_one() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let rows = "beta,d,y,z,T\n0.9,0.3,0.5,0.5,0\n";
    fs::write(folder.path().join("rows.csv"), rows).expect("it is writable");
    for name in ["in.csv", "out.csv"] {
        pipe(&folder.path().join(name));
    }
    let expected = super::eval(rows).text();
    let program = env!("CARGO_BIN_EXE_gamow");
    for script in ["cat rows.csv > in.csv & $0 eval in.csv", "$0 eval rows.csv --out out.csv & cat out.csv"] {
        let mut shell = Command::new("sh");
        let outcome = ended(shell.current_dir(folder.path()).args(["-c", script, program]));
        assert_eq!(outcome.text(), expected, "{script}");
    }
}
