//! Comfort on a ride: an exposure that follows the speed without flashing, and a vignette while the head turns.
//!
//! Streaming at the edge of the field of view is what makes people ill, and it is darkened for as long as the head turns. The light that
//! rushes in with D^4 would flash at each push; the exposure meets it at a limited rate.

use eframe::egui::epaint::{Mesh, Vertex, WHITE_UV};
use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Vec2, vec2};
use relativity_core::math;

use crate::app::state::State;
use crate::flags::choices::GazeChoice;

/// The fastest change of an automatic exposure, factors of 2 per second.
const EV_PER_SECOND: f64 = 3.0;
/// Time for which the vignette stays after the last turn, and in which it comes and goes, seconds.
const HELD: f64 = 0.3;
const FADE: f64 = 0.25;
/// Radii of the vignette, parts of the half width and the half height: clear inside the first, dark outside the second.
const CLEAR: f32 = 0.55;
const DARK: f32 = 1.15;
/// How dark it gets, 0 to 1.
const DEPTH: f32 = 0.92;
/// Corners of the vignette's rings.
const CORNERS: u32 = 64;

/// What follows the ride from one frame of the window to the next.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Comfort {
    /// Automatic exposure that is shown, on its way to the one that the speed has.
    exposure_ev: Option<f64>,
    /// Gaze of the frame before.
    gaze: Option<GazeChoice>,
    /// Seconds for which the vignette is still held.
    held: f64,
    /// How far the vignette has come, 0 to 1.
    vignette: f64,
}

impl State {
    /// Lets exposure and vignette follow the ride for this many `seconds`; whether they are still on their way.
    pub(in crate::app) fn follow_for_comfort(&mut self, seconds: f64) -> bool {
        let settings = &self.document.settings;
        if !settings.ride.is_on() {
            self.scratch.comfort = Comfort::default();
            return false;
        }
        let Comfort { exposure_ev, gaze, held, vignette } = self.scratch.comfort;
        let target = settings.automatic_ev(&self.document.scene, self.document.time);
        let now = exposure_ev.unwrap_or(target);
        let exposure_ev = towards(now, target, EV_PER_SECOND * seconds);
        let has_turned = gaze.is_some_and(|gaze| gaze != settings.look.gaze) && settings.window.vignette;
        let held = if has_turned { HELD } else { (held - seconds).max(0.0) };
        let end = if held > 0.0 { 1.0 } else { 0.0 };
        let vignette = towards(vignette, end, seconds / FADE);
        let gaze = Some(settings.look.gaze);
        self.scratch.comfort = Comfort { exposure_ev: Some(exposure_ev), gaze, held, vignette };
        exposure_ev != target || vignette > 0.0
    }

    /// The automatic exposure that a ride shows just now; `None` where it is not held back.
    pub(in crate::app) fn followed_exposure(&self) -> Option<f64> {
        let is_automatic = self.document.settings.light.exposure.0.is_none();
        self.scratch.comfort.exposure_ev.filter(|_| is_automatic)
    }

    /// Darkens the edge of the picture at `rect` while the head turns.
    pub(in crate::app) fn paint_vignette(&self, painter: &Painter, rect: Rect) {
        let strength = self.scratch.comfort.vignette as f32;
        if strength > 0.0 {
            painter.with_clip_rect(rect).add(Shape::mesh(vignette(rect, DEPTH * strength)));
        }
    }
}

/// `from`, by at most `step` nearer to `to`.
fn towards(from: f64, to: f64, step: f64) -> f64 {
    from + (to - from).clamp(-step, step)
}

