//! The textures of a model that is being read: each is decoded once, and together they have a limit.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::Arc;

use gamow_platform::messages;
use relativity_render::geometry::triangles::texture::MipMap;
use relativity_render::{RawModel, Wrap};

use super::companions::Companions;
use super::picture;

/// The least opacity of a picture at which there is a surface, where a file does not say which.
pub const HALF_OPAQUE: f32 = 0.5;

/// Returns the cutoff of a texture with this least opacity, in parts of 65535.
pub fn cutoff(least: f32) -> u16 {
    (least * 65535.0).round() as u16
}

/// The textures so far, by what the file calls them.
pub struct Textures<Key> {
    numbers: HashMap<Key, u32>,
    all: Vec<Arc<MipMap>>,
}

impl<Key: Eq + Hash> Textures<Key> {
    /// Returns none so far.
    pub fn new() -> Self {
        Self { numbers: HashMap::new(), all: Vec::new() }
    }

    /// Returns the number of the texture called `key`, which has this cutoff: from the bytes of its file and
    /// the name of that for messages, unless it is known already. One that cannot be read is remarked, and is
    /// none.
    pub fn number(
        &mut self,
        key: Key,
        wrap: [Wrap; 2],
        cutoff: u16,
        companions: &Companions<'_>,
        file: impl FnOnce() -> Result<(Vec<u8>, String), String>,
    ) -> u32 {
        if let Some(number) = self.numbers.get(&key) {
            return *number;
        }
        let number = self.read(wrap, cutoff, companions, file).unwrap_or_else(|problem| {
            companions.remark(format!("a picture is left out: {problem}"));
            RawModel::NO_TEXTURE
        });
        self.numbers.insert(key, number);
        number
    }

    fn read(
        &mut self,
        wrap: [Wrap; 2],
        cutoff: u16,
        companions: &Companions<'_>,
        file: impl FnOnce() -> Result<(Vec<u8>, String), String>,
    ) -> Result<u32, String> {
        let (bytes, name) = file()?;
        let texture = picture::texture(&bytes, wrap, cutoff, companions.texels.get())
            .and_then(|texture| texture.prepared().map_err(|error| error.to_string()))
            .map_err(|problem| format!("cannot read {}: {problem}", messages::excerpt(&name)))?;
        companions.texels.set(companions.texels.get().saturating_sub(texture.count()));
        self.all.push(texture);
        Ok(self.all.len() as u32 - 1)
    }

    /// Moves the textures into `model`, which names one for every triangle and a place for every corner;
    /// without textures, these lists are emptied.
    pub fn put_into(self, model: &mut RawModel) {
        if self.all.is_empty() {
            (model.texture_numbers, model.texture_places) = (Vec::new(), Vec::new());
        }
        model.textures = self.all;
    }
}
