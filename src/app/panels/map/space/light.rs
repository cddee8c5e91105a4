//! Light of the selected point on its way to the eyes: the rays that arrive at T, the fronts that they belong
//! to, and fronts of light that left at regular times, which grow while time runs.

use std::f32::consts::PI;

use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Ui, Vec2};
use glam::DVec3;
use relativity_core::{Event, math};

use super::sheet::{SheetPainter, SpaceSheet};
use crate::app::panels::map::times::{labelled, times};
use crate::app::state::State;
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::map::{Front, MapProjection, PointWorldline, ReceivedRay, along, fronts, rays};
use crate::plot::round_step;
use crate::quantity::Quantity;
use crate::settings::MapFrame;

/// Fronts that follow each other while light comes from where the point passes.
const FRONTS_ON_THE_WAY: f64 = 3.0;
/// Distance up to which the pointer counts as near, points.
const NEAR: f32 = 5.0;
/// Shortest ray that has room for text beside it, points, and the part of it where that is.
const SHORTEST_NAMED: f32 = 80.0;
const NAMED_AT: f32 = 0.35;
/// The narrowest plan in which a front is named, points, and where on it: turned from where it is furthest
/// from the eyes.
const NARROWEST_NAMED: f32 = 500.0;
const TURNS: [f32; 7] = [0.0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2];
/// Radius of the largest circle that is drawn, points.
const LARGEST: f32 = 1e6;
/// Greatest distance of a drawn circle from a round one, points.
const TOLERANCE: f32 = 0.1;
/// Length of the arrow on a ray, points.
const ARROW: f32 = 8.0;

/// The light of the selected point on a chart.
pub(super) struct ChartLight<'a> {
    sheet: &'a SpaceSheet,
    worldline: PointWorldline,
    rays: [ReceivedRay; 2],
    /// The present by the clocks of the frame that is drawn.
    now: f64,
    /// The middle between the eyes on the ground.
    here: DVec3,
}

impl<'a> ChartLight<'a> {
    /// Returns the light at the present T; `None` outside the domain of the core, and in the frame of who
    /// rides.
    pub(super) fn new(state: &State, sheet: &'a SpaceSheet) -> Option<Self> {
        let (settings, time) = (&state.document.settings, state.document.time);
        let (track, frame) = (state.document.points.selected().track, settings.frame(time));
        if settings.map_frame() == MapFrame::Rider {
            return None;
        }
        let observer = settings.rider(time).observer();
        let here = observer.place.into();
        Some(Self {
            sheet,
            worldline: PointWorldline::new(settings, &track, frame),
            rays: rays(settings, &track, time, frame).ok()?,
            now: frame.event_at(observer.place, observer.time).t,
            here,
        })
    }

    /// Draws the light on its way to the eyes.
    pub(super) fn paint(&self, ui: &Ui, painter: &Painter, state: &State) {
        let faint = ui.visuals().weak_text_color().gamma_multiply(0.28);
        for front in self.fronts(state) {
            self.paint_front(painter, &front, Stroke::new(1.0, faint));
        }
        for (eye, ray) in Eye::BOTH.into_iter().zip(self.rays) {
            let colour = theme::eye_colour(eye, ui.visuals());
            self.paint_front(painter, &ray.front(), Stroke::new(1.0, colour.gamma_multiply(0.7)));
            self.paint_ray(painter, &ray, colour);
        }
    }

    /// Names it in the plan.
    pub(super) fn name(&self, on: &mut SheetPainter<'_>) {
        if self.sheet.projection == MapProjection::Plan {
            // Words before numbers.
            if !on.state.document.settings.window.simple {
                self.name_way(on);
            }
            self.name_front(on);
        }
    }

