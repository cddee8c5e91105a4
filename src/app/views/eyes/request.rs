//! The request for a picture, and the picture that is shown.

use eframe::egui::TextureId;
use relativity_render::{Appearance, Method, PreparedScene, View};

/// Everything a picture depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// View to draw.
    pub view: View,
    /// Appearance of the light.
    pub appearance: Appearance,
    /// Scene to draw.
    pub scene: PreparedScene,
    /// Method that should draw the view.
    pub method: Method,
    /// Whether the reference should draw the view within the frame, too.
    pub at_once: bool,
    /// Whether the reference may make the view smoother while nothing changes.
    pub refine: bool,
}

/// A picture to show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownPicture {
    /// Texture of the picture.
    pub texture: TextureId,
    /// Method that drew it. The rays stand in for the reference until that is done; the published model is
    /// only known to the mesh renderer, and one light cone for both eyes not to the rays; the packets stand
    /// in for these where the device has no room for a scene's models.
    pub method: Method,
    /// Number of pixels each way that are drawn as one, where there was no time for more: else 1.
    pub coarseness: u32,
}

impl Request {
    /// Whether a picture of it is one of the `other`, too, by the same method.
    pub fn shows_as(&self, other: &Self) -> bool {
        (self.view, self.appearance) == (other.view, other.appearance) && self.scene == other.scene
    }

    /// Whether the reference has to draw the view, in the background.
    pub fn is_for_reference(&self) -> bool {
        self.method.of_view(&self.view) == Method::Reference && !self.at_once
    }

    /// Whether the reference knows how to.
    pub fn is_known_to_reference(&self) -> bool {
        Method::Reference.of_view(&self.view) == Method::Reference
    }

    /// Returns the request for the background, with this `method`.
    pub fn in_background_by(&self, method: Method) -> Self {
        Self { method, at_once: false, ..self.clone() }
    }

    /// Returns the method that draws the view within the frame.
    pub fn method_in_frame(&self) -> Method {
        if self.at_once { self.method.of_view(&self.view) } else { self.method.on_gpu(&self.view) }
    }
}
