//! Corrects a picture to the frame of the bodies: what a camera moving along with them would have taken at
//! the same event.
//!
//! Both cameras meet at one event and receive the same light. A line of sight turns by aberration, a
//! wavelength is multiplied by D, and an intensity is divided by D^n. That holds for all light, whatever sent
//! it: a wheel that rolls becomes one that turns, with the Doppler effect of its turning.
//!
//! A pixel's colour tells a wavelength only as far as its hue does: the part of it that is not grey counts as
//! monochromatic light (see [`crate::colour`]), the grey part as light without a wavelength; what the
//! shoulder of bright light (see [`crate::light::tone`]) took off is put back first. What the Doppler effect
//! shifted out of sight stays dark.

use std::sync::LazyLock;

use glam::DVec3;
use relativity_core::doppler::intensity_factor;
use relativity_core::math::{atan, sinh};
use relativity_core::threads::{self, prelude::*};

use super::pixels::{Picture, encoded, sample_grid};
use crate::camera::lines_of_sight::LinesOfSight;
use crate::camera::{Camera, Gaze, Projection};
use crate::colour::{linear_srgb, mix, srgb_decoded};
use crate::kinematics::velocity::Velocity;
use crate::light::tone::{toned, untoned};

/// Rays per pixel of a corrected picture, along each side.
const SAMPLES: u32 = 3;
/// Range of wavelengths that have distinct hues, nm.
const HUES_NM: std::ops::RangeInclusive<u32> = 420..=710;
/// Distance from every spectral hue up to which a colour still counts as one of them: generously a step of
/// the table.
const HUE_TOLERANCE: f64 = 0.1;

/// Two cameras at one event: one at rest on the ground, one moving along with the bodies.
///
/// # Examples
///
/// ```
/// use relativity_core::Aperture;
/// use relativity_render::picture::rectify::Rectification;
/// use relativity_render::{Camera, Gaze, Velocity};
///
/// let (aperture, gaze) = (Aperture::default(), Gaze::STRAIGHT_AHEAD);
/// let ground = Camera::new(aperture, gaze, 1.0, [80, 60]);
/// let velocity = Velocity::from_beta(0.6)?;
/// let rest = Rectification::rest_camera(&ground, &velocity);
/// // The camera that moves along looks ahead to see the same: cos(azimuth) = beta.
/// assert!((rest.gaze.azimuth - 0.6f64.acos()).abs() < 1e-15);
/// let [u, v] = Rectification::new(ground, rest, velocity).ground_place([40.0, 30.0]).expect("inside");
/// assert!((u - 40.0).hypot(v - 30.0) < 1e-9);
/// # Ok::<(), relativity_core::SpeedError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Rectification {
    ground: Camera,
    rest: Camera,
    velocity: Velocity,
    lines_of_sight: LinesOfSight,
}

/// The correction of light by a change of frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightCorrection {
    /// Whether wavelengths are multiplied by D.
    pub doppler_shift: bool,
    /// Exponent n of the received intensity D^n by which intensities are divided; `None` leaves them.
    pub intensity_exponent: Option<f64>,
}

impl Rectification {
    /// From a picture of `ground`, taken on the ground, to one of `rest`, which moves along at `velocity`.
    #[must_use]
    pub fn new(ground: Camera, rest: Camera, velocity: Velocity) -> Self {
        Self { ground, rest, velocity, lines_of_sight: rest.lines_of_sight() }
    }

    /// The moving camera that has what `ground` has in its centre in its own, equally large, its picture
    /// across its gaze; or conformal as that of `ground` is: then its picture is the same for eyes along the
    /// motion, slid by the rapidity.
    #[must_use]
    pub fn rest_camera(ground: &Camera, velocity: &Velocity) -> Camera {
        let to_centre = ground.through_middle();
        // Beside the axis of a sheared picture all is larger: across the shear so many times.
        let stretch = to_centre.length();
        let centre = to_centre / stretch;
        let gaze = Gaze::along(velocity.rest_from_ground(centre).to_array());
        // Small angles are D times as large in the rest frame, so the focal length is 1/D times as long.
        let half_width = ground.half_width() * velocity.doppler_factor(centre) / stretch;
        let Projection::Mercator { right, .. } = ground.projection else {
            return Camera {
                gaze,
                horizontal_fov: 2.0 * atan(half_width),
                projection: Projection::Gaze,
                ..*ground
            };
        };
        let rest = Camera { gaze, projection: Projection::Mercator { right, shift: 0.0 }, ..*ground };
        let half_width = half_width * rest.through_middle().length();
        Camera { horizontal_fov: 2.0 * atan(sinh(half_width)), ..rest }
    }

