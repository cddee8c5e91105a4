//! The colour of a wavelength, against published values.
//!
//! References: G. Wyszecki and W. S. Stiles, *Color Science*, 2nd ed. (1982), table I(3.3.1): functions,
//! chromaticities and sums; IEC 61966-2-1 for the way back from sRGB.

use relativity_render::colour::planck::black_body;
use relativity_render::colour::{
    colour_matching, false_colour, hue_preserving_clip, linear_srgb, luminance, srgb_decoded, srgb_encoded,
    srgb_level, unseen_glow, unseen_line,
};
use relativity_render::light::tone::{KNEE, shoulder, toned, untoned};

use crate::support::documented;

fn nm(from: u32, to: u32, step: usize) -> impl Iterator<Item = f64> {
    (from..=to).step_by(step).map(f64::from)
}

fn chromaticity([x, y, z]: [f64; 3]) -> [f64; 2] {
    [x / (x + y + z), y / (x + y + z)]
}

#[test]
fn the_table_holds_the_published_functions() {
    let published = [
        (450.0, [0.3362, 0.0380, 1.77211]),
        (500.0, [0.0049, 0.3230, 0.2720]),
        (555.0, [0.51205, 1.0, 0.00575]),
        (600.0, [1.0622, 0.6310, 0.0008]),
        (700.0, [0.011_359, 0.004_102, 0.0]),
    ];
    for (wavelength, expected) in published {
        let found = colour_matching(wavelength).expect("inside the table");
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() <= 5e-6, "{wavelength} nm: {found} against {expected}");
        }
    }
    assert_eq!(colour_matching(359.9), None);
    assert_eq!(colour_matching(830.1), None);
    assert_eq!(colour_matching(f64::NAN), None);
}

#[test]
fn the_sums_over_the_table_are_the_published_ones() {
    let sums = nm(380, 780, 5).fold([0.0; 3], |sum: [f64; 3], wavelength| {
        let value = colour_matching(wavelength).expect("inside the table");
        std::array::from_fn(|i| sum[i] + value[i])
    });
    for (sum, published) in sums.into_iter().zip([21.3714, 21.3711, 21.3715]) {
        assert!((sum - published).abs() < 2e-3, "{sum} against {published}");
    }
}

#[test]
fn spectral_chromaticities_are_the_published_ones() {
    for (wavelength, published) in [
        (460.0, [0.1440, 0.0297]),
        (520.0, [0.0743, 0.8338]),
        (580.0, [0.5125, 0.4866]),
        (700.0, [0.7347, 0.2653]),
    ] {
        let found = chromaticity(colour_matching(wavelength).expect("inside the table"));
        assert!((found[0] - published[0]).abs() < 1e-4 && (found[1] - published[1]).abs() < 1e-4);
    }
}

/// Hue angle in IPT, degrees, as its authors define it: worked out here once more, with the printed matrices.
fn hue_in_ipt([x, y, z]: [f64; 3]) -> f64 {
    let cones = [0.4002 * x + 0.7075 * y - 0.0807 * z, -0.2280 * x + 1.1500 * y + 0.0612 * z, 0.9184 * z];
    let [l, m, s] = cones.map(|response: f64| response.abs().powf(0.43).copysign(response));
    let (p, t) = (4.4550 * l - 4.8510 * m + 0.3960 * s, 0.8056 * l + 0.3572 * m - 1.1628 * s);
    t.atan2(p).to_degrees()
}

/// From the hue `from` to the hue `to` by the shorter way, degrees.
fn turn(from: f64, to: f64) -> f64 {
    (to - from + 180.0).rem_euclid(360.0) - 180.0
}

/// The matrix of linear sRGB to more digits than the standard prints: at the red end the hue hangs on the
/// last.
fn xyz_from_srgb([r, g, b]: [f64; 3]) -> [f64; 3] {
    [
        0.412_456_4 * r + 0.357_576_1 * g + 0.180_437_5 * b,
        0.212_672_9 * r + 0.715_152_2 * g + 0.072_175_0 * b,
        0.019_333_9 * r + 0.119_192_0 * g + 0.950_304_1 * b,
    ]
}

#[test]
fn a_spectral_colour_has_the_hue_of_its_wavelength() {
    for wavelength in nm(4000, 7000, 1).map(|tenth| tenth / 10.0) {
        let spectral = hue_in_ipt(colour_matching(wavelength).expect("inside the table"));
        let off = turn(spectral, hue_in_ipt(xyz_from_srgb(linear_srgb(wavelength))));
        assert!(off.abs() < 0.5, "{wavelength} nm is {off} degrees off its hue");
    }
}

