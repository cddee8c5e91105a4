//! Crowds: bodies that the device places by itself, since they are small in the picture.
//!
//! The processor decides on a cluster of them at once, and their data stay on the device from picture to
//! picture. So a picture costs it a step for each cluster, in place of a rectangle for each body; the vertex
//! stage finds the rectangles (`footprint.wgsl`).

use std::collections::BTreeMap;
use std::mem;
use std::ops::Range;

use relativity_core::threads::prelude::*;

use super::piece::{FADED_PX, Piece, THIN_PX};
use crate::gpu::buffers::{fill_vertex_buffer, vertex_buffer};
use crate::gpu::device::Gpu;
use crate::gpu::drawing::{Batches, Shot, Trait};
use crate::picture::footprint::FootprintMap;
use crate::picture::tiles::Tile;
use crate::scene::clusters::Cluster;
use crate::scene::prepared_scene::PreparedScene;
use crate::scene::wheel::packed::Turns;
use crate::view::Appearance;
use crate::view::effects::Effects;
use crate::view::group_view::GroupView;

/// The radius, px, up to which a body is small, where the middle of a flat picture shows it: an upright
/// rectangle around it has little else in it.
const MOST_PX: f64 = 16.0;
/// The gamma up to which f32 keeps rectangles within the room around them.
const MOST_GAMMA: f64 = 1000.0;
/// Distances that f32 can square and divide by, rest frame.
const DISTANCES: Range<f64> = 1e-9..1e12;
/// The most bodies that are drawn outside of the picture, so that one draw serves their neighbours.
const MOST_BRIDGED: u32 = 64;

/// The bodies of a scene that the device may place.
#[derive(Debug)]
pub struct Crowd {
    /// The origin of the data on the device; `None` before there are any.
    held: Option<Held>,
    /// The data of all simple bodies, group by group.
    buffer: wgpu::Buffer,
    /// The ranges in the buffer that the picture shows.
    shown: BTreeMap<Trait<()>, Vec<Range<u32>>>,
    /// The numbers of the clusters in the picture.
    found: Vec<u32>,
    batches: Batches<Piece, ()>,
}

/// The origin of the data of bodies: a change of any of it changes them. Exposure does not.
#[derive(Debug, PartialEq)]
struct Held {
    scene: PreparedScene,
    unexposed: Option<Appearance>,
    /// Effects of each group.
    effects: Vec<Option<Effects>>,
}

/// A decision on a cluster.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Verdict {
    /// None of it is in the picture.
    Hidden,
    /// The device places its bodies; are they drawn as thin ones?
    Placed { is_thin: bool },
    /// The processor places each of its bodies: they are large, or thin ones among thick, or f32 may lose
    /// them.
    OneByOne,
}

/// The view of one group, for decisions on its clusters.
#[derive(Debug)]
pub struct ClusterView<'a> {
    view: &'a GroupView,
    projection: &'a FootprintMap,
    /// Whether thin bodies are faded, as in pictures.
    is_faded: bool,
}

impl Crowd {
    /// None yet, to be drawn by the pipelines of `batches`.
    pub fn new(gpu: &Gpu, batches: Batches<Piece, ()>) -> Self {
        Self { held: None, buffer: vertex_buffer(gpu, 0), shown: BTreeMap::new(), found: Vec::new(), batches }
    }

    /// Shows nothing any more.
    pub fn clear(&mut self) {
        self.shown.values_mut().for_each(Vec::clear);
    }

    /// Decides, by the `view` of the group of this number, which of its bodies the crowd shows, and adds the
    /// numbers of all others that may be in the picture to `others`, in order.
    pub fn divide(
        &mut self,
        scene: &PreparedScene,
        group: usize,
        view: &ClusterView<'_>,
        others: &mut Vec<u32>,
    ) {
        let bodies = scene.groups()[group].bodies.clone();
        others.extend(scene.turning_in(bodies).map(|body| body as u32));
        let picture = Tile { corner: [0, 0], size: view.view.camera.size };
        let beam = scene.beam(group, view.view, &picture.cap(&view.view.camera.lines_of_sight()));
        let mut found = mem::take(&mut self.found);
        scene.find_clusters(group, view.view, beam.as_ref(), &mut found);
        let first = (0..group).map(|group| scene.clusters(group).simple_bodies().len()).sum::<usize>();
        let clusters = scene.clusters(group);
        // The traits of the last cluster, if the crowd shows it: no body since is drawn otherwise.
        let mut last = None;
        for &number in &found {
            let cluster = clusters.cluster(number);
            match view.verdict(cluster) {
                Verdict::Hidden => {}
                Verdict::Placed { is_thin } => {
                    let (kind, is_patterned) = (cluster.alike.kind, cluster.alike.is_patterned);
                    let shared =
                        Trait { is_thin, group, kind, is_patterned, turns: Turns::Not, template: () };
                    let [start, end] = [cluster.range.start, cluster.range.end].map(|at| (first + at) as u32);
                    self.show(shared, start..end, last == Some(shared));
                    last = Some(shared);
                }
                Verdict::OneByOne => {
                    last = None;
                    match &beam {
                        Some(beam) => cluster.hierarchy.add_along(beam, others),
                        None => others.extend(clusters.bodies_of(cluster)),
                    }
                }
            }
        }
        self.found = found;
        others.sort_unstable();
        others.dedup();
    }