    /// Returns the moving camera.
    #[must_use]
    pub const fn rest(&self) -> &Camera {
        &self.rest
    }

    /// Returns the place in the picture from the ground that shows the same as `place` in the corrected one
    /// (both in pixels); `None` outside of it.
    #[must_use]
    pub fn ground_place(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let rest_line = self.lines_of_sight.through(place);
        let [u, v] = self.ground.pixel(self.velocity.ground_from_rest(rest_line))?;
        let [width, height] = self.ground.size.map(f64::from);
        ((0.0..width).contains(&u) && (0.0..height).contains(&v)).then_some([u, v])
    }

    /// Doppler factor of the light at `place` in the picture from the ground.
    #[must_use]
    pub fn doppler_factor(&self, place: [f64; 2]) -> f64 {
        self.velocity.doppler_factor(self.ground.line_of_sight(place))
    }

    /// The corrected picture of `picture`; black where that shows nothing.
    ///
    /// `picture` must have the size of the camera on the ground.
    #[must_use]
    pub fn picture(&self, picture: &Picture, light: LightCorrection) -> Picture {
        let linear: [f64; 256] = std::array::from_fn(|byte| srgb_decoded(byte as f64 / 255.0));
        let [width, height] = self.rest.size;
        let row_done = threads::in_parts(height);
        let pixel = |index: u32| {
            let mut sum = [0.0; 3];
            for place in sample_grid([index % width, index / width], SAMPLES) {
                let Some(source) = self.ground_place(place) else { continue };
                let colour = interpolated(picture, &linear, source);
                let corrected = light.corrected(colour, self.doppler_factor(source));
                sum = std::array::from_fn(|i| sum[i] + corrected[i]);
            }
            if (index + 1).is_multiple_of(width) {
                row_done();
            }
            encoded(sum.map(|part| part / f64::from(SAMPLES * SAMPLES)))
        };
        Picture { size: self.rest.size, rgba: (0..width * height).into_par_iter().map(pixel).collect() }
    }
}

impl LightCorrection {
    /// The linear colour that light of the linear colour `received` at Doppler factor `doppler` has at rest,
    /// both as a screen shows them.
    #[must_use]
    pub fn corrected(&self, received: [f64; 3], doppler: f64) -> [f64; 3] {
        let brightness =
            self.intensity_exponent.map_or(1.0, |exponent| 1.0 / intensity_factor(doppler, exponent));
        let received = untoned(received);
        let shifted = if self.doppler_shift { shifted(received, doppler) } else { received };
        toned(shifted.map(|part| (part * brightness).min(f64::MAX)))
    }
}

/// The linear colour of `received` with the wavelength of its monochromatic part multiplied by `factor`; as
/// it is if no light has its hue.
fn shifted(received: [f64; 3], factor: f64) -> [f64; 3] {
    let Some(wavelength_nm) = pure(received).and_then(wavelength_nm) else { return received };
    let (received, own) = (DVec3::from(received), DVec3::from(linear_srgb(wavelength_nm)));
    // A screen shows the light of one wavelength with some grey of its own, see `in_gamut`.
    let range = |colour: DVec3| colour.max_element() - colour.min_element();
    let intensity = range(received) / range(own);
    let rest = (received.min_element() - intensity * own.min_element()).max(0.0);
    linear_srgb(wavelength_nm * factor).map(|part| intensity * part + rest)
}

/// The wavelength whose light is `hue` without its grey part.
fn wavelength_nm(hue: [f64; 3]) -> Option<f64> {
    static HUES: LazyLock<Vec<(f64, [f64; 3])>> = LazyLock::new(|| {
        HUES_NM.map(f64::from).filter_map(|nm| Some((nm, pure(linear_srgb(nm))?))).collect()
    });
    let distance = |other: &[f64; 3]| -> f64 { (0..3).map(|i| (other[i] - hue[i]).powi(2)).sum() };
    let nearest = HUES.iter().min_by(|a, b| distance(&a.1).total_cmp(&distance(&b.1)))?;
    (distance(&nearest.1).sqrt() <= HUE_TOLERANCE).then_some(nearest.0)
}

/// `colour` without its grey part, its largest component 1; `None` for grey.
fn pure(colour: [f64; 3]) -> Option<[f64; 3]> {
    let colour = DVec3::from(colour);
    let (grey, most) = (colour.min_element(), colour.max_element());
    (most > grey).then(|| ((colour - grey) / (most - grey)).to_array())
}

