//! Sky and resting ground, as `shaders/backdrop.wgsl` has them.

use super::contact::left_by_contacts;
use super::house_fronts::{CoveredRange, front};
use crate::cpu::packets::light::tables::{Tables, on_screen, toned, untoning};
use crate::cpu::packets::logarithm::{log2, power_of_two};
use crate::cpu::packets::ray::{GroupPassage, PixelSight, line_of_sight, passage, steps_but_along};
use crate::frame::uniform::FrameUniform;
use crate::light::palette::Row;
use crate::light::street_light::{DAYLIT_ROW, FALSE_ROW};
use crate::simd::lanes::{
    F, Mask, Simd, SimdBase as _, SimdFloat as _, SimdMask as _, V2, V3, all, clamp, select,
};
use crate::street::backdrop::{
    AXIS_HALF_WIDTH, BackdropPart, DASH, Floor, GRID_FADE, KERB_WIDTH, LANE_HALF_WIDTH, LEAST_TOWARDS_FRONTS,
    LINE_HALF_WIDTH, SKY_RISE,
};
use crate::street::sight::StreetVariant;
use crate::view::Geometry;

/// Lines of sight that fall less do not meet the ground.
const LEAST_FALL: f32 = -1e-6;

/// Margin around a rectangle, px.
const MARGIN: f32 = 2.0;

/// Returns the part of the backdrop that a rectangle of the picture can show: its left and upper edge, and
/// its width and height, px.
#[inline(always)]
pub fn part<S: Simd>(
    simd: S,
    frame: &FrameUniform,
    [left, top]: [f32; 2],
    [width, height]: [f32; 2],
) -> BackdropPart {
    let floor = frame.floor();
    if floor == Floor::Open {
        return BackdropPart::Sky;
    }
    // The plane of the ground is a bowl to whoever does not move along it.
    if frame.is_street_oblique() {
        return floor.whole();
    }
    // As `shows` of the shader has it, which says why; a pixel's middle shows what is around it, too.
    let ([left, top], [width, height]) =
        ([left - MARGIN, top - MARGIN], [width + 2.0 * MARGIN, height + 2.0 * MARGIN]);
    let [_, _, ground, _] = frame.ground;
    let u = F::from_fn(simd, |lane| left + [0.0, width][lane % 2]);
    let v = F::from_fn(simd, |lane| top + [0.0, height][lane / 2 % 2]);
    let sight = line_of_sight(simd, frame, u, v).n;
    let (towards, rise) = (sight.y, sight.z);
    let above = rise * frame.road[2] - towards * ground;
    let [highest, lowest, ..] = frame.houses.map(|house| house[0]);
    // Between the corners rows of a conformal picture may bulge by the square of the height.
    let rows = if frame.is_conformal() { height * frame.base[3] } else { 0.0 };
    let bulge = rows * rows;
    let room = bulge * (frame.road[2] + ground.abs() + highest);
    let is_beside = towards.simd_le(-bulge).all_true()
        || above.simd_lt(-room).all_true()
        || above.simd_gt(towards * highest + room).all_true();
    let has_fronts = floor == Floor::Street && !is_beside;
    let is_covered = has_fronts
        && towards.simd_gt(0.01 + bulge).all_true()
        && above.simd_gt(room).all_true()
        && above.simd_lt(towards * lowest - room).all_true();
    let has_ground = !rise.simd_ge(bulge).all_true() && !is_covered;
    match (has_ground, has_fronts, floor) {
        (false, false, _) => BackdropPart::Sky,
        (false, true, _) => BackdropPart::Fronts,
        (true, true, _) => BackdropPart::Street,
        (true, false, Floor::Grid | Floor::Open) => BackdropPart::Grid,
        (true, false, Floor::Road | Floor::Street) => BackdropPart::Road,
    }
}

