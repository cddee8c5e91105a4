//! The whole chain: pictures of a passing ball, its disparities measured in them, and its speed and distance.

use std::path::Path;
use std::process::Command;

use gamow::files::png::{self, PngFile};
use relativity_render::colour::linear_srgb;
use relativity_render::picture::pixels::encoded;
use serde_json::Value;

use super::{complaint_of, folder, gamow_output, render, run_gamow};

/// A ball where the paper's tracked point is. (At small sizes a ball is easier to find than a spot on a
/// tyre.)
const BALL: &str = "\
name = \"A ball\"
[[object]]
name = \"Green\"
shape = \"sphere\"
centre = [0.0, 3.0, 2.0]
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
    // By its name in the scene, too.
    let by_number = run_gamow(folder.path(), "measure ride --object 0");
    assert_eq!(run_gamow(folder.path(), "measure ride --object green"), by_number);
    let complaint = complaint_of(folder.path(), "measure ride --object red");
    assert!(complaint.contains("A ball has no body called `red`: there are Green\n"), "{complaint}");
    let complaint = complaint_of(folder.path(), "measure ride --object 7");
    assert!(complaint.contains("A ball has no body called `7`: there are Green\n"), "{complaint}");
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

/// What eyes measure does not depend on how their pictures are made: from parallel ones, shifted or not, come
/// the disparities of the light cone, as from those across the gaze.
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

/// Of every disparity measured in `ride.csv`, the error over its sigma, squared: the mean of dphi and of
/// dtheta.
fn chi_squared_per_sample(csv: &str, rest: [f64; 3]) -> [f64; 2] {
    use relativity_core::{Aperture, SourcePoint, Speed, disparity};

    let speed = Speed::from_beta(0.9).expect("a speed");
    let source = SourcePoint::from_rest(rest, &speed);
    let [left, right] = Aperture::pair(0.1);
    let rows = rows(csv);
    let mut sums = [0.0; 2];
    for row in &rows {
        let seen = disparity(&speed, source, left, right, row[0]).expect("inside the domain");
        for (sum, (measured, exact, sigma)) in
            sums.iter_mut().zip([(row[6], seen.dphi, row[8]), (row[7], seen.dtheta, row[9])])
        {
            *sum += ((measured - exact) / sigma).powi(2);
        }
    }
    sums.map(|sum| sum / rows.len() as f64)
}

/// Both eyes have a point equally high, so that their errors of height are alike, and differences of
/// elevation better than their sigmas.
#[test]
fn errors_of_disparities_are_as_large_as_their_sigmas_say() {
    // In a conformal picture a ball has one outline in both eyes, in the same rows: errors cancel in part.
    for (projection, least) in [("gaze", 0.4), ("mercator", 0.0)] {
        errors_are_as_large_as_their_sigmas_say(projection, least);
    }
}

fn errors_are_as_large_as_their_sigmas_say(projection: &str, least: f64) {
    let folder = folder();
    let projection = format!("--projection {projection}");
    ride(folder.path(), &format!("{projection} --exr"));
    let of_body = run_gamow(folder.path(), "measure ride --object 0");
    std::fs::remove_dir_all(folder.path().join("ride")).expect("it is there");
    let plain = "--doppler-shift off --intensity-exponent off --shading emission --ground off --sky off";
    ride(folder.path(), &format!("{projection} {plain}"));
    let of_colour = run_gamow(folder.path(), &format!("measure ride --marker {}", green()));
    for csv in [of_body, of_colour] {
        let [dphi, dtheta] = chi_squared_per_sample(&csv, [0.0, 3.0, 2.0]);
        assert!((least..1.7).contains(&dphi) && dtheta < 1.7, "{dphi} {dtheta}");
    }
}

/// A tyre, whose side is seen well as it comes, and within a pixel of its outline as it goes.
const TYRE: &str = "\
name = \"A tyre\"
[[object]]
name = \"tyre\"
shape = \"ring\"
centre = [-0.525, 3.0, 2.0]
axis = [0.0, 1.0, 0.0]
radius = 0.493
tube_radius = 0.032
";

