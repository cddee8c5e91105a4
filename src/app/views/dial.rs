//! The optical clock: a dial beside each followed point, whose hand turns with the proper time of what the
//! eye sees there. So it is seen to run D times as fast as a clock on the ground: fast as it comes, slow as
//! it goes. On a wheel it is a clock that turns with the point, and goes slower than those that rest in the
//! wheel's frame.

use std::f32::consts::TAU;

use eframe::egui::accesskit::Role;
use eframe::egui::{Align2, Color32, Pos2, Rect, Sense, Stroke, TextStyle, Ui, Vec2, WidgetInfo, pos2, vec2};

use crate::app::state::State;
use crate::app::state::points::Point;
use crate::eye::Eye;
use crate::number_text;
use crate::plot::round_step;
use crate::units::Unit;

/// A turn of the hand takes about this long, units of the scene: it can be followed with the eyes as it
/// comes.
const PERIOD: f64 = 2.0;
/// Least and largest radius of the face, points, and which part of the view's height it is in between.
const RADII: [f32; 2] = [9.5, 20.0];
const RADIUS_SHARE: f32 = 0.035;
/// From the middle of the marker to the nearest of the rim, points.
const AWAY: f32 = 15.0;
/// The steps by which a dial moves away from its marker to leave what moves there in sight, points, and how
/// many of them it takes at most, as a part of the view's height. Where all that way is taken it stays near.
const STEP_AWAY: f32 = 8.0;
const FARTHEST: f32 = 0.4;
/// Room below the resting clock for its count and a line of the view's own, points.
const BELOW_RESTING: f32 = 56.0;
/// Room between the dial and the edge of the view.
const MARGIN: f32 = 2.0;

/// A clock as an eye sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dial {
    /// Position of the hand: turns clockwise from the top, from 0 to below 1.
    pub turn: f64,
    /// The proper time that a turn of it takes, units of the scene.
    pub period: f64,
    /// The turns that the dial has made, where they are counted.
    pub count: Option<f64>,
}

impl Dial {
    /// Returns a dial that shows `time`, without a count of turns.
    fn showing(time: f64, period: f64) -> Self {
        Self { turn: (time / period).rem_euclid(1.0), period, count: None }
    }
}

/// Returns the duration of a turn: a round number of this `unit`. In units of the scene.
#[must_use]
pub fn period(unit: Unit) -> f64 {
    unit.in_scene(round_step(unit.shown(PERIOD)))
}

/// Returns the tooltip of a dial whose times are in this `unit`.
#[must_use]
pub fn tip(unit: Unit, is_turning: bool) -> String {
    let what = if is_turning {
        "a clock that turns with it, and so goes √(1 − v²) times as fast as the proper time τ of what the wheel is on"
    } else {
        "its proper time τ"
    };
    format!(
        "The clock at this point as the eye sees it: {what}. A turn of the hand is {}. It is seen to run at D: fast as it \
        comes, slow as it goes.",
        unit.text(period(unit), 0)
    )
}

impl State {
    /// The clock at `point` as `eye` sees it; none where no light is shown that it receives.
    #[must_use]
    pub fn dial(&self, point: &Point, eye: Eye) -> Option<Dial> {
        let is_on = self.document.settings.window.dials && self.shows_what_is_received(eye);
        let seen = self.sighting(point, eye).filter(|seen| is_on && seen.proper_time.is_finite())?;
        let period = period(self.measures().time);
        let slowed = self.slowed(point, seen.proper_time);
        let first = self.first_proper_time(point, eye)?;
        let count = slowed * (seen.proper_time - first) / period;
        Some(Dial {
            count: self.counts().then_some(count),
            ..Dial::showing(slowed * seen.proper_time, period)
        })
    }

    /// The clock that rests beside the eyes, which shows T; none where none is drawn, or no light is shown
    /// that `eye` receives.
    #[must_use]
    pub fn resting_dial(&self, eye: Eye) -> Option<Dial> {
        let is_on = self.document.settings.window.dials && self.counts() && self.shows_what_is_received(eye);
        let (period, time) = (period(self.measures().time), self.document.time);
        let count = (time - self.first_time().unwrap_or(0.0)) / period;
        is_on.then(|| Dial { count: Some(count), ..Dial::showing(time, period) })
    }

    /// Whether turns are counted, and a resting clock is there to compare them with.
    fn counts(&self) -> bool {
        self.document.settings.window.resting_clock
    }

    /// The time T at which the step of the lesson begins; `None` without one.
    fn first_time(&self) -> Option<f64> {
        self.lesson_settings().and_then(|settings| settings.time)
    }

