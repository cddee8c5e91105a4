//! The rest-frame rays of pixels, and where along them things lie: `line_of_sight` of `shaders/frame.wgsl`,
//! and `shaders/rest_ray.wgsl`.

use super::body::{PacketGroup, RestRays};
use super::mercator;
use super::places::{centres, packet_places};
use crate::frame::pipeline_key::AmongOthers;
use crate::frame::uniform::FrameUniform;
use crate::simd::lanes::{F, Simd, SimdBase as _, SimdFloat, V2, V3, all, select};
use crate::view::Geometry;

/// The line of sight of a pixel's middle.
#[derive(Debug, Clone, Copy)]
pub struct PixelSight<S: Simd> {
    /// Unit vector towards the source, in the ground frame.
    pub n: V3<S>,
    /// 1/length of the unnormalised line of sight, by which steps to the next pixels are multiplied; those of
    /// a conformal picture are not.
    pub scale: F<S>,
    /// 1/cosh u in a conformal picture: the sine of the angle to the baseline.
    sech: F<S>,
}

/// The passage of lines of sight through a group.
#[derive(Debug, Clone, Copy)]
pub struct GroupPassage<S: Simd> {
    /// Unit vector towards the source in the rest frame.
    pub direction: V3<S>,
    /// Ground distance per rest-frame distance.
    pub ground_per_rest: F<S>,
    pub doppler: F<S>,
}

/// Lines of sight through the pixels of one tile. In a conformal picture columns and rows share what costs
/// most.
#[derive(Debug, Clone, Copy)]
pub struct TileSights<'a, S: Simd> {
    simd: S,
    frame: &'a FrameUniform,
    corner: [u32; 2],
    /// The shared parts, in a conformal picture.
    parts: Option<ConformalParts<S>>,
}

/// The parts of a conformal picture's lines of sight that the two columns and the four rows of a tile's
/// packets share.
#[derive(Debug, Clone, Copy)]
struct ConformalParts<S: Simd> {
    columns: [F<S>; 2],
    rows: [V3<S>; 4],
}

impl<S: Simd> ConformalParts<S> {
    /// Spreads the parts of the tile's eight columns and eight rows of pixels over its packets.
    #[inline(always)]
    fn new(simd: S, column: F<S>, row: V3<S>) -> Self {
        let mut columns = [column; 2];
        for (place, columns) in columns.iter_mut().enumerate() {
            *columns = F::from_fn(simd, |lane| column[4 * place + lane % 4]);
        }
        let mut rows = [row; 4];
        for (place, rows) in rows.iter_mut().enumerate() {
            let at = |lane: usize| 2 * place + lane / 4;
            rows.x = F::from_fn(simd, |lane| row.x[at(lane)]);
            rows.y = F::from_fn(simd, |lane| row.y[at(lane)]);
            rows.z = F::from_fn(simd, |lane| row.z[at(lane)]);
        }
        Self { columns, rows }
    }
}

impl<'a, S: Simd> TileSights<'a, S> {
    /// Prepares the lines of sight of the tile with this `corner`.
    #[inline(always)]
    pub fn new(simd: S, frame: &'a FrameUniform, corner: [u32; 2]) -> Self {
        let parts = if frame.is_conformal() {
            let centre_after = |first: u32| F::from_fn(simd, |place| (first + place as u32) as f32 + 0.5);
            let offset = conformal_from_pole(frame, [centre_after(corner[0]), centre_after(corner[1])]);
            let (column, row) = (mercator::column(frame, offset.x), mercator::row(simd, frame, offset.y));
            Some(ConformalParts::new(simd, column, row))
        } else {
            None
        };
        Self { simd, frame, corner, parts }
    }

    /// Returns the lines of sight of the packet at this place, this far from the middles of its pixels to the
    /// right and down, px.
    #[inline(always)]
    pub fn of_sample(&self, place: usize, [right, down]: [f32; 2]) -> PixelSight<S> {
        let [u, v] = centres(self.simd, packet_places(self.corner, place));
        line_of_sight(self.simd, self.frame, u + right, v + down)
    }

