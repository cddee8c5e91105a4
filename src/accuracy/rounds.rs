//! Errors and costs of entries into turning bodies that are found in rounds, each of which takes the ray's curve for a straight
//! line, against the exact entry. The renderers find spokes by steps that pass no entry (`course.wgsl`); bodies that are no tubes,
//! which no scene file has turn about an axle, they still find in rounds.

use std::hint::black_box;

use gamow_platform::clock::Instant;
use glam::{DVec2, DVec3};
use relativity_render::camera::lines_of_sight::LinesOfSight;
use relativity_render::scene::wheel::rounds::Search;
use relativity_render::{Geometry, GroupView, HitImage, PreparedScene, View};
use serde::{Deserialize, Serialize};

use super::spread::Spread;

/// The numbers of rounds that are measured. The shader takes six at most, for bodies that are no tubes.
const ROUNDS: [u32; 4] = [1, 2, 3, 6];
/// Greatest number of rays that are compared.
const RAYS: usize = 2000;
/// Timed runs, of which the fastest counts.
const RUNS: u32 = 3;
/// Halvings of a pixel in the search for an outline.
const BISECTIONS: u32 = 40;
/// Distance of the neighbouring place that gives an outline's direction, pixels.
const NEIGHBOUR_PX: f64 = 0.02;

/// The error of rounds in one view.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RoundsError {
    /// Rays that were compared: through pixels that show what turns.
    pub rays: usize,
    /// Nanoseconds per ray and body of the exact search, one thread.
    pub exact_ns: f64,
    /// After each number of rounds.
    pub after: Vec<AfterRounds>,
}

/// The error of rays after some rounds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AfterRounds {
    /// Number of rounds.
    pub rounds: u32,
    /// Nanoseconds per ray and body, one thread.
    pub ray_ns: f64,
    /// From the exact entry, along the ray in the rest frame, in radii of the wheel.
    pub along_radii: Option<Spread>,
    /// Displacement of outlines, pixels: at most one, where the search ends.
    pub outlines_px: Option<Spread>,
    /// Share of the rays that find no entry.
    pub missed_share: f64,
}

/// A ray, and the body that turns where it enters.
struct TurningSample<'a> {
    body: usize,
    view: &'a GroupView,
    line_of_sight: DVec3,
}

impl RoundsError {
    /// In `view`, which the reference shows as `image`, at about `places` places on outlines; `None` where it shows nothing
    /// that turns, and where eyes share a light cone: no ray is straight there.
    #[must_use]
    pub fn new(scene: &PreparedScene, view: &View, image: &HitImage, places: usize) -> Option<Self> {
        let has_rays = matches!(view.geometry, Geometry::Seen | Geometry::Contracted | Geometry::Rest);
        let views = scene.group_views(view);
        let pixels = if has_rays { turned_pixels(scene, image) } else { Vec::new() };
        let lines_of_sight = view.camera.lines_of_sight();
        let samples = |(pixel, body): (DVec2, usize)| TurningSample {
            body,
            view: &views[scene.group_of(body)],
            line_of_sight: lines_of_sight.through(pixel.to_array()),
        };
        let rays: Vec<_> = evenly(&pixels, RAYS).map(samples).collect();
        let (exact, exact_ns) = timed(scene, &rays, Search::Exact);
        let edges = OutlineEdges { scene, views: &views, lines_of_sight: &lines_of_sight };
        let outlines: Vec<_> = evenly(&pixels, 8 * places).filter_map(|pixel| edges.exact(pixel)).collect();
        let outlines: Vec<_> = evenly(&outlines, places).collect();
        let after = |rounds: u32| {
            let search = Search::Rounds(rounds);
            let (found, ray_ns) = timed(scene, &rays, search);
            let pairs = rays.iter().zip(exact.iter().zip(&found));
            let along = pairs.filter_map(|(ray, (&exact, &found))| {
                let radius = scene.bodies()[ray.body].spin?.radius;
                Some((found? - exact?).abs() / radius)
            });
            let missed = found.iter().filter(|entry| entry.is_none()).count();
            AfterRounds {
                rounds,
                ray_ns,
                along_radii: Spread::from_errors(along.collect()),
                outlines_px: Spread::from_errors(
                    outlines.iter().map(|edge| edges.displacement(edge, search)).collect(),
                ),
                missed_share: missed as f64 / rays.len().max(1) as f64,
            }
        };
        (!rays.is_empty()).then(|| Self { rays: rays.len(), exact_ns, after: ROUNDS.map(after).into() })
    }

    /// The worse of two views, figure by figure.
    #[must_use]
    pub fn worse(self, other: &Self) -> Self {
        let spread =
            |a: Option<Spread>, b: Option<Spread>| [a, b].into_iter().flatten().reduce(Spread::worse);
        let after = self.after.into_iter().zip(&other.after).map(|(a, b)| AfterRounds {
            rounds: a.rounds,
            ray_ns: a.ray_ns.max(b.ray_ns),
            along_radii: spread(a.along_radii, b.along_radii),
            outlines_px: spread(a.outlines_px, b.outlines_px),
            missed_share: a.missed_share.max(b.missed_share),
        });
        Self {
            rays: self.rays + other.rays,
            exact_ns: self.exact_ns.max(other.exact_ns),
            after: after.collect(),
        }
    }
}

