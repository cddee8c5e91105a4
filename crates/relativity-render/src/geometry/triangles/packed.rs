//! Triangles as the shaders read them: records of four texels, which are four words each.
//!
//! The boxes of a model are divided in two there, as a shader looks through them with one ray: a record is a
//! node, with both boxes in it, or a triangle. Nodes come first, the one around all before the others.
//!
//! | texel | node | triangle |
//! |---|---|---|
//! | 0 | middle of the first box, its link | first corner, number of the triangle |
//! | 1 | half of its sides, 0 | second corner, paint and one more than the number of its material |
//! | 2 | middle of the second box, its link | third corner, its places |
//! | 3 | half of its sides, 0 | paint |
//!
//! A link is the number of a node; or, with the highest bit set, the record of the first triangle of a leaf,
//! and in the two bits below one less than how many follow. Paint is 16 bits a reflectance.
//!
//! Behind the records of a model with textures come two texels for each triangle, whose number its record has
//! (0 is none): the places of its corners in its texture, the number of the texture's header, and 1 where a
//! measured material takes the place of the texture, of which its holes are left. The header is one texel:
//! width, height, wrapping with the cutoff in its upper half, and the number of the first of its words, which
//! are the texels of the texture and its smaller copies. They may lie behind those of other models, which
//! share them.

use glam::Vec3;

use super::texture::MipMap;
use super::{RawModel, TrianglePoint, Triangles};
use crate::geometry::hierarchy::{Child, Content};

/// Four words, which the shaders take for floats or for bits.
pub(crate) type Texel = [u32; 4];
/// Number of texels in a record.
pub(crate) const TEXELS: usize = 4;
/// Greatest number of links that wait while a shader looks into a model: each node on the way to a leaf
/// leaves one.
pub(crate) const MOST_WAITING: usize = 64;

/// Greatest number of triangles in a leaf.
const LEAF: usize = 4;
/// Marks the link of a leaf.
const IS_LEAF: u32 = 1 << 31;
/// Place of a leaf's count in its link.
const COUNT_AT: u32 = 29;
/// Room around boxes, as a part of the model's size: the shaders test them in f32, which is off by less than
/// half of that.
const ROOM: f32 = 2e-6;

/// A model for the shaders.
#[derive(Debug)]
pub(crate) struct PackedModel {
    /// Texels of all records.
    pub texels: Vec<Texel>,
    /// Greatest number of links that wait.
    pub waiting: usize,
    /// Number of the first header of its textures, in which the number of the first word is not yet filled
    /// in.
    pub headers: usize,
}

/// The records of a model while it is packed.
struct Records<'a> {
    triangles: &'a Triangles,
    nodes: Vec<[Texel; TEXELS]>,
    /// Numbers of the triangles, in the order of their records.
    leaves: Vec<u32>,
    depth: usize,
    room: f32,
}

impl Triangles {
    /// Packs them for the shaders.
    pub(crate) fn packed(&self) -> PackedModel {
        let Records { mut nodes, leaves, depth, .. } = Records::new(self);
        let first = nodes.len() as u32;
        for link in nodes.iter_mut().flat_map(|[a, _, b, _]| [&mut a[3], &mut b[3]]) {
            if *link & IS_LEAF != 0 {
                *link += first;
            }
        }
        let triangles = leaves.iter().flat_map(|&triangle| self.record(triangle));
        let mut texels: Vec<_> = nodes.into_iter().flatten().chain(triangles).collect();
        if !self.textures.is_empty() {
            self.add_places(&leaves, TEXELS * first as usize, &mut texels);
        }
        let headers = texels.len();
        texels.extend(self.textures.iter().map(|texture| {
            let ([width, height], [across, down]) = (texture.levels[0].size, texture.wrap);
            [width, height, across as u32 | (down as u32) << 8 | u32::from(texture.cutoff) << 16, 0]
        }));
        PackedModel { texels, waiting: depth, headers }
    }

