//! Whatever cannot be written: each way out names what it is about once and ends with status 2, and what was
//! there stays.

use std::fs::{self, File, OpenOptions};
use std::path::Path;
use std::process::{Command, Stdio};

use super::{Outcome, gamow, run};

/// All that writes to standard output, and quickly.
const TALKERS: [&str; 11] = [
    "curve --samples 9",
    "eval points.csv",
    "fit rows.csv",
    "fit rows.csv --json",
    "measure frame.exr --object 0",
    "accuracy --quick --scene two-balls --size 8x6 --json",
    "--list",
    "render --renderer reference --size 8x6 --timings --repeat 1 --out timed.png",
    "--help",
    "render --help",
    "--version",
];

/// All that writes files, and which: those that take longest last.
const WRITERS: [(&str, &str); 12] = [
    ("curve --samples 50 --out", "out.csv"),
    ("eval points.csv --out", "out.csv"),
    ("fit rows.csv --json --out", "out.json"),
    ("measure frame.exr --object 0 --out", "out.csv"),
    ("render --renderer reference --size 8x6 --out", "out.png"),
    ("render --renderer reference --size 8x6 --out", "out.exr"),
    ("render --renderer reference --size 8x6 --frames 2 --out", "out.gif"),
    ("render --renderer reference --size 8x6 --frames 2 --out", "out.mp4"),
    ("render --renderer reference --size 8x6 --frames 2 --out", "film.png"),
    ("rectify frame.exr --beta 0.5 --out", "out.exr"),
    ("lesson page.md --worksheet", "out.html"),
    ("accuracy --quick --scene two-balls --size 8x6 --out", "out.txt"),
];

/// How many of them are quick.
const QUICK: usize = 10;

/// A short lesson.
const LESSON: &str = "\
---
title: A page
concept: Paper
minutes: 1
---

What it is about.

## A step

Words of it.

## In a sentence

It is a page.
";

/// A folder with what the commands read.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let made = |words: &str| run(&mut command(folder.path(), words), b"").text();
    fs::write(folder.path().join("points.csv"), "beta,d,y,z,T\n0.9,0.3,0.5,0.5,0\n").expect("it is writable");
    fs::write(folder.path().join("page.md"), LESSON).expect("it is writable");
    made("curve --samples 9 --out rows.csv");
    made("render --renderer reference --size 64x48 --scene two-balls --out frame.exr");
    folder
}

/// `gamow` with these `words`, in `folder` and without a graphics adapter.
fn command(folder: &Path, words: &str) -> Command {
    let mut command = gamow();
    command.current_dir(folder).args(words.split_whitespace()).env("WGPU_BACKEND", "dx12");
    command
}

/// A device on which nothing has room.
fn full() -> Stdio {
    OpenOptions::new().write(true).open("/dev/full").expect("there is such a device").into()
}

fn ended(command: &mut Command) -> Outcome {
    let output = command.stdin(Stdio::null()).output().expect("the program starts");
    let stderr = String::from_utf8(output.stderr).expect("messages are text");
    Outcome { status: output.status.code(), stdout: output.stdout, stderr }
}

/// `command` with its streams as a shell redirects them.
fn in_shell(folder: &Path, words: &str, redirection: &str) -> Outcome {
    let script = format!("exec '{}' {words} {redirection}", env!("CARGO_BIN_EXE_gamow"));
    ended(Command::new("sh").current_dir(folder).args(["-c", &script]).env("WGPU_BACKEND", "dx12"))
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
    let mut names: Vec<_> = entries.map(|entry| name(entry.expect("it can be read"))).collect();
    names.sort();
    names
}

#[test]
fn a_full_standard_output_is_named_and_no_panic() {
    let folder = folder();
    for words in TALKERS {
        let outcome = ended(command(folder.path(), words).stderr(Stdio::piped()).stdout(full()));
        let said = "gamow: standard output: No space left on device (os error 28)";
        assert_eq!(outcome.complaint(), said, "{words}");
    }
}

