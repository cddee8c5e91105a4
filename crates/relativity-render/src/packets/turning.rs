//! Rays against bodies that turn about an axle along y: `shaders/turning.wgsl`, where the method is explained.

use super::body::{Body, Capsule, Group, Ray, Surface};
use super::ray::nearest_to;
use super::shape::{around, middle, surface};
use crate::kind::Kind;
use crate::lanes::{F, Mask, Quaternion, Simd, SimdFloat, SimdMask, V2, V3, all, clamp, select};
use crate::view::Geometry;
use crate::wheel::packed::{Shown, Turns};

/// What turns by less than this angle (radians) while a ray passes it is met in rounds from the middle; else the ray is
/// followed there first, in this many steps at most.
const SHORT: f32 = 0.4;
const MOST_STEPS: u32 = 48;
/// Most rounds, and when one is the last: what is off then is this part of the body's radius.
const MOST_ROUNDS: u32 = 6;
const SETTLED: f32 = 1e-4;

/// How a body turns.
#[derive(Debug, Clone, Copy)]
pub struct Spin<S: Simd> {
    /// The middle of the axle, from the group's.
    pub hub: V3<S>,
    /// About +y.
    pub omega: F<S>,
    /// By how much the speed of the rim is below 1, and that of a ring's outermost circle below the rim's, along the
    /// group's motion.
    pub below_light: F<S>,
    pub lag: F<S>,
}

/// By how much later places are shown than the hub, and how much earlier per step from there.
#[derive(Clone, Copy)]
struct Later<S: Simd> {
    time: F<S>,
    slowness: V3<S>,
}

/// Sine and cosine of an angle.
#[derive(Clone, Copy)]
struct Turn<S: Simd> {
    sine: F<S>,
    cosine: F<S>,
}

/// What is shown along rays, in the frame that turns.
struct CoMoving<S: Simd> {
    /// From the hub.
    place: V3<S>,
    /// How fast the place changes along the ray.
    tangent: V3<S>,
}

/// A body as it is when what is at `place`, from its middle, is shown.
#[derive(Debug, Clone, Copy)]
pub struct Standing<S: Simd> {
    pub body: Body<S>,
    pub place: V3<S>,
}

impl<S: Simd> Spin<S> {
    /// Of what the shaders have.
    #[inline(always)]
    pub fn new(simd: S, shown: &Shown) -> Self {
        let Shown { spin, rim: [below_light, lag], .. } = *shown;
        Self {
            hub: V3::of_four(simd, spin),
            omega: all(simd, spin[3]),
            below_light: all(simd, below_light),
            lag: all(simd, lag),
        }
    }
}

/// Of the place `q` from the hub.
#[inline(always)]
fn later<S: Simd>(simd: S, group: &Group, q: V3<S>, spin: &Spin<S>) -> Later<S> {
    let frame = group.frame;
    if group.geometry == Geometry::Contracted {
        // One time of the ground.
        let slowness = V3::all(simd, [frame.motion[0] * frame.speed[0], 0.0, 0.0]);
        return Later { time: -slowness.x * q.x, slowness };
    }
    let fine = V3::of_four(simd, frame.middle_fine) + spin.hub;
    later_from(V3::of_four(simd, frame.middle) + fine, q)
}

/// The same for the light to a camera event from which the hub is at `hub`.
#[inline(always)]
fn later_from<S: Simd>(hub: V3<S>, q: V3<S>) -> Later<S> {
    let largest = hub.abs().max_part().max(1e-12);
    let scaled = hub / largest;
    let reach = scaled.length();
    let towards = scaled / reach;
    let step = q / (largest * reach);
    let there = towards + step;
    let distance = there.length().max(1e-12);
    Later { time: -q.dot(towards + there) / (1.0 + distance), slowness: there / distance }
}

