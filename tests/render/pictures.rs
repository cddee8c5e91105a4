//! PNG pictures: what they show, what they remember, and how long they take.

use std::fs;
use std::process::Command;

use super::{HEIGHT, Png, WIDTH, command_of_any_scene, folder, picture, render};

#[test]
#[cfg(unix)]
fn a_picture_holds_the_command_that_makes_it_again() {
    let folder = folder();
    fs::write(
        folder.path().join("it's mine.toml"),
        "name = 'Mine'\n[[object]]\nshape = 'sphere'\ncentre = [0.0, 3.0, 0.5]\nradius = 0.4\n",
    )
    .expect("the folder is writable");
    let flags = "--gamma 2.5 --d 0.3 --time 2.25 --fov 71.5 --gaze 100,-3.5 --layout anaglyph --colour false \
                 --intensity-exponent 3 --exposure -0.5 --shading emission --sky off --samples 2 --out first.png";
    let mut first = command_of_any_scene(folder.path(), flags);
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
fn the_overhead_preset_is_the_stereo_frame_of_the_paper() {
    let frame = picture("--state overhead --labels off");
    assert_eq!(frame.size, [2 * WIDTH, HEIGHT]);
    let parameters = &frame.texts["Parameters"];
    for part in [
        "--scene=cyclist",
        "--beta=0.9",
        "--d=0.1",
        // T at which the tracked point is seen at X = -R, R^2 = 13 + d^2/4: -R/0.9 + sqrt(2) R.
        "--time=1.09295",
        "--gaze=140.2",
        "--fov=84",
        "--intensity-exponent=2",
        "--layout=side-by-side",
    ] {
        assert!(parameters.contains(part), "{part} in {parameters}");
    }
}

#[test]
fn layouts_show_the_same_two_pictures() {
    let shown = |layout: &str| picture(&format!("--time 1.5 --labels off --layout {layout}"));
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
fn layouts_for_televisions_and_for_the_eyes_alone() {
    let folder = folder();
    let file = |layout: &str| {
        render(folder.path(), &format!("--time 1.5 --labels off --layout {layout} --out picture.png"));
        fs::read(folder.path().join("picture.png")).expect("it was written")
    };
    let shown = |layout: &str| {
        file(layout);
        Png::read(&folder.path().join("picture.png"))
    };
    let [left, right] = [shown("left"), shown("right")];
    let above = shown("over-under");
    let (rows, rows_swapped) = (shown("rows"), shown("rows --swapped rows"));
    for v in 0..HEIGHT {
        assert_eq!((above.row(v), above.row(HEIGHT + v)), (left.row(v), right.row(v)));
        let eyes = if v % 2 == 0 { [&left, &right] } else { [&right, &left] };
        assert_eq!([rows.row(v), rows_swapped.row(v)], eyes.map(|eye| eye.row(v)));
    }
    for layout in ["half-side-by-side", "half-over-under", "dubois"] {
        assert_eq!(shown(layout).size, [WIDTH, HEIGHT], "{layout}");
    }
    // An animated file opens as its first frame.
    let flicker = file("flicker");
    assert!(Png::read(&folder.path().join("picture.png")).rgb == left.rgb);
    let chunk = |file: &[u8], name: &[u8]| file.windows(4).position(|bytes| bytes == name);
    assert!(chunk(&flicker, b"acTL").is_some() && chunk(&flicker, b"fdAT").is_some());
    // Pixels per metre: the pictures are as wide as their middles are to be apart, 60 mm or 100.
    for (flags, expected) in [("", 800), ("--picture-distance 100", 480)] {
        let file = file(&format!("free-viewing {flags}"));
        let at = chunk(&file, b"pHYs").expect("it records its size") + 4;
        let per_metre =
            file[at..at + 8].chunks(4).map(|bytes| bytes.iter().fold(0, |n, b| 256 * n + u32::from(*b)));
        assert_eq!(per_metre.collect::<Vec<_>>(), [expected; 2]);
    }
    assert!(chunk(&file("side-by-side"), b"pHYs").is_none());
}

#[test]
fn labels_stand_outside_of_the_pictures_and_tell_them_apart() {
    let shown = |flags: &str| picture(&format!("--time 1.5 --layout {flags}"));
    let [left, right] = [shown("left"), shown("right")];
    for (layout, [first, second]) in [("side-by-side", [&left, &right]), ("cross-eyed", [&right, &left])] {
        let file = shown(layout);
        let [strip, bar] = [file.size[1] - HEIGHT, file.size[0] - 2 * WIDTH];
        assert!(strip >= 10 && bar >= 2, "{:?}", file.size);
        let (length, bar) = (3 * WIDTH as usize, 3 * bar as usize);
        for v in 0..HEIGHT {
            let row = file.row(strip + v);
            assert_eq!([&row[..length], &row[length + bar..]], [first.row(v), second.row(v)]);
        }
        // Blue for the left eye, orange for the right.
        let tint = |from: usize| -> i32 {
            let pixels = (0..strip).flat_map(|v| file.row(v)[from..from + length].chunks(3));
            pixels.map(|pixel| i32::from(pixel[2]) - i32::from(pixel[0])).sum()
        };
        let paper = 15 * i32::try_from(strip * WIDTH).expect("few"); // it is a little blue itself
        let is_blue = [0, length + bar].map(|from| tint(from) > paper);
        assert_eq!(is_blue, [layout == "side-by-side", layout != "side-by-side"]);
    }
    assert_eq!(shown("anaglyph").size, [WIDTH, HEIGHT]);
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
        "--light off",
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
