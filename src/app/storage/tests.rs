//! A start always succeeds, and says what it could not believe.

use std::path::Path;

use eframe::egui;

use super::*;
use crate::settings::Settings;

/// What is remembered after the file at `path` was looked through, as the windowing library reads it.
fn kept_in(path: &Path) -> Kept {
    std::fs::read_to_string(path)
        .map_or_else(|_| Kept::new(), |text| ron::from_str(&text).expect("it is read"))
}

/// A folder with a file that holds this.
fn with(kept: &[(&str, &str)]) -> (tempfile::TempDir, PathBuf) {
    let kept: Kept = kept.iter().map(|(key, text)| ((*key).to_owned(), (*text).to_owned())).collect();
    with_bytes(ron::to_string(&kept).expect("it is text").as_bytes())
}

fn with_bytes(bytes: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let path = folder.path().join(FILE);
    std::fs::write(&path, bytes).expect("it is writable");
    (folder, path)
}

const PLACED: &str = "(normal_geometry:(outer_position_pixels:Some((x:10.0,y:-20.0)),scale_factor:1.5,\
    inner_size_points:(x:1280.0,y:800.0)),fullscreen:false,maximized:false)";

#[test]
fn what_is_right_stays_as_it_is() {
    let toml = Settings::default().to_toml();
    let egui = toolkit::kept("()").0;
    let (folder, path) = with(&[
        ("settings", &toml),
        ("window", PLACED),
        (toolkit::KEY, &egui),
        ("recent", "/a.toml"),
        ("new", "x"),
    ]);
    let before = std::fs::read(&path).expect("it is there");
    let looked = look_through(&path);
    assert_eq!((looked.notice, looked.instead), (None, None));
    assert_eq!(std::fs::read(&path).expect("it is there"), before);
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 1);
    assert_eq!(look_through(&folder.path().join("none.ron")).notice, None);
}

#[test]
fn one_setting_is_lost_and_named_and_the_others_are_kept() {
    let toml = "[motion]\nd = nan\nbeta = 0.5\n[playback]\nrate = 1e300\n[fit]\nfit-samples = 18446744073709551615\n\
                seed = 7\n[later]\nx = 1";
    let (_folder, path) = with(&[("settings", toml), ("recent", "/a.toml")]);
    let before = std::fs::read(&path).expect("it is there");
    let looked = look_through(&path);
    let text = looked.notice.expect("it is told").text;
    for told in [
        "d = nan: not a finite number",
        "rate = 1e300: must be between 1e-3 and 1e6",
        "fit-samples = 18446744073709551615: must be a whole number between 2 and 5000",
        "unknown section [later]: there are motion",
        "app.ron.old1",
    ] {
        assert!(text.contains(told), "{told} in {text}");
    }
    assert_eq!(std::fs::read(path.with_extension("ron.old1")).expect("it is kept"), before);
    let kept = kept_in(&path);
    let expected =
        Settings::default().with_toml("[motion]\nbeta = 0.5\n[fit]\nseed = 7", "").expect("it is right");
    let read = Settings::default().with_toml(&kept["settings"], "").expect("it is right");
    assert_eq!((read, kept["recent"].as_str()), (expected, "/a.toml"));
    assert_eq!(look_through(&path).notice, None, "it is told once");
}

#[test]
fn settings_of_before_are_judged_alike() {
    for samples in ["18446744073709551615", "1e11", "-1", "NaN"] {
        let saved = format!("(motion:(separation:0.25),fit:(samples:{samples}),look:(fov_degrees:inf))");
        let (_folder, path) = with(&[("app", &saved)]);
        let text = look_through(&path).notice.expect("it is told").text;
        assert!(text.contains("fit-samples = ") && text.contains("fov = inf"), "{text}");
        let kept = kept_in(&path);
        let read = Settings::default().with_toml(&kept["settings"], "").expect("it is right");
        assert_eq!((read.motion.d, read.fit.fit_samples), (0.25, Settings::default().fit.fit_samples));
    }
}

#[test]
fn a_window_and_a_zoom_that_cannot_be_are_as_usual() {
    for (right, wrong) in [
        ("x:1280.0", "x:1e9"),
        ("x:1280.0", "x:NaN"),
        ("y:800.0", "y:-800.0"),
        ("x:10.0", "x:1e30"),
        ("y:-20.0", "y:inf"),
        ("scale_factor:1.5", "scale_factor:0.0"),
        ("scale_factor:1.5", "scale_factor:true"),
    ] {
        let (_folder, path) = with(&[("window", &PLACED.replace(right, wrong)), ("recent", "/a.toml")]);
        assert!(look_through(&path).notice.is_some(), "{wrong}");
        let kept = kept_in(&path);
        assert!(!kept.contains_key("window") && kept.contains_key("recent"), "{wrong}");
    }
    let (_folder, path) = with(&[("egui", "(options:(zoom_factor:0.0,max_passes:1000000000))")]);
    assert!(look_through(&path).notice.is_some_and(|notice| notice.text.contains("zoom_factor = 0")));
    let memory: egui::Memory = ron::from_str(&kept_in(&path)["egui"]).expect("the library reads it");
    assert_eq!((memory.options.zoom_factor, memory.options.max_passes.get()), (1.0, 2));
}

#[test]
fn a_file_that_cannot_be_read_is_kept_aside_whole() {
    let deep = "(".repeat(100_000);
    for bytes in [&b""[..], b"\xff\xfe\x00garbage", b"{\"settings\": 3}", b"[1, 2", deep.as_bytes()] {
        let (_folder, path) = with_bytes(bytes);
        assert!(look_through(&path).notice.is_some_and(|notice| notice.text.contains("app.ron.old1")));
        assert_eq!(std::fs::read(path.with_extension("ron.old1")).expect("it is kept"), bytes);
        assert!(!path.exists());
    }
    let (_folder, path) = with_bytes(b"");
    let file = std::fs::File::options().write(true).open(&path).expect("it is there");
    file.set_len(100 << 20).expect("it can be that long");
    assert!(look_through(&path).notice.is_some_and(|notice| notice.text.contains("104857600 bytes")));
    let (folder, path) = with_bytes(b"");
    std::fs::remove_file(&path).and_then(|()| std::fs::create_dir(&path)).expect("it is writable");
    assert!(look_through(&path).notice.is_some_and(|notice| notice.text.contains("it is no file")));
    assert!(folder.path().join("app.ron.old1").is_dir());
}

#[test]
fn many_old_files_are_kept_and_not_without_end() {
    let (folder, path) = with_bytes(b"");
    for number in 0..20 {
        std::fs::write(&path, format!("garbage {number}")).expect("it is writable");
        assert!(look_through(&path).notice.is_some());
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), MOST_ASIDE as usize);
    let first = std::fs::read_to_string(folder.path().join("app.ron.old1")).expect("it is kept");
    assert_eq!(first, "garbage 0");
}
