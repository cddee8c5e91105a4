//! Division of a body that is fine enough for its triangles to keep a bound on the picture.
//!
//! Between its corners a triangle is flat where the image P(u, v) of the surface is curved. Interpolation over
//! a triangle of a grid with steps g along u and h along v is off by at most
//!
//! ```text
//! (g^2 |P_uu| + 2 g h |P_uv| + h^2 |P_vv|)/8
//! ```
//!
//! A flat picture shows straight lines as such, and the second derivatives are those of the surface in space; a conformal one
//! bends them, and there they are those of the image itself.
//!
//! Each direction gets a quarter of the bound, so that the mixed term, no larger than the geometric mean of the
//! others on these shapes, has the other half. The derivatives come from second differences of the apparent
//! position in f64 at places all over the body: so the count follows from what the speed makes of the shape.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use glam::{DVec2, DVec3};
use relativity_core::math;

use super::template::Division;
use crate::camera::Gauge;
use crate::camera::mercator::{Mercator, nearest_turn};
use crate::geometry::intersect::Solid;
use crate::kinematics::spin::Spin;
use crate::scene::prepared_body::PreparedBody;
use crate::scene::wheel::packed::Turns;
use crate::view::group_view::GroupView;

/// The most segments a direction is divided into: bodies that touch the picture plane would need any number.
const MAX_SEGMENTS: f64 = 512.0;
/// Second derivatives between the samples may be this much larger than at them: with it, `tests/gpu_mesh.rs` finds
/// the bound kept at all speeds.
const SAFETY: f64 = 1.3;
/// Step of the second differences, radians or half lengths: their error is a 1e-5th of the derivative, and rounding
/// costs 1e-12 of the position.
const STEP: f64 = 1e-2;
/// Number of steps in which a body is sampled from one end to the other; one that turns is bent more in places.
const STEPS: u32 = 4;
const STEPS_TURNING: u32 = 32;
/// Share of the radius at which the rim of a wheel is sampled: a step from there is still inside.
const RIM: f64 = 0.98;
/// Angles around a body at which it is sampled, radians.
const AROUND: [f64; 4] = [0.0, FRAC_PI_2, PI, 1.5 * PI];

/// The division of `body` that keeps `bound_px` in `view`; where that would do with less, no coarser than
/// normals between corners look round.
pub fn division(body: &PreparedBody, solid: &Solid, view: &GroupView, bound_px: f64) -> Division {
    let curvature = Curvature {
        view,
        body,
        gauge: view.camera.gauge(),
        mercator: view.camera.mercator(),
        focal_length_px: view.camera.focal_length_px(),
        bound_px: 0.25 * bound_px,
    };
    let needed = || {
        let place = |own: DVec3| solid.center() + body.turn * own;
        solid
            .form
            .answers()
            .segments(&|surface| curvature.greatest(|t, angle, h| place(surface(t, angle, h))))
    };
    let Some(model) = &body.triangles else {
        let segments = needed().map(|(needed, least)| segments(needed, least));
        return Division::Shape { kind: body.kind, segments };
    };
    let needed = match body.spin.filter(|_| view.turns(body) == Turns::About) {
        Some(spin) => {
            [0, 1, 2].map(|axis| 2.0 * curvature.of_wheel(&spin, solid.center(), model.half(), axis))
        }
        None => needed().map(|(needed, _)| needed),
    };
    let most = needed.into_iter().fold(0.0, f64::max);
    Division::Model { fingerprint: model.fingerprint(), segments: segments(most, model.least_segments()) }
}

/// The number of segments, on a ladder so that bodies share templates.
fn segments(needed: f64, least: u32) -> u32 {
    let needed = needed.min(MAX_SEGMENTS).ceil().max(f64::from(least)) as u32;
    if needed <= 4 {
        return needed;
    }
    // 5, 6, 7, 8, 10, 12, 14, 16, 20, ...: steps of at most a quarter.
    let step = (needed.next_power_of_two() / 8).max(1);
    needed.next_multiple_of(step)
}