#[test]
fn a_mark_beside_an_outline_is_as_far_off_as_its_sigmas_say() {
    let folder = folder();
    std::fs::write(folder.path().join("tyre.toml"), TYRE).expect("the folder is there");
    let camera =
        "--scene tyre.toml --beta 0.9 --d 0.1 --size 320x240 --projection gaze --fov 12 --exr --frames 6";
    let gazes =
        [("coming", "--gaze 157,14.8 --from 0 --to 0.1"), ("going", "--gaze 64.4,31.3 --from 5.3 --to 5.5")];
    for (name, flags) in gazes {
        render(folder.path(), &format!("{camera} {flags} --out {name}"));
        let csv = run_gamow(folder.path(), &format!("measure {name} --point=-0.032,2.968,2"));
        assert!(rows(&csv).len() >= 3, "{name}: {csv}");
        let [dphi, dtheta] = chi_squared_per_sample(&csv, [-0.032, 2.968, 2.0]);
        assert!(dphi < 1.7 && dtheta < 1.7, "{name}: {dphi} {dtheta}");
    }
}

/// Errors of marks all over a ball that fills the picture, where single precision is all that there is.
#[test]
fn the_rounding_of_a_renderer_is_in_the_sigmas() {
    let folder = folder();
    std::fs::write(folder.path().join("ball.toml"), BALL).expect("the folder is there");
    for renderer in ["packets", "reference"] {
        let camera =
            format!("--scene ball.toml --beta 0.9 --d 0.1 --size 160x120 --fov 3 --renderer {renderer}");
        render(folder.path(), &format!("{camera} --gaze point --exr --frames 4 --from 2 --to 4 --out ride"));
        let (mut sums, marks) = ([0.0; 2], 12);
        for number in 0..marks {
            // Towards the eyes, on a spiral.
            let (turn, tilt) = (2.4 * f64::from(number), 0.05 * f64::from(number));
            let (sin, cos) = turn.sin_cos();
            let towards = [
                tilt.sin() * cos,
                -(0.83 * tilt.cos() - 0.55 * tilt.sin() * sin),
                -(0.55 * tilt.cos() + 0.83 * tilt.sin() * sin),
            ];
            let length = towards.iter().map(|part| part * part).sum::<f64>().sqrt();
            let mark = [0, 1, 2].map(|axis| [0.0, 3.0, 2.0][axis] + towards[axis] * 0.12 / length);
            let point = mark.map(|along| along.to_string()).join(",");
            let csv = run_gamow(folder.path(), &format!("measure ride --point={point}"));
            let each = chi_squared_per_sample(&csv, mark);
            sums = [sums[0] + each[0], sums[1] + each[1]];
        }
        let means = sums.map(|sum| sum / f64::from(marks));
        assert!(means.iter().all(|mean| (0.01..1.7).contains(mean)), "{renderer}: {means:?}");
        std::fs::remove_dir_all(folder.path().join("ride")).expect("it is there");
    }
}

/// The file at `path` as another program leaves it: without texts.
fn forget(path: &Path) {
    let picture = PngFile::read(path).expect("it was rendered").picture().clone();
    png::write(&picture, &[], std::fs::File::create(path).expect("it is there")).expect("it is written");
}

/// As a photographer has them: no texts, no letters, cameras that keep their direction.
const PHOTOGRAPHS: &str = "--beta 0.9 --d 0.1 --size 160x120 --gaze 90,33 --fov 80 --projection gaze --labels off \
     --doppler-shift off --intensity-exponent off --shading emission --ground off --sky off";

#[test]
fn photographs_that_record_nothing_are_measured_by_flags() {
    let folder = folder();
    std::fs::write(folder.path().join("ball.toml"), BALL).expect("the folder is there");
    let frames = "--scene ball.toml --frames 5 --from 3 --to 5 --out photos";
    render(folder.path(), &format!("{PHOTOGRAPHS} {frames}"));
    let measure = format!("measure photos --marker {}", green());
    let recorded = run_gamow(folder.path(), &measure);
    for photo in std::fs::read_dir(folder.path().join("photos")).expect("it is there") {
        forget(&photo.expect("it is there").path());
    }
    let complaint = complaint_of(folder.path(), &measure);
    assert!(
        complaint.ends_with(
            "frame_00000.png: it does not record --layout, --gaze, --fov, --time, --d, which must then be given\n"
        ),
        "{complaint}"
    );
    let flags = "--gaze 90,33 --fov 80 --layout side-by-side --d 0.1";
    let complaint = complaint_of(folder.path(), &format!("{measure} {flags}"));
    assert!(complaint.contains("it does not record --time, which"), "{complaint}");
    let complaint = complaint_of(folder.path(), &format!("{measure} {flags} --times 1,2,3"));
    assert!(
        complaint.contains("--times: 3 for 5 files: give one for each, or the first and the last"),
        "{complaint}"
    );
    for times in ["3,5", "3,3.5,4,4.5,5"] {
        assert_eq!(run_gamow(folder.path(), &format!("{measure} {flags} --times {times}")), recorded);
    }
    // What is known by flags can be said of a file that records something else, too.
    let csv = run_gamow(folder.path(), &format!("{measure} {flags} --times 3,5 --roll 10"));
    assert!(csv.starts_with("T,d,roll,turn,"), "{csv}");
    assert!(csv.lines().skip(1).all(|row| row.split(',').nth(2) == Some("10")), "{csv}");
}

