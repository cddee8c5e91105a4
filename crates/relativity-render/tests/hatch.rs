//! The hatch of light that eyes do not see, in rendered pictures: its contrast with the street, its lines,
//! and whether people who confuse red and green tell it from light that is seen.

use relativity_core::{Aperture, Speed};
use relativity_render::colour::{luminance, srgb_decoded};
use relativity_render::{
    Appearance, Body, Camera, Gaze, Geometry, HitImage, Picture, PreparedScene, Shape, View,
};

const INFRARED_NM: f64 = 900.0;
const ULTRAVIOLET_NM: f64 = 300.0;
const RED_NM: f64 = 700.0;

/// Widths of the pictures that are examined, px.
fn widths(light: bool) -> [u32; 2] {
    if light { [300, 800] } else { [300, 2000] }
}

/// A ball before a wide road, in a picture of this width.
fn view(width: u32) -> View {
    let gaze = Gaze { azimuth: std::f64::consts::FRAC_PI_2, elevation: -0.35 };
    let camera = Camera::new(Aperture::default(), gaze, 0.9, [width, width * 5 / 8]);
    let speed = Speed::from_beta(0.0).expect("below 1");
    View { camera, speed, observation_time: 0.0, geometry: Geometry::Seen }
}

fn street(light: bool) -> Appearance {
    Appearance { ground_z: Some(-2.0), road: Some([1.0, 30.0]), light, ..Appearance::default() }
}

struct Shown {
    hits: HitImage,
    body: Picture,
    road: Picture,
}

fn shown(nm: f64, width: u32, appearance: &Appearance) -> Shown {
    let view = view(width);
    let scene =
        PreparedScene::moving(&[Body::new(Shape::Sphere { centre: [0.6, 4.0, -1.2], radius: 0.7 }, nm)]);
    let road = PreparedScene::moving(&[]).picture(&view, appearance, 1);
    Shown { hits: scene.hit_image(&view), body: scene.picture(&view, appearance, 1), road }
}

fn linear(pixel: [u8; 4]) -> [f64; 3] {
    [0, 1, 2].map(|part| srgb_decoded(f64::from(pixel[part]) / 255.0))
}

/// The mean of linear light of `picture` where the body is.
fn mean(picture: &Picture, hits: &HitImage) -> [f64; 3] {
    let covered = picture.rgba.iter().zip(&hits.hits).filter(|(_, hit)| hit.is_some());
    let (sum, count) = covered.fold(([0.0; 3], 0.0), |(sum, count), (pixel, _)| {
        let pixel = linear(*pixel);
        ([0, 1, 2].map(|part| sum[part] + pixel[part]), count + 1.0)
    });
    assert!(count > 500.0, "the body is in the picture");
    sum.map(|part: f64| part / count)
}

