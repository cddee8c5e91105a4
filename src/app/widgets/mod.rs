//! Widgets of the panels: rows of controls that look alike (a name, a widget, an explanation on hover),
//! buttons, numbers and titles.

pub(in crate::app) mod apart;
mod area;
pub(in crate::app) mod fitted;
pub(in crate::app) mod focus;
pub(in crate::app) mod formula;
pub(in crate::app) mod icons;
pub(in crate::app) mod markdown;
pub(in crate::app) mod qr_code;
pub(in crate::app) mod theme;
pub(in crate::app) mod wavelength_colour;

use std::ops::RangeInclusive;
use std::sync::Arc;

use clap::ValueEnum;
use eframe::egui::accesskit::Live;
use eframe::egui::{
    self, Align, Align2, Button, Color32, Context, DragValue, Galley, Id, Layout, Painter, PointerButton,
    Pos2, Rect, Response, RichText, Sense, Slider, SliderClamping, TextEdit, TextStyle, TextWrapMode, Ui,
    UiBuilder, Vec2, emath::Numeric, pos2, vec2,
};
use relativity_core::math;

use self::icons::Icon;
use crate::app::tools::folded;
use crate::flags::MAX_TIME;
use crate::number_text;
use crate::settings::meaning;
use crate::units::Unit;

/// Tooltip of what has the window as the screen of a stereoscope.
pub const STEREOSCOPE_TIP: &str = "Fills the screen with the two eyes' pictures, as far apart as the lenses of a viewer that a phone is put into. Esc leaves.";

/// Width of the names in front of the widgets.
const NAME_WIDTH: f32 = 88.0;
/// Width of the numbers behind the sliders.
const NUMBER_WIDTH: f32 = 68.0;

/// Has assistive technology read out the text that appears in the widget or the part called `id`, once it has
/// ended its present sentence.
pub fn read_out(ctx: &Context, id: Id) {
    ctx.accesskit_node_builder(id, |node| node.set_live(Live::Polite));
}

/// Shows a titled group of rows that can be folded away, with a button in its title that resets them, unless
/// they have their defaults: then `reset` is none, else what the button does. True if it was clicked.
pub fn section(ui: &mut Ui, title: &str, reset: Option<&str>, rows: impl FnOnce(&mut Ui)) -> bool {
    let is_open = !folded::is_folded(ui.ctx(), title);
    let header = egui::CollapsingHeader::new(RichText::new(title).strong()).default_open(is_open);
    let shown = header.show_unindented(ui, |ui| {
        ui.add_space(2.0);
        rows(ui);
        ui.add_space(6.0);
    });
    folded::note(ui.ctx(), title, shown.openness < 0.5);
    let title_rect = shown.header_response.rect;
    let middle = pos2(ui.max_rect().max.x - RESET_SIDE, title_rect.center().y);
    let rect = Rect::from_center_size(middle, Vec2::splat(RESET_SIDE));
    reset.is_some_and(|tip| {
        let name = format!("Reset {title}");
        icons::button_in(ui, rect, Icon::Reset, &name).on_hover_text(tip).clicked()
    })
}

/// Side of the button in the title of a section.
const RESET_SIDE: f32 = 18.0;

/// `name`, then `widget` in the rest of the row; `tip` explains it.
pub fn row(ui: &mut Ui, name: &str, tip: &str, widget: impl FnOnce(&mut Ui)) {
    named_row(ui, name, tip, widget);
}

/// Draws a row as [`row`], and returns the response of its name.
fn named_row(ui: &mut Ui, name: &str, tip: &str, widget: impl FnOnce(&mut Ui)) -> Response {
    let row = ui.horizontal(|ui| {
        let size = vec2(NAME_WIDTH, ui.spacing().interact_size.y);
        let name = ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_width(NAME_WIDTH);
            ui.add(egui::Label::new(name).selectable(false)).on_hover_text(tip)
        });
        // Whatever does not fit goes on below.
        let beside = vec2(ui.available_width(), ui.spacing().interact_size.y);
        let wrapped = Layout::left_to_right(Align::Center).with_main_wrap(true);
        ui.allocate_ui_with_layout(beside, wrapped, widget);
        name.inner
    });
    row.inner
}

/// Whether `response` was clicked twice, whatever else it takes: what a double click on a slider or on its
/// name is.
#[must_use]
pub fn is_double_clicked(ui: &Ui, response: &Response) -> bool {
    response.contains_pointer()
        && ui.input(|input| input.pointer.button_double_clicked(PointerButton::Primary))
}

