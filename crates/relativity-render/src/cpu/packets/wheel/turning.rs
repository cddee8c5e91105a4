//! Rays against bodies that turn about an axle along y: `shaders/turning.wgsl`, where the method is
//! explained.

use super::course::SweptRays;
use super::spin::{PacketSpin, about_y, later, sine_cosine, velocity_at};
use crate::cpu::packets::body::{Limits, PacketBody, PacketGroup, RestRays, Surface};
use crate::cpu::packets::look::Seen;
use crate::cpu::packets::ray::{nearest_to, passage};
use crate::cpu::packets::shape::{around, middle, surface};
use crate::geometry::kind::Kind;
use crate::scene::wheel::packed::Turns;
use crate::simd::lanes::{F, Quaternion, Simd, SimdFloat, SimdMask, V2, V3, all, clamp, select, vectorized};
use crate::view::Geometry;

/// The angle, radians, below which a turning body that is no tube is met in rounds from the middle of the
/// ray's passage. Beyond it the ray is first followed to the tube around the body. Tubes are always met in
/// steps (`course.rs`).
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

/// A body that may turn, in the view of its group.
#[derive(Debug, Clone, Copy)]
pub struct TurningBody<'a, S: Simd> {
    pub kind: Kind,
    pub turns: Turns,
    pub group: PacketGroup<'a>,
    pub body: PacketBody<S>,
    pub spin: PacketSpin<S>,
}

impl<'a, S: Simd> TurningBody<'a, S> {
    /// Takes the body that is `seen`.
    #[inline(always)]
    pub fn new(simd: S, group: PacketGroup<'a>, seen: &Seen<'_>) -> Self {
        let Seen { body, turns, ref shown, .. } = *seen;
        let (kind, spin) = (body.kind, PacketSpin::new(simd, shown));
        Self { kind, turns, group, body: PacketBody::new(simd, &shown.placement), spin }
    }

    /// Returns the surface of the body where rays meet it as it is shown; if `limits` exclude it, it may be
    /// any excluded surface.
    #[inline(always)]
    pub fn surface_when_shown(&self, simd: S, ray: &RestRays<S>, limits: Option<&Limits<S>>) -> Surface<S> {
        if self.turns != Turns::About {
            return surface(simd, self.kind, &self.group, &self.body, ray, limits);
        }
        vectorized!(simd, self.surface_of_turning(simd, ray))
    }

