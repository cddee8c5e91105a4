//! The rays on the CPU: a test per pixel, in the rest frame and in f32, eight pixels at a time.
//!
//! The same formulas as in `shaders/`, function by function, so that it is as accurate as [`rays`](crate::rays); it needs
//! no graphics adapter, and is faster than one that is software. A tile of the picture looks for bodies in the
//! hierarchies, about the nearest first, and stops behind what covers it.
#![expect(clippy::inline_always, reason = "what runs on wide registers must be inlined into where they are chosen")]

mod backdrop;
mod body;
mod encode;
mod lanes;
mod look;
mod numbers;
mod passing;
mod shading;
mod street;
#[cfg(test)]
mod testing;
mod tile;

use fearless_simd::{Level, dispatch};

use crate::canvas::Measures;
use crate::picture::Picture;
use crate::reference::HitImage;
use crate::scene::PreparedScene;
use crate::view::{Appearance, View};
use look::Look;
use tile::{CENTRE, STANDARD};

/// Draws on the CPU.
#[derive(Debug)]
pub struct PacketRenderer {
    level: Level,
    tables: colour::Tables,
}

impl Default for PacketRenderer {
    fn default() -> Self {
        Self { level: Level::new(), tables: colour::Tables::new() }
    }
}

impl PacketRenderer {
    /// The picture `view` shows of `scene`.
    pub fn picture(&self, scene: &PreparedScene, view: &View, appearance: &Appearance) -> Picture {
        let look = Look::new(scene, view, Some(appearance));
        let width = view.camera.size[0];
        let rgba = scene.tiles(view, &look.views, |tile, rows| {
            dispatch!(self.level, simd => look.draw(simd, &STANDARD, &tile).shade(simd, &look, &self.tables, &tile.tile, width, rows));
        });
        Picture { size: view.camera.size, rgba }
    }

    /// What the centre of every pixel of `view` shows of `scene`.
    pub fn hits(&self, scene: &PreparedScene, view: &View) -> HitImage {
        let look = Look::new(scene, view, None);
        let width = view.camera.size[0];
        let both = scene.tiles(view, &look.views, |tile, rows| {
            dispatch!(self.level, simd => look.draw(simd, &CENTRE, &tile).measure(simd, &look, &tile.tile, width, rows));
        });
        let (measures, places) = both.into_iter().unzip();
        Measures { measures, places }.hit_image(scene, view)
    }
}
