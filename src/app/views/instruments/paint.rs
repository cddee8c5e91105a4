//! Paints the instruments into a picture.

use std::sync::Arc;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, FontId, Galley, Painter, Rect, Sense, TextStyle, Ui, Vec2, WidgetInfo, vec2,
};

use super::dial;
use super::places::Places;
use super::values::Instruments;
use crate::app::commands::riding::keys;
use crate::app::state::State;
use crate::app::tools::awake;
use crate::app::views::panes::EyePane;
use crate::app::widgets::theme;

/// Size of the labels as a share of the picture's height, where that is more than small writing has, and the
/// largest as a share of its width.
const LABEL_SHARE: f32 = 0.02;
const LABEL_OF_WIDTH: f32 = 0.03;
/// Size of the numbers on the plates, relative to the labels.
const NUMBER: f32 = 1.6;
/// Space inside a plate, and between the instruments, relative to the labels' size.
const PADDING: Vec2 = vec2(0.7, 0.35);
const GAP: f32 = 0.6;
/// Names of the rider's clock and of the street's, the first pair that has room.
const NAMES: [[&str; 2]; 2] = [["my clock", "clock of the street here"], ["my clock", "street’s clock"]];
/// Opacity of what the instruments stand on.
const BACK: u8 = 190;
/// Time for which odometers and keys stay, seconds, and the part of it in which they fade.
const SHOWN: f64 = 9.0;
const FADE: f64 = 0.2;

/// Height of the lowest picture in which a lesson leaves room for the keys, points.
const LOWEST_WITH_KEYS: f32 = 320.0;

/// A plate with its label and its number.
struct Plate {
    label: Arc<Galley>,
    number: Arc<Galley>,
    padding: Vec2,
}

impl Plate {
    fn new(painter: &Painter, name: &str, number: &str, label: f32) -> Self {
        let line = |text: &str, size: f32, colour: Color32| {
            painter.layout_no_wrap(text.to_owned(), FontId::proportional(size), colour)
        };
        Self {
            label: line(name, label, theme::TAG_TEXT),
            number: line(number, NUMBER * label, Color32::WHITE),
            padding: label * PADDING,
        }
    }

    fn size(&self) -> Vec2 {
        let [label, number] = [&self.label, &self.number].map(|line| line.size());
        vec2(label.x.max(number.x), label.y + number.y) + 2.0 * self.padding
    }

    fn paint(self, painter: &Painter, rect: Rect) {
        painter.rect_filled(rect, self.padding.x, Color32::from_black_alpha(BACK));
        let corner = rect.min + self.padding;
        let below = corner + vec2(0.0, self.label.size().y);
        painter.galley(corner, self.label, Color32::WHITE);
        painter.galley(below, self.number, Color32::WHITE);
    }
}

/// The instruments that are in a picture, and what is still to be written beside them.
#[derive(Debug, Clone, Default)]
pub struct Shown {
    /// Places of the dial and of the plates.
    pub places: Vec<Rect>,
    /// Odometers, place and keys, as far as they are shown; a line each.
    lines: Vec<String>,
    /// The place alone, for a picture that has no room for all lines.
    place: String,
    /// Opacity of these, 0 to 1.
    opacity: f32,
    /// Size of the labels, points.
    label: f32,
}

/// Paints the instruments of whoever rides into the picture of `pane`, off the marks that are to stay in
/// sight.
#[must_use]
pub fn show(ui: &Ui, painter: &Painter, state: &State, pane: EyePane, free: &[Rect]) -> Shown {
    let Some(instruments) = state.instruments(keys::told(ui.ctx())) else { return Shown::default() };
    let small = TextStyle::Small.resolve(ui.style()).size;
    let [width, height] = [pane.rect.width(), pane.rect.height()];
    let label = (LABEL_SHARE * height).min(LABEL_OF_WIDTH * width).max(small);
    let laid = dial::laid(painter, &instruments, label, height);
    let plates = NAMES.map(|[mine, street]| {
        [(mine, &instruments.clock), (street, &instruments.street_clock)]
            .map(|(name, number)| Plate::new(painter, name, number, label))
    });
    let found = plates.into_iter().map(|plates| {
        let sizes = [plates[0].size(), plates[1].size()];
        (Places::new(pane.rect, laid.radius, sizes, GAP * label, free), plates)
    });
    let mut found: Vec<_> = found.collect();
    let with_plates = found.iter().position(|(places, _)| places.is_some_and(|it| it.plates.is_some()));
    let (places, plates) = found.swap_remove(with_plates.unwrap_or(0));
    let Some(places) = places else { return Shown::default() };
    dial::paint(painter, &laid, instruments.rapidity, places.dial.center(), Color32::from_black_alpha(BACK));
    for (plate, rect) in plates.into_iter().zip(places.plates.into_iter().flatten()) {
        plate.paint(painter, rect);
    }
    let is_pointed = say(ui, pane, &instruments, places);
    let shown = Shown { places: places.parts().collect(), label, ..Shown::default() };
    if pane.is_second {
        return shown;
    }
    let fresh = if is_pointed { 1.0 } else { freshness(ui, state) };
    // A lesson may ask about the way.
    let is_asked = state.session.lesson.is_some();
    // In a low picture that is all there is room for.
    let has_keys = fresh > 0.0 && !(is_asked && height < LOWEST_WITH_KEYS);
    let keys = instruments.keys.iter().map(|line| (*line).to_owned()).filter(|_| has_keys);
    let way = instruments.way.into_iter().filter(|_| is_asked || fresh > 0.0);
    let way: Vec<_> = way.collect();
    let place = way.last().cloned().unwrap_or_default();
    Shown {
        lines: way.into_iter().chain(keys).collect(),
        place,
        opacity: if is_asked { 1.0 } else { fresh },
        ..shown
    }
}