    /// Returns the lines of sight of the packet at this place.
    #[inline(always)]
    pub fn of_packet(&self, place: usize) -> PixelSight<S> {
        let Self { simd, frame, .. } = *self;
        if let Some(ConformalParts { columns, rows }) = &self.parts {
            return PixelSight::of_conformal(mercator::line(
                simd,
                frame,
                columns[place % 2],
                rows[place / 2],
            ));
        }
        let place = centres(simd, packet_places(self.corner, place));
        PixelSight::of_flat(simd, frame, from_pole(frame, place))
    }
}

impl<S: Simd> PixelSight<S> {
    /// Takes a conformal picture's line of sight, which is cosh u long.
    #[inline(always)]
    fn of_conformal(line: V3<S>) -> Self {
        let sech = 1.0 / line.length();
        Self { n: line * sech, scale: all(line.x.simd, 1.0), sech }
    }

    /// Returns a flat picture's line of sight `offset` pixels to the right of the pole and below it.
    #[inline(always)]
    fn of_flat(simd: S, frame: &FrameUniform, offset: V2<S>) -> Self {
        let right = V3::of_four(simd, frame.right) * offset.x;
        let down = V3::of_four(simd, frame.down) * offset.y;
        let unnormalised = V3::of_four(simd, frame.base) + right + down;
        let scale = 1.0 / unnormalised.length();
        Self { n: unnormalised * scale, scale, sech: scale }
    }
}

/// Pixels to the right of the pole and below it.
#[inline(always)]
fn from_pole<S: Simd>(frame: &FrameUniform, [u, v]: [F<S>; 2]) -> V2<S> {
    let [pole_u, pole_v, fine_u, fine_v] = frame.pole;
    V2::new((u - pole_u) - fine_u, (v - pole_v) - fine_v)
}

/// The coordinates of a conformal picture there, from those of the pole.
#[inline(always)]
fn conformal_from_pole<S: Simd>(frame: &FrameUniform, place: [F<S>; 2]) -> V2<S> {
    let V2 { x, y } = from_pole(frame, place);
    let per_px = frame.base[3];
    V2::new(x * per_px, y * -per_px)
}

/// The line of sight through any place `u` and `v` of the picture, px.
#[inline(always)]
pub fn line_of_sight<S: Simd>(simd: S, frame: &FrameUniform, u: F<S>, v: F<S>) -> PixelSight<S> {
    if frame.is_conformal() {
        let V2 { x, y } = conformal_from_pole(frame, [u, v]);
        let (column, row) = (mercator::column(frame, x), mercator::row(simd, frame, y));
        return PixelSight::of_conformal(mercator::line(simd, frame, column, row));
    }
    PixelSight::of_flat(simd, frame, from_pole(frame, [u, v]))
}

/// Returns the lines of sight through the corners of rectangles around the places `u` and `v` of the picture,
/// px, of these half widths and heights: the upper two, then the lower two.
#[inline(always)]
pub fn corner_sights<S: Simd>(
    simd: S,
    frame: &FrameUniform,
    [u, v]: [F<S>; 2],
    [half_width, half_height]: [f32; 2],
) -> [PixelSight<S>; 4] {
    let [left, right, top, bottom] = [u - half_width, u + half_width, v - half_height, v + half_height];
    if !frame.is_conformal() {
        return [
            line_of_sight(simd, frame, left, top),
            line_of_sight(simd, frame, right, top),
            line_of_sight(simd, frame, left, bottom),
            line_of_sight(simd, frame, right, bottom),
        ];
    }
    let (first, last) =
        (conformal_from_pole(frame, [left, top]), conformal_from_pole(frame, [right, bottom]));
    let [left, right] = [mercator::column(frame, first.x), mercator::column(frame, last.x)];
    let [top, bottom] = [mercator::row(simd, frame, first.y), mercator::row(simd, frame, last.y)];
    [
        PixelSight::of_conformal(mercator::line(simd, frame, left, top)),
        PixelSight::of_conformal(mercator::line(simd, frame, right, top)),
        PixelSight::of_conformal(mercator::line(simd, frame, left, bottom)),
        PixelSight::of_conformal(mercator::line(simd, frame, right, bottom)),
    ]
}