    /// Shows the bodies in a `range` of the buffer, if it may with those between them and the last.
    fn show(&mut self, shared: Trait<()>, range: Range<u32>, may_bridge: bool) {
        let ranges = self.shown.entry(shared).or_default();
        let most = if may_bridge { MOST_BRIDGED } else { 0 };
        match ranges.last_mut() {
            Some(last) if last.end <= range.start && range.start - last.end <= most => last.end = range.end,
            _ => ranges.push(range),
        }
    }

    /// Makes the pipelines that the shown bodies need, and brings the data of all simple bodies of `shot` to
    /// the device, unless they are there or none is shown.
    pub fn load(&mut self, gpu: &Gpu, shot: &Shot<'_>) {
        let shown = self.shown.iter().filter(|(_, ranges)| !ranges.is_empty());
        self.batches.refer(gpu, shot, shown.map(|(&shared, ranges)| (shared, &ranges[..])));
        if self.batches.iter().next().is_none() || self.held.as_ref().is_some_and(|held| held.is_of(shot)) {
            return;
        }
        let groups = 0..shot.scene.groups().len();
        let bodies = groups.flat_map(|group| shot.scene.clusters(group).simple_bodies());
        let bodies: Vec<_> = bodies.map(|&number| &shot.scene.bodies()[number as usize]).collect();
        let pieces: Vec<_> = bodies.par_iter().map(|body| Piece::new(body, shot)).collect();
        fill_vertex_buffer(gpu, &mut self.buffer, &pieces);
        self.held = Some(Held::of(shot));
    }

    /// The batches that are shown, and the buffer that they are ranges of.
    pub const fn drawn(&self) -> (&Batches<Piece, ()>, &wgpu::Buffer) {
        (&self.batches, &self.buffer)
    }
}

impl Held {
    fn of(shot: &Shot<'_>) -> Self {
        let effects = Self::effects(shot).collect();
        Self { scene: shot.scene.clone(), unexposed: Self::unexposed(shot), effects }
    }

    fn is_of(&self, shot: &Shot<'_>) -> bool {
        self.scene == *shot.scene
            && self.unexposed == Self::unexposed(shot)
            && Self::effects(shot).eq(self.effects.iter().copied())
    }

    fn unexposed(shot: &Shot<'_>) -> Option<Appearance> {
        shot.appearance.map(|&appearance| Appearance { exposure_ev: 0.0, ..appearance })
    }

    fn effects(shot: &Shot<'_>) -> impl Iterator<Item = Option<Effects>> {
        shot.views.iter().map(|view| Some(view.effects(Turns::Not, shot.appearance?)))
    }
}

impl<'a> ClusterView<'a> {
    pub const fn new(view: &'a GroupView, projection: &'a FootprintMap, is_faded: bool) -> Self {
        Self { view, projection, is_faded }
    }