#[test]
fn a_closed_standard_output_is_remarked_on() {
    let folder = folder();
    for words in TALKERS {
        // Its file is what a picture was asked for, and whoever asks for help reads it.
        let is_beside = ["--timings", "--help", "--version"].iter().any(|flag| words.contains(flag));
        let remark = "gamow: standard output is closed or discarded: this output is lost\n";
        let said = if is_beside { "" } else { remark };
        let outcome = in_shell(folder.path(), words, ">&-");
        assert_eq!((outcome.status, outcome.stderr.as_str()), (Some(0), said), "{words}");
        let outcome = in_shell(folder.path(), words, "> /dev/null");
        assert_eq!((outcome.status, outcome.stderr.as_str()), (Some(0), ""), "{words}");
    }
}

#[test]
fn a_reader_that_has_gone_ends_every_command_quietly() {
    let folder = folder();
    for words in TALKERS {
        let (reader, writer) = std::io::pipe().expect("there are pipes");
        drop(reader);
        let outcome = ended(command(folder.path(), words).stdout(writer));
        assert_eq!((outcome.status, outcome.stderr.as_str()), (Some(0), ""), "{words}");
    }
}

#[test]
fn a_full_or_closed_standard_error_changes_nothing() {
    let folder = folder();
    let ways = [
        ("curve --beta 3", 2),
        ("curve --no-such-flag", 2),
        ("eval nowhere.csv", 2),
        ("render --renderer reference --size 8x6 --frames 2 --out ride", 0),
        ("render --size 8x6 --out usual.png", 0), // says that there is no graphics adapter
        ("measure frame.exr nowhere.exr --object 0", 2),
    ];
    for (words, status) in ways {
        for redirection in ["2>/dev/full", "2>&-"] {
            let outcome = in_shell(folder.path(), words, redirection);
            assert_eq!(outcome.status, Some(status), "{words} {redirection}");
        }
    }
}

#[test]
fn a_file_that_cannot_be_written_is_named_once_and_nothing_is_left() {
    let folder = folder();
    fs::create_dir(folder.path().join("folder.csv")).expect("it is writable");
    std::os::unix::fs::symlink("loop", folder.path().join("loop")).expect("links work here");
    std::os::unix::fs::symlink("/nowhere/at all", folder.path().join("dangling")).expect("links work here");
    for (place_in_list, (words, name)) in WRITERS.into_iter().enumerate() {
        let ending = name.rsplit('.').next().expect("it has one");
        let place = |path: &str| folder.path().join(path).with_extension(ending);
        let ways = [
            ("nowhere/x", "No such file or directory (os error 2)"),
            ("rows.csv/x", "Not a directory (os error 20)"),
            ("loop/x", "Too many levels of symbolic links (os error 40)"),
            ("dangling/x", "No such file or directory (os error 2)"),
        ];
        for (path, problem) in ways.into_iter().take(if place_in_list < QUICK { ways.len() } else { 1 }) {
            let before = names_in(folder.path());
            let path = place(path);
            let outcome = run(command(folder.path(), words).arg(&path), b"");
            assert_eq!(outcome.complaint(), format!("gamow: {}: {problem}", path.display()), "{words}");
            assert_eq!(without_rest(&before), without_rest(&names_in(folder.path())), "{words}");
        }
        let link = place("full");
        std::os::unix::fs::symlink("/dev/full", &link).ok();
        let outcome = run(command(folder.path(), words).arg(&link), b"");
        let problem = "No space left on device (os error 28)";
        assert_eq!(outcome.complaint(), format!("gamow: {}: {problem}", link.display()), "{words}");
    }
}

fn without_rest(names: &[String]) -> Vec<&String> {
    names.iter().filter(|name| *name != "rest.txt").collect()
}

/// The largest file that `command` may write is `bytes` long.
fn limited(folder: &Path, bytes: usize, words: &str) -> Outcome {
    let program = env!("CARGO_BIN_EXE_gamow");
    let mut command = Command::new("prlimit");
    command.arg(format!("--fsize={bytes}")).arg(program).args(words.split_whitespace());
    ended(command.current_dir(folder).env("WGPU_BACKEND", "dx12"))
}

