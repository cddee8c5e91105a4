//! `gamow render`, run as its users run it. The reference renderer throughout: it needs no graphics adapter.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use exr::prelude::{FlatSamples, read_first_flat_layer_from_file};
use gamow::scene::Scene;
use relativity_core::{Aperture, SourcePoint, Speed, sighting};
use relativity_render::{Camera, Gaze};
use tempfile::TempDir;

const WIDTH: u32 = 48;
const HEIGHT: u32 = 36;

fn folder() -> TempDir {
    tempfile::tempdir().expect("there is a place for temporary files")
}

/// `gamow render` with the words of `flags` in `folder`, small and by the reference renderer.
fn command(folder: &Path, flags: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    command.current_dir(folder).env_remove("RUST_LOG").arg("render").args(flags.split_whitespace());
    if !flags.contains("--size") {
        command.arg(format!("--size={WIDTH}x{HEIGHT}"));
    }
    if !flags.contains("--renderer") {
        command.arg("--renderer=reference");
    }
    command
}

fn output(folder: &Path, flags: &str) -> Output {
    command(folder, flags).output().expect("the program starts")
}

/// A run that must succeed; what it printed.
fn render(folder: &Path, flags: &str) -> String {
    let output = output(folder, flags);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{flags}: {stderr}");
    String::from_utf8(output.stdout).expect("it prints text")
}

/// The one line of a run that must fail.
fn complaint(folder: &Path, flags: &str) -> String {
    let output = output(folder, flags);
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{flags}: {stderr}");
    assert!(stderr.starts_with("gamow: ") && stderr.trim_end().lines().count() == 1, "{flags}: {stderr}");
    stderr
}

/// A PNG file: its size, its RGB bytes and its texts.
struct Png {
    size: [u32; 2],
    rgb: Vec<u8>,
    texts: BTreeMap<String, String>,
}

impl Png {
    fn read(path: &Path) -> Self {
        let file = File::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let mut reader = png::Decoder::new(BufReader::new(file)).read_info().expect("it is a PNG file");
        let mut rgb = vec![0; reader.output_buffer_size().expect("it fits into memory")];
        reader.next_frame(&mut rgb).expect("all pixels are there");
        reader.finish().expect("the file is whole");
        let info = reader.info();
        let text = |chunk: &png::text_metadata::ITXtChunk| {
            (chunk.keyword.clone(), chunk.get_text().expect("the text is there"))
        };
        Self { size: [info.width, info.height], rgb, texts: info.utf8_text.iter().map(text).collect() }
    }

    fn row(&self, v: u32) -> &[u8] {
        let length = 3 * self.size[0] as usize;
        &self.rgb[v as usize * length..][..length]
    }
}

/// The picture of a run with these flags.
fn picture(flags: &str) -> Png {
    let folder = folder();
    render(folder.path(), &format!("{flags} --out picture.png"));
    Png::read(&folder.path().join("picture.png"))
}

#[test]
#[cfg(unix)]
fn a_picture_holds_the_command_that_makes_it_again() {
    let folder = folder();
    fs::write(
        folder.path().join("it's mine.toml"),
        "name = 'Mine'\n[[object]]\nshape = 'sphere'\ncenter = [0.0, 3.0, 0.5]\nradius = 0.4\n",
    )
    .expect("the folder is writable");
    let flags = "--gamma 2.5 --d 0.3 --time 2.25 --fov 71.5 --gaze 100,-3.5 --layout anaglyph --colour false \
                 --intensity-exponent 3 --exposure -0.5 --shading emission --sky off --samples 2 --out first.png";
    let mut first = command(folder.path(), flags);
    assert!(first.args(["--scene", "it's mine.toml"]).status().expect("the program starts").success());
    let first = Png::read(&folder.path().join("first.png"));
    let parameters = &first.texts["Parameters"];
    assert_eq!(first.texts["Title"], "Mine");

    let script = parameters.replacen("gamow", env!("CARGO_BIN_EXE_gamow"), 1) + " --out second.png";
    let again = Command::new("sh").current_dir(folder.path()).args(["-c", &script]).status();
    assert!(again.expect("there is a shell").success(), "{script}");
    let second = Png::read(&folder.path().join("second.png"));
    assert_eq!(&second.texts["Parameters"], parameters);
    assert!(second.rgb == first.rgb, "the pictures differ");
    assert!(first.rgb.iter().any(|&part| part > 100), "the ball is in the picture");
}

