//! `gamow rectify` of rendered frames, against frames rendered at rest from the same event.

use std::path::Path;

use gamow::files::exr::{Channel, Measurements};
use gamow::files::png::PngFile;
use gamow::settings::Settings;
use relativity_render::picture::rectify::Rectification;
use relativity_render::{Picture, Velocity};

use super::{complaint_of, folder, render, run_gamow};

/// Speeds and times: approaching, abreast and receding.
const CASES: [(f64, f64); 4] = [(0.9, 0.6), (0.9, 2.0), (0.6, 3.0), (0.9, 6.0)];

/// Solid bodies: the spokes of a wheel are thinner than a pixel, and a ray per pixel hits them at random.
const SCENE: &str = "--scene two-balls";

/// The corrected left eye's frame, and the frame of a camera at rest in the bodies' frame.
fn corrected_and_true(
    folder: &Path,
    scene: &str,
    beta: f64,
    time: f64,
    extension: &str,
    projection: &str,
) -> [std::path::PathBuf; 2] {
    // One exposure for both, since each picture would find its own; and the paper's intensity, of which a
    // picture in bytes holds all.
    let size = "--size 320x240 --fov 60 --ground off --sky off --shading emission --exposure 0 --intensity-exponent 2";
    let layout = if extension == "png" { "--layout left" } else { "" };
    let seen = format!("{scene} --beta {beta} --time {time} {size} {layout} --projection {projection}");
    render(folder, &format!("{seen} --out seen.{extension}"));
    run_gamow(folder, &format!("rectify seen.{extension} --beta {beta} --out corrected.{extension}"));
    let corrected = folder.join(format!("corrected.{extension}"));
    let command = match extension {
        "png" => PngFile::read(&corrected).expect("it was written").command().to_owned(),
        _ => measurements(&corrected).command(),
    };
    let value = |flag| command.split_whitespace().find_map(|word| word.strip_prefix(flag));
    let [fov, gaze] = ["--out-fov=", "--out-gaze="].map(|flag| value(flag).expect("it is recorded"));
    // What two screens show is corrected to what a camera does.
    let projection = if projection == "mercator" { projection } else { "gaze" };
    let size = size.replace("--fov 60", &format!("--fov {fov} --gaze {gaze}"));
    render(
        folder,
        &format!(
            "{scene} --beta {beta} --time {time} {size} {layout} --projection {projection} --zero-parallax infinity --geometry rest --out true.{extension}"
        ),
    );
    [corrected, folder.join(format!("true.{extension}"))]
}

fn measurements(path: &Path) -> Measurements {
    Measurements::read(path).expect("it was written")
}

/// The left eye's values of a channel.
fn channel(file: &Measurements, channel: Channel) -> &[f32] {
    file.channel("left", channel).expect("it is there")
}

/// The cameras behind a picture and its correction.
fn rectification(seen: &Measurements, truth: &Measurements, beta: f64) -> Rectification {
    let camera = |file: &Measurements| {
        let settings = Settings::of_picture(&file.command(), "it").expect("it was rendered");
        settings.recorded_cameras(file.size).expect("they are recorded")[0]
    };
    Rectification::new(camera(seen), camera(truth), Velocity::from_beta(beta).expect("a speed"))
}

/// Whether a pixel within one pixel of (column, row) fulfils `is`.
fn is_near([column, row]: [usize; 2], [width, height]: [usize; 2], is: impl Fn(usize) -> bool) -> bool {
    let around = |at: usize, side: usize| at.saturating_sub(1)..(at + 2).min(side);
    around(row, height).any(|v| around(column, width).any(|u| is(v * width + u)))
}

/// Pixels at which outlines of the bodies differ by more than a pixel, and all pixels of bodies, where
/// the picture from the ground `shows` something.
fn misplaced(
    corrected: &Measurements,
    truth: &Measurements,
    shows: impl Fn([usize; 2]) -> bool,
) -> [usize; 2] {
    let size = truth.size.map(|side| side as usize);
    let [corrected, truth] = [corrected, truth].map(|file| channel(file, Channel::Id));
    let mut counts = [0, 0];
    for pixel in 0..truth.len() {
        let at = [pixel % size[0], pixel / size[0]];
        if !shows(at) {
            continue;
        }
        let has_counterpart = |id: &[f32], other: &[f32]| is_near(at, size, |near| other[near] == id[pixel]);
        counts[0] += usize::from(!has_counterpart(corrected, truth) || !has_counterpart(truth, corrected));
        counts[1] += usize::from(truth[pixel] >= 0.0);
    }
    counts
}

#[test]
fn outlines_and_wavelengths_are_those_of_a_camera_riding_along() {
    for ((beta, time), projection) in
        CASES.into_iter().flat_map(|case| ["parallel", "mercator"].map(|of| (case, of)))
    {
        let folder = folder();
        let [corrected, truth] = corrected_and_true(folder.path(), SCENE, beta, time, "exr", projection)
            .map(|path| measurements(&path));
        let seen = measurements(&folder.path().join("seen.exr"));
        let rectification = rectification(&seen, &truth, beta);
        let shows = |[column, row]: [usize; 2]| {
            let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
            corners.iter().all(|[u, v]| {
                rectification
                    .ground_place([column as f64 + 2.0 * u - 0.5, row as f64 + 2.0 * v - 0.5])
                    .is_some()
            })
        };
        let [wrong, covered] = misplaced(&corrected, &truth, shows);
        assert!(covered > 500, "{covered} pixels show the balls");
        assert!(wrong * 1000 <= covered, "{wrong} of {covered} at beta {beta}, T {time}");
        let compared = assert_wavelengths(&corrected, &truth);
        assert!(compared > covered / 2, "{compared} of {covered}");
    }
}

