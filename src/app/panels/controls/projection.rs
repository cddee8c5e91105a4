//! The controls of how directions become places in the views, and of what then lies in the screen.

use std::ops::RangeInclusive;

use eframe::egui::Ui;

use crate::app::state::State;
use crate::app::widgets::{Edit, NumberRow, choice, row};
use crate::flags::choices::{ProjectionChoice, ZeroParallax};
use crate::settings::{Look, MAX_LENGTH};

/// The distance to start from where the pictures are not shifted.
const USUAL_DEPTH: f64 = 4.0;
/// Nearest and furthest that can be typed.
const DEPTH: RangeInclusive<f64> = 1e-3..=MAX_LENGTH;

/// Shows the controls of the projection.
pub fn show(ui: &mut Ui, state: &State, look: &mut Look) {
    projection_row(ui, &mut look.projection);
    if state.document.settings.projection() != look.projection
        && look.projection == state.document.settings.look.projection
    {
        ui.label("The eyes are one behind the other: the views show camera pictures.");
    }
    zero_parallax_rows(ui, state, look);
}

fn projection_row(ui: &mut Ui, projection: &mut ProjectionChoice) {
    let tip = "Chooses how lines of sight become places in the pictures. Measured values do not change.";
    row(ui, "Pictures", tip, |ui| _ = choice(ui, projection, &PROJECTIONS));
}

const PROJECTIONS: [(ProjectionChoice, &str, &str); 3] = [
    (
        ProjectionChoice::Mercator,
        "Conformal",
        "Keeps the shape of small things everywhere: a globe stays round. Motion only slides the picture, \
            by the rapidity, and two eyes can fuse it. Things far aside are enlarged. (V changes to the \
            camera and back.)",
    ),
    (
        ProjectionChoice::Gaze,
        "Camera",
        "Draws as a photograph does, as in the paper: straight lines stay straight, and what is far from \
            the middle is stretched. A point then has two heights in the two pictures, which differ by \
            more than eyes can fuse.",
    ),
    (
        ProjectionChoice::Parallel,
        "Flat screens",
        "Projects both pictures onto planes along the line between the eyes, as two screens side by side would show them. \
        Two eyes can fuse them; what is aside is stretched.",
    ),
];

/// The object at the depth of the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
enum ScreenDepth {
    Point,
    Infinity,
    Distance,
}

const SCREEN_DEPTHS: [(ScreenDepth, &str, &str); 3] = [
    (
        ScreenDepth::Point,
        "The point",
        "The selected point, or the hub that it turns about: it is at the same place in both pictures, where two eyes look \
        most easily.",
    ),
    (
        ScreenDepth::Infinity,
        "Infinity",
        "What is infinitely far away: the pictures are not shifted, and everything appears in front of the \
            screen.",
    ),
    (ScreenDepth::Distance, "Distance", "Whatever is at a chosen distance in front of the eyes."),
];

fn zero_parallax_rows(ui: &mut Ui, state: &State, look: &mut Look) {
    let tip = "Chooses what appears in the plane of the screen, in the same place of both pictures. Each \
        picture is shifted as a whole; measured values do not change.";
    let before = match look.zero_parallax {
        ZeroParallax::Point => ScreenDepth::Point,
        ZeroParallax::Infinity => ScreenDepth::Infinity,
        ZeroParallax::Distance(_) => ScreenDepth::Distance,
    };
    let (mut chosen, is_used) = (before, look.projection.is_fused());
    row(ui, "Zero parallax", tip, |ui| {
        _ = ui.add_enabled_ui(is_used, |ui| choice(ui, &mut chosen, &SCREEN_DEPTHS));
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
        let row_of_number = NumberRow {
            name: "Screen at",
            tip: "Sets the distance at which objects appear in the plane of the screen.",
            slider: 0.5..=20.0,
            typed: DEPTH,
            decimals: 4,
            suffix: "",
        };
        if row_of_number.edit_in(ui, state.measures().length, distance) == Edit::Restored {
            look.zero_parallax = state.defaults().look.zero_parallax;
        }
    }
}
