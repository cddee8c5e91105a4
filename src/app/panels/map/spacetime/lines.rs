//! Lines of the diagram: worldlines, past light cones, light, and presents.

use eframe::egui::{Color32, Pos2, Shape, Stroke};
use relativity_core::Event;
use relativity_render::Velocity;

use super::sheet::{DiagramSheet, NEAR};
use crate::app::panels::map::labels::MapLabels;
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::map::{Diagram, PastCone, ReceivedRay, StraightLine, worldline_of_eye};
use crate::quantity::Quantity;
use crate::settings::MapFrame;

/// Length and gap of dashes, points: for the line of simultaneity of the other frame, and for light projected
/// onto the plane.
const DASH: f32 = 6.0;
const SPACE: f32 = 4.0;
/// Eyes that are further apart than this have names of their own, points.
const EYES_APART: f32 = 60.0;
/// Places on the shown part of a present's line, as shares of it, the first free one of which has its name.
const NOW_NAMES: [f32; 4] = [0.9, 0.7, 0.5, 0.25];

/// Draws lines of simultaneity, light cones, world lines and rays.
pub fn paint(sheet: &DiagramSheet<'_>, labels: &mut MapLabels) {
    nows(sheet, labels);
    cones(sheet, labels);
    eyes(sheet, labels);
    for (point, diagram) in &sheet.others {
        worldline(sheet, labels, diagram, theme::point_colour(point.number, sheet.ui.visuals()));
    }
    worldline(sheet, labels, &sheet.diagram, point_colour(sheet));
    rays(sheet, labels);
}

/// Returns the part of a line that is shown, on screen.
fn shown(sheet: &DiagramSheet<'_>, line: StraightLine) -> Option<[Pos2; 2]> {
    let [low, high] = sheet.corners();
    line.within(low, high).map(|ends| ends.map(|event| sheet.place(event)))
}

fn draw(sheet: &DiagramSheet<'_>, labels: &mut MapLabels, line: StraightLine, stroke: Stroke) {
    if let Some(ends) = shown(sheet, line) {
        sheet.painter.line_segment(ends, stroke);
        labels.places.avoid(ends, 1.0);
    }
}

fn dashed(sheet: &DiagramSheet<'_>, labels: &mut MapLabels, ends: [Pos2; 2], stroke: Stroke) {
    sheet.painter.extend(Shape::dashed_line(&ends, stroke, DASH, SPACE));
    labels.places.avoid(ends, 1.0);
}

/// Draws the present: of the frame that is drawn, solid; of the other one, dashed.
fn nows(sheet: &DiagramSheet<'_>, labels: &mut MapLabels) {
    let [ground, scene] = sheet.diagram.nows();
    let colours = now_colours(sheet);
    let is_ground = sheet.state.document.settings.map_frame() == MapFrame::Ground;
    let both = [(ground, colours[0], is_ground), (scene, colours[1], !is_ground)];
    for (line, colour, is_own) in both.into_iter().take(number_of_nows(sheet)) {
        let stroke = Stroke::new(1.2, colour);
        if is_own {
            draw(sheet, labels, line, stroke);
        } else if let Some(ends) = shown(sheet, line) {
            dashed(sheet, labels, ends, stroke);
        }
    }
}

/// Returns the number of presents: one where both frames are the same.
fn number_of_nows(sheet: &DiagramSheet<'_>) -> usize {
    if sheet.diagram.other.is_rest() { 1 } else { 2 }
}

/// The colours of what is at one time on the ground, and in the scene's frame: the latter in the colour of
/// the point where it rests there.
pub fn now_colours(sheet: &DiagramSheet<'_>) -> [Color32; 2] {
    let measured = theme::measured_colour(sheet.ui.visuals());
    let moves_with_scene =
        Velocity::along_street(&sheet.diagram.other) == Some(sheet.diagram.point.velocity());
    let scene =
        if moves_with_scene { point_colour(sheet).gamma_multiply(0.8) } else { measured.gamma_multiply(0.4) };
    [measured.gamma_multiply(0.55), scene]
}

