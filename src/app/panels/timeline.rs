//! Play, pause, step and scrub through the observation time.

use std::sync::Arc;

use eframe::egui::accesskit::Role;
use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{
    self, Align, Align2, Checkbox, Color32, CursorIcon, Galley, Layout, PopupCloseBehavior, Rect, Response,
    Sense, Slider, SliderClamping, Stroke, TextStyle, Ui, Visuals, WidgetInfo, pos2, vec2,
};

use super::{Commands, OnClick as _, on_change};
use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, PlaybackCommand, SettingsCommand};
use crate::app::state::State;
use crate::app::views::window_layout::has_timeline_in_a_row;
use crate::app::widgets;
use crate::app::widgets::apart::{Span, apart};
use crate::app::widgets::icons::{self, Icon};
use crate::app::widgets::theme;
use crate::flags::{MAX_TIME, TimeRange};
use crate::settings::{PlaybackSettings, RATE, about};
use crate::units::Unit;

/// Widths of the transport's buttons with T's name and the gaps around them, of the words around the numbers
/// of the rate and of the range, of the menu's button, and of a number without its digits and of one of
/// these; points.
const TRANSPORT: f32 = 206.0;
const AROUND_RATE: f32 = 10.0;
const AROUND_RANGE: f32 = 196.0;
const MENU: f32 = 62.0;
const AROUND_DIGITS: f32 = 16.0;
const DIGIT: f32 = 7.2;

/// The part of the playback controls that has room in the timeline; the rest is in a menu.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum PlaybackControls {
    /// Rate, looping and range.
    All,
    /// The rate without looping and range.
    Rate,
    /// None of the three.
    Nothing,
}

impl PlaybackControls {
    /// Returns the part that has room in this `width`.
    fn within(width: f32, state: &State) -> Self {
        let [rate, range] = playback_widths(state);
        let taken = TRANSPORT + time_width(state);
        match width - taken {
            free if free >= rate + range => Self::All,
            free if free >= rate + MENU => Self::Rate,
            _ => Self::Nothing,
        }
    }
}

/// Width of numbers written so.
fn numbers_width(text: &str) -> f32 {
    AROUND_DIGITS + DIGIT * text.chars().count() as f32
}

/// Widths of the rate, and of looping and range.
fn playback_widths(state: &State) -> [f32; 2] {
    let unit = state.measures().time;
    let rate = numbers_width(&format!("{} / s", unit.text(state.document.settings.playback.rate, 2)));
    let ends = state.time_range().map(|end| numbers_width(&unit.text(end, 2)));
    [rate + AROUND_RATE, ends[0] + ends[1] + AROUND_RANGE]
}

/// Width of the number of T.
fn time_width(state: &State) -> f32 {
    let unit = state.measures().time;
    let default = if unit.name.is_empty() { 76.0 } else { 100.0 };
    numbers_width(&unit.text(state.document.time, unit.decimals(3))).max(default)
}

/// Shows the timeline with its scrubber.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    ui.spacing_mut().item_spacing.y = 3.0;
    let window = state.document.settings.window;
    if has_timeline_in_a_row(window, ui.available_width()) {
        ui.horizontal_top(|ui| {
            ui.horizontal(|ui| {
                transport(ui, state, commands);
                ui.add_space(theme::GAP / 2.0);
                time(ui, state, commands);
            });
            ui.add_space(theme::GAP / 2.0);
            ui.vertical(|ui| scrubber(ui, state, commands));
        });
        return;
    }
    let shown = PlaybackControls::within(ui.available_width(), state);
    ui.horizontal(|ui| {
        transport(ui, state, commands);
        ui.separator();
        time(ui, state, commands);
        if !window.simple {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| playback(ui, state, shown, commands));
        }
    });
    scrubber(ui, state, commands);
}