/// WCAG 2.2's contrast ratio of two relative luminances.
fn contrast(a: f64, b: f64) -> f64 {
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[test]
fn a_body_in_unseen_light_stands_out_from_the_street_two_to_one() {
    for light in [false, true] {
        for width in widths(light) {
            for nm in [INFRARED_NM, ULTRAVIOLET_NM] {
                let Shown { hits, body, road } = shown(nm, width, &street(light));
                let [body, road] = [body, road].map(|picture| luminance(mean(&picture, &hits)));
                let ratio = contrast(body, road);
                println!("light {light}, {width} px, {nm} nm: {ratio:.2} : 1");
                assert!(ratio >= 2.0, "light {light}, {width} px, {nm} nm: {body} on {road} is {ratio} : 1");
            }
        }
    }
}

#[test]
fn ultraviolet_is_neutral_and_infrared_warm_but_far_from_any_colour_of_light() {
    for light in [false, true] {
        let [infrared, ultraviolet] = [INFRARED_NM, ULTRAVIOLET_NM].map(|nm| shown(nm, 600, &street(light)));
        let of_body = |shown: &Shown| {
            let pixels = shown.body.rgba.iter().zip(&shown.hits.hits).filter(|(_, hit)| hit.is_some());
            pixels.map(|(pixel, _)| linear(*pixel)).collect::<Vec<_>>()
        };
        for [r, g, b] in of_body(&ultraviolet) {
            assert!(r == g && g == b, "{r} {g} {b}");
        }
        for [r, g, b] in of_body(&infrared) {
            // Of light that eyes see one component in three is less than a twentieth of another.
            assert!(r >= g && g >= b && b > 0.3 * r, "{r} {g} {b}");
        }
        let [warm, cold] =
            [&infrared, &ultraviolet].map(|Shown { hits, body, .. }| luminance(mean(body, hits)));
        assert!((warm / cold - 1.0).abs() < 0.05, "{warm} beside {cold}");
    }
}

/// Root mean square of the change of lightness (0 to 255) from a pixel to the one `right` columns and one row
/// below, inside the body.
fn change(Shown { hits, body, .. }: &Shown, right: isize) -> f64 {
    let width = (body.size[0] as usize).cast_signed();
    let is_inside =
        |i: isize| usize::try_from(i).is_ok_and(|i| hits.hits.get(i).is_some_and(Option::is_some));
    let (mut sum, mut count) = (0.0, 0.0);
    for i in 0..body.rgba.len().cast_signed() {
        let other = i + width + right;
        if is_inside(i) && is_inside(other) {
            let [a, b] = [i, other].map(|i| f64::from(body.rgba[i.cast_unsigned()][1]));
            (sum, count) = (sum + (a - b) * (a - b), count + 1.0);
        }
    }
    f64::sqrt(sum / count)
}

#[test]
fn lines_rise_for_infrared_and_fall_for_ultraviolet_and_show_at_all_sizes() {
    for light in [false, true] {
        for width in widths(light) {
            // Along a line nothing changes but the shade; across it much does.
            let infrared = shown(INFRARED_NM, width, &street(light));
            let ultraviolet = shown(ULTRAVIOLET_NM, width, &street(light));
            let [rising, falling] = [-1, 1];
            for (body, along, across) in [(&infrared, rising, falling), (&ultraviolet, falling, rising)] {
                let [along, across] = [along, across].map(|right| change(body, right));
                assert!(
                    across > 10.0 && across > 4.0 * along,
                    "{light} {width}: {along} and {across} levels"
                );
            }
        }
    }
}

/// G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, *A Physiologically-based Model for Simulation of Color
/// Vision Deficiency*, IEEE TVCG 15 (2009), severity 1.0, for linear sRGB: protanopia and deuteranopia.
const MACHADO: [[[f64; 3]; 3]; 2] = [
    [
        [0.152_286, 1.052_583, -0.204_868],
        [0.114_503, 0.786_281, 0.099_216],
        [-0.003_882, -0.048_116, 1.051_998],
    ],
    [
        [0.367_322, 0.860_646, -0.227_968],
        [0.280_085, 0.672_501, 0.047_413],
        [-0.011_820, 0.042_940, 0.968_881],
    ],
];

fn simulated(matrix: &[[f64; 3]; 3], colour: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row.iter().zip(colour).map(|(weight, part)| weight * part).sum::<f64>().clamp(0.0, 1.0))
}

/// CIE L*a*b* of linear sRGB, white at D65.
fn lab([r, g, b]: [f64; 3]) -> [f64; 3] {
    let x = (0.412_456 * r + 0.357_576 * g + 0.180_438 * b) / 0.950_47;
    let y = luminance([r, g, b]);
    let z = (0.019_334 * r + 0.119_192 * g + 0.950_304 * b) / 1.088_83;
    let [x, y, z] = [x, y, z].map(|t| if t > 0.008_856 { f64::cbrt(t) } else { 7.787 * t + 16.0 / 116.0 });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Colours this far apart (CIE 1976) are far beyond what can be confused; 2.3 is just noticed.
const TOLD_APART: f64 = 20.0;

#[test]
fn protanopes_and_deuteranopes_tell_lit_red_from_infrared() {
    for light in [false, true] {
        let [red, infrared] = [RED_NM, INFRARED_NM].map(|nm| {
            let Shown { hits, body, .. } = shown(nm, 400, &street(light));
            mean(&body, &hits)
        });
        for matrix in &MACHADO {
            let [red, infrared] = [red, infrared].map(|colour| lab(simulated(matrix, colour)));
            let off = f64::sqrt((0..3).map(|i| (red[i] - infrared[i]).powi(2)).sum());
            println!("light {light}: {off:.1} apart");
            assert!(off > TOLD_APART, "light {light}: {red:?} and {infrared:?} are {off} apart");
        }
    }
}

#[test]
fn what_is_seen_has_no_hatch() {
    for nm in [430.0, 550.0, RED_NM] {
        let all = street(false);
        let black = Appearance { invisible: false, ..all };
        let [with, without] = [all, black].map(|appearance| shown(nm, 300, &appearance).body);
        assert_eq!(with, without, "{nm} nm");
        // And without it what is not seen is black.
        let Shown { hits, body, .. } = shown(INFRARED_NM, 300, &black);
        assert_eq!(mean(&body, &hits), [0.0; 3]);
    }
}
