//! Corrects what was measured at each pixel: as a picture of colours is corrected (see
//! [`crate::picture::rectify`]), but no wavelength is out of sight, and none has to be told from a hue.

use relativity_core::threads::prelude::*;

use super::hit::HitImage;
use super::pixels::{Picture, encoded, sample_grid};
use super::rectify::Rectification;
use crate::light::hatch::Hatch;
use crate::light::shade::{Received, surface_colour};
use crate::scene::pattern::SampleShifts;
use crate::scene::prepared_scene::PreparedScene;
use crate::view::Appearance;

/// Rays per corrected pixel, along each side.
const SAMPLES: u32 = 2;

/// Linear sRGB of what is no body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blank {
    /// Colour where the picture from the ground shows no body.
    pub background: [f64; 3],
    /// Colour outside the picture from the ground.
    pub outside: [f64; 3],
}

impl Rectification {
    /// The corrected picture of `hits`, which the camera on the ground measured.
    ///
    /// Wavelengths are multiplied by the D of this rectification's speed and intensities divided by D^n, as
    /// `appearance` has it: at the true speed each body has its colour at rest, at any other the rest of the
    /// Doppler effect stays. Patterns and textures are where the hits are, and `hits` are of `scene`.
    #[must_use]
    pub fn picture_of_hits(
        &self,
        hits: &HitImage,
        scene: &PreparedScene,
        appearance: &Appearance,
        blank: Blank,
    ) -> Picture {
        let [width, height] = self.rest().size;
        let hatch = Hatch::new([width, height], appearance.light);
        let colour = |place: [f64; 2]| {
            let Some(source) = self.ground_place(place) else { return blank.outside };
            let [column, row] = source.map(f64::floor);
            let index = row as usize * hits.size[0] as usize + column as usize;
            let Some(hit) = hits.hits.get(index).copied().flatten() else { return blank.background };
            let doppler_factor = self.doppler_factor([column + 0.5, row + 0.5]);
            // What is left of the hit's Doppler effect.
            let doppler_factor = hit.doppler_factor / doppler_factor;
            let paint = scene.paint_at(&hit, || SampleShifts::NOTHING);
            let rest_normal = hit.rest_normal;
            let received = Received { rest_normal, doppler_factor, facing: None, paint, place };
            let colour = surface_colour(appearance, &scene.bodies()[hit.body], received, &hatch);
            let mark = scene.mark(&hit, SampleShifts::NOTHING);
            colour.map(|part| part * mark)
        };
        let pixel = |index: u32| {
            let places = sample_grid([index % width, index / width], SAMPLES);
            let sum = places.fold([0.0; 3], |sum: [f64; 3], place| {
                let part = colour(place);
                std::array::from_fn(|i| sum[i] + part[i])
            });
            encoded(sum.map(|part| part / f64::from(SAMPLES * SAMPLES)))
        };
        Picture { size: [width, height], rgba: (0..width * height).into_par_iter().map(pixel).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Body, Camera, Gaze, Geometry, Hit, Shading, Shape, Velocity, View};
    use relativity_core::{Aperture, Speed};

    const RED_NM: f64 = 640.0;
    /// Grey, which no light of one wavelength is.
    const BLANK: Blank = Blank { background: [0.2; 3], outside: [0.4; 3] };

    fn view() -> View {
        let camera = Camera::new(
            Aperture { x: -0.05, y: 0.0, z: 0.0 },
            Gaze { azimuth: 2.2, elevation: 0.3 },
            1.2,
            [160, 120],
        );
        let speed = Speed::from_beta(0.9).expect("a speed");
        View { camera, speed, observation_time: 1.1, geometry: Geometry::Seen }
    }

    fn bodies() -> Vec<Body> {
        let sphere = |x: f64| Body::new(Shape::Sphere { centre: [x, 3.0, 1.6], radius: 0.5 }, RED_NM);
        vec![sphere(-1.2), sphere(0.0)]
    }

    fn appearance() -> Appearance {
        Appearance {
            intensity_exponent: Some(2.0),
            invisible: false,
            shading: Shading::Emission,
            ground_z: None,
            road: None,
            fronts: None,
            sky: false,
            light: false,
            ..Appearance::default()
        }
    }

    fn corrected(fitted_beta: f64) -> Picture {
        corrected_before(fitted_beta, BLANK)
    }

    fn corrected_before(fitted_beta: f64, blank: Blank) -> Picture {
        let (view, scene) = (view(), PreparedScene::moving(&bodies()));
        let hits = scene.hit_image(&view);
        let velocity = Velocity::from_beta(fitted_beta).expect("a speed");
        let rest = Rectification::rest_camera(&view.camera, &velocity);
        let rectification = Rectification::new(view.camera, rest, velocity);
        rectification.picture_of_hits(&hits, &scene, &appearance(), blank)
    }

    fn greyness(pixel: [u8; 4]) -> u8 {
        pixel[0].min(pixel[1]).min(pixel[2])
    }

    /// Pixels that show a body and nothing else, which are the same before another blank, and the largest
    /// difference of one from the colour at rest.
    fn bodies_in(fitted_beta: f64) -> (usize, u8) {
        let other = Blank { background: [0.7; 3], outside: [0.9; 3] };
        let pictures = [BLANK, other].map(|blank| corrected_before(fitted_beta, blank));
        let expected = encoded(crate::light::tone::toned(crate::colour::linear_srgb(RED_NM)));
        let both = pictures[0].rgba.iter().zip(&pictures[1].rgba);
        let full = both.filter(|(pixel, other)| pixel == other).map(|(pixel, _)| pixel);
        let difference = |pixel: &[u8; 4]| (0..3).map(|i| pixel[i].abs_diff(expected[i])).max();
        (full.clone().count(), full.filter_map(difference).max().unwrap_or(0))
    }

    #[test]
    fn the_true_speed_gives_every_body_its_colour_at_rest() {
        let (count, difference) = bodies_in(0.9);
        assert!(count > 500, "{count} pixels");
        assert!(difference <= 1, "{difference} of 255");
        let (_, difference) = bodies_in(0.7);
        assert!(difference > 30, "{difference} of 255");
    }

    #[test]
    fn the_true_speed_gives_the_outlines_of_a_camera_that_rides_along() {
        let view = view();
        let rest_camera = Rectification::rest_camera(&view.camera, &Velocity::forward(view.speed));
        let riding = View { camera: rest_camera, geometry: Geometry::Rest, ..view };
        let expected = PreparedScene::moving(&bodies()).hit_image(&riding);
        let differing = |beta: f64| {
            let pairs = corrected(beta).rgba.into_iter().zip(&expected.hits);
            let wrong = |(pixel, hit): &([u8; 4], &Option<Hit>)| {
                let outside = pixel == &encoded(BLANK.outside);
                !outside && hit.is_some() != (greyness(*pixel) < encoded(BLANK.background)[0] / 2)
            };
            pairs.filter(wrong).count()
        };
        let outline = expected.hits.iter().flatten().count() as f64;
        let length = (4.0 * std::f64::consts::PI * outline).sqrt() * 1.5;
        // The nearest pixel is at most one off along the outline.
        assert!((differing(0.9) as f64) < length, "{} for {length}", differing(0.9));
        assert!((differing(0.8) as f64) > 2.0 * length, "{} for {length}", differing(0.8));
    }
}
