//! The menu of the stereoscope: its measures, and the way in and out.

use eframe::egui::{Align2, Area, Context, Frame, Id, Order, Slider, Ui, vec2};

use crate::app::commands::{SettingsCommand, WindowCommand};
use crate::app::panels::{Commands, OnClick as _, on_change};
use crate::settings::{LENS_MM, PICTURE_MM, ScreenSettings, about};

/// Width of the menu, points.
const WIDTH: f32 = 320.0;
/// Distances that lenses usually have from each other and from the screen, mm; others can be typed.
const APART_MM: std::ops::RangeInclusive<f64> = 50.0..=80.0;
const TO_SCREEN_MM: std::ops::RangeInclusive<f64> = 25.0..=100.0;
/// Height of what a finger meets, points.
const FINGER: f32 = 30.0;

/// The page that the menu leads to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MenuChoice {
    /// The pictures alone.
    Pictures,
    /// The menu, over the pictures.
    Menu,
    /// The card by which the screen is measured.
    Card,
}

/// Facts about the device and its screen, for the menu's words.
#[derive(Debug, Clone, Copy)]
pub struct Known {
    /// Whether the device reports its orientation.
    pub is_turned: bool,
    /// Whether the size of its screen can be found by a card.
    pub takes_card: bool,
    /// Whether the size was set.
    pub is_measured: bool,
}

/// Shows the button that opens the menu, between the pictures.
pub fn button(ctx: &Context) -> MenuChoice {
    let area = Area::new(Id::unique("stereoscope's button")).order(Order::Foreground);
    let shown = area.anchor(Align2::CENTER_BOTTOM, vec2(0.0, -4.0)).show(ctx, |ui| {
        ui.spacing_mut().interact_size.y = FINGER;
        ui.button("Menu").clicked()
    });
    if shown.inner { MenuChoice::Menu } else { MenuChoice::Pictures }
}

/// Shows the menu over the pictures.
pub fn show(ctx: &Context, screen: ScreenSettings, known: Known, commands: &mut Commands) -> MenuChoice {
    let area = Area::new(Id::unique("stereoscope's menu")).order(Order::Foreground);
    let shown = area.anchor(Align2::CENTER_CENTER, vec2(0.0, 0.0)).show(ctx, |ui| {
        Frame::popup(ui.style()).show(ui, |ui| {
            ui.set_width(WIDTH.min(ctx.content_rect().width() - 24.0));
            ui.spacing_mut().interact_size.y = FINGER;
            words(ui, known);
            measures(ui, screen, known, commands);
            buttons(ui, known, commands)
        })
    });
    shown.inner.inner
}

fn words(ui: &mut Ui, known: Known) {
    ui.strong("Stereoscope");
    let turn = if known.is_turned { "Turn your head" } else { "Turn your head, or drag," };
    ui.label(format!(
        "Put the device into a viewer with two lenses. {turn} to look around. A tap brings the middle of what moves before you and plays, \
         another one pauses."
    ));
    let area = ui.ctx().content_rect();
    if area.width() < area.height() {
        ui.strong("Turn the device on its side: each eye needs half of the width.");
    }
    if !known.is_measured && known.takes_card {
        ui.strong("The size of the screen is guessed: measure it by a bank card.");
    }
}

fn measures(ui: &mut Ui, screen: ScreenSettings, known: Known, commands: &mut Commands) {
    let mut changed = screen;
    let [apart, to_screen] = [&mut changed.picture_distance, &mut changed.lens_to_screen];
    let rows = [
        ("Lenses apart", "picture-distance", APART_MM, PICTURE_MM, apart),
        ("Lenses to screen", "lens-to-screen", TO_SCREEN_MM, LENS_MM, to_screen),
    ];
    for (name, setting, usual, all, value) in rows {
        let tip = about(setting);
        ui.horizontal(|ui| {
            ui.label(name).on_hover_text(tip);
            // One that was set elsewhere stays.
            let range = usual.start().min(*value)..=usual.end().max(*value);
            let slider = Slider::new(value, range).suffix(" mm").max_decimals(1);
            ui.add(slider).on_hover_text(tip);
            *value = value.clamp(*all.start(), *all.end());
        });
    }
    if known.is_measured {
        ui.weak("The size of the screen was set.");
    }
    on_change(commands, &screen, changed, SettingsCommand::Screen);
}

fn buttons(ui: &mut Ui, known: Known, commands: &mut Commands) -> MenuChoice {
    let mut choice = MenuChoice::Menu;
    ui.horizontal(|ui| {
        if ui.button("Look").clicked() {
            choice = MenuChoice::Pictures;
        }
        if known.takes_card && ui.button("Card…").clicked() {
            choice = MenuChoice::Card;
        }
        ui.button("Leave").on_click(commands, WindowCommand::ToggleStereoscope);
    });
    choice
}
