//! The method that the settings choose to draw the views with.

use relativity_render::Method;

use super::QualitySettings;
use crate::flags::choices::RendererChoice;

impl QualitySettings {
    /// The renderer that is chosen; `None` where that is automatic.
    #[must_use]
    pub const fn method(&self) -> Option<Method> {
        match self.renderer {
            RendererChoice::Auto => None,
            RendererChoice::Rays => Some(Method::Rays),
            RendererChoice::Packets => Some(Method::Packets),
            RendererChoice::Mesh => Some(Method::Mesh),
            RendererChoice::Reference => Some(Method::Reference),
        }
    }

    /// Returns this quality with `method` as its renderer.
    #[must_use]
    pub const fn with_method(self, method: Method) -> Self {
        match method {
            Method::Rays => Self { renderer: RendererChoice::Rays, ..self },
            Method::Packets => Self { renderer: RendererChoice::Packets, ..self },
            Method::Mesh => Self { renderer: RendererChoice::Mesh, ..self },
            Method::Reference => Self { renderer: RendererChoice::Reference, ..self },
        }
    }
}
