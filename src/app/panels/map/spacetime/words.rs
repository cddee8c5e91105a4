//! Words for an event: its place, and its three times.

use relativity_core::Event;

use super::sheet::DiagramSheet;
use crate::app::panels::map::times::times;
use crate::caption::capitalised;
use crate::eye::Eye;
use crate::map::{Diagram, ReceivedRay};
use crate::settings::MapFrame;

/// Decimals of a length or a time in the scene's unit.
const DECIMALS: u8 = 3;

/// Describes the point at the ground's time `happened`; `what` follows its name.
pub fn of_point(sheet: &DiagramSheet<'_>, happened: f64, what: &str) -> String {
    let diagram = &sheet.diagram;
    let event = diagram.point.at(happened);
    let received = diagram.point.received(&sheet.state.document.settings.ride, happened);
    let times = times(sheet.state, [received, happened, diagram.point.proper_time(happened)]);
    let point = sheet.state.document.points.selected().noun(&sheet.state.document.scene);
    format!(
        "{}{what}\n{}\n{times}\nClick to see it: {} = {}",
        capitalised(&point),
        place(sheet, event),
        sheet.state.clock().symbol,
        time(sheet, received)
    )
}

/// Another followed point that is measured now, after its `name`.
pub fn of_other(sheet: &DiagramSheet<'_>, diagram: &Diagram, name: &str) -> String {
    let now = diagram.time;
    let received = diagram.point.received(&sheet.state.document.settings.ride, now);
    let shown = [received, now, diagram.point.proper_time(now)];
    format!("{}\n{}\n{}", capitalised(name), place(sheet, diagram.measured()), times(sheet.state, shown))
}

/// Describes the light that `eye` receives, at its emission.
pub fn of_ray(sheet: &DiagramSheet<'_>, eye: Eye, ray: &ReceivedRay) -> String {
    let times = times(sheet.state, [sheet.diagram.clock, ray.happened, ray.proper_time]);
    let name = eye.name().to_lowercase();
    format!("What the {name} sees now happened here\n{}\n{times}", place(sheet, ray.left))
}

/// Describes the eyes at T = `received`.
pub fn of_eyes(sheet: &DiagramSheet<'_>, received: f64) -> String {
    let observer = sheet.state.document.settings.rider(received).observer();
    let event = sheet.diagram.frame.event_at(observer.place, observer.time);
    let symbol = sheet.state.clock().symbol;
    format!(
        "Both eyes receive light\n{}\nreceived {symbol} = {}\nDrag it, or click on the line, to change {symbol}.",
        place(sheet, event),
        time(sheet, received)
    )
}

fn time(sheet: &DiagramSheet<'_>, value: f64) -> String {
    sheet.state.measures().time.text(value, DECIMALS)
}

/// x and t of the frame that is drawn.
fn place(sheet: &DiagramSheet<'_>, event: Event) -> String {
    let x = sheet.state.measures().length.text(event.x, DECIMALS);
    let t = time(sheet, event.t);
    match sheet.state.document.settings.map_frame() {
        MapFrame::Ground => format!("x = {x}, t = {t}"),
        MapFrame::Bicycle | MapFrame::Rider => format!("x′ = {x}, t′ = {t}"),
    }
}
