//! What is asked for, and what is shown.

use eframe::egui::TextureId;
use relativity_render::{Appearance, Method, PreparedScene, View};

/// Everything a picture depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Who looks at what.
    pub view: View,
    /// What becomes of its light.
    pub appearance: Appearance,
    /// What there is to see.
    pub scene: PreparedScene,
    /// What is to draw it.
    pub method: Method,
    /// Whether the reference is to draw it within the frame, too.
    pub at_once: bool,
    /// Whether the reference may make it smoother while nothing changes.
    pub refine: bool,
}

/// A picture to show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// The picture.
    pub texture: TextureId,
    /// What drew it. The rays stand in for the reference until that is done; the published model is
    /// only known to the mesh renderer, and one light cone for both eyes not to the rays.
    pub method: Method,
}

impl Request {
    /// Whether a picture of it is one of the `other`, too, by the same method.
    pub fn shows_as(&self, other: &Self) -> bool {
        (self.view, self.appearance) == (other.view, other.appearance) && self.scene == other.scene
    }

    /// Whether it is the reference's to draw, in the background.
    pub fn is_for_reference(&self) -> bool {
        self.method.of_view(&self.view) == Method::Reference && !self.at_once
    }

    /// Whether the reference knows how to.
    pub fn is_known_to_reference(&self) -> bool {
        Method::Reference.of_view(&self.view) == Method::Reference
    }

    /// It, for the reference to draw.
    pub fn for_reference(&self) -> Self {
        Self { method: Method::Reference, at_once: false, ..self.clone() }
    }

    /// What draws it within the frame.
    pub fn method_in_frame(&self) -> Method {
        if self.at_once { self.method.of_view(&self.view) } else { self.method.on_gpu(&self.view) }
    }
}