fn point_colour(sheet: &DiagramSheet<'_>) -> Color32 {
    theme::point_colour(sheet.state.document.points.selected().number, sheet.ui.visuals())
}

/// The past light cones in the plane of the point, and light that runs along x.
fn cones(sheet: &DiagramSheet<'_>, labels: &mut MapLabels) {
    let [low, high] = sheet.corners();
    let Some(cones) = sheet.diagram.cones() else { return };
    paint_past(sheet, &cones[0]);
    for (eye, cone) in Eye::BOTH.into_iter().zip(cones) {
        let colour = theme::eye_colour(eye, sheet.ui.visuals());
        for line in cone.asymptotes() {
            let past = Event { x: -1e-9 * line.step.x, t: -1e-9 };
            let part = line.part_within(low, high).filter(|part| part[0] < 0.0);
            if let Some([first, last]) = part {
                let ends = [first, last.min(0.0)].map(|steps| sheet.place(line.at(steps).plus(past)));
                sheet.painter.line_segment(ends, Stroke::new(1.0, colour.gamma_multiply(0.3)));
            }
        }
        let curve: Vec<Pos2> =
            cone.curve([low.x, high.x]).into_iter().map(|event| sheet.place(event)).collect();
        labels.places.avoid(&curve, 1.0);
        sheet.painter.line(curve, Stroke::new(1.5, colour));
    }
}

/// Tints all from where light has arrived by now.
fn paint_past(sheet: &DiagramSheet<'_>, cone: &PastCone) {
    let [low, high] = sheet.corners();
    let Some([left, right]) = cone.later_than(low.t) else { return };
    let [left, right] = [left.clamp(low.x, high.x), right.clamp(low.x, high.x)];
    let mut outline: Vec<Pos2> =
        cone.curve([left, right]).into_iter().map(|event| sheet.place(event)).collect();
    outline.extend([right, left].map(|x| sheet.place(Event { x, t: low.t })));
    // A fan of triangles is torn where two corners are one.
    outline.dedup_by(|a, b| a.distance(*b) < 0.5);
    let tint = sheet.ui.visuals().text_color().gamma_multiply(0.05);
    sheet.painter.add(Shape::convex_polygon(outline, tint, Stroke::NONE));
}

fn eyes(sheet: &DiagramSheet<'_>, labels: &mut MapLabels) {
    if sheet.state.document.settings.ride.is_on() {
        return riding_eyes(sheet, labels);
    }
    for (eye, line) in Eye::BOTH.into_iter().zip(sheet.diagram.eyes()) {
        draw(sheet, labels, line, Stroke::new(1.5, theme::eye_colour(eye, sheet.ui.visuals())));
    }
}

/// Draws the worldlines of eyes that ride: they bend where the velocity changes.
fn riding_eyes(sheet: &DiagramSheet<'_>, labels: &mut MapLabels) {
    let (settings, range) = (&sheet.state.document.settings, sheet.state.time_range());
    for eye in Eye::BOTH {
        let events = worldline_of_eye(settings, &sheet.diagram.frame, eye.index(), range);
        let places: Vec<Pos2> = events.into_iter().map(|event| sheet.place(event)).collect();
        labels.places.avoid(&places, 1.0);
        sheet.painter.line(places, Stroke::new(1.5, theme::eye_colour(eye, sheet.ui.visuals())));
    }
}

/// Returns the owner of the other frame's clocks, in words.
pub fn whose(sheet: &DiagramSheet<'_>) -> String {
    if sheet.state.document.settings.ride.is_on() {
        return "my own".to_owned();
    }
    format!("the {}'s", sheet.state.document.scene.rider)
}