/// Effect of a double click on a slider or on its name, for its tooltip.
pub const DOUBLE_CLICK: &str = "Double-click the slider or its name to reset it.";

/// An edit of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edit {
    /// The value was left as it was.
    Kept,
    /// Another value was set.
    Changed,
    /// The default value, after a double click.
    Restored,
}

/// A slider, and behind it the number, which can be typed.
#[derive(Debug, Clone)]
pub struct NumberRow<'a> {
    /// Name on screen and for assistive technology.
    name: &'a str,
    /// Description for the tooltip.
    tip: &'a str,
    /// Range of the slider.
    slider: RangeInclusive<f64>,
    /// Range that may be typed.
    typed: RangeInclusive<f64>,
    decimals: usize,
    suffix: &'a str,
}

impl<'a> NumberRow<'a> {
    /// Returns a row for numbers without a unit, with at most six digits behind the point.
    pub const fn new(
        name: &'a str,
        tip: &'a str,
        slider: RangeInclusive<f64>,
        typed: RangeInclusive<f64>,
    ) -> Self {
        Self { name, tip, slider, typed, decimals: 6, suffix: "" }
    }

    /// Returns the row with at most this many digits behind the point.
    pub fn decimals(self, decimals: usize) -> Self {
        Self { decimals, ..self }
    }

    /// Returns the row with a unit behind the number.
    pub fn suffix(self, suffix: &'a str) -> Self {
        Self { suffix, ..self }
    }

    /// Shows the row; true if `value` changed, or was reset to `default`.
    pub fn show(&self, ui: &mut Ui, value: &mut f64, default: f64) -> bool {
        let edit = self.edit(ui, value);
        if edit == Edit::Restored {
            *value = default;
        }
        edit != Edit::Kept
    }

    /// Shows the row in `unit`, where `value` and its range are in units of the scene; true if `value`
    /// changed.
    pub fn show_in(&self, ui: &mut Ui, unit: Unit, value: &mut f64, default: f64) -> bool {
        let edit = self.edit_in(ui, unit, value);
        if edit == Edit::Restored {
            *value = default;
        }
        edit != Edit::Kept
    }

    /// Shows the row for a number without a default; returns the edit of `value`.
    pub fn edit(&self, ui: &mut Ui, value: &mut f64) -> Edit {
        let (mut changed, mut restored) = (false, false);
        let tip = format!("{}\n{DOUBLE_CLICK}", self.tip);
        let name = named_row(ui, self.name, &tip, |ui| {
            let slider = self.slider(ui, value).on_hover_text(&tip);
            restored = is_double_clicked(ui, &slider);
            changed = slider.changed() | self.number(ui, value);
        });
        match (restored || is_double_clicked(ui, &name), changed) {
            (true, _) => Edit::Restored,
            (false, true) => Edit::Changed,
            (false, false) => Edit::Kept,
        }
    }

    /// Shows the row in `unit`, for a number in units of the scene that has no default: the edit of `value`.
    pub fn edit_in(&self, ui: &mut Ui, unit: Unit, value: &mut f64) -> Edit {
        let [slider, typed] = [&self.slider, &self.typed].map(|span| shown_span(unit, span));
        let decimals = if unit == Unit::OWN { self.decimals } else { unit.decimals(3).into() };
        let row = NumberRow { slider, typed, decimals, suffix: &unit.suffix(), ..self.clone() };
        let mut shown = unit.shown(*value);
        let edit = row.edit(ui, &mut shown);
        if edit == Edit::Changed {
            *value = unit.in_scene(shown).clamp(*self.typed.start(), *self.typed.end());
        }
        edit
    }

    fn slider(&self, ui: &mut Ui, value: &mut f64) -> Response {
        let free = ui.available_width() - NUMBER_WIDTH - ui.spacing().item_spacing.x;
        ui.spacing_mut().slider_width = free.max(30.0);
        // A typed value may lie beyond the slider's ends and stays as typed.
        let slider =
            Slider::new(value, self.slider.clone()).show_value(false).clamping(SliderClamping::Never);
        let response = explained(ui.add(slider), self.tip).accessible_name(self.name);
        // An aid for accessibility can set what no drag reaches.
        if response.changed() {
            *value = value.clamp(*self.typed.start(), *self.typed.end());
        }
        response
    }