    /// Writes beside the way of the light when it left: by the ground's clocks, or by those of the bicycle.
    fn name_way(&self, on: &mut SheetPainter<'_>) {
        let SheetPainter { ui, state, labels, .. } = on;
        let ways = self.rays.map(|ray| self.ends(&ray));
        for way in &ways {
            labels.places.avoid(way, 1.0);
        }
        let (name, times) = match state.document.settings.map.frame {
            MapFrame::Ground | MapFrame::Rider => {
                (Quantity::EmissionTime.row().name, self.rays.map(|ray| ray.happened))
            }
            MapFrame::Bicycle => (Quantity::ProperTime.row().name, self.rays.map(|ray| ray.proper_time)),
        };
        let [left, right] = times.map(|time| labelled(state, time));
        let both = if left == right { left } else { format!("{left}, {right}") };
        let text = format!("{name} {both}{}", state.measures().time.suffix());
        let [[from, to], _] = ways;
        let middle = from.lerp(to, NAMED_AT);
        if from.distance(to) > SHORTEST_NAMED && self.sheet.room().contains(middle) {
            labels.write((middle, ARROW), &text, ui.visuals().text_color());
        }
    }

    /// Says what the circles are, where there is room, on the side of the light's front that is away from the
    /// eyes.
    fn name_front(&self, on: &mut SheetPainter<'_>) {
        let SheetPainter { ui, labels, .. } = on;
        let room = self.sheet.room();
        let [ray, _] = self.rays;
        let Some((middle, radius)) = self.circle(&ray.front()).filter(|_| room.width() > NARROWEST_NAMED)
        else {
            return;
        };
        let away = middle - self.ends(&ray)[1];
        let places = TURNS.map(|turn| middle + radius * Vec2::angled(away.angle() + turn));
        if let Some(place) = places.into_iter().find(|place| room.shrink(20.0).contains(*place)) {
            let colour = theme::eye_colour(Eye::Left, ui.visuals());
            labels.write((place, 2.0), "wave front", colour);
        }
    }

    /// Describes the light under the pointer.
    pub(super) fn hover_text(&self, state: &State, pointer: Pos2) -> Option<String> {
        let eyes = || Eye::BOTH.into_iter().zip(self.rays);
        let told = |what: &str, received: f64, front: &Front| {
            format!("{what}\n{}", times(state, [received, front.happened, front.proper_time]))
        };
        let now = state.document.time;
        if let Some((eye, ray)) = eyes().find(|(_, ray)| self.off_ray(ray, pointer) < NEAR) {
            let what = format!("Light that the {} receives now", eye.name().to_lowercase());
            return Some(told(&what, now, &ray.front()));
        }
        if let Some((eye, ray)) = eyes().find(|(_, ray)| self.off_front(&ray.front(), pointer) < NEAR) {
            let what = format!("Wave front of the light that reaches the {} now", eye.name().to_lowercase());
            return Some(told(&what, now, &ray.front()));
        }
        let front = self.fronts(state).find(|front| self.off_front(front, pointer) < NEAR)?;
        let every = state.measures().time.text(self.period(state), 3);
        let what = format!("Wave front of light that left at one of a series of times, {every} apart");
        Some(told(&what, self.worldline.received(&state.document.settings.ride, front.happened), &front))
    }

    /// The time from one front to the next, round in the unit that is shown.
    fn period(&self, state: &State) -> f64 {
        let unit = state.measures().time;
        let distance = self.worldline.distance().max(1.0);
        unit.in_scene(round_step(unit.shown(distance / FRONTS_ON_THE_WAY)))
    }

    fn fronts(&self, state: &State) -> impl Iterator<Item = Front> {
        fronts(&self.worldline, self.now, self.period(state))
    }

    /// Returns the place of an event with these y and z.
    fn place(&self, event: Event, [y, z]: [f64; 2]) -> Pos2 {
        self.sheet.on_screen(DVec3::new(event.x, y, z))
    }

    /// The circle in which a front meets the plane of the eyes, in which it reaches them: its middle, and its
    /// radius in points; `None` before it has come so far.
    fn circle(&self, front: &Front) -> Option<(Pos2, f32)> {
        let [y, z] = front.across;
        let from_plane = match self.sheet.projection {
            MapProjection::Plan => z - self.here.z,
            MapProjection::Side => y - self.here.y,
        };
        let radius = front.radius_in_plane(from_plane.abs())?;
        Some((self.place(front.left, [y, z]), (radius * self.sheet.chart.scale) as f32))
    }