/// Draws the worldline of a point: boldest as far as light from it has arrived, and faint where it is yet to
/// be.
fn worldline(sheet: &DiagramSheet<'_>, labels: &mut MapLabels, diagram: &Diagram, colour: Color32) {
    let times = sheet.worldline_times(diagram);
    let received = diagram.rays.map(|ray| ray.happened);
    let received = received[0].min(received[1]);
    let now = diagram.time;
    let parts = [
        (f64::NEG_INFINITY, received, Stroke::new(3.0, colour)),
        (received, now, Stroke::new(2.0, colour)),
        (now, f64::INFINITY, Stroke::new(1.5, colour.gamma_multiply(0.45))),
    ];
    for (from, to, stroke) in parts {
        let places: Vec<Pos2> =
            part(&times, from, to).map(|time| sheet.place(diagram.point.at(time))).collect();
        labels.places.avoid(&places, 1.0);
        sheet.painter.line(places, stroke);
    }
}

/// Returns those of the `times` that are between `from` and `to`, and these two, where they are between the
/// first and the last.
fn part(times: &[f64], from: f64, to: f64) -> impl Iterator<Item = f64> {
    let ends = times.first().copied().zip(times.last().copied());
    let ends = ends.map(|(first, last)| (from.max(first), to.min(last))).filter(|(from, to)| from < to);
    let (from, to) = ends.unwrap_or((f64::INFINITY, f64::INFINITY));
    let inner = times.iter().copied().filter(move |&time| time > from && time < to);
    let ends = ends.map(|(from, to)| [from, to]);
    ends.map(|[from, _]| from).into_iter().chain(inner).chain(ends.map(|[_, to]| to))
}

/// The light that arrives at T: dashed, for it also crosses the distance that is not drawn.
fn rays(sheet: &DiagramSheet<'_>, labels: &mut MapLabels) {
    for (eye, ray) in Eye::BOTH.into_iter().zip(sheet.diagram.rays) {
        let colour = theme::eye_colour(eye, sheet.ui.visuals());
        if let Some(ends) = shown_ray(sheet, &ray) {
            dashed(sheet, labels, ends, Stroke::new(1.2, colour));
        }
    }
}

/// Returns the part of the light's way that is shown, on screen.
fn shown_ray(sheet: &DiagramSheet<'_>, ray: &ReceivedRay) -> Option<[Pos2; 2]> {
    let step = Event { x: ray.received.x - ray.left.x, t: ray.received.t - ray.left.t };
    let line = StraightLine { through: ray.left, step };
    let [low, high] = sheet.corners();
    let [from, to] = line.part_within(low, high)?;
    let (from, to) = (from.max(0.0), to.min(1.0));
    (from < to).then(|| [from, to].map(|steps| sheet.place(line.at(steps))))
}

/// Returns the place of a worldline's name, on the part that is shown.
fn upper([first, last]: [Pos2; 2]) -> Pos2 {
    first.lerp(last, 0.93)
}

/// Names what is not clear by its marks; first the lines of what is now, which differ by nothing else.
pub fn name(sheet: &DiagramSheet<'_>, labels: &mut MapLabels) {
    let mut write = |place: Pos2, text: &str, colour: Color32| labels.write((place, 1.0), text, colour);
    let number = number_of_nows(sheet);
    let names = if number == 1 {
        ["now".to_owned(), String::new()]
    } else {
        let other = if sheet.state.document.settings.ride.is_on() {
            "mine"
        } else {
            &sheet.state.document.scene.rider
        };
        ["ground", other].map(|whose| format!("now, {whose}"))
    };
    let nows = sheet.diagram.nows().into_iter().take(number);
    for ((line, name), colour) in nows.zip(names).zip(now_colours(sheet)) {
        if let Some([left, right]) = shown(sheet, line) {
            let places = NOW_NAMES.map(|part| left.lerp(right, part));
            let _written = places.into_iter().any(|place| write(place, &name, colour));
        }
    }
    let selected = (sheet.state.document.points.selected(), sheet.diagram);
    for (point, diagram) in [selected].iter().chain(&sheet.others) {
        if let Some(ends) = shown(sheet, diagram.worldline()) {
            let colour = theme::point_colour(point.number, sheet.ui.visuals());
            write(upper(ends), &sheet.state.name_of(point), colour);
        }
    }
    name_eyes(sheet, &mut write);
    name_far_event(sheet, &mut write);
    name_light(sheet, &mut write);
}