/// The system itself stops the file at so many bytes; `GAMOW_POSITIONS` says at how many of them.
#[test]
fn a_file_that_ends_too_early_is_not_there_and_the_old_one_stays() {
    let positions = std::env::var("GAMOW_POSITIONS").ok().and_then(|count| count.parse().ok()).unwrap_or(4);
    let folder = folder();
    for (words, name) in WRITERS.into_iter().take(QUICK) {
        let path = folder.path().join(name);
        let words = format!("{words} {name}");
        let whole = limited(folder.path(), 1 << 30, &words);
        assert_eq!(whole.status, Some(0), "{words}: {}", whole.stderr);
        let length = fs::read(&path).expect("it is there").len();
        for place in 0..positions.min(length) {
            let bytes = if place + 1 == positions { length - 1 } else { place * length / positions };
            for there in [false, true] {
                if there {
                    fs::write(&path, "precious").expect("it is writable");
                } else {
                    fs::remove_file(&path).expect("it is there");
                }
                let outcome = limited(folder.path(), bytes, &words);
                let said = format!("gamow: {name}: File too large (os error 27)");
                assert_eq!(outcome.complaint(), said, "{words} after {bytes} bytes");
                assert_eq!(path.exists(), there, "{words} after {bytes} bytes");
                assert!(!there || fs::read(&path).is_ok_and(|found| found == b"precious"), "{words}");
                let left = names_in(folder.path()).into_iter().find(|name| name.starts_with(".gamow"));
                assert_eq!(left, None, "{words} after {bytes} bytes");
            }
        }
    }
}

#[test]
fn a_replaced_file_keeps_its_rights() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let path = folder.path().join("mine.csv");
    for mode in [0o600, 0o640, 0o664, 0o777] {
        File::create(&path).expect("it is writable");
        fs::set_permissions(&path, fs::Permissions::from_mode(mode)).expect("it is ours");
        run(gamow().args(["curve", "--samples", "2", "--out"]).arg(&path), b"").text();
        let found = fs::metadata(&path).expect("it is there");
        assert_eq!((found.permissions().mode() & 0o7777, found.len() > 100), (mode, true));
    }
}

#[test]
fn what_a_dangling_link_points_to_is_made() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("data")).expect("it is writable");
    for (link, target) in [("first.csv", "second.csv"), ("second.csv", "data/third.csv")] {
        std::os::unix::fs::symlink(target, at(link)).expect("links work here");
    }
    run(gamow().args(["curve", "--samples", "2", "--out"]).arg(at("first.csv")), b"").text();
    assert!(["first.csv", "second.csv"].iter().all(|link| at(link).is_symlink()));
    assert_eq!(fs::read_to_string(at("data/third.csv")).expect("it is there").lines().count(), 3);
}

#[test]
fn what_a_terminal_would_obey_is_quoted_wherever_it_comes_from() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let scene =
        "name = \"a\\u001b[31mb\"\nboo\u{7f} = 1\n\u{1b}]0;x\u{7} = 2\n[[object]]\nshape = \"b\\u001bll\"\n";
    fs::write(folder.path().join("scene.toml"), scene).expect("it is writable");
    fs::write(folder.path().join("rows.csv"), "beta,d,y,z,T\u{1b}[2J\n1,2,3\n").expect("it is writable");
    let ways: [&[&str]; 10] = [
        &["eval", "rows.csv"],
        &["fit", "rows.csv"],
        &["render", "--scene", "scene.toml"],
        &["render", "--scene", "a\u{1b}[31m\nb"],
        &["curve", "--beta", "\u{1b}[31m\nx"],
        &["curve", "--beta=\u{9b}31mx"],
        &["curve", "--\u{1b}c"],
        &["\u{202e}evruc"],
        &["measure", "rows.csv", "--object", "\u{1b}\n"],
        &["lesson", "\u{1b}[1m", "--worksheet", "x.html"],
    ];
    for words in ways {
        let outcome = run(gamow().current_dir(folder.path()).args(words), b"");
        assert_eq!(outcome.status, Some(2), "{words:?}");
        let said = outcome.stderr;
        let is_obeyed = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
        assert!(!said.is_empty() && !said.contains(is_obeyed), "{words:?}: {said:?}");
        assert!(!said.starts_with("gamow: ") || said.lines().count() == 1, "{words:?}: {said}");
    }
}

/// `.ci/kills COUNT` does it more often, by hand.
#[test]
fn a_command_that_is_killed_leaves_what_was_there_or_all_that_is_new() {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join(".ci/kills");
    let outcome = ended(Command::new(script).args(["16", env!("CARGO_BIN_EXE_gamow")]));
    assert_eq!((outcome.status, outcome.stderr.as_str()), (Some(0), ""));
}
