//! Sequences that are broken off and taken up again.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::thread;
use std::time::{Duration, Instant};

use super::{HEIGHT, Png, WIDTH, command, folder, output, render};

fn frame(folder: &Path, number: u32) -> PathBuf {
    folder.join(format!("ride/frame_{number:05}.png"))
}

#[test]
fn a_sequence_keeps_the_frames_it_finds_and_mends_the_others() {
    let folder = folder();
    let flags = "--frames 4 --from 1 --to 2.5 --samples 1 --out ride";
    render(folder.path(), flags);
    let whole: Vec<_> =
        (0..4).map(|number| fs::read(frame(folder.path(), number)).expect("it is there")).collect();
    assert!(Png::read(&frame(folder.path(), 2)).texts["Parameters"].contains("--time=2 "));

    let kept_before =
        fs::metadata(frame(folder.path(), 0)).and_then(|file| file.modified()).expect("it is there");
    fs::remove_file(frame(folder.path(), 1)).expect("it is there");
    fs::write(frame(folder.path(), 2), &whole[2][..whole[2].len() - 20]).expect("it is writable");
    fs::copy(frame(folder.path(), 0), frame(folder.path(), 3)).expect("it is writable"); // of another time
    let message = String::from_utf8(output(folder.path(), flags).stderr).expect("it is text");
    let lines: Vec<_> = message.lines().collect();
    assert!(lines[0].starts_with(&format!("4 frames, {WIDTH}x{HEIGHT} per eye: about ")), "{message}");
    assert!(lines[1].starts_with("3 frames drawn and 1 kept in ride: ") && lines.len() == 2, "{message}");
    for (number, whole) in (0..4).zip(&whole) {
        assert!(fs::read(frame(folder.path(), number)).is_ok_and(|bytes| bytes == *whole), "frame {number}");
    }
    let kept_after =
        fs::metadata(frame(folder.path(), 0)).and_then(|file| file.modified()).expect("it is there");
    assert_eq!(kept_after, kept_before);
}

#[test]
fn a_sequence_draws_again_what_other_parameters_or_another_scene_made() {
    let folder = folder();
    let scene = |radius: &str| {
        let text = format!(
            "name = 'Ball'\n[[object]]\nshape = 'sphere'\ncentre = [0.0, 3.0, 0.5]\nradius = {radius}\n"
        );
        fs::write(folder.path().join("ball.toml"), text).expect("the folder is writable");
    };
    let drawn = |flags: &str| {
        let flags = format!("--scene ball.toml --frames 2 --samples 1 --out ride {flags}");
        String::from_utf8(output(folder.path(), &flags).stderr).expect("it is text")
    };
    scene("0.4");
    assert!(drawn("").starts_with("2 frames drawn and 0 kept"));
    assert!(drawn("").starts_with("0 frames drawn and 2 kept"));
    assert!(drawn("--exposure 1").starts_with("2 frames drawn and 0 kept"));
    scene("0.5");
    assert!(drawn("--exposure 1").starts_with("2 frames drawn and 0 kept"));
}

#[test]
fn a_killed_sequence_leaves_only_whole_frames() {
    let folder = folder();
    let mut child = command(folder.path(), "--frames 1000 --samples 1 --labels off --out ride")
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let start = Instant::now();
    while !frame(folder.path(), 3).exists() {
        assert!(start.elapsed() < Duration::from_mins(1), "no frames appear");
        thread::sleep(Duration::from_millis(2));
    }
    child.kill().expect("it runs still");
    child.wait().expect("it ends");
    let mut frames = 0;
    for entry in fs::read_dir(folder.path().join("ride")).expect("it is there") {
        let path = entry.expect("it can be read").path();
        if path.extension().is_some_and(|extension| extension == "png") {
            assert_eq!(Png::read(&path).size, [2 * WIDTH, HEIGHT]);
            frames += 1;
        }
    }
    assert!((4..1000).contains(&frames), "{frames} frames");
}