#[test]
fn hardly_a_screen_colour_of_its_hue_is_more_saturated_than_a_spectral_one() {
    for wavelength in nm(420, 710, 1) {
        let rgb = linear_srgb(wavelength);
        let smallest = rgb.into_iter().fold(f64::INFINITY, f64::min);
        let largest = rgb.into_iter().fold(0.0, f64::max);
        let is_pure = (0.0..0.04).contains(&smallest) && largest == 1.0;
        assert!(is_pure, "{wavelength} nm: {rgb:?}");
    }
}

/// Levels of 255 by the standard's curve, not rounded.
fn levels(linear: [f64; 3]) -> [f64; 3] {
    linear.map(|part| {
        255.0 * if part <= 0.003_130_8 { 12.92 * part } else { 1.055 * part.powf(1.0 / 2.4) - 0.055 }
    })
}

#[test]
fn no_seam_shows_in_the_rainbow() {
    let step = |from: [f64; 3], to: [f64; 3]| {
        let [from, to] = [from, to].map(levels);
        (0..3).map(|i| (from[i] - to[i]).abs()).fold(0.0, f64::max)
    };
    let stated: f64 = documented(include_str!("../src/colour/mod.rs"), "component changes by more than ");
    let steps = nm(380, 779, 1).map(|nm| (step(linear_srgb(nm), linear_srgb(nm + 1.0)), nm));
    let (most, at) = steps.max_by(|a, b| a.0.total_cmp(&b.0)).expect("there are some");
    println!("at most {most:.1} levels, after {at} nm");
    assert!(most <= stated, "{most} levels after {at} nm");
    // Black bodies move into what a screen can show, at about 1900 K.
    let glows: Vec<_> = (2560..6400).map(|step| black_body(f64::from(step) / 256.0).hue).collect();
    let most = glows.windows(2).map(|pair| step(pair[0], pair[1])).fold(0.0, f64::max);
    println!("at most {most:.1} levels in 1/256 of an octave");
    assert!(most <= stated, "{most} levels");
}

#[test]
fn the_red_of_long_waves_is_red_and_hues_follow_the_wavelength() {
    let bytes = |nm| linear_srgb(nm).map(|part| (255.0 * srgb_encoded(part)).round() as u8);
    assert_eq!(bytes(700.0), [0xff, 0x12, 0x22]);
    assert_eq!(bytes(620.0), [0xff, 0x3f, 0x06]);
    let hues: Vec<_> = nm(420, 700, 1).map(|nm| hue_in_ipt(xyz_from_srgb(linear_srgb(nm)))).collect();
    for (step, pair) in hues.windows(2).enumerate() {
        let turn = turn(pair[0], pair[1]);
        // The table's z ends at 650 nm, with a step back of 0.104 degrees in the hue of the table itself.
        assert!((-20.0..0.11).contains(&turn), "{turn} degrees after {} nm", 420 + step);
    }
}

#[test]
fn visible_light_fades_smoothly_to_black_at_both_ends() {
    for dark in [1e-3, 1.0, 200.0, 359.0, 380.0, 780.0, 900.0, 1e9] {
        assert_eq!(linear_srgb(dark), [0.0; 3], "{dark} nm");
    }
    let red = linear_srgb(700.0);
    assert!(red[0] == 1.0 && red[1] < 0.01 && red[2] < 0.1, "the paper's red is full red: {red:?}");
    for wavelength in nm(1440, 1720, 1).chain(nm(2800, 3200, 1)).map(|quarter| quarter / 4.0) {
        let [here, next] = [wavelength, wavelength + 0.25].map(linear_srgb);
        let step = (0..3).map(|i| (here[i] - next[i]).abs()).fold(0.0, f64::max);
        assert!(step < 0.03, "a jump of {step} at {wavelength} nm");
    }
}

#[test]
fn the_unseen_share_is_signed_and_fades_out_where_light_fades_in() {
    assert_eq!([1e-3, 200.0, 380.0, 780.0, 2000.0, 1e9].map(unseen_line), [-1.0, -1.0, -1.0, 1.0, 1.0, 1.0]);
    for wavelength in nm(420, 710, 1) {
        assert_eq!(unseen_line(wavelength), 0.0, "{wavelength} nm");
    }
    for wavelength in nm(360, 800, 1) {
        let [here, next] = [wavelength, wavelength + 1.0].map(unseen_line);
        assert!((here - next).abs() < 0.05, "a jump from {here} to {next} at {wavelength} nm");
        assert!(next >= here, "more infrared than at {wavelength} nm is less: {next}");
    }
    assert_eq!([900.0, 4000.0].map(|kelvin| unseen_glow(f64::log2(kelvin))), [1.0, 0.0]);
}