    fn number(&self, ui: &mut Ui, value: &mut f64) -> bool {
        let number = number(value)
            .range(self.typed.clone())
            .speed((self.slider.end() - self.slider.start()) / 400.0)
            .max_decimals(self.decimals)
            .update_while_editing(false)
            .suffix(self.suffix);
        let size = [NUMBER_WIDTH, ui.spacing().interact_size.y];
        let name = format!("{}, typed", self.name);
        explained(ui.add_sized(size, number), self.tip).accessible_name(name).changed()
    }
}

/// Explains what `response` is of, but not while it is dragged nor as long as the pointer rests where it was
/// left: the explanation would cover what the drag changes.
pub fn explained(response: Response, tip: impl Into<egui::WidgetText>) -> Response {
    let id = Id::unique("dragged last");
    let last = response.ctx.data(|data| data.get_temp::<Id>(id));
    if response.dragged() {
        response.ctx.data_mut(|data| data.insert_temp(id, response.id));
        return response;
    }
    if last != Some(response.id) {
        return response.on_hover_text(tip);
    }
    if !response.hovered() {
        response.ctx.data_mut(|data| data.remove::<Id>(id));
    }
    response
}

/// Buttons side by side, one of them chosen, with tooltips about their values. True if another was chosen.
pub fn choice<T: ValueEnum + PartialEq + Copy>(ui: &mut Ui, value: &mut T, options: &[(T, &str)]) -> bool {
    buttons(ui, value, options, |button, option| explained_lazily(button, || meaning(&option)))
}

/// Buttons side by side as of [`choice`], for values that have no sentence of their own: `tip` explains them
/// all.
pub fn choice_of<T: PartialEq + Copy>(ui: &mut Ui, value: &mut T, options: &[(T, &str)], tip: &str) -> bool {
    buttons(ui, value, options, |button, _| button.on_hover_text(tip))
}

fn buttons<T: PartialEq + Copy>(
    ui: &mut Ui,
    value: &mut T,
    options: &[(T, &str)],
    explained: impl Fn(Response, T) -> Response,
) -> bool {
    ui.spacing_mut().item_spacing.x = 3.0;
    let chosen = |&(option, name): &(T, &str)| {
        let button = ui.selectable_value(value, option, name);
        explained(button, option).changed()
    };
    options.iter().map(chosen).fold(false, |any, changed| any | changed)
}

/// Explains a widget on hover by a text that is made only then.
pub fn explained_lazily(response: Response, tip: impl FnOnce() -> String) -> Response {
    response.on_hover_ui(|ui| {
        ui.set_max_width(ui.spacing().tooltip_width);
        ui.label(tip());
    })
}

/// A field in which a number is typed exactly, as [`typed_text`].
pub fn exact_number(
    ui: &mut Ui,
    name: &str,
    tip: &str,
    shown: &str,
    width: f32,
) -> Option<Result<f64, String>> {
    typed(ui, name, tip, shown, width).1.map(|text| number_text::parsed(&text))
}

/// A field in which a text is typed. While it is not edited it shows `shown`; what was typed is handed out
/// once, on Enter or when the field is left.
pub fn typed_text(ui: &mut Ui, name: &str, tip: &str, shown: &str, width: f32) -> Option<String> {
    let (field, typed) = typed(ui, name, tip, shown, width);
    focus::note_words(&field);
    typed
}

/// Shows the field of [`typed_text`]; returns its response, too.
fn typed(ui: &mut Ui, name: &str, tip: &str, shown: &str, width: f32) -> (Response, Option<String>) {
    let id = Id::unique(("typed text", name));
    let mut text = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_else(|| shown.to_owned());
    let field = TextEdit::singleline(&mut text).id(id).desired_width(width).clip_text(true);
    let response = ui.add(field).on_hover_text(tip).accessible_name(name);
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, text));
        return (response, None);
    }
    ui.data_mut(|data| data.remove::<String>(id));
    let entered = (response.lost_focus() && text != shown).then_some(text);
    (response, entered)
}

/// A number to drag or type.
pub fn number<N: Numeric>(value: &mut N) -> DragValue<'_> {
    DragValue::new(value).custom_parser(parsed)
}

/// A number as it is typed anywhere in the window: with a decimal point or comma.
fn parsed(text: &str) -> Option<f64> {
    number_text::parsed(text).ok()
}

/// Returns a `span` in units of the scene, in `unit`.
fn shown_span(unit: Unit, span: &RangeInclusive<f64>) -> RangeInclusive<f64> {
    unit.shown(*span.start())..=unit.shown(*span.end())
}