/// The frames of all parts are those of the whole, byte for byte, and each is drawn by one part alone.
#[test]
fn parts_make_the_frames_of_the_whole_once_each() {
    let folder = folder();
    let flags = "--frames 8 --from 1 --to 2.5 --samples 1";
    let said = |flags: &str| String::from_utf8(output(folder.path(), flags).stderr).expect("it is text");
    let last_line = |text: String| text.lines().last().unwrap_or_default().to_owned();
    let names = |folder: &Path| {
        let entries = fs::read_dir(folder).expect("it is there");
        let mut names: Vec<_> = entries.map(|entry| entry.expect("it can be read").file_name()).collect();
        names.sort();
        names
    };
    render(folder.path(), &format!("{flags} --out ride"));
    for (part, frames) in [("1/3", [0, 3, 6].as_slice()), ("2/3", &[1, 4, 7]), ("3/3", &[2, 5])] {
        let flags = format!("{flags} --part {part} --out parts");
        let drawn = last_line(said(&flags));
        assert!(drawn.starts_with(&format!("{} frames drawn and 0 kept", frames.len())), "{part}: {drawn}");
        // A restart draws what is missing, and nothing else.
        fs::remove_file(folder.path().join(format!("parts/frame_{:05}.png", frames[1])))
            .expect("it was drawn");
        let again = last_line(said(&flags));
        assert!(
            again.starts_with(&format!("1 frames drawn and {} kept", frames.len() - 1)),
            "{part}: {again}"
        );
    }
    let [whole, parts] = ["ride", "parts"].map(|name| folder.path().join(name));
    assert_eq!(names(&whole), names(&parts));
    for name in names(&whole) {
        let [whole, part] = [&whole, &parts].map(|folder| fs::read(folder.join(&name)).expect("it is there"));
        assert!(whole == part, "{}", name.display());
    }
    // The whole finds them all, and more parts than frames leave some without any.
    assert!(last_line(said(&format!("{flags} --out parts"))).starts_with("0 frames drawn and 8 kept"));
    assert!(
        last_line(said(&format!("{flags} --part 9/9 --out parts"))).starts_with("0 frames drawn and 0 kept")
    );
}

#[test]
fn a_part_that_is_none_is_refused_in_a_line() {
    let folder = folder();
    for part in ["4/3", "0/3", "1/0", "3", "1/", "/", "-1/3", "1.5/3", "1/3/3", "1/99999999999", ""] {
        let output = output(folder.path(), &format!("--frames 3 --out ride --part={part}"));
        let error = String::from_utf8(output.stderr).expect("it is text");
        let told = format!("gamow: --part {part}: must be I/K, such as 2/8: part I, from 1 to K, of K parts");
        assert!(!output.status.success() && error.starts_with(&told), "{part}: {error}");
        assert!(!folder.path().join("ride").exists(), "{part}");
    }
    for (flags, complaint) in [
        (
            "--frames 3 --part 1/3 --renderer auto --out ride",
            "--part 1/3: --renderer is needed (rays, packets, mesh or reference), so that all parts are drawn alike",
        ),
        (
            "--frames 3 --part 1/3 --out ride.gif",
            "--part 1/3: an animation is one file; parts of a sequence need a folder",
        ),
    ] {
        let error = String::from_utf8(output(folder.path(), flags).stderr).expect("it is text");
        assert_eq!(error, format!("gamow: {complaint}\n"));
    }
}

/// How much it will be is told before most of it is made, and how much it is at the end.
#[test]
fn a_sequence_of_measurements_tells_its_size_beforehand_and_afterwards() {
    let folder = folder();
    let message =
        String::from_utf8(output(folder.path(), "--frames 16 --exr --out ride").stderr).expect("it is text");
    let lines: Vec<_> = message.lines().collect();
    let kilobytes = |line: &str, before: &str| {
        let (_, rest) = line.split_once(before).expect("the size is told");
        let (number, _) = rest.split_once(" kB").expect("some kilobytes");
        number.parse::<f64>().expect("a number")
    };
    assert_eq!(lines.len(), 2, "{message}");
    assert!(lines[0].starts_with(&format!("16 frames, {WIDTH}x{HEIGHT} per eye: about ")), "{message}");
    assert!(lines[0].ends_with(", estimated from 3 of them"), "{message}");
    let (estimate, total) = (kilobytes(lines[0], "about "), kilobytes(lines[1], "in ride: "));
    let bytes: u64 = fs::read_dir(folder.path().join("ride"))
        .expect("it is there")
        .map(|entry| entry.and_then(|entry| entry.metadata()).expect("it can be read").len())
        .sum();
    assert!((total * 1000.0 / bytes as f64 - 1.0).abs() < 0.01, "{total} {bytes}");
    assert!((0.5..2.0).contains(&(estimate / total)), "{estimate} {total}");
}

