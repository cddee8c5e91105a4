//! The speed: a slider finer towards 1, speeds to click, and three fields to type it exactly.

use eframe::egui::accesskit::{Action, ActionData};
use eframe::egui::{
    self, Align, Align2, FontId, Label, Layout, Rect, RichText, Sense, Slider, TextStyle, Ui, vec2,
};

use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, SettingsCommand};
use crate::app::widgets::{self, DOUBLE_CLICK};
use crate::flags::{SpeedParameter, SpeedSetting};
use crate::number_text;
use crate::settings::about;

const TIP: &str = "Sets the speed of the scene in units of c.\nβ = v/c,   γ = 1/√(1 − β²),   η = artanh β\nThe slider is finer towards 1.";

const OWN_TIP: &str = "Pedals or brakes until this speed is reached, in units of c, and starts T if it stands. The large number is \
    the speed that you have.";

/// A field in which the speed is typed: its parameter, symbol and name.
pub type Field = (SpeedParameter, &'static str, &'static str);

/// The fields for β, γ and η.
pub const FIELDS: [Field; 3] = [
    (SpeedParameter::Beta, "β", "Beta, typed"),
    (SpeedParameter::Gamma, "γ", "Gamma, typed"),
    (SpeedParameter::Rapidity, "η", "Rapidity, typed"),
];

/// A speed that can be set: that of the bodies, or the rider's own.
#[derive(Debug, Clone, Copy)]
pub struct SpeedControl<'a> {
    /// Speed that the slider shows.
    pub current: SpeedSetting,
    /// Speed that a double click sets.
    pub default: SpeedSetting,
    /// Speed in words at the end of the title.
    pub told: &'a str,
    /// Whether it is the rider's own.
    pub is_own: bool,
    /// Whether its number is the large one.
    pub is_large: bool,
    /// Fields to type it in.
    pub fields: &'a [Field],
}

impl SpeedControl<'_> {
    fn title(&self) -> &'static str {
        if self.is_own { "My speed" } else { "Speed" }
    }

    fn tip(&self) -> String {
        if self.is_own {
            return format!("{OWN_TIP}\n{DOUBLE_CLICK}");
        }
        let keys = [1, -1].map(|steps| Command::Settings(SettingsCommand::NudgeSpeed(steps)));
        format!("{}\n{DOUBLE_CLICK}", with_keys(TIP, &keys))
    }
}

/// Shows a speed with its fields. Returns a speed if the user gave one, or requested the default.
pub fn show(ui: &mut Ui, control: SpeedControl<'_>) -> Option<SpeedSetting> {
    let title = ui.horizontal(|ui| {
        let name = ui.add(Label::new(control.title()).selectable(false)).on_hover_text(control.tip());
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let text = RichText::new(control.told);
            let text = if control.is_large { text.heading().strong() } else { text };
            ui.label(text).on_hover_text(control.tip());
        });
        name
    });
    let restored = widgets::is_double_clicked(ui, &title.inner).then_some(control.default);
    let slid = slider(ui, control);
    let typed = if control.fields.is_empty() { None } else { fields(ui, control.current, control.fields) };
    restored.or(typed).or(slid)
}

fn slider(ui: &mut Ui, control: SpeedControl<'_>) -> Option<SpeedSetting> {
    let SpeedControl { current, default, fields, is_own, .. } = control;
    let mut position = current.slider_position();
    ui.spacing_mut().slider_width = ui.available_width();
    let slider = Slider::new(&mut position, 0.0..=1.0).show_value(false).smart_aim(false);
    let response =
        widgets::explained(ui.add(slider), control.tip()).accessible_name(format!("{} β", control.title()));
    // The slider's own number is a place along it: to others it is the speed.
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_numeric_value(current.speed().beta());
        node.set_max_numeric_value(SpeedSetting::at_slider_position(1.0).speed().beta());
        node.set_value(number_text::beta(&current.speed()));
    });
    let asked = asked_for(ui, response.id);
    let marked = marks(ui, response.rect, is_own || fields.len() == FIELDS.len());
    if widgets::is_double_clicked(ui, &response) {
        return Some(default);
    }
    let slid = response.changed().then(|| SpeedSetting::at_slider_position(position));
    asked.or(slid).or(marked)
}

