//! The street's daylight where it falls on a surface that moves: its spectrum, at one point.
//!
//! The surface receives light of a whole hemisphere, each direction with a Doppler factor D of its own
//! ([`Facing`]): on average the spectral irradiance `D^5 E(lambda D)`, E being that of what rests.

use relativity_core::math::{exp2, log2};

use super::daylight::Facing;
use crate::colour::spectra::daylight;
use crate::kinematics::spin::{MaterialPoint, about_y};
use crate::scene::prepared_scene::PreparedScene;
use crate::view::{Appearance, View};

/// Places per octave of the wavelength: 1.5 nm apart in the middle of what eyes see.
const PER_OCTAVE: f64 = 256.0;
/// Samples of daylight within a place.
const SAMPLES: u32 = 4;
/// The ends of the data of daylight, nm.
const KNOWN_NM: [f64; 2] = [280.0, 4000.0];

/// A spectrum of daylight that falls on a surface.
///
/// # Accuracy
///
/// It is averaged over about 1/128 of an octave, 3 nm in the middle of what eyes see. A test below holds it
/// against a sum over directions, averaged so: within 1 % of its peak.
#[derive(Debug, Clone, PartialEq)]
pub struct FallingDaylight {
    /// log2 of the first wavelength, nm.
    first: f64,
    /// Spectral irradiances, in the units of daylight at rest.
    irradiances: Vec<f64>,
}

impl Facing {
    /// Returns the spectrum of the street's daylight on the surface.
    #[must_use]
    pub fn daylight(self) -> FallingDaylight {
        let reach = (self.head_on_octaves() * PER_OCTAVE).ceil();
        let shares = self.shares(-reach / PER_OCTAVE, PER_OCTAVE, 2 * reach as usize + 1);
        let [first, last] = KNOWN_NM.map(log2);
        let at_rest: Vec<_> = (0..=((last - first) * PER_OCTAVE) as usize)
            .map(|place| daylight_around(first + place as f64 / PER_OCTAVE))
            .collect();
        let mut irradiances = vec![0.0; at_rest.len() + shares.len() - 1];
        // The greatest Doppler factors, which come last, move light to the first wavelengths.
        for (place, share) in shares.iter().rev().enumerate() {
            let octaves = (reach - place as f64) / PER_OCTAVE;
            let share = share * exp2(5.0 * octaves);
            for (sum, light) in irradiances[place..].iter_mut().zip(&at_rest) {
                *sum += share * light;
            }
        }
        FallingDaylight { first: first - reach / PER_OCTAVE, irradiances }
    }
}

/// Daylight at rest, on average within half a place of 2^`octaves` nm.
fn daylight_around(octaves: f64) -> f64 {
    let offs = (0..SAMPLES).map(|sample| (f64::from(sample) + 0.5) / f64::from(SAMPLES) - 0.5);
    offs.map(|off| daylight(exp2(octaves + off / PER_OCTAVE))).sum::<f64>() / f64::from(SAMPLES)
}

impl FallingDaylight {
    /// Returns the spectral irradiance at a wavelength, nm, in the units of daylight at rest: 0 where none is
    /// known.
    #[must_use]
    pub fn at(&self, nm: f64) -> f64 {
        let place = (log2(nm) - self.first) * PER_OCTAVE;
        let last = (self.irradiances.len() - 1) as f64;
        if !(0.0..last).contains(&place) {
            return 0.0;
        }
        let [low, high] = [0, 1].map(|next| self.irradiances[place as usize + next]);
        low + (high - low) * place.fract()
    }
}

