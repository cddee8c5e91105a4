//! Shaders and pipelines of a device: each is made when it is first needed, once for all that draw on that device.

use std::collections::HashMap;
use std::fmt;
use std::hash::Hash;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::backdrop::LastPass;
use crate::compose::ComposeVariant;
use crate::pipeline_key::BodyPipeline;

/// Everything that was made on a device.
#[derive(Debug, Default)]
pub struct Made {
    /// Shaders, by their source.
    pub shaders: MadeOnce<&'static str, wgpu::ShaderModule>,
    /// Pipelines that draw bodies.
    pub bodies: MadeOnce<BodyPipeline, wgpu::RenderPipeline>,
    /// Pipelines that draw a part of the backdrop, and what is before it.
    pub last_passes: MadeOnce<LastPass, wgpu::RenderPipeline>,
    /// Pipelines that compose the pictures of two eyes.
    pub composers: MadeOnce<ComposeVariant, wgpu::RenderPipeline>,
}

/// Values by key, each of them made once. While one is made, others can be.
pub struct MadeOnce<K, V>(Mutex<HashMap<K, Arc<OnceLock<V>>>>);

impl<K, V> Default for MadeOnce<K, V> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K, V> fmt::Debug for MadeOnce<K, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("MadeOnce")
    }
}

impl<K: Eq + Hash, V: Clone> MadeOnce<K, V> {
    /// Returns the value of `key`, by `make` if there is none yet.
    pub fn get(&self, key: K, make: impl FnOnce() -> V) -> V {
        let place = Arc::clone(self.0.lock().unwrap_or_else(PoisonError::into_inner).entry(key).or_default());
        place.get_or_init(make).clone()
    }
}
