//! Places of the target in a picture.

use std::borrow::Cow;

use glam::DVec3;
use relativity_core::math;
use relativity_render::{Method, Picture};

use super::place::{PixelPlace, ROUNDING, TargetMask};
use crate::files::exr::{Channel, Measurements, NO_ANGLE};
use crate::flags::choices::FileKind;
use crate::scene::Scene;
use crate::settings::Settings;

/// Largest difference of a component of a colour that still counts as the same.
const COLOUR_TOLERANCE: u8 = 24;
/// Greatest distance of a mark from the centre of a pixel that shows it, in pixels: a corner is 0.7 away.
const REACH_PX: f64 = 1.0;
/// Root mean square of what third differences add: u^3/6 along a row or a column, and u^2 v/2 where both
/// change, as much of it.
const CUBE_RMS: f64 = 0.018;
/// Greatest change of a change from pixel to pixel, in parts of it, for differences to say how a surface goes
/// on.
const MOST_BENT: f64 = 0.5;
/// Likewise of the change of that.
const MOST_CUBIC: f64 = 0.1;
/// Errors of places that are drawn in single precision, root mean square along an axis and in steps of f32 at
/// the greatest coordinate. Measured against the reference for packets and rays, from rest to 0.999 c, body
/// by body: 0.2 to 4. What f64 draws is rounded in the file alone.
const GRAIN_OF_F32: f64 = 2.0;
/// Rounds of Newton's method, and the step after which it is settled, px.
const ROUNDS: usize = 20;
const SETTLED_PX: f64 = 1e-9;

/// The target that is looked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target<'a> {
    /// The mark at a place on a body's surface; of one that turns with a wheel, at t' = 0.
    Point([f64; 3]),
    /// The middle of a body, by its number or by what the scene calls it.
    Body(&'a str),
    /// The middle of all pixels of a colour.
    Marker([u8; 3]),
}

impl Target<'_> {
    /// The kind of file that shows the target.
    pub const fn file_kind(self) -> FileKind {
        match self {
            Self::Point(_) | Self::Body(_) => FileKind::Exr,
            Self::Marker(_) => FileKind::Png,
        }
    }
}

/// Parses a colour of six hexadecimal digits.
pub fn colour(text: &str) -> Result<[u8; 3], String> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    let is_colour = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    let number = is_colour.then(|| u32::from_str_radix(digits, 16).ok()).flatten();
    let [_, r, g, b] = number.ok_or("write six hexadecimal digits like ff0000")?.to_be_bytes();
    Ok([r, g, b])
}

/// The pixels of `picture` that have this `colour`.
pub fn colour_in(picture: &Picture, colour: [u8; 3]) -> TargetMask {
    let is_alike = |rgba: &[u8; 4]| (0..3).all(|i| rgba[i].abs_diff(colour[i]) <= COLOUR_TOLERANCE);
    TargetMask { shows: picture.rgba.iter().map(is_alike).collect(), width: picture.size[0] as usize }
}

/// A target in a layer.
pub struct Located {
    /// The target's place in the picture; none if the eye does not see it.
    pub place: Option<PixelPlace>,
    /// Share of the outline of a body beside which more of it is hidden: by what is nearer, or by the end of
    /// the picture.
    pub hidden: f64,
}

/// Returns where `target` is in the layer of `eye`.
///
/// # Errors
///
/// A channel that is not there; a scene that cannot be had, or that has no such body.
pub fn in_layer(
    file: &Measurements,
    eye: &str,
    target: Target<'_>,
    settings: &Settings,
) -> anyhow::Result<Located> {
    let channel = |channel| file.channel(eye, channel);
    let width = file.size[0] as usize;
    let ids = channel(Channel::Id)?;
    match target {
        Target::Point(point) => {
            let rest = [channel(Channel::RestX)?, channel(Channel::RestY)?, channel(Channel::RestZ)?];
            let rest = match channel(Channel::MaterialAngle) {
                Ok(angles) if angles.iter().any(|&angle| angle != NO_ANGLE) => {
                    at_start(&settings.opened_scene()?, ids, rest, angles).map(Cow::Owned)
                }
                _ => rest.map(Cow::Borrowed),
            };
            let is_exact = settings.quality.method().is_none_or(|method| method == Method::Reference);
            let grain = if is_exact { ROUNDING } else { GRAIN_OF_F32 };
            let place = BodySurface { width, ids, rest, grain }.place(point.into());
            Ok(Located { place, hidden: 0.0 })
        }
        Target::Body(name) => {
            let body = settings.opened_scene()?.body_called(name).map_err(anyhow::Error::msg)? as f32;
            let mask = TargetMask { shows: ids.iter().map(|id| *id == body).collect(), width };
            let distances = channel(Channel::Distance)?;
            let is_nearer =
                |beside: usize, own: usize| ids[beside] >= 0.0 && distances[beside] < distances[own];
            Ok(Located { place: mask.middle(), hidden: mask.hidden_share(is_nearer) })
        }
        Target::Marker(_) => Ok(Located { place: None, hidden: 0.0 }),
    }
}

