//! The outline of the body under the pointer, which tells it from its neighbours. It is found by rays at that body alone,
//! spread from the pointer as far as they hit it, so that it costs nothing where there is none.

use std::collections::BTreeSet;

use eframe::egui::{Color32, Painter, Stroke};
use relativity_render::{Group, PreparedScene, View};

use super::observer::Eye;
use super::panes::EyePane;
use super::state::State;

/// Pixels from ray to ray, and how many may hit: the first that is enough is taken, so that thin bodies are traced finely
/// and large ones cheaply.
const GRIDS: [(i32, usize); 2] = [(1, 1500), (4, 6000)];

/// A straight piece of an outline: pixels of the picture.
type Edge = [[f64; 2]; 2];

impl State {
    /// The outline of `body` around a `pixel` of the picture of `eye`, which has this `size`; nothing where it is too large.
    #[must_use]
    pub fn outline_of(&self, body: usize, eye: Eye, pixel: [f64; 2], size: [u32; 2]) -> Vec<Edge> {
        if self.sees_as_published(eye) {
            return Vec::new();
        }
        let motion = self.session.prepared.motion_of(body);
        let alone = PreparedScene::new([Group { motion, bodies: &self.session.scene.bodies[body..=body] }]);
        let view = self.view(eye, size);
        GRIDS
            .into_iter()
            .find_map(|(step, most)| traced(&alone, &view, pixel, step, most))
            .unwrap_or_default()
    }
}

/// The edges between rays that hit and rays that miss, among those connected with `pixel`; none if more than `most` hit.
fn traced(scene: &PreparedScene, view: &View, pixel: [f64; 2], step: i32, most: usize) -> Option<Vec<Edge>> {
    let [width, height] = view.camera.size.map(|side| (side / step.unsigned_abs()) as i32);
    let place = |at: i32| f64::from(at * step);
    let is_hit = |[u, v]: [i32; 2]| {
        let middle = [place(u) + 0.5 * f64::from(step), place(v) + 0.5 * f64::from(step)];
        scene.first_hit(view, view.camera.line_of_sight(middle)).is_some()
    };
    let start = pixel.map(|at| (at / f64::from(step)).floor() as i32);
    let mut hits = BTreeSet::from([start]);
    let mut missed = BTreeSet::new();
    let mut edges = Vec::new();
    let mut open = vec![start];
    while let Some([u, v]) = open.pop() {
        let neighbours = [
            ([u - 1, v], [[u, v], [u, v + 1]]),
            ([u + 1, v], [[u + 1, v], [u + 1, v + 1]]),
            ([u, v - 1], [[u, v], [u + 1, v]]),
            ([u, v + 1], [[u, v + 1], [u + 1, v + 1]]),
        ];
        for (next, edge) in neighbours {
            if hits.contains(&next) {
                continue;
            }
            let is_inside = (0..width).contains(&next[0]) && (0..height).contains(&next[1]);
            if is_inside && !missed.contains(&next) && is_hit(next) {
                hits.insert(next);
                open.push(next);
            } else {
                missed.insert(next);
                edges.push(edge.map(|corner| corner.map(place)));
            }
        }
        if hits.len() > most {
            return None;
        }
    }
    Some(edges)
}

/// Draws the outline `edges` in `pane`.
pub fn paint(painter: &Painter, pane: EyePane, edges: &[Edge]) {
    for stroke in [Stroke::new(3.0, Color32::from_black_alpha(120)), Stroke::new(1.3, Color32::WHITE)] {
        for edge in edges {
            painter.line_segment(edge.map(|corner| pane.place(corner)), stroke);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Settings;

    #[test]
    fn the_outline_is_where_the_body_ends() {
        let state = State::open(Settings::default()).expect("a preset");
        let size = [320, 240];
        for eye in Eye::BOTH {
            let view = state.view(eye, size);
            let on = (0..240).flat_map(|v| (0..320).map(move |u| [f64::from(u) + 0.5, f64::from(v) + 0.5]));
            let (pixel, body) = on
                .filter_map(|pixel| Some((pixel, state.point_at(eye, pixel, size)?.1)))
                .find(|(_, body)| state.session.scene.name_of(*body) == "front tyre")
                .expect("in sight");
            let alone = PreparedScene::new([Group {
                motion: state.session.prepared.motion_of(body),
                bodies: &state.session.scene.bodies[body..=body],
            }]);
            let edges = state.outline_of(body, eye, pixel, size);
            assert!(edges.len() > 100, "{} edges", edges.len());
            for [from, to] in edges {
                let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
                let across = if from[0] == to[0] { [0.5, 0.0] } else { [0.0, 0.5] };
                let hits = [1.0, -1.0].map(|side| {
                    let at = [middle[0] + side * across[0], middle[1] + side * across[1]];
                    alone.first_hit(&view, view.camera.line_of_sight(at)).is_some()
                });
                let is_at_the_edge =
                    middle.iter().zip(size).any(|(&at, side)| at <= 0.5 || at >= f64::from(side) - 0.5);
                assert!(hits[0] != hits[1] || is_at_the_edge, "{eye:?} at {middle:?}");
            }
        }
    }

    #[test]
    fn where_nothing_can_be_traced_there_is_no_outline() {
        let mut state = State::open(Settings::default()).expect("a preset");
        state.settings.look.geometry = relativity_render::Geometry::Published;
        let middle = [160.0, 120.0];
        assert!(state.outline_of(0, Eye::Right, middle, [320, 240]).is_empty());
        assert!(!state.outline_of(0, Eye::Left, middle, [320, 240]).is_empty());
    }
}