/// The linear colour of `picture` at a place between the centres of pixels, by the `linear` value of each
/// byte.
fn interpolated(picture: &Picture, linear: &[f64; 256], [u, v]: [f64; 2]) -> [f64; 3] {
    let [width, height] = picture.size;
    let last = |side: u32| f64::from(side - 1);
    let (x, y) = ((u - 0.5).clamp(0.0, last(width)), (v - 0.5).clamp(0.0, last(height)));
    let at = |x: f64, y: f64| {
        let [r, g, b, _] = picture.rgba[y as usize * width as usize + x as usize];
        [r, g, b].map(|part| linear[usize::from(part)])
    };
    let (right, below) = ((x + 1.0).min(last(width)), (y + 1.0).min(last(height)));
    let row = |y: f64| mix(at(x, y), at(right, y), x.fract());
    mix(row(y), row(below), y.fract())
}

#[cfg(test)]
mod tests {
    use super::*;
    use relativity_core::Aperture;

    fn camera() -> Camera {
        Camera::new(Aperture::default(), Gaze { azimuth: 2.2, elevation: 0.3 }, 1.0, [120, 90])
    }

    fn rectification() -> Rectification {
        let velocity = Velocity::from_beta(0.8).expect("a speed");
        Rectification::new(camera(), Rectification::rest_camera(&camera(), &velocity), velocity)
    }

    #[test]
    fn the_centre_stays_in_place_and_size() {
        let rectification = rectification();
        let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let centre = rectification.ground_place([60.0, 45.0]).expect("inside");
        assert!(near(centre, [60.0, 45.0]) < 1e-9);
        for step in [[0.01, 0.0], [0.0, 0.01]] {
            let beside = rectification.ground_place([60.0 + step[0], 45.0 + step[1]]).expect("inside");
            assert!((near(beside, centre) / 0.01 - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn bodies_that_move_towards_minus_x_are_corrected_as_in_a_mirror() {
        let mirrored = |camera: Camera| {
            let gaze = Gaze { azimuth: std::f64::consts::PI - camera.gaze.azimuth, ..camera.gaze };
            Camera { gaze, ..camera }
        };
        let there = mirrored(camera());
        let velocity = Velocity::from_beta(-0.8).expect("a speed");
        let backward = Rectification::new(there, Rectification::rest_camera(&there, &velocity), velocity);
        for [u, v] in [[60.0, 45.0], [50.5, 40.5], [70.5, 52.5]] {
            let forward = rectification().ground_place([u, v]).expect("inside");
            let [x, y] = backward.ground_place([120.0 - u, v]).expect("inside");
            assert!((x + forward[0] - 120.0).hypot(y - forward[1]) < 1e-9);
        }
    }

    #[test]
    fn light_of_one_wavelength_gets_its_own_colour_back() {
        let light = LightCorrection { doppler_shift: true, intensity_exponent: Some(2.0) };
        for doppler in [0.9, 1.0, 1.2, 1.35] {
            let rest = linear_srgb(590.0).map(|part| part * 0.3);
            let received = linear_srgb(590.0 / doppler).map(|part| part * 0.3 * doppler * doppler);
            let corrected = light.corrected(received, doppler);
            let difference = (0..3).map(|i| (corrected[i] - rest[i]).abs()).fold(0.0, f64::max);
            assert!(difference < 0.02, "{corrected:?} {rest:?}");
        }
    }

    #[test]
    fn grey_light_changes_only_in_brightness() {
        let light = LightCorrection { doppler_shift: true, intensity_exponent: Some(2.0) };
        let corrected = light.corrected([0.2; 3], 2.0);
        assert!(corrected.iter().all(|part| (part - 0.05).abs() < 1e-12));
        let untouched = LightCorrection { doppler_shift: false, intensity_exponent: None };
        assert_eq!(untouched.corrected([0.1, 0.5, 0.2], 2.0), [0.1, 0.5, 0.2]);
    }

    #[test]
    fn at_rest_a_picture_stays_as_it_is() {
        let camera = Camera { size: [8, 6], ..camera() };
        let rgba: Vec<[u8; 4]> = (0..48).map(|i| [5 * i, 255 - 4 * i, 3 * i, 255]).collect();
        let picture = Picture { size: [8, 6], rgba: rgba.clone() };
        let light = LightCorrection { doppler_shift: false, intensity_exponent: Some(2.0) };
        let same = Rectification::new(camera, camera, Velocity::REST).picture(&picture, light);
        for (pixel, (a, b)) in same.rgba.iter().zip(&rgba).enumerate() {
            let is_inside = (1..7).contains(&(pixel % 8)) && (1..5).contains(&(pixel / 8));
            assert!(!is_inside || (0..3).all(|i| a[i].abs_diff(b[i]) <= 4), "{a:?} {b:?}");
        }
    }
}