#[test]
fn without_flags_it_is_the_stereo_frame_of_the_paper() {
    let frame = picture("");
    assert_eq!(frame.size, [2 * WIDTH, HEIGHT]);
    let parameters = &frame.texts["Parameters"];
    for part in
        ["--scene=cyclist", "--beta=0.9", "--d=0.1", "--time=3.6058", "--gaze=track", "--layout=side-by-side"]
    {
        assert!(parameters.contains(part), "{part} in {parameters}");
    }
}

#[test]
fn layouts_show_the_same_two_pictures() {
    let shown = |layout: &str| picture(&format!("--time 1.5 --layout {layout}"));
    let [left, right] = [shown("left"), shown("right")];
    assert!(left.rgb != right.rgb);
    let [parallel, crossed] = [shown("side-by-side"), shown("cross-eyed")];
    let [anaglyph, overlay] = [shown("anaglyph"), shown("overlay")];
    for v in 0..HEIGHT {
        assert_eq!(parallel.row(v), [left.row(v), right.row(v)].concat());
        assert_eq!(crossed.row(v), [right.row(v), left.row(v)].concat());
        for u in (0..3 * WIDTH as usize).step_by(3) {
            let largest = |eye: &Png| *eye.row(v)[u..u + 3].iter().max().expect("three");
            assert_eq!(anaglyph.row(v)[u..u + 3], [largest(&left), largest(&right), largest(&right)]);
        }
    }
    assert_eq!(overlay.size, [WIDTH, HEIGHT]);
    let blue_minus_red = |pixel: &[u8]| i32::from(pixel[2]) - i32::from(pixel[0]);
    let tints: Vec<_> = overlay.rgb.chunks(3).map(blue_minus_red).collect();
    assert!(tints.iter().any(|&tint| tint > 50) && tints.iter().any(|&tint| tint < -50), "blue and orange");
}

#[test]
fn effects_and_geometries_change_the_picture() {
    let plain = picture("--time 1.5");
    for flags in [
        "--colour false",
        "--doppler-shift off",
        "--intensity-exponent off",
        "--exposure -2",
        "--shading emission",
        "--sky off",
        "--light on",
        "--geometry contracted",
        "--geometry rest",
        "--gaze 90,10",
        "--fov 90",
        "--beta 0.5",
        "--d 0.6",
    ] {
        assert!(picture(&format!("--time 1.5 {flags}")).rgb != plain.rgb, "{flags}");
    }
    let street = "--time 1.5 --scene street --gaze 110,-20";
    assert!(picture(street).rgb != picture(&format!("{street} --ground off")).rgb);
}

/// The channels of an EXR file.
fn channels(path: &Path) -> BTreeMap<String, Vec<f32>> {
    let image = read_first_flat_layer_from_file(path).expect("it is an EXR file");
    let channels = image.layer_data.channel_data.list.into_iter();
    let values = |samples| match samples {
        FlatSamples::F32(values) => values,
        _ => panic!("a channel is not f32"),
    };
    channels.map(|channel| (channel.name.to_string(), values(channel.sample_data))).collect()
}

