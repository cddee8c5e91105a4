//! The bodies of a view as they are drawn: the grid and the copies of each, and their order.

use std::f32::consts::TAU;
use std::f64::consts::{FRAC_PI_2, PI};
use std::slice;

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use relativity_core::math::hypot;
use relativity_core::threads::prelude::*;

use super::size::{Sizes, Whereabouts};
use super::template::Grid;
use crate::geometry::capsule::Capsule;
use crate::geometry::corners::Coarseness;
use crate::geometry::intersect::Solid;
use crate::gpu::drawing::{Shot, Trait};
use crate::kinematics::spin::MaterialPoint;
use crate::picture::footprint::FootprintMap;
use crate::scene::prepared_body::{Joint, Placement, PreparedBody};
use crate::scene::prepared_scene::PreparedScene;
use crate::scene::wheel::packed::{TurningStart, Turns};
use crate::view::group_view::GroupView;

/// Mirror of the shaders' `MeshInstance`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct MeshInstance {
    pub place_radius: [f32; 4],
    pub form: [f32; 4],
    pub turn: [f32; 4],
    pub light: [f32; 4],
    pub width_brightness_index: [f32; 3],
    pub pattern: [f32; 3],
    pub spin: [f32; 4],
    pub rim: [f32; 2],
    pub copy: BodyCopy,
}

/// A copy of a body in a conformal picture, a strip around the baseline that is cut open behind the camera:
/// the angle by which it is turned about the baseline, and whether it draws only the triangles across the
/// cut, 1 or 0.
type BodyCopy = [f32; 2];

/// The only copy in a flat picture, and the first in a conformal one.
const WHOLE: BodyCopy = [0.0, 0.0];

/// The copies in a conformal picture, each with the half height, radians, from which a picture shows anything
/// of it: triangles across the cut are drawn beside both ends of the strip, and pictures that go farther
/// round show bodies again.
const COPIES: [(f64, BodyCopy); 5] =
    [(0.0, WHOLE), (FRAC_PI_2, [0.0, 1.0]), (FRAC_PI_2, [-TAU, 1.0]), (PI, [TAU, 0.0]), (PI, [-TAU, 0.0])];

/// A body as it is drawn.
#[derive(Debug, Clone, Copy)]
struct DrawnBody {
    grid: Grid,
    instance: MeshInstance,
    /// The number of its group.
    group: usize,
    joint: Joint,
    /// Whether it is thinner than a pixel somewhere, in a picture.
    is_thin: bool,
    is_patterned: bool,
    turns: Turns,
}

/// The parts of a view. Kept from view to view, for their memory.
#[derive(Debug, Default)]
pub struct Parts {
    /// Parts found, one for each body, `None` for those out of sight.
    found: Vec<Option<DrawnBody>>,
    /// In the order they are drawn in.
    sorted: Vec<DrawnBody>,
}

impl Parts {
    /// Replaces all by the bodies that `shot` can show, in groups whose views are `meant`. In pictures thin
    /// ones are drawn wider, and faded.
    pub fn refill(&mut self, shot: &Shot<'_>, meant: impl Fn(&GroupView) -> bool) {
        let Shot { scene, views, appearance, .. } = *shot;
        let projections: Vec<_> = views.iter().map(FootprintMap::new).collect();
        let sizes: Vec<_> = views.iter().map(Sizes::new).collect();
        let is_meant: Vec<_> = views.iter().map(meant).collect();
        let is_hidden = |body: &PreparedBody, ball: &Capsule| {
            let view = &views[body.group];
            // Neither the published positions nor those of one light cone for both eyes are the camera's.
            if !view.has_straight_rays() {
                return sizes[body.group].hides(ball);
            }
            projections[body.group].hides(view.along_motion_from_camera(ball.from), ball.radius)
        };
        let coarseness = |body: &PreparedBody, ball: Capsule| {
            let whereabouts = whereabouts(scene, body, &views[body.group], ball);
            let px_per_length = sizes[body.group].px_per_length(&whereabouts);
            let sizes = scene.solid(body.number).form.answers().grid_sizes();
            Coarseness::for_sizes(sizes.map(|size| size * px_per_length))
        };
        let part = |body: &PreparedBody| {
            let ball = is_meant[body.group].then(|| ball_around(scene, body))?;
            if is_hidden(body, &ball) {
                return None;
            }
            let view = &views[body.group];
            // What numbers show is drawn as wide as it is.
            let half_width = appearance.map(|_| half_width(body, scene.solid(body.number), view));
            Some(DrawnBody {
                grid: Grid::of(body, || coarseness(body, ball)),
                instance: MeshInstance::new(body, half_width.unwrap_or_default(), shot),
                group: body.group,
                joint: body.joint,
                // A model is drawn as it is, however thin.
                is_thin: body.triangles.is_none()
                    && half_width.is_some_and(|half_width| {
                        half_width < half_pixel(body, scene.solid(body.number), view)
                    }),
                is_patterned: body.is_patterned,
                turns: view.turns(body),
            })
        };
        scene.bodies().par_iter().map(part).collect_into_vec(&mut self.found);
        self.sorted.clear();
        let camera = &views[0].camera;
        let half_height =
            camera.mercator().map_or(0.0, |mercator| 0.5 * f64::from(camera.size[1]) / mercator.px_per_unit);
        for part in self.found.iter().flatten() {
            let shown = COPIES.iter().filter(|(least, _)| *least <= half_height);
            self.sorted.extend(shown.map(|&(_, copy)| part.copied(copy)));
        }
        self.sorted.sort_unstable_by_key(DrawnBody::rank);
    }

