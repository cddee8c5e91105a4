//! Comfort of fusing a pair of pictures: the disparities on the screen, as angles at the viewer.
//!
//! Of the places of all bodies ([`Shape::samples`](relativity_render::Shape::samples)) those count that lie
//! in both pictures. The difference of where one is in the left and in the right picture is
//! `u_left - u_right` across and `v_left - v_right` down; seen from a distance L a difference p is the angle
//! `2 atan(p / 2L)`. The horizontal range is that of the greatest difference across less the least, so that
//! shifting a picture does not change it; the vertical disparity is that of the largest difference down. What
//! lies behind something else counts too; the ground and the sky do not.
//!
//! About 1 degree across is comfortable (M. Lambooij et al., *Visual discomfort and visual fatigue of
//! stereoscopic displays*, J. Imaging Sci. Technol. 53, 030201, 2009), 2 can be fused at most, and 20 arcmin
//! down.

use std::f64::consts::PI;

use relativity_core::math::{atan, log10, powf};
use relativity_render::{MaterialPoint, View};

use crate::number_text;
use crate::scene::Scene;

/// Widest range across that is comfortable, and that can be fused at all, radians.
pub const RANGES: [f64; 2] = [PI / 180.0, 2.0 * PI / 180.0];
/// Largest vertical disparity that can be fused, radians.
pub const VERTICAL: f64 = PI / 540.0;

/// Greatest number of bodies that are sampled; larger scenes are strided.
const MOST_BODIES: usize = 256;

/// The disparities of a pair of pictures, radians at the viewer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comfort {
    /// From the least to the greatest horizontal disparity.
    pub range: f64,
    /// The largest vertical disparity.
    pub vertical: f64,
}

/// The verdict on a pair of pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ComfortVerdict {
    /// Comfortable for a long time.
    Comfortable,
    /// Fused with effort.
    Tiring,
    /// Few people can fuse the views.
    TooMuch,
}

impl Comfort {
    /// Returns the comfort of the `views` (left, right) of `scene`, seen from a distance of this number of
    /// their pixels, above 0. `None` where no body lies in both pictures.
    #[must_use]
    pub fn new(scene: &Scene, views: &[View; 2], distance_px: f64) -> Option<Self> {
        let stride = scene.bodies.len().div_ceil(MOST_BODIES).max(1);
        let (mut across, mut down) = ([f64::INFINITY, f64::NEG_INFINITY], 0.0_f64);
        for group in &scene.groups {
            let seen = views.map(|view| view.of_group(group.motion));
            for body in group.bodies().step_by(stride) {
                let body = &scene.bodies[body];
                for rest in body.outline().samples() {
                    let point = MaterialPoint { rest, spin: body.spin };
                    let pixel = |eye: usize| {
                        let [u, v] = views[eye].camera.pixel(seen[eye].apparent_position(point)?)?;
                        let [width, height] = views[eye].camera.size.map(f64::from);
                        ((0.0..=width).contains(&u) && (0.0..=height).contains(&v)).then_some([u, v])
                    };
                    let (Some(left), Some(right)) = (pixel(0), pixel(1)) else { continue };
                    let difference = left[0] - right[0];
                    across = [across[0].min(difference), across[1].max(difference)];
                    down = down.max((left[1] - right[1]).abs());
                }
            }
        }
        let angle = |difference: f64| 2.0 * atan(0.5 * difference / distance_px);
        let comfort = Self { range: angle(across[1] - across[0]), vertical: angle(down) };
        (across[0].is_finite() && comfort.range.is_finite() && comfort.vertical.is_finite())
            .then_some(comfort)
    }

    /// Returns the verdict and the angles behind it.
    #[must_use]
    pub fn words(self) -> String {
        let across = number_text::fixed(self.range.to_degrees(), 2);
        let down = number_text::fixed(60.0 * self.vertical.to_degrees(), 0);
        format!("{}: {across}° across, {down}′ up", self.verdict().word())
    }