/// Lines of sight on the ground: see [`StreetSight`](crate::street::sight::StreetSight).
#[derive(Clone, Copy)]
struct StreetLines<S: Simd> {
    /// Unit vectors along the lines.
    n: V3<S>,
    /// Factor of steps to the next pixels.
    scale: F<S>,
    /// The part of a distance by which haze counts.
    haze_share: F<S>,
    doppler: F<S>,
    /// The camera's lines of sight.
    sight: V3<S>,
    /// The same, in axes along the street's motion where that is oblique.
    seen: V3<S>,
}

impl<S: Simd> StreetLines<S> {
    #[inline(always)]
    fn new(simd: S, frame: &FrameUniform, sight: PixelSight<S>) -> Self {
        let PixelSight { n, scale, .. } = sight;
        let one = all(simd, 1.0);
        let Some(geometry) = street_geometry(frame) else {
            return Self { n, scale, haze_share: one, doppler: one, sight: n, seen: n };
        };
        let is_oblique = frame.is_street_oblique();
        let seen = if is_oblique { n.sum_of(frame.to_street) } else { n };
        let GroupPassage { direction, ground_per_rest, doppler } =
            passage(simd, seen, geometry, frame.street_speed, frame.street_motion[0]);
        let haze_share = ground_per_rest.min(one);
        let on_ground = if is_oblique { direction.sum_of(frame.street_axes) } else { direction };
        Self { n: on_ground, scale: scale * ground_per_rest, haze_share, doppler, sight: n, seen }
    }

    /// Steps to the pixels on the right and below, up to multiples of the lines.
    #[inline(always)]
    fn steps(&self, frame: &FrameUniform) -> [V3<S>; 2] {
        let [right, down] = steps_but_along(frame, self.sight);
        if street_geometry(frame).is_none() {
            return [right, down];
        }
        [self.step_on_ground(frame, right), self.step_on_ground(frame, down)]
    }

    /// The step on the ground for one of the camera's lines of sight, lines on the ground being (Gamma
    /// (`n_x` + V |n|), `n_y`, `n_z`).
    #[inline(always)]
    fn step_on_ground(&self, frame: &FrameUniform, step: V3<S>) -> V3<S> {
        let [beta, _, _, gamma] = frame.street_speed;
        let sign = frame.street_motion[0];
        let velocity = if street_geometry(frame) == Some(Geometry::Seen) { sign * beta } else { 0.0 };
        let is_oblique = frame.is_street_oblique();
        let step = if is_oblique { step.sum_of(frame.to_street) } else { step };
        let on_ground = V3::new((step.x + self.seen.dot(step) * velocity) * gamma, step.y, step.z);
        if is_oblique { on_ground.sum_of(frame.street_axes) } else { on_ground }
    }
}

/// The geometry that shows a street which moves against the camera.
#[inline(always)]
fn street_geometry(frame: &FrameUniform) -> Option<Geometry> {
    match frame.street() {
        StreetVariant::AtRest => None,
        StreetVariant::Contracted => Some(Geometry::Contracted),
        StreetVariant::Painted | StreetVariant::Daylit | StreetVariant::FalseColours => Some(Geometry::Seen),
    }
}

/// Colours at rest, and the share of the sky's own light in them.
#[derive(Clone, Copy)]
struct AtRest<S: Simd> {
    colour: V3<S>,
    sky: F<S>,
}

impl<S: Simd> AtRest<S> {
    /// The colour of the backdrop with this number.
    #[inline(always)]
    fn of(simd: S, frame: &FrameUniform, number: usize) -> Self {
        let [.., sky] = frame.backdrop[number];
        Self { colour: paint(simd, frame, number), sky: all(simd, sky) }
    }

    #[inline(always)]
    fn mix(first: Self, second: Self, share: F<S>) -> Self {
        let sky = first.sky * (1.0 - share) + second.sky * share;
        Self { colour: V3::mix(first.colour, second.colour, share), sky }
    }

