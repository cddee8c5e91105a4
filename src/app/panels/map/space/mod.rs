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

use self::light::ChartLight;
use self::sheet::{SheetPainter, SpaceSheet};
use super::canvas;
use super::labels::MapLabels;
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::map::{BodyPicture, Chart, MapInstant, MapProjection, OutlineLines, WorldBox, plan_and_side};
use crate::settings::MapFraming;

/// Shows it in `rect`.
pub fn show(ui: &mut Ui, state: &State, rect: Rect, commands: &mut Commands) {
    let rect = legend::show(ui, state, rect);
    let instant = MapInstant::new(&state.document.settings, state.document.time);
    let charts = charts(state, &instant, rect);
    let lines = OutlineLines::new(&instant, &state.document.scene, &charts);
    for (projection, chart) in MapProjection::BOTH.into_iter().zip(charts) {
        let sheet = SpaceSheet { projection, chart };
        let response = canvas::look_around(ui, state, sheet.name(), &chart, projection.axes(), commands);
        let painter = ui.painter().with_clip_rect(sheet.room().intersect(ui.clip_rect()));
        let labels = MapLabels::new(ui, &painter, sheet.room());
        let mut on = SheetPainter { ui, painter: &painter, state, instant: &instant, sheet, labels };
        backdrop::paint(&mut on);
        let light = ChartLight::new(state, &sheet);
        if let Some(light) = &light {
            light.paint(ui, &painter, state);
        }
        pictures::paint(ui, &painter, &lines, &sheet);
        marks::show(&mut on);
        lengths::show(&mut on);
        if let Some(light) = &light {
            light.name(&mut on);
        }
        pointer::read(ui, &painter, &response, state, &lines, &sheet, commands);
    }
}

fn charts(state: &State, instant: &MapInstant, rect: Rect) -> [Chart; 2] {
    let scene = &state.document.scene;
    let close_up = match state.document.settings.map.framing {
        MapFraming::CloseUp => {
            WorldBox::close_up(instant, scene, state.document.points.selected().track.motion)
        }
        MapFraming::Passage => None,
    };
    let extent = close_up.unwrap_or_else(|| {
        let (settings, here) = (&state.document.settings, instant.middle());
        let point = &state.document.points.selected().track;
        let pictures = [BodyPicture::Measured, BodyPicture::Seen(0), BodyPicture::Seen(1)];
        let seen = pictures.into_iter().filter_map(|picture| instant.place(point, picture));
        if !settings.ride.is_on() {
            WorldBox::of_space(settings, scene)
        } else if settings.ride.is_along_street() {
            let around = WorldBox::of_ride(settings, scene, here.x);
            // Distances that are told are shown.
            if settings.window.distances {
                around.reaching(here.x, seen.map(|place| place.x))
            } else {
                around
            }
        } else {
            let velocity = instant.observer().velocity;
            let beta = velocity.speed().beta() * DVec3::from(velocity.direction());
            WorldBox::of_ride_aslant(here, beta, seen)
        }
    });
    let area = [rect.min.x, rect.min.y, rect.width(), rect.height()].map(f64::from);
    plan_and_side(area, &extent, &state.scratch.map_view)
}
