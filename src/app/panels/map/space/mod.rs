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

use self::light::Light;
use self::sheet::Sheet;
use super::canvas;
use super::labels::Labels;
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::map::{Chart, Extent, Instant, Lines, Projection, plan_and_side};
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
        let (settings, [left, right]) = (&state.document.settings, instant.eyes());
        if settings.ride.is_on() {
            Extent::of_ride(settings, scene, 0.5 * (left.x + right.x))
        } else {
            Extent::of_space(settings, scene)
        }
    });
    let area = [rect.min.x, rect.min.y, rect.width(), rect.height()].map(f64::from);
    plan_and_side(area, &extent, &state.scratch.map_view)
}
