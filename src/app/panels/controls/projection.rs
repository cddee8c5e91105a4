//! The controls of how directions become places in the views, and of what then lies in the screen.

use std::ops::RangeInclusive;

use eframe::egui::Ui;

use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, SettingsCommand, Switch};
use crate::app::state::State;
use crate::app::widgets::{Edit, NumberRow, choice, choice_of, row};
use crate::flags::choices::{ProjectionChoice, ZeroParallax};
use crate::settings::{LookSettings, MAX_LENGTH, about};

/// The distance to start from where the pictures are not shifted.
const USUAL_DEPTH: f64 = 4.0;
/// Nearest and furthest that can be typed.
const DEPTH: RangeInclusive<f64> = 1e-3..=MAX_LENGTH;

/// Shows the controls of the projection.
pub fn show(ui: &mut Ui, state: &State, look: &mut LookSettings) {
    let key = Command::Settings(SettingsCommand::Switch(Switch::Projection));
    let tip = with_keys(about("projection"), &[key]);
    row(ui, "Pictures", &tip, |ui| _ = choice(ui, &mut look.projection, &PROJECTIONS));
    if state.document.settings.projection() != look.projection
        && look.projection == state.document.settings.look.projection
    {
        ui.label("The eyes are one behind the other: the views show camera pictures.");
    }
    zero_parallax_rows(ui, state, look);
}

const PROJECTIONS: [(ProjectionChoice, &str); 3] = [
    (ProjectionChoice::Mercator, "Conformal"),
    (ProjectionChoice::Gaze, "Camera"),
    (ProjectionChoice::Parallel, "Flat screens"),
];

/// The object at the depth of the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
enum ScreenDepth {
    Point,
    Infinity,
    Distance,
}

const SCREEN_DEPTHS: [(ScreenDepth, &str); 3] = [
    (ScreenDepth::Point, "The point"),
    (ScreenDepth::Infinity, "Infinity"),
    (ScreenDepth::Distance, "Distance"),
];

fn zero_parallax_rows(ui: &mut Ui, state: &State, look: &mut LookSettings) {
    let tip = about("zero-parallax");
    let before = match look.zero_parallax {
        ZeroParallax::Point => ScreenDepth::Point,
        ZeroParallax::Infinity => ScreenDepth::Infinity,
        ZeroParallax::Distance(_) => ScreenDepth::Distance,
    };
    let (mut chosen, is_used) = (before, look.projection.is_fused());
    row(ui, "Zero parallax", tip, |ui| {
        _ = ui.add_enabled_ui(is_used, |ui| choice_of(ui, &mut chosen, &SCREEN_DEPTHS, tip));
    });
    if chosen != before {
        look.zero_parallax = match chosen {
            ScreenDepth::Point => ZeroParallax::Point,
            ScreenDepth::Infinity => ZeroParallax::Infinity,
            // From where it is now.
            ScreenDepth::Distance => match state.look().zero_parallax {
                ZeroParallax::Distance(distance) => ZeroParallax::Distance(distance),
                ZeroParallax::Point | ZeroParallax::Infinity => ZeroParallax::Distance(USUAL_DEPTH),
            },
        };
    }
    if let (ZeroParallax::Distance(distance), true) = (&mut look.zero_parallax, is_used) {
        let depth = NumberRow::new("Screen at", tip, 0.5..=20.0, DEPTH).decimals(4);
        if depth.edit_in(ui, state.measures().length, distance) == Edit::Restored {
            look.zero_parallax = state.defaults().look.zero_parallax;
        }
    }
}
