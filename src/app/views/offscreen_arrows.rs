//! Arrows at the edge of a view to things beyond it, each with a name and the side where it is.

use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, TextStyle, Ui, Vec2, Visuals, vec2};
use glam::DVec3;
use relativity_core::math;
use relativity_render::{Camera, Motion};

use crate::app::state::State;
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::plot::LabelPlaces;

/// Something out of a view.
#[derive(Debug, Clone, PartialEq)]
pub struct OffscreenArrow {
    /// Name of the thing.
    pub name: String,
    /// Side on which the thing is, as one looks.
    pub side: Side,
    /// Unit vector in the picture, right and down.
    pub towards: Vec2,
    /// Number of the followed point, if it is one.
    pub point: Option<usize>,
}

/// A side of whoever looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// To the left of the picture.
    Left,
    /// To the right of the picture.
    Right,
    /// Above the picture's upper edge.
    Above,
    /// Below the picture's lower edge.
    Below,
    /// Behind, by more than 45 degrees from either side.
    Behind,
}

impl Side {
    /// The side on which something is that is this far to the right, up and ahead, out of a picture that is
    /// this many times as high as wide.
    fn new([right, up, ahead]: [f64; 3], aspect: f64) -> Self {
        // Ahead, it is beyond the edge of the picture that it is further out of.
        let level = if ahead > 0.0 { aspect * right.abs() } else { math::hypot(right, ahead) };
        match () {
            () if up.abs() > level => {
                if up > 0.0 {
                    Self::Above
                } else {
                    Self::Below
                }
            }
            () if -ahead > right.abs() => Self::Behind,
            () if right > 0.0 => Self::Right,
            () => Self::Left,
        }
    }

    /// Returns the side in words.
    const fn text(self) -> &'static str {
        match self {
            Self::Left => "to your left",
            Self::Right => "to your right",
            Self::Above => "above you",
            Self::Below => "below you",
            Self::Behind => "behind you",
        }
    }
}

impl OffscreenArrow {
    /// Returns the arrow to something along `direction` (any length above 0).
    fn new(name: String, camera: &Camera, direction: DVec3, point: Option<usize>) -> Self {
        let axes = camera.axes();
        let [width, height] = camera.size.map(f64::from);
        let middle = camera.line_of_sight([0.5 * width, 0.5 * height]);
        let conformal_place = camera.pixel(direction).filter(|_| camera.projection.is_conformal());
        let [right, up] = if let Some([x, y]) = conformal_place {
            [x - 0.5 * width, 0.5 * height - y]
        } else {
            // From where the middle's line of sight is as far in front of the eye, or behind it, on a plane
            // like the picture.
            let off = direction - middle * (direction.dot(axes.forward) / middle.dot(axes.forward));
            [axes.right, axes.up].map(|axis| off.dot(axis))
        };
        // What is right behind is as near on either side.
        let towards = DVec3::new(right, -up, 0.0).try_normalize().unwrap_or(DVec3::X);
        let side = Side::new([axes.right, axes.up, middle].map(|axis| direction.dot(axis)), height / width);
        Self { name, side, towards: vec2(towards.x as f32, towards.y as f32), point }
    }

    /// Returns the arrow in words.
    #[must_use]
    pub fn text(&self) -> String {
        format!("{}, {}", self.name, self.side.text())
    }
}

impl State {
    /// Returns the arrows to what is out of the view of `eye`, `size` in pixels: everything that moves, or
    /// else the selected point.
    #[must_use]
    pub fn offscreen_arrows(&self, eye: Eye, size: [u32; 2]) -> Vec<OffscreenArrow> {
        let camera = self.view(eye, size).camera;
        let scene = self.subject_arrow(&camera);
        let point = self.document.points.selected();
        let has_arrow = scene.is_some() && point.track.motion == Motion::Scene;
        let point = self
            .direction(point, eye)
            .filter(|&direction| !has_arrow && !camera.shows(direction))
            .map(|direction| {
                let name = self.name_of(point);
                OffscreenArrow::new(name, &camera, direction, Some(point.number))
            });
        scene.into_iter().chain(point).collect()
    }

