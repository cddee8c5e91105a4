//! The pictures of the two eyes as a file shows them.

use relativity_render::Picture as Pixels;

use super::sheet::{Labels, Sheet};
use crate::files::png::Still;
use crate::flags::choices::{Form, Layout};
use crate::settings::PictureSettings;

/// Returns the file that shows `eyes`, the pictures of `picture` in its order, with `labels` where these
/// distinguish them. For free viewing the middles of pictures are `picture_mm` apart.
#[must_use]
pub fn still(picture: &PictureSettings, eyes: Vec<Pixels>, labels: Option<Labels>, picture_mm: f64) -> Still {
    let (frames, pixels_per_metre) = match (picture.layout.form(), eyes.as_slice()) {
        (Form::Composed(composition), [first, second]) => (vec![composition.picture([first, second])], None),
        (Form::Beside | Form::Above | Form::InTurn, [first, _]) => {
            let sheet = Sheet::new(picture, first.size, labels.is_some());
            let is_measured = picture.layout == Layout::FreeViewing;
            let pixels_per_metre = is_measured.then(|| sheet.pixels_per_metre(picture_mm));
            (sheet.composed(&eyes, &labels.unwrap_or_default()), pixels_per_metre)
        }
        _ => (eyes, None),
    };
    Still { frames, pixels_per_metre }
}
