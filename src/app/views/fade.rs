//! The fade from one preset or layout to the next: the last pictures stand over the new ones, and go.

use eframe::egui::{Color32, Context, Rect, TextureId, Ui, pos2};

use crate::app::state::State;
use crate::flags::choices::Layout;

/// Duration of a fade, seconds.
pub const SECONDS: f64 = 0.2;

/// The parts of the state whose change begins a fade.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Looks {
    preset: Option<&'static str>,
    layout: Layout,
    pictures: usize,
}

/// The pictures that go.
#[derive(Debug, Default)]
pub struct Fade {
    looks: Option<Looks>,
    /// Pictures of this frame or the last, with their places.
    shown: Vec<(Rect, TextureId)>,
    leaving: Vec<(Rect, TextureId)>,
    /// When they began to go, seconds.
    begun: f64,
}

impl Fade {
    /// Begins a frame with this number of `pictures`. Returns whether a fade begins, for which the pictures
    /// of the last frame are needed.
    pub fn begins(&mut self, ctx: &Context, state: &State, pictures: usize) -> bool {
        let preset = state.document.preset.map(|preset| preset.name);
        let layout = state.document.settings.picture.layout;
        let looks = Looks { preset, layout, pictures };
        let before = self.looks.replace(looks);
        let shown = std::mem::take(&mut self.shown);
        let is_left = |before: Looks| {
            let other_preset = looks.preset.is_some() && looks.preset != before.preset;
            other_preset || Looks { preset: None, ..looks } != Looks { preset: None, ..before }
        };
        let may_move = ctx.global_style().animation_time > 0.0;
        let begins = may_move && before.is_some_and(is_left) && !shown.is_empty();
        if begins {
            (self.leaving, self.begun) = (shown, ctx.input(|input| input.time));
        }
        begins
    }

    /// Notes that `texture` is shown in `rect`.
    pub fn note(&mut self, rect: Rect, texture: TextureId) {
        self.shown.push((rect, texture));
    }

    /// Paints what still goes over the pictures in `area`. Returns whether all is gone.
    pub fn paint(&mut self, ui: &Ui, area: Rect) -> bool {
        let gone = (ui.input(|input| input.time) - self.begun) / SECONDS;
        if gone >= 1.0 {
            self.leaving.clear();
        }
        let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        for &(rect, texture) in &self.leaving {
            let tint = Color32::WHITE.gamma_multiply(1.0 - gone as f32);
            ui.painter().with_clip_rect(area).image(texture, rect, uv, tint);
            ui.ctx().request_repaint();
        }
        self.leaving.is_empty()
    }

    /// Whether no fade is under way.
    pub const fn is_settled(&self) -> bool {
        self.leaving.is_empty()
    }
}
