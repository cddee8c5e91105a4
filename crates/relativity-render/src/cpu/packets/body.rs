//! A body, a ray, and where they meet, as `shaders/body.wgsl` has them.

use crate::frame::uniform::FrameUniform;
use crate::scene::prepared_body::Placement;
use crate::simd::lanes::{F, Mask, Quaternion, Simd, SimdFloat, SimdMask, V3, all, select};
use crate::view::Geometry;

/// The view of a group, in the units of the shaders.
#[derive(Debug, Clone, Copy)]
pub struct PacketGroup<'a> {
    pub frame: &'a FrameUniform,
    pub geometry: Geometry,
}

/// A body, the same for all pixels but for its turn.
#[derive(Debug, Clone, Copy)]
pub struct PacketBody<S: Simd> {
    /// From the middle of its group: its centre, or one end of a tube.
    pub place: V3<S>,
    /// Radius; for a body with flat faces the least of its half lengths.
    pub radius: F<S>,
    /// The other end of a tube; a ring's unit axis; half the lengths of a body with flat faces along its own
    /// axes.
    pub form: V3<S>,
    /// Radius of a ring's middle circle.
    pub form_w: F<S>,
    /// From its own axes to those of the rest frame.
    pub turn: Quaternion<S>,
}

/// The rest-frame rays of the pixels.
#[derive(Debug, Clone, Copy)]
pub struct RestRays<S: Simd> {
    /// Unit vector towards the source, in the ground frame.
    pub sight: V3<S>,
    /// 1/length of the unnormalised line of sight.
    pub scale: F<S>,
    /// Changes of the unnormalised line of sight to the next pixel on the right, and to the one below. In a
    /// flat picture the component along the line of sight does not count.
    pub steps: [V3<S>; 2],
    /// Unit vector towards the source in the rest frame.
    pub direction: V3<S>,
    /// Ground distance per rest-frame distance.
    pub ground_per_rest: F<S>,
    pub doppler: F<S>,
    /// Middle of the group: its moment about the ray, and its distance along it.
    pub moment: V3<S>,
    pub to_centre: F<S>,
}

/// A tube with rounded ends.
#[derive(Debug, Clone, Copy)]
pub struct PacketCapsule<S: Simd> {
    pub place: V3<S>,
    pub end: V3<S>,
    pub radius: F<S>,
}

/// The surface where rays meet a body, or the distance at which they pass.
#[derive(Debug, Clone, Copy)]
pub struct Surface<S: Simd> {
    /// Depth of the ray inside the outline, as a rest-frame length at the surface; negative outside.
    pub clearance: F<S>,
    /// Half the least width that the body is seen with.
    pub half_width: F<S>,
    /// From the body to the ray where they come closest, across the outline.
    pub outward: V3<S>,
    /// Rest-frame distance along the ray beyond the middle of its group.
    pub beyond: F<S>,
    /// The point, from the body's middle.
    pub place: V3<S>,
    pub normal: V3<S>,
}

/// The limits within which a surface may change a packet.
#[derive(Debug, Clone, Copy)]
pub struct Limits<S: Simd> {
    /// Width of a pixel per distance, with what is widened into it.
    pub pixel: F<S>,
    /// Distance beyond the middle of the group behind which each pixel is covered.
    pub farthest: F<S>,
}

impl<S: Simd> Limits<S> {
    /// Whether a surface with this `clearance`, this far `beyond`, is outside all pixels, covered in them or
    /// behind the camera.
    #[inline(always)]
    pub fn exclude(&self, ray: &RestRays<S>, clearance: F<S>, beyond: F<S>) -> bool {
        let distance = ray.to_centre + beyond;
        // Farther outside than a pixel it is in no sample, and not widened into one.
        let is_inside = (clearance + distance.max(0.0) * self.pixel).simd_gt(0.0);
        let is_in_sight = is_inside & distance.simd_gt(0.0) & !beyond.simd_gt(self.farthest);
        !is_in_sight.any_true()
    }
}

impl<S: Simd> PacketBody<S> {
    /// Loads the shaders' data of a body.
    #[inline(always)]
    pub fn new(simd: S, placement: &Placement) -> Self {
        let Placement { place_radius, form, turn } = *placement;
        Self {
            place: V3::of_four(simd, place_radius),
            radius: all(simd, place_radius[3]),
            form: V3::of_four(simd, form),
            form_w: all(simd, form[3]),
            turn: Quaternion::all(simd, turn),
        }
    }

    /// From the body's own axes to those of the rest frame.
    #[inline(always)]
    pub fn rest_from_body(&self, v: V3<S>) -> V3<S> {
        self.turn.turned(v)
    }

    /// Turns a vector from the rest frame into the body's own axes.
    #[inline(always)]
    pub fn body_from_rest(&self, v: V3<S>) -> V3<S> {
        self.turn.conjugate().turned(v)
    }

    /// Half its lengths along its own axes, of a body with flat faces: at least `radius`, which is raised
    /// where it is drawn a pixel wide.
    #[inline(always)]
    pub fn halves(&self) -> V3<S> {
        self.form.max(V3::new(self.radius, self.radius, self.radius))
    }
}

impl<S: Simd> Surface<S> {
    /// Nothing but zeros, to begin with.
    #[inline(always)]
    pub fn none(simd: S) -> Self {
        let zero = all(simd, 0.0);
        let origin = V3::new(zero, zero, zero);
        Self {
            clearance: zero,
            half_width: zero,
            outward: origin,
            beyond: zero,
            place: origin,
            normal: origin,
        }
    }

    /// Returns a surface outside all pixels.
    #[inline(always)]
    pub fn excluded(simd: S) -> Self {
        Self { clearance: all(simd, f32::NEG_INFINITY), ..Self::none(simd) }
    }

    /// `value` where it holds, else `other`.
    #[inline(always)]
    pub fn select(holds: Mask<S>, value: &Self, other: &Self) -> Self {
        Self {
            clearance: select(holds, value.clearance, other.clearance),
            half_width: select(holds, value.half_width, other.half_width),
            outward: V3::select(holds, value.outward, other.outward),
            beyond: select(holds, value.beyond, other.beyond),
            place: V3::select(holds, value.place, other.place),
            normal: V3::select(holds, value.normal, other.normal),
        }
    }
}

/// Rays in the own axes of a body, from its `place`: each is nearest + s direction, and moment their cross
/// product.
#[derive(Debug, Clone, Copy)]
pub struct OwnRay<S: Simd> {
    pub direction: V3<S>,
    pub moment: V3<S>,
    pub nearest: V3<S>,
}

#[inline(always)]
pub fn own_ray<S: Simd>(simd: S, body: &PacketBody<S>, ray: &RestRays<S>) -> OwnRay<S> {
    let direction = body.body_from_rest(ray.direction);
    // A ray that passes farther off than bodies are large misses: nearer, no product of its distances
    // overflows.
    let far = V3::all(simd, [1e15; 3]);
    let moment = body.body_from_rest(ray.moment + body.place.cross(ray.direction)).clamp(-far, far);
    OwnRay { direction, moment, nearest: moment.cross(direction) }
}
