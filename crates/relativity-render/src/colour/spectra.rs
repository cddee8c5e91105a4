//! Spectra: daylight at the ground, and the reflectances of paints.
//!
//! Sources and licences of the data are in `assets/README.md`, the derivation in `docs/real-light.md`.

use std::array::from_fn;
use std::sync::LazyLock;

use super::paint::{Material, Paint};

/// Irradiance by sun and sky of a surface that is tilted by 37 degrees towards the sun, and by the sun alone
/// of one at right angles to its light: ASTM G173-03, W/(m^2 nm), 280 to 4000 nm.
static SUN: LazyLock<Columns<2>> = LazyLock::new(|| Columns::new(include_str!("../../assets/sun.csv")));
/// Measured reflectances, 400 to 2400 nm.
static MATERIALS: LazyLock<Columns<{ Material::COUNT }>> =
    LazyLock::new(|| Columns::new(include_str!("../../assets/materials.csv")));
/// Reflectances of red, green and blue smooth paint, 380 to 780 nm, which add up to 1.
static SMOOTH: LazyLock<Columns<3>> =
    LazyLock::new(|| Columns::new(include_str!("../../assets/smooth-paint.csv")));
/// Cosine of the angle between that tilted surface and the sun, 11.2 degrees.
const TOWARDS_SUN: f64 = 0.981;
/// The end of the data of daylight, nm.
const LONGEST_NM: f64 = 4000.0;

/// Numbers over a wavelength.
struct Columns<const N: usize> {
    nm: Vec<f64>,
    rows: Vec<[f64; N]>,
}

impl<const N: usize> Columns<N> {
    /// Parses lines of a wavelength and these numbers, below a line of names.
    fn new(csv: &str) -> Self {
        let (nm, rows) = csv
            .lines()
            .skip(1)
            .map(|line| {
                let mut values =
                    line.split(',').map(|value| value.parse::<f64>().expect("the table holds numbers"));
                let mut next = || values.next().expect("a row holds every column");
                (next(), from_fn(|_| next()))
            })
            .unzip();
        Self { nm, rows }
    }

    /// Returns the numbers at this wavelength, linear between rows; outside, those of the ends.
    fn at(&self, nm: f64) -> [f64; N] {
        let next = self.nm.partition_point(|known| *known <= nm);
        let (Some(below), true) = (next.checked_sub(1), next < self.nm.len()) else {
            return self.rows[next.min(self.nm.len() - 1)];
        };
        let share = (nm - self.nm[below]) / (self.nm[next] - self.nm[below]);
        from_fn(|column| {
            let [low, high] = [below, next].map(|row| self.rows[row][column]);
            low + (high - low) * share
        })
    }
}

/// Spectral irradiance in daylight, of sun and sky together, W/(m^2 nm).
///
/// Below 280 nm, where there is none at the ground, it keeps the value there, 4.7e-23. Beyond 4000 nm, where
/// there are no data, it falls as the fourth power of the wavelength, as the light of anything hot does.
#[must_use]
pub fn daylight(nm: f64) -> f64 {
    let [global, _] = SUN.at(nm);
    global * left_beyond_data(nm)
}

/// The part of [`daylight`] that comes from the sky and not from the sun: blue, and faint in the infrared.
#[must_use]
pub fn skylight(nm: f64) -> f64 {
    let [global, direct] = SUN.at(nm);
    (global - TOWARDS_SUN * direct).max(0.0) * left_beyond_data(nm)
}

fn left_beyond_data(nm: f64) -> f64 {
    let beyond = (nm / LONGEST_NM).max(1.0);
    1.0 / (beyond * beyond * beyond * beyond)
}

/// The reflectance of `paint` at a wavelength, nm. Outside the range in which it is known, 400 to 2400 nm for
/// measured materials and 380 to 780 nm for smooth paint, it keeps its last value.
#[must_use]
pub fn reflectance(paint: Paint, nm: f64) -> f64 {
    match paint {
        Paint::Measured(material) => MATERIALS.at(nm)[material.number()],
        Paint::Smooth(colour) => SMOOTH.at(nm).into_iter().zip(colour).map(|(of, share)| of * share).sum(),
    }
}
