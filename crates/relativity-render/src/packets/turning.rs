//! Rays against bodies that turn about an axle along y: `shaders/turning.wgsl`, where the method is explained.

use super::body::{PacketBody, PacketGroup, RestRays, Surface};
use super::course::SweptRays;
use super::ray::{nearest_to, passage};
use super::shape::{around, middle, surface};
use super::spin::{PacketSpin, about_y, later, sine_cosine, velocity_at};
use crate::kind::Kind;
use crate::lanes::{F, Quaternion, Simd, SimdFloat, SimdMask, V2, V3, all, clamp, select};
use crate::view::Geometry;
use crate::wheel::packed::Turns;

/// The angle, radians, below which a turning body that is no tube is met in rounds from the middle of the ray's passage. Beyond it the
/// ray is first followed to the tube around the body. Tubes are always met in steps (`course.rs`).
const SHORT: f32 = 0.4;
/// Greatest number of rounds, and the error, as a part of the body's radius, at which a round is the last.
const MOST_ROUNDS: u32 = 6;
const SETTLED: f32 = 1e-4;

/// The co-moving place of what is shown along rays, in the frame that turns.
struct CoMoving<S: Simd> {
    /// Place from the hub.
    place: V3<S>,
    /// Change of the place along the ray.
    tangent: V3<S>,
}

/// A body as it is when what is at `place`, from its middle, is shown.
#[derive(Debug, Clone, Copy)]
pub struct Standing<S: Simd> {
    pub body: PacketBody<S>,
    pub place: V3<S>,
}

/// Returns the surface of a body where rays meet it as it is shown.
#[inline(always)]
pub fn surface_when_shown<S: Simd>(
    simd: S,
    kind: Kind,
    turns: Turns,
    group: &PacketGroup,
    body: &PacketBody<S>,
    ray: &RestRays<S>,
    spin: &PacketSpin<S>,
) -> Surface<S> {
    if turns != Turns::About {
        return surface(simd, kind, group, body, ray);
    }
    simd.vectorize(
        #[inline(always)]
        || surface_of_turning(simd, kind, group, body, ray, spin),
    )
}

#[inline(always)]
fn surface_of_turning<S: Simd>(
    simd: S,
    kind: Kind,
    group: &PacketGroup,
    body: &PacketBody<S>,
    ray: &RestRays<S>,
    spin: &PacketSpin<S>,
) -> Surface<S> {
    let capsule = around(kind, body);
    let course = SweptRays::new(simd, group, &capsule, ray, spin);
    if kind == Kind::Tube {
        return course.surface(spin);
    }
    let SweptRays { from, to, .. } = course;
    let length = to - from;
    let is_short = (spin.omega.abs() * length).simd_lt(SHORT);
    let mut start = 0.5 * (from + to);
    let mut reach = 1.5 * length;
    if !is_short.all_true() {
        let (first, _) = course.first_at_tube(!is_short);
        start = select(is_short, start, first);
        reach = select(is_short, reach, 0.5 * SHORT / spin.omega.abs() + capsule.radius);
    }
    surface_near(simd, kind, group, body, ray, spin, start, reach)
}

/// Returns the co-moving place of what is shown at `q`, from the hub, along rays in the direction of `n`.
#[inline(always)]
fn co_moving<S: Simd>(simd: S, group: &PacketGroup, q: V3<S>, n: V3<S>, spin: &PacketSpin<S>) -> CoMoving<S> {
    let shown = later(simd, group, q, spin);
    let turn = sine_cosine(-spin.omega * shown.time);
    let tangent = n + velocity_at(simd, q, spin) * shown.slowness.dot(n);
    CoMoving { place: about_y(q, turn), tangent: about_y(tangent, turn) }
}

