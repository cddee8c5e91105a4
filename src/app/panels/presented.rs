//! The words for an audience, below the views: the speed and the moment, and what is shown and why, or those
//! of a lesson; so large that the last row reads them.

use std::hash::{DefaultHasher, Hash, Hasher as _};

use eframe::egui::{Context, Id, Label, Rect, RichText, TextStyle, Ui};

use crate::app::state::State;
use crate::app::views::window_layout::Beside;
use crate::app::widgets::fitted;
use crate::app::widgets::theme;

/// Least size of writing before an audience, as a part of the window's height.
pub const LEAST_SHARE: f32 = 0.03;
/// Largest and smallest sizes of the words, as parts of the same height. The smallest is for windows that
/// nobody presents in: in those of usual shapes all that comes with the program stays above [`LEAST_SHARE`].
const SIZES: [f32; 2] = [0.042, 0.018];
/// Bounds of how much larger than usual writing is for an audience, for windows of any size.
const SCALES: [f32; 2] = [0.8, 12.0];
/// Size of the speed, relative to the other words.
const SPEED: f32 = 1.5;
/// Height of the smallest writing in a window of this height that is less wide than high, in widths.
const LEAST_ASPECT: f32 = 0.75;

/// Share of the room above which words get all of it.
const NEARLY: f32 = 0.92;

/// Height of words, as far as it is known.
#[derive(Debug, Clone, Copy, PartialEq)]
struct KnownHeight {
    /// Hash of the words, the panel beside them and the window's size.
    key: u64,
    /// The height that they need; infinite if they would be too small.
    need: f32,
}

/// Returns the height in proportion to which a window of this `area` writes for an audience.
#[must_use]
pub fn reference_height(area: Rect) -> f32 {
    area.height().min(LEAST_ASPECT * area.width())
}

/// Returns how much larger than usual writing is for an audience: the smallest is as high as the last row
/// needs, and larger with the window's zoom.
#[must_use]
pub fn scale(ctx: &Context) -> f32 {
    let height = reference_height(ctx.content_rect()) * ctx.zoom_factor();
    let [least, most] = SCALES;
    (LEAST_SHARE * height / theme::SMALL_SIZE).clamp(least, most)
}

/// Words, and where they are shown.
#[derive(Debug, Clone, Copy)]
pub struct Words<'a> {
    /// Identifier of the words, different for each text.
    pub what: &'a str,
    /// Inner area of the whole window.
    pub area: Rect,
    /// The panel beside them.
    pub beside: Beside,
}

impl Words<'_> {
    /// Returns the height that they need, if that is known.
    #[must_use]
    pub fn needed(&self, ctx: &Context) -> Option<f32> {
        let known = ctx.data(|data| data.get_temp::<KnownHeight>(id(ctx)));
        known.filter(|known| known.key == self.key()).map(|known| known.need)
    }

    /// Shows these `contents` in all of the room there is.
    pub fn show(&self, ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
        let (key, room) = (self.key(), ui.max_rect().height());
        let height = ui.ctx().zoom_factor() * reference_height(self.area);
        let [need, size] = fitted::show(ui, key, SIZES.map(|share| share * height), |ui| {
            ui.spacing_mut().item_spacing.y = 0.25 * TextStyle::Body.resolve(ui.style()).size;
            contents(ui);
        });
        note(ui.ctx(), key, [need, room], size < LEAST_SHARE * height);
    }

    fn key(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        let size = [self.area.width(), self.area.height()].map(f32::to_bits);
        (self.what, self.beside, size).hash(&mut hasher);
        hasher.finish()
    }
}

/// Keeps that the words with this key need so much where they have that `room`: it is given to them from the
/// next pass on. What is too small, or grows while it is shown, gets all the room there is.
fn note(ctx: &Context, key: u64, [need, room]: [f32; 2], is_small: bool) {
    let id = id(ctx);
    let known = ctx.data(|data| data.get_temp::<KnownHeight>(id)).filter(|known| known.key == key);
    let exceeds = need > room + 0.5;
    let next = match known.map(|known| known.need) {
        Some(f32::INFINITY) => return,
        _ if is_small => f32::INFINITY,
        Some(_) if exceeds => f32::INFINITY,
        Some(_) => return,
        None if exceeds => return,
        // Nearly as much is as good: another height would have all written anew.
        None if need > NEARLY * room => room,
        None => need,
    };
    ctx.data_mut(|data| data.insert_temp(id, KnownHeight { key, need: next }));
    ctx.request_discard("the words get as much room as they need");
    ctx.request_repaint();
}

fn id(ctx: &Context) -> Id {
    Id::unique(("words for an audience", ctx.viewport_id()))
}

/// Shows the speed, the moment in a sentence, and the caption of the preset. A fit is of the whole passage:
/// beside it no moment is described, and the views keep that room.
pub fn preset(ui: &mut Ui, state: &State, beside: Beside) {
    let size = TextStyle::Body.resolve(ui.style()).size;
    let strong = ui.visuals().strong_text_color();
    let write = |ui: &mut Ui, text: RichText| ui.add(Label::new(text).selectable(false));
    write(ui, RichText::new(state.told_speed_text()).size(SPEED * size).color(strong));
    if let Some(others) = state.others_speed_text() {
        write(ui, RichText::new(others));
    }
    if beside != Beside::Fit {
        // A number is not parted from its unit, nor from what it is the value of.
        let sentence = state.moment().sentence().replace(" nm", "\u{a0}nm").replace(" = ", "\u{a0}=\u{a0}");
        write(ui, RichText::new(sentence).color(strong));
    }
    if let Some(preset) = state.document.preset {
        write(ui, RichText::new(format!("{}. {}", preset.title, preset.caption)));
    }
}
