//! The bodies of a view as they are drawn: how finely each is divided, and in which order.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use relativity_core::math::hypot;
use relativity_core::threads::prelude::*;

use super::copies::{Around, Copy, FLAT};
use super::division::division;
use super::template::Division;
use crate::geometry::capsule::Capsule;
use crate::geometry::intersect::Solid;
use crate::gpu::drawing::{Shot, Trait};
use crate::kinematics::spin::MaterialPoint;
use crate::picture::footprint::FootprintMap;
use crate::scene::prepared_body::{Joint, Placement, PreparedBody};
use crate::scene::wheel::packed::{TurningStart, Turns};
use crate::view::Geometry;
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
    pub copy: Copy,
}

/// A body as it is drawn.
#[derive(Debug, Clone, Copy)]
struct DrawnBody {
    division: Division,
    instance: MeshInstance,
    /// The number of its group.
    group: usize,
    joint: Joint,
    /// Whether it is thinner than a pixel somewhere, in a picture.
    is_thin: bool,
    is_patterned: bool,
    turns: Turns,
    /// In a conformal picture.
    around: Option<Around>,
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
    /// Replaces all by the bodies that `shot` can show, divided to keep `bound_px`. In pictures thin ones are drawn
    /// wider, and faded.
    pub fn refill(&mut self, shot: &Shot<'_>, bound_px: f64) {
        let Shot { scene, views, divided_for, appearance, .. } = *shot;
        let projections: Vec<_> = views.iter().map(FootprintMap::new).collect();
        let maps: Vec<_> = views.iter().map(|view| view.camera.mercator()).collect();
        let ball = |body: &PreparedBody| {
            if body.is_turned {
                return *scene.ball_around(body);
            }
            let solid = scene.solid(body.number);
            Capsule::ball(solid.center(), solid.bounding_radius())
        };
        let is_seen = |body: &PreparedBody| {
            let view = &views[body.group];
            let Capsule { from: center, radius, .. } = ball(body);
            let middle = view.along_motion_from_camera(center);
            // Neither the published positions nor those of one light cone for both eyes are the camera's.
            matches!(view.geometry, Geometry::Published | Geometry::OneCone)
                || !projections[body.group].hides(middle, radius)
        };
        let part = |body: &PreparedBody| {
            let view = &divided_for[body.group];
            // What numbers show is drawn as wide as it is.
            let half_width = appearance.map(|_| half_width(body, scene.solid(body.number), view));
            DrawnBody {
                division: division(body, scene.solid(body.number), view, bound_px),
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
                around: maps[body.group].map(|mercator| {
                    let (view, projection) = (&views[body.group], &projections[body.group]);
                    let middle = MaterialPoint { rest: scene.solid(body.number).center(), spin: body.spin };
                    let ball = ball(body);
                    let whole = [ball];
                    let pieces = if body.is_turned { &whole } else { scene.around(body) };
                    Around::new(&mercator, view, projection, view.apparent_position(middle), &ball, pieces)
                }),
            }
        };
        scene
            .bodies()
            .par_iter()
            .map(|body| is_seen(body).then(|| part(body)))
            .collect_into_vec(&mut self.found);
        self.sorted.clear();
        for part in self.found.iter().flatten() {
            match part.around {
                None => self.sorted.push(*part),
                Some(around) => self.sorted.extend(around.copies().map(|copy| part.copied(copy))),
            }
        }
        self.sorted.sort_unstable_by_key(DrawnBody::rank);
    }

    /// Returns the runs of parts that one draw draws, in order.
    pub fn runs(&self) -> impl Iterator<Item = (Trait<Division>, impl Iterator<Item = &MeshInstance>)> {
        let chunks = self.sorted.chunk_by(|a, b| a.common() == b.common());
        chunks.map(|run| (run[0].common(), run.iter().map(|part| &part.instance)))
    }
}

impl DrawnBody {
    fn copied(&self, copy: Copy) -> Self {
        Self { instance: MeshInstance { copy, ..self.instance }, ..*self }
    }

    /// Returns the properties that a part shares with those drawn by the same draw.
    fn common(&self) -> Trait<Division> {
        let Self { division, group, is_thin, is_patterned, turns, .. } = *self;
        Trait { group, kind: division.kind(), template: division, is_thin, is_patterned, turns }
    }

    /// Returns the place of a part in the order: faded ones last; group by group; in the bodies' order where surfaces may coincide, so
    /// that the first of them stays, and else those of one division together, which saves a draw for each.
    fn rank(&self) -> (bool, usize, Option<(bool, Turns, Division)>, u32) {
        let is_joined = if self.is_thin { self.joint.widened } else { self.joint.as_it_is };
        let [_, _, index] = self.instance.width_brightness_index;
        (
            self.is_thin,
            self.group,
            (!is_joined).then_some((self.is_patterned, self.turns, self.division)),
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
            7 => Float32x3, 8 => Float32x4, 9 => Float32x2, 10 => Float32x4
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
            copy: FLAT,
        }
    }
}

/// Returns half the least width that `body` is seen with, in the direction of its middle.
fn half_width(body: &PreparedBody, solid: &Solid, view: &GroupView) -> f64 {
    let center = view.place_when_shown(MaterialPoint { rest: solid.center(), spin: body.spin });
    solid.half_width((center - view.origin).normalize_or(DVec3::Y))
}

/// Returns half the size of a pixel where `body` is farthest: infinite outside the domain of the core. The shader finds the same
/// at each corner.
fn half_pixel(body: &PreparedBody, solid: &Solid, view: &GroupView) -> f64 {
    let axes = view.camera.axes();
    let is_conformal = view.camera.mercator().is_some();
    // Away from the axis of a flat picture nothing is smaller than on it, as deep; in a conformal one, as far from the
    // baseline.
    let depth = |place: DVec3| {
        view.apparent_position(view.corner(body, place)).map_or(f64::INFINITY, |place| {
            let depth = place.dot(axes.forward);
            if is_conformal { hypot(depth, place.dot(axes.up)) } else { depth }
        })
    };
    let mut farthest = 0.0_f64;
    let mut visit = |own: DVec3| farthest = farthest.max(depth(solid.center() + body.turn * own));
    solid.form.answers().visit_farthest(&mut visit);
    0.5 * farthest / view.camera.focal_length_px()
}
