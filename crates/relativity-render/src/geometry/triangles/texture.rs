//! Textures: pictures whose colours are the paint of triangles, and smaller copies of them for what is seen
//! from afar.
//!
//! Texels are encoded as sRGB, and are averaged in linear light: between the nearest four, and between the
//! two copies whose texels are about as large as a sample of the picture (trilinear filtering). A sample that
//! covers more of a texture one way than the other takes the larger of the two: seen aslant, a texture is
//! smoother than it needs to be and never breaks up.
//!
//! # Accuracy
//!
//! Each copy is rounded to sRGB of 8 bits: its colours are within half a level of the averages of the copy
//! that it is made of.

use std::array::from_fn;
use std::ops::Range;
use std::sync::{Arc, LazyLock};

use relativity_core::math::log2;

use super::error::TrianglesError;
use crate::colour::{srgb_decoded, srgb_level};

/// The linear value of each level of sRGB.
static LINEAR: LazyLock<[f32; 256]> =
    LazyLock::new(|| from_fn(|level| srgb_decoded(level as f64 / 255.0) as f32));

/// A picture, and how it goes on beyond its edges.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Texture {
    /// Width and height, texels.
    pub size: [u32; 2],
    /// Red, green and blue in sRGB, and the opacity, row by row from the top left.
    pub texels: Vec<[u8; 4]>,
    /// The continuation to the left and right, and above and below.
    pub wrap: [Wrap; 2],
    /// The least opacity at which there is a surface, in parts of 65535: 0 where there is one everywhere.
    pub cutoff: u16,
}

impl Texture {
    /// Makes the smaller copies of the texture, to be shared by models.
    ///
    /// # Errors
    ///
    /// No texel, or not as many as the size needs.
    pub fn prepared(self) -> Result<Arc<MipMap>, TrianglesError> {
        let count = self.size.map(u64::from).iter().product::<u64>();
        if count == 0 || count != self.texels.len() as u64 {
            return Err(TrianglesError::Texture);
        }
        Ok(Arc::new(MipMap::new(self)))
    }
}

/// The continuation of a texture beyond its edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Wrap {
    /// Copies of the texture follow each other.
    #[default]
    Repeat,
    /// Copies follow each other, every second one mirrored.
    Mirror,
    /// The texels at the edge are continued.
    Clamp,
}

/// A texture, and copies of half its size, a quarter, and so on down to one texel.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MipMap {
    /// Texels of the texture and of all its copies, one after the other: as [`Texture::texels`].
    pub texels: Vec<[u8; 4]>,
    /// Size of each, and the number of its first texel; the texture itself comes first.
    pub levels: Vec<Level>,
    /// The continuation of the texture, see [`Texture::wrap`].
    pub wrap: [Wrap; 2],
    /// The least opacity of a surface, see [`Texture::cutoff`].
    pub cutoff: u16,
}

/// A texture or a copy of it among the texels of a [`MipMap`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Level {
    /// Width and height, texels.
    pub size: [u32; 2],
    /// Number of its first texel.
    pub first: usize,
}

impl Wrap {
    /// Returns the place in a row of `count` texels of the one `number` places behind its first.
    fn place(self, number: i64, count: i64) -> i64 {
        match self {
            Self::Repeat => number.rem_euclid(count),
            Self::Mirror => {
                let there = number.rem_euclid(2 * count);
                there.min(2 * count - 1 - there)
            }
            Self::Clamp => number.clamp(0, count - 1),
        }
    }
}