    /// Adds the places in textures of the triangles in `leaves`, whose records begin with the texel of this
    /// number; the headers come behind.
    fn add_places(&self, leaves: &[u32], records: usize, texels: &mut Vec<Texel>) {
        let headers = texels.len() + 2 * leaves.len();
        for (record, &triangle) in leaves.iter().enumerate() {
            let number = self.texture_numbers.get(triangle as usize).copied().unwrap_or(RawModel::NO_TEXTURE);
            let is_measured = self.material(triangle).is_some();
            let has_holes = self.textures.get(number as usize).is_some_and(|texture| texture.cutoff > 0);
            if number == RawModel::NO_TEXTURE || (is_measured && !has_holes) {
                texels.extend([Texel::default(); 2]);
                continue;
            }
            texels[records + TEXELS * record + 2][3] = texels.len() as u32;
            let places = self.faces[triangle as usize].map(|corner| self.texture_places[corner as usize]);
            let [[au, av], [bu, bv], [cu, cv]] = places.map(|place| place.map(f32::to_bits));
            texels.extend([[au, av, bu, bv], [cu, cv, (headers as u32) + number, u32::from(is_measured)]]);
        }
    }

    /// Returns the record of the first triangle when they are packed, and the numbers of all in the order of
    /// their records.
    pub(crate) fn packed_order(&self) -> (u32, Vec<u32>) {
        let Records { nodes, leaves, .. } = Records::new(self);
        (nodes.len() as u32, leaves)
    }

    fn record(&self, triangle: u32) -> [Texel; TEXELS] {
        let corners = self.faces[triangle as usize];
        let paints = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]
            .map(|weights| self.corner_paint(TrianglePoint { triangle, weights }));
        let paint = |corner: usize, part: usize| (paints[corner][part] * 65535.0).round() as u32;
        let both = |low: u32, high: u32| low | high << 16;
        let material = self.material(triangle).map_or(0, |material| material.number() as u32 + 1);
        let [a, b, c] = corners.map(|corner| self.corners[corner as usize]);
        [
            texel(a, triangle),
            texel(b, both(paint(2, 2), material)),
            texel(c, 0),
            [
                both(paint(0, 0), paint(0, 1)),
                both(paint(0, 2), paint(1, 0)),
                both(paint(1, 1), paint(1, 2)),
                both(paint(2, 0), paint(2, 1)),
            ],
        ]
    }
}

/// Returns the texels of a texture and its copies, four in each.
pub(crate) fn packed_texture(texture: &MipMap) -> impl Iterator<Item = Texel> {
    let word = |texel: Option<&[u8; 4]>| texel.map_or(0, |texel| u32::from_le_bytes(*texel));
    texture.texels.chunks(4).map(move |chunk| std::array::from_fn(|i| word(chunk.get(i))))
}

impl<'a> Records<'a> {
    fn new(triangles: &'a Triangles) -> Self {
        let room = ROOM * triangles.half.length() as f32;
        let mut records = Self { triangles, nodes: Vec::new(), leaves: Vec::new(), depth: 0, room };
        let mut all: Vec<_> = triangles.hierarchy.children(0).collect();
        records.add_node(&mut all, 1);
        records
    }

    /// Adds the node around `children`, at this depth, and what is in it; returns its link.
    fn add_node(&mut self, children: &mut [Child], depth: usize) -> u32 {
        self.depth = self.depth.max(depth);
        let place = self.nodes.len();
        self.nodes.push([[0; 4]; TEXELS]);
        let (low, high) = bounds(children);
        let axis = (high - low).max_position();
        children.sort_unstable_by(|a, b| a.centre[axis].total_cmp(&b.centre[axis]));
        let (first, second) = children.split_at_mut(children.len().div_ceil(2));
        for (half, children) in [first, second].into_iter().enumerate() {
            let (low, high) = bounds(children);
            // No ray meets a box of no size below 0.
            let sides = if children.is_empty() { Vec3::NEG_ONE } else { 0.5 * (high - low) + self.room };
            let middle = if children.is_empty() { Vec3::ZERO } else { 0.5 * (low + high) };
            let link = self.link(children, depth + 1);
            self.nodes[place][2 * half] = texel(middle, link);
            self.nodes[place][2 * half + 1] = texel(sides, 0);
        }
        place as u32
    }