/// Has assistive technology and a pointer find the instruments; returns whether the pointer is on them.
fn say(ui: &Ui, pane: EyePane, instruments: &Instruments, places: Places) -> bool {
    const TIP: &str = "My speed; its arc shows my rapidity, to which each push adds evenly, with marks at 0.5, \
        0.9, 0.99 and 0.999 c. My clock. The clock of the street that I am passing.";
    let id = ui.scope_id().with(("handlebar", pane.eye.index(), pane.is_second));
    let response = ui.interact(places.all().intersect(pane.rect), id, Sense::hover());
    response.widget_info(|| {
        let whose = if pane.is_second { "Second picture" } else { pane.eye.name() };
        let text = format!("{whose}, instruments: {}", instruments.text());
        WidgetInfo::labeled(Role::Label, true, text)
    });
    response.on_hover_text(TIP).hovered()
}

/// Opacity of odometers and keys, 0 to 1: they appear when a ride begins and on request, and fade.
fn freshness(ui: &Ui, state: &State) -> f32 {
    let asked = (state.scratch.saddle.requests, state.document.preset.map(|preset| preset.name));
    let left = SHOWN - awake::shown_for(ui.ctx(), "odometers and keys", asked);
    if left <= 0.0 {
        return 0.0;
    }
    ui.ctx().request_repaint_after_secs((left - FADE).max(0.0) as f32);
    (left / FADE).min(1.0) as f32
}

impl Shown {
    /// Writes odometers, place and keys into the first corner of the `picture` in which they cover nothing
    /// that is `taken`; returns where.
    pub fn write_beside(self, painter: &Painter, picture: Rect, taken: &[Rect]) -> Option<Rect> {
        const CORNERS: [Align2; 6] = [
            Align2::LEFT_BOTTOM,
            Align2::RIGHT_BOTTOM,
            Align2::LEFT_CENTER,
            Align2::RIGHT_CENTER,
            Align2::LEFT_TOP,
            Align2::RIGHT_TOP,
        ];
        if self.lines.is_empty() {
            return None;
        }
        let colour = Color32::WHITE.gamma_multiply(self.opacity);
        let padding = self.label * PADDING;
        let room = picture.shrink(6.0);
        let laid = |text: &str, width: f32| {
            let width = (width - 2.0 * padding.x).max(1.0);
            painter.layout(text.to_owned(), FontId::proportional(self.label), colour, width)
        };
        let is_free = |place: &Rect| {
            let covers = |part: &Rect| part.is_positive() && part.expand(padding.y).intersects(*place);
            picture.contains_rect(*place) && !taken.iter().any(covers)
        };
        // In a narrow picture broken lines leave room beside them.
        let (all, whole) = (self.lines.join("\n"), room.width());
        let ways = [(&all, whole), (&all, 0.5 * whole), (&self.place, whole)];
        let mut places = ways.into_iter().flat_map(|(text, width)| {
            let galley = laid(text, width);
            let size = galley.size() + 2.0 * padding;
            CORNERS.map(|corner| (corner.align_size_within_rect(size, room), Arc::clone(&galley)))
        });
        let (place, galley) = places.find(|(place, _)| is_free(place))?;
        painter.rect_filled(place, padding.x, Color32::from_black_alpha(BACK).gamma_multiply(self.opacity));
        painter.galley(place.min + padding, galley, colour);
        Some(place)
    }
}
