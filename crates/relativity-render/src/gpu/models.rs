//! The models of a scene on the device, in one texture: made when a scene with others is drawn, not from
//! picture to picture.

use std::collections::HashMap;
use std::sync::{Arc, Weak};

use super::device::Gpu;
use super::target;
use crate::geometry::triangles::Triangles;
use crate::geometry::triangles::packed::{MOST_WAITING, PackedModel, TEXELS, Texel, packed_texture};
use crate::geometry::triangles::texture::MipMap;
use crate::scene::prepared_scene::PreparedScene;

/// Greatest length of a row, texels: a power of two, as every length is.
const LONGEST_ROW: u32 = 4096;
/// Format of a texel: bits, since no device may change those of a number that a float is not.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Uint;

/// The texture of a scene's models.
#[derive(Debug)]
pub struct Models {
    view: wgpu::TextureView,
    /// The models in it, each with the row that it begins with.
    held: Vec<(Weak<Triangles>, u32)>,
    /// The models that were found not to fit.
    too_large: Vec<Weak<Triangles>>,
}

impl Models {
    /// Returns a texture without models.
    pub fn new(gpu: &Gpu) -> Self {
        Self { view: filled(gpu, [1, 1], &[Texel::default()]), held: Vec::new(), too_large: Vec::new() }
    }

    /// The texture, for a bind group.
    pub const fn view(&self) -> &wgpu::TextureView {
        &self.view
    }

    /// Makes it the texture of the models of `scene`, unless it is. Returns whether the device can hold them;
    /// else it stays as it was.
    ///
    /// A triangle takes 64 bytes, and its share of the nodes 16 to 64.
    pub fn load(&mut self, gpu: &Gpu, scene: &PreparedScene) -> bool {
        let wanted = each_once(scene);
        if wanted.is_empty() || are_same(&wanted, self.held.iter().map(|(model, _)| model)) {
            return true;
        }
        if are_same(&wanted, self.too_large.iter()) {
            return false;
        }
        let Some(Arranged { rows, size, texels }) = Arranged::new(&wanted, gpu.largest_texture()) else {
            self.too_large = wanted.into_iter().map(Arc::downgrade).collect();
            return false;
        };
        self.held = wanted.into_iter().map(Arc::downgrade).zip(rows).collect();
        self.view = filled(gpu, size, &texels);
        true
    }

    /// Returns the row that a model begins with; 0 for one that is not there.
    pub fn row(&self, model: &Arc<Triangles>) -> u32 {
        let held = self.held.iter().find(|(held, _)| held.as_ptr() == Arc::as_ptr(model));
        held.map_or(0, |(_, row)| *row)
    }
}

/// Models in rows, each from the beginning of one, and their textures behind them, each once.
#[derive(Debug)]
struct Arranged {
    /// The row that each model begins with.
    rows: Vec<u32>,
    /// Texels in a row, and rows.
    size: [u32; 2],
    texels: Vec<Texel>,
}

impl Arranged {
    /// Arranges `models` in a texture with sides of at most this length; `None` if it is too small, or a
    /// model too deep for the shaders.
    fn new(models: &[&Arc<Triangles>], largest_side: u32) -> Option<Self> {
        let width = row_length(largest_side);
        let mut arranged = Self { rows: Vec::new(), size: [width, 0], texels: Vec::new() };
        let mut headers = Vec::new();
        for model in models {
            let PackedModel { texels, waiting, headers: first } = model.packed();
            headers.push(arranged.texels.len() + first);
            arranged.rows.push(arranged.size[1]);
            if waiting > MOST_WAITING || !arranged.has_room(texels.len(), largest_side) {
                return None;
            }
            arranged.texels.extend(texels);
            arranged.end_row();
        }
        let mut begun = HashMap::new();
        for ((model, header), row) in models.iter().zip(headers).zip(arranged.rows.clone()) {
            for (number, texture) in model.textures().iter().enumerate() {
                let first = match begun.get(&Arc::as_ptr(texture)) {
                    Some(first) => *first,
                    None => arranged.add(texture, largest_side)?,
                };
                begun.insert(Arc::as_ptr(texture), first);
                let from_model = first - width as usize * row as usize;
                arranged.texels[header + number][3] = u32::try_from(4 * from_model).ok()?;
            }
        }
        arranged.end_row();
        (width as usize >= TEXELS).then_some(arranged)
    }

    /// Adds a texture, and returns the number of its first texel; `None` if it does not fit.
    fn add(&mut self, texture: &MipMap, largest_side: u32) -> Option<usize> {
        let first = self.texels.len();
        if !self.has_room(texture.texels.len().div_ceil(4), largest_side) {
            return None;
        }
        self.texels.extend(packed_texture(texture));
        Some(first)
    }

    /// Whether there is room for `more` texels where the texture has at most this number of rows.
    const fn has_room(&self, more: usize, largest_side: u32) -> bool {
        (self.texels.len() + more).div_ceil(self.size[0] as usize) <= largest_side as usize
    }