    /// Returns the decision on `cluster`.
    fn verdict(&self, cluster: &Cluster) -> Verdict {
        let middle = self.view.along_motion_from_camera(cluster.ball.from);
        if self.projection.hides(middle, cluster.ball.radius) {
            return Verdict::Hidden;
        }
        let is_in_reach = self.view.velocity.speed.gamma() <= MOST_GAMMA
            && DISTANCES.contains(&(middle.length() - cluster.ball.radius))
            && cluster.are_simple();
        let lengths = self.projection.lengths_of_a_pixel(middle, cluster.ball.radius);
        let Some([finest, coarsest]) = lengths.filter(|_| is_in_reach) else {
            return Verdict::OneByOne;
        };
        let [thinnest, thickest] = [cluster.radii[0] / coarsest, cluster.radii[1] / finest];
        match cluster.largest / finest {
            px if px > MOST_PX => Verdict::OneByOne,
            _ if !self.is_faded || thinnest >= FADED_PX => Verdict::Placed { is_thin: false },
            _ if thickest < THIN_PX => Verdict::Placed { is_thin: true },
            _ => Verdict::OneByOne,
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use relativity_core::{Aperture, Speed};

    use super::*;
    use crate::camera::{Camera, Gaze, Projection};
    use crate::geometry::shape::Shape;
    use crate::scene::body::Body;
    use crate::scene::prepared_body::PreparedBody;
    use crate::view::{Geometry, View};

    /// Swarms of small tubes around the camera.
    fn scene() -> PreparedScene {
        let spread = |i: u32, root: f64| (f64::from(i) * root.sqrt()).fract() - 0.5;
        let body = |i: u32| {
            let swarm = DVec3::new(spread(i / 40, 2.0), spread(i / 40, 3.0), spread(i / 40, 5.0));
            let own = DVec3::new(spread(i, 7.0), spread(i, 11.0), spread(i, 13.0));
            let start = 12.0 * swarm + 0.2 * own;
            let end = start + 0.02 * own;
            let shape = Shape::Tube { from: start.to_array(), to: end.to_array(), radius: 0.002 };
            Body::new(shape, 600.0)
        };
        PreparedScene::moving(&(0..4000).map(body).collect::<Vec<_>>())
    }

    fn views() -> impl Iterator<Item = View> {
        let geometries = [Geometry::Seen, Geometry::Contracted, Geometry::Rest];
        let right = DVec3::new(0.96, 0.0, 0.28);
        let projections = [
            Projection::Gaze,
            Projection::Parallel { right, shift: 0.1 },
            Projection::Mercator { right: DVec3::X, shift: 0.0 },
            Projection::Mercator { right, shift: 0.1 },
        ];
        let speeds = [0.0, 0.5, 0.99, 0.999_999].map(|beta| Speed::from_beta(beta).expect("below 1"));
        let cases = geometries.into_iter().flat_map(move |geometry| speeds.map(|speed| (geometry, speed)));
        cases.flat_map(move |(geometry, speed)| {
            projections.map(|projection| {
                let gaze = Gaze { azimuth: 1.2, elevation: 0.1 };
                let camera = Camera::new(Aperture::default(), gaze, 1.2, [640, 480]);
                let camera = Camera { projection, ..camera };
                View { camera, speed, observation_time: 1.5, geometry }
            })
        })
    }

    /// Every body of a placed cluster keeps the bounds of its verdict on size and thickness, and most small
    /// bodies are placed by the device.
    #[test]
    fn verdicts_hold_for_each_body() {
        let scene = scene();
        let (mut placed, mut one_by_one) = (0, 0);
        for view in views() {
            let group = &scene.group_views(&view)[0];
            let projection = FootprintMap::new(group);
            let decide = ClusterView::new(group, &projection, true);
            let mut found = Vec::new();
            scene.find_clusters(0, group, None, &mut found);
            let lengths = |place: DVec3| {
                let seen = projection.apparent_centre(place, 0.0).expect("it is seen");
                view.camera.mercator().map_or_else(
                    || seen.length() / view.camera.focal_length_px(),
                    |mercator| {
                        let baseline = group.velocity.motion_from_camera(mercator.axes.right);
                        seen.reject_from(baseline).length() / mercator.px_per_unit
                    },
                )
            };
            for number in found {
                let cluster = scene.clusters(0).cluster(number);
                let numbers = scene.clusters(0).bodies_of(cluster).iter();
                let bodies: Vec<_> = numbers.map(|&body| &scene.bodies()[body as usize]).collect();
                let middle =
                    |body: &PreparedBody| group.along_motion_from_camera(scene.ball_around(body).from);
                match decide.verdict(cluster) {
                    Verdict::Hidden => {
                        let is_hidden = |body| projection.hides(middle(body), scene.ball_around(body).radius);
                        assert!(bodies.iter().all(|body| is_hidden(body)), "{view:?}");
                    }
                    Verdict::Placed { is_thin } => {
                        placed += bodies.len();
                        for body in bodies {
                            let length = lengths(middle(body));
                            let reach_px = scene.ball_around(body).radius / length;
                            let radius_px = f64::from(body.placement.place_radius[3]) / length;
                            assert!(reach_px <= MOST_PX, "{reach_px} px: {view:?}");
                            let is_right = if is_thin { radius_px < THIN_PX } else { radius_px >= FADED_PX };
                            assert!(is_right, "{radius_px} px: {view:?}");
                        }
                    }
                    Verdict::OneByOne => {
                        let is_small = |body: &&PreparedBody| {
                            scene.ball_around(body).radius / lengths(middle(body)) < 0.5 * MOST_PX
                        };
                        one_by_one += bodies.into_iter().filter(is_small).count();
                    }
                }
            }
        }
        assert!(placed > 3 * one_by_one && placed > 1000, "{placed} placed, {one_by_one} one by one");
    }
}
