//! The controls of one's own ride: getting on and off, its speed, its start and its legs.

use eframe::egui::{Button, Id, RichText, Ui};

use super::speed::{self, SpeedControl};
use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, SettingsCommand, Switch};
use crate::app::panels::{Commands, OnClick as _, on_change};
use crate::app::state::State;
use crate::app::state::riding::saddle::RideCommand;
use crate::app::widgets::{NumberRow, row, typed_text};
use crate::flags::choices::Compare;
use crate::flags::{RideLegs, SpeedSetting, StreetVelocity};
use crate::number_text;
use crate::settings::{AZIMUTH, ELEVATION, MAX_LENGTH, PUSH, Riding, about};

/// Width of the fields, points.
const FIELD: f32 = 150.0;

const SPEED_TIP: &str = "Pedals or brakes until this speed is reached: v/c, below 0 the other way, or like \
    gamma:10. Before the start it sets the speed to start with.";

const FACE_TIP: &str = "Turns your head to where you ride. On a ride that is pushed aside the head keeps its way as a gyroscope \
    does, and turns against the street.";

const STANDING_TIP: &str =
    "Shows beside your picture what somebody sees who stands where you ride, at the same event.";

/// Shows the rows of the section.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    button(ui, state, commands);
    let mut ride = state.document.settings.ride.clone();
    let default = state.defaults().ride;
    if !ride.is_on() {
        return;
    }
    NumberRow::new("Push", about("push"), 0.05..=2.0, PUSH).show(ui, &mut ride.push, default.push);
    start(ui, state, &mut ride, &default);
    direction(ui, &mut ride, &default);
    legs_row(ui, &mut ride);
    row(ui, "Comfort", "Helps against motion sickness on a ride.", |ui| {
        let mut window = state.document.settings.window;
        ui.checkbox(&mut window.vignette, "Vignette while turning").on_hover_text(about("vignette"));
        on_change(commands, &state.document.settings.window, window, SettingsCommand::Window);
    });
    on_change(commands, &state.document.settings.ride, ride, RideCommand::Set);
}

/// The button that gets on the bicycle, or off it.
pub fn button(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let is_on = state.document.settings.ride.is_on();
    let (text, tip) = if is_on {
        ("Get off", "Puts you beside the street again, where everything rides past.")
    } else {
        (
            "Get on and ride",
            "Puts you on a bicycle on the road, at first at rest. The arrow keys ↑ and ↓ pedal and brake.",
        )
    };
    let is_standing = is_on && state.document.settings.look.compare == Compare::Standing;
    let buttons = [
        (text, tip, false, Command::Ride(RideCommand::Toggle)),
        ("Face ahead", FACE_TIP, false, Command::Ride(RideCommand::Face)),
        ("Beside standing", STANDING_TIP, is_standing, SettingsCommand::Switch(Switch::Standing).into()),
    ];
    row(ui, "Ride", tip, |ui| {
        for (text, tip, is_chosen, asked) in buttons.into_iter().take(if is_on { 3 } else { 1 }) {
            let button = ui.add(Button::new(text).selected(is_chosen));
            button.on_hover_text(with_keys(tip, std::slice::from_ref(&asked))).on_click(commands, asked);
        }
    });
}

/// Shows the rider's own speed, large, and a field to type it in.
pub fn speeds(ui: &mut Ui, state: &State, commands: &mut Commands) {
    speed(ui, state, commands);
    speed_row(ui, state, commands);
}

/// Shows the rider's own speed: the slider pedals or brakes until it is reached.
pub fn speed(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let told = state.told_speed_text();
    let current = state.throttle();
    let control = SpeedControl {
        current,
        default: SpeedSetting::REST,
        told: &told,
        is_own: true,
        is_large: true,
        fields: &[],
    };
    let asked = speed::show(ui, control).filter(|speed| speed.speed() != current.speed());
    if let Some(velocity) = asked.and_then(|speed| state.throttled(speed)) {
        commands.push(RideCommand::Reach(velocity).into());
    }
}

fn speed_row(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let velocity = state.rider().velocity;
    let sign = if velocity.is_backward { "-" } else { "" };
    let shown = format!("{sign}{}", number_text::beta(&velocity.speed));
    let typed = checked(ui, "My speed β", SPEED_TIP, &shown, str::parse::<StreetVelocity>);
    if let Some(velocity) = typed {
        commands.push(RideCommand::Reach(velocity).into());
    }
}

fn start(ui: &mut Ui, state: &State, ride: &mut Riding, default: &Riding) {
    let lengths = -MAX_LENGTH..=MAX_LENGTH;
    let place = NumberRow::new("Starts at x", about("ride-from"), -50.0..=50.0, lengths);
    place.show_in(ui, state.measures().length, &mut ride.ride_from, default.ride_from);
    let shown = ride.ride_speed.to_string();
    if let Some(speed) = checked(ui, "Starts with β", about("ride-speed"), &shown, str::parse) {
        ride.ride_speed = speed;
    }
}

/// The direction of the ride, in degrees.
fn direction(ui: &mut Ui, ride: &mut Riding, default: &Riding) {
    let angle = |name, tip, slider, typed| NumberRow::new(name, tip, slider, typed).decimals(3).suffix("°");
    let azimuth = angle("Direction", about("ride-azimuth"), -180.0..=180.0, AZIMUTH);
    azimuth.show(ui, &mut ride.ride_azimuth, default.ride_azimuth);
    let elevation = angle("Upwards", about("ride-elevation"), ELEVATION, ELEVATION);
    elevation.show(ui, &mut ride.ride_elevation, default.ride_elevation);
}

fn legs_row(ui: &mut Ui, ride: &mut Riding) {
    let shown = ride.ride.rounded().to_string();
    let typed = checked(ui, "Legs", about("ride"), &shown, str::parse::<RideLegs>);
    if let Some(legs) = typed {
        ride.ride = legs;
    }
}

/// A row with a field whose text `parse` reads; what is wrong with it stays below until it is right.
fn checked<T>(
    ui: &mut Ui,
    name: &'static str,
    tip: &str,
    shown: &str,
    parse: impl Fn(&str) -> Result<T, String>,
) -> Option<T> {
    let error_id = Id::unique(("error of", name));
    let mut found = None;
    row(ui, name, tip, |ui| {
        let Some(text) = typed_text(ui, &format!("{name}, typed"), tip, shown, FIELD) else { return };
        let parsed = parse(&text);
        ui.data_mut(|data| data.insert_temp(error_id, parsed.as_ref().err().cloned()));
        found = parsed.ok();
    });
    if let Some(message) = ui.data(|data| data.get_temp::<Option<String>>(error_id)).flatten() {
        ui.label(RichText::new(message).color(ui.visuals().error_fg_color));
    }
    found
}
