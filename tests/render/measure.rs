//! The whole chain: pictures of a passing ball, its disparities measured in them, and its speed and distance.

use std::path::Path;

use relativity_render::colour::linear_srgb;
use relativity_render::picture::encoded;
use serde_json::Value;

use super::{complaint_of, folder, render, run_gamow};

/// A ball where the paper's tracked point is. (At small sizes a ball is easier to find than a spot on a tyre.)
const BALL: &str = "\
name = \"A ball\"
[[object]]
shape = \"sphere\"
center = [0.0, 3.0, 2.0]
radius = 0.12
wavelength_nm = 550
";
/// The colour of the ball's light, 550 nm, as it is typed.
fn green() -> String {
    let [r, g, b, _] = encoded(linear_srgb(550.0));
    format!("{r:02x}{g:02x}{b:02x}")
}

/// A sequence of the ball in `ride`, by the paper's numbers, small.
fn ride(folder: &Path, flags: &str) {
    std::fs::write(folder.join("ball.toml"), BALL).expect("the folder is there");
    let camera = "--beta 0.9 --d 0.1 --size 160x120 --gaze point --fov 50";
    render(folder, &format!("--scene ball.toml --frames 30 {camera} {flags} --out ride"));
}

/// Speed and distance from `ride.csv` are the true ones within three standard errors, and these are small.
fn assert_recovers(folder: &Path) {
    let report: Value =
        serde_json::from_str(&run_gamow(folder, "fit ride.csv --json")).expect("the report is JSON");
    // The paper's uncertainties are 0.01, 0.05 and 0.08; these pictures are far smaller than a camera's.
    for (name, truth, largest) in [("beta", 0.9, 0.015), ("y", 3.0, 0.1), ("z", 2.0, 0.08)] {
        let parameter = &report["parameters"][name];
        let [value, error] = ["value", "uncertainty"].map(|key| parameter[key].as_f64().expect("a number"));
        assert!((value - truth).abs() <= 3.0 * error, "{name} = {value} +- {error}");
        assert!(error < largest, "{name} = {value} +- {error}");
    }
}

#[test]
fn measurements_of_a_body_give_its_speed_and_distance() {
    let folder = folder();
    ride(folder.path(), "--exr");
    run_gamow(folder.path(), "measure ride --object 0 --out ride.csv");
    assert_recovers(folder.path());
    assert!(
        complaint_of(folder.path(), "measure ride --object 7").contains("none of 30 files shows the target")
    );
    assert!(complaint_of(folder.path(), "measure ride --marker ff0000").contains("there is no .png file"));
}

#[test]
fn a_marker_in_pictures_gives_its_speed_and_distance() {
    let folder = folder();
    let plain = "--doppler-shift off --intensity-exponent off --shading emission --ground off --sky off";
    ride(folder.path(), plain);
    let measured = || {
        run_gamow(folder.path(), &format!("measure ride --marker {} --out ride.csv", green()));
        std::fs::read_to_string(folder.path().join("ride.csv")).expect("it was written")
    };
    let labelled = measured();
    assert_recovers(folder.path());
    // The letters and the bar are not in the pictures: the same is measured without them.
    std::fs::remove_dir_all(folder.path().join("ride")).expect("it is there");
    ride(folder.path(), &format!("{plain} --labels off"));
    assert_eq!(measured(), labelled);
}

/// What loses nothing is measured to the last digit as side by side; what does is refused in a line.
#[test]
fn every_layout_that_loses_nothing_measures_the_same() {
    let folder = folder();
    let measure = format!("measure ride --marker {} --out ride.csv", green());
    let ride_in = |layout: &str| {
        let plain = "--doppler-shift off --intensity-exponent off --shading emission --ground off --sky off";
        if folder.path().join("ride").exists() {
            std::fs::remove_dir_all(folder.path().join("ride")).expect("it is there");
        }
        ride(folder.path(), &format!("{plain} {layout}"));
    };
    let measured = |layout: &str| {
        ride_in(layout);
        run_gamow(folder.path(), &measure);
        std::fs::read_to_string(folder.path().join("ride.csv")).expect("it was written")
    };
    let beside = measured("");
    for layout in [
        "--layout free-viewing",
        "--layout cross-eyed",
        "--layout over-under",
        "--layout flicker",
        "--layout flicker --swapped flicker",
        "--layout over-under --swapped over-under --labels off",
    ] {
        assert_eq!(measured(layout), beside, "{layout}");
    }
    for layout in ["left", "dubois", "half-over-under"] {
        ride_in(&format!("--layout {layout}"));
        let complaint = complaint_of(folder.path(), &measure);
        let expected = format!("its layout, {layout}, does not have the whole pictures of both eyes");
        assert!(complaint.contains(&expected) && complaint.lines().count() == 1, "{complaint}");
    }
}

