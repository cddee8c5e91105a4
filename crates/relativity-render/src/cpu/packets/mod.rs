//! The rays on the CPU: a test per pixel, in the rest frame and in f32, eight pixels at a time.
//!
//! The same formulas as in `shaders/`, function by function, so that it is as accurate as
//! [`rays`](crate::gpu::rays); it needs no graphics adapter, and is faster than one that is software. A tile
//! of the picture looks for bodies in the hierarchies, about the nearest first, and stops behind what covers
//! it; each packet of eight pixels leaves out bodies that it does not show before it tests them closely.

mod body;
mod edge;
mod light;
mod logarithm;
mod look;
mod mercator;
mod model;
mod places;
mod ray;
mod shape;
mod street;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
mod tile;
mod wheel;

use fearless_simd::Level;

use crate::frame::hit_numbers::HitNumbers;
use crate::picture::hit::HitImage;
use crate::picture::pixels::Picture;
use crate::scene::prepared_scene::PreparedScene;
use crate::simd::registers::{on_registers, widest};
use crate::view::{Appearance, View};
use light::tables::Tables;
use look::Look;
use tile::shading::shade_backdrop;
use tile::{CENTRE, STANDARD};

/// Draws on the CPU.
#[derive(Debug)]
pub struct PacketRenderer {
    level: Level,
}

impl PacketRenderer {
    /// Returns a renderer for this processor; `None` where it has no vector registers.
    pub fn new() -> Option<Self> {
        Some(Self { level: widest()? })
    }

    /// Returns the picture of `scene` in `view`, drawn while `goes_on` is true, which is evaluated before
    /// each tile: tiles that are not drawn have no colour and no opacity.
    pub fn picture_while(
        &self,
        scene: &PreparedScene,
        view: &View,
        appearance: &Appearance,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Picture {
        let look = Look::new(scene, view, Some(appearance));
        let tables = Tables::shared();
        let rgba = scene.tiles(view, &look.views, &|_| goes_on(), |tile, rows| {
            on_registers!(self.level, simd => {
                if let Some(cap) = &tile.cap {
                    let drawn = look.draw(simd, &STANDARD, tile, cap);
                    if !drawn.packets.is_empty() {
                        return drawn.shade(simd, &look, appearance, tables, &tile.tile, rows);
                    }
                }
                shade_backdrop(simd, &look, &tile.tile, rows);
            });
        });
        Picture { size: view.camera.size, rgba }
    }

    /// Returns the hits of `scene` at the centre of every pixel of `view`.
    pub fn hits(&self, scene: &PreparedScene, view: &View) -> HitImage {
        let look = Look::new(scene, view, None);
        let both = scene.tiles(view, &look.views, &|_| true, |tile, rows| {
            let Some(cap) = &tile.cap else { return };
            on_registers!(self.level, simd => {
                look.draw(simd, &CENTRE, tile, cap).measure(simd, &look, &tile.tile, rows);
            });
        });
        let (measures, places) = both.into_iter().unzip();
        HitNumbers { measures, places }.hit_image(scene, view)
    }
}
