//! The copies of a body that are drawn in a conformal picture, which is a strip around the baseline, cut open.
//!
//! v of a corner counts from an axis, the plane through the baseline and the body's middle. Of a body around the baseline
//! triangles on the other side have corners at both ends of that count, and would be torn across the picture: the shader leaves
//! them out, and a second copy draws these alone, counted from the other side. What reaches beyond one end of the strip is drawn
//! at the other end, too.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;
use relativity_core::math::{asin, atan2, hypot, sin_cos};

use crate::camera::mercator::Mercator;
use crate::geometry::capsule::Capsule;
use crate::picture::footprint::FootprintMap;
use crate::view::Geometry;
use crate::view::group_view::GroupView;

/// The range of v in which a body is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Around {
    /// Unit vector from the baseline to the body's middle: ahead and up.
    axis: [f64; 2],
    /// The v of its middle.
    v: f64,
    /// The largest angle about the baseline between the body's middle and a point of it, radians.
    reach: f64,
    /// The range of v in the picture.
    half_height: f64,
}

/// The vertex attribute of one copy of an instance: the axis, its v, and whether only the triangles on the other side are drawn, 1 or 0.
pub type Copy = [f32; 4];

/// The attribute of the only copy in a flat picture.
pub const FLAT: Copy = [1.0, 0.0, 0.0, 0.0];

/// More than 1 px of the picture's edges: what is seen there is drawn with some room.
const ROOM: f64 = 0.1;

impl Around {
    /// Returns the range of a body whose middle appears at `middle`, in a ball around it, of which `pieces` is all; both as they are at rest.
    pub fn new(
        mercator: &Mercator,
        view: &GroupView,
        projection: &FootprintMap,
        middle: Option<DVec3>,
        ball: &Capsule,
        pieces: &[Capsule],
    ) -> Self {
        let axes = &mercator.axes;
        let flat = |place: DVec3| [place.dot(axes.forward), place.dot(axes.up)];
        let [ahead, rise] = middle.map_or([1.0, 0.0], flat);
        let rho = hypot(ahead, rise);
        let axis = if rho > 0.0 { [ahead / rho, rise / rho] } else { [1.0, 0.0] };
        let half_height = 0.5 * f64::from(view.camera.size[1]) / mercator.px_per_unit + ROOM;
        let reach = reach(mercator, view, projection, ball, pieces);
        Self { axis, v: atan2(axis[1], axis[0]), reach, half_height }
    }

    /// Returns the copies to draw.
    pub fn copies(&self) -> impl Iterator<Item = Copy> + use<> {
        let Self { axis, v, reach, half_height } = *self;
        let copy = move |turned: f64, is_other_side: bool| {
            let v = (v + turned) as f32;
            [axis[0] as f32, axis[1] as f32, v, f32::from(u8::from(is_other_side))]
        };
        let meets = move |middle: f64, half: f64| middle.abs() <= half + half_height;
        let again = [-TAU, TAU].into_iter().filter(move |turned| meets(v + turned, reach));
        let other_side =
            [0.0, -TAU].into_iter().filter(move |turned| reach >= PI && meets(v + PI + turned, FRAC_PI_2));
        let first = std::iter::once(copy(0.0, false));
        first
            .chain(again.map(move |turned| copy(turned, false)))
            .chain(other_side.map(move |turned| copy(turned, true)))
    }
}

/// Returns the farthest angle from its middle at which a body in this ball can be seen; pi if it may be around the baseline.
fn reach(
    mercator: &Mercator,
    view: &GroupView,
    projection: &FootprintMap,
    ball: &Capsule,
    pieces: &[Capsule],
) -> f64 {
    let right = mercator.axes.right;
    let flat = |place: DVec3| place.reject_from_normalized(right);
    // Along the motion nothing changes what is across.
    if right.x.abs() == 1.0 && view.velocity.along_x().is_some() {
        let k = ball.radius / flat(ball.from - view.origin).length();
        if k < 1.0 {
            return 2.0 * asin(k);
        }
        return if is_beside(view, pieces) { FRAC_PI_2 } else { PI };
    }
    if matches!(view.geometry, Geometry::Published | Geometry::OneCone) {
        return PI;
    }
    let center = view.along_motion_from_camera(ball.from);
    let image = projection.apparent_centre(center, ball.radius);
    let k = image.map_or(1.0, |image| ball.radius / flat(view.velocity.camera_from_motion(image)).length());
    if k < 1.0 { 2.0 * asin(k) } else { PI }
}

/// Number of directions in which a body's extent beside the line through the eye along x is tested.
const DIRECTIONS: u32 = 32;

/// Whether all `pieces` are on one side of the line through the eye along x.
fn is_beside(view: &GroupView, pieces: &[Capsule]) -> bool {
    (0..DIRECTIONS).any(|i| {
        let (sine, cosine) = sin_cos(TAU * f64::from(i) / f64::from(DIRECTIONS));
        let direction = DVec3::new(0.0, cosine, sine);
        let is_there = |end: DVec3, radius: f64| (end - view.origin).dot(direction) > radius;
        pieces.iter().all(|piece| is_there(piece.from, piece.radius) && is_there(piece.to, piece.radius))
    })
}