/// The places that pixels show as they are at t' = 0: of what turns with a wheel of `scene` not those at
/// `rest`, where it was as the light left, but at the `angles` that it had then.
fn at_start(scene: &Scene, ids: &[f32], rest: [&[f32]; 3], angles: &[f32]) -> [Vec<f32>; 3] {
    let mut places = rest.map(<[f32]>::to_vec);
    for (pixel, (&id, &angle)) in ids.iter().zip(angles).enumerate() {
        let body = (id >= 0.0 && angle != NO_ANGLE).then_some(id as usize);
        let Some(spin) = body.and_then(|body| scene.bodies.get(body)?.spin) else { continue };
        let [x, y, z] = rest.map(|channel| f64::from(channel[pixel]));
        let there = DVec3::new(x, y, z);
        let start = spin.turned(there, spin.angle(there) - f64::from(angle));
        for (place, value) in places.iter_mut().zip(start.to_array()) {
            place[pixel] = value as f32;
        }
    }
    places
}

/// The surface that each pixel shows: a place of a body.
struct BodySurface<'a> {
    width: usize,
    ids: &'a [f32],
    rest: [Cow<'a, [f32]>; 3],
    /// Standard deviation of a place along an axis, in steps of f32 at the greatest coordinate.
    grain: f64,
}

impl BodySurface<'_> {
    /// Returns the place where `point` is seen: from the pixel that shows the nearest place on by how the
    /// places change, and how that change changes, from pixel to pixel; `None` if that leads out of the
    /// pixel's reach.
    ///
    /// Its standard deviation is what this leaves out, over all offsets in a pixel: the third differences,
    /// or, where an outline is so near that these say nothing, all that the second make of a pixel, or the
    /// pixel.
    fn place(&self, point: DVec3) -> Option<PixelPlace> {
        let seen = (0..self.ids.len()).filter(|&pixel| self.ids[pixel] >= 0.0);
        let distance = |&pixel: &usize| self.at(pixel).distance_squared(point);
        let nearest = seen.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        let patch = self.patch(nearest)?;
        let [u, v] = patch.nearest_to(point)?;
        let (there, [across, down]) = patch.at([u, v]);
        let step = across.length().max(down.length());
        if math::hypot(u, v) > REACH_PX || (point - there).length() > REACH_PX * step {
            return None;
        }
        let mut squares = [0.0; 2];
        for left_out in patch.left_out() {
            // The pixel itself is known.
            let left_out = match left_out {
                Some(left_out) => coordinates(left_out, across, down)?.map(|part| part.abs().min(ROUNDING)),
                None => [ROUNDING; 2],
            };
            let grain = point.abs().max_element() * f64::from(f32::EPSILON) * self.grain / step;
            squares = [0, 1].map(|axis: usize| squares[axis] + left_out[axis].powi(2) + grain.powi(2));
        }
        let (column, row) = (nearest % self.width, nearest / self.width);
        let at = [column as f64 + 0.5 + u, row as f64 + 0.5 + v];
        Some(PixelPlace { at, sigma: squares.map(f64::sqrt) })
    }

    /// The surface around a pixel; none where no neighbour shows the same body.
    fn patch(&self, pixel: usize) -> Option<SurfacePatch> {
        let (column, row) = (pixel % self.width, pixel / self.width);
        let [across, down] = [self.change(pixel, column, 1)?, self.change(pixel, row, self.width)?];
        let shown = |du: isize, dv: isize| {
            let (u, v) = (column.checked_add_signed(du)?, row.checked_add_signed(dv)?);
            let other = v * self.width + u;
            (u < self.width && self.ids.get(other) == Some(&self.ids[pixel])).then(|| self.at(other))
        };
        // The mean of those of its four corners that are shown with both pixels beside them.
        let quarter = |(du, dv): (isize, isize)| {
            let twist = shown(du, dv)? - shown(du, 0)? - shown(0, dv)? + self.at(pixel);
            Some(twist * (du * dv) as f64)
        };
        let corners = [(1, 1), (1, -1), (-1, 1), (-1, -1)].into_iter();
        let of_face = corners.filter(|&(du, dv)| across.has_side(du) && down.has_side(dv));
        let twists: Vec<_> = of_face.filter_map(quarter).collect();
        let twist = twists.iter().sum::<DVec3>() / twists.len().max(1) as f64;
        Some(SurfacePatch { here: self.at(pixel), across, down, twist, is_twist_known: !twists.is_empty() })
    }

    fn at(&self, pixel: usize) -> DVec3 {
        let [x, y, z] = self.rest.each_ref().map(|channel| f64::from(channel[pixel]));
        DVec3::new(x, y, z)
    }

    /// Change of place from pixel to pixel, by the neighbours `stride` away on the same body; none without
    /// one. At an outline both neighbours are on one side; so they are beside an edge, behind which another
    /// face of the body goes elsewhere.
    fn change(&self, pixel: usize, position: usize, stride: usize) -> Option<Change> {
        let is_same = |&other: &usize| self.ids.get(other) == Some(&self.ids[pixel]);
        let before = |steps: usize| (position >= steps).then(|| pixel - steps * stride).filter(is_same);
        let is_inside = |steps: usize| stride > 1 || position + steps < self.width;
        let after = |steps: usize| is_inside(steps).then_some(pixel + steps * stride).filter(is_same);
        let here = self.at(pixel);
        let side = |neighbour: &dyn Fn(usize) -> Option<usize>| {
            [1, 2].map(|steps| neighbour(steps).map(|pixel| self.at(pixel)))
        };
        let (back, forth) = (side(&before), side(&after));
        let one_sided = [(back, -1.0), (forth, 1.0)]
            .map(|([near, far], sign)| Some(Change::on_one_side(here, near?, far, sign)));
        let ([Some(near_back), far_back], [Some(near_forth), far_forth]) = (back, forth) else {
            return one_sided.into_iter().flatten().next();
        };
        let slope = 0.5 * (near_forth - near_back);
        // Of a face alone: farther neighbours may be beyond an edge.
        let third = far_back.zip(far_forth).map(|(b, a)| 0.5 * (a - b) - (near_forth - near_back));
        let third = third.filter(|third| third.length() < MOST_CUBIC * slope.length());
        let central = Change {
            per_pixel: slope - third.unwrap_or_default() / 6.0,
            bend: Some(near_forth - here - (here - near_back)),
            third,
            sides: [true; 2],
        };
        if central.is_smooth() {
            return Some(central);
        }
        let on_a_face = one_sided.into_iter().flatten().filter(|change| change.bend.is_some());
        let flattest =
            on_a_face.min_by(|a, b| a.bend().length_squared().total_cmp(&b.bend().length_squared()));
        Some(flattest.filter(Change::is_smooth).unwrap_or(central))
    }
}