/// Returns the surface of a turning body where rays meet it, found round after round from `start` along the ray, counted from its
/// point nearest to the hub, and no farther from there than `reach`.
#[expect(clippy::too_many_arguments, reason = "as the shader has them, and what are constants there")]
#[inline(always)]
fn surface_near<S: Simd>(
    simd: S,
    kind: Kind,
    group: &PacketGroup,
    body: &PacketBody<S>,
    ray: &RestRays<S>,
    spin: &PacketSpin<S>,
    start: F<S>,
    reach: F<S>,
) -> Surface<S> {
    let n = ray.direction;
    let nearest = nearest_to(spin.hub, ray);
    let hub_along = spin.hub.dot(n);
    let mut s = start;
    let mut met = Surface::none(simd);
    let mut active = !crate::lanes::no(simd);
    for _ in 0..MOST_ROUNDS {
        let at = co_moving(simd, group, nearest + n * s, n, spin);
        let rate = at.tangent.length().max(1e-6);
        let direction = at.tangent / rate;
        let place = spin.hub + at.place;
        let along = place.dot(direction);
        let moment = direction.cross(place);
        let to_centre = ray.to_centre + (hub_along + s) - along;
        let tangent = RestRays { direction, moment, to_centre, ..*ray };
        let mut round = surface(simd, kind, group, body, &tangent);
        let reached = clamp(s + (round.beyond - along) / rate, start - reach, start + reach);
        // The curve departs from its tangent by no more than about this.
        let off = spin.omega.abs() * (reached - s) * (reached - s);
        round.clearance -= off;
        met = Surface::select(active, &round, &met);
        s = select(active, reached, s);
        active &= !off.simd_lt(SETTLED * body.radius);
        if !active.any_true() {
            break;
        }
    }
    let q = nearest + n * s;
    let shown = later(simd, group, q, spin);
    let turn = sine_cosine(spin.omega * shown.time);
    // The outline moves by what is across the ray alone, but is shown at another time, too.
    let across = about_y(met.outward, turn);
    let outward = across + shown.slowness * across.dot(velocity_at(simd, q, spin));
    Surface {
        outward: outward - n * outward.dot(n),
        beyond: hub_along + s,
        place: (spin.hub + q) - middle(kind, body),
        normal: about_y(met.normal, turn),
        ..met
    }
}

/// From the hub if it turns about it, as its middle does; else from the body's middle: `place`, which is from its middle as
/// it is given.
#[inline(always)]
pub fn place_of_hit<S: Simd>(
    kind: Kind,
    turns: Turns,
    body: &PacketBody<S>,
    place: V3<S>,
    spin: &PacketSpin<S>,
) -> V3<S> {
    if turns == Turns::About {
        return (middle(kind, body) - spin.hub) + place;
    }
    place
}

/// The body as it is when what is at `place`, from its middle, is shown.
#[inline(always)]
pub fn standing<S: Simd>(
    simd: S,
    kind: Kind,
    turns: Turns,
    group: &PacketGroup,
    body: &PacketBody<S>,
    place: V3<S>,
    spin: &PacketSpin<S>,
) -> Standing<S> {
    if turns == Turns::Not {
        return Standing { body: *body, place };
    }
    let from_hub = middle(kind, body) - spin.hub;
    let q = from_hub + place;
    let angle = spin.omega * later(simd, group, q, spin).time;
    let half = sine_cosine(0.5 * angle);
    let zero = all(simd, 0.0);
    let by = Quaternion { v: V3::new(zero, half.sine, zero), w: half.cosine };
    let own = body.turn;
    let turn =
        Quaternion { v: own.v * by.w + by.v * own.w + by.v.cross(own.v), w: by.w * own.w - by.v.dot(own.v) };
    let there = if turns == Turns::About { q - about_y(from_hub, sine_cosine(angle)) } else { place };
    Standing { body: PacketBody { turn, ..*body }, place: there }
}

