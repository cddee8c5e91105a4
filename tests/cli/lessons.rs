//! `gamow --list` and `--lesson`: what there is, and what is said of what there is not.

use std::fs;
use std::process::Stdio;

use super::{gamow, run, words};

/// The lines of the list for these `arguments`.
fn list(arguments: &[&str]) -> Vec<String> {
    let text = run(gamow().arg("--list").args(arguments), b"").text();
    text.lines().map(str::to_owned).collect()
}

#[test]
fn all_lessons_and_presets_are_listed_in_columns() {
    let lines = list(&[]);
    let is_preset = |line: &&String| line.contains("(preset)");
    let lessons: Vec<_> = lines.iter().take_while(|line| !is_preset(line)).collect();
    assert_eq!(lessons.len(), 21);
    assert!(lines[21..].iter().all(|line| is_preset(&line)) && lines.len() >= 25);
    assert!(lines[0].starts_with("rods ") && lines[21].starts_with("real-light "));
    // Names, minutes, concepts and titles each begin where those above do.
    let header = |file: &str, key: &str| {
        let text = fs::read_to_string(format!("assets/lessons/{file}.md")).expect("it is there");
        let line = text.lines().find_map(|line| line.strip_prefix(key)).expect("it is said");
        line.trim().to_owned()
    };
    let column = |line: &str, what: &str| line.rfind(what).unwrap_or_else(|| panic!("{what} in {line}"));
    let places: Vec<_> = lessons
        .iter()
        .map(|line| {
            let file = line.split(' ').next().expect("a name");
            let minutes = format!("{} min  ", header(file, "minutes:"));
            let concept = format!("  {} ", header(file, "concept:"));
            let ends = column(line, &minutes) + minutes.len();
            [
                ends,
                line.find(&concept).expect(&concept),
                column(line, &format!("  {}", header(file, "title:"))),
            ]
        })
        .collect();
    assert!(places.iter().all(|place| *place == places[0]), "{places:?}");
}

#[test]
fn lessons_of_ones_own_are_listed_in_their_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, title: &str, order: u32| {
        let text = format!("---\ntitle: {title}\norder: {order}\n---\n\n## One step\n\nLook.\n");
        fs::write(folder.path().join(name), text).expect("it is written");
    };
    write("mine.md", "Mine", 2);
    write("rods.md", "Other rods", 1);
    write("README.md", "None", 1);
    let lines = list(&["--lessons", folder.path().to_str().expect("a plain path")]);
    assert_eq!(lines.len(), list(&[]).len() + 1);
    assert!(lines[0].starts_with("rods ") && lines[0].ends_with("  Other rods"), "{}", lines[0]);
    assert_eq!(lines.iter().filter(|line| line.ends_with("  Mine")).count(), 1);
    // One that cannot be read is listed with the reason.
    write("broken\u{1b}.md", "Broken\n## x", 3);
    fs::write(folder.path().join("wrong.md"), "---\norder: 1\n---\n").expect("it is written");
    let with_wrong = list(&["--lessons", folder.path().to_str().expect("a plain path")]);
    assert_eq!(with_wrong.len(), lines.len() + 2);
    let last = with_wrong.last().expect("a line");
    assert!(last.starts_with("wrong ") && last.contains("  (refused)  "), "{last}");
    assert!(last.ends_with("wrong.md:3: a lesson needs a title: `title: …`"), "{last}");
    let page = folder.path().join("page.html");
    let worksheet = |name: &str| {
        run(gamow().args(["lesson", name, "--worksheet"]).arg(&page).arg("--lessons").arg(folder.path()), b"")
    };
    let complaint = worksheet("wrong").complaint();
    assert!(complaint.ends_with("wrong.md:3: a lesson needs a title: `title: …`"), "{complaint}");
    assert!(!page.exists());
    worksheet("mine").text();
    assert!(page.exists());
    let complaint = words("--list --lessons /nowhere/at/all").complaint();
    assert!(complaint.contains("/nowhere/at/all"), "{complaint}");
}

#[test]
fn a_reader_that_goes_away_ends_the_list_quietly() {
    let mut child = gamow()
        .arg("--list")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]));
}

#[test]
fn a_lesson_that_is_not_there_is_told_in_a_line() {
    for (arguments, parts) in [
        ("--lesson no-such", ["no lesson is called `no-such`", "rods"]),
        ("--lesson nowhere.md", ["nowhere.md", "cannot read"]),
        ("--lesson rods --state street", ["--lesson", "--state"]),
    ] {
        let outcome = words(&format!("{arguments} --screenshot never.png"));
        assert_eq!(outcome.status, Some(2), "{arguments}");
        assert!(parts.iter().all(|part| outcome.stderr.contains(part)), "{}", outcome.stderr);
    }
    words("--lesson no-such").complaint();
    words("--lesson nowhere.md").complaint();
}

/// Neither the window nor a worksheet crashes on it, and no file is left behind.
#[test]
fn a_hostile_lesson_is_refused_in_a_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let front = "---\ntitle: x\n---\n\n## One\n\n";
    for (text, said) in [
        (">".repeat(8000) + " x", "7: quotes, lists and emphasis may be nested at most 16 deep"),
        ("- ".repeat(4000) + "x", "7: quotes, lists and emphasis may be nested at most 16 deep"),
        ("- ".repeat(6000) + "x", "7: a text that is shown at once has at most 8 kB"),
        ("a ".repeat(2_000_000), "1: a lesson has at most 64 kB"),
        (format!("${}x{}$", "{".repeat(200), "}".repeat(200)), "7: the formula ${{{"),
        (format!("$\\rule{{{}em}}{{1em}}$", "9".repeat(50)), "7: the formula $\\rule{999"),
    ] {
        fs::write(folder.path().join("q.md"), format!("{front}{text}\n")).expect("it is written");
        for arguments in
            [["lesson", "q.md", "--worksheet", "q.html"], ["--screenshot", "q.png", "--lesson", "q.md"]]
        {
            let complaint = run(gamow().args(arguments).current_dir(folder.path()), b"").complaint();
            assert!(complaint.starts_with(&format!("gamow: q.md:{said}")), "{complaint}");
            assert!(complaint.len() < 250, "{complaint}");
            assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1, "{arguments:?}");
        }
    }
}

#[test]
fn the_bodies_of_a_scene_are_listed() {
    let names = list(&["--scene", "twins"]);
    assert_eq!(names[..2], ["resting rod 1", "resting rod 2"]);
    assert_eq!(list(&["--scene", "street"]).iter().filter(|name| *name == "front tyre").count(), 1);
}
