//! The bar at the top: the scene, and which parts of the window are shown.

mod file_menu;

use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::text::{LayoutJob, TextFormat, TextWrapping};
use eframe::egui::{Align, Button, ComboBox, Layout, PopupCloseBehavior, RichText, TextStyle, Ui, vec2};
use gamow_platform::files;

use super::{Commands, OnClick as _, on_change, stereoscope_button};
use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, FileCommand, SettingsCommand, ShowCommand, Switch, WindowCommand};
use crate::app::state::State;
use crate::app::state::files::purpose::Purpose;
use crate::app::state::files::recent::file_name;
use crate::app::state::overlay::Overlay;
use crate::app::widgets::explained_lazily;
use crate::app::widgets::icons::{self, Icon};
use crate::caption::whole_sentences;
use crate::scene::{PRESETS, Scene};
use crate::settings::{Theme, WindowSettings, about, meaning};
use crate::units::Units;

/// Room for a menu's entries before they scroll, points.
const MENU_HEIGHT: f32 = 520.0;

/// Narrower bars do without the program's name, have units and theme in a menu, and what is shown, too;
/// points.
const NARROWEST_WITH_NAME: f32 = 900.0;
const NARROWEST_WITH_ALL: f32 = 1120.0;
const NARROWEST_WITH_PARTS: f32 = 700.0;
/// Narrower bars, as on a phone, have the way back and the help in the menu too, and a shorter name of the
/// scene; points.
const NARROWEST_WITH_WAY_BACK: f32 = 540.0;
/// A window that is lower is that of a phone on its side, points.
const LOWEST_WITH_WAY_BACK: f32 = 480.0;
/// Room for the buttons after the scene's name on a phone, and widths that the name has at least there and
/// elsewhere.
const PHONE_BUTTONS: f32 = 146.0;
const LEAST_NAME: f32 = 110.0;
const USUAL_NAME: f32 = 140.0;
/// A narrower caption would say nothing.
const NARROWEST_CAPTION: f32 = 180.0;

/// Shows the bar with its menus.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let width = ui.available_width();
    ui.horizontal_centered(|ui| {
        if width >= NARROWEST_WITH_NAME {
            ui.label(RichText::new("Gamow").strong());
        }
        file_menu::show(ui, state, commands);
        scene(ui, state, commands);
        let is_simple = state.document.settings.window.simple;
        pages(
            ui,
            state,
            width >= if is_simple { NARROWEST_WITH_PARTS } else { NARROWEST_WITH_ALL },
            commands,
        );
        if width >= NARROWEST_WITH_ALL && !is_simple {
            units(ui, state, commands);
        }
        if width < NARROWEST_WITH_WAY_BACK || ui.ctx().content_rect().height() < LOWEST_WITH_WAY_BACK {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| more_on_a_phone(ui, state, commands));
            return;
        }
        way_back(ui, state, commands);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            help(ui, commands);
            if !is_simple {
                if width >= NARROWEST_WITH_ALL {
                    theme(ui, state, commands);
                    ui.separator();
                } else {
                    more(ui, state, width < NARROWEST_WITH_PARTS, commands);
                }
                if width >= NARROWEST_WITH_PARTS {
                    parts(ui, state, commands);
                }
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| caption(ui, state));
        });
    });
}

fn help(ui: &mut Ui, commands: &mut Commands) {
    let open = Command::Window(WindowCommand::Toggle(Overlay::Help));
    let tip = "Explains the window, its terms, settings, keys and mouse.";
    ui.button("Help").on_hover_text(with_keys(tip, std::slice::from_ref(&open))).on_click(commands, open);
}

/// The ways to the start page and back, and where there is room to the presets.
fn pages(ui: &mut Ui, state: &State, has_room: bool, commands: &mut Commands) {
    let pages = [
        ("Lessons", Overlay::Start, "Opens the start page, with the lessons and presets."),
        ("Presets", Overlay::Presets, "Shows all presets: ready-made scenes."),
    ];
    for (name, page, tip) in pages.into_iter().take(if has_room { 2 } else { 1 }) {
        let shown = state.session.overlay.filter(|shown| shown.is_page());
        let is_open = shown.is_some_and(|shown| (shown == Overlay::Presets) == (page == Overlay::Presets));
        let button = ui.add(Button::new(name).selected(is_open));
        let open = Command::Window(WindowCommand::Toggle(page));
        let tip = with_keys(tip, std::slice::from_ref(&open));
        button.on_hover_text(tip).on_click(commands, open);
    }
}