    /// The proper time of `point` from which turns are counted.
    fn first_proper_time(&self, point: &Point, eye: Eye) -> Option<f64> {
        let Some(time) = self.first_time().filter(|_| self.counts()) else { return Some(0.0) };
        let both = self.document.settings.shown_disparity(&point.track, time).ok()?;
        let seen = [both.primary, both.secondary][eye.index()];
        seen.proper_time.is_finite().then_some(seen.proper_time)
    }
}

/// The place and colour of a dial beside a marker.
#[derive(Debug, Clone, Copy)]
pub struct DialPlacement {
    /// Position of the marker beside the dial.
    pub marker: Pos2,
    /// The view that contains the dial.
    pub view: Rect,
    /// Distance of the dial from the marker beyond the usual one, points.
    pub farther: f32,
    /// Colour of the dial's rim, and of the line from the marker.
    pub colour: Color32,
}

/// Draws `dial`, with its `name` for assistive technology and its `tip` for hovering.
pub fn show(ui: &Ui, dial: Dial, drawn: DialPlacement, name: &str, tip: String) {
    let (centre, radius) = face(drawn.marker, drawn.view, drawn.farther);
    let outwards = (centre - drawn.marker).normalized();
    let [near, far] = [drawn.marker + 7.0 * outwards, centre - radius * outwards];
    ui.painter().with_clip_rect(drawn.view).line_segment([near, far], Stroke::new(1.5, drawn.colour));
    paint(ui, dial, DialFace { centre, radius, view: drawn.view, colour: drawn.colour }, name, tip);
}

/// Draws the clock that rests beside the eyes at the lower edge of the `view` of `eye`, if it is shown.
pub fn show_resting(ui: &Ui, state: &State, eye: Eye, view: Rect) {
    const TIP: &str = "A clock that rests beside you, and shows T: nothing has to come from far for you to read it. Count its turns \
        against those of a clock that rides past.";
    let Some(dial) = state.resting_dial(eye) else { return };
    let name = format!("Clock beside you, {}", eye.name());
    let radius = radius(view);
    let centre = pos2(view.center().x, view.max.y - radius - BELOW_RESTING);
    let colour = ui.visuals().strong_text_color();
    paint(ui, dial, DialFace { centre, radius, view, colour }, &name, TIP.to_owned());
}

/// The face of a dial.
#[derive(Debug, Clone, Copy)]
struct DialFace {
    centre: Pos2,
    radius: f32,
    /// The view that contains the dial.
    view: Rect,
    /// Colour of the dial's rim.
    colour: Color32,
}

fn paint(ui: &Ui, dial: Dial, DialFace { centre, radius, view, colour }: DialFace, name: &str, tip: String) {
    let (painter, visuals) = (ui.painter().with_clip_rect(view), ui.visuals());
    let behind =
        if visuals.dark_mode { Color32::from_black_alpha(215) } else { Color32::from_white_alpha(235) };
    painter.circle(centre, radius, behind, Stroke::new(1.5, colour));
    for quarter in 0..4 {
        let direction = towards(f64::from(quarter) / 4.0);
        let ends = [0.72, 0.92].map(|part| centre + part * radius * direction);
        painter.line_segment(ends, Stroke::new(1.0, visuals.weak_text_color()));
    }
    let hand = Stroke::new(2.0, visuals.strong_text_color());
    painter.line_segment([centre, centre + 0.8 * radius * towards(dial.turn)], hand);
    let rect = Rect::from_center_size(centre, Vec2::splat(2.0 * radius));
    let response = ui.interact(rect.intersect(view), ui.scope_id().with(name), Sense::hover());
    let count = dial.count.map(|count| number_text::fixed(count, 2));
    let counted = count.as_ref().map_or_else(String::new, |count| format!(", {count} turns"));
    let turn = dial.turn + 0.0; // no minus before 0
    response.widget_info(|| {
        WidgetInfo::labeled(Role::Label, true, format!("{name}: {turn:.4} of a turn{counted}"))
    });
    if let Some(count) = count {
        let galley =
            painter.layout_no_wrap(count, TextStyle::Body.resolve(ui.style()), visuals.strong_text_color());
        let place = Align2::CENTER_TOP.anchor_size(centre + vec2(0.0, radius + 3.0), galley.size());
        painter.rect_filled(place.expand2(vec2(3.0, 0.0)), 3.0, behind);
        painter.galley(place.min, galley, visuals.strong_text_color());
    }
    response.on_hover_text(tip);
}

/// From the middle to where the hand points after this part of a turn.
fn towards(turn: f64) -> Vec2 {
    Vec2::angled((turn as f32 - 0.25) * TAU)
}

/// The radius of a face in the `view`.
fn radius(view: Rect) -> f32 {
    (RADIUS_SHARE * view.height()).clamp(RADII[0], RADII[1])
}

