//! The hover label of a view: the body's name, where it is seen, its three times, and D.

use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Color32, Pos2, Rect, Sense, TextStyle, Ui, Vec2, WidgetInfo, pos2, vec2};
use relativity_core::{Conformal, Sighting};
use relativity_render::Geometry;

use crate::app::state::State;
use crate::app::tools::{awake, clock};
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::flags::choices::ProjectionChoice;
use crate::number_text;

/// From the pointer to the tag, and around its words; points.
const AWAY: Vec2 = vec2(16.0, 14.0);
const MARGIN: Vec2 = vec2(7.0, 5.0);
/// From a finger up to the tag, points.
const FINGER: f32 = 40.0;

/// The thing under the pointer.
#[derive(Debug, Clone, PartialEq)]
pub struct Hovered {
    /// Number of the body.
    pub body: usize,
    /// Place in the picture, at the pointer or very near.
    pub pixel: [f64; 2],
    /// Name of the body.
    pub name: String,
    /// Doppler factor of the light of it that is received, where that is shown.
    pub doppler_factor: Option<f64>,
    /// Remarks on the point under the pointer: a line each.
    pub lines: Vec<String>,
}

impl Hovered {
    /// Returns the name of the body, with the shift of its light.
    #[must_use]
    pub fn title(&self) -> String {
        let shift = self.doppler_factor.map(|factor| format!("   D = {}", number_text::fixed(factor, 3)));
        format!("{}{}", self.name, shift.unwrap_or_default())
    }
}

impl State {
    /// Returns the thing at a `pixel` of the picture of `eye`, which has this `size`, or very near; `None`
    /// where nothing is, and where no ray leads to it.
    #[must_use]
    pub fn hovered(&self, eye: Eye, pixel: [f64; 2], size: [u32; 2]) -> Option<Hovered> {
        let pixel = self.meant(eye, pixel, size)?;
        let (track, body) = self.point_at(eye, pixel, size)?;
        let name = self.document.scene.name_of(body).to_owned();
        let view = self.view(eye, size);
        let (doppler_factor, mut lines) = match self.document.settings.geometry() {
            Geometry::Rest => {
                let there = view.of_group(track.motion).place_when_shown(track.point());
                let is = if track.spin.is_some() { "seen from its frame" } else { "at rest" };
                let place = self.place(self.document.settings.rest_place(there.to_array()));
                (None, vec![format!("{is} at {place}")])
            }
            Geometry::Contracted => {
                let place = self.place(self.document.settings.measured_place(&track, self.document.time));
                (None, vec![format!("measured now at {place}")])
            }
            Geometry::Seen | Geometry::Published | Geometry::OneCone => {
                let both = self.document.settings.disparity(&track, self.document.time).ok()?;
                let seen = [both.primary, both.secondary][eye.index()];
                (Some(seen.doppler_factor), self.received(&seen))
            }
        };
        lines.extend(self.wheel_texts(&track, &view));
        Some(Hovered { body, pixel, name, doppler_factor, lines })
    }

    /// Returns the place where a point is seen that an eye receives light of, and its times.
    fn received(&self, seen: &Sighting) -> Vec<String> {
        let at = format!("seen at {}", self.place(seen.position));
        let times = [self.document.time, seen.retarded_time, seen.proper_time];
        [at].into_iter()
            .chain(self.conformal(seen))
            .chain(self.clock().texts(times, self.measures().time, 2))
            .collect()
    }

    /// The coordinates in a conformal picture of what is seen; none in another picture, and along the line
    /// between the eyes.
    fn conformal(&self, seen: &Sighting) -> Option<String> {
        let is_conformal = self.document.settings.projection() == ProjectionChoice::Mercator;
        let axes = self.document.settings.baseline_at(self.document.time).axes();
        let Conformal { u, v } = axes.conformal(seen.position).filter(|_| is_conformal)?;
        Some(format!("u = {}, v = {} rad", number_text::fixed(u, 3), number_text::fixed(v, 3)))
    }

