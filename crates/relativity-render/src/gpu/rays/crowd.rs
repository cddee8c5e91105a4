//! Crowds: bodies that the device places by itself, since they are small in the picture.
//!
//! The processor decides on a block of them at once, and their data stay on the device from picture to
//! picture. So a picture costs it a step for each block, in place of a rectangle for each body; the vertex
//! stage finds the rectangles (`footprint.wgsl`).

use std::collections::BTreeMap;
use std::ops::Range;

use relativity_core::threads::prelude::*;

use super::pieces::Piece;
use crate::gpu::buffers::{fill_vertex_buffer, vertex_buffer};
use crate::gpu::device::Gpu;
use crate::gpu::drawing::{Batches, Shot, Trait};
use crate::picture::footprint::FootprintMap;
use crate::picture::tiles::Tile;
use crate::scene::blocks::Block;
use crate::scene::prepared_scene::PreparedScene;
use crate::scene::wheel::packed::Turns;
use crate::view::Appearance;
use crate::view::effects::Effects;
use crate::view::group_view::GroupView;

/// The radius, px, up to which a body is small: an upright rectangle around it has little else in it.
const MOST_PX: f64 = 16.0;
/// The gamma up to which f32 keeps rectangles within the room around them.
const MOST_GAMMA: f64 = 1000.0;
/// Distances that f32 can square and divide by, rest frame.
const DISTANCES: Range<f64> = 1e-9..1e12;
/// Bodies of at most this radius may be drawn as thin ones, px: the shader fades what is thin among them.
const MOST_THIN_PX: f64 = 2.0;

/// The bodies of a scene that the device may place.
#[derive(Debug)]
pub struct Crowd {
    /// What the device holds; `None` before the first.
    held: Option<Held>,
    /// The data of all simple bodies, group by group.
    buffer: wgpu::Buffer,
    /// The ranges in the buffer that the picture shows.
    shown: BTreeMap<Trait<()>, Vec<Range<u32>>>,
    batches: Batches<Piece, ()>,
}

/// All that the data of bodies depend on.
#[derive(Debug, PartialEq)]
struct Held {
    scene: PreparedScene,
    appearance: Option<Appearance>,
    /// Effects of each group.
    effects: Vec<Option<Effects>>,
}

/// A decision on a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Verdict {
    /// None of it is in the picture.
    Hidden,
    /// The device places its bodies; are they drawn as thin ones?
    Placed { is_thin: bool },
    /// Each body is to be placed for itself.
    Near,
}

/// The view of one group, for decisions on its blocks.
#[derive(Debug)]
pub struct BlockView<'a> {
    view: &'a GroupView,
    projection: &'a FootprintMap,
    /// Radius below which bodies are faded, px: 0 where none is.
    thin_px: f64,
}

impl Crowd {
    /// None yet, to be drawn by the pipelines of `batches`.
    pub fn new(gpu: &Gpu, batches: Batches<Piece, ()>) -> Self {
        Self { held: None, buffer: vertex_buffer(gpu, 0), shown: BTreeMap::new(), batches }
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
        view: &BlockView<'_>,
        others: &mut Vec<u32>,
    ) {
        let bodies = scene.groups()[group].bodies.clone();
        others.extend(scene.turning_in(bodies).map(|body| body as u32));
        let picture = Tile { corner: [0, 0], size: view.view.camera.size };
        let beam = scene.beam(group, view.view, &picture.cap(&view.view.camera.lines_of_sight()));
        let first = (0..group).map(|group| scene.blocks(group).simple_bodies().len()).sum();
        for block in scene.seen_blocks(group, view.view) {
            match view.verdict(block) {
                Verdict::Hidden => {}
                Verdict::Placed { is_thin } => self.show(group, first, block, is_thin),
                Verdict::Near => match &beam {
                    Some(beam) => block.hierarchy.along(beam, |candidate| {
                        others.push(candidate.body);
                        f32::INFINITY
                    }),
                    None => others.extend(scene.blocks(group).bodies_of(block)),
                },
            }
        }
        others.sort_unstable();
        others.dedup();
    }

    /// Shows a block of the group of this number, whose simple bodies begin at `first` in the buffer.
    fn show(&mut self, group: usize, first: usize, block: &Block, is_thin: bool) {
        let (kind, is_patterned) = (block.alike.kind, block.alike.is_patterned);
        let shared = Trait { is_thin, group, kind, is_patterned, turns: Turns::Not, template: () };
        let ranges = self.shown.entry(shared).or_default();
        let [start, end] = [block.range.start, block.range.end].map(|place| (first + place) as u32);
        match ranges.last_mut() {
            Some(last) if last.end == start => last.end = end,
            _ => ranges.push(start..end),
        }
    }