    /// Fills the last row.
    fn end_row(&mut self) {
        let width = self.size[0] as usize;
        self.texels.resize(self.texels.len().next_multiple_of(width), Texel::default());
        self.size[1] = (self.texels.len() / width) as u32;
    }
}

/// Length of a row where textures are at most this wide.
const fn row_length(largest_side: u32) -> u32 {
    let longest = if largest_side < LONGEST_ROW { largest_side } else { LONGEST_ROW };
    1 << longest.ilog2()
}

/// The models of `scene`, each once, however many bodies share it.
fn each_once(scene: &PreparedScene) -> Vec<&Arc<Triangles>> {
    let mut models: Vec<_> = scene.models().collect();
    models.sort_unstable_by_key(|model| Arc::as_ptr(model));
    models.dedup_by_key(|model| Arc::as_ptr(model));
    models
}

fn are_same<'a>(
    wanted: &[&Arc<Triangles>],
    held: impl ExactSizeIterator<Item = &'a Weak<Triangles>>,
) -> bool {
    wanted.len() == held.len()
        && wanted.iter().zip(held).all(|(model, held)| held.as_ptr() == Arc::as_ptr(model))
}

fn filled(gpu: &Gpu, size: [u32; 2], texels: &[Texel]) -> wgpu::TextureView {
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    let texture = target::texture(gpu, "models", size, 1, FORMAT, usage);
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(size[0] * size_of::<Texel>() as u32),
        rows_per_image: None,
    };
    gpu.queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(texels), layout, texture.size());
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::triangles::{RawModel, Texture, Wrap};

    /// A band of triangles, about one of whose corners the next is turned.
    fn band(count: u32) -> Arc<Triangles> {
        let corner = |i: u32| [f64::from(i), f64::from(i % 2), 0.0];
        let triangles = (0..count).map(|i| [i, i + 1, i + 2]).collect();
        let model =
            RawModel { corners: (0..count + 2).map(corner).collect(), triangles, ..RawModel::default() };
        model.prepared().expect("a model")
    }

    #[test]
    fn models_that_do_not_fit_are_told() {
        let models = [band(40), band(7), band(40)];
        let models: Vec<_> = models.iter().collect();
        let Arranged { rows, size, texels } = Arranged::new(&models, 32).expect("there is room");
        assert!(size[0] == 32 && size[1] <= 32 && texels.len() as u32 == size[0] * size[1]);
        assert!(rows[0] == 0 && rows[1] > 5 && rows[2] > rows[1] && rows[2] + 5 < size[1], "{rows:?}");
        for too_small in [2, 8] {
            assert!(Arranged::new(&models, too_small).is_none());
        }
    }

    #[test]
    fn rows_are_powers_of_two_within_what_a_device_has() {
        assert_eq!([1, 2048, 3000, 4096, 16384, u32::MAX].map(row_length), [1, 2048, 2048, 4096, 4096, 4096]);
    }

    /// Two models with one texture, and one with two of them, have each texture once, whole, where their
    /// headers say.
    #[test]
    fn models_share_textures() {
        let texture = |first: u8| {
            let texels = (0..15).map(|i| [first + i, i, 7, 255]).collect();
            Texture { size: [5, 3], texels, wrap: [Wrap::Mirror; 2], cutoff: 0 }
                .prepared()
                .expect("a texture")
        };
        let (one, other) = (texture(0), texture(100));
        let square = |textures: &[&Arc<MipMap>]| {
            let model = RawModel {
                corners: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
                triangles: vec![[0, 1, 2], [0, 2, 3]],
                textures: textures.iter().map(|texture| Arc::clone(texture)).collect(),
                texture_numbers: vec![0, textures.len() as u32 - 1],
                texture_places: vec![[0.0; 2]; 4],
                ..RawModel::default()
            };
            model.prepared().expect("a model")
        };
        let models = [square(&[&one]), square(&[&other, &one]), square(&[&one])];
        let models: Vec<_> = models.iter().collect();
        let Arranged { rows, size, texels } = Arranged::new(&models, 64).expect("there is room");
        let words: Vec<u32> = texels.into_iter().flatten().collect();
        let mut places = Vec::new();
        for (model, row) in models.iter().zip(rows) {
            let (first, headers) = ((size[0] * row) as usize * 4, model.packed().headers);
            for (number, texture) in model.textures().iter().enumerate() {
                let header = &words[first + 4 * (headers + number)..][..4];
                let place = first + header[3] as usize;
                let found = words[place..].iter().take(texture.texels.len()).map(|word| word.to_le_bytes());
                assert!(header[..3] == [5, 3, 0x101] && found.eq(texture.texels.iter().copied()));
                places.push(place);
            }
        }
        assert!(places[0] == places[2] && places[0] == places[3] && places[0] != places[1], "{places:?}");
    }

    /// The shader has room for as many links as a packed model may leave.
    #[test]
    fn the_shader_says_how_many_links_wait() {
        let stated = format!("const MOST_WAITING = {MOST_WAITING}u;");
        assert!(include_str!("../../shaders/models.wgsl").contains(&stated));
    }
}