/// The speed that assistive technology asks for.
fn asked_for(ui: &Ui, id: egui::Id) -> Option<SpeedSetting> {
    let beta = ui.input(|input| {
        let requests = input.accesskit_action_requests(id, Action::SetValue);
        requests
            .filter_map(|request| match request.data {
                Some(ActionData::NumericValue(beta)) => Some(beta),
                _ => None,
            })
            .last()
    });
    SpeedSetting::new(SpeedParameter::Beta, beta?).ok()
}

/// Shows marked speeds below the slider at its positions for them; returns one that is clicked, if it
/// `takes_clicks`.
fn marks(ui: &mut Ui, slider: Rect, takes_clicks: bool) -> Option<SpeedSetting> {
    const MARKS: [(f64, &str); 6] =
        [(0.0, "0"), (0.5, "0.5"), (0.9, "0.9"), (0.99, "0.99"), (0.999, "0.999"), (0.9999, "0.9999")];
    let (strip, hovered) = ui.allocate_exact_size(vec2(slider.width(), 15.0), Sense::hover());
    let font = TextStyle::Small.resolve(ui.style());
    let mut chosen = None;
    for (beta, text) in MARKS {
        let setting = SpeedSetting::new(SpeedParameter::Beta, beta).expect("marks are speeds");
        let x = widgets::handle_x(slider, setting.slider_position());
        let rect = Rect::from_center_size(egui::pos2(x, strip.center().y), vec2(36.0, strip.height()));
        // There may be two sliders: the rider's own speed, and the bodies'.
        let id = hovered.id.with(text);
        if mark(ui, (rect, id), &font, text, takes_clicks) {
            chosen = Some(setting);
        }
    }
    chosen
}

fn mark(ui: &mut Ui, (rect, id): (Rect, egui::Id), font: &FontId, text: &str, takes_clicks: bool) -> bool {
    let response = takes_clicks.then(|| ui.interact(rect, id, Sense::click()));
    let response = response.map(|response| response.on_hover_cursor(egui::CursorIcon::PointingHand));
    let is_hovered = response.as_ref().is_some_and(egui::Response::hovered);
    let colour = if is_hovered { ui.visuals().strong_text_color() } else { ui.visuals().weak_text_color() };
    ui.painter().text(rect.center(), Align2::CENTER_CENTER, text, font.clone(), colour);
    let Some(response) = response else { return false };
    let name = format!("Set β to {text}");
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, &name));
    response.clicked()
}

fn fields(ui: &mut Ui, current: SpeedSetting, fields: &[Field]) -> Option<SpeedSetting> {
    let error_id = egui::Id::unique("speed error");
    let mut chosen = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 5.0;
        let width = ((ui.available_width() - 74.0) / 3.0).max(20.0);
        for &(parameter, symbol, name) in fields {
            let tip = &format!("{} Enter applies it.", about(parameter.name()));
            ui.label(symbol).on_hover_text(tip);
            let Some(typed) = widgets::exact_number(ui, name, tip, &current.text(parameter), width) else {
                continue;
            };
            let setting = typed
                .and_then(|value| SpeedSetting::new(parameter, value).map_err(|error| error.to_string()));
            ui.data_mut(|data| data.insert_temp(error_id, setting.as_ref().err().cloned()));
            chosen = setting.ok();
        }
    });
    // The old speed stays, and so does the message, until something valid is typed.
    if let Some(message) = ui.data(|data| data.get_temp::<Option<String>>(error_id)).flatten() {
        ui.colored_label(ui.visuals().error_fg_color, message);
    }
    chosen
}