    /// Returns the verdict on the pair.
    #[must_use]
    pub fn verdict(self) -> ComfortVerdict {
        let [comfortable, most] = RANGES;
        if self.range > most || self.vertical > VERTICAL {
            ComfortVerdict::TooMuch
        } else if self.range > comfortable {
            ComfortVerdict::Tiring
        } else {
            ComfortVerdict::Comfortable
        }
    }
}

impl ComfortVerdict {
    /// Returns the verdict in a word or two.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Comfortable => "comfortable",
            Self::Tiring => "tiring",
            Self::TooMuch => "too much",
        }
    }
}

/// Times that a distance is halved in search of a comfortable one.
const HALVINGS: usize = 40;

/// The widest separation of the eyes, at most `separation` and of two digits, with which the pair is
/// comfortable, where `comfort` tells how a separation is. `None` if none is narrow enough.
pub fn comfortable_separation(separation: f64, comfort: impl Fn(f64) -> Option<Comfort>) -> Option<f64> {
    let suits = |d: f64| comfort(d).is_none_or(|comfort| comfort.verdict() == ComfortVerdict::Comfortable);
    if suits(separation) {
        return Some(separation);
    }
    let (mut suitable, mut wide) = (0.0, separation);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (suitable + wide);
        *(if suits(middle) { &mut suitable } else { &mut wide }) = middle;
    }
    let rounded = floor_to_two_digits(suitable);
    (rounded > 0.0 && suits(rounded)).then_some(rounded)
}

