//! Rows in and out: what passes through, when it appears, and files that are whole or not there.

use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::path::Path;
use std::process::Stdio;
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use super::{eval, gamow, run, words};

const APPENDED: &str = "x_left,x_right,t_left,t_right,doppler_left,doppler_right,intensity_left,intensity_right,\
                        phi_left,phi_right,theta_left,theta_right,dphi,dtheta,tau_left,tau_right";

const GOOD: &str = "beta,d,y,z,T\n0.9,0.3,0.5,0.5,0\n";

#[test]
fn header_alone_gives_a_header_alone() {
    for input in ["beta,d,y,z,T", "beta,d,y,z,T\n", "beta,d,y,z,T\r\n", "\u{feff}beta,d,y,z,T\n\n"] {
        assert_eq!(eval(input).text(), format!("beta,d,y,z,T,{APPENDED}\n"));
    }
}

#[test]
fn columns_may_come_in_any_order_and_others_pass_through_in_place() {
    let plain = eval(GOOD).text();
    let appended = plain.lines().nth(1).and_then(|row| row.strip_prefix("0.9,0.3,0.5,0.5,0,"));
    let appended = appended.expect("the inputs come first");
    let mixed =
        "who,T,z, y ,,beta,d,\"say, \"\"hi\"\"\"\nrider,0,5e-1,\" 0.50 \",x,.9,+0.3,\"a,\n\"\"b\"\"\"\n";
    assert_eq!(
        eval(mixed).text(),
        format!(
            "who,T,z, y ,,beta,d,\"say, \"\"hi\"\"\",{APPENDED}\n\
             rider,0,5e-1, 0.50 ,x,.9,+0.3,\"a,\n\"\"b\"\"\",{appended}\n"
        )
    );
}

#[test]
fn bytes_that_are_no_text_pass_through_columns_that_mean_nothing() {
    let outcome = eval(b"\xffname,beta,d,y,z,T\n\xc0\xff,0,0,1,1,0\n");
    assert_eq!((outcome.status, outcome.stderr.as_str()), (Some(0), ""));
    assert!(outcome.stdout.starts_with(b"\xffname,beta"));
    assert!(outcome.stdout.windows(4).any(|bytes| bytes == b"\n\xc0\xff,"));
}

#[test]
fn line_endings_and_blank_lines_make_no_difference() {
    let expected = eval(GOOD).text();
    for input in [
        GOOD.replace('\n', "\r\n"),
        GOOD.replace('\n', "\n\n"),
        GOOD.trim_end().to_owned(),
        format!("\u{feff}{GOOD}"),
    ] {
        assert_eq!(eval(input).text(), expected);
    }
}

#[test]
fn x0_is_zero_unless_given() {
    let with = eval("beta,d,y,z,T,x0\n0.9,0.3,0.5,0.5,0,0\n").table();
    assert_eq!(with.rows[0][6..], eval(GOOD).table().rows[0][5..]);
}

#[test]
fn dash_is_standard_input_and_standard_output() {
    let expected = eval(GOOD).text();
    assert_eq!(run(gamow().args(["eval", "-", "--out", "-"]), GOOD.as_bytes()).text(), expected);
}

#[test]
fn rows_appear_while_the_input_is_still_open() {
    let mut child =
        gamow().arg("eval").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("the program starts");
    let mut input = child.stdin.take().expect("it is piped");
    let output = BufReader::new(child.stdout.take().expect("it is piped")).lines();
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || output.map_while(Result::ok).try_for_each(|line| sender.send(line)));
    let line = || receiver.recv_timeout(Duration::from_mins(1)).expect("a row appears");
    input.write_all(GOOD.as_bytes()).expect("the program reads");
    assert!(line().ends_with("tau_right"));
    assert!(line().starts_with("0.9,0.3,0.5,0.5,0,"));
    for time in 1..4 {
        input.write_all(format!("0.5,0,1,1,{time}\r\n").as_bytes()).expect("the program reads");
        assert!(line().starts_with(&format!("0.5,0,1,1,{time},")));
    }
    drop(input);
    assert!(receiver.recv().is_err(), "no row is left");
    assert!(child.wait().expect("the program ends").success());
}

#[test]
fn reader_that_has_seen_enough_ends_the_program_quietly() {
    let mut child = gamow()
        .args(["curve", "--samples", "1000000000"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut output = BufReader::new(child.stdout.take().expect("it is piped"));
    output.read_line(&mut String::new()).expect("it is text");
    drop(output);
    let mut complaint = String::new();
    let mut stderr = child.stderr.take().expect("it is piped");
    stderr.read_to_string(&mut complaint).expect("messages are text");
    assert!(child.wait().expect("the program ends").success());
    assert_eq!(complaint, "");
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    entries.map(|entry| entry.expect("it can be read").file_name().to_string_lossy().into_owned()).collect()
}

#[test]
fn out_writes_what_standard_output_would_get() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let file = folder.path().join("out.csv");
    assert_eq!(run(gamow().arg("eval").arg("--out").arg(&file), GOOD.as_bytes()).text(), "");
    assert_eq!(fs::read_to_string(&file).expect("it is there"), eval(GOOD).text());
    assert_eq!(run(gamow().args(["curve", "--samples", "4", "--out"]).arg(&file), b"").text(), "");
    assert_eq!(fs::read_to_string(&file).expect("it is there"), words("curve --samples 4").text());
    assert_eq!(names_in(folder.path()), ["out.csv"]);
}

#[test]
fn out_may_be_the_input() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let file = folder.path().join("rows.csv");
    fs::write(&file, GOOD).expect("it is writable");
    run(gamow().arg("eval").arg(&file).arg("--out").arg(&file), b"").text();
    assert_eq!(fs::read_to_string(&file).expect("it is there"), eval(GOOD).text());
}