/// Other programs keep the texts of a picture in chunks of their own.
#[test]
fn ordinary_text_chunks_are_read() {
    let folder = folder();
    std::fs::write(folder.path().join("ball.toml"), BALL).expect("the folder is there");
    render(folder.path(), &format!("{PHOTOGRAPHS} --scene ball.toml --time 4 --out ball.png"));
    let measure = format!("measure ball.png --marker {}", green());
    let recorded = run_gamow(folder.path(), &measure);
    let path = folder.path().join("ball.png");
    let file = PngFile::read(&path).expect("it was rendered");
    let picture = file.picture();
    for is_compressed in [false, true] {
        let out = std::fs::File::create(&path).expect("it is there");
        let mut encoder = ::png::Encoder::new(out, picture.size[0], picture.size[1]);
        encoder.set_color(::png::ColorType::Rgba);
        let (keyword, text) = ("Parameters".to_owned(), file.command().to_owned());
        let added = if is_compressed {
            encoder.add_ztxt_chunk(keyword, text)
        } else {
            encoder.add_text_chunk(keyword, text)
        };
        added.expect("it is plain text");
        let mut writer = encoder.write_header().expect("it is written");
        writer.write_image_data(picture.rgba.as_flattened()).expect("it is written");
        writer.finish().expect("it is written");
        assert_eq!(run_gamow(folder.path(), &measure), recorded);
    }
}

/// A colour that is not one point is remarked on in one line that names file and eye, and measured all the
/// same.
#[test]
fn a_colour_that_is_not_one_point_is_remarked_on() {
    let folder = folder();
    let second = BALL
        .replace("name = \"A ball\"", "")
        .replace("Green", "Other")
        .replace("[0.0, 3.0, 2.0]", "[0.9, 3.0, 2.0]");
    std::fs::write(folder.path().join("two.toml"), format!("{BALL}{second}")).expect("the folder is there");
    std::fs::write(folder.path().join("ball.toml"), BALL).expect("the folder is there");
    let remark = |flags: &str| {
        let output = gamow_output(folder.path(), &format!("measure {flags} --marker {}", green()));
        assert!(output.status.success());
        String::from_utf8(output.stderr).expect("it is text")
    };
    render(folder.path(), &format!("{PHOTOGRAPHS} --scene ball.toml --frames 3 --from 3 --to 5 --out one"));
    assert_eq!(remark("one"), "");
    render(folder.path(), &format!("{PHOTOGRAPHS} --scene two.toml --frames 3 --from 3 --to 5 --out two"));
    let line = remark("two");
    let expected = "two/frame_00000.png: in the left eye's picture the colour is in 2 separate places; the middle of all is measured (so";
    assert!(line.starts_with(expected) && line.lines().count() == 1, "{line}");
    // The eyes the wrong way round.
    let line = remark("one/frame_00001.png --layout cross-eyed");
    assert!(
        line.starts_with("one/frame_00001.png: the colour is in places that cannot be one point"),
        "{line}"
    );
    assert!(line.contains("the eyes may be swapped") && line.lines().count() == 1, "{line}");
    // One camera looks higher than it is said to: as pictures of one that is held askew.
    let path = folder.path().join("one/frame_00001.png");
    let file = PngFile::read(&path).expect("it was rendered");
    let mut askew = file.picture().clone();
    let width = askew.size[0] as usize;
    for row in (8..askew.size[1] as usize).rev() {
        let [from, to] = [row - 8, row].map(|row| row * width + width / 2..(row + 1) * width);
        askew.rgba.copy_within(from, to.start);
    }
    let texts: Vec<_> = file.texts.iter().map(|(keyword, text)| (keyword.as_str(), text.as_str())).collect();
    png::write(&askew, &texts, std::fs::File::create(&path).expect("it is there")).expect("it is written");
    let line = remark("one/frame_00001.png");
    assert!(line.contains("the lines of sight of the two eyes miss each other by"), "{line}");
    assert_eq!(line.lines().count(), 1, "{line}");
}