/// The Doppler factor of what is at `place`, from the body's middle, with this `normal`: that of the light received along
/// the unit vector `sight`, in the camera's frame, if it stood still, or with its own motion.
#[expect(clippy::too_many_arguments, reason = "as the shader has them, and what are constants there")]
#[inline(always)]
pub fn doppler_of<S: Simd>(
    kind: Kind,
    turns: Turns,
    group: &PacketGroup,
    body: &PacketBody<S>,
    place: V3<S>,
    normal: V3<S>,
    sight: V3<S>,
    doppler: F<S>,
    spin: &PacketSpin<S>,
) -> F<S> {
    let PacketGroup { frame, geometry } = *group;
    if turns == Turns::Not || geometry == Geometry::Contracted {
        return doppler;
    }
    if frame.is_oblique() {
        return doppler * own_doppler(kind, turns, group, body, place, normal, sight, spin);
    }
    let [beta, one_minus_beta, per_gamma, _] = frame.speed;
    let sign = frame.motion[0];
    let n = sight.reflected(sign);
    let q = ((middle(kind, body) - spin.hub) + place).reflected(sign);
    let omega = sign * spin.omega;
    let rim = 1.0 - spin.below_light;
    let off_axle = V2::new(q.x, q.z).length().max(1e-30);
    let mut lag = rim - omega * off_axle;
    if turns == Turns::InPlace {
        // A ring, from its outermost circle: 1 - cos, without the difference, of the place on its tube.
        let outward = normal.reflected(sign);
        let cosine = (outward.x * q.x + outward.z * q.z) / off_axle;
        let gap = select(cosine.simd_gt(0.0), normal.y * normal.y / (1.0 + cosine), 1.0 - cosine);
        lag = select(body.form_w.simd_gt(0.0), spin.lag + omega * body.radius * gap, lag);
    }
    // And from the lowest point of its own circle.
    let above = select(q.z.simd_lt(0.0), q.x * q.x / (off_axle - q.z), off_axle + q.z);
    let behind = lag + omega * above;
    let faster = (spin.below_light - one_minus_beta) + behind;
    let upwards = -omega * q.x * n.z * per_gamma;
    let ahead = one_minus_beta + beta * (spin.below_light + behind) + faster * n.x;
    let one_plus_x = (n.y * n.y + n.z * n.z) / (1.0 - n.x);
    let astern = one_minus_beta * (1.0 + rim - behind) + faster * one_plus_x;
    let receding = select(n.x.simd_lt(0.0), astern, ahead);
    let dilation_squared = spin.below_light * (1.0 + rim) + lag * (2.0 * rim - lag);
    dilation_squared.max(0.0).sqrt() * per_gamma / (receding + upwards).max(1e-30)
}

/// The factor of the Doppler factor that the own motion of what turns has in its group: sqrt(1 - v^2)/(1 + v.n'), of light that is
/// received along `sight` in a picture of oblique motion.
#[expect(clippy::too_many_arguments, reason = "as the shader has them, and what are constants there")]
#[inline(always)]
fn own_doppler<S: Simd>(
    kind: Kind,
    turns: Turns,
    group: &PacketGroup,
    body: &PacketBody<S>,
    place: V3<S>,
    normal: V3<S>,
    sight: V3<S>,
    spin: &PacketSpin<S>,
) -> F<S> {
    let PacketGroup { frame, geometry } = *group;
    let simd = sight.x.simd;
    let n = passage(simd, sight, geometry, frame.speed, frame.motion[0]).direction.sum_of(frame.group_axes);
    let q = (middle(kind, body) - spin.hub) + place;
    let off_axle = V2::new(q.x, q.z).length().max(1e-30);
    let rim = 1.0 - spin.below_light;
    let mut lag = rim - spin.omega * off_axle;
    if turns == Turns::InPlace {
        let cosine = (normal.x * q.x + normal.z * q.z) / off_axle;
        let gap = select(cosine.simd_gt(0.0), normal.y * normal.y / (1.0 + cosine), 1.0 - cosine);
        lag = select(body.form_w.simd_gt(0.0), spin.lag + spin.omega * body.radius * gap, lag);
    }
    let dilation_squared = spin.below_light * (1.0 + rim) + lag * (2.0 * rim - lag);
    let receding = 1.0 + velocity_at(simd, q, spin).dot(n);
    dilation_squared.max(0.0).sqrt() / receding.max(1e-30)
}