/// Shows as many whole sentences of the preset's caption as fit in two lines, and all of it on hover.
fn caption(ui: &mut Ui, state: &State) {
    let has_room = ui.available_width() >= NARROWEST_CAPTION;
    // On a page nothing of the preset is seen.
    let is_page = state.session.overlay.is_some_and(Overlay::is_page);
    let Some(preset) = state.told_preset().filter(|_| has_room && !is_page) else { return };
    let format = TextFormat::simple(TextStyle::Small.resolve(ui.style()), ui.visuals().weak_text_color());
    let wrap = TextWrapping { max_width: ui.available_width(), max_rows: 2, ..TextWrapping::default() };
    let laid = |text: &str| {
        let mut job = LayoutJob::single_section(text.to_owned(), format.clone());
        job.wrap = wrap.clone();
        ui.painter().layout_job(job)
    };
    let sentences = whole_sentences(&preset.caption);
    if let Some(galley) = sentences.iter().rev().map(|text| laid(text)).find(|galley| !galley.elided) {
        ui.label(galley).on_hover_text(&preset.caption);
    }
}

fn scene(ui: &mut Ui, state: &State, commands: &mut Commands) {
    ui.scope(|ui| {
        let room = ui.available_width();
        let is_on_phone = room < NARROWEST_WITH_WAY_BACK;
        // On a phone a long name leaves room for the buttons after it.
        ui.set_max_width(if is_on_phone { (room - PHONE_BUTTONS).max(LEAST_NAME) } else { room });
        choose_scene(ui, state, if is_on_phone { LEAST_NAME } else { USUAL_NAME }, commands);
    });
}

fn choose_scene(ui: &mut Ui, state: &State, least: f32, commands: &mut Commands) {
    ComboBox::from_id_salt("scene")
        .selected_text(&state.document.scene.name)
        .width(least)
        .truncate()
        .height(MENU_HEIGHT)
        .show_ui(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 1.0;
            // Above the program's own, which have to be scrolled in a low window.
            files(ui, state, commands);
            ui.separator();
            for (preset, scene) in PRESETS.into_iter().filter_map(|name| Some((name, Scene::preset(name)?))) {
                let shown = scene.name == state.document.scene.name;
                ui.selectable_label(shown, scene.name).on_click(commands, ShowCommand::Scene(preset));
            }
        })
        .response
        .on_hover_text(
            "Chooses what rides past: a scene of the program, or a file that was opened. A file dropped \
                onto the window opens too.",
        )
        .accessible_name("Scene");
}

/// The files that were opened, and the way to another.
fn files(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let shown = state.shown_files();
    for path in state.session.recent.all() {
        let choice = ui.selectable_label(shown.contains(path), file_name(path));
        choice.on_hover_text(files::shown(path)).on_click(commands, FileCommand::Open(path.clone()));
    }
    let tip = "Opens a scene, a model, a state, data, or a picture with the state that it records.";
    let tip = with_keys(tip, &[Command::File(FileCommand::Choose(Purpose::Open))]);
    ui.button("Open…").on_hover_text(tip).on_click(commands, FileCommand::Choose(Purpose::Open));
}

/// Shows the choice of units for lengths and times in the whole window.
fn units(ui: &mut Ui, state: &State, commands: &mut Commands) {
    ComboBox::from_id_salt("units")
        .selected_text(UNITS[state.measures().units as usize].1)
        .width(92.0)
        .show_ui(ui, |ui| units_to_choose(ui, state, commands))
        .response
        .on_hover_text(about("units"))
        .accessible_name("Units");
}

fn units_to_choose(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let (window, shown) = (state.document.settings.window, state.measures().units);
    let has_metres = state.document.scene.metres.is_some();
    for (choice, name) in UNITS {
        let is_there = has_metres || choice == Units::Natural;
        let response = ui.add_enabled(is_there, Button::selectable(shown == choice, name));
        explained_lazily(response, || meaning(&choice))
            .on_disabled_hover_text(NO_METRES)
            .on_click(commands, SettingsCommand::Window(WindowSettings { units: choice, ..window }));
    }
    if !has_metres {
        ui.label(RichText::new(NO_METRES).weak().small());
    }
}

