//! Rays as the curves that they are in the frame that turns with a body, and where these first enter a tube:
//! `shaders/course.wgsl`, where the method is explained.

use super::spin::{PacketSpin, SineCosine, about_y, later, sine_cosine, velocity_at};
use crate::cpu::packets::body::{PacketCapsule, PacketGroup, RestRays, Surface};
use crate::cpu::packets::ray::nearest_to;
use crate::simd::lanes::{F, Mask, Simd, SimdFloat, SimdMask, V3, all, clamp, select};

/// The limit of steps to an entry. Of 58 million rays (`tests/spokes.rs`) none took more than half.
const MOST_STEPS: u32 = 64;
/// A ray is at a tube within the first part of the tube's radius plus the second part of its reach from the
/// axle, which rounding takes.
const AT_TUBE: f32 = 1e-4;
const ROUNDING: f32 = 1e-7;
/// Steps to where a ray passes that does not enter.
const PASSING_STEPS: u32 = 2;

/// A ray among what a tube sweeps, from its point nearest to the hub.
pub struct SweptRays<'a, S: Simd> {
    capsule: &'a PacketCapsule<S>,
    /// The capsule's one end, from the hub, and the way from there to its other end.
    beginning: V3<S>,
    axis: V3<S>,
    direction: V3<S>,
    nearest: V3<S>,
    /// Between which distances along the ray it may meet the tube.
    pub from: F<S>,
    pub to: F<S>,
    /// The angle by which the ray is turned back at `from`, and its change per distance.
    turn: F<S>,
    rate: F<S>,
    /// The time by which places are shown earlier, per step from there.
    slowness: V3<S>,
    /// The curve is no faster, and not bent more.
    speed: F<S>,
    bend: F<S>,
    at_tube: F<S>,
}

/// A place on a course.
struct CoursePlace<S: Simd> {
    turn: SineCosine<S>,
    /// From the tube's axis, and how fast and with which acceleration that changes.
    off: V3<S>,
    velocity: V3<S>,
    acceleration: V3<S>,
    distance: F<S>,
}

impl<'a, S: Simd> SweptRays<'a, S> {
    /// Follows `ray` past the turning `capsule`.
    #[inline(always)]
    pub fn new(
        simd: S,
        group: &PacketGroup,
        capsule: &'a PacketCapsule<S>,
        ray: &RestRays<S>,
        spin: &PacketSpin<S>,
    ) -> Self {
        let n = ray.direction;
        let nearest = nearest_to(spin.hub, ray);
        let (beginning, end) = (capsule.place - spin.hub, capsule.end - spin.hub);
        let off_axle = off_axle_squared(beginning).max(off_axle_squared(end)).sqrt() + capsule.radius;
        let flat_squared = off_axle_squared(n).max(1e-12);
        let closest = -(nearest.x * n.x + nearest.z * n.z) / flat_squared;
        let side = nearest.x * n.z - nearest.z * n.x;
        let half_chord = ((off_axle * off_axle - side * side / flat_squared).max(0.0) / flat_squared).sqrt();
        let slope = select(n.y.simd_lt(0.0), n.y.min(-1e-9), n.y.max(1e-9));
        let low = beginning.y.min(end.y) - capsule.radius;
        let high = beginning.y.max(end.y) + capsule.radius;
        let crossings = [(low - nearest.y) / slope, (high - nearest.y) / slope];
        let (before, after) = (closest - half_chord, closest + half_chord);
        let camera = -(ray.to_centre + spin.hub.dot(n));
        let to = clamp(crossings[0].max(crossings[1]), before, after);
        let from = clamp(crossings[0].min(crossings[1]), before, after).max(camera).min(to);
        let shown = later(simd, group, nearest + n * from, spin);
        let rate = spin.omega * shown.slowness.dot(n);
        let flat = flat_squared.sqrt();
        let own_speed = rate.abs() * off_axle;
        Self {
            capsule,
            beginning,
            axis: end - beginning,
            direction: n,
            nearest,
            from,
            to,
            turn: -spin.omega * shown.time,
            rate,
            slowness: shown.slowness,
            speed: (n.y * n.y + (flat + own_speed) * (flat + own_speed)).sqrt(),
            bend: rate.abs() * (flat * 2.0 + own_speed),
            at_tube: capsule.radius * AT_TUBE + off_axle * ROUNDING,
        }
    }

    #[inline(always)]
    fn at(&self, s: F<S>) -> CoursePlace<S> {
        let simd = s.simd;
        let (zero, one, rate) = (all(simd, 0.0), all(simd, 1.0), self.rate);
        let turn = sine_cosine(self.turn + rate * (s - self.from));
        let (n, q) = (self.direction, self.nearest + self.direction * s);
        let across = V3::new(q.z, zero, -q.x);
        let outward = V3::new(q.x, zero, q.z);
        let from_beginning = about_y(q, turn) - self.beginning;
        let velocity = about_y(n + across * rate, turn);
        let acceleration = about_y(V3::new(n.z, zero, -n.x) * (rate * 2.0) - outward * (rate * rate), turn);
        let axis = self.axis;
        let per_length_squared = 1.0 / axis.dot(axis).max(1e-30);
        let along = from_beginning.dot(axis) * per_length_squared;
        let off = from_beginning - axis * clamp(along, zero, one);
        // Beside the axis what is along it does not count.
        let is_beside = along.simd_gt(0.0) & along.simd_lt(1.0);
        let beside = axis * select(is_beside, per_length_squared, zero);
        CoursePlace {
            turn,
            off,
            velocity: velocity - beside * velocity.dot(axis),
            acceleration: acceleration - beside * acceleration.dot(axis),
            distance: off.length(),
        }
    }