/// Curvature of images, as segments per unit of a parameter.
struct Curvature<'a> {
    view: &'a GroupView,
    body: &'a PreparedBody,
    gauge: Gauge,
    mercator: Option<Mercator>,
    focal_length_px: f64,
    bound_px: f64,
}

impl Curvature<'_> {
    /// Returns the divisions of lines along an axis through a model that turns, in a box with this middle and half these sides: around its
    /// rim and halfway there, on both sides. No place of it is beyond the rim, where there may be no slower speed than that of light.
    fn of_wheel(&self, spin: &Spin, middle: DVec3, half: DVec3, axis: usize) -> f64 {
        let along = DVec3::AXES[axis] * half;
        let hub = DVec3::from(spin.hub);
        self.greatest(|t, angle, h| {
            let (sine, cosine) = math::sin_cos(PI * t);
            let (side, share) = math::sin_cos(angle + FRAC_PI_4);
            let off_axle = spin.radius * if share > 0.0 { RIM } else { 0.5 };
            let y = middle.y + half.y.copysign(side);
            DVec3::new(hub.x + off_axle * cosine, y, hub.z + off_axle * sine) + along * h
        })
    }

    /// The most segments per unit that any place of `surface` (a place along in [-1, 1], an angle, and the
    /// step of the parameter in question) needs.
    fn greatest(&self, surface: impl Fn(f64, f64, f64) -> DVec3) -> f64 {
        let turns = self.view.corner(self.body, DVec3::ZERO).spin.is_some();
        let steps = if turns { STEPS_TURNING } else { STEPS };
        let along = (0..=steps).map(|i| f64::from(2 * i) / f64::from(steps) - 1.0);
        let places = along.flat_map(|t| AROUND.iter().map(move |turn| (t, *turn)));
        let needed = places.map(|(t, angle)| self.segments(|h| surface(t, angle, h)));
        SAFETY * needed.fold(0.0, f64::max)
    }

    /// Segments per unit of h that the curve needs at h = 0.
    fn segments(&self, curve: impl Fn(f64) -> DVec3) -> f64 {
        let [before, at, after] = [-STEP, 0.0, STEP].map(|h| self.apparent(curve(h)));
        let bend = match &self.mercator {
            Some(mercator) => bend_of_image(mercator, [before, at, after]),
            None => self.image_of_change(at, before - 2.0 * at + after),
        };
        (bend.length() / (STEP * STEP * 8.0 * self.bound_px)).sqrt()
    }

    /// Returns the apparent position of the corner at `place`; NaN outside the domain of the core, which asks for the finest division.
    fn apparent(&self, place: DVec3) -> DVec3 {
        self.view.apparent_position(self.view.corner(self.body, place)).unwrap_or(DVec3::NAN)
    }

    /// Returns the shift of an image, px, that a change of its apparent position makes.
    fn image_of_change(&self, at: DVec3, change: DVec3) -> DVec2 {
        let Gauge { right, up, forward, .. } = self.gauge;
        let depth = at.dot(forward);
        if depth <= 0.0 {
            return DVec2::ZERO;
        }
        let image = DVec2::new(at.dot(right), at.dot(up)) / depth;
        let moved = DVec2::new(change.dot(right), change.dot(up));
        (moved - image * change.dot(forward)) * (self.focal_length_px / depth)
    }
}

/// The second difference of the images of three places in a conformal picture, px.
fn bend_of_image(mercator: &Mercator, places: [DVec3; 3]) -> DVec2 {
    let [Some(before), Some(at), Some(after)] = places.map(|place| mercator.coordinates(place)) else {
        return DVec2::ZERO;
    };
    let off = |image: DVec2| DVec2::new(image.x, nearest_turn(image.y, at.y)) - at;
    (off(before) + off(after)) * mercator.px_per_unit
}