/// The change of the place shown along a row or a column.
struct Change {
    per_pixel: DVec3,
    /// Change of that change from pixel to pixel, if two neighbours show the same body.
    bend: Option<DVec3>,
    /// Change of that in turn, if two neighbours on either side do.
    third: Option<DVec3>,
    /// Whether the neighbours before and behind the pixel are on the face that it shows.
    sides: [bool; 2],
}

impl Change {
    /// By the neighbours on one side: `sign` is -1 for those before the pixel.
    fn on_one_side(here: DVec3, near: DVec3, far: Option<DVec3>, sign: f64) -> Self {
        let bend = far.map(|far| far - near - (near - here));
        let per_pixel = (near - here - 0.5 * bend.unwrap_or_default()) * sign;
        Self { per_pixel, bend, third: None, sides: [sign < 0.0, sign > 0.0] }
    }

    /// Whether the place goes on smoothly.
    fn is_smooth(&self) -> bool {
        self.bend().length() < MOST_BENT * self.per_pixel.length()
    }

    /// Whether the neighbour on this side, -1 or 1, is on the same face.
    fn has_side(&self, sign: isize) -> bool {
        self.sides[usize::from(sign > 0)]
    }

    fn bend(&self) -> DVec3 {
        self.bend.unwrap_or_default()
    }
}

/// The surface around a pixel, to second order in the offset from its middle.
struct SurfacePatch {
    here: DVec3,
    across: Change,
    down: Change,
    /// Change of the change along a row from row to row.
    twist: DVec3,
    is_twist_known: bool,
}

impl SurfacePatch {
    /// The place at an offset to the right and down, px, and how it changes there along both.
    fn at(&self, [u, v]: [f64; 2]) -> (DVec3, [DVec3; 2]) {
        let Self { here, across, down, twist, .. } = self;
        let changes = [
            across.per_pixel + across.bend() * u + *twist * v,
            down.per_pixel + down.bend() * v + *twist * u,
        ];
        let place = *here
            + across.per_pixel * u
            + down.per_pixel * v
            + across.bend() * (0.5 * u * u)
            + down.bend() * (0.5 * v * v)
            + *twist * (u * v);
        (place, changes)
    }

