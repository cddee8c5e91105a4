//! Black bodies against sums done here: Planck's law over what eyes see of the CIE's table, with no logarithm
//! and no lookup.

use relativity_render::colour::luminance;
use relativity_render::colour::planck::{Broad, black_body};
use relativity_render::{Appearance, Colour, Emission, received_intensity};

const TABLE: &str = include_str!("../assets/cie-1931-2deg.csv");
/// hc/k, nm K.
const C2: f64 = 1.438_776_877e7;

/// Wavelength, nm, and the colour-matching functions there.
fn rows() -> impl Iterator<Item = [f64; 4]> {
    let row = |line: &str| {
        let mut numbers = line.split(',').map(|number| number.parse().expect("a number"));
        std::array::from_fn(|_| numbers.next().expect("four of them"))
    };
    TABLE.lines().skip(1).map(row).filter(|[nm, ..]: &[f64; 4]| (380.0..=780.0).contains(nm))
}

/// X, Y, Z of a black body of `kelvin`: sums over every nm, as CIE 015 has them.
fn xyz(kelvin: f64) -> [f64; 3] {
    rows().fold([0.0; 3], |sum, [nm, x, y, z]| {
        let radiance = nm.powi(-5) / (C2 / (nm * kelvin)).exp_m1();
        [sum[0] + radiance * x, sum[1] + radiance * y, sum[2] + radiance * z]
    })
}

/// log2 of the luminance of `light`, in units in which that of a spectrum is a plain sum over nm.
fn log2_luminance(light: &Broad) -> f64 {
    light.log2_level + luminance(light.hue).log2()
}

fn luminance_of(kelvin: f64) -> f64 {
    log2_luminance(&black_body(kelvin.log2())).exp2()
}

#[test]
fn luminances_are_those_of_a_numerical_integration() {
    let daylight = [luminance_of(6504.0), xyz(6504.0)[1]];
    for kelvin in (0..=60).map(|step| 250.0 * 10f64.powf(f64::from(step) / 60.0 * 3.6)) {
        let [found, expected] = [luminance_of(kelvin) / daylight[0], xyz(kelvin)[1] / daylight[1]];
        assert!((found / expected - 1.0).abs() < 2e-3, "{kelvin} K: {found} for {expected}");
    }
}

#[test]
fn the_lattice_of_1000_degrees_at_nine_tenths_of_c() {
    let appearance = Appearance { colour: Colour::Glowing, temperature_k: 1273.15, ..Appearance::default() };
    let head_on = 19f64.sqrt();
    let ratio = |doppler| received_intensity(Emission::WHITE, &appearance, doppler);
    let summed = |doppler: f64| xyz(1273.15 * doppler)[1] / xyz(1273.15)[1];
    assert!((ratio(head_on) / 3.5e6 - 1.0).abs() < 0.02, "{}", ratio(head_on));
    assert!((ratio(1.0 / head_on) / 2.4e-25 - 1.0).abs() < 0.02, "{}", ratio(1.0 / head_on));
    for doppler in [head_on, 1.0 / head_on, 0.6, 1.7] {
        assert!((ratio(doppler) / summed(doppler) - 1.0).abs() < 5e-3, "D = {doppler}");
    }
}

#[test]
fn colours_are_those_of_a_numerical_integration() {
    for kelvin in [2000.0, 2856.0, 4000.0, 6504.0, 10_000.0, 30_000.0, 1e6] {
        let Broad { hue: [r, g, b], .. } = black_body(f64::log2(kelvin));
        // The printed way back of IEC 61966-2-1.
        let shown = [
            0.4124 * r + 0.3576 * g + 0.1805 * b,
            0.2126 * r + 0.7152 * g + 0.0722 * b,
            0.0193 * r + 0.1192 * g + 0.9505 * b,
        ];
        let place = |[x, y, z]: [f64; 3]| [x / (x + y + z), y / (x + y + z)];
        let ([a, b], [c, d]) = (place(shown), place(xyz(kelvin)));
        assert!((a - c).hypot(b - d) < 1e-3, "{kelvin} K: {a}, {b} for {c}, {d}");
    }
}

#[test]
fn colder_and_hotter_than_the_table_the_asymptotes_go_on() {
    let step =
        |colder: f64, hotter: f64| log2_luminance(&black_body(hotter)) - log2_luminance(&black_body(colder));
    // Rayleigh and Jeans: as T.
    for octave in [23.0, 24.0, 30.0, 200.0] {
        assert!((step(octave, octave + 1.0) - 1.0).abs() < 2e-3, "2^{octave} K");
    }
    // Wien: at the red end of what is seen ln L falls by hc/(k lambda T) for each halving of T.
    for octave in [1.0, 3.0] {
        let expected = C2 / (780.0 * f64::exp2(octave + 1.0)) / std::f64::consts::LN_2;
        assert!((step(octave, octave + 1.0) / expected - 1.0).abs() < 0.02, "2^{octave} K");
    }
    for octave in [-1000.0, 0.0, 4.0, 23.9, 1000.0] {
        let Broad { hue, log2_level } = black_body(octave);
        assert!(log2_level.is_finite() && hue.iter().all(|part| (0.0..=1.0).contains(part)), "2^{octave} K");
    }
}