/// A number to drag or type in `unit`; it and its `span` are in units of the scene.
pub fn measure(value: &mut f64, unit: Unit, span: RangeInclusive<f64>) -> DragValue<'_> {
    let shown = shown_span(unit, &span);
    let number = DragValue::from_get_set(move |typed| {
        if let Some(typed) = typed {
            *value = unit.in_scene(typed).clamp(*span.start(), *span.end());
        }
        unit.shown(*value)
    });
    number.range(shown).suffix(unit.suffix()).update_while_editing(false).custom_parser(parsed)
}

/// The first or the last T of a range, to drag or type in `unit`, where the plots show `from` to `to`.
pub fn end_of_range(time: &mut f64, unit: Unit, [from, to]: [f64; 2], decimals: u8) -> DragValue<'_> {
    // In a range of a hundred the last of them is of no use, in one of a thousand another.
    let useless = math::log10((to - from) / 10.0).floor().clamp(0.0, f64::from(decimals)) as u8;
    measure(time, unit, -MAX_TIME..=MAX_TIME)
        .speed(unit.shown((to - from) / 400.0))
        .max_decimals(unit.decimals(decimals - useless).into())
}

/// Returns x of the middle of the handle of a slider in `rect`, at `fraction` of its way.
pub fn handle_x(rect: egui::Rect, fraction: f64) -> f32 {
    // The theme's handles are circles of this radius.
    let radius = rect.height() / 2.5;
    egui::lerp(rect.min.x + radius..=rect.max.x - radius, fraction.clamp(0.0, 1.0) as f32)
}

/// Shows a dot whose colour identifies the thing that follows.
pub fn dot(ui: &mut Ui, colour: egui::Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(10.0, 10.0), Sense::hover());
    ui.painter().circle_filled(rect.center(), 4.5, colour);
}

/// Names the window for assistive technology.
pub fn name_window(ctx: &egui::Context, name: &str) {
    ctx.accesskit_node_builder(egui::accesskit_root_id(), |node| node.set_label(name));
}

/// Text with a `name` of its own for assistive technology.
pub fn named_text(ui: &mut Ui, text: impl Into<egui::WidgetText>, name: impl Into<String>) -> Response {
    ui.add(egui::Label::new(text).sense(Sense::hover())).accessible_name(name)
}

/// Writes `text` on a dark ground below `top`, or as near to there as is inside of a picture's `room`.
pub fn label_below(painter: &Painter, top: Pos2, text: Arc<Galley>, room: Rect) {
    let size = text.size();
    let corner = Align2::CENTER_TOP.anchor_size(top, size).min;
    let corner = corner.clamp(room.min, (room.max - size).max(room.min));
    let ground = Rect::from_min_size(corner, size).expand2(vec2(4.0, 1.0));
    painter.rect_filled(ground, 3.0, Color32::from_black_alpha(170));
    painter.galley(corner, text, Color32::WHITE);
}

/// Names the picture in `rect`.
pub fn pane_title(ui: &Ui, rect: Rect, text: &str, colour: Color32) {
    let font = TextStyle::Body.resolve(ui.style());
    let scale = theme::text_scale(ui.style());
    let height = scale * theme::TITLE_HEIGHT;
    let place = pos2(rect.min.x, rect.min.y - height / 2.0 - 1.0);
    // Beside it stand others.
    let above = rect.with_min_y(rect.min.y - height - 2.0);
    let painter = ui.painter().with_clip_rect(above.expand2(vec2(theme::GAP / 2.0, 0.0)));
    painter.circle_filled(place + scale * vec2(5.0, 0.0), scale * 4.5, colour);
    painter.text(place + scale * vec2(16.0, 0.0), Align2::LEFT_CENTER, text, font, ui.visuals().text_color());
}

/// Adds a small button into the title strip `strip`, at its left end or at its right one.
pub fn strip_button(ui: &mut Ui, strip: Rect, end: Align, text: &str) -> Response {
    let font = TextStyle::Small.resolve(ui.style());
    let width = ui.painter().layout_no_wrap(text.to_owned(), font, Color32::WHITE).size().x + 12.0;
    let size = vec2(width, strip.height() - 3.0);
    let place = Align2([end, Align::Min]).align_size_within_rect(size, strip);
    ui.scope_builder(UiBuilder::new().max_rect(place), |ui| {
        ui.spacing_mut().button_padding = vec2(4.0, 0.0);
        ui.spacing_mut().interact_size.y = 0.0;
        let text = RichText::new(text).small();
        ui.add(Button::new(text).min_size(size).wrap_mode(TextWrapMode::Extend))
    })
    .inner
}