    /// Adds what is in the box around `children`; returns its link.
    fn link(&mut self, children: &mut [Child], depth: usize) -> u32 {
        if let [Child { content: Content::Node(node), .. }] = *children {
            let mut inner: Vec<_> = self.triangles.hierarchy.children(node).collect();
            return self.link(&mut inner, depth);
        }
        let triangle = |child: &Child| match child.content {
            Content::Body(triangle) => Some(triangle),
            Content::Node(_) => None,
        };
        let first = self.leaves.len();
        if children.len() <= LEAF && children.iter().all(|child| triangle(child).is_some()) {
            self.leaves.extend(children.iter().filter_map(triangle));
            let more = (self.leaves.len() - first).saturating_sub(1) as u32;
            return IS_LEAF | more << COUNT_AT | first as u32;
        }
        self.add_node(children, depth)
    }
}

/// The lowest and the highest corner of the box around `children`.
fn bounds(children: &[Child]) -> (Vec3, Vec3) {
    children.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), child| {
        (low.min(child.centre - child.half), high.max(child.centre + child.half))
    })
}

fn texel(place: Vec3, word: u32) -> Texel {
    let [x, y, z] = place.to_array().map(f32::to_bits);
    [x, y, z, word]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Triangles of all sizes that have an area in f32, strewn about.
    fn strewn(count: u32) -> Triangles {
        let part = |i: u32, k: u32| (f64::from(i) * f64::from(k).sqrt()).fract();
        let corner = |i: u32| {
            let (triangle, size) = (i / 3, 0.001 + part(i / 3, 11).powi(4));
            [2, 3, 5].map(|k| part(triangle, k) + size * part(i * i, k + 5))
        };
        let triangles = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let model =
            RawModel { corners: (0..3 * count).map(corner).collect(), triangles, ..RawModel::default() };
        Triangles::new(model).expect("a model")
    }

    fn place(texel: Texel) -> Vec3 {
        Vec3::from([texel[0], texel[1], texel[2]].map(f32::from_bits))
    }

    /// Adds the numbers of the triangles that a link leads to, all of which lie between `low` and `high`.
    fn walk(texels: &[Texel], link: u32, low: Vec3, high: Vec3, found: &mut Vec<u32>) {
        if link & IS_LEAF == 0 {
            for half in texels[4 * link as usize..][..TEXELS].chunks(2) {
                let (middle, sides) = (place(half[0]), place(half[1]));
                if sides.x > 0.0 {
                    walk(texels, half[0][3], low.max(middle - sides), high.min(middle + sides), found);
                }
            }
            return;
        }
        let (first, more) = ((link << 3 >> 3) as usize, (link >> COUNT_AT & 3) as usize);
        for record in texels.chunks(TEXELS).skip(first).take(more + 1) {
            let corners = [0, 1, 2].map(|corner| place(record[corner]));
            assert!(corners.iter().all(|corner| corner.cmpge(low).all() && corner.cmple(high).all()));
            found.push(record[0][3]);
        }
    }

    #[test]
    fn each_triangle_is_in_one_leaf_and_in_all_boxes_around_it() {
        for count in [1, 2, 4, 5, 8, 9, 40, 3000] {
            let PackedModel { texels, waiting, .. } = strewn(count).packed();
            let mut found = Vec::new();
            walk(&texels, 0, Vec3::NEG_INFINITY, Vec3::INFINITY, &mut found);
            found.sort_unstable();
            assert_eq!(found, (0..count).collect::<Vec<_>>());
            assert!(waiting <= MOST_WAITING, "{waiting} of {count}");
        }
    }

    #[test]
    fn a_triangle_takes_64_bytes_and_16_to_64_for_boxes() {
        let bytes = strewn(3000).packed().texels.len() * size_of::<Texel>() / 3000;
        assert!((79..=128).contains(&bytes), "{bytes}");
    }
}