#[test]
fn false_colours_are_grey_at_rest_and_tell_all_doppler_factors_apart() {
    let [red, green, blue] = false_colour(0.0);
    assert!((red - green).abs() < 0.05 && (green - blue).abs() < 0.05);
    let blueness = |octaves| false_colour(octaves)[2] - false_colour(octaves)[0];
    let steps: Vec<_> = (-80..=80).map(|step| blueness(f64::from(step) / 10.0)).collect();
    assert!(steps.windows(2).all(|pair| pair[1] > pair[0]));
    assert!(blueness(-1000.0) < -0.5 && blueness(1000.0) > 0.7);
}

#[test]
fn the_shoulder_rises_everywhere_without_a_kink_and_cuts_nothing_off() {
    assert_eq!([0.0, 0.3, KNEE].map(shoulder), [0.0, 0.3, KNEE]);
    let steps: Vec<_> = (0..4000).map(|i| shoulder(f64::from(i) / 400.0)).collect();
    assert!(steps.windows(2).all(|pair| pair[1] > pair[0]));
    let bends = steps.windows(3).map(|three| (three[2] - 2.0 * three[1] + three[0]).abs());
    // 5 h^2 where it bends most, for steps h of 1/400; a kink would be a part of h.
    assert!(bends.fold(0.0, f64::max) < 4e-5, "slopes have no jump");
    assert!(shoulder(30.0) < 1.0 && shoulder(f64::MAX) <= 1.0);
    // The brightest that is shown by less than the last of 255 levels.
    assert!((255.0 * srgb_encoded(shoulder(30.0))).round() < 255.0);
}

#[test]
fn the_shoulder_keeps_hue_and_saturation_and_can_be_undone() {
    let [red, green, blue] = toned([4.0, 1.0, 0.0]);
    assert!((red / green - 4.0).abs() < 1e-12 && blue == 0.0 && red < 1.0);
    assert_eq!(toned([0.5, 0.1, 0.0]), [0.5, 0.1, 0.0]);
    for linear in [[4.0, 1.0, 0.0], [0.5, 0.1, 0.0], [20.0, 19.0, 3.0]] {
        let back = untoned(toned(linear));
        assert!((0..3).all(|i| (back[i] - linear[i]).abs() < 1e-9 * linear[0]), "{back:?}");
    }
}

#[test]
fn clipping_keeps_the_ratios_of_the_components() {
    assert_eq!(hue_preserving_clip([4.0, 1.0, 0.0]), [1.0, 0.25, 0.0]);
    assert_eq!(hue_preserving_clip([0.5, 0.1, 0.0]), [0.5, 0.1, 0.0]);
}

#[test]
fn the_srgb_curve_has_the_standard_values() {
    assert!((srgb_encoded(0.214_041_14) - 0.5).abs() < 1e-6);
    assert_eq!(srgb_encoded(0.0), 0.0);
    assert!((srgb_encoded(1.0) - 1.0).abs() < 1e-12);
    for step in 0..=255 {
        let encoded = f64::from(step) / 255.0;
        assert!((srgb_encoded(srgb_decoded(encoded)) - encoded).abs() < 1e-6);
    }
}

#[test]
fn a_level_is_the_nearest_to_the_encoding() {
    for step in -1_000..101_000 {
        let linear = f64::from(step) * 1e-5;
        let expected = (255.0 * srgb_encoded(linear.clamp(0.0, 1.0))).round() as u8;
        assert_eq!(srgb_level(linear), expected, "{linear}");
    }
    assert_eq!([f64::NAN, f64::NEG_INFINITY, f64::INFINITY].map(srgb_level), [0, 0, 255]);
}

#[test]
fn colours_end_where_the_documentation_says() {
    let source = include_str!("../src/colour/mod.rs");
    let nm = |before| documented(source, before);
    let [violet, red] = ["as can be; black outside ", "as can be; black outside 380 nm to "].map(nm);
    assert_eq!([violet, red].map(linear_srgb), [[0.0; 3]; 2]);
    assert!([violet + 1.0, red - 1.0].iter().all(|&nm| luminance(linear_srgb(nm)) > 0.0));
    let [first, last] = ["none from ", "none from 420 nm to "].map(nm);
    assert!([first, last].iter().all(|&nm| unseen_line(nm) == 0.0));
    assert!([first - 1.0, last + 1.0].iter().all(|&nm| unseen_line(nm) != 0.0));
}