/// Middle and radius of the face beside a `marker`, this much `farther` away than usual: above it to the
/// right, else where there is room in the `view`.
fn face(marker: Pos2, view: Rect, farther: f32) -> (Pos2, f32) {
    let radius = radius(view);
    let (room, near) = (view.shrink(radius + MARGIN), AWAY + radius);
    let part = std::f32::consts::FRAC_1_SQRT_2;
    let x = if marker.x + part * near > room.max.x { -part } else { part };
    let y = if marker.y - part * near < room.min.y { part } else { -part };
    (marker + (near + farther) * vec2(x, y), radius)
}

/// Returns the distance from its `marker`, beyond the usual one, at which a dial in the `view` covers no
/// place that `is_taken`, points.
#[must_use]
pub fn farther(marker: Pos2, view: Rect, is_taken: impl Fn(Pos2) -> bool) -> f32 {
    let room = view.shrink(radius(view) + MARGIN);
    let covers = |&away: &f32| {
        let (centre, radius) = face(marker, view, away);
        let rim = (0..8).map(|eighth| centre + radius * towards(f64::from(eighth) / 8.0));
        std::iter::once(centre).chain(rim).any(&is_taken)
    };
    let steps = (FARTHEST * view.height() / STEP_AWAY) as u16;
    let ways = (0..=steps).map(|step| STEP_AWAY * f32::from(step));
    let mut within = ways.take_while(|&away| away == 0.0 || room.contains(face(marker, view, away).0));
    within.find(|away| !covers(away)).unwrap_or(0.0)
}

/// The place of the dial beside a `marker` in the `view`, this much `farther` away than usual.
#[must_use]
pub fn place(marker: Pos2, view: Rect, farther: f32) -> Rect {
    let (centre, radius) = face(marker, view, farther);
    Rect::from_center_size(centre, Vec2::splat(2.0 * radius))
}

#[cfg(test)]
mod tests {
    use relativity_render::Geometry;

    use super::*;
    use crate::flags::{SpeedParameter, SpeedSetting};
    use crate::settings::Settings;
    use crate::units::Units;

    fn cyclist(time: f64, units: Units) -> State {
        let mut settings = Settings { scene: "cyclist".to_owned(), time: Some(time), ..Settings::default() };
        settings.window.units = units;
        State::open(settings).expect("a preset")
    }

    fn dial(state: &State, eye: Eye) -> Dial {
        state.dial(state.document.points.selected(), eye).expect("it is seen")
    }

    /// Returns the time of a clock at (0, 3, 2) of what moves at 0.9 as light leaves it that arrives at (a,
    /// 0, 0) at T: in its own frame, where it rests, that arrives later by its distance from there.
    fn proper_time(a: f64, time: f64) -> f64 {
        let gamma = 1.0 / 0.19_f64.sqrt();
        let [received, x] = [gamma * (time - 0.9 * a), gamma * (a - 0.9 * time)];
        received - (x * x + 13.0).sqrt()
    }

    #[test]
    fn the_hand_is_at_the_proper_time_of_what_is_seen() {
        for (units, period) in
            [(Units::Natural, 2.0), (Units::Metric, 5.0 * 0.299_792_458 / 0.65), (Units::Town, 0.2 / 0.078)]
        {
            for time in [-20.0, -1.3, 0.0, 3.7, 55.5] {
                for (eye, a) in Eye::BOTH.into_iter().zip([-0.05, 0.05]) {
                    let Dial { turn, period: shown, .. } = dial(&cyclist(time, units), eye);
                    assert!((shown - period).abs() < 1e-9, "{units:?}: {shown} for {period}");
                    let expected = (proper_time(a, time) / period).rem_euclid(1.0);
                    let off = (turn - expected + 0.5).rem_euclid(1.0) - 0.5;
                    assert!(off.abs() < 1e-8, "{units:?}, T = {time}: {turn} for {expected}");
                }
            }
        }
    }

    #[test]
    fn the_hand_is_seen_to_run_at_d() {
        const STEP: f64 = 1e-4;
        for time in [-20.0, -1.3, 0.0, 3.7, 55.5] {
            for eye in Eye::BOTH {
                let turn = |time| {
                    let dial = dial(&cyclist(time, Units::Natural), eye);
                    dial.turn * dial.period
                };
                let turned = (turn(time + STEP) - turn(time - STEP) + 1.0).rem_euclid(2.0) - 1.0;
                let state = cyclist(time, Units::Natural);
                let seen = state.sighting(state.document.points.selected(), eye).expect("it is seen");
                let rate = turned / (2.0 * STEP);
                assert!((rate / seen.doppler_factor - 1.0).abs() < 1e-6, "T = {time}: {rate}");
            }
        }
    }