fn transport(ui: &mut Ui, state: &State, commands: &mut Commands) {
    ui.spacing_mut().item_spacing.x = 4.0;
    let buttons = [
        (Icon::Start, "To the start", 28.0, Command::Playback(PlaybackCommand::GoToPart(0.0))),
        (Icon::Back, "Step back", 28.0, Command::Playback(PlaybackCommand::Step(-1))),
        if state.scratch.playing {
            (Icon::Pause, "Pause", 46.0, Command::Playback(PlaybackCommand::Toggle))
        } else {
            (Icon::Play, "Play", 46.0, Command::Playback(PlaybackCommand::Toggle))
        },
        (Icon::Forward, "Step forwards", 28.0, Command::Playback(PlaybackCommand::Step(1))),
        (Icon::End, "To the end", 28.0, Command::Playback(PlaybackCommand::GoToPart(1.0))),
    ];
    let few = state.document.settings.window.simple;
    for (icon, name, width, command) in buttons {
        if few && command != Command::Playback(PlaybackCommand::Toggle) {
            continue;
        }
        let response = icons::button(ui, icon, name, egui::vec2(width, 26.0));
        response.on_hover_text(with_keys(name, std::slice::from_ref(&command))).on_click(commands, command);
    }
}

fn time(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let tip = time_tip(state);
    ui.label(state.clock().symbol).on_hover_text(&tip);
    let mut time = state.document.time;
    let [from, to] = state.time_range();
    let unit = state.measures().time;
    // While it runs, digits that nobody can read would only flicker.
    let is_simple = state.document.settings.window.simple;
    let least = if is_simple { 2 } else { 3 };
    let most = if is_simple || state.scratch.playing { least } else { 6 };
    let number = widgets::measure(&mut time, unit, -MAX_TIME..=MAX_TIME)
        .speed(unit.shown((to - from) / 1000.0))
        .min_decimals(unit.decimals(least).into())
        .max_decimals(unit.decimals(most).into());
    let response = ui.add_sized([time_width(state), ui.spacing().interact_size.y], number);
    if widgets::explained(response, tip).accessible_name("T, typed").changed() {
        commands.push(PlaybackCommand::GoTo(time).into());
    }
}

/// Returns the tooltip of T, with the keys that set it.
fn time_tip(state: &State) -> String {
    let ends = [
        Command::Playback(PlaybackCommand::GoToPart(0.0)),
        Command::Playback(PlaybackCommand::GoToPart(1.0)),
    ];
    with_keys(
        state.clock().received.tip,
        &[
            &[Command::Playback(PlaybackCommand::Step(-1)), Command::Playback(PlaybackCommand::Step(1))][..],
            &ends,
        ]
        .concat(),
    )
}

/// Rate, looping and range, from the right; what is not `shown` of them is in a menu.
fn playback(ui: &mut Ui, state: &State, shown: PlaybackControls, commands: &mut Commands) {
    let mut playback = state.document.settings.playback;
    if shown == PlaybackControls::All {
        range(ui, state, &mut playback);
        ui.separator();
        looping(ui, &mut playback);
    } else {
        let stays_open = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        let in_a_row = Layout::right_to_left(Align::Center);
        let size = vec2(playback_widths(state).into_iter().sum(), ui.spacing().interact_size.y + 2.0);
        let menu = MenuButton::new("range").config(stays_open).ui(ui, |ui| {
            ui.allocate_ui_with_layout(size, in_a_row, |ui| {
                range(ui, state, &mut playback);
                looping(ui, &mut playback);
                if shown == PlaybackControls::Nothing {
                    rate(ui, state, &mut playback);
                }
            });
        });
        menu.0.on_hover_text("Sets the first and the last T, and how T runs between them");
    }
    if shown != PlaybackControls::Nothing {
        rate(ui, state, &mut playback);
    }
    on_change(commands, &state.document.settings.playback, playback, SettingsCommand::Playback);
}

fn rate(ui: &mut Ui, state: &State, playback: &mut PlaybackSettings) {
    let unit = state.measures().time;
    let rate = widgets::measure(&mut playback.rate, unit, RATE)
        .speed(unit.shown(0.01))
        .max_decimals(unit.decimals(3).into())
        .suffix(" / s"); // behind the unit
    let rate = ui.add(rate).on_hover_text(about("rate"));
    rate.accessible_name("Playback rate");
}