    /// The offset at which the place is nearest to `point`, by the method of Gauss and Newton; none if there
    /// is no such.
    fn nearest_to(&self, point: DVec3) -> Option<[f64; 2]> {
        let mut offset = [0.0_f64; 2];
        for _ in 0..ROUNDS {
            let (place, [across, down]) = self.at(offset);
            let step = coordinates(point - place, across, down)?;
            offset = [offset[0] + step[0], offset[1] + step[1]];
            if step.iter().all(|part| part.abs() < SETTLED_PX) {
                return Some(offset);
            }
        }
        None
    }

    /// What it leaves out along a row and along a column, root mean square over all offsets in a pixel: by
    /// the third differences; where an outline is so near that these say nothing, all that the second
    /// differences make of a pixel; none where there are none.
    fn left_out(&self) -> [Option<DVec3>; 2] {
        [&self.across, &self.down].map(|change| {
            let is_smooth = self.is_twist_known && change.is_smooth();
            let by_third = change.third.filter(|_| is_smooth).map(|third| third * CUBE_RMS);
            by_third.or(change.bend.map(|bend| bend * 0.5))
        })
    }
}

/// Least-squares coordinates of `offset` along `a` and `b`; none if these are parallel.
fn coordinates(offset: DVec3, a: DVec3, b: DVec3) -> Option<[f64; 2]> {
    let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
    let determinant = aa * bb - ab * ab;
    let (oa, ob) = (offset.dot(a), offset.dot(b));
    (determinant > 0.0).then(|| [(oa * bb - ob * ab) / determinant, (ob * aa - oa * ab) / determinant])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_read() {
        assert_eq!(colour("ff8000"), Ok([255, 128, 0]));
        assert_eq!(colour("#00ff01"), Ok([0, 255, 1]));
        for text in ["red", "fff", "ffff0000", "+12345", "##ff0000", "#12345", "-12345", "ff00００"] {
            assert!(colour(text).is_err(), "{text}");
        }
    }

    /// The place that a pixel of two faces shows, which meet at this column: a flat end, seen obliquely, and
    /// a side.
    fn on_two_faces(edge: f64, [u, v]: [f64; 2]) -> DVec3 {
        let depth = 1.0 + 0.004 * u + 0.003 * v;
        let (across, behind) = (u.min(edge), (u - edge).max(0.0));
        DVec3::new(0.3 * behind, 0.1 * across * depth, 0.1 * v * depth)
    }

    /// An end three or five pixels wide, between an outline and an edge: its points are found to a hundredth
    /// of a pixel, and within their sigmas.
    #[test]
    fn a_point_on_a_small_end_is_found_as_on_a_large_one() {
        let (width, height) = (24, 24);
        for (first, wide) in [(0, 3), (6, 3), (6, 5)] {
            let edge = f64::from(first + wide);
            let centre = |pixel: usize| [(pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5];
            let shown: Vec<DVec3> =
                (0..width * height).map(|pixel| on_two_faces(edge, centre(pixel))).collect();
            let is_body = |pixel: &usize| pixel % width >= first as usize;
            let ids: Vec<f32> =
                (0..width * height).map(|pixel| if is_body(&pixel) { 0.0 } else { -1.0 }).collect();
            let rest = [0, 1, 2].map(|axis| Cow::Owned(shown.iter().map(|at| at[axis] as f32).collect()));
            let surface = BodySurface { width, ids: &ids, rest, grain: ROUNDING };
            for step in 0..30 {
                let at = [
                    f64::from(first) + (0.05 + f64::from(step) / 31.0) * f64::from(wide),
                    8.2 + 0.231 * f64::from(step),
                ];
                let found = surface.place(on_two_faces(edge, at)).expect("it is seen");
                for axis in 0..2 {
                    let (off, sigma) = ((found.at[axis] - at[axis]).abs(), found.sigma[axis]);
                    assert!(off < 4.0 * sigma + 1e-6 && sigma < 0.01, "{at:?} {axis}: {off} +- {sigma}");
                }
            }
        }
    }

    #[test]
    fn coordinates_are_those_of_the_plane() {
        let (a, b) = (DVec3::new(1.0, 0.2, 0.0), DVec3::new(0.3, 0.0, 2.0));
        let [u, v] = coordinates(0.25 * a - 0.5 * b, a, b).expect("not parallel");
        assert!((u - 0.25).abs() < 1e-12 && (v + 0.5).abs() < 1e-12);
        assert_eq!(coordinates(a, b, b), None);
    }
}