    fn paint_front(&self, painter: &Painter, front: &Front, stroke: Stroke) {
        if let Some((middle, radius)) = self.circle(front).filter(|(_, radius)| *radius < LARGEST) {
            painter.line(arc(middle, radius, self.sheet.room()), stroke);
        }
    }

    fn off_front(&self, front: &Front, pointer: Pos2) -> f32 {
        self.circle(front).map_or(f32::INFINITY, |(middle, radius)| (middle.distance(pointer) - radius).abs())
    }

    /// Returns the ends of a ray: where the light left, and where it arrives.
    fn ends(&self, ray: &ReceivedRay) -> [Pos2; 2] {
        [self.place(ray.left, ray.across), self.place(ray.received, ray.eye)]
    }

    /// The way of the light, with an arrow in the middle.
    fn paint_ray(&self, painter: &Painter, ray: &ReceivedRay, colour: Color32) {
        let [from, to] = self.ends(ray);
        painter.line_segment([from, to], Stroke::new(1.2, colour));
        let along = (to - from).normalized();
        let tip = from.lerp(to, 0.5) + 0.5 * ARROW * along;
        let (back, aside) = (tip - ARROW * along, 0.4 * ARROW * along.rot90());
        let arrow = vec![tip, back + aside, back - aside];
        painter.add(Shape::convex_polygon(arrow, colour, Stroke::NONE));
    }

    fn off_ray(&self, ray: &ReceivedRay, pointer: Pos2) -> f32 {
        let [from, to] = self.ends(ray);
        let [from, to, pointer] = [from, to, pointer].map(|place| [place.x, place.y].map(f64::from));
        along(from, to, pointer).1 as f32
    }
}

/// Returns the part of a circle that may be seen in `room`, in pieces that are straight to a tenth of a
/// point.
fn arc(middle: Pos2, radius: f32, room: Rect) -> Vec<Pos2> {
    let towards = room.center() - middle;
    let corners = [room.left_top(), room.right_top(), room.left_bottom(), room.right_bottom()];
    let aside = corners.map(|corner| {
        let there = corner - middle;
        let [sine, cosine] = [towards.x * there.y - towards.y * there.x, towards.dot(there)];
        math::atan2(f64::from(sine), f64::from(cosine)) as f32
    });
    let half =
        if room.contains(middle) { PI } else { aside.into_iter().fold(0.0, |a: f32, b| a.max(b.abs())) };
    let piece = 2.0 * (2.0 * TOLERANCE / radius.max(TOLERANCE)).sqrt();
    let pieces = (2.0 * half / piece).ceil().max(1.0);
    let at =
        |i: u32| middle + radius * Vec2::angled(towards.angle() + half * (2.0 * i as f32 / pieces - 1.0));
    (0..=pieces as u32).map(at).collect()
}

#[cfg(test)]
mod tests {
    use eframe::egui::pos2;

    use super::*;

    #[test]
    fn an_arc_is_round_and_all_of_it_that_is_in_the_room() {
        let room = Rect::from_min_max(pos2(0.0, 0.0), pos2(400.0, 200.0));
        for (middle, radius) in
            [(pos2(100.0, 100.0), 80.0), (pos2(-50.0, 90.0), 300.0), (pos2(-20_000.0, 3000.0), 20_300.0)]
        {
            let arc = arc(middle, radius, room);
            assert!((2..400).contains(&arc.len()), "{}", arc.len());
            for pair in arc.windows(2) {
                let between = pair[0].lerp(pair[1], 0.5);
                assert!((between.distance(middle) - radius).abs() < 0.11, "{between:?}");
            }
            // Each place of the circle in the room is near a place of the arc.
            let all = (0..100_000).map(|i| middle + radius * Vec2::angled(i as f32 * 2.0 * PI / 1e5));
            let longest = 2.0 * (2.0 * TOLERANCE * radius).sqrt();
            for place in all.filter(|place| room.contains(*place)) {
                assert!(arc.iter().any(|there| there.distance(place) < longest), "{place:?}");
            }
        }
    }
}
