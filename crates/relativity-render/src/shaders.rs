//! The shaders' sources, put together from `shaders/`, and the structs they share with Rust.

use std::mem::offset_of;

use crate::exact::Instance;
use crate::frame::Frame;

pub(crate) const TUBE: &str = concat!(
    include_str!("../shaders/frame.wgsl"),
    include_str!("../shaders/colour.wgsl"),
    include_str!("../shaders/body.wgsl"),
    include_str!("../shaders/impostor.wgsl"),
    include_str!("../shaders/tube.wgsl"),
);
pub(crate) const RING: &str = concat!(
    include_str!("../shaders/frame.wgsl"),
    include_str!("../shaders/colour.wgsl"),
    include_str!("../shaders/body.wgsl"),
    include_str!("../shaders/impostor.wgsl"),
    include_str!("../shaders/ring.wgsl"),
);
pub(crate) const MESH_TUBE: &str = concat!(
    include_str!("../shaders/frame.wgsl"),
    include_str!("../shaders/colour.wgsl"),
    include_str!("../shaders/body.wgsl"),
    include_str!("../shaders/tube.wgsl"),
    include_str!("../shaders/mesh.wgsl"),
    include_str!("../shaders/mesh_tube.wgsl"),
);
pub(crate) const MESH_RING: &str = concat!(
    include_str!("../shaders/frame.wgsl"),
    include_str!("../shaders/colour.wgsl"),
    include_str!("../shaders/body.wgsl"),
    include_str!("../shaders/ring.wgsl"),
    include_str!("../shaders/mesh.wgsl"),
    include_str!("../shaders/mesh_ring.wgsl"),
);
pub(crate) const BACKDROP: &str =
    concat!(include_str!("../shaders/frame.wgsl"), include_str!("../shaders/backdrop.wgsl"));

/// Every shader, by name.
pub const SOURCES: [(&str, &str); 5] = [
    ("tube", TUBE),
    ("ring", RING),
    ("mesh of a tube", MESH_TUBE),
    ("mesh of a ring", MESH_RING),
    ("backdrop", BACKDROP),
];

/// The layout that Rust gives a struct of the shaders.
#[derive(Debug)]
pub struct Mirror {
    /// Its name in the shaders.
    pub name: &'static str,
    /// Its fields and their offsets, bytes.
    pub fields: &'static [(&'static str, usize)],
    /// Its size, bytes.
    pub size: usize,
}

/// The structs that exist on both sides.
pub const MIRRORS: [Mirror; 2] = [
    Mirror {
        name: "Frame",
        fields: &[
            ("base", offset_of!(Frame, base)),
            ("right", offset_of!(Frame, right)),
            ("down", offset_of!(Frame, down)),
            ("pole", offset_of!(Frame, pole)),
            ("speed", offset_of!(Frame, speed)),
            ("light", offset_of!(Frame, light)),
            ("scene", offset_of!(Frame, scene)),
            ("scene_fine", offset_of!(Frame, scene_fine)),
            ("ground", offset_of!(Frame, ground)),
            ("backdrop", offset_of!(Frame, backdrop)),
            ("clip_right", offset_of!(Frame, clip_right)),
            ("clip_up", offset_of!(Frame, clip_up)),
            ("forward", offset_of!(Frame, forward)),
        ],
        size: size_of::<Frame>(),
    },
    Mirror {
        name: "Instance",
        fields: &[
            ("place", offset_of!(Instance, place)),
            ("second_axis_index_wavelength", offset_of!(Instance, second_axis_index_wavelength)),
            ("place_radius", offset_of!(Instance, place_radius)),
            ("form", offset_of!(Instance, form)),
            ("rest_colour", offset_of!(Instance, rest_colour)),
        ],
        size: size_of::<Instance>(),
    },
];
