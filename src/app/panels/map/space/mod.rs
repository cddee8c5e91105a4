//! Space: the plan above, and below it the view from the side, as of now.

mod backdrop;
mod legend;
mod lengths;
mod light;
mod marks;
mod pictures;
mod pointer;
mod sheet;

use eframe::egui::{Rect, Ui};
use glam::DVec3;

use self::light::Light;
use self::sheet::Sheet;
use super::canvas;
use super::labels::Labels;
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::map::{Chart, Extent, Instant, Lines, Picture, Projection, plan_and_side};
use crate::settings::Framing;

/// Shows it in `rect`.
pub fn show(ui: &mut Ui, state: &State, rect: Rect, commands: &mut Commands) {
    let rect = legend::show(ui, state, rect);
    let instant = Instant::new(&state.document.settings, state.document.time);
    let charts = charts(state, &instant, rect);
    let lines = Lines::new(&instant, &state.document.scene, &charts);
    for (projection, chart) in Projection::BOTH.into_iter().zip(charts) {
        let sheet = Sheet { projection, chart };
        let response = canvas::look_around(ui, state, sheet.name(), &chart, projection.axes(), commands);
        let painter = ui.painter().with_clip_rect(sheet.room().intersect(ui.clip_rect()));
        let mut labels = Labels::new(sheet.room(), ui.visuals().extreme_bg_color);
        backdrop::paint(ui, &painter, state, &instant, &sheet, &mut labels);
        let light = Light::new(state, &sheet);
        if let Some(light) = &light {
            light.paint(ui, &painter, state);
        }
        pictures::paint(ui, &painter, &lines, &sheet);
        marks::show(ui, &painter, state, &instant, &sheet, &mut labels);
        lengths::show(ui, &painter, state, &instant, &sheet, &mut labels);
        if let Some(light) = &light {
            light.name(ui, &painter, state, &mut labels);
        }
        pointer::read(ui, &painter, &response, state, &lines, &sheet, commands);
    }
}

fn charts(state: &State, instant: &Instant, rect: Rect) -> [Chart; 2] {
    let scene = &state.document.scene;
    let close_up = match state.document.settings.map.framing {
        Framing::CloseUp => Extent::close_up(instant, scene, state.document.points.selected().track.motion),
        Framing::Passage => None,
    };
    let extent = close_up.unwrap_or_else(|| {
        let (settings, here) = (&state.document.settings, instant.middle());
        if !settings.ride.is_on() {
            Extent::of_space(settings, scene)
        } else if settings.ride.is_along_street() {
            Extent::of_ride(settings, scene, here.x)
        } else {
            let velocity = instant.observer().velocity;
            let beta = velocity.speed().beta() * DVec3::from(velocity.direction());
            let point = &state.document.points.selected().track;
            let pictures = [Picture::Measured, Picture::Seen(0), Picture::Seen(1)];
            let seen = pictures.into_iter().filter_map(|picture| instant.place(point, picture));
            Extent::of_ride_aslant(here, beta, seen)
        }
    });
    let area = [rect.min.x, rect.min.y, rect.width(), rect.height()].map(f64::from);
    plan_and_side(area, &extent, &state.scratch.map_view)
}
