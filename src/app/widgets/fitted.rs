//! Writing that is as large as fits into the room there is, and is scrolled where the smallest does not.

use std::hash::Hash;

use eframe::egui::{ScrollArea, Ui, UiBuilder};
use relativity_core::math;

use crate::app::widgets::theme;

/// From one size that is tried to the next, points.
const STEP: f32 = 0.25;
/// Power of the factor by which the writing is too high that is tried: a half would fit a single long text.
const LEAST_GAIN: f64 = 0.4;

/// Shows `contents` in the rest of `ui`, most writing between the largest and the smallest of these `sizes`,
/// points. They are tried anew when `key` changes, which tells what is shown: a larger text, another width.
/// Returns the height that they need, and the size that they have by then.
pub fn show(ui: &mut Ui, key: impl Hash, sizes: [f32; 2], contents: impl FnOnce(&mut Ui)) -> [f32; 2] {
    let [largest, smallest] = sizes;
    let room = ui.available_rect_before_wrap();
    let key = hash_of(&(key, [room.width(), room.height(), largest].map(f32::to_bits)));
    let id = ui.scope_id().with("size of writing");
    let known = ui.data(|data| data.get_temp::<(u64, f32)>(id)).filter(|(known, _)| *known == key);
    let size = known.map_or(largest, |(_, size)| size);
    let (mut next, mut height) = (size, 0.0);
    ui.scope_builder(UiBuilder::new().id_salt("fitted").max_rect(room), |ui| {
        theme::set_body_size(ui.style_mut(), size);
        let area = ScrollArea::vertical().auto_shrink(false);
        let shown = area.show(ui, contents);
        let [needs, has] = [shown.content_size.y, shown.inner_rect.height()];
        height = needs;
        if needs > has + 0.5 && size > smallest {
            // Lines become fewer as they become lower, and more so than that where they break elsewhere.
            let factor = math::powf(f64::from(has / needs), LEAST_GAIN) as f32;
            let fitting = (factor * size / STEP).floor() * STEP;
            next = fitting.min(size - STEP).max(smallest);
            ui.ctx().request_discard("the writing is too large");
            ui.ctx().request_repaint();
        }
    });
    ui.data_mut(|data| data.insert_temp(id, (key, next)));
    [height, next]
}

fn hash_of(key: &impl Hash) -> u64 {
    use std::hash::{DefaultHasher, Hasher as _};
    let mut hasher = DefaultHasher::new();
    key.hash(&mut hasher);
    hasher.finish()
}
