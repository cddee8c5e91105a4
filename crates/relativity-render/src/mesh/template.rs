//! Grids of corners over unit shapes, for bodies of that shape to be placed on.

use relativity_core::math;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use bytemuck::{Pod, Zeroable};

use crate::kind::Kind;
use crate::triangles::Triangles;

/// The division of a shape: its number of steps each way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Division {
    /// A tube (or, with no sides, a ball): segments around, along each rounded end, and along the side.
    Tube { around: u32, end: u32, side: u32 },
    /// A ring: segments around the axis, and around the tube.
    Ring { around: u32, tube: u32 },
    /// A box: segments along each of its own axes.
    Box { along: [u32; 3] },
    /// A cylinder: segments around, from the middle of each end to its rim, and along the side.
    Cylinder { around: u32, end: u32, side: u32 },
    /// The model with this fingerprint: segments along any side of its box, if they were as long as edges may be.
    Model { fingerprint: u64, segments: u32 },
}

/// Mirror of the shaders' `Corner`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Corner {
    pub profile: [f32; 4],
    pub turn: [f32; 2],
}

impl Corner {
    /// Layout in which the vertex stage reads a corner.
    pub const LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
        array_stride: size_of::<Self>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x2],
    };
}

/// The corners of a division, and the triangles between them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Template {
    pub corners: Vec<Corner>,
    pub triangles: Vec<u32>,
}

impl Division {
    /// The kind of shape that it divides.
    pub fn kind(self) -> Kind {
        match self {
            Self::Tube { .. } => Kind::Tube,
            Self::Ring { .. } => Kind::Ring,
            Self::Box { .. } => Kind::Box,
            Self::Cylinder { .. } => Kind::Cylinder,
            Self::Model { .. } => Kind::Model,
        }
    }

    /// Returns corners and triangles, counter-clockwise as seen from outside; of a model those of the one among `models` that it divides.
    pub fn template<'a>(self, mut models: impl Iterator<Item = &'a Arc<Triangles>>) -> Template {
        match self {
            Self::Tube { around, end, side } => grid(&tube_profile(end, side), around),
            Self::Ring { around, tube } => {
                let profile = (0..=tube).map(|i| {
                    let (sine, cosine) = math::sin_cos(TAU * f64::from(i) / f64::from(tube));
                    [cosine as f32, sine as f32, 0.0, 0.0]
                });
                grid(&profile.collect::<Vec<_>>(), around)
            }
            Self::Box { along } => box_template(along),
            Self::Cylinder { around, end, side } => grid(&cylinder_profile(end, side), around),
            Self::Model { fingerprint, segments } => {
                let model = models.find(|model| model.fingerprint() == fingerprint);
                model.map_or_else(Template::default, |model| model.template(segments))
            }
        }
    }
}

/// From the pole of one end to that of the other.
fn tube_profile(end: u32, side: u32) -> Vec<[f32; 4]> {
    let cap = |i: u32, sign: f64| {
        let (sine, cosine) = math::sin_cos(FRAC_PI_2 * f64::from(i) / f64::from(end));
        [sign as f32, (sign * cosine) as f32, sine as f32, 0.0]
    };
    let near = (0..=end).map(|i| cap(i, -1.0));
    let along = (1..side).map(|i| [(2.0 * f64::from(i) / f64::from(side) - 1.0) as f32, 0.0, 1.0, 0.0]);
    // A ball has no sides: its ends share their last circle.
    let far = (0..=end).rev().map(|i| cap(i, 1.0)).skip(usize::from(side == 0));
    near.chain(along).chain(far).collect()
}

/// From the middle of one end to that of the other.
fn cylinder_profile(end: u32, side: u32) -> Vec<[f32; 4]> {
    let share = |i: u32, count: u32| (f64::from(i) / f64::from(count)) as f32;
    let near = (0..=end).map(|i| [-1.0, share(i, end), -1.0, 0.0]);
    let along = (0..=side).map(|i| [2.0 * share(i, side) - 1.0, 1.0, 0.0, 1.0]);
    let far = (0..=end).rev().map(|i| [1.0, share(i, end), 1.0, 0.0]);
    near.chain(along).chain(far).collect()
}

/// The six faces of the cube from -1 to 1, each a grid.
fn box_template(along: [u32; 3]) -> Template {
    let mut template = Template { corners: Vec::new(), triangles: Vec::new() };
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            add_face(&mut template, along, axis, side);
        }
    }
    template
}

/// The face across an axis, on one `side`.
fn add_face(template: &mut Template, along: [u32; 3], axis: usize, side: f32) {
    // As seen from outside, the second axis is a quarter turn from the first.
    let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
    let (u, v) = if side > 0.0 { (first, second) } else { (second, first) };
    let start = template.corners.len() as u32;
    let share = |i: u32, axis: usize| (2.0 * f64::from(i) / f64::from(along[axis]) - 1.0) as f32;
    for j in 0..=along[v] {
        for i in 0..=along[u] {
            let mut profile = [0.0, 0.0, 0.0, axis as f32];
            (profile[axis], profile[u], profile[v]) = (side, share(i, u), share(j, v));
            template.corners.push(Corner { profile, turn: [0.0; 2] });
        }
    }
    let row = along[u] + 1;
    let lows = (0..along[v]).flat_map(|j| (0..along[u]).map(move |i| start + j * row + i));
    template
        .triangles
        .extend(lows.flat_map(|low| [low, low + 1, low + row, low + row, low + 1, low + row + 1]));
}

/// `profile` turned around the axis.
fn grid(profile: &[[f32; 4]], around: u32) -> Template {
    let rows = profile.len() as u32;
    let turn = |j: u32| {
        let (sine, cosine) = math::sin_cos(TAU * f64::from(j) / f64::from(around));
        [cosine as f32, sine as f32]
    };
    let corners = (0..=around)
        .flat_map(|j| profile.iter().map(move |&profile| Corner { profile, turn: turn(j) }))
        .collect();
    let triangles = (0..around)
        .flat_map(|j| (0..rows - 1).map(move |i| j * rows + i))
        .flat_map(|low| [low, low + rows, low + 1, low + 1, low + rows, low + rows + 1])
        .collect();
    Template { corners, triangles }
}