    /// Makes the pipelines that the shown bodies need, and brings the data of all simple bodies of `shot` to
    /// the device, unless they are there or none is shown.
    pub fn load(&mut self, gpu: &Gpu, shot: &Shot<'_>) {
        let shown = self.shown.iter();
        let ranges =
            shown.flat_map(|(&shared, ranges)| ranges.iter().map(move |range| (shared, range.clone())));
        self.batches.refer(gpu, shot, ranges);
        if self.batches.iter().next().is_none() || self.held.as_ref().is_some_and(|held| held.is_of(shot)) {
            return;
        }
        let groups = 0..shot.scene.groups().len();
        let bodies = groups.flat_map(|group| shot.scene.blocks(group).simple_bodies());
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
        Self { scene: shot.scene.clone(), appearance: shot.appearance.copied(), effects }
    }

    fn is_of(&self, shot: &Shot<'_>) -> bool {
        self.scene == *shot.scene
            && self.appearance.as_ref() == shot.appearance
            && Self::effects(shot).eq(self.effects.iter().copied())
    }

    fn effects(shot: &Shot<'_>) -> impl Iterator<Item = Option<Effects>> {
        shot.views.iter().map(|view| Some(view.effects(Turns::Not, shot.appearance?)))
    }
}

impl<'a> BlockView<'a> {
    pub const fn new(view: &'a GroupView, projection: &'a FootprintMap, thin_px: f64) -> Self {
        Self { view, projection, thin_px }
    }

    /// Decides on `block`.
    fn verdict(&self, block: &Block) -> Verdict {
        let middle = self.view.along_motion_from_camera(block.ball.from);
        if self.projection.hides(middle, block.ball.radius) {
            return Verdict::Hidden;
        }
        let is_in_reach = self.view.velocity.speed.gamma() <= MOST_GAMMA
            && DISTANCES.contains(&(middle.length() - block.ball.radius))
            && block.are_simple();
        let lengths = self.projection.lengths_of_a_pixel(middle, block.ball.radius);
        let Some([finest, coarsest]) = lengths.filter(|_| is_in_reach) else {
            return Verdict::Near;
        };
        let [thinnest, thickest] = [block.radii[0] / coarsest, block.radii[1] / finest];
        if block.largest / finest > MOST_PX {
            Verdict::Near
        } else if self.thin_px > 0.0 && thickest <= MOST_THIN_PX {
            Verdict::Placed { is_thin: true }
        } else if thinnest >= self.thin_px {
            Verdict::Placed { is_thin: false }
        } else {
            Verdict::Near
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
        let projections = [Projection::Gaze, Projection::Mercator { right: DVec3::X, shift: 0.0 }];
        let speeds = [0.0, 0.5, 0.99].map(|beta| Speed::from_beta(beta).expect("below 1"));
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

    /// What is told of a block is true of each of its bodies, and the device is left most of those in the
    /// picture that are small.
    #[test]
    fn blocks_are_as_small_as_is_told() {
        let scene = scene();
        for view in views() {
            let group = &scene.group_views(&view)[0];
            let projection = FootprintMap::new(group);
            let decide = BlockView::new(group, &projection, 0.75);
            let (mut placed, mut near) = (0, 0);
            for block in scene.seen_blocks(0, group) {
                let bodies = scene.blocks(0).bodies_of(block).iter();
                let balls = bodies.map(|&body| scene.ball_around(&scene.bodies()[body as usize]));
                let balls: Vec<_> =
                    balls.map(|ball| (group.along_motion_from_camera(ball.from), ball.radius)).collect();
                let verdict = decide.verdict(block);
                if verdict == Verdict::Hidden {
                    assert!(balls.iter().all(|&(centre, radius)| projection.hides(centre, radius)));
                    continue;
                }
                let middle = group.along_motion_from_camera(block.ball.from);
                if let Some([finest, coarsest]) = projection.lengths_of_a_pixel(middle, block.ball.radius) {
                    for (centre, _) in &balls {
                        let seen = projection.apparent_centre(*centre, 0.0).expect("it is seen");
                        let length = match view.camera.mercator() {
                            Some(mercator) => seen.reject_from(DVec3::X).length() / mercator.px_per_unit,
                            None => seen.length() / view.camera.focal_length_px(),
                        };
                        assert!((finest..=coarsest).contains(&length), "{finest} {length} {coarsest}");
                    }
                }
                match verdict {
                    Verdict::Near => near += balls.len(),
                    _ => placed += balls.len(),
                }
            }
            assert!(placed > near && placed > 20, "{placed} placed, {near} near: {view:?}");
        }
    }
}
