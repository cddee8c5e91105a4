//! Lessons 20 and 21, in real light: against sums over the measured spectra that are done here.

use super::support::lesson;
use super::told::{observed, right, says, settings};

const MATCHING: &str = include_str!("../../crates/relativity-render/assets/cie-1931-2deg.csv");
const SUN: &str = include_str!("../../crates/relativity-render/assets/sun.csv");
const MATERIALS: &str = include_str!("../../crates/relativity-render/assets/materials.csv");

/// A column of a table over wavelengths.
struct Spectrum(Vec<[f64; 2]>);

impl Spectrum {
    fn new(csv: &str, column: &str) -> Self {
        let mut lines = csv.lines();
        let names = lines.next().expect("names");
        let number = names.split(',').position(|name| name == column).expect("a column");
        let row = |line: &str| {
            let at = |number: usize| line.split(',').nth(number).and_then(|text| text.parse().ok());
            [at(0).expect("a wavelength"), at(number).expect("a number")]
        };
        Self(lines.map(row).collect())
    }

    /// Between the entries; 0 below the first.
    fn at(&self, nm: f64) -> f64 {
        let next = self.0.partition_point(|[known, _]| *known <= nm);
        let (Some([a, low]), Some([b, high])) =
            (next.checked_sub(1).map(|before| self.0[before]), self.0.get(next))
        else {
            return 0.0;
        };
        low + (high - low) * (nm - a) / (b - a)
    }
}

/// Linear sRGB, beside that of white paint at rest, and the luminance beside its, of what reflects this share
/// of daylight and is received with this Doppler factor.
fn received(reflectance: impl Fn(f64) -> f64, doppler: f64) -> ([f64; 3], f64) {
    let sun = Spectrum::new(SUN, "global_W_m2_nm");
    let matching = ["xbar", "ybar", "zbar"].map(|name| Spectrum::new(MATCHING, name));
    let sums = |reflectance: &dyn Fn(f64) -> f64, doppler: f64| {
        (360..830).map(f64::from).fold([0.0; 3], |sum: [f64; 3], nm| {
            let light = doppler.powi(5) * sun.at(nm * doppler) * reflectance(nm * doppler);
            std::array::from_fn(|part| sum[part] + light * matching[part].at(nm))
        })
    };
    let linear = |[x, y, z]: [f64; 3]| {
        [
            3.240_454_2 * x - 1.537_138_5 * y - 0.498_531_4 * z,
            -0.969_266 * x + 1.876_010_8 * y + 0.041_556 * z,
            0.055_643_4 * x - 0.204_025_9 * y + 1.057_225_2 * z,
        ]
    };
    let (found, white) = (sums(&reflectance, doppler), sums(&|_| 1.0, 1.0));
    let (colour, whites) = (linear(found), linear(white));
    (std::array::from_fn(|part| colour[part] / whites[part]), found[1] / white[1])
}

fn doppler_ahead(beta: f64) -> f64 {
    ((1.0 + beta) / (1.0 - beta)).sqrt()
}