    fn subject_arrow(&self, camera: &Camera) -> Option<OffscreenArrow> {
        if !self.outline().is_out_of(camera) {
            return None;
        }
        let framing = self.framing()?;
        let first = self.document.prepared.subject().next()?.bodies.start;
        let group = self.document.prepared.group_of(first);
        let name = self.document.scene.name_of_group(group)?.to_owned();
        Some(OffscreenArrow::new(name, camera, framing.gaze.axes().forward, None))
    }
}

/// Length of an arrow, and its distance from the view's edge, points.
const ARROW: f32 = 11.0;
const INSET: f32 = 7.0;

/// Draws an arrow at the edge of `rect`, where a view is, for each of `all`; their names cover nothing of
/// what is `covered` already, if they can.
pub fn paint(ui: &Ui, painter: &Painter, rect: Rect, all: &[OffscreenArrow], covered: &[Rect]) {
    let mut labels = LabelPlaces::new(rect, 1.0);
    covered.iter().filter(|area| area.is_positive()).for_each(|area| labels.keep_free(*area));
    for beyond in all {
        let towards = beyond.towards;
        let tip = edge_of(rect.shrink(INSET), towards);
        let (back, aside) = (tip - towards * ARROW, towards.rot90() * (0.6 * ARROW));
        let colour =
            beyond.point.map_or(Color32::WHITE, |number| theme::point_colour(number, &Visuals::dark()));
        let arrow = vec![tip, back + aside, back - aside];
        painter.add(Shape::convex_polygon(arrow, colour, Stroke::new(1.5, Color32::from_black_alpha(200))));
        label(ui, painter, rect, (beyond, tip), &mut labels);
    }
}

/// Names the arrow with this `tip`, above or below where its name would cover another's.
fn label(
    ui: &Ui,
    painter: &Painter,
    rect: Rect,
    (beyond, tip): (&OffscreenArrow, Pos2),
    labels: &mut LabelPlaces,
) {
    let font = TextStyle::Small.resolve(ui.style());
    let galley = painter.layout_no_wrap(beyond.text(), font, Color32::WHITE);
    let half = 0.5 * galley.size() + vec2(5.0, 2.0);
    // Straight inwards from the edge that the arrow is at.
    let is_aside = (tip.x - rect.center().x).abs() > 0.5 * rect.width() - INSET - 1.0;
    let inwards =
        if is_aside { vec2(beyond.towards.x, 0.0) } else { vec2(0.0, beyond.towards.y) }.normalized();
    let centre = tip - inwards * (ARROW + 5.0 + (half * inwards).length());
    let room = rect.shrink2(half + Vec2::splat(2.0));
    let backs = [0.0, -1.0, 1.0, -2.0, 2.0].map(|rows| {
        let centre = centre + vec2(0.0, rows * 2.0 * (half.y + 1.0));
        Rect::from_center_size(centre.clamp(room.min, room.max.max(room.min)), 2.0 * half)
    });
    let Some(back) = labels.take(backs).map(Rect::from) else { return };
    painter.rect_filled(back, 3.0, Color32::from_black_alpha(170));
    painter.galley(back.min + vec2(5.0, 2.0), galley, Color32::WHITE);
}

/// Returns the place where the way from the middle of `rect` `towards` somewhere leaves it.
fn edge_of(rect: Rect, towards: Vec2) -> Pos2 {
    let half = 0.5 * rect.size();
    let reach = |half: f32, part: f32| if part == 0.0 { f32::INFINITY } else { half / part.abs() };
    rect.center() + towards * reach(half.x, towards.x).min(reach(half.y, towards.y))
}

#[cfg(test)]
mod tests {
    use eframe::egui::pos2;

    use super::*;
    use crate::flags::FieldOfView;
    use crate::flags::choices::{GazeChoice, ProjectionChoice};
    use crate::settings::Settings;

    const SIZE: [u32; 2] = [480, 360];

    /// The cyclist at this T, seen with this gaze, 40 degrees wide.
    fn looking(gaze: [f64; 2], time: f64) -> State {
        let mut settings = Settings { scene: "cyclist".to_owned(), time: Some(time), ..Settings::default() };
        settings.look.gaze = GazeChoice::Fixed(gaze);
        settings.look.fov = FieldOfView(Some(40.0));
        State::open(settings).expect("a preset")
    }