    #[inline(always)]
    fn select(holds: Mask<S>, value: Self, other: Self) -> Self {
        let sky = select(holds, value.sky, other.sky);
        Self { colour: V3::select(holds, value.colour, other.colour), sky }
    }
}

/// Linear sRGB of the background along these lines of sight, of which no more than this part is seen.
#[inline(always)]
pub fn behind<S: Simd>(simd: S, frame: &FrameUniform, part: BackdropPart, sight: PixelSight<S>) -> V3<S> {
    let sight = StreetLines::new(simd, frame, sight);
    let nearness = 1.0 - (sight.n.z.abs() * SKY_RISE as f32).min(1.0);
    let sky = AtRest::mix(AtRest::of(simd, frame, 1), AtRest::of(simd, frame, 0), nearness * nearness);
    let mut at_rest = sky;
    if part.has_ground() {
        let falls = sight.n.z.simd_lt(LEAST_FALL);
        if falls.any_true() {
            at_rest = AtRest::select(falls, ground(simd, frame, part, sky, sight), sky);
        }
    }
    if part.has_fronts() {
        let meets = sight.n.y.simd_gt(LEAST_TOWARDS_FRONTS as f32);
        if meets.any_true() {
            at_rest = AtRest::select(meets, with_fronts(frame, part, at_rest, sky, sight), at_rest);
        }
    }
    match frame.street() {
        StreetVariant::Daylit | StreetVariant::FalseColours => received(frame, at_rest, sight.doppler),
        StreetVariant::AtRest | StreetVariant::Contracted | StreetVariant::Painted => at_rest.colour,
    }
}

/// Returns what is received of this, as `received_from_street` of the shader.
#[inline(always)]
fn received<S: Simd>(frame: &FrameUniform, at_rest: AtRest<S>, doppler: F<S>) -> V3<S> {
    let tables = Tables::shared();
    let [shift, level, exponent, exposure] = frame.street_light;
    let octaves = log2(doppler);
    let untoning = untoning(at_rest.colour);
    let light = at_rest.colour * untoning;
    let (light, brightness) = if frame.street() == StreetVariant::Daylit {
        let place = octaves * (shift * tables.sunlit_per_octave) + tables.sunlit_at_rest;
        let (mut light, level) = tables.smooth(DAYLIT_ROW, light, place);
        if at_rest.sky.simd_gt(0.0).any_true() {
            light += tables.looked_up(Row::Sky.number(), place).0 * (at_rest.sky * untoning);
        }
        (light, level)
    } else {
        let place = octaves * (shift * tables.map_per_octave) + tables.map_middle;
        let (tint, level) = tables.looked_up(FALSE_ROW, place);
        (light.times(tint), level)
    };
    toned(on_screen(light * power_of_two(brightness * level + octaves * exponent + exposure)))
}

#[inline(always)]
fn paint<S: Simd>(simd: S, frame: &FrameUniform, number: usize) -> V3<S> {
    V3::of_four(simd, frame.backdrop[number])
}

/// Returns what is seen at a distance of a surface of this colour.
#[inline(always)]
fn hazy<S: Simd>(part: BackdropPart, sky: AtRest<S>, colour: V3<S>, distance: F<S>) -> AtRest<S> {
    let painted = AtRest { colour, sky: all(distance.simd, 0.0) };
    AtRest::mix(sky, painted, 1.0 / (1.0 + distance * distance * part.haze() as f32))
}

/// Width and height of a pixel on a plane: its two axes' parts of the line of sight, per part across the
/// plane, are `slope`, and `reach` is how far the place that it meets moves where the line's end moves along
/// the plane. A multiple of the line in its steps does not count.
#[inline(always)]
fn pixel_on<S: Simd>(
    frame: &FrameUniform,
    sight: &StreetLines<S>,
    axes: [usize; 2],
    across: usize,
    slope: V2<S>,
    reach: F<S>,
) -> V2<S> {
    let [right, down] = sight.steps(frame);
    let (right, down) = ([right.x, right.y, right.z], [down.x, down.y, down.z]);
    let width = size_along(axes[0], across, right, down, slope.x);
    let height = size_along(axes[1], across, right, down, slope.y);
    V2::new(width * reach.abs(), height * reach.abs())
}