#[test]
fn frames_become_an_animation_where_the_name_of_a_file_is_given() {
    let folder = folder();
    let flags = "--frames 4 --from 1 --to 2.5 --samples 1";
    for out in ["ride", "ride.gif", "ride.png"] {
        render(folder.path(), &format!("{flags} --out {out}"));
    }
    let png = Png::read(&folder.path().join("ride.png"));
    assert!(png.texts["Parameters"].contains("--time=1 "), "{:?}", png.texts);
    assert_eq!(png.rgb, Png::read(&frame(folder.path(), 0)).rgb);
    let file = fs::File::open(folder.path().join("ride.gif")).expect("it is there");
    let mut gif = gif::DecodeOptions::new().read_info(file).expect("a GIF");
    let mut frames = 0;
    while let Some(frame) = gif.read_next_frame().expect("a whole GIF") {
        assert_eq!(frame.delay, 4);
        frames += 1;
    }
    assert_eq!(frames, 4);
    for (arguments, complaint) in [
        ("--out ride.gif", "--out ride.gif: an animation needs --frames"),
        (
            "--frames 2 --out ride.exr",
            "--out ride.exr: a sequence of measurements needs a folder, not a file",
        ),
        (
            "--frames 2 --exr --out ride.gif",
            "--exr: an animation shows pictures; measurements of every pixel need a folder",
        ),
    ] {
        let error = String::from_utf8(output(folder.path(), arguments).stderr).expect("it is text");
        assert_eq!(error, format!("gamow: {complaint}\n"));
    }
}

#[test]
fn a_frame_counts_only_if_it_is_whole() {
    let folder = folder();
    for (ending, flag) in [("png", ""), ("exr", "--exr")] {
        let flags = format!("--frames 2 --from 1 --to 2 --samples 1 --out {ending} {flag}");
        let said = || String::from_utf8(output(folder.path(), &flags).stderr).expect("it is text");
        let kept = |count: usize| format!("{} frames drawn and {count} kept", 2 - count);
        assert!(said().contains(&kept(0)));
        assert!(said().contains(&kept(2)));
        let path = folder.path().join(format!("{ending}/frame_00001.{ending}"));
        let whole = fs::read(&path).expect("it is there");
        let length = whole.len();
        for left in [0, length / 2, length * 9 / 10, length - 12, length - 1] {
            for end in [0, length - left] {
                let damaged = [&whole[..left], &vec![0; end]].concat();
                if damaged == whole {
                    continue;
                }
                fs::write(&path, damaged).expect("it is writable");
                let said = said();
                assert!(
                    said.contains(&kept(1)),
                    "{ending} of {length} bytes, {left} and {end} zeros: {said}"
                );
            }
        }
        assert!(said().contains(&kept(2)));
    }
}

#[test]
fn a_sequence_of_a_scene_with_any_name_is_read_again() {
    let folder = folder();
    let scene = "name = '車輪 の競走'\n[[object]]\nname = 'ボール'\nshape = 'sphere'\ncentre = [0.0, 3.0, 0.5]\n\
                 radius = 0.4\n";
    for (number, name) in
        ["車輪.toml", "自転車 と 'räder' \"x\".toml", "ゲ\u{301}モフ\u{3000}全角.toml"].iter().enumerate()
    {
        fs::write(folder.path().join(name), scene).expect("the folder is writable");
        for flag in ["", "--exr"] {
            let ride = format!("ride{number}{flag}");
            let said = || {
                let flags = format!("--frames 2 --from 1 --to 2 --samples 1 --out {ride} {flag}");
                let mut command = super::command_of_any_scene(folder.path(), &flags);
                let output = command.arg(format!("--scene={name}")).output().expect("the program starts");
                String::from_utf8(output.stderr).expect("it is text")
            };
            assert!(said().contains("2 frames drawn and 0 kept"), "{name} {flag}");
            assert!(said().contains("0 frames drawn and 2 kept"), "{name} {flag}");
            let ending = flag.strip_prefix("--").unwrap_or("png");
            let state = format!("--state {ride}/frame_00000.{ending} --out again.png --samples 1");
            assert!(
                super::command_of_any_scene(folder.path(), &state).status().expect("it starts").success()
            );
        }
        let measured = format!("measure ride{number}--exr --object ボール");
        let output = super::gamow_output(folder.path(), &measured);
        assert_eq!(String::from_utf8_lossy(&output.stdout).lines().count(), 3, "{output:?}");
    }
}