/// Compares received wavelengths wherever one body fills the surroundings; at how many pixels.
fn assert_wavelengths(corrected: &Measurements, truth: &Measurements) -> usize {
    let size = truth.size.map(|side| side as usize);
    let channels = |of| [corrected, truth].map(|file| channel(file, of));
    let (ids, wavelengths) = (channels(Channel::Id), channels(Channel::WavelengthNm));
    let is_inside = |&pixel: &usize| {
        let id = ids[1][pixel];
        let at = [pixel % size[0], pixel / size[0]];
        id >= 0.0 && ids.iter().all(|ids| !is_near(at, size, |near| ids[near] != id))
    };
    let inside: Vec<usize> = (0..ids[0].len()).filter(is_inside).collect();
    for &pixel in &inside {
        let error = (wavelengths[0][pixel] - wavelengths[1][pixel]).abs();
        assert!(error < 0.5, "{error} nm at pixel {pixel}");
    }
    inside.len()
}

#[test]
fn a_picture_becomes_evenly_red() {
    let folder = folder();
    let [corrected, truth] = corrected_and_true(folder.path(), "", 0.6, 1.2, "png", "parallel")
        .map(|path| PngFile::read(&path).expect("it was written").picture().clone());
    let is_red = |[r, g, b, _]: [u8; 4]| r > 150 && g < 60 && b < 160 && r > b;
    let count = |picture: &Picture| picture.rgba.iter().filter(|&&pixel| is_red(pixel)).count();
    let (corrected, truth) = (count(&corrected), count(&truth));
    assert!(corrected * 10 > truth * 8 && corrected * 10 < truth * 12, "{corrected} of {truth}");
}

/// The picture of an eye is the same in every layout that loses nothing, and so is what is made of it.
#[test]
fn every_layout_that_loses_nothing_is_corrected() {
    let folder = folder();
    let corrected = |layout: &str, eye: &str| {
        render(folder.path(), &format!("--time 1.2 {layout} --out seen.png"));
        run_gamow(folder.path(), &format!("rectify seen.png --beta 0.9 {eye} --out corrected.png"));
        PngFile::read(&folder.path().join("corrected.png")).expect("it was written").frames
    };
    let [left, right] = ["left", "right"].map(|eye| corrected(&format!("--layout {eye}"), ""));
    assert!(left != right);
    for layout in ["side-by-side", "free-viewing", "cross-eyed", "over-under", "flicker"] {
        for swapped in ["", "--swapped side-by-side,free-viewing,cross-eyed,over-under,flicker"] {
            let layout = format!("--layout {layout} {swapped}");
            assert!(corrected(&layout, "") == left, "{layout}");
            assert!(corrected(&layout, "--eye right") == right, "{layout}");
        }
    }
}

#[test]
fn what_is_missing_is_named() {
    let folder = folder();
    render(folder.path(), "--out both.png");
    let run = |arguments: &str| complaint_of(folder.path(), &format!("rectify {arguments}"));
    render(folder.path(), "--layout rows --out rows.png");
    let rows = run("rows.png --beta 0.9 --out x.png");
    assert!(rows.contains("its layout, rows, has the whole picture of neither"), "{rows}");
    assert!(run("both.png --beta 0.9 --out x.exr").contains("it should be of the same kind"));
    assert!(run("none.png --beta 0.9 --out x.png").contains("none.png"));
    render(folder.path(), "--layout left --out left.png");
    assert!(run("left.png --beta 0.9 --eye right --out x.png").contains("the picture shows one eye"));
    assert!(run("left.png --out x.png").contains("one of --beta, --gamma, --rapidity is needed"));
}

/// A photograph of both eyes, of which flags say what it does not record.
#[test]
fn a_photograph_is_corrected_by_flags() {
    let folder = folder();
    let camera = "--fov 100 --gaze 120,25 --projection gaze";
    render(folder.path(), &format!("--time 1.2 {camera} --labels off --out seen.png"));
    let correct = |flags: &str| {
        run_gamow(
            folder.path(),
            &format!("rectify seen.png --beta 0.9 --intensity-exponent 4 {flags} --out corrected.png"),
        );
        PngFile::read(&folder.path().join("corrected.png")).expect("it was written").frames
    };
    let recorded = ["left", "right"].map(|eye| correct(&format!("--eye {eye}")));
    let seen = folder.path().join("seen.png");
    let picture = PngFile::read(&seen).expect("it was rendered").picture().clone();
    let out = std::fs::File::create(&seen).expect("it is there");
    gamow::files::png::write(&picture, &[], out).expect("it is written");
    let complaint = complaint_of(folder.path(), "rectify seen.png --beta 0.9 --fov 70 --out x.png");
    assert_eq!(complaint, "gamow: seen.png: it does not record --gaze, which must then be given\n");
    let flags = "--fov 100 --gaze 120,25 --layout side-by-side";
    assert!(["left", "right"].map(|eye| correct(&format!("{flags} --eye {eye}"))) == recorded);
    assert!(recorded[0] != recorded[1]);
}
