//! Comfort on a ride: an exposure that follows the speed without flashing, and a vignette while the head
//! turns.
//!
//! Streaming at the edge of the field of view is what makes people ill, and it is darkened for as long as the
//! head turns. The light that rushes in with D^4 would flash at each push; the exposure meets it at a limited
//! rate.

use eframe::egui::epaint::{Mesh, Vertex, WHITE_UV};
use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Vec2, vec2};
use relativity_core::math;

use crate::flags::choices::GazeChoice;

/// The fastest change of an automatic exposure, factors of 2 per second.
const EV_PER_SECOND: f64 = 3.0;
/// Time for which the vignette stays after the last turn, and in which it comes and goes, seconds.
const HELD: f64 = 0.3;
const FADE: f64 = 0.25;
/// Radii of the vignette, parts of the half width and the half height: clear inside the first, dark outside
/// the second.
const CLEAR: f32 = 0.55;
const DARK: f32 = 1.15;
/// Greatest opacity of the vignette, 0 to 1.
const DEPTH: f32 = 0.92;
/// Corners of the vignette's rings.
const CORNERS: u32 = 64;

/// Exposure and vignette of a ride, which follow it from one frame of the window to the next.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RideComfort {
    /// Automatic exposure that is shown, on its way to the one that the speed has.
    pub exposure_ev: Option<f64>,
    /// Gaze of the frame before.
    gaze: Option<GazeChoice>,
    /// Seconds for which the vignette is still held.
    held: f64,
    /// Strength of the vignette, 0 to 1.
    vignette: f64,
}

impl RideComfort {
    /// Returns it after this many `seconds`, in which the automatic exposure was on its way to `target_ev`
    /// and the head held this `gaze`; a turn darkens the edges only if that `has_vignette`.
    #[must_use]
    pub fn after(self, seconds: f64, target_ev: f64, gaze: GazeChoice, has_vignette: bool) -> Self {
        let now = self.exposure_ev.unwrap_or(target_ev);
        let has_turned = has_vignette && self.gaze.is_some_and(|before| before != gaze);
        let held = if has_turned { HELD } else { (self.held - seconds).max(0.0) };
        let end = if held > 0.0 { 1.0 } else { 0.0 };
        Self {
            exposure_ev: Some(towards(now, target_ev, EV_PER_SECOND * seconds)),
            gaze: Some(gaze),
            held,
            vignette: towards(self.vignette, end, seconds / FADE),
        }
    }

    /// Whether the exposure is still on its way to `target_ev`, or the vignette has not gone yet.
    #[must_use]
    pub fn is_on_its_way(&self, target_ev: f64) -> bool {
        self.exposure_ev != Some(target_ev) || self.vignette > 0.0
    }

    /// Darkens the edge of the picture at `rect` while the head turns.
    pub fn paint(&self, painter: &Painter, rect: Rect) {
        let strength = self.vignette as f32;
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

    const FRAME: f64 = 1.0 / 60.0;
    const AHEAD: GazeChoice = GazeChoice::Fixed([0.0, -12.0]);

    #[test]
    fn a_push_does_not_flash_and_the_exposure_arrives() {
        let mut comfort = RideComfort::default().after(FRAME, 0.0, AHEAD, true);
        assert_eq!(comfort.exposure_ev, Some(0.0));
        let mut frames = 0;
        while comfort.is_on_its_way(-6.0) {
            let before = comfort.exposure_ev.expect("there was a frame");
            comfort = comfort.after(FRAME, -6.0, AHEAD, true);
            let now = comfort.exposure_ev.expect("there was a frame");
            assert!((now - before).abs() < 1.000_001 * EV_PER_SECOND * FRAME, "{before} to {now}");
            frames += 1;
        }
        // Two seconds for six factors of 2.
        assert!((119..=122).contains(&frames), "{frames}");
    }

    #[test]
    fn the_edge_is_dark_while_the_head_turns_and_for_a_moment_after() {
        let turned = |frame: u32| GazeChoice::Fixed([f64::from(frame), 0.0]);
        let mut comfort = RideComfort::default();
        for frame in 0..20 {
            comfort = comfort.after(FRAME, 0.0, turned(frame), true);
        }
        assert_eq!(comfort.vignette, 1.0);
        for _ in 0..((HELD + FADE) / FRAME) as u32 + 2 {
            comfort = comfort.after(FRAME, 0.0, turned(19), true);
        }
        assert_eq!(comfort.vignette, 0.0);
        assert!(!comfort.is_on_its_way(0.0), "no frame more is asked for");
        assert_eq!(comfort.after(FRAME, 0.0, turned(20), false).vignette, 0.0);
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