impl MipMap {
    /// The number of texels of the texture, without its copies.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.levels.first().map_or(0, |level| level.size.map(u64::from).iter().product())
    }

    /// Makes the copies of `texture`, whose size is not 0 and counts its texels.
    fn new(texture: Texture) -> Self {
        let Texture { size, mut texels, wrap, cutoff } = texture;
        // The copies together: a third, and a little more of one that is narrow.
        texels.reserve_exact(texels.len() / 3 + 2 * (size[0].max(size[1]) as usize));
        let mut map = Self { texels, levels: vec![Level { size, first: 0 }], wrap, cutoff };
        while let Some(&last) = map.levels.last().filter(|level| level.size != [1, 1]) {
            let next = Level { size: last.size.map(|side| (side / 2).max(1)), first: map.texels.len() };
            let [rows, columns] = [1, 0].map(|side| TexelShares::new(last.size[side], next.size[side]));
            for row in 0..next.size[1] {
                for column in 0..next.size[0] {
                    let texel = map.average(last, &columns.of(column), rows.of(row));
                    map.texels.push(texel);
                }
            }
            map.levels.push(next);
        }
        map
    }

    /// Returns the average, in linear light, over these columns and rows of `level`, with their shares.
    fn average(
        &self,
        level: Level,
        columns: &(impl Iterator<Item = (u32, f64)> + Clone),
        rows: impl Iterator<Item = (u32, f64)>,
    ) -> [u8; 4] {
        let mut sum = [0.0; 3];
        for (row, height) in rows {
            for (column, width) in columns.clone() {
                let texel = self.texels[level.first + (row * level.size[0] + column) as usize];
                for (sum, part) in sum.iter_mut().zip(texel) {
                    *sum += width * height * f64::from(LINEAR[usize::from(part)]);
                }
            }
        }
        let [red, green, blue] = sum.map(srgb_level);
        [red, green, blue, u8::MAX]
    }

    /// Returns the linear colour at a `place` (as
    /// [`Model::texture_places`](super::RawModel::texture_places)), on average over about as much as is
    /// `covered` of it each way, in widths and heights of the texture.
    pub(super) fn colour(&self, place: [f64; 2], covered: [f64; 2]) -> [f64; 3] {
        let texels = [0, 1].map(|side| covered[side] * f64::from(self.levels[0].size[side]));
        let last = (self.levels.len() - 1) as f64;
        let depth = log2(texels[0].max(texels[1]).max(1.0)).min(last);
        let (nearer, share) = (depth.floor(), depth.fract());
        let large = self.between(self.levels[nearer as usize], place);
        if share == 0.0 {
            return large;
        }
        let small = self.between(self.levels[nearer as usize + 1], place);
        from_fn(|part| large[part] + share * (small[part] - large[part]))
    }

    /// Whether there is a surface at a `place`: the opacity of the texture itself, between the nearest four
    /// texels, is not below its cutoff.
    pub(super) fn is_solid(&self, place: [f64; 2]) -> bool {
        let opacity: f64 =
            self.nearest(self.levels[0], place).map(|(texel, share)| share * f64::from(texel[3])).sum();
        opacity * 257.0 >= f64::from(self.cutoff)
    }

    /// Returns the linear colour at a `place` of `level`, between the nearest four texels.
    fn between(&self, level: Level, place: [f64; 2]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (texel, share) in self.nearest(level, place) {
            for (sum, part) in sum.iter_mut().zip(texel) {
                *sum += share * f64::from(LINEAR[usize::from(part)]);
            }
        }
        sum
    }

    /// Returns the four texels of `level` that are nearest to a `place`, with their shares.
    fn nearest(&self, level: Level, place: [f64; 2]) -> impl Iterator<Item = ([u8; 4], f64)> + use<'_> {
        let [columns, rows] = [0, 1].map(|side| {
            let at = place[side] * f64::from(level.size[side]) - 0.5;
            let count = i64::from(level.size[side]);
            let near = [0, 1].map(|next| self.wrap[side].place(at.floor() as i64 + next, count) as usize);
            [(near[0], 1.0 - (at - at.floor())), (near[1], at - at.floor())]
        });
        rows.into_iter().flat_map(move |(row, height)| {
            columns.into_iter().map(move |(column, width)| {
                (self.texels[level.first + row * level.size[0] as usize + column], width * height)
            })
        })
    }
}

/// The shares that the texels of a row have in those of a shorter one.
struct TexelShares {
    /// Length of the row in that of the shorter one.
    step: f64,
    count: u32,
}

impl TexelShares {
    fn new(count: u32, fewer: u32) -> Self {
        Self { step: f64::from(count) / f64::from(fewer), count }
    }

    /// The texels that make up that of this `number`, with their shares.
    fn of(&self, number: u32) -> impl Iterator<Item = (u32, f64)> + Clone {
        let [low, high] = [0.0, 1.0].map(|end| (f64::from(number) + end) * self.step);
        let texels: Range<u32> = low as u32..(high.ceil() as u32).min(self.count);
        let step = self.step;
        texels.map(move |texel| {
            let covered = high.min(f64::from(texel) + 1.0) - low.max(f64::from(texel));
            (texel, covered.max(0.0) / step)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texture(size: [u32; 2], wrap: Wrap) -> Texture {
        let texel = |i: u32| [(i * 37 % 256) as u8, (i * 101 % 256) as u8, (i * 11 % 256) as u8, 255];
        Texture { size, texels: (0..size[0] * size[1]).map(texel).collect(), wrap: [wrap; 2], cutoff: 0 }
    }

    /// Every copy has the brightness of the texture, as nothing is lost or counted twice: of odd sizes too.
    #[test]
    fn copies_keep_the_average() {
        for size in [[16, 8], [13, 7], [1, 5], [9, 1]] {
            let map = MipMap::new(texture(size, Wrap::Repeat));
            assert_eq!(map.levels.last().map(|level| level.size), Some([1, 1]));
            let average = |level: &Level| {
                let count = (level.size[0] * level.size[1]) as usize;
                let texels = &map.texels[level.first..level.first + count];
                texels.iter().map(|texel| f64::from(LINEAR[usize::from(texel[1])])).sum::<f64>()
                    / count as f64
            };
            let whole = average(&map.levels[0]);
            for level in &map.levels {
                // A level of sRGB is at most 1/110 of linear light.
                assert!((average(level) - whole).abs() < 0.01, "{size:?}: {level:?}");
            }
        }
    }

    #[test]
    fn the_middle_of_a_texel_has_its_colour_and_edges_go_on() {
        for (wrap, expected) in [(Wrap::Repeat, 3), (Wrap::Mirror, 0), (Wrap::Clamp, 0)] {
            let map = MipMap::new(texture([4, 1], wrap));
            let level = |place: f64| map.colour([place, 0.5], [0.0; 2])[0];
            let texel = |number: usize| f64::from(LINEAR[usize::from(map.texels[number][0])]);
            assert_eq!(level(0.375), texel(1));
            assert!((level(0.5) - 0.5 * (texel(1) + texel(2))).abs() < 1e-12);
            assert_eq!(level(-0.125), texel(expected), "{wrap:?}");
            // All of it, and more.
            let all = map.colour([0.3, 0.5], [1e6; 2])[0];
            assert_eq!(all, f64::from(LINEAR[usize::from(map.texels[map.levels[2].first][0])]));
        }
        assert_eq!(Wrap::Mirror.place(-1, 4), 0);
        assert_eq!(Wrap::Mirror.place(4, 4), 3);
        assert_eq!(Wrap::Mirror.place(8, 4), 0);
    }
}