/// The middles of the pixels that show a body that turns, and its number.
fn turned_pixels(scene: &PreparedScene, image: &HitImage) -> Vec<(DVec2, usize)> {
    let width = image.size[0] as usize;
    let shown = image.hits.iter().enumerate().filter_map(|(i, hit)| {
        let body = hit.as_ref()?.body;
        let pixel = DVec2::new((i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
        scene.is_turned(body).then_some((pixel, body))
    });
    shown.collect()
}

/// Returns about `most` of all, evenly spread.
fn evenly<T: Copy>(all: &[T], most: usize) -> impl Iterator<Item = T> {
    all.iter().copied().step_by(all.len().div_ceil(most.max(1)).max(1))
}

/// Returns the place where each ray enters, and nanoseconds per ray.
fn timed(scene: &PreparedScene, rays: &[TurningSample<'_>], search: Search) -> (Vec<Option<f64>>, f64) {
    let entry = |ray: &TurningSample<'_>| scene.turned_entry(ray.body, ray.view, ray.line_of_sight, search);
    let mut fastest = f64::INFINITY;
    let mut entries = Vec::new();
    for _ in 0..RUNS {
        let start = Instant::now();
        entries = black_box(rays.iter().map(entry).collect());
        fastest = fastest.min(start.elapsed().as_secs_f64() * 1e9 / rays.len().max(1) as f64);
    }
    (entries, fastest)
}

/// A place on the outline of a body, between two pixels side by side.
#[derive(Debug, Clone, Copy)]
struct OutlineEdge {
    body: usize,
    inside: DVec2,
    outside: DVec2,
    /// Place of the edge.
    place: DVec2,
    /// Pixels across the outline per pixel from `inside` to `outside`.
    across: f64,
}

/// Outlines of single bodies in a view, whatever is before them.
struct OutlineEdges<'a> {
    scene: &'a PreparedScene,
    views: &'a [GroupView],
    lines_of_sight: &'a LinesOfSight,
}

impl OutlineEdges<'_> {
    /// The edge to the right of the middle of a pixel that shows the body; `None` if there is none.
    fn exact(&self, (inside, body): (DVec2, usize)) -> Option<OutlineEdge> {
        let outside = inside + DVec2::X;
        let aside = NEIGHBOUR_PX * DVec2::Y;
        let place = self.edge(body, inside, outside, Search::Exact)?;
        let neighbour = self.edge(body, inside + aside, outside + aside, Search::Exact)?;
        let across = NEIGHBOUR_PX / (neighbour - place).length();
        Some(OutlineEdge { body, inside, outside, place, across })
    }

    /// Returns the displacement of the edge, pixels; if it is not between the two pixels, the distance of the nearer one that shows so.
    fn displacement(&self, edge: &OutlineEdge, search: Search) -> f64 {
        let OutlineEdge { body, inside, outside, place, across } = *edge;
        let found = self
            .edge(body, inside, outside, search)
            .unwrap_or_else(|| if self.shows(body, inside, search) { outside } else { inside });
        (found - place).length() * across
    }

    fn edge(&self, body: usize, inside: DVec2, outside: DVec2, search: Search) -> Option<DVec2> {
        let shows = |place| self.shows(body, place, search);
        if !shows(inside) || shows(outside) {
            return None;
        }
        let halved = |[inside, outside]: [DVec2; 2], _| {
            let middle = 0.5 * (inside + outside);
            if shows(middle) { [middle, outside] } else { [inside, middle] }
        };
        Some((0..BISECTIONS).fold([inside, outside], halved)[0])
    }

    fn shows(&self, body: usize, place: DVec2, search: Search) -> bool {
        let line_of_sight = self.lines_of_sight.through(place.to_array());
        let view = &self.views[self.scene.group_of(body)];
        self.scene.turned_entry(body, view, line_of_sight, search).is_some()
    }
}

#[cfg(test)]
mod tests {
    use relativity_core::Speed;

    use super::*;
    use crate::accuracy::{TrackedPlace, view_at};
    use crate::scene::Scene;

    fn measured(preset: &str, beta: f64, geometry: Geometry) -> Option<RoundsError> {
        let scene = Scene::preset(preset).expect("a preset");
        let speed = Speed::from_beta(beta).expect("it is a speed");
        let place = TrackedPlace::Abreast;
        let view = view_at(place, speed, scene.tracked, 0.1, 0.8, [96, 72]).expect("inside the domain");
        let (prepared, view) = (scene.prepared(), View { geometry, ..view });
        RoundsError::new(&prepared, &view, &prepared.hit_image(&view), 12)
    }

    #[test]
    fn each_round_squares_what_is_off() {
        let error = measured("wheel", 0.9, Geometry::Seen).expect("it has spokes");
        assert!(error.rays > 100);
        let along = |i: usize| error.after[i].along_radii.expect("most are found").p99;
        assert!(along(0) > 1e-5 && along(0) < 1e-2, "{}", along(0));
        assert!(along(1) < along(0).powf(1.5) && along(2) < along(1).powf(1.4), "{error:?}");
        let outlines = |i: usize| error.after[i].outlines_px.expect("spokes have outlines");
        assert!(outlines(0).count >= 6 && outlines(0).worst > outlines(2).worst && outlines(2).worst < 1e-3);
    }

    #[test]
    fn what_turns_nowhere_is_not_measured() {
        assert_eq!(measured("two-balls", 0.9, Geometry::Seen), None);
        assert_eq!(measured("wheel", 0.9, Geometry::OneCone), None);
        // At rest it does not roll, and one round is exact.
        let resting = measured("wheel", 0.0, Geometry::Seen).expect("it has spokes");
        assert!(resting.after[0].along_radii.expect("all are found").worst < 1e-12);
    }
}
