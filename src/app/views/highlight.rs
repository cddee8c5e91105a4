//! The outline of the body under the pointer, which sets it off from its neighbours. It is found by rays at
//! that body alone, spread from the pointer as far as they hit it, so that it costs nothing where there is
//! none.

use std::collections::{BTreeMap, BTreeSet};

use eframe::egui::{Color32, Painter, Pos2, Shape, Stroke};
use relativity_render::{Group, PreparedScene, View};

use crate::app::state::State;
use crate::app::views::panes::EyePane;
use crate::eye::Eye;

/// Pixels from ray to ray, and how many may hit: the first that is enough is taken, so that thin bodies are
/// traced finely and large ones cheaply.
const GRIDS: [(i32, usize); 3] = [(1, 4000), (2, 4000), (4, 6000)];

/// Number of times that the steps of an outline from pixel to pixel are smoothed.
const SMOOTHED: usize = 2;

/// A closed line: pixels of the picture.
type Loop = Vec<[f64; 2]>;

impl State {
    /// The outline of `body` around a `pixel` of the picture of `eye`, which has this `size`; nothing where
    /// it is too large.
    #[must_use]
    pub fn outline_of(&self, body: usize, eye: Eye, pixel: [f64; 2], size: [u32; 2]) -> Vec<Loop> {
        if self.sees_as_published(eye) {
            return Vec::new();
        }
        let motion = self.document.prepared.motion_of(body);
        let alone = PreparedScene::new([Group { motion, bodies: &self.document.scene.bodies[body..=body] }]);
        let view = self.view(eye, size);
        GRIDS
            .into_iter()
            .find_map(|(step, most)| traced(&alone, &view, pixel, step, most))
            .unwrap_or_default()
    }
}

/// The lines between rays that hit and rays that miss, among those connected with `pixel`; none if more than
/// `most` hit.
fn traced(scene: &PreparedScene, view: &View, pixel: [f64; 2], step: i32, most: usize) -> Option<Vec<Loop>> {
    let [width, height] = view.camera.size.map(|side| (side / step.unsigned_abs()).cast_signed());
    let place = |at: i32| f64::from(at * step);
    let is_hit = |[u, v]: [i32; 2]| {
        let middle = [place(u) + 0.5 * f64::from(step), place(v) + 0.5 * f64::from(step)];
        scene.first_hit(view, view.camera.line_of_sight(middle)).is_some()
    };
    let start = pixel.map(|at| (at / f64::from(step)).floor() as i32);
    let mut hits = BTreeSet::from([start]);
    let mut missed = BTreeSet::new();
    let mut open = vec![start];
    while let Some([u, v]) = open.pop() {
        // Thin slanted bodies are connected by corners.
        for next in [-1, 0, 1].into_iter().flat_map(|down| [-1, 0, 1].map(|across| [u + across, v + down])) {
            if hits.contains(&next) || missed.contains(&next) {
                continue;
            }
            let is_inside = (0..width).contains(&next[0]) && (0..height).contains(&next[1]);
            if is_inside && is_hit(next) {
                hits.insert(next);
                open.push(next);
            } else {
                missed.insert(next);
            }
        }
        if hits.len() > most {
            return None;
        }
    }
    Some(
        loops(&hits)
            .into_iter()
            .map(|corners| corners.into_iter().map(|at| at.map(place)).collect())
            .collect(),
    )
}

/// The corners of cells along which `cells` end, loop by loop.
fn loops(cells: &BTreeSet<[i32; 2]>) -> Vec<Vec<[i32; 2]>> {
    // Clockwise around each cell, so that the edges that are left join.
    let edges = cells.iter().flat_map(|&[u, v]| {
        let sides = [
            ([u, v - 1], [[u, v], [u + 1, v]]),
            ([u + 1, v], [[u + 1, v], [u + 1, v + 1]]),
            ([u, v + 1], [[u + 1, v + 1], [u, v + 1]]),
            ([u - 1, v], [[u, v + 1], [u, v]]),
        ];
        sides.into_iter().filter(|(next, _)| !cells.contains(next)).map(|(_, edge)| edge)
    });
    let mut onwards: BTreeMap<[i32; 2], Vec<[i32; 2]>> = BTreeMap::new();
    for [from, to] in edges {
        onwards.entry(from).or_default().push(to);
    }
    let mut loops = Vec::new();
    while let Some(&start) = onwards.keys().next() {
        let mut corners = vec![start];
        while let Some(next) = corners.last().and_then(|last| take(&mut onwards, *last)) {
            corners.push(next);
        }
        corners.pop();
        loops.push(corners);
    }
    loops
}

/// The end of an edge that begins at `corner`, which is then gone.
fn take(onwards: &mut BTreeMap<[i32; 2], Vec<[i32; 2]>>, corner: [i32; 2]) -> Option<[i32; 2]> {
    let ends = onwards.get_mut(&corner)?;
    let end = ends.pop();
    if ends.is_empty() {
        onwards.remove(&corner);
    }
    end
}

/// Draws the outline `loops` in `pane`.
pub fn paint(painter: &Painter, pane: EyePane, loops: &[Loop]) {
    for corners in loops {
        let places = corners.iter().map(|corner| pane.place(*corner)).collect();
        let smooth = (0..SMOOTHED).fold(places, |places: Vec<Pos2>, _| smoothed(&places));
        for stroke in [Stroke::new(3.0, Color32::from_black_alpha(110)), Stroke::new(1.2, Color32::WHITE)] {
            painter.add(Shape::closed_line(smooth.clone(), stroke));
        }
    }
}

/// Each of the `places` on a loop a little nearer to its neighbours.
fn smoothed(places: &[Pos2]) -> Vec<Pos2> {
    let count = places.len();
    let near = |at: usize, next: usize| places[(at + next) % count].to_vec2();
    (0..count).map(|at| ((near(at, count - 1) + 2.0 * near(at, 0) + near(at, 1)) / 4.0).to_pos2()).collect()
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
            let shown = state.document.prepared.hit_image(&view).hits;
            let mut bodies = (0..).zip(shown).filter_map(|(i, hit)| Some((i, hit?.body)));
            let is_tyre = |body: usize| state.document.scene.name_of(body) == "front tyre";
            let (i, body): (u32, usize) = bodies.find(|(_, body)| is_tyre(*body)).expect("in sight");
            let pixel = [i % 320, i / 320].map(|at| f64::from(at) + 0.5);
            let alone = PreparedScene::new([Group {
                motion: state.document.prepared.motion_of(body),
                bodies: &state.document.scene.bodies[body..=body],
            }]);
            let outline = state.outline_of(body, eye, pixel, size);
            assert_eq!(outline.len(), 2, "a tyre has an outer and an inner edge");
            let onwards = |corners: &Loop| {
                corners.iter().copied().cycle().skip(1).take(corners.len()).collect::<Vec<_>>()
            };
            for (from, to) in
                outline.iter().flat_map(|corners| corners.clone().into_iter().zip(onwards(corners)))
            {
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
        state.document.settings.look.geometry = relativity_render::Geometry::Published;
        let middle = [160.0, 120.0];
        assert!(state.outline_of(0, Eye::Right, middle, [320, 240]).is_empty());
        assert!(!state.outline_of(0, Eye::Left, middle, [320, 240]).is_empty());
    }
}