/// Shows the buttons that undo, redo and reset.
fn way_back(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let history = &state.session.history;
    let reset = format!(
        "Resets speed, eyes, path, look, light, plots and points to the defaults, {}. The parts of the \
            window, its units and colours, and the screen stay as they are. Undo takes the reset back.",
        state.defaults_source()
    );
    let buttons = [
        (Icon::Undo, "Undo", "Undoes the last step.", history.can_undo(), Command::Undo),
        (Icon::Redo, "Redo", "Redoes the step that was undone.", history.can_redo(), Command::Redo),
        (Icon::Reset, "Reset", &reset, !state.is_default(), Command::Settings(SettingsCommand::Reset)),
    ];
    let apart = std::mem::replace(&mut ui.spacing_mut().item_spacing.x, 3.0);
    for (icon, name, tip, is_there, command) in buttons {
        let button = ui.add_enabled_ui(is_there, |ui| icons::button(ui, icon, name, vec2(26.0, 22.0)));
        let tip = with_keys(tip, std::slice::from_ref(&command));
        button.inner.on_hover_text(&tip).on_disabled_hover_text(&tip).on_click(commands, command);
    }
    ui.spacing_mut().item_spacing.x = apart;
}

const UNITS: [(Units, &str); 3] =
    [(Units::Natural, "c = 1"), (Units::Metric, "m, ns"), (Units::Town, "c = 30 km/h")];

const NO_METRES: &str = "This scene does not say how many metres its unit is.";

/// Shows the menu of a narrow bar: the units, the theme, and `with_parts` the parts that are shown.
fn more(ui: &mut Ui, state: &State, with_parts: bool, commands: &mut Commands) {
    let stays_open = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let menu = MenuButton::new("More").config(stays_open).ui(ui, |ui| looks(ui, state, with_parts, commands));
    menu.0.on_hover_text("Units, theme");
}

/// Shows the menu of a phone's bar: the way back, the help, and but for who sees the window for the first
/// time the rest.
fn more_on_a_phone(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let stays_open = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let menu = MenuButton::new("More").config(stays_open).ui(ui, |ui| {
        ui.horizontal(|ui| way_back(ui, state, commands));
        help(ui, commands);
        stereoscope_button(ui, commands);
        if !state.document.settings.window.simple {
            ui.separator();
            looks(ui, state, true, commands);
        }
    });
    menu.0.on_hover_text("Undo, help, stereoscope, units, theme");
}

fn looks(ui: &mut Ui, state: &State, with_parts: bool, commands: &mut Commands) {
    ui.label(RichText::new("Units").weak()).on_hover_text(about("units"));
    units_to_choose(ui, state, commands);
    ui.separator();
    ui.horizontal(|ui| {
        ui.label(RichText::new("Switches between a light and a dark window").weak());
        theme(ui, state, commands);
    });
    if with_parts {
        ui.separator();
        parts(ui, state, commands);
    }
}

fn theme(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let dark = ui.visuals().dark_mode;
    let (icon, theme) = if dark { (Icon::Light, Theme::Light) } else { (Icon::Dark, Theme::Dark) };
    let window = WindowSettings { theme, ..state.document.settings.window };
    icons::button(ui, icon, "Theme", vec2(30.0, 22.0))
        .on_hover_text("Switches between a light and a dark window")
        .on_click(commands, SettingsCommand::Window(window));
}

/// Shows the switches of the parts of the window.
fn parts(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let mut window = state.document.settings.window;
    ui.toggle_value(&mut window.controls, "Controls").on_hover_text(about("controls"));
    ui.toggle_value(&mut window.plots, "Plots").on_hover_text(about("plots"));
    let mut shows_map = state.frame.shows_map;
    let map_tip = with_keys(about("map"), &[Command::Settings(SettingsCommand::Switch(Switch::Map))]);
    ui.toggle_value(&mut shows_map, "Map").on_hover_text(map_tip);
    on_change(commands, &state.frame.shows_map, shows_map, |_| SettingsCommand::Switch(Switch::Map));
    ui.toggle_value(&mut window.views, "Views").on_hover_text(about("views"));
    on_change(commands, &state.document.settings.window, window, SettingsCommand::Window);
}