    /// Also that of a point of a wheel, whose D has its own motion in it.
    #[test]
    fn the_hand_of_a_clock_on_a_rolling_wheel_is_seen_to_run_at_d() {
        const STEP: f64 = 1e-5;
        let mut settings = Settings { scene: "street".to_owned(), time: Some(0.0), ..Settings::default() };
        settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, 0.8).expect("a speed");
        let mut state = State::open(settings).expect("a preset");
        let is_tyre = |name: &String| name == "front tyre";
        let tyre = state.document.scene.names.iter().position(is_tyre).expect("a bicycle has one");
        let track = state.document.scene.track_on(tyre).expect("a body");
        assert!(track.spin.is_some());
        state.document.points.choose(track, tyre, false);
        for time in [-8.0, -1.3, 0.0, 3.7, 9.5] {
            for eye in Eye::BOTH {
                let mut hand = |time| {
                    state.document.time = time;
                    let dial = dial(&state, eye);
                    dial.turn * dial.period
                };
                let turned = (hand(time + STEP) - hand(time - STEP) + 1.0).rem_euclid(2.0) - 1.0;
                state.document.time = time;
                let seen = state.sighting(state.document.points.selected(), eye).expect("it is seen");
                let rate = turned / (2.0 * STEP);
                assert!((rate / seen.doppler_factor - 1.0).abs() < 1e-5, "T = {time}: {rate}");
            }
        }
    }

    /// Without a lesson turns are counted from each clock's zero: so that of the front is the proper time
    /// over the period, of which the hand shows the rest; and the resting clock shows T.
    #[test]
    fn turns_are_counted_where_a_resting_clock_is_drawn() {
        for time in [-20.0, 0.0, 3.7, 55.5] {
            let mut state = cyclist(time, Units::Natural);
            assert_eq!((dial(&state, Eye::Left).count, state.resting_dial(Eye::Left)), (None, None));
            state.document.settings.window.resting_clock = true;
            for (eye, a) in Eye::BOTH.into_iter().zip([-0.05, 0.05]) {
                let Dial { turn, count, .. } = dial(&state, eye);
                let count = count.expect("it is counted");
                assert!((count - proper_time(a, time) / 2.0).abs() < 1e-8, "T = {time}: {count}");
                assert!((count.rem_euclid(1.0) - turn).abs() < 1e-9);
                let resting = state.resting_dial(eye).expect("it is drawn");
                assert_eq!(resting.count, Some(time / 2.0));
            }
            state.document.settings.window.dials = false;
            assert_eq!(state.resting_dial(Eye::Left), None);
        }
    }

    #[test]
    fn only_what_is_received_has_a_clock() {
        for (geometry, shown) in [
            (Geometry::Seen, [true, true]),
            (Geometry::Published, [true, false]),
            (Geometry::Contracted, [false, false]),
            (Geometry::Rest, [false, false]),
        ] {
            let mut state = cyclist(1.0, Units::Natural);
            state.document.settings.look.geometry = geometry;
            let dials = Eye::BOTH.map(|eye| state.dial(state.document.points.selected(), eye).is_some());
            assert_eq!(dials, shown, "{geometry:?}");
            state.document.settings.window.dials = false;
            assert_eq!(state.dial(state.document.points.selected(), Eye::Left), None);
        }
    }

    #[test]
    fn a_dial_stays_in_the_view_and_off_its_marker() {
        let view = Rect::from_min_max(pos2(0.0, 0.0), pos2(300.0, 200.0));
        for marker in [[150.0, 100.0], [3.0, 3.0], [297.0, 3.0], [3.0, 197.0], [297.0, 197.0]].map(Pos2::from)
        {
            let (centre, radius) = face(marker, view, 0.0);
            assert!(
                view.contains_rect(Rect::from_center_size(centre, Vec2::splat(2.0 * radius))),
                "{marker}"
            );
            // 6 is the radius of the marker of the selected point.
            assert!(centre.distance(marker) > radius + 6.0 + 3.0, "{marker}");
        }
    }

    /// The dial covers nothing of a disc of 40 points around the marker, and stays near where all of the view
    /// is taken.
    #[test]
    fn a_dial_leaves_what_moves_in_sight() {
        let view = Rect::from_min_max(pos2(0.0, 0.0), pos2(300.0, 200.0));
        let marker = pos2(150.0, 120.0);
        let away = farther(marker, view, |place| place.distance(marker) < 40.0);
        let (centre, radius) = face(marker, view, away);
        let gap = centre.distance(marker) - radius - 40.0;
        assert!((0.0..STEP_AWAY).contains(&gap), "{gap}");
        assert!(view.contains_rect(place(marker, view, away)));
        assert_eq!(farther(marker, view, |_| true).to_bits(), 0.0_f32.to_bits());
        assert_eq!(farther(marker, view, |_| false).to_bits(), 0.0_f32.to_bits());
    }
}
