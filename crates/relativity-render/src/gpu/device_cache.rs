//! Shaders and pipelines of a device: each is made when it is first needed, once for all that draw on that
//! device.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::frame::pipeline_key::BodyPipeline;
use crate::picture::compose::ComposeVariant;
use crate::shaders::Source;
use crate::street::backdrop::LastPass;

/// Shaders and pipelines of a device, shared by all that draw on it.
#[derive(Debug, Default)]
pub struct DeviceCache {
    /// Shaders, by their source.
    pub shaders: Cache<Source, wgpu::ShaderModule>,
    /// Pipelines that draw bodies.
    pub bodies: Cache<BodyPipeline, wgpu::RenderPipeline>,
    /// Pipelines that draw a part of the backdrop, and what is before it.
    pub last_passes: Cache<LastPass, wgpu::RenderPipeline>,
    /// Pipelines that compose the pictures of two eyes.
    pub composers: Cache<ComposeVariant, wgpu::RenderPipeline>,
}

/// Values by key, each made at its first use. Different keys can be made at the same time.
#[derive(Debug)]
pub struct Cache<K, V>(Mutex<HashMap<K, Arc<OnceLock<V>>>>);

impl<K, V> Default for Cache<K, V> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: Eq + Hash, V: Clone> Cache<K, V> {
    /// Returns the value of `key`, which the first call makes with `make`.
    pub fn get(&self, key: K, make: impl FnOnce() -> V) -> V {
        let cell = Arc::clone(self.0.lock().unwrap_or_else(PoisonError::into_inner).entry(key).or_default());
        cell.get_or_init(make).clone()
    }

    /// Returns the number of values that are made.
    pub fn made(&self) -> usize {
        let values = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        values.values().filter(|cell| cell.get().is_some()).count()
    }

    /// Whether the value of `key` is made.
    pub fn has(&self, key: &K) -> bool {
        self.0
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .get(key)
            .is_some_and(|cell| cell.get().is_some())
    }
}