fn looping(ui: &mut Ui, playback: &mut PlaybackSettings) {
    let repeat = icons::switch(ui, Icon::Loop, "Loop", vec2(28.0, 24.0), playback.looping);
    if repeat.on_hover_text(about("looping")).clicked() {
        playback.looping = !playback.looping;
    }
}

/// First and last T, from the right.
fn range(ui: &mut Ui, state: &State, playback: &mut PlaybackSettings) {
    let [mut from, mut to] = state.time_range();
    let mut fitted = playback.range.0.is_none();
    let tip = about("range");
    if ui
        .add(Checkbox::new(&mut fitted, "auto"))
        .on_hover_text(tip)
        .accessible_name("Automatic range")
        .changed()
    {
        playback.range = TimeRange((!fitted).then_some([from, to]));
    }
    let (shown, unit) = ([from, to], state.measures().time);
    let end = |value| widgets::end_of_range(value, unit, shown, 2);
    let last = ui.add(end(&mut to)).on_hover_text("Last T").accessible_name("Last T").changed();
    ui.label("to");
    let first = ui.add(end(&mut from)).on_hover_text("First T").accessible_name("First T").changed();
    if first || last {
        playback.range = TimeRange(Some([from.min(to), to.max(from)]));
    }
    ui.label("from");
}

fn scrubber(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let [from, to] = state.time_range();
    let mut time = state.document.time;
    ui.spacing_mut().slider_width = ui.available_width();
    // T may lie outside the range; only a drag brings it inside.
    let slider = Slider::new(&mut time, from..=to).show_value(false).clamping(SliderClamping::Never);
    let response = widgets::explained(ui.add(slider), time_tip(state)).accessible_name("Observation time T");
    if response.changed() {
        commands.push(PlaybackCommand::GoTo(time).into());
    }
    marks(ui, state, response.rect, commands);
}

/// Height of the names of the marks below the scrubber.
const NAMES_HEIGHT: f32 = 15.0;
/// Least space between two of them.
const BETWEEN: f32 = 14.0;
/// A smaller part of the range of T is 0: the vertices of models are rounded to single precision.
const ROUNDING: f64 = 1e-6;

/// A time to go to: when the selected point is abreast, in one sense of the word or the other.
struct TimeMark {
    name: &'static str,
    tip: &'static str,
    time: f64,
    colour: Color32,
}

impl TimeMark {
    /// Returns the marks of the selected point; none at rest.
    fn all(state: &State, visuals: &Visuals) -> Vec<Self> {
        let point = state.document.points.selected();
        // Places in scene files are sums: what is left over of them is no time.
        let [from, to] = state.time_range();
        let rounded = |time: f64| if time.abs() < ROUNDING * (to - from) { 0.0 } else { time };
        let mark =
            |name, tip, colour, time: Option<f64>| Some(Self { name, tip, time: rounded(time?), colour });
        let presently = state.abreast_time(point);
        let seen = state.equidistance_time(point);
        let [presently_tip, seen_tip] =
            if point.track.spin.is_some() { TURNING_TIPS } else { [PRESENTLY_TIP, SEEN_TIP] };
        let marks = [
            mark("measured abreast", presently_tip, theme::measured_colour(visuals), presently),
            if state.document.settings.baseline().is_along_motion() {
                mark("seen abreast", seen_tip, theme::equidistance_colour(visuals), seen)
            } else {
                mark("seen equally far", EQUIDISTANT_TIP, theme::equidistance_colour(visuals), seen)
            },
        ];
        marks.into_iter().flatten().collect()
    }

    /// Returns the text below the scrubber, with the mark at this `fraction` of its way; `with_time` adds
    /// its time.
    fn text(&self, unit: Unit, fraction: f64, with_time: bool) -> String {
        let text = if with_time {
            format!("{} {}", self.name, unit.text(self.time, 2))
        } else {
            self.name.to_owned()
        };
        match fraction {
            ..0.0 => format!("← {text}"),
            0.0..=1.0 => text,
            _ => format!("{text} →"),
        }
    }
}