/// Sine and cosine within 2e-7 for moderate angles. Polynomials of S. L. Moshier's Cephes library (1989).
#[expect(clippy::excessive_precision, reason = "as they are published")]
#[inline(always)]
fn sine_cosine<S: Simd>(angle: F<S>) -> Turn<S> {
    let quarters = (angle * std::f32::consts::FRAC_2_PI).round_ties_even();
    let x = (angle - quarters * 1.570_312_5) - quarters * 4.838_267_9e-4;
    let xx = x * x;
    let sine = x + x * xx * (-0.166_666_546_11 + xx * (0.008_332_160_873_6 - xx * 0.000_195_152_958_91));
    let cosine = 1.0 - 0.5 * xx
        + xx * xx * (0.041_666_645_683 + xx * (-0.001_388_731_625_5 + xx * 0.000_024_433_157_118));
    let quarter = quarters - 4.0 * (0.25 * quarters).floor();
    let is_odd = quarter.simd_eq(1.0) | quarter.simd_eq(3.0);
    let is_reversed = quarter.simd_ge(2.0);
    let along = Turn { sine: select(is_odd, cosine, sine), cosine: select(is_odd, -sine, cosine) };
    Turn {
        sine: select(is_reversed, -along.sine, along.sine),
        cosine: select(is_reversed, -along.cosine, along.cosine),
    }
}

/// `v` turned about +y: from z towards x.
#[inline(always)]
fn about_y<S: Simd>(v: V3<S>, turn: Turn<S>) -> V3<S> {
    let Turn { sine, cosine } = turn;
    V3::new(v.x * cosine + v.z * sine, v.y, v.z * cosine - v.x * sine)
}

/// The velocity of what turns so at `q` from the hub.
#[inline(always)]
pub fn velocity_at<S: Simd>(simd: S, q: V3<S>, spin: &Spin<S>) -> V3<S> {
    V3::new(q.z, all(simd, 0.0), -q.x) * spin.omega
}

/// Where rays meet a body as it is shown.
#[inline(always)]
pub fn surface_when_shown<S: Simd>(
    simd: S,
    kind: Kind,
    turns: Turns,
    group: &Group,
    body: &Body<S>,
    ray: &Ray<S>,
    spin: &Spin<S>,
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
    group: &Group,
    body: &Body<S>,
    ray: &Ray<S>,
    spin: &Spin<S>,
) -> Surface<S> {
    let capsule = around(kind, body);
    let course = course_through(&capsule, ray, spin);
    let [from, to] = course;
    let length = to - from;
    let is_short = (spin.omega.abs() * length).simd_lt(SHORT);
    let mut start = 0.5 * (from + to);
    let mut reach = 1.5 * length;
    if !is_short.all_true() {
        let first = first_within(simd, group, &capsule, ray, spin, course, !is_short);
        start = select(is_short, start, first);
        reach = select(is_short, reach, 0.5 * SHORT / spin.omega.abs() + capsule.radius);
    }
    surface_near(simd, kind, group, body, ray, spin, start, reach)
}

/// Where on this course those rays that are `active` first come into `capsule`, which turns, or else come closest to it.
#[inline(always)]
fn first_within<S: Simd>(
    simd: S,
    group: &Group,
    capsule: &Capsule<S>,
    ray: &Ray<S>,
    spin: &Spin<S>,
    [from, to]: [F<S>; 2],
    active: Mask<S>,
) -> F<S> {
    let n = ray.direction;
    let nearest = nearest_to(spin.hub, ray);
    let beginning = capsule.place - spin.hub;
    let axis = capsule.end - capsule.place;
    let length_squared = axis.dot(axis).max(1e-30);
    let (zero, one) = (all(simd, 0.0), all(simd, 1.0));
    let (mut closest, mut least, mut s, mut active) = (from, all(simd, 1e30), from, active);
    for _ in 0..MOST_STEPS {
        let q = nearest + n * s;
        let at = co_moving(simd, group, q, n, spin);
        let along = clamp((at.place - beginning).dot(axis) / length_squared, zero, one);
        let off_axis = (at.place - beginning) - axis * along;
        let distance = off_axis.length();
        let outside = distance - capsule.radius;
        let is_closer = active & outside.simd_lt(least);
        least = select(is_closer, outside, least);
        closest = select(is_closer, s, closest);
        active &= !outside.simd_le(0.01 * capsule.radius);
        let slope = off_axis.dot(at.tangent) / distance;
        let off_axle = V2::new(q.x, q.z).length();
        let bend = spin.omega.abs() * (2.0 + spin.omega.abs() * off_axle);
        let step = (slope + (slope * slope + 2.0 * bend * outside).sqrt()) / bend;
        s = select(active, s + step, s);
        active &= !s.simd_gt(to);
        if !active.any_true() {
            break;
        }
    }
    closest
}

