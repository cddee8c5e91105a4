//! Mirrors: structs and constants that both the shaders and Rust state, and what is made of them, for tests
//! to compare.

use std::mem::offset_of;

use super::device::Gpu;
use super::mesh::MeshInstance;
use super::pipelines::Technique;
use super::rays::Piece;
use super::sampling::Sampling;
use super::{mesh, rays};
use crate::frame::pipeline_key::{Key, Output};
use crate::frame::uniform::FrameUniform;
use crate::geometry::corners::Corner;
use crate::geometry::kind::Kind;
use crate::picture::compose::{self, Composing};
use crate::scene::wheel::packed::Turns;
use crate::shaders;
use crate::street::backdrop;
use crate::street::sight::StreetVariant;
use crate::view::effects::{Constant, Effects};
use crate::view::{Appearance, Geometry};

/// A shader and what Rust gives it.
#[derive(Debug)]
pub struct Shader {
    /// Name of the pass that the shader draws.
    pub name: String,
    /// Source text, in WGSL.
    pub source: String,
    /// The constants that its pipelines are made with.
    pub constants: Vec<Constant>,
}

/// A struct that a shader reads, as Rust lays it out.
#[derive(Debug)]
pub struct Mirror {
    /// Name of the struct on both sides.
    pub name: &'static str,
    /// Names of the fields and their offsets, bytes.
    pub fields: &'static [(&'static str, usize)],
    /// Size of the struct, bytes.
    pub size: usize,
}

/// A mirror that the vertex stage reads by attributes.
#[derive(Debug)]
pub struct VertexMirror {
    /// Struct that both sides state.
    pub mirror: Mirror,
    /// Layout in which pipelines read the struct.
    pub layout: wgpu::VertexBufferLayout<'static>,
}

macro_rules! mirror {
    ($struct:ident: $($field:ident),+) => {
        Mirror {
            name: stringify!($struct),
            fields: &[$((stringify!($field), offset_of!($struct, $field))),+],
            size: size_of::<$struct>(),
        }
    };
}

/// The uniform blocks that both sides state.
pub const BLOCKS: [Mirror; 2] = [
    mirror!(
        FrameUniform: base, right, down, radial, pole, speed, motion, oblique, group_axes, reference_axes, to_street, street_axes, rising, on_ground, eye, reference_eye, reference_speed, reference_middle, middle, middle_fine, ground, road, street_speed, street_motion, street_light, exposure, contact_eye, contacts, houses, openings, backdrop, hatch,
        clip_right, clip_up, forward
    ),
    mirror!(Composing: first, second, top),
];

/// The structs of vertices and instances.
pub const VERTICES: [VertexMirror; 3] = [
    VertexMirror {
        mirror: mirror!(Piece: place, second_axis_index_brightness, place_radius, form, turn, light, pattern, spin, rim),
        layout: Piece::LAYOUT,
    },
    VertexMirror { mirror: mirror!(Corner: profile, turn), layout: Corner::LAYOUT },
    VertexMirror {
        mirror: mirror!(MeshInstance: place_radius, form, turn, light, width_brightness_index, pattern, spin, rim, copy),
        layout: MeshInstance::LAYOUT,
    },
];

/// Returns the number of pipelines that draw bodies and backdrops, as far as they are made on `gpu`.
#[must_use]
pub fn pipelines(gpu: &Gpu) -> usize {
    gpu.cache.bodies.made() + gpu.cache.last_passes.made()
}

/// Returns every shader.
#[must_use]
pub fn shaders() -> Vec<Shader> {
    let pass = backdrop::LastPass {
        part: backdrop::BackdropPart::Street,
        street: StreetVariant::Daylit,
        is_conformal: true,
        is_oblique: true,
    };
    let backdrop = Shader {
        name: "backdrop".to_owned(),
        source: shaders::BACKDROP.concat(),
        constants: Sampling::CHOSEN.among(pass.constants()),
    };
    let compose = Shader {
        name: "compose".to_owned(),
        source: shaders::COMPOSE.concat(),
        constants: compose::ComposeVariant::Rows.constants().to_vec(),
    };
    let bodies = Kind::ALL.iter().flat_map(|&kind| {
        [
            ("impostor", rays::TECHNIQUE),
            ("impostor as pixels", rays::TECHNIQUE_AS_PIXELS),
            ("mesh", mesh::TECHNIQUE),
        ]
        .map(|(name, technique)| of_bodies(kind, name, &technique))
    });
    bodies.chain([backdrop, compose]).collect()
}

fn of_bodies(kind: Kind, name: &str, technique: &Technique) -> Shader {
    let output = Output::Picture {
        is_thin: false,
        is_patterned: true,
        effects: Effects::new(true, &Appearance::default()),
    };
    let key = Key {
        kind,
        geometry: Geometry::Seen,
        is_conformal: true,
        is_oblique: true,
        among_others: None,
        turns: Turns::About,
        output,
    };
    Shader {
        name: format!("{name} of a {kind:?}"),
        source: (technique.source)(kind).concat(),
        constants: technique.constants(key, Sampling::CHOSEN),
    }
}