const PRESENTLY_TIP: &str = "T = −x₀/β: the selected point is measured beside the eyes now, at x = 0. Nobody sees it \
    there yet, since the light of this moment is still on its way.\nClick to go there.";

const EQUIDISTANT_TIP: &str = "When both eyes see it equally far (T₀): the one time at which they receive one and the same event, so \
    that their lines of sight meet where it was.";

const SEEN_TIP: &str = "T₀ = √((d/2)² + y² + z²) − x₀/β: the selected point is seen beside the eyes, equally far from \
    both, with D = 1/γ and as short as 1/γ. The light left it when it was measured abreast; by now it is \
    further on.\nClick to go there.";

/// Both of a point that turns.
const TURNING_TIPS: [&str; 2] = [
    "The selected point itself, not its hub, is measured beside the eyes now, at x = 0. Nobody sees it there yet, since the \
    light of this moment is still on its way.\nClick to go there.",
    "T₀: the selected point itself, not its hub, is seen beside the eyes, equally far from both: they receive one and the same \
    event. The light left it when it was measured abreast.\nClick to go there.",
];

/// Ticks on the scrubber, and below it their names, to click, none of which covers another.
fn marks(ui: &mut Ui, state: &State, slider: Rect, commands: &mut Commands) {
    let (marks, unit, [from, to]) =
        (TimeMark::all(state, ui.visuals()), state.measures().time, state.time_range());
    let font = TextStyle::Small.resolve(ui.style());
    let fraction = |mark: &TimeMark| (mark.time - from) / (to - from);
    let with_time = !state.document.settings.window.simple;
    let galleys: Vec<_> = marks
        .iter()
        .map(|mark| {
            let text = mark.text(unit, fraction(mark), with_time);
            ui.painter().layout_no_wrap(text, font.clone(), mark.colour)
        })
        .collect();
    let spans: Vec<Span> = marks
        .iter()
        .zip(&galleys)
        .map(|(mark, galley)| Span {
            middle: widgets::handle_x(slider, fraction(mark)),
            width: galley.size().x,
        })
        .collect();
    let lefts = apart(&spans, slider.x_range(), BETWEEN);
    for (((mark, galley), span), left) in marks.iter().zip(galleys).zip(spans).zip(lefts) {
        let place = Rect::from_min_size(pos2(left, slider.max.y - 1.0), vec2(span.width, NAMES_HEIGHT));
        if (0.0..=1.0).contains(&fraction(mark)) {
            tick(ui, slider, span.middle, place, mark.colour);
        }
        name(ui, mark, place, galley).on_click(commands, PlaybackCommand::GoTo(mark.time));
    }
}

/// A tick where the slider has a mark at `x`, and a line from there to its `name`.
fn tick(ui: &Ui, slider: Rect, x: f32, name: Rect, colour: Color32) {
    let painter = ui.painter();
    painter.vline(x, slider.shrink2(vec2(0.0, 2.0)).y_range(), Stroke::new(1.5, colour));
    let end = pos2(x.max(name.min.x + 4.0).min(name.max.x - 4.0), name.min.y + 3.0);
    painter.line_segment([pos2(x, slider.max.y - 2.0), end], Stroke::new(1.0, colour));
}

/// The name of `mark`, laid out as `galley`, to click.
fn name(ui: &Ui, mark: &TimeMark, place: Rect, galley: Arc<Galley>) -> Response {
    let id = ui.scope_id().with(mark.name);
    let response = ui.interact(place, id, Sense::click()).on_hover_cursor(CursorIcon::PointingHand);
    let colour = if response.hovered() { ui.visuals().strong_text_color() } else { mark.colour };
    let corner = Align2::LEFT_BOTTOM.anchor_size(place.left_bottom(), galley.size()).min;
    ui.painter().galley_with_override_text_color(corner, galley, colour);
    let name = format!("Go to {}", mark.name);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    response.on_hover_text(mark.tip)
}