    /// Returns where the `active` rays first reach the tube, or else come closest to it, and which of them
    /// reach it.
    #[inline(always)]
    pub fn first_at_tube(&self, active: Mask<S>) -> (F<S>, Mask<S>) {
        let simd = self.from.simd;
        let mut closest = (self.from + self.to) * 0.5;
        let mut least = self.at(closest).distance;
        let mut enters = crate::simd::lanes::no(simd);
        // Where the middle is farther off than the curve goes from there, all of it is.
        let outside = least - self.capsule.radius;
        let mut active = active & outside.simd_le((self.to - self.from) * self.speed * 0.5);
        let radius_squared = self.capsule.radius * self.capsule.radius;
        let mut s = self.from;
        for _ in 0..MOST_STEPS {
            if !active.any_true() {
                break;
            }
            let at = self.at(s);
            let is_closer = active & at.distance.simd_lt(least);
            least = select(is_closer, at.distance, least);
            closest = select(is_closer, s, closest);
            let outside = (at.distance - self.capsule.radius).max(0.0);
            let slope = at.off.dot(at.velocity) / at.distance.max(1e-30);
            let root = (slope * slope + self.bend * outside * 2.0).sqrt();
            let step = select(
                slope.simd_gt(0.0),
                (slope + root) / self.bend.max(1e-30),
                outside * 2.0 / (root - slope).max(1e-30),
            );
            let is_at = active & outside.simd_le(self.at_tube);
            if is_at.any_true() {
                // What only grazes it may enter later.
                let is_on_its_way = slope.simd_lt(0.0) & at.miss_squared().simd_lt(radius_squared);
                let is_in = is_at & (outside.simd_le(0.0) | is_on_its_way);
                enters |= is_in;
                active &= !is_in;
            }
            s = select(active, s + step, s);
            active &= !s.simd_gt(self.to);
        }
        (select(enters, s, closest), enters)
    }

    /// Returns where rays meet the tube that fills the capsule.
    #[inline(always)]
    pub fn surface(&self, spin: &PacketSpin<S>) -> Surface<S> {
        let simd = self.from.simd;
        let radius = self.capsule.radius;
        let (mut s, enters) = self.first_at_tube(!crate::simd::lanes::no(simd));
        let mut at = self.at(s);
        for _ in 0..PASSING_STEPS {
            if enters.all_true() {
                break;
            }
            let passed = clamp(s + at.to_closest(), self.from - radius, self.to + radius);
            s = select(enters, s, passed);
            at = self.at(s);
        }
        // As the parabola through the entry has it.
        let to_closest = at.to_closest();
        let closest = at.off + (at.velocity + at.acceleration * (to_closest * 0.5)) * to_closest;
        let inside = radius - at.miss_squared().sqrt();
        let clearance = select(enters, inside, (radius - at.distance).min(0.0));
        let back = SineCosine { sine: -at.turn.sine, cosine: at.turn.cosine };
        let q = self.nearest + self.direction * s;
        // The outline moves by what is across the ray alone, but is shown at another time, too.
        let across = about_y(closest / closest.length().max(1e-30), back);
        let outward = across + self.slowness * across.dot(velocity_at(simd, q, spin));
        let n = self.direction;
        Surface {
            clearance,
            half_width: radius,
            outward: outward - n * outward.dot(n),
            beyond: spin.hub.dot(n) + s,
            place: (spin.hub + q) - (self.capsule.place + self.capsule.end) * 0.5,
            normal: about_y(at.off / at.distance.max(1e-30), back),
        }
    }
}

impl<S: Simd> CoursePlace<S> {
    /// The second derivative of half the distance squared.
    #[inline(always)]
    fn growth(&self) -> F<S> {
        self.velocity.dot(self.velocity) + self.off.dot(self.acceleration)
    }

    /// Returns the square of the least distance by the parabola through this place: 0 where it bends inwards.
    #[inline(always)]
    fn miss_squared(&self) -> F<S> {
        let least = self.distance * self.distance + self.off.dot(self.velocity) * self.to_closest();
        select(self.growth().simd_gt(0.0), least.max(0.0), all(least.simd, 0.0))
    }

    /// Returns the way from here to where the ray is closest to the axis, by Newton's method; 0 where that
    /// would be the farthest place.
    #[inline(always)]
    fn to_closest(&self) -> F<S> {
        let growth = self.growth();
        let is_least = growth.simd_gt(0.0);
        select(is_least, -self.off.dot(self.velocity) / growth.max(1e-30), all(growth.simd, 0.0))
    }
}

#[inline(always)]
fn off_axle_squared<S: Simd>(v: V3<S>) -> F<S> {
    v.x * v.x + v.z * v.z
}
