//! From linear sRGB to bytes.

use std::sync::LazyLock;

use fearless_simd::u32x8;

use crate::colour::LEAST;
use crate::simd::lanes::{F, LANES, Simd, SimdBase as _, SimdFrom as _, V3, clamp};

/// Number of the digits of a float after those of its cell: in none of these does more than one level begin.
const DIGITS: u32 = 16;
/// Cells from [`LEAST_TOLD`] to 2 and beyond.
const CELLS: usize = 0x800;
/// 2^-15: below lies the level 0 alone, and here the last digits of a cell's number are 0.
const LEAST_TOLD: f32 = 1.0 / 32_768.0;

/// First level of each cell, in front of [`DIGITS`] digits that are as far from full as the next level is
/// from the start of the cell: the sum with the rest of a float's digits begins with its level.
static LEVELS: LazyLock<[u32; CELLS]> = LazyLock::new(|| {
    let least = LEAST.map(|least| {
        let nearest = least as f32;
        if f64::from(nearest) < least { nearest.next_up() } else { nearest }.to_bits()
    });
    std::array::from_fn(|cell| {
        let first = LEAST_TOLD.to_bits() + ((cell as u32) << DIGITS);
        let level = least.partition_point(|least| *least <= first);
        let next = least.get(level).filter(|next| **next >> DIGITS == first >> DIGITS);
        ((level as u32) << DIGITS) + next.map_or(0, |next| (1 << DIGITS) - (next - first))
    })
});

/// The bytes red, green, blue and 255 of each: those of [`srgb_level`](crate::colour::srgb_level).
#[inline(always)]
pub fn encoded<S: Simd>(simd: S, linear: V3<S>) -> [[u8; 4]; LANES] {
    let table = &*LEVELS;
    let red = level(simd, table, linear.x);
    let green = level(simd, table, linear.y) << 8;
    let blue = level(simd, table, linear.z) << 16;
    let together: [u32; LANES] = (red | green | blue | u32x8::splat(simd, 255 << 24)).into();
    together.map(u32::to_le_bytes)
}

#[inline(always)]
fn level<S: Simd>(simd: S, table: &[u32; CELLS], linear: F<S>) -> u32x8<S> {
    let told = clamp(linear, F::splat(simd, LEAST_TOLD), F::splat(simd, 1.0));
    let bits = simd.reinterpret_u32_f32x8(told);
    let cells: [u32; LANES] = ((bits >> DIGITS) & (CELLS as u32 - 1)).into();
    let begun = u32x8::simd_from(simd, cells.map(|cell| table[cell as usize % CELLS]));
    (begun + (bits & ((1 << DIGITS) - 1))) >> DIGITS
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::srgb_level;
    use crate::cpu::packets::testing::at_every_level;

    /// Every float near where a level begins, and many between.
    #[test]
    fn bytes_are_those_of_the_curve() {
        let begin = LEAST.map(|least| (least as f32).to_bits());
        let near = begin.iter().flat_map(|bits| bits - 40..bits + 40);
        let all = near.chain((0..=1.0_f32.to_bits()).step_by(997));
        let mut values: Vec<_> = all.map(f32::from_bits).chain([-1.0, 1.0, 1.5, 1e30]).collect();
        values.resize(values.len().next_multiple_of(LANES), 0.5);
        at_every_level!(simd => {
            for packet in values.as_chunks::<LANES>().0 {
                let part = F::simd_from(simd, *packet);
                let found = encoded(simd, V3::new(part, 1.0 - part, part * 0.5));
                for (value, found) in packet.iter().zip(found) {
                    let expected = [*value, 1.0 - value, value * 0.5].map(|part| srgb_level(part.into()));
                    assert_eq!(found, [expected[0], expected[1], expected[2], 255], "{value}");
                }
            }
        });
    }
}