#[test]
fn measurements_agree_with_the_light_cone_of_each_point() {
    let folder = folder();
    render(folder.path(), "--time 2 --beta 0.9 --d 0.4 --fov 80 --gaze 120,30 --out hits.exr");
    let channels = channels(&folder.path().join("hits.exr"));
    assert_eq!(channels.len(), 18);
    let speed = Speed::from_beta(0.9).expect("below 1");
    let scene = Scene::preset("cyclist").expect("it is a preset");
    let [azimuth, elevation] = [120f64, 30.0].map(f64::to_radians);
    for (eye, aperture) in ["left", "right"].into_iter().zip(Aperture::pair(0.4)) {
        let channel = |name: &str| &channels[&format!("{eye}.{name}")];
        let camera = Camera {
            aperture,
            gaze: Gaze { azimuth, elevation },
            horizontal_fov: 80f64.to_radians(),
            size: [WIDTH, HEIGHT],
        };
        let mut seen = 0;
        for pixel in 0..channel("id").len() {
            let value = |name: &str| f64::from(channel(name)[pixel]);
            if value("id") < 0.0 {
                assert_eq!([value("distance"), value("intensity"), value("rest_x")], [0.0; 3]);
                continue;
            }
            seen += 1;
            let rest = [value("rest_x"), value("rest_y"), value("rest_z")];
            let source = SourcePoint::from_rest(rest, &speed);
            let expected = sighting(&speed, source, aperture, 2.0).expect("it is in the domain");
            let near = |name: &str, expected: f64| {
                let found = value(name);
                assert!(
                    (found - expected).abs() <= 2e-6 * expected.abs().max(1.0),
                    "{name}: {found}, {expected}"
                );
            };
            near("distance", expected.distance);
            near("emission_time", expected.retarded_time);
            near("doppler", expected.doppler_factor);
            near("intensity", expected.intensity(2.0));
            let rest_wavelength_nm = scene.bodies[value("id") as usize].rest_wavelength_nm;
            let wavelength_nm = rest_wavelength_nm / expected.doppler_factor;
            assert!((value("wavelength_nm") / wavelength_nm - 1.0).abs() < 2e-6);
            let [u, v] = camera.pixel(expected.position.into()).expect("it is in front");
            let [column, row] = [pixel % WIDTH as usize, pixel / WIDTH as usize];
            assert!((u - column as f64 - 0.5).abs() < 1e-3 && (v - row as f64 - 0.5).abs() < 1e-3);
        }
        assert!(seen > 50, "only {seen} pixels show a body");
    }
}

fn frame(folder: &Path, number: u32) -> std::path::PathBuf {
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
    assert_eq!(message, "3 frames drawn and 1 kept in ride\n");
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
            "name = 'Ball'\n[[object]]\nshape = 'sphere'\ncenter = [0.0, 3.0, 0.5]\nradius = {radius}\n"
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
    let mut child = command(folder.path(), "--frames 1000 --samples 1 --out ride")
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

#[test]
fn timings_name_every_stage() {
    let folder = folder();
    let table = render(folder.path(), "--timings --repeat 3 --samples 1 --out picture.png");
    for stage in ["set up", "left eye", "right eye", "layout", "file"] {
        let row = table
            .lines()
            .find(|line| line.starts_with(stage))
            .unwrap_or_else(|| panic!("{stage} in {table}"));
        let numbers: Vec<f64> =
            row[stage.len()..].split_whitespace().map(|n| n.parse().expect("a number")).collect();
        assert_eq!(numbers[0], if stage == "set up" { 1.0 } else { 3.0 });
        assert!(numbers[1] <= numbers[2] && numbers[2] <= numbers[3], "{row}");
    }
    assert!(table.starts_with("reference, f64"), "{table}");
}

#[test]
fn mistakes_are_told_in_one_line() {
    let folder = folder();
    for (flags, told) in [
        ("--out picture.jpg", ".png or .exr"),
        ("--out folder", "--frames"),
        ("--frames 2 --out picture.png", "folder"),
        ("--frames 2 --beta 0 --out ride", "--from and --to"),
        ("--geometry published", "mesh"),
        ("--scene cyclsit", "cyclsit"),
        ("--scene missing.toml", "missing.toml"),
        ("--beta 1", "beta = 1"),
        ("--d -1", "negative"),
        ("--out missing/picture.png", "missing/picture.png"),
        ("--time 1e70", "T = 1e70"),
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
        ("--fov 180", "between 0 and 180"),
        ("--gaze up", "90,0"),
        ("--gaze 0,90", "level"),
        ("--layout both", "side-by-side"),
        ("--exposure nan", "finite"),
        ("--samples 0", "1..=16"),
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
fn without_an_adapter_it_draws_by_reference_and_says_so() {
    let folder = folder();
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    let flags = ["render", "--size=48x36", "--samples=1", "--out=picture.png"];
    // There is no Direct3D 12 on this system.
    let output = command.current_dir(folder.path()).args(flags).env("WGPU_BACKEND", "dx12").output();
    let output = output.expect("the program starts");
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{stderr}");
    assert!(stderr.contains("reference renderer") && stderr.lines().count() == 1, "{stderr}");
    let parameters = &Png::read(&folder.path().join("picture.png")).texts["Parameters"];
    assert!(parameters.contains("--renderer=reference"), "{parameters}");

    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    let demanded = command.args(flags).arg("--renderer=exact").env("WGPU_BACKEND", "dx12").output();
    assert_eq!(demanded.expect("the program starts").status.code(), Some(2));
}