/// Size of a pixel along an axis of the plane, before it is scaled by the reach. A function, since a closure
/// would be a call between registers of different widths.
#[inline(always)]
fn size_along<S: Simd>(axis: usize, across: usize, right: [F<S>; 3], down: [F<S>; 3], slope: F<S>) -> F<S> {
    V2::new(right[axis] - slope * right[across], down[axis] - slope * down[across]).length()
}

#[inline(always)]
fn ground<S: Simd>(
    simd: S,
    frame: &FrameUniform,
    part: BackdropPart,
    sky: AtRest<S>,
    sight: StreetLines<S>,
) -> AtRest<S> {
    let [camera_x, camera_y, height, _] = frame.ground;
    let per_fall = 1.0 / sight.n.z;
    let distance = per_fall * height;
    let from_camera = V2::new(sight.n.x * distance, sight.n.y * distance);
    let foot = V2::new(from_camera.x + camera_x, from_camera.y + camera_y);
    let slope = V2::new(sight.n.x * per_fall, sight.n.y * per_fall);
    let pixel = pixel_on(frame, &sight, [0, 1], 2, slope, sight.scale * distance);
    let grid = grid_cover(foot.x, pixel.x).max(grid_cover(foot.y, pixel.y));
    let gridded = V3::mix(paint(simd, frame, 2), paint(simd, frame, 3), grid);
    let painted = if part == BackdropPart::Grid {
        let axes = line_cover(foot.x, AXIS_HALF_WIDTH as f32, pixel.x).max(line_cover(
            foot.y,
            AXIS_HALF_WIDTH as f32,
            pixel.y,
        ));
        V3::mix(gridded, paint(simd, frame, 4), axes)
    } else {
        let [near, far, ..] = frame.road;
        let upwards = CoveredRange::new(pixel.y);
        let road = upwards.band_cover(foot.y, all(simd, near), all(simd, far));
        let surface = V3::mix(gridded, paint(simd, frame, 5), road);
        let marks = marks_cover(frame, foot, CoveredRange::new(pixel.x), upwards);
        V3::mix(surface, paint(simd, frame, 4), marks) * left_by_contacts(simd, frame, from_camera, pixel)
    };
    hazy(part, sky, painted, distance * sight.haze_share)
}

#[inline(always)]
fn line_cover<S: Simd>(off_line: F<S>, half_width: f32, pixel: F<S>) -> F<S> {
    let simd = pixel.simd;
    let half = (pixel * 0.5).max(half_width);
    let per_pixel = 1.0 / pixel.max(1e-6);
    let cover = clamp((half - off_line.abs()) * per_pixel + 0.5, all(simd, 0.0), all(simd, 1.0));
    cover * (per_pixel * (2.0 * half_width)).min(1.0)
}

/// Returns the coverage of lines at whole numbers; a grid finer than pixels is left out.
#[inline(always)]
fn grid_cover<S: Simd>(foot: F<S>, pixel: F<S>) -> F<S> {
    let simd = pixel.simd;
    let [start, rate] = GRID_FADE;
    let fade = clamp(start as f32 - pixel * rate as f32, all(simd, 0.0), all(simd, 1.0));
    line_cover(foot - foot.round_ties_even(), LINE_HALF_WIDTH as f32, pixel) * fade
}