#[test]
fn the_letters_of_a_picture_are_no_marker() {
    let folder = folder();
    ride(folder.path(), "--doppler-shift off --shading emission --layout side-by-side");
    // The colour of the letter L.
    let complaint = complaint_of(folder.path(), "measure ride --marker 56b4e9");
    assert!(complaint.contains("none of 30 files shows the target"), "{complaint}");
}

/// What eyes measure does not depend on how their pictures are made: from parallel ones, shifted or not, come the
/// disparities of the light cone, as from those across the gaze.
#[test]
fn every_projection_measures_the_same_disparities() {
    use relativity_core::{Aperture, SourcePoint, Speed, disparity};

    let speed = Speed::from_beta(0.9).expect("a speed");
    let source = SourcePoint::from_rest([0.0, 3.0, 2.0], &speed);
    let [left, right] = Aperture::pair(0.1);
    for flags in ["--projection gaze", "--projection parallel", "--projection parallel --zero-parallax 1.5"] {
        let folder = folder();
        ride(folder.path(), &format!("--exr {flags}"));
        let text = run_gamow(folder.path(), "measure ride --object 0");
        let rows = rows(&text);
        assert!(rows.len() > 25, "{flags}: {} rows", rows.len());
        for row in rows {
            let seen = disparity(&speed, source, left, right, row[0]).expect("inside the domain");
            // The middle of a ball, of some pixels, that is drawn out by its motion.
            let pixel = 50.0_f64.to_radians() / 160.0;
            for (measured, exact) in [(row[6], seen.dphi), (row[7], seen.dtheta)] {
                assert!((measured - exact).abs() < pixel, "{flags}, T {}: {measured} is not {exact}", row[0]);
            }
        }
    }
}

fn rows(csv: &str) -> Vec<Vec<f64>> {
    let cells = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    csv.lines().skip(1).map(cells).collect()
}

/// The angles of a mark on the surface are those of the light cone, to a fraction of a pixel.
#[test]
fn a_mark_on_a_surface_is_found_to_a_fraction_of_a_pixel() {
    for flags in ["--projection gaze", "--projection parallel"] {
        assert_finds_a_mark(flags);
    }
}

fn assert_finds_a_mark(flags: &str) {
    use relativity_core::{Aperture, SourcePoint, Speed, disparity};

    let folder = folder();
    let mark = [-0.2, 2.6, 2.2];
    let camera = format!("--scene two-balls --beta 0.7 --d 0.4 --size 200x150 --fov 60 {flags}");
    for time in ["2.2", "3.1", "4.0"] {
        render(folder.path(), &format!("{camera} --time {time} --out {time}.exr"));
    }
    // On the ball's surface, towards the eyes.
    let direction = [mark[0], mark[1] - 3.0, mark[2] - 2.0];
    let scale = 0.5 / direction.iter().map(|part| part * part).sum::<f64>().sqrt();
    let point = [scale * direction[0], 3.0 + scale * direction[1], 2.0 + scale * direction[2]];
    let words = format!("measure 2.2.exr 3.1.exr 4.0.exr --point={},{},{}", point[0], point[1], point[2]);
    let text = run_gamow(folder.path(), &words);
    let rows = rows(&text);
    assert_eq!(rows.len(), 3, "{text}");
    let speed = Speed::from_beta(0.7).expect("a speed");
    let [left, right] = Aperture::pair(0.4);
    for row in rows {
        let source = SourcePoint::from_rest(point, &speed);
        let seen = disparity(&speed, source, left, right, row[0]).expect("inside the domain");
        let pixel = 60.0_f64.to_radians() / 200.0;
        for (measured, exact) in [(row[6], seen.dphi), (row[7], seen.dtheta), (row[2], seen.primary.phi())] {
            assert!((measured - exact).abs() < 0.15 * pixel, "{measured} is not {exact}");
        }
    }
}
