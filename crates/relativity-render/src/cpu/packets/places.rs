//! Places of the packets in a tile of 8 x 8 pixels, and their pixels.

use crate::picture::candidates::PixelRows;
use crate::picture::tiles::Tile;
use crate::simd::lanes::{F, LANES, Simd, SimdFrom};

/// Packets of a tile: four pixels wide and two high.
pub const PACKETS: usize = 8;
/// The pixel at the top left of the packet of this number, in the tile with this `corner`.
pub fn packet_places([left, top]: [u32; 2], packet: usize) -> [u32; 2] {
    [left + 4 * (packet as u32 % 2), top + 2 * (packet as u32 / 2)]
}

/// The centres of the pixels of a packet.
#[inline(always)]
pub fn centres<S: Simd>(simd: S, [left, top]: [u32; 2]) -> [F<S>; 2] {
    let u: [f32; LANES] = std::array::from_fn(|lane| (left + lane as u32 % 4) as f32 + 0.5);
    let v: [f32; LANES] = std::array::from_fn(|lane| (top + lane as u32 / 4) as f32 + 0.5);
    [F::simd_from(simd, u), F::simd_from(simd, v)]
}

/// The pixel in this lane of the packet with this corner.
#[inline(always)]
pub fn pixel_of_lane([left, top]: [u32; 2], lane: usize) -> [u32; 2] {
    [left + lane as u32 % 4, top + lane as u32 / 4]
}

/// Writes the pixel in this lane of the packet with this corner, if it is in `tile`, into the rows that that
/// is in.
#[inline(always)]
pub fn write_one<T>(tile: &Tile, [left, top]: [u32; 2], rows: &mut PixelRows<'_, T>, lane: usize, value: T) {
    let [u, v] = pixel_of_lane([left, top], lane);
    if u < tile.corner[0] + tile.size[0] && v < tile.corner[1] + tile.size[1] {
        rows.put([u, v], value);
    }
}
