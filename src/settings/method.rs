//! The method that the settings choose to draw the views with.

use relativity_render::Method;

use super::Quality;
use crate::flags::choices::RendererChoice;

impl Quality {
    /// The renderer with its bound. The window cannot be without a GPU.
    #[must_use]
    pub const fn method(&self) -> Method {
        match self.renderer {
            RendererChoice::Auto | RendererChoice::Rays => Method::Rays,
            RendererChoice::Packets => Method::Packets,
            RendererChoice::Mesh => Method::Mesh { bound_px: self.bound_px },
            RendererChoice::Reference => Method::Reference,
        }
    }

    /// This, with another renderer.
    #[must_use]
    pub const fn with_method(self, method: Method) -> Self {
        match method {
            Method::Rays => Self { renderer: RendererChoice::Auto, ..self },
            Method::Packets => Self { renderer: RendererChoice::Packets, ..self },
            Method::Mesh { bound_px } => Self { renderer: RendererChoice::Mesh, bound_px },
            Method::Reference => Self { renderer: RendererChoice::Reference, ..self },
        }
    }
}
