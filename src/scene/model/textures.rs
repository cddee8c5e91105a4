//! The textures of a model that is being read: each is decoded once, and together they have a limit.

use std::collections::HashMap;
use std::hash::Hash;

use relativity_render::geometry::triangles::MOST_TEXELS;
use relativity_render::{RawModel, Texture, Wrap};

use super::picture;

/// The textures so far, by what the file calls them.
pub struct Textures<Key> {
    numbers: HashMap<Key, u32>,
    all: Vec<Texture>,
}

impl<Key: Eq + Hash> Textures<Key> {
    /// Returns none so far.
    pub fn new() -> Self {
        Self { numbers: HashMap::new(), all: Vec::new() }
    }

    /// Returns the number of the texture called `key`: from the bytes of its file and the name of that for
    /// messages, unless it is known already.
    pub fn number(
        &mut self,
        key: Key,
        wrap: [Wrap; 2],
        file: impl FnOnce() -> Result<(Vec<u8>, String), String>,
    ) -> Result<u32, String> {
        if let Some(number) = self.numbers.get(&key) {
            return Ok(*number);
        }
        let (bytes, name) = file()?;
        let used: u64 = self.all.iter().map(|texture| texture.texels.len() as u64).sum();
        let texture = picture::texture(&bytes, wrap, MOST_TEXELS.saturating_sub(used))
            .map_err(|problem| format!("cannot read {name}: {problem}"))?;
        let number = self.all.len() as u32;
        self.all.push(texture);
        self.numbers.insert(key, number);
        Ok(number)
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