/// When the light left, where that is too far off to be shown.
fn name_far_event(sheet: &DiagramSheet<'_>, write: &mut impl FnMut(Pos2, &str, Color32) -> bool) {
    let [_, ray] = sheet.diagram.rays;
    if sheet.room().contains(sheet.place(ray.left)) {
        return;
    }
    if let Some([from, _]) = shown_ray(sheet, &ray) {
        let time = sheet.state.measures().time.text(ray.happened, 1);
        write(
            from,
            &format!("{} {time}, further off", Quantity::EmissionTime.row().name),
            sheet.ui.visuals().text_color(),
        );
    }
}

/// The eyes by one name where they are close together.
fn name_eyes(sheet: &DiagramSheet<'_>, write: &mut impl FnMut(Pos2, &str, Color32) -> bool) {
    let visuals = sheet.ui.visuals();
    let tops = sheet.diagram.eyes().map(|eye| shown(sheet, eye).map(upper));
    match tops {
        [Some(left), Some(right)] if left.distance(right) < EYES_APART => {
            write(left, "eyes", visuals.text_color());
        }
        _ => {
            for (eye, top) in Eye::BOTH.into_iter().zip(tops) {
                if let Some(top) = top {
                    write(top, &eye.name().to_lowercase(), theme::eye_colour(eye, visuals));
                }
            }
        }
    }
}

/// The cone, and the light that runs along x, low in the chart.
fn name_light(sheet: &DiagramSheet<'_>, write: &mut impl FnMut(Pos2, &str, Color32) -> bool) {
    let colour = sheet.ui.visuals().weak_text_color();
    let [low, high] = sheet.corners();
    let Some([_, cone]) = sheet.diagram.cones() else { return };
    let at = |part: f64| low.t + part * (high.t - low.t);
    if let Some([left, right]) = cone.later_than(at(0.12)) {
        let x = if right < high.x { right } else { left };
        write(sheet.place(Event { x, t: at(0.12) }), "past light cone", colour);
    }
    let [_, outwards] = cone.asymptotes();
    let steps = at(0.3) - outwards.through.t;
    if steps < 0.0 {
        write(sheet.place(outwards.at(steps)), "light along x: 45°", colour);
    }
}

/// Describes the line under the pointer, if it is no worldline.
pub fn hover_text(sheet: &DiagramSheet<'_>, pointer: Pos2) -> Option<String> {
    let near = |line: StraightLine| sheet.nearest(line, pointer).1 < NEAR;
    let light = sheet.diagram.cones().and_then(|[cone, _]| light_text(sheet, &cone, pointer));
    if light.is_some() {
        return light;
    }
    let [ground, other] = sheet.diagram.nows();
    let told = |clocks: String| {
        format!("Everything that happens now, when the light is received, by {clocks} clocks.")
    };
    let named = [(other, whose(sheet)), (ground, "the ground's".to_owned())]
        .into_iter()
        .find(|(line, _)| near(*line));
    named.map(|(_, clocks)| told(clocks))
}

/// Describes the light under the pointer.
fn light_text(sheet: &DiagramSheet<'_>, cone: &PastCone, pointer: Pos2) -> Option<String> {
    let world = sheet.chart.world([pointer.x, pointer.y].map(f64::from));
    let near = |line: StraightLine| sheet.nearest(line, pointer).1 < NEAR;
    let off = sheet.place(Event { x: world[0], t: cone.time(world[0]) }).y - pointer.y;
    if off.abs() < NEAR {
        let distance = sheet.state.measures().length.text(cone.distance, 2);
        return Some(format!(
            "Past light cone: light that leaves here, {distance} beside the line of the eyes, arrives now.\n\
             Far away it runs along x, at 45 degrees: one unit of length in one of time. Near the eyes it takes its \
             time across."
        ));
    }
    let runs_along_x = cone.asymptotes().into_iter().any(near) && world[1] < cone.apex.t;
    runs_along_x.then(|| "Light that runs along x at 45 degrees, and arrives now.".to_owned())
}