    /// Returns the runs of parts that one draw draws, in order.
    pub fn runs(&self) -> impl Iterator<Item = (Trait<Grid>, impl Iterator<Item = &MeshInstance>)> {
        let chunks = self.sorted.chunk_by(|a, b| a.common() == b.common());
        chunks.map(|run| (run[0].common(), run.iter().map(|part| &part.instance)))
    }
}

/// Returns a ball around `body`, at every angle to which it turns.
fn ball_around(scene: &PreparedScene, body: &PreparedBody) -> Capsule {
    if body.is_turned {
        return *scene.ball_around(body);
    }
    let solid = scene.solid(body.number);
    Capsule::ball(solid.centre(), solid.bounding_radius())
}

/// Returns where `body` is, which is inside `ball`.
fn whereabouts(scene: &PreparedScene, body: &PreparedBody, view: &GroupView, ball: Capsule) -> Whereabouts {
    let capsules = if body.is_turned { slice::from_ref(&ball) } else { scene.capsules(body) };
    let nearest = match &body.block {
        Some(block) if !body.is_turned => block.distance_from(view.origin),
        _ => capsules.iter().map(|capsule| capsule.distance_from(view.origin)).fold(f64::INFINITY, f64::min),
    };
    Whereabouts { ball, nearest }
}

impl DrawnBody {
    fn copied(&self, copy: BodyCopy) -> Self {
        Self { instance: MeshInstance { copy, ..self.instance }, ..*self }
    }

    /// Returns the properties that a part shares with those drawn by the same draw.
    fn common(&self) -> Trait<Grid> {
        let Self { grid, group, is_thin, is_patterned, turns, .. } = *self;
        Trait { group, kind: grid.kind(), template: grid, is_thin, is_patterned, turns }
    }

    /// Returns the place of a part in the order: faded ones last; group by group; in the bodies' order where
    /// surfaces may coincide, so that the first of them stays, and else those of one grid together, which
    /// saves a draw for each.
    fn rank(&self) -> (bool, usize, Option<(bool, Turns, Grid)>, u32) {
        let is_joined = if self.is_thin { self.joint.widened } else { self.joint.as_it_is };
        let [_, _, index] = self.instance.width_brightness_index;
        (
            self.is_thin,
            self.group,
            (!is_joined).then_some((self.is_patterned, self.turns, self.grid)),
            index as u32,
        )
    }
}

impl MeshInstance {
    /// Layout in which the vertex stage reads an instance.
    pub const LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
        array_stride: size_of::<Self>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![
            2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Float32x4, 6 => Float32x3,
            7 => Float32x3, 8 => Float32x4, 9 => Float32x2, 10 => Float32x2
        ],
    };

    fn new(body: &PreparedBody, half_width: f64, shot: &Shot<'_>) -> Self {
        let TurningStart { placement: Placement { place_radius, form, turn }, spin, rim } = shot.shown(body);
        Self {
            place_radius,
            form,
            turn,
            light: shot.light(body),
            width_brightness_index: [half_width as f32, body.brightness as f32, body.index()],
            pattern: shot.pattern(body),
            spin,
            rim,
            copy: WHOLE,
        }
    }
}

/// Returns half the least width that `body` is seen with, in the direction of its middle.
fn half_width(body: &PreparedBody, solid: &Solid, view: &GroupView) -> f64 {
    let centre = view.place_when_shown(MaterialPoint { rest: solid.centre(), spin: body.spin });
    solid.half_width((centre - view.origin).normalize_or(DVec3::Y))
}

/// Returns half the size of a pixel where `body` is farthest: infinite outside the domain of the core. The
/// shader finds the same at each corner.
fn half_pixel(body: &PreparedBody, solid: &Solid, view: &GroupView) -> f64 {
    let axes = view.camera.axes();
    let is_conformal = view.camera.mercator().is_some();
    // Away from the axis of a flat picture nothing is smaller than on it, as deep; in a conformal one, as far
    // from the baseline.
    let depth = |place: DVec3| {
        view.apparent_position(view.corner(body, place)).map_or(f64::INFINITY, |place| {
            let depth = place.dot(axes.forward);
            if is_conformal { hypot(depth, place.dot(axes.up)) } else { depth }
        })
    };
    let mut farthest = 0.0_f64;
    let mut visit = |own: DVec3| farthest = farthest.max(depth(solid.centre() + body.turn * own));
    solid.form.answers().visit_farthest(&mut visit);
    0.5 * farthest / view.camera.focal_length_px()
}