impl PreparedScene {
    /// Returns how the surface of the body of this number moves through the street's daylight at `point` when
    /// `view` shows it; `None` where it is lit as what rests, in the middle of a body, and of models, whose
    /// surface is not told by a place alone.
    #[must_use]
    pub fn facing_at(
        &self,
        view: &View,
        appearance: &Appearance,
        body: usize,
        point: MaterialPoint,
    ) -> Option<Facing> {
        let view = view.of_group(self.motion_of(body));
        if !view.is_lit_by_the_street(appearance) || self.bodies()[body].triangles.is_some() {
            return None;
        }
        let place = view.place_when_shown(point);
        let turn = point.spin.map_or(0.0, |spin| view.turn_at(&spin, place));
        let normal = about_y(self.solid(body).normal(point.rest), turn);
        let facing = Facing::new(&view, point.spin.as_ref(), place, normal);
        (normal.is_finite() && facing.rapid > 0.0).then_some(facing)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use glam::DVec3;
    use relativity_core::{Aperture, Speed};

    use super::*;
    use crate::camera::{Camera, Gaze};
    use crate::geometry::shape::Shape;
    use crate::scene::body::Body;
    use crate::view::{Colour, Geometry};

    const NM: [f64; 12] =
        [120.0, 200.0, 290.0, 350.0, 420.0, 550.0, 700.0, 940.0, 1100.0, 1500.0, 2400.0, 3500.0];

    /// The same as a sum over the directions from which light comes, in the frame of the surface.
    fn summed(beta: f64, ahead: f64, nm: f64) -> f64 {
        const STEPS: [u32; 2] = [3000, 16];
        let gamma = 1.0 / (1.0_f64 - beta * beta).sqrt();
        let normal = DVec3::new(ahead, (1.0_f64 - ahead * ahead).sqrt(), 0.0);
        let (mut sum, mut weights) = (0.0, 0.0);
        for step in 0..STEPS[0] {
            let along = 2.0 * (f64::from(step) + 0.5) / f64::from(STEPS[0]) - 1.0;
            let factor = 1.0 / (gamma * (1.0 - beta * along));
            for step in 0..STEPS[1] {
                let angle = TAU * (f64::from(step) + 0.5) / f64::from(STEPS[1]);
                let across = (1.0_f64 - along * along).sqrt();
                let towards = DVec3::new(along, across * angle.cos(), across * angle.sin());
                let weight = normal.dot(towards).max(0.0);
                sum += weight * factor.powi(5) * daylight(nm * factor);
                weights += weight;
            }
        }
        sum / weights
    }

    #[test]
    fn the_spectrum_is_a_sum_over_directions() {
        for beta in [0.01, 0.6, 0.9] {
            let gamma = 1.0 / (1.0_f64 - beta * beta).sqrt();
            for ahead in [-1.0, -0.4, 0.0, 0.7, 1.0] {
                let falling = Facing { rapid: gamma * beta, ahead }.daylight();
                let peak = falling.irradiances.iter().copied().fold(0.0, f64::max);
                for nm in NM {
                    let offs = (0..4).map(|sample| (f64::from(sample) + 0.5) / 4.0 - 0.5);
                    let around = offs.map(|off| summed(beta, ahead, nm * exp2(off / 128.0)));
                    let (found, summed) = (falling.at(nm), around.sum::<f64>() / 4.0);
                    assert!(
                        (found - summed).abs() < 0.01 * peak,
                        "{beta}, {ahead}, {nm} nm: {found} {summed}"
                    );
                }
            }
        }
    }

    /// The power of daylight in three bands of wavelengths: averaging the spectrum moves none of it to
    /// another band.
    #[test]
    fn what_rests_is_lit_by_daylight_as_it_is() {
        let falling = Facing { rapid: 0.0, ahead: 0.3 }.daylight();
        for [first, last] in [[281.0, 3990.0], [400.0, 700.0], [540.0, 560.0]] {
            let total = |of: &dyn Fn(f64) -> f64| -> f64 {
                (0..40_000).map(|step| of(first + (last - first) * f64::from(step) / 40_000.0)).sum()
            };
            let ratio = total(&|nm| falling.at(nm)) / total(&daylight);
            assert!((ratio - 1.0).abs() < 0.005, "{first} to {last} nm: {ratio}");
        }
    }

    /// The power on the front, the top and the back of a ball, from closed forms: the mean of D to the fourth
    /// over the hemisphere before each.
    #[test]
    fn a_ball_receives_the_power_of_the_closed_forms() {
        let (centre, beta) = ([3.0, 2.0, 1.0], 0.6_f64);
        let ball = Body::white(Shape::Sphere { centre, radius: 0.5 });
        let scene = PreparedScene::moving(&[ball]);
        let camera = Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 1.0, [8, 8]);
        let speed = Speed::from_beta(beta).expect("a speed");
        let view = View { camera, speed, observation_time: 0.0, geometry: Geometry::Seen };
        let appearance = Appearance { colour: Colour::StreetDaylight, ..Appearance::default() };
        let facing = |normal: DVec3| {
            let rest = DVec3::from(centre) + 0.5 * normal;
            scene.facing_at(&view, &appearance, 0, MaterialPoint { rest, spin: None })
        };
        let total = |of: &dyn Fn(f64) -> f64| -> f64 {
            (0..100_000).map(|step| of(100.0 + 0.15 * f64::from(step))).sum()
        };
        let resting = Facing { rapid: 0.0, ahead: 0.0 }.daylight();
        let at_rest = total(&|nm| resting.at(nm));
        let gamma = 1.0 / (1.0 - beta * beta).sqrt();
        let along = |beta: f64| gamma * gamma * (1.0 + beta).powi(3) * (3.0 - beta) / 3.0;
        for (normal, power) in [(DVec3::X, along(beta)), (DVec3::Z, gamma), (DVec3::NEG_X, along(-beta))] {
            let falling = facing(normal).expect("lit by the street").daylight();
            let found = total(&|nm| falling.at(nm)) / at_rest;
            assert!((found / power - 1.0).abs() < 0.005, "{normal}: {found}, not {power}");
        }
        let standing = View { speed: Speed::from_beta(0.0).expect("a speed"), ..view };
        let rest = DVec3::new(3.0, 2.0, 1.5);
        assert_eq!(scene.facing_at(&standing, &appearance, 0, MaterialPoint { rest, spin: None }), None);
    }

    #[test]
    fn no_speed_and_no_wavelength_gives_what_is_no_number() {
        for rapid in [1e-300, 1e-9, 1e3, crate::light::daylight::MOST_RAPID] {
            let falling = Facing { rapid, ahead: 0.5 }.daylight();
            for nm in [1e-300, 1.0, 550.0, 1e30, f64::INFINITY] {
                assert!(falling.at(nm).is_finite(), "{rapid}, {nm} nm");
            }
        }
    }
}