#[inline(always)]
fn marks_cover<S: Simd>(
    frame: &FrameUniform,
    foot: V2<S>,
    along: CoveredRange<S>,
    across: CoveredRange<S>,
) -> F<S> {
    let simd = foot.x.simd;
    let [near, far, ..] = frame.road;
    let [kerb, lane] = [KERB_WIDTH as f32, LANE_HALF_WIDTH as f32];
    let middle = 0.5 * (near + far);
    let near_kerb = across.band_cover(foot.y, all(simd, near - kerb), all(simd, near));
    let far_kerb = across.band_cover(foot.y, all(simd, far), all(simd, far + kerb));
    let line = across.band_cover(foot.y, all(simd, middle - lane), all(simd, middle + lane));
    let [length, period] = DASH;
    near_kerb + far_kerb + line * along.repeated_cover(foot.x, length as f32, period as f32)
}

#[inline(always)]
fn with_fronts<S: Simd>(
    frame: &FrameUniform,
    part: BackdropPart,
    without: AtRest<S>,
    sky: AtRest<S>,
    sight: StreetLines<S>,
) -> AtRest<S> {
    let [camera_x, _, ground, _] = frame.ground;
    let per_towards = 1.0 / sight.n.y;
    let distance = per_towards * frame.road[2];
    let place = V2::new(sight.n.x * distance + camera_x, sight.n.z * distance - ground);
    let slope = V2::new(sight.n.x * per_towards, sight.n.z * per_towards);
    let size = pixel_on(frame, &sight, [0, 2], 1, slope, sight.scale * distance);
    let seen = front(frame, place, size);
    AtRest::mix(without, hazy(part, sky, seen.colour, distance * sight.haze_share), seen.cover)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use glam::DVec3;
    use relativity_core::{Aperture, Speed};

    use super::*;
    use crate::camera::{Camera, Gaze, Projection};
    use crate::colour::srgb_encoded;
    use crate::cpu::packets::light::encode::encoded;
    use crate::cpu::packets::testing::at_every_level;
    use crate::kinematics::velocity::{Motion, Velocity};
    use crate::scene::prepared_scene::PreparedScene;
    use crate::simd::lanes::LANES;
    use crate::street::backdrop::Backdrop;
    use crate::view::{Appearance, Colour, Geometry, StreetColours, View};

    const SIZE: [u32; 2] = [120, 136];

    fn appearances() -> Vec<Appearance> {
        let road = Appearance { ground_z: Some(-1.5), road: Some([1.0, 9.0]), ..Appearance::default() };
        let dark = [
            Appearance::default(),
            Appearance { sky: false, ..Appearance::default() },
            Appearance { ground_z: Some(-0.3), ..Appearance::default() },
            Appearance { ground_z: Some(-40.0), ..Appearance::default() },
            Appearance { ground_z: Some(1.5), ..Appearance::default() },
            road,
            Appearance { fronts: Some(12.0), ..road },
            Appearance { fronts: Some(400.0), ground_z: Some(-6.0), ..road },
            Appearance { street: StreetColours::Received, exposure_ev: -2.0, fronts: Some(12.0), ..road },
            Appearance { colour: Colour::False, fronts: Some(12.0), ..road },
        ];
        dark.into_iter().flat_map(|dark| [dark, Appearance { light: true, ..dark }]).collect()
    }

    fn cameras() -> Vec<Camera> {
        let gazes =
            [(0.5, 0.0), (0.45, -0.1), (0.1, 0.2), (1.3, -0.6), (-0.5, -0.02), (0.62, 0.5), (0.5, -1.55)];
        let mut cameras = Vec::new();
        for (i, (azimuth, elevation)) in gazes.into_iter().enumerate() {
            let aperture = Aperture { x: [0.03, -7.3][i % 2], y: [0.0, 0.4, -2.0][i % 3], z: 0.1 };
            let gaze = Gaze { azimuth: azimuth * PI, elevation };
            let camera = Camera::new(aperture, gaze, [1.0, 0.2, 2.0][i % 3], SIZE);
            let projection = Projection::Parallel { right: DVec3::X, shift: 0.05 };
            let tilted = DVec3::new(0.9, 0.1, 0.42).normalize();
            let conformal = [DVec3::X, tilted].map(|right| Projection::Mercator { right, shift: 0.05 });
            cameras.push(camera);
            let beta = [0.9, -0.6][i % 2];
            let riding = Camera { velocity: Velocity::from_beta(beta).expect("a speed").into(), ..camera };
            cameras.extend([riding, Camera { projection: conformal[0], ..riding }]);
            cameras.extend(
                [projection].into_iter().chain(conformal).map(|projection| Camera { projection, ..camera }),
            );
        }
        cameras
    }

    fn frame(camera: Camera, appearance: &Appearance) -> FrameUniform {
        let speed = Speed::from_beta(0.9).expect("below 1");
        let view = View { camera, speed, observation_time: 0.0, geometry: Geometry::Seen };
        let groups = [view.of_group(Motion::Scene)];
        FrameUniform::of_groups(&PreparedScene::new([]), &groups, appearance)[0]
    }

    #[inline(always)]
    fn row<S: Simd>(simd: S, frame: &FrameUniform, [u, v]: [u32; 2]) -> V3<S> {
        row_of(simd, frame, tile_part(simd, frame, [u, v]), [u, v])
    }

    /// Returns the part of the backdrop that the tile with this pixel can show.
    #[inline(always)]
    fn tile_part<S: Simd>(simd: S, frame: &FrameUniform, pixel: [u32; 2]) -> BackdropPart {
        part(simd, frame, pixel.map(|at| (at / 8 * 8) as f32), [8.0; 2])
    }

    #[inline(always)]
    fn row_of<S: Simd>(simd: S, frame: &FrameUniform, part: BackdropPart, [u, v]: [u32; 2]) -> V3<S> {
        let along = F::from_fn(simd, |lane| (u + lane as u32) as f32 + 0.5);
        behind(simd, frame, part, line_of_sight(simd, frame, along, all(simd, v as f32 + 0.5)))
    }

    fn packets() -> impl Iterator<Item = [u32; 2]> {
        (0..SIZE[1]).step_by(3).flat_map(|v| (0..SIZE[0]).step_by(LANES).map(move |u| [u, v]))
    }

    #[test]
    fn what_lies_behind_is_what_the_reference_has_there() {
        let mut worst: f64 = 0.0;
        for camera in cameras() {
            for appearance in appearances() {
                let (reference, frame) =
                    (Backdrop::new(&camera, Geometry::Seen, &appearance), frame(camera, &appearance));
                let sights = camera.lines_of_sight();
                let mut check = |[u, v]: [u32; 2], found: [[f32; 3]; LANES]| {
                    for (u, found) in (u..).zip(found) {
                        let expected =
                            reference.behind(sights.through([u, v].map(|place| f64::from(place) + 0.5)));
                        for (found, expected) in found.into_iter().zip(expected) {
                            let off = 255.0 * (srgb_encoded(found.into()) - srgb_encoded(expected)).abs();
                            worst = worst.max(off);
                            assert!(
                                off < 2.0,
                                "{camera:?} {appearance:?} at {u}, {v}: {found} for {expected}"
                            );
                        }
                    }
                };
                at_every_level!(simd => {
                    for place in packets() {
                        let colour = row(simd, &frame, place);
                        check(place, std::array::from_fn(|lane| colour.lane(lane)));
                    }
                });
            }
        }
        println!("at most {worst} levels off");
    }

    #[test]
    fn no_registers_change_a_byte() {
        for camera in cameras() {
            for appearance in appearances() {
                let frame = frame(camera, &appearance);
                let mut first: Option<Vec<_>> = None;
                at_every_level!(simd => {
                    let mut bytes = Vec::new();
                    for place in packets() {
                        bytes.extend(encoded(simd, row(simd, &frame, place)));
                    }
                    let first = first.get_or_insert_with(|| bytes.clone());
                    assert!(bytes == *first, "{camera:?} {appearance:?}");
                });
            }
        }
    }
}