/// Returns how the line of sight `n` (unit vector) changes to the next pixel on the right and to the one
/// below, up to multiples of `n`: of a conformal picture, dn/du = b - n (n . b) without its second part, b
/// along the baseline.
#[inline(always)]
pub fn steps_but_along<S: Simd>(frame: &FrameUniform, n: V3<S>) -> [V3<S>; 2] {
    let simd = n.x.simd;
    if !frame.is_conformal() {
        return [V3::of_four(simd, frame.right), V3::of_four(simd, frame.down)];
    }
    let baseline = V3::of_four(simd, frame.clip_right);
    [baseline * frame.base[3], n.cross(baseline) * frame.base[3]]
}

/// Returns the steps of the line of `sight` to the next pixel on the right, and to the one below. In a flat
/// picture, what is along it does not count; in a conformal one it is 0, since close to the baseline it would
/// exceed what is across.
#[inline(always)]
fn steps<S: Simd>(frame: &FrameUniform, sight: PixelSight<S>) -> [V3<S>; 2] {
    let PixelSight { n, sech, .. } = sight;
    let [right, down] = steps_but_along(frame, n);
    if !frame.is_conformal() {
        return [right, down];
    }
    let baseline = V3::of_four(n.x.simd, frame.clip_right);
    let cosine = n.dot(baseline);
    let across = n - baseline * cosine;
    [(baseline * (sech * sech) - across * cosine) * frame.base[3], down]
}

/// Returns the passage of the line of sight along the unit vector `sight` through a group of this `speed`,
/// with the `sign` of its motion. In a picture of oblique motion both directions are in the axes along that.
#[inline(always)]
pub fn passage<S: Simd>(
    simd: S,
    sight: V3<S>,
    geometry: Geometry,
    speed: [f32; 4],
    sign: f32,
) -> GroupPassage<S> {
    let [beta, one_minus_beta, per_gamma, _] = speed;
    let one = all(simd, 1.0);
    match geometry {
        Geometry::Seen | Geometry::Published | Geometry::OneCone => {
            let n = sight.reflected(sign);
            let transverse_squared = n.y * n.y + n.z * n.z;
            let one_plus_x = select(n.x.simd_lt(0.0), transverse_squared / (1.0 - n.x), 1.0 + n.x);
            let reciprocal = 1.0 / (one_minus_beta + beta * one_plus_x);
            let doppler = per_gamma * reciprocal;
            let direction = V3::new((one_plus_x - one_minus_beta) * reciprocal, n.y * doppler, n.z * doppler);
            GroupPassage { direction: direction.reflected(sign), ground_per_rest: doppler, doppler }
        }
        Geometry::Contracted => {
            let flattened = V3::new(sight.x, sight.y * per_gamma, sight.z * per_gamma);
            let largest = flattened.abs().max_part();
            let scaled = flattened / largest;
            let reciprocal = 1.0 / scaled.length();
            GroupPassage {
                direction: scaled * reciprocal,
                ground_per_rest: per_gamma * reciprocal / largest,
                doppler: one,
            }
        }
        Geometry::Rest => GroupPassage { direction: sight, ground_per_rest: one, doppler: one },
    }
}

/// The rays of what is seen so.
#[inline(always)]
pub fn rest_ray<S: Simd>(simd: S, group: &PacketGroup, sight: PixelSight<S>) -> RestRays<S> {
    let PacketGroup { frame, geometry } = *group;
    let PixelSight { n, scale, .. } = sight;
    let GroupPassage { direction, ground_per_rest, doppler } =
        passage(simd, n, geometry, frame.speed, frame.motion[0]);
    let direction = if frame.is_oblique() { direction.sum_of(frame.group_axes) } else { direction };
    let centre = V3::of_four(simd, frame.middle);
    let moment = centre.cross(direction) + V3::of_four(simd, frame.middle_fine).cross(direction);
    let to_centre = centre.dot(direction);
    let steps = steps(frame, sight);
    RestRays { sight: n, scale, steps, direction, ground_per_rest, doppler, moment, to_centre }
}