/// A mark on the near side of a rolling wheel's tyre: followed round in measurements, which say what a fit
/// has to know of it.
#[test]
fn a_mark_on_a_rolling_wheel_gives_the_speed_and_where_its_hub_passes() {
    let wheel = "name = \"A wheel\"\ntracked = [0.0, 3.0, 2.0]\n\n[[wheel]]\nhub = [0.0, 3.0, 2.0]\nradius = 0.525\ntyre = 0.1\n\
        rim = 0.02\naxle = 0.2\nhub_radius = 0.05\nspokes = 3\nspoke_radius = 0.02\nrolls = true\nlight = \"white\"\n";
    let folder = folder();
    std::fs::write(folder.path().join("wheel.toml"), wheel).expect("the folder is there");
    let camera = "--beta 0.8 --d 0.1 --size 320x240 --gaze point --fov 45";
    render(folder.path(), &format!("--scene wheel.toml --frames 40 {camera} --exr --out ride"));
    // The middle of the tyre's tube is 0.425 from the hub.
    let (sine, cosine) = 0.7_f64.sin_cos();
    let point = format!("{},2.9,{}", 0.425 * cosine, 2.0 + 0.425 * sine);
    let output = gamow_output(folder.path(), &format!("measure ride --point={point} --out ride.csv"));
    let said = String::from_utf8(output.stderr).expect("it says words");
    assert!(output.status.success(), "{said}");
    let (_, advice) = said.split_once("fit it by `gamow fit ").expect("it is said");
    let (flags, _) = advice.split_once('`').expect("it ends");
    assert!(flags.starts_with("--wheel-radius 0.525 --rho 0.80952"), "{flags}");
    let report: Value =
        serde_json::from_str(&run_gamow(folder.path(), &format!("fit ride.csv {flags} --json")))
            .expect("the report is JSON");
    for (name, truth, largest) in [("beta", 0.8, 0.003), ("y", 2.9, 0.02), ("z", 2.0, 0.02)] {
        let parameter = &report["parameters"][name];
        let [value, error] = ["value", "uncertainty"].map(|key| parameter[key].as_f64().expect("a number"));
        assert!((value - truth).abs() <= 3.5 * error, "{name} = {value} +- {error}");
        assert!(error < largest, "{name} = {value} +- {error}");
    }
    // A whole spoke has no one place on the wheel; the hub turns, and is where it is.
    let of_body = |name: &str| {
        let arguments = ["measure", "ride", "--object", name];
        let run =
            Command::new(env!("CARGO_BIN_EXE_gamow")).current_dir(folder.path()).args(arguments).output();
        String::from_utf8(run.expect("the program starts").stderr).expect("it says words")
    };
    assert!(of_body("3").contains("follow a --point of it"));
    assert!(!of_body("hub").contains("turns with a wheel"));
}

#[test]
fn a_body_that_another_or_the_end_of_the_picture_hides_in_part_is_remarked() {
    let folder = folder();
    let ball = "name = \"Half\"\n[[object]]\nname = \"ball\"\nshape = \"sphere\"\ncentre = [0, 4, 0]\nradius = 0.5\n";
    let post = "[[object]]\nname = \"post\"\nshape = \"box\"\ncentre = [0.15, 2, 0]\nsize = [0.3, 0.1, 2]\n";
    std::fs::write(folder.path().join("free.toml"), ball).expect("it is written");
    std::fs::write(folder.path().join("hidden.toml"), format!("{ball}{post}")).expect("it is written");
    let said = |scene: &str, gaze: &str| {
        let camera = format!("--beta 0 --time 0 --size 160x120 --fov 40 --gaze={gaze},0");
        render(folder.path(), &format!("--scene {scene}.toml {camera} --exr --out {scene}.exr"));
        let output = gamow_output(folder.path(), &format!("measure {scene}.exr --object ball"));
        String::from_utf8(output.stderr).expect("it says words")
    };
    let remark = "hide a part of the body";
    assert!(!said("free", "90").contains(remark));
    assert!(said("hidden", "90").contains(remark));
    assert!(said("free", "110").contains(remark));
}