/// What is shown at `q`, from the hub, along rays in the direction of `n`.
#[inline(always)]
fn co_moving<S: Simd>(simd: S, group: &Group, q: V3<S>, n: V3<S>, spin: &Spin<S>) -> CoMoving<S> {
    let shown = later(simd, group, q, spin);
    let turn = sine_cosine(-spin.omega * shown.time);
    let tangent = n + velocity_at(simd, q, spin) * shown.slowness.dot(n);
    CoMoving { place: about_y(q, turn), tangent: about_y(tangent, turn) }
}

/// Between which distances from its point nearest to the hub a ray may meet what turns and is inside `capsule`.
#[inline(always)]
fn course_through<S: Simd>(capsule: &Capsule<S>, ray: &Ray<S>, spin: &Spin<S>) -> [F<S>; 2] {
    let n = ray.direction;
    let nearest = nearest_to(spin.hub, ray);
    let (place, end) = (capsule.place - spin.hub, capsule.end - spin.hub);
    let off_axle = off_axle_squared(place).max(off_axle_squared(end)).sqrt() + capsule.radius;
    let flat_squared = off_axle_squared(n).max(1e-12);
    let closest = -(nearest.x * n.x + nearest.z * n.z) / flat_squared;
    let side = nearest.x * n.z - nearest.z * n.x;
    let half_chord = ((off_axle * off_axle - side * side / flat_squared).max(0.0) / flat_squared).sqrt();
    let slope = select(n.y.simd_lt(0.0), n.y.min(-1e-9), n.y.max(1e-9));
    let low = place.y.min(end.y) - capsule.radius;
    let high = place.y.max(end.y) + capsule.radius;
    let crossings = [(low - nearest.y) / slope, (high - nearest.y) / slope];
    let first = crossings[0].min(crossings[1]);
    let last = crossings[0].max(crossings[1]);
    let (before, after) = (closest - half_chord, closest + half_chord);
    [clamp(first, before, after), clamp(last, before, after)]
}

#[inline(always)]
fn off_axle_squared<S: Simd>(v: V3<S>) -> F<S> {
    v.x * v.x + v.z * v.z
}

/// Where rays meet a body that turns, as one round after the other finds it, from `start` along the ray, counted from its
/// point nearest to the hub, and no farther from there than `reach`.
#[expect(clippy::too_many_arguments, reason = "as the shader has them, and what are constants there")]
#[inline(always)]
fn surface_near<S: Simd>(
    simd: S,
    kind: Kind,
    group: &Group,
    body: &Body<S>,
    ray: &Ray<S>,
    spin: &Spin<S>,
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
        let tangent = Ray { direction, moment, to_centre, ..*ray };
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
    body: &Body<S>,
    place: V3<S>,
    spin: &Spin<S>,
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
    group: &Group,
    body: &Body<S>,
    place: V3<S>,
    spin: &Spin<S>,
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
    Standing { body: Body { turn, ..*body }, place: there }
}

/// The Doppler factor of what is at `place`, from the body's middle, with this `normal`: that of the light received along
/// the unit vector `sight`, in the camera's frame, if it stood still, or with its own motion.
#[expect(clippy::too_many_arguments, reason = "as the shader has them, and what are constants there")]
#[inline(always)]
pub fn doppler_of<S: Simd>(
    kind: Kind,
    turns: Turns,
    group: &Group,
    body: &Body<S>,
    place: V3<S>,
    normal: V3<S>,
    sight: V3<S>,
    doppler: F<S>,
    spin: &Spin<S>,
) -> F<S> {
    let Group { frame, geometry } = *group;
    if turns == Turns::Not || geometry == Geometry::Contracted {
        return doppler;
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
