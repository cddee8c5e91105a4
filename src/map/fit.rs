//! The fitted part of the world in a map. It depends on the scene and on how far from the eyes it passes, not
//! on T, and on the speed only in steps: nothing jumps while time runs.

use glam::DVec3;
use relativity_core::math;
use relativity_render::{Motion, Velocity};

use super::{Chart, Viewpoint};
use crate::scene::Scene;
use crate::settings::{MapFrame, Settings};

/// A box of the world: lowest and highest x, y, z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorldBox(pub [[f64; 2]; 3]);

/// Distance on either side within which a passage is shown, in units of its closest approach.
const PASSAGE: f64 = 2.0;
/// Least distance that it is fitted to, units.
const NEAREST: f64 = 1.0;
/// At most so much wider is the map in the bicycle's frame.
const WIDEST: f64 = 1.5;
/// Margin behind the eyes, beyond what moves and below the ground, units; above it half as much.
const MARGIN: f64 = 0.7;
/// Part of the street around who rides, behind and ahead, units.
const AROUND_RIDER: [f64; 2] = [-8.0, 16.0];
/// Half the part of the world around who does not ride along the street, units, and how far it is shifted at
/// the speed of light.
const AROUND_ASLANT: [f64; 3] = [6.0, 6.0, 3.0];
const AHEAD_ASLANT: f64 = 4.0;
/// Greatest distance of what such a rider sees that is fitted.
const FURTHEST: f64 = 120.0;
/// The same along the street, where only the width of the map has to hold it.
const FURTHEST_ALONG: f64 = 400.0;
/// Least height of the plan and of the view from the side, of that of the other.
const LEAST_SHARE: f64 = 0.25;
/// Space between the plan and the view from the side, points.
const BETWEEN: f64 = 10.0;

impl WorldBox {
    /// Returns the part in the space face: both eyes, and what moves, as it passes them.
    #[must_use]
    pub fn of_space(settings: &Settings, scene: &Scene) -> Self {
        let [x, y, z] = subject_box(scene);
        let y = y.map(|y| y + settings.motion.depth_shift);
        let z = z.map(|z| z + settings.motion.height_shift);
        let ground = scene.ground_z.map_or(z[0], |ground| ground + settings.motion.height_shift);
        let distance = math::hypot(0.5 * (y[0] + y[1]), 0.5 * (z[0] + z[1]));
        let reach = (PASSAGE * distance.max(NEAREST) + 0.5 * (x[1] - x[0])) * widening(settings);
        let middle = 0.5 * (x[0] + x[1]);
        Self([
            [middle - reach, middle + reach],
            [y[0].min(0.0) - MARGIN, y[1].max(0.0) + MARGIN],
            [z[0].min(0.0).min(ground) - MARGIN, z[1].max(0.0) + 0.5 * MARGIN],
        ])
    }

    /// Returns the part around who rides, whose eyes are at this x on the map: more of it ahead than behind.
    #[must_use]
    pub fn of_ride(settings: &Settings, scene: &Scene, x: f64) -> Self {
        let mut extent = Self::of_space(settings, scene);
        extent.0[0] = AROUND_RIDER.map(|along| x + along);
        extent
    }

    /// Returns this part, extended along x to the places `along` it that are not too far from `x`.
    #[must_use]
    pub fn reaching(self, x: f64, along: impl Iterator<Item = f64>) -> Self {
        let Self([across, y, z]) = self;
        let near = along.filter(|place| (place - x).abs() <= FURTHEST_ALONG);
        let across =
            near.fold(across, |[from, to], place| [from.min(place - MARGIN), to.max(place + MARGIN)]);
        Self([across, y, z])
    }
}

impl WorldBox {
    /// Returns the part around who does not ride along the street: more of it ahead of `here` than behind, by
    /// `velocity`, and all of `seen` that is not too far off.
    #[must_use]
    pub fn of_ride_aslant(here: DVec3, velocity: DVec3, seen: impl Iterator<Item = DVec3>) -> Self {
        let (middle, half) =
            (here + AHEAD_ASLANT * velocity, DVec3::from(AROUND_ASLANT) + AHEAD_ASLANT * velocity.abs());
        let within = seen.map(|place| here + (place - here).clamp_length_max(FURTHEST));
        let around = (middle - half, middle + half);
        let (low, high) = within.fold(around, |(low, high), place| {
            (low.min(place - DVec3::splat(MARGIN)), high.max(place + DVec3::splat(MARGIN)))
        });
        let size = high - low;
        let lacks = (0.5 * (LEAST_SHARE * DVec3::new(0.0, size.z, size.y) - size)).max(DVec3::ZERO);
        let (low, high) = (low - lacks, high + lacks);
        Self([0, 1, 2].map(|axis| [low[axis], high[axis]]))
    }
}

/// Returns the factor by which a map is wider that holds eyes which ride past: from T = 0 on they are gamma
/// beta T away. In steps, and at most so much that the bicycle stays large enough to be seen.
fn widening(settings: &Settings) -> f64 {
    match settings.map_frame() {
        MapFrame::Ground | MapFrame::Rider => 1.0,
        MapFrame::Bicycle => {
            let steps = 2.0 * math::log2(settings.speed().gamma());
            math::powf(2.0, 0.5 * steps.ceil()).min(WIDEST)
        }
    }
}

/// The box around what the scene is about, at rest.
fn subject_box(scene: &Scene) -> [[f64; 2]; 3] {
    let moves = |motion: Motion| motion != Motion::Own(Velocity::REST);
    let subject = scene.passing().filter(|group| moves(group.motion));
    let bodies = subject.flat_map(|group| &scene.bodies[group.bodies()]);
    let empty = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    let around = bodies.fold(empty, |around, body| joined(around, body.shape.ball_around()));
    if around[0][0] <= around[0][1] { around } else { [[-1.0, 1.0]; 3] }
}

fn joined(around: [[f64; 2]; 3], (centre, radius): ([f64; 3], f64)) -> [[f64; 2]; 3] {
    [0, 1, 2]
        .map(|axis| [around[axis][0].min(centre[axis] - radius), around[axis][1].max(centre[axis] + radius)])
}

/// The plan (x, y) above and the view from the side (x, z) below, in a rectangle (left, top, width, height,
/// points) that holds `extent` as the user looks at it. They have one scale and share x.
#[must_use]
pub fn plan_and_side(
    [left, top, width, height]: [f64; 4],
    extent: &WorldBox,
    viewpoint: &Viewpoint,
) -> [Chart; 2] {
    let size = extent.0.map(|[low, high]| high - low);
    let middle = extent.0.map(|[low, high]| 0.5 * (low + high));
    let height = (height - BETWEEN).max(2.0);
    let fitted = (width.max(1.0) / size[0]).min(height / (size[1] + size[2]));
    let scale = fitted * viewpoint.zoom;
    let centre = [0, 1, 2].map(|axis| middle[axis] + viewpoint.shift[axis]);
    let plan_height = height * size[1] / (size[1] + size[2]);
    let chart = |top: f64, height: f64, up: usize| Chart {
        middle: [left + 0.5 * width, top + 0.5 * height],
        half: [0.5 * width, 0.5 * height],
        centre: [centre[0], centre[up]],
        scale,
    };
    [chart(top, plan_height, 1), chart(top + plan_height + BETWEEN, height - plan_height, 2)]
}