/// Returns the height on the ground, from the camera, of what is at this `height` in the group's frame, at
/// `place` from its middle.
#[inline(always)]
pub fn height_on_ground<S: Simd>(group: &PacketGroup, height: F<S>, place: V3<S>) -> F<S> {
    let frame = group.frame;
    if !frame.is_oblique() {
        return height;
    }
    let from_camera = V3::of_four(height.simd, frame.middle) + place;
    height + V3::of_four(height.simd, frame.rising).dot(from_camera) + from_camera.length() * frame.rising[3]
}

/// Returns the movement of the ray's direction (rest frame) along the unit vector `across`, perpendicular to
/// it, from one pixel to the next, to the right and down.
#[inline(always)]
pub fn movement<S: Simd>(group: &PacketGroup, ray: &RestRays<S>, across: V3<S>) -> V2<S> {
    let PacketGroup { frame, geometry } = *group;
    let [beta, _, _, gamma] = frame.speed;
    let (across, direction) = if frame.is_oblique() {
        (across.in_columns(frame.group_axes), ray.direction.in_columns(frame.group_axes))
    } else {
        (across, ray.direction)
    };
    let ground = match geometry {
        Geometry::Seen | Geometry::Published | Geometry::OneCone => {
            let transverse = across.y * direction.y + across.z * direction.z;
            let along = frame.motion[0] * (beta * gamma * transverse);
            V3::new(ray.doppler * across.x - along, across.y, across.z) * ray.doppler
        }
        Geometry::Contracted => V3::new(across.x * gamma, across.y, across.z) * ray.ground_per_rest,
        Geometry::Rest => across,
    };
    let turned = (ground - ray.sight * ray.sight.dot(ground)) * ray.scale;
    let [right, down] = ray.steps;
    V2::new(turned.dot(right), turned.dot(down))
}

/// Returns the ray's closest approach to `anchor` (from the group's middle), from there.
#[inline(always)]
pub fn nearest_to<S: Simd>(anchor: V3<S>, ray: &RestRays<S>) -> V3<S> {
    -ray.direction.cross(ray.moment + anchor.cross(ray.direction))
}

/// Returns the depth, from 1 (nearest) to 0 (nothing), of what lies `beyond` the group's middle along the
/// ray. With several groups it is counted among the depths of the reference group (`others`).
#[inline(always)]
pub fn depth<S: Simd>(
    group: &PacketGroup,
    others: Option<AmongOthers>,
    ray: &RestRays<S>,
    beyond: F<S>,
) -> F<S> {
    match others {
        None => 0.5 - beyond * group.frame.middle[3],
        Some(AmongOthers { is_reference: true, .. }) => depth_in_reference(group.frame, beyond),
        Some(AmongOthers { reference, .. }) => depth_of_distance(
            group.frame,
            reference,
            (ray.to_centre + beyond) * ray.ground_per_rest,
            ray.sight,
        ),
    }
}

/// The reference group has the middle half of all depths, from 3/4 to 1/4 over twice its reach.
#[inline(always)]
fn depth_in_reference<S: Simd>(frame: &FrameUniform, beyond: F<S>) -> F<S> {
    0.5 - 0.5 * beyond * frame.reference_middle[3]
}

/// Depth of what is seen at `distance` (ground frame) along `sight`, among that of the reference group, which
/// is seen in this geometry: not that of one light cone for both eyes, whose lines of sight are curves.
#[inline(always)]
pub fn depth_of_distance<S: Simd>(
    frame: &FrameUniform,
    reference: Geometry,
    distance: F<S>,
    sight: V3<S>,
) -> F<S> {
    let simd = distance.simd;
    let sight = if frame.is_oblique() { sight.sum_of(frame.reference_axes) } else { sight };
    let reference = passage(simd, sight, reference, frame.reference_speed, frame.motion[1]);
    let to_centre = V3::of_four(simd, frame.reference_middle).dot(reference.direction);
    let reach = 0.5 / frame.reference_middle[3];
    let near = (to_centre - reach) * reference.ground_per_rest;
    let far = (to_centre + reach) * reference.ground_per_rest;
    let scale = far.max(1.0);
    let before = 1.0 - 0.25 * distance / near;
    let behind = 0.25 * scale / (scale + (distance - far));
    let among = depth_in_reference(frame, distance / reference.ground_per_rest - to_centre);
    select(distance.simd_lt(near), before, select(distance.simd_gt(far), behind, among))
}