/// The largest number of two digits up to `value`, 0 or more.
fn floor_to_two_digits(value: f64) -> f64 {
    let power = log10(value).floor() - 1.0;
    if !power.is_finite() {
        return 0.0;
    }
    // Written and read, it is the nearest to its decimal.
    let digits = (value / powf(10.0, power)).floor();
    format!("{digits}e{power}").parse().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use glam::{DQuat, DVec3};
    use relativity_render::Shape;

    use super::*;
    use crate::flags::choices::{GazeChoice, ProjectionChoice};
    use crate::flags::{FieldOfView, SpeedParameter, SpeedSetting};
    use crate::settings::{Settings, Subject};

    const ARCMIN: f64 = PI / 10_800.0;

    /// The cyclist at this beta, in pictures whose plane is parallel to its motion, with the tracked point in
    /// their middle: so wide that all of it is in them.
    fn wide(beta: f64) -> Settings {
        let mut settings = Settings { scene: "cyclist".to_owned(), ..Settings::default() };
        settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).expect("a speed");
        settings.look.projection = ProjectionChoice::Parallel;
        settings.look.gaze = GazeChoice::Point;
        settings.look.fov = FieldOfView(Some(170.0));
        settings
    }

    fn comfort(settings: &Settings, time: f64) -> Option<Comfort> {
        let scene = settings.opened_scene().expect("a preset");
        let prepared = scene.prepared();
        let subject = Subject { scene: &prepared, tracked: scene.track(None) };
        let views = settings.views(subject, time, [1000, 1000]);
        // Seen from where the camera was.
        Comfort::new(&scene, &views, views[0].camera.focal_length_px())
    }

    /// Returns x where an eye at (`eye`, 0, 0) sees a place at rest along x, by the light cone's quadratic
    /// equation.
    fn seen_x([x, y, z]: [f64; 3], eye: f64, beta: f64, time: f64) -> f64 {
        let rest = (1.0 - beta * beta).sqrt();
        let present = x * rest - eye + beta * time;
        let (a, b, c) = (1.0 - beta * beta, beta * present, present * present + y * y + z * z);
        present - beta * ((b * b + a * c).sqrt() - b) / a
    }

    /// The range across of the cyclist's middle lines, 40 places on each, in a picture plane across (0, 3,
    /// 2), arcmin.
    fn range_by_hand(beta: f64, time: f64) -> f64 {
        let scene = wide(beta).opened_scene().expect("a preset");
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for body in &scene.bodies {
            for i in 0..40 {
                let part = f64::from(i) / 39.0;
                let place = match body.shape {
                    Shape::Tube { from, to, .. } => DVec3::from(from).lerp(to.into(), part),
                    Shape::Ring { centre, axis, radius, .. } => {
                        let turn = DQuat::from_axis_angle(axis.into(), TAU * part);
                        let across = DVec3::from(axis).cross(DVec3::new(0.3, 0.5, 0.8)).normalize();
                        DVec3::from(centre) + turn * (radius * across)
                    }
                    Shape::Sphere { centre, .. } => centre.into(),
                    _ => unreachable!("a bicycle has no others"),
                };
                let depth = (3.0 * place.y + 2.0 * place.z) / 13f64.sqrt();
                let [left, right] = [-0.05, 0.05].map(|eye| seen_x(place.into(), eye, beta, time) / depth);
                range = [range[0].min(left - right), range[1].max(left - right)];
            }
        }
        (range[1] - range[0]) / ARCMIN
    }

    #[test]
    fn the_range_is_that_of_the_light_cones() {
        let seen_abreast = 13f64.sqrt();
        for (beta, time, expected) in
            [(0.0, 0.0, 31.0), (0.6, 0.0, 89.0), (0.9, seen_abreast, 44.0), (0.9, 1.2, 281.0)]
        {
            let found = comfort(&wide(beta), time).expect("it is in the pictures");
            let (range, by_hand) = (found.range / ARCMIN, range_by_hand(beta, time));
            assert!((range / by_hand - 1.0).abs() < 0.03, "{beta} {time}: {range} arcmin, by hand {by_hand}");
            assert!((by_hand / expected - 1.0).abs() < 0.04, "{by_hand}, expected {expected}");
            assert!(found.vertical < 1e-9, "{}", found.vertical);
        }
    }

    #[test]
    fn what_is_out_of_a_picture_does_not_count() {
        let mut settings = wide(0.9);
        let all = comfort(&settings, 1.2).expect("it is in the pictures");
        settings.look.fov = FieldOfView(Some(60.0));
        let most = comfort(&settings, 1.2).expect("most of it is in the pictures");
        settings.look.gaze = GazeChoice::Fixed([-90.0, 0.0]);
        assert!(most.range < 0.9 * all.range, "{} of {}", most.range, all.range);
        assert!(comfort(&settings, 1.2).is_none());
    }

    #[test]
    fn nothing_makes_it_no_number() {
        for (parameter, value) in [
            (SpeedParameter::Gamma, 1e30),
            (SpeedParameter::Beta, 0.0),
            (SpeedParameter::Beta, 1e-14),
            (SpeedParameter::Gamma, 1e12),
        ] {
            for time in [-1e12, -1.0, 0.0, 1e-300, 1e12] {
                for d in [0.0, 1e-300, 0.1, 1e6] {
                    let mut settings = wide(0.0);
                    settings.motion.speed = SpeedSetting::new(parameter, value).expect("a speed");
                    settings.motion.d = d;
                    if let Some(Comfort { range, vertical }) = comfort(&settings, time) {
                        assert!(range.is_finite() && vertical.is_finite() && range >= 0.0 && vertical >= 0.0);
                    }
                }
            }
        }
    }

    #[test]
    fn a_comfortable_separation_is_the_widest_of_two_digits() {
        let linear = |d: f64| Some(Comfort { range: 0.1 * d, vertical: 0.0 });
        let [comfortable, _] = RANGES;
        assert_eq!(comfortable_separation(0.1, linear), Some(0.1));
        assert_eq!(comfortable_separation(2.0, linear), Some(0.17));
        assert!((0.017..0.018).contains(&comfortable));
        assert_eq!(comfortable_separation(2.0, |_| None), Some(2.0));
        let hopeless = |_| Some(Comfort { range: 1.0, vertical: 0.0 });
        assert_eq!(comfortable_separation(2.0, hopeless), None);
    }

    #[test]
    fn verdicts_have_the_limits_that_are_said() {
        let verdict = |range: f64, vertical: f64| {
            Comfort { range: range.to_radians(), vertical: (vertical / 60.0).to_radians() }.verdict()
        };
        assert_eq!(verdict(0.99, 19.9), ComfortVerdict::Comfortable);
        assert_eq!(verdict(1.01, 0.0), ComfortVerdict::Tiring);
        assert_eq!([verdict(2.01, 0.0), verdict(0.0, 20.1)], [ComfortVerdict::TooMuch; 2]);
    }
}