/// A dark ring over the edge of `rect`, as opaque outside as this.
fn vignette(rect: Rect, opacity: f32) -> Mesh {
    let dark = Color32::from_black_alpha((255.0 * opacity) as u8);
    // The last ring is outside the corners.
    let rings = [(CLEAR, Color32::TRANSPARENT), (DARK, dark), (2.0, dark)];
    let mut mesh = Mesh::default();
    for corner in 0..=CORNERS {
        let angle = std::f64::consts::TAU * f64::from(corner) / f64::from(CORNERS);
        let (sine, cosine) = math::sin_cos(angle);
        let direction: Vec2 = vec2(cosine as f32, sine as f32) * 0.5 * rect.size();
        for (radius, color) in rings {
            let pos: Pos2 = rect.center() + radius * direction;
            mesh.vertices.push(Vertex { pos, uv: WHITE_UV, color });
        }
        if corner > 0 {
            let [before, after] = [3 * (corner - 1), 3 * corner];
            for ring in 0..2 {
                mesh.add_triangle(before + ring, before + ring + 1, after + ring);
                mesh.add_triangle(after + ring, before + ring + 1, after + ring + 1);
            }
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::command::Command;
    use crate::app::riding::saddle::{Direction, RideCommand};
    use crate::settings::Settings;

    const FRAME: f64 = 1.0 / 60.0;

    fn riding(scene: &str) -> State {
        let settings = Settings { scene: scene.to_owned(), ..Settings::default() };
        let mut state = State::open(settings).expect("a scene of ours");
        state.apply(Command::Ride(RideCommand::Toggle));
        state.document.settings.window.vignette = true;
        state.document.settings.ride.push = 8.0;
        state.follow_for_comfort(FRAME);
        state
    }

    #[test]
    fn the_hardest_push_does_not_flash_and_the_exposure_arrives() {
        let mut state = riding("street");
        let shown = |state: &State| state.appearance(true).exposure_ev;
        let mut before = shown(&state);
        let mut most: f64 = 0.0;
        for frame in 0..600 {
            if frame < 30 {
                state.apply(Command::Ride(RideCommand::Push(Direction::Forwards, FRAME)));
            }
            let is_on_its_way = state.follow_for_comfort(FRAME);
            let now = shown(&state);
            most = most.max((now - before).abs());
            assert_eq!(is_on_its_way, now != automatic(&state), "frame {frame}");
            before = now;
        }
        assert!(most <= 1.000_001 * EV_PER_SECOND * FRAME, "{most} in a frame");
        assert_eq!(before, automatic(&state));
        assert!(before.abs() > 1.0, "there was something to follow: {before}");
    }

    fn automatic(state: &State) -> f64 {
        state.document.settings.automatic_ev(&state.document.scene, state.document.time)
    }

    #[test]
    fn a_set_exposure_is_shown_at_once() {
        let mut state = riding("street");
        state.document.settings.light.exposure.0 = Some(-7.0);
        assert_eq!(state.appearance(true).exposure_ev, -7.0);
    }

    #[test]
    fn the_edge_is_dark_while_the_head_turns_and_for_a_moment_after() {
        let mut state = riding("street");
        assert_eq!(state.scratch.comfort.vignette, 0.0);
        for _ in 0..20 {
            state.apply(Command::LookAside([1.0, 0.0]));
            state.follow_for_comfort(FRAME);
        }
        assert_eq!(state.scratch.comfort.vignette, 1.0);
        for _ in 0..((HELD + FADE) / FRAME) as u32 + 2 {
            state.follow_for_comfort(FRAME);
        }
        assert_eq!(state.scratch.comfort.vignette, 0.0);
        assert!(!state.follow_for_comfort(FRAME), "no frame more is asked for");
        state.document.settings.window.vignette = false;
        state.apply(Command::LookAside([1.0, 0.0]));
        state.follow_for_comfort(FRAME);
        assert_eq!(state.scratch.comfort.vignette, 0.0);
    }

    #[test]
    fn the_vignette_leaves_the_middle_clear_and_covers_the_corners() {
        let rect = Rect::from_min_max(Pos2::new(10.0, 20.0), Pos2::new(410.0, 220.0));
        let mesh = vignette(rect, 1.0);
        let from_middle = |vertex: &Vertex| {
            let off = vertex.pos - rect.center();
            (2.0 * off.x / rect.width()).hypot(2.0 * off.y / rect.height())
        };
        let corner = 2.0_f32.sqrt();
        let (clear, dark): (Vec<_>, Vec<_>) =
            mesh.vertices.iter().partition(|vertex| vertex.color == Color32::TRANSPARENT);
        assert!(clear.iter().all(|vertex| (from_middle(vertex) - CLEAR).abs() < 1e-3));
        assert!(dark.iter().any(|vertex| from_middle(vertex) > corner));
        assert!(mesh.is_valid());
    }
}