    /// A place in words.
    fn place(&self, place: [f64; 3]) -> String {
        let unit = self.measures().length;
        let [x, y, z] = place.map(|value| unit.number(value, 2));
        format!("({x}, {y}, {z}){}", unit.suffix())
    }

    /// Whether T runs so slowly that numbers can be read: a step of the scrubber takes a second or more.
    #[must_use]
    pub fn is_legible(&self) -> bool {
        !self.scratch.playing || self.document.settings.playback.rate <= clock::step_size(self.time_range())
    }
}

/// Returns the pointer's position in the view at `rect` while its hover label may show: not during a drag
/// (unless it is of a finger that rests), while the pointer is out of use, or while T runs fast.
#[must_use]
pub fn pointer(ui: &Ui, state: &State, rect: Rect) -> Option<Pos2> {
    // A pointer elsewhere has no label that a later frame would have to take away.
    let pointer = ui.ctx().pointer_hover_pos().filter(|_| ui.rect_contains_pointer(rect))?;
    let is_used = awake::is_moved(ui.ctx()) || awake::is_opened(ui.ctx());
    let is_free = is_used && !ui.input(|input| input.pointer.any_down()) || awake::is_held(ui.ctx());
    (is_free && state.is_legible()).then_some(pointer)
}

/// Writes what is `hovered` beside the `pointer`, inside `view`: its name and D, and the rest once it was
/// clicked. Assistive technology has all of it.
pub fn show(ui: &Ui, view: Rect, pointer: Pos2, hovered: &Hovered) {
    let name = format!("Under the pointer: {}; {}", hovered.title(), hovered.lines.join("; "));
    let lines = if awake::is_opened(ui.ctx()) { hovered.lines.as_slice() } else { &[] };
    tag(ui, view, pointer, &hovered.title(), lines, &name);
}

/// Says at `place` in `view` that nothing is there that could be followed.
pub fn show_nothing(ui: &Ui, view: Rect, place: Pos2) {
    tag(ui, view, place, NOTHING, &[], NOTHING);
}

/// Remark where a click hit nothing.
const NOTHING: &str = "Nothing here to follow.";

/// Writes `title`, and below it `lines`, beside a `place` in `view`; `name` is for assistive technology.
fn tag(ui: &Ui, view: Rect, place: Pos2, title: &str, lines: &[String], name: &str) {
    let font = TextStyle::Small.resolve(ui.style());
    let format = |colour| TextFormat::simple(font.clone(), colour);
    let mut job = LayoutJob::default();
    job.append(title, 0.0, format(Color32::WHITE));
    for line in lines {
        job.append(&format!("\n{line}"), 0.0, format(theme::TAG_TEXT));
    }
    let galley = ui.painter().layout_job(job);
    let size = galley.size() + 2.0 * MARGIN;
    // A finger hides what is below it.
    let above = if ui.input(eframe::egui::InputState::any_touches) { size.y + FINGER } else { 0.0 };
    let rect = beside(place - vec2(0.0, above), size, view);
    let painter = ui.painter().with_clip_rect(view);
    painter.rect_filled(rect, 4.0, Color32::from_black_alpha(185));
    painter.galley(rect.min + MARGIN, galley, Color32::WHITE);
    let response =
        ui.interact(rect.intersect(view), ui.scope_id().with(("tag", name == NOTHING)), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, name));
}

/// Returns the place of a tag of this `size`: below the pointer to the right, else where there is room in the
/// `view`.
fn beside(pointer: Pos2, size: Vec2, view: Rect) -> Rect {
    let along = |at: f32, away: f32, size: f32, [from, to]: [f32; 2]| {
        let start = if at + away + size > to { at - away - size } else { at + away };
        start.min(to - size).max(from)
    };
    let x = along(pointer.x, AWAY.x, size.x, [view.min.x, view.max.x]);
    let y = along(pointer.y, AWAY.y, size.y, [view.min.y, view.max.y]);
    Rect::from_min_size(pos2(x, y), size)
}
