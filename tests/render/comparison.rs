//! Two pictures of one eye beside each other: each is the one that there is without the other.

use std::fs;
use std::process::Command;

use super::{HEIGHT, Png, WIDTH, complaint, complaint_of, folder, picture, render};

/// The same gaze and field of view for both, so that each can be drawn by itself.
const LOOK: &str = "--time 1.5 --fov 70 --labels off";

#[test]
fn both_pictures_are_those_that_their_geometry_has_by_itself() {
    for first in ["seen", "contracted", "rest"] {
        let alone = picture(&format!("{LOOK} --layout left --geometry {first}"));
        for second in ["seen", "contracted", "rest"] {
            let other = picture(&format!("{LOOK} --layout left --geometry {second}"));
            assert_eq!(alone.rgb == other.rgb, first == second, "{first} {second}");
            if first == second {
                let flags = format!("--geometry {first} --compare {second}");
                let complaint = complaint(folder().path(), &flags);
                assert!(complaint.contains("both would be alike"), "{complaint}");
                continue;
            }
            let both = picture(&format!("{LOOK} --geometry {first} --compare {second}"));
            assert_eq!(both.size, [2 * WIDTH, HEIGHT]);
            for v in 0..HEIGHT {
                assert_eq!(both.row(v), [alone.row(v), other.row(v)].concat(), "{first} {second}");
            }
        }
    }
    let [seen, rest] = ["seen", "rest"].map(|of| picture(&format!("{LOOK} --layout left --geometry {of}")));
    let above = picture(&format!("{LOOK} --layout over-under --swapped over-under --compare rest"));
    for v in 0..HEIGHT {
        assert_eq!([above.row(v), above.row(HEIGHT + v)], [rest.row(v), seen.row(v)]);
    }
}

#[test]
fn both_brightnesses_have_one_exposure() {
    // Dice of white light: with all at one colour the exponent alone makes them bright or dark.
    let flags = "--scene train --time 8 --doppler-shift off --labels off --exposure -1.5";
    let alone = |exponent| picture(&format!("{flags} --layout left --intensity-exponent {exponent}"));
    let [fourth, second] = [alone("surface"), alone("paper")];
    assert!(fourth.rgb != second.rgb);
    let both = picture(&format!("{flags} --compare paper"));
    for v in 0..HEIGHT {
        assert_eq!(both.row(v), [fourth.row(v), second.row(v)].concat());
    }
    // An exposure that is found is that of the first.
    let found = picture("--scene train --time 8 --doppler-shift off --labels off --compare paper");
    let first = picture("--scene train --time 8 --doppler-shift off --labels off --layout left");
    let exposure = first.texts["Parameters"].split("--exposure=").nth(1).expect("it is recorded");
    let exposure = exposure.split_whitespace().next().expect("a number");
    let flags = "--scene train --time 8 --doppler-shift off --labels off --layout left";
    let second = picture(&format!("{flags} --intensity-exponent paper --exposure {exposure}"));
    for v in 0..HEIGHT {
        assert_eq!(found.row(v), [first.row(v), second.row(v)].concat());
    }
}

/// A gaze that follows does so in each, and both are as wide as the wider needs.
#[test]
fn each_follows_what_it_shows_at_one_scale() {
    let flags = "--time -2 --labels off";
    let both = picture(&format!("{flags} --compare contracted"));
    let fov = |geometry: &str| -> f64 {
        let alone = picture(&format!("{flags} --layout left --geometry {geometry}"));
        let told = alone.texts["Parameters"].split("--fov=").nth(1).expect("it is recorded").to_owned();
        told.split_whitespace().next().expect("a number").parse().expect("a number")
    };
    let [seen, contracted] = [fov("seen"), fov("contracted")];
    assert!(seen != contracted, "{seen}");
    let wide = seen.max(contracted);
    let parts = ["seen", "contracted"]
        .map(|geometry| picture(&format!("{flags} --layout left --geometry {geometry} --fov {wide}")));
    for v in 0..HEIGHT {
        assert_eq!(both.row(v), [parts[0].row(v), parts[1].row(v)].concat());
    }
}

#[test]
fn the_recorded_command_makes_it_again_and_words_stand_above() {
    let folder = folder();
    for compare in ["contracted", "rest", "paper"] {
        render(folder.path(), &format!("--time 0.5 --compare {compare} --out first.png"));
        let first = Png::read(&folder.path().join("first.png"));
        let parameters = &first.texts["Parameters"];
        assert!(parameters.contains(&format!("--compare={compare}")), "{parameters}");
        let mut again = Command::new(env!("CARGO_BIN_EXE_gamow"));
        let words = parameters.split_whitespace().skip(1).map(|word| word.replace('\'', ""));
        let again = again.current_dir(folder.path()).args(words).arg("--out=second.png").status();
        assert!(again.expect("the program starts").success(), "{parameters}");
        assert!(Png::read(&folder.path().join("second.png")).rgb == first.rgb, "{compare}");
        // Two different words stand above them, in letters of one colour.
        let strip = first.size[1] - HEIGHT;
        let half = 3 * WIDTH as usize;
        let above =
            |from: usize| (0..strip).map(|v| &first.row(v)[from..from + half]).collect::<Vec<_>>().concat();
        let right = 3 * first.size[0] as usize - half;
        assert!(above(0) != above(right), "{compare}");
        let inked = |from| above(from).chunks(3).any(|p| p[2] > p[0].saturating_add(60));
        assert!(inked(0) && inked(right), "{compare}");
    }
    // Without it nothing is recorded of it.
    assert!(!picture(LOOK).texts["Parameters"].contains("compare"));
}

#[test]
fn what_cannot_be_compared_is_told_in_one_line() {
    let folder = folder();
    for (flags, told) in [
        ("--compare rest --layout anaglyph", "side-by-side or over-under, not anaglyph"),
        ("--compare rest --layout cross-eyed", "side-by-side or over-under, not cross-eyed"),
        ("--compare rest --layout left", "side-by-side or over-under, not left"),
        ("--compare paper --colour glowing", "--colour one-wavelength"),
        ("--compare paper --geometry contracted", "--geometry seen"),
        ("--compare rest --projection vr180 --size 48x48", "headset"),
        ("--compare rest --out hits.exr", ".exr"),
    ] {
        let line = complaint(folder.path(), flags);
        assert!(line.contains(told), "{flags}: {line}");
    }
    assert!(fs::read_dir(folder.path()).expect("it is there").next().is_none(), "a file was left behind");
    render(folder.path(), "--compare rest --out picture.png");
    for command in [
        "rectify picture.png --beta 0.9 --out corrected.png",
        "measure picture.png --marker ff0000 --out rows.csv",
    ] {
        let line = complaint_of(folder.path(), command);
        assert!(line.contains("one eye twice"), "{command}: {line}");
    }
}

#[test]
fn a_state_file_has_it_like_any_setting() {
    let folder = folder();
    let state =
        "scene = 'cyclist'\ntime = 1.5\n[look]\ncompare = 'rest'\nfov = 70\n[picture]\nlabels = false\n";
    fs::write(folder.path().join("rest.toml"), state).expect("the folder is writable");
    render(folder.path(), "--state rest.toml --out picture.png");
    let by_flags = picture(&format!("{LOOK} --compare rest"));
    assert!(Png::read(&folder.path().join("picture.png")).rgb == by_flags.rgb);
    render(folder.path(), "--state rest.toml --compare off --out picture.png");
    assert!(Png::read(&folder.path().join("picture.png")).rgb == picture(LOOK).rgb);
}