#[test]
fn leaves_have_the_colours_of_the_seasons() {
    let lesson = lesson("seasons");
    let leaves = Spectrum::new(MATERIALS, "leaves");
    let told = ["orange", "near 620 nm", "a light yellow-green", "as pale as snow"];
    for (step, (beta, told)) in [0.26, 0.14, 0.26, 0.55].into_iter().zip(told).enumerate() {
        assert_eq!(right(&lesson, step), told);
        assert_eq!(settings(&lesson, step, true).ride.ride_speed.to_string(), beta.to_string());
    }
    says(&lesson, 0, "= {}$", doppler_ahead(0.26), 2);
    says(&lesson, 0, "arrives with {} nm", 550.0 / doppler_ahead(0.26), 0);
    says(&lesson, 0, "left the leaves with {} nm", 610.0 * doppler_ahead(0.26), 0);
    says(&lesson, 1, "where D is {} straight ahead", doppler_ahead(0.14), 2);
    says(&lesson, 1, "with D of {},", doppler_ahead(0.38), 2);
    says(&lesson, 3, "with D of {} straight ahead", doppler_ahead(0.55), 2);
    // Half way up the edge.
    let edge = (690..750).map(f64::from).find(|nm| leaves.at(*nm) > 0.26).expect("an edge");
    assert!((edge - 715.0).abs() < 5.0, "{edge}");
    for (beta, told) in [(0.14, 622.0), (0.26, 548.0), (0.38, 480.0), (0.55, 385.0)] {
        assert!((715.0 / doppler_ahead(beta) - told).abs() < 2.5, "{beta}");
    }
    for (nm, least, most) in [(793.0, 0.5, 0.6), (550.0, 1.0 / 13.0, 1.0 / 11.0), (640.0, 0.0, 0.05)] {
        assert!((least..most).contains(&leaves.at(nm)), "{nm}: {}", leaves.at(nm));
    }
    let colour = |beta: f64| received(|nm| leaves.at(nm), doppler_ahead(beta)).0;
    let [red, green, blue] = colour(0.14);
    assert!(red > 3.0 * green && red > 3.0 * blue, "wine red");
    let [red, green, blue] = colour(0.26);
    assert!((0.2..0.5).contains(&(green / red)) && blue < 0.1 * red, "orange");
    let [red, green, blue] = colour(0.38);
    assert!(green > red && red > 0.5 * green && blue < 0.15 * green, "lime");
    let white = |beta: f64| received(|_| 1.0, doppler_ahead(beta)).0;
    let snow: [f64; 3] = std::array::from_fn(|part| colour(0.55)[part] / white(0.55)[part]);
    assert!(snow.iter().all(|part| (part / snow[1] - 1.0).abs() < 0.1), "{snow:?}");
}

#[test]
fn red_paint_is_yellow_green_and_the_road_is_as_white_is() {
    let lesson = lesson("seasons");
    let paint = Spectrum::new(MATERIALS, "red_paint");
    says(&lesson, 2, "620 nm / 1.30 = {} nm", 620.0 / 1.30, 0);
    let edge = (560..700).map(f64::from).find(|nm| paint.at(*nm) > 0.32).expect("an edge");
    assert!((edge - 620.0).abs() < 5.0, "{edge}");
    let [red, green, blue] = received(|nm| paint.at(nm), doppler_ahead(0.26)).0;
    assert!(green > red && red > 0.6 * green && blue < 0.4 * green, "yellow-green");
    let road = Spectrum::new(MATERIALS, "asphalt_road");
    let over_white = |name: &Spectrum| {
        let luminance = |beta: f64| received(|nm| name.at(nm), doppler_ahead(beta)).1;
        let white = |beta: f64| received(|_| 1.0, doppler_ahead(beta)).1;
        luminance(0.26) / white(0.26) / luminance(0.0) * white(0.0)
    };
    assert!(over_white(&paint) > 3.0 && (0.9..1.2).contains(&over_white(&road)));
}

#[test]
fn behind_a_rider_sunlight_ends() {
    let lesson = lesson("goes-dark");
    let behind = |beta: f64| 1.0 / doppler_ahead(beta);
    assert_eq!(right(&lesson, 0), "dark, and thousands of times fainter");
    assert!((behind(0.6) - 0.5).abs() < 1e-12);
    let luminance = |doppler: f64| received(|_| 1.0, doppler).1;
    says(&lesson, 0, "has {} of its luminance at rest", luminance(0.5), 5);
    says(&lesson, 0, "has to leave with {} nm", 620.0 * 0.5, 0);
    assert_eq!(right(&lesson, 1), "0.43");
    says(&lesson, 1, "= {}$$", 300.0 / 700.0, 2);
    assert!(luminance(behind(0.69)) < 1e-6 && (behind(0.69) - 300.0 / 700.0).abs() < 0.005);
    says(&lesson, 2, "behind you D is {}.", behind(0.3), 2);
    says(&lesson, 2, "has {} of its luminance", luminance(behind(0.3)), 3);
    assert!((luminance(behind(0.3)) / behind(0.3).powi(4) - 0.5).abs() < 0.03);
    assert_eq!((right(&lesson, 2), observed(&lesson, 2)), ("a seventh", "dim, and brown"));
}