    #[test]
    fn what_the_start_shows_needs_no_arrow() {
        let state = State::open(Settings::default()).expect("the start");
        assert_eq!(Eye::BOTH.map(|eye| state.offscreen_arrows(eye, SIZE)), [vec![], vec![]]);
    }

    #[test]
    fn an_arrow_names_what_it_points_to_and_its_side() {
        for (turned, side) in [
            (40.0, "to your right"),
            (-70.0, "to your left"),
            (100.0, "to your right"),
            (-125.0, "to your left"),
            (150.0, "behind you"),
            (-170.0, "behind you"),
        ] {
            let mut state = looking([90.0, 0.0], 1.1);
            // Across the gaze, so that an angle about the vertical is one from the middle.
            state.document.settings.look.projection = ProjectionChoice::Gaze;
            let whole = {
                state.document.settings.look.gaze = GazeChoice::Whole;
                state.gaze()
            };
            let azimuth = whole.azimuth.to_degrees() + turned;
            state.document.settings.look.gaze = GazeChoice::Fixed([azimuth, 0.0]);
            let [beyond] = state.offscreen_arrows(Eye::Left, SIZE).try_into().expect("one arrow");
            // Turned to the left it lies to the right.
            assert_eq!(beyond.towards.x > 0.0, turned > 0.0, "{beyond:?}");
            assert_eq!((beyond.text(), beyond.point), (format!("Gamow's cyclist, {side}"), None));
        }
    }

    #[test]
    fn what_is_above_or_below_is_said_to_be_there() {
        for (place, side) in [
            ([0.1, 0.9, 0.4], Side::Above),
            ([0.1, -0.9, 0.4], Side::Below),
            ([0.1, 0.9, -0.4], Side::Above),
            ([-0.6, 0.5, 0.6], Side::Left),
            ([0.3, 0.4, -0.8], Side::Behind),
            ([0.8, 0.4, -0.3], Side::Right),
        ] {
            assert_eq!(Side::new(place, 1.0), side, "{place:?}");
        }
        // Out of a low picture at its upper edge, out of an upright one at its right edge.
        assert_eq!([0.3, 2.0].map(|aspect| Side::new([0.5, 0.4, 0.7], aspect)), [Side::Above, Side::Right]);
    }

    #[test]
    fn a_cyclist_on_a_street_and_a_riding_rod_have_their_own_names() {
        for (scene, name) in [("street", "cyclist"), ("twins", "riding rod"), ("cube", "die")] {
            let mut settings = Settings { scene: scene.to_owned(), time: Some(0.0), ..Settings::default() };
            settings.look.fov = FieldOfView(Some(40.0));
            let mut state = State::open(settings).expect("a preset");
            let azimuth = state.gaze().azimuth.to_degrees() + 180.0;
            state.document.settings.look.gaze = GazeChoice::Fixed([azimuth, 0.0]);
            let arrows = state.offscreen_arrows(Eye::Left, SIZE);
            assert_eq!(arrows[0].text(), format!("{name}, behind you"));
        }
    }

    #[test]
    fn a_selected_point_that_is_cut_off_has_an_arrow_of_its_own() {
        let mut state = looking([90.0, 0.0], 1.1);
        state.document.settings.look.gaze = GazeChoice::Whole;
        state.document.settings.look.fov = FieldOfView(Some(8.0));
        let [beyond] = state.offscreen_arrows(Eye::Left, SIZE).try_into().expect("one arrow");
        assert_eq!(beyond.point, Some(1));
        assert!(beyond.text().starts_with("front tyre, "), "{}", beyond.text());
    }

    #[test]
    fn arrows_stand_at_the_edge() {
        let rect = Rect::from_min_max(pos2(10.0, 20.0), pos2(110.0, 80.0));
        assert_eq!(edge_of(rect, vec2(1.0, 0.0)), pos2(110.0, 50.0));
        assert_eq!(edge_of(rect, vec2(0.0, -1.0)), pos2(60.0, 20.0));
        let aslant = edge_of(rect, vec2(-0.6, 0.8));
        assert!((aslant - pos2(37.5, 80.0)).length() < 1e-4, "{aslant:?}");
    }
}