    #[inline(always)]
    fn surface_of_turning(&self, simd: S, ray: &RestRays<S>) -> Surface<S> {
        let Self { kind, group, body, spin, .. } = self;
        let capsule = around(*kind, body);
        let course = SweptRays::new(simd, group, &capsule, ray, spin);
        if *kind == Kind::Tube {
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
        self.surface_near(simd, ray, start, reach)
    }

    /// Returns the surface of the turning body where rays meet it, found round after round from `start` along
    /// the ray, counted from its point nearest to the hub, and no farther from there than `reach`.
    #[inline(always)]
    fn surface_near(&self, simd: S, ray: &RestRays<S>, start: F<S>, reach: F<S>) -> Surface<S> {
        let Self { kind, group, body, spin, .. } = self;
        let n = ray.direction;
        let nearest = nearest_to(spin.hub, ray);
        let hub_along = spin.hub.dot(n);
        let mut s = start;
        let mut met = Surface::none(simd);
        let mut active = !crate::simd::lanes::no(simd);
        for _ in 0..MOST_ROUNDS {
            let at = co_moving(simd, group, nearest + n * s, n, spin);
            let rate = at.tangent.length().max(1e-6);
            let direction = at.tangent / rate;
            let place = spin.hub + at.place;
            let along = place.dot(direction);
            let moment = direction.cross(place);
            let to_centre = ray.to_centre + (hub_along + s) - along;
            let tangent = RestRays { direction, moment, to_centre, ..*ray };
            let mut round = surface(simd, *kind, group, body, &tangent, None);
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
            place: (spin.hub + q) - middle(*kind, body),
            normal: about_y(met.normal, turn),
            ..met
        }
    }

    /// From the hub: what is at `place`, from the body's middle.
    #[inline(always)]
    pub fn place_from_hub(&self, place: V3<S>) -> V3<S> {
        (middle(self.kind, &self.body) - self.spin.hub) + place
    }

    /// From the hub if it turns about it, as its middle does; else from the body's middle: `place`, which is
    /// from its middle as it is given.
    #[inline(always)]
    pub fn place_of_hit(&self, place: V3<S>) -> V3<S> {
        if self.turns == Turns::About { self.place_from_hub(place) } else { place }
    }

    /// The body as it is when what is at `place`, from its middle, is shown.
    #[inline(always)]
    pub fn standing(&self, simd: S, place: V3<S>) -> Standing<S> {
        let Self { kind, turns, group, body, spin } = self;
        if *turns == Turns::Not {
            return Standing { body: *body, place };
        }
        let from_hub = middle(*kind, body) - spin.hub;
        let q = from_hub + place;
        let angle = spin.omega * later(simd, group, q, spin).time;
        let half = sine_cosine(0.5 * angle);
        let zero = all(simd, 0.0);
        let by = Quaternion { v: V3::new(zero, half.sine, zero), w: half.cosine };
        let own = body.turn;
        let turn = Quaternion {
            v: own.v * by.w + by.v * own.w + by.v.cross(own.v),
            w: by.w * own.w - by.v.dot(own.v),
        };
        let there = if *turns == Turns::About { q - about_y(from_hub, sine_cosine(angle)) } else { place };
        Standing { body: PacketBody { turn, ..*body }, place: there }
    }

    /// The Doppler factor of what is at `place`, from the body's middle, with this `normal`: that of the
    /// light received along the line of sight of `ray`, in the camera's frame, if it stood still, or with its
    /// own motion.
    #[inline(always)]
    pub fn doppler(&self, place: V3<S>, normal: V3<S>, ray: &RestRays<S>) -> F<S> {
        let (PacketGroup { frame, geometry }, spin) = (self.group, &self.spin);
        if self.turns == Turns::Not || geometry == Geometry::Contracted {
            return ray.doppler;
        }
        if frame.is_oblique() {
            return ray.doppler * self.own_doppler(place, normal, ray.sight);
        }
        let [beta, one_minus_beta, per_gamma, _] = frame.speed;
        let sign = frame.motion[0];
        let n = ray.sight.reflected(sign);
        let q = self.place_from_hub(place).reflected(sign);
        let omega = sign * spin.omega;
        let rim = 1.0 - spin.below_light;
        let off_axle = off_axle(q);
        let lag = self.lag(omega, off_axle, q, normal.reflected(sign));
        // And from the lowest point of its own circle.
        let above = select(q.z.simd_lt(0.0), q.x * q.x / (off_axle - q.z), off_axle + q.z);
        let behind = lag + omega * above;
        let faster = (spin.below_light - one_minus_beta) + behind;
        let upwards = -omega * q.x * n.z * per_gamma;
        let ahead = one_minus_beta + beta * (spin.below_light + behind) + faster * n.x;
        let one_plus_x = (n.y * n.y + n.z * n.z) / (1.0 - n.x);
        let astern = one_minus_beta * (1.0 + rim - behind) + faster * one_plus_x;
        let receding = select(n.x.simd_lt(0.0), astern, ahead);
        self.dilation(lag) * per_gamma / (receding + upwards).max(1e-30)
    }

    /// The factor of the Doppler factor that the own motion of what turns has in its group: sqrt(1 -
    /// v^2)/(1 + v.n'), of light that is received along `sight` in a picture of oblique motion.
    #[inline(always)]
    fn own_doppler(&self, place: V3<S>, normal: V3<S>, sight: V3<S>) -> F<S> {
        let (PacketGroup { frame, geometry }, spin) = (self.group, &self.spin);
        let simd = sight.x.simd;
        let n =
            passage(simd, sight, geometry, frame.speed, frame.motion[0]).direction.sum_of(frame.group_axes);
        let q = self.place_from_hub(place);
        let lag = self.lag(spin.omega, off_axle(q), q, normal);
        let receding = 1.0 + velocity_at(simd, q, spin).dot(n);
        self.dilation(lag) / receding.max(1e-30)
    }

    /// The speed of the rim less that of what is at `q` from the hub, `off_axle` it, and turns by `omega`.
    #[inline(always)]
    fn lag(&self, omega: F<S>, off_axle: F<S>, q: V3<S>, normal: V3<S>) -> F<S> {
        let (rim, lag) = (1.0 - self.spin.below_light, self.spin.lag);
        let below_rim = rim - omega * off_axle;
        if self.turns != Turns::InPlace {
            return below_rim;
        }
        // A ring, from its outermost circle: 1 - cos, without the difference, of the place on its tube.
        let cosine = (normal.x * q.x + normal.z * q.z) / off_axle;
        let gap = select(cosine.simd_gt(0.0), normal.y * normal.y / (1.0 + cosine), 1.0 - cosine);
        select(self.body.form_w.simd_gt(0.0), lag + omega * self.body.radius * gap, below_rim)
    }

    /// sqrt(1 - v^2) of what is slower than the rim by `lag`.
    #[inline(always)]
    fn dilation(&self, lag: F<S>) -> F<S> {
        let rim = 1.0 - self.spin.below_light;
        let squared = self.spin.below_light * (1.0 + rim) + lag * (2.0 * rim - lag);
        squared.max(0.0).sqrt()
    }
}

/// Returns the co-moving place of what is shown at `q`, from the hub, along rays in the direction of `n`.
#[inline(always)]
fn co_moving<S: Simd>(simd: S, group: &PacketGroup, q: V3<S>, n: V3<S>, spin: &PacketSpin<S>) -> CoMoving<S> {
    let shown = later(simd, group, q, spin);
    let turn = sine_cosine(-spin.omega * shown.time);
    let tangent = n + velocity_at(simd, q, spin) * shown.slowness.dot(n);
    CoMoving { place: about_y(q, turn), tangent: about_y(tangent, turn) }
}

/// The distance of `q`, from the hub, from the axle.
#[inline(always)]
fn off_axle<S: Simd>(q: V3<S>) -> F<S> {
    V2::new(q.x, q.z).length().max(1e-30)
}