#[test]
fn out_is_left_as_it_was_when_a_row_is_bad() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let file = folder.path().join("out.csv");
    let rows = "0.9,0.3,0.5,0.5,0\n".repeat(10_000); // more than any buffer holds
    let input = format!("beta,d,y,z,T\n{rows}1,0.3,0.5,0.5,0\n");
    let evaluated = || run(gamow().arg("eval").arg("--out").arg(&file), input.as_bytes());
    evaluated().complaint();
    assert_eq!(names_in(folder.path()), [""; 0]);
    fs::write(&file, "precious").expect("it is writable");
    evaluated().complaint();
    assert_eq!(fs::read_to_string(&file).expect("it is there"), "precious");
    assert_eq!(names_in(folder.path()), ["out.csv"]);
}

#[test]
fn out_in_a_folder_that_is_not_there_is_an_error() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let file = folder.path().join("nowhere").join("out.csv");
    let complaint = run(gamow().args(["curve", "--out"]).arg(&file), b"").complaint();
    assert!(complaint.contains("nowhere"), "{complaint}");
    let complaint = run(gamow().args(["curve", "--out"]).arg(folder.path()), b"").complaint();
    assert!(complaint.starts_with(&format!("gamow: {}", folder.path().display())), "{complaint}");
}

#[cfg(unix)]
#[test]
fn out_keeps_links_devices_and_the_usual_permissions() {
    use std::os::unix::fs::{FileTypeExt as _, PermissionsExt as _, symlink};
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let (target, link) = (folder.path().join("target.csv"), folder.path().join("link.csv"));
    let default = folder.path().join("usual");
    for file in [&target, &default] {
        fs::write(file, "").expect("it is writable");
    }
    symlink(&target, &link).expect("links work here");
    run(gamow().args(["curve", "--samples", "2", "--out"]).arg(&link), b"").text();
    assert!(fs::symlink_metadata(&link).expect("it is there").is_symlink());
    let mode = |path| fs::metadata(path).expect("it is there").permissions().mode();
    assert_eq!(
        (fs::read_to_string(&target).expect("it is text").lines().count(), mode(&target)),
        (3, mode(&default))
    );

    run(gamow().args(["curve", "--out", "/dev/null"]), b"").text();
    assert!(fs::metadata("/dev/null").expect("it is there").file_type().is_char_device());
}

#[test]
#[cfg(unix)]
fn an_interrupt_leaves_nothing_behind() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sightings.csv");
    let mut child =
        gamow().args(["eval", "--out"]).arg(&path).stdin(Stdio::piped()).spawn().expect("the program starts");
    let mut rows = child.stdin.take().expect("it is piped");
    rows.write_all(GOOD.as_bytes()).expect("it reads");
    let files = || fs::read_dir(folder.path()).expect("it is there").count();
    let start = Instant::now();
    while files() == 0 && start.elapsed() < Duration::from_mins(2) {
        thread::sleep(Duration::from_millis(10));
    }
    // Interrupts know it as soon as it is there.
    assert_eq!(files(), 1, "a temporary file");
    let kill = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.expect("there is kill").success());
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    assert_eq!(files(), 0);
    drop(rows);
}

#[test]
#[cfg(unix)]
fn files_whose_names_are_no_text_are_read_and_written() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt as _;
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let name = |ending: &[u8]| OsStr::from_bytes(&[b"./r\xff", ending].concat()).to_owned();
    let gamow = || {
        let mut gamow = gamow();
        gamow.current_dir(folder.path());
        gamow
    };
    let small = ["--size", "32x24", "--samples", "1", "--renderer", "reference"];
    let draw = || {
        let mut draw = gamow();
        draw.arg("render").args(small);
        draw
    };
    run(gamow().args(["curve", "--out"]).arg(name(b".csv")), b"").text();
    assert_eq!(run(gamow().arg("fit").arg(name(b".csv")), b"").status, Some(0));
    run(draw().arg("--out").arg(name(b".png")), b"").text();
    run(draw().args(["--out", "a.png", "--state"]).arg(name(b".png")), b"").text();
    let lesson = "---\ntitle: Mine\n---\n\n## One\n\nLook.\n";
    fs::write(folder.path().join(name(b".md")), lesson).expect("it is writable");
    run(gamow().arg("lesson").arg(name(b".md")).args(["--worksheet", "a.html"]), b"").text();
    // A scene's name is recorded as text.
    let refused = run(draw().args(["--out", "b.png", "--scene"]).arg(name(b".toml")), b"");
    assert_eq!(refused.status, Some(2));
    let reason = "the file's name is not text in UTF-8, so nothing could record which scene is shown";
    assert!(refused.stderr.contains(reason), "{}", refused.stderr);
    assert!(!folder.path().join("b.png").exists());
}
