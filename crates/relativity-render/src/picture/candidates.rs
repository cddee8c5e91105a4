//! A picture in tiles, and what each of them may show: which groups, and which bodies that no hierarchy
//! knows, as they turn or are seen along rays that curve.

use std::borrow::Cow;

use relativity_core::threads::{self, prelude::*};

use super::tiles::{TILE_SIDE, Tile};
use crate::camera::lines_of_sight::LinesOfSight;
use crate::scene::prepared_body::PreparedBody;
use crate::scene::prepared_scene::PreparedScene;
use crate::view::View;
use crate::view::cap::Cap;
use crate::view::cone::Cone;
use crate::view::group_view::GroupView;

/// Length of the balls that follow a turning body, as a part of its reach from the axle.
const BALLS: f64 = 0.15;

/// Smallest side of a part of a picture, px, that is tested for showing anything: testing a smaller one costs
/// more than it saves.
const LEAST_ASKED: u32 = 2 * TILE_SIDE;

/// Rows of pixels that one thread draws at a time.
pub const BAND: u32 = 2 * TILE_SIDE;

/// A tile of a picture, and what may be seen in it.
pub(crate) struct TileLook<'a> {
    /// Tile that the rows belong to.
    pub tile: Tile,
    /// Around its lines of sight; `None` far from all bodies.
    pub cap: Option<Cap>,
    /// The numbers, which ascend, of the groups of which something may be seen there.
    pub groups: &'a [u32],
    /// The numbers, which ascend, of bodies that may be seen there, of those in no hierarchy of their group.
    pub others: &'a [u32],
}

/// Rows of pixels, from the first of a tile's on or before it.
pub(crate) struct PixelRows<'a, T> {
    values: &'a mut [T],
    width: usize,
    top: u32,
}

impl<T> PixelRows<'_, T> {
    /// Writes the value of a pixel.
    pub fn put(&mut self, [u, v]: [u32; 2], value: T) {
        self.values[(v - self.top) as usize * self.width + u as usize] = value;
    }
}

/// The fixed data of a division of a picture.
struct PictureDivision<'a> {
    scene: &'a PreparedScene,
    views: &'a [GroupView],
    lines_of_sight: LinesOfSight,
    /// Caps in the sky of bodies outside any hierarchy, and the numbers of these bodies, ascending.
    others: Vec<(Cap, u32)>,
}

/// The bodies that may be seen in a part of a picture; numbers ascend.
#[derive(Default)]
struct Candidates<'a> {
    /// Numbers of the groups.
    groups: Cow<'a, [u32]>,
    /// Numbers into the list of others of the division, all of these groups.
    others: Vec<u32>,
}

impl PreparedScene {
    /// Returns one value per pixel of `view`, row by row: `draw` is called with each tile and the rows of
    /// pixels to write into. What is not `wanted` when it would begin, by the first row of its band, keeps
    /// the default, and so does all after the work of this thread was given up.
    pub(crate) fn tiles<T: Clone + Default + Send>(
        &self,
        view: &View,
        group_views: &[GroupView],
        wanted: &(dyn Fn(u32) -> bool + Sync),
        draw: impl Fn(&TileLook<'_>, &mut PixelRows<'_, T>) + Sync,
    ) -> Vec<T> {
        let [width, height] = view.camera.size;
        // By all threads: the first touch of so much memory takes its time.
        let count = width as usize * height as usize;
        let mut image: Vec<_> = (0..count).into_par_iter().map(|_| T::default()).collect();
        if image.is_empty() {
            return image;
        }
        let division = PictureDivision::new(self, view, group_views);
        let bands = image.par_chunks_mut(width as usize * BAND as usize).enumerate();
        let (goes_on, done) = (threads::goes_on(), threads::in_parts(height.div_ceil(BAND)));
        bands.filter(|(number, _)| wanted(*number as u32 * BAND)).for_each(|(number, values)| {
            let top = number as u32 * BAND;
            let tile = Tile { corner: [0, top], size: [width, BAND.min(height - top)] };
            let mut rows = PixelRows { values, width: width as usize, top };
            let groups = (0..group_views.len() as u32).collect();
            let all = Candidates { groups, others: (0..division.others.len() as u32).collect() };
            division.divide(tile, &all, &mut |look| {
                if goes_on() && wanted(top) {
                    draw(look, &mut rows);
                }
            });
            done();
        });
        image
    }

    /// Adds cones to `out` in one of which `view` shows what it shows of `body`.
    fn add_cones(&self, body: &PreparedBody, view: &GroupView, out: &mut Vec<Cone>) {
        let (Some(turning), Some(spin)) = (self.turning(body.number), &body.spin) else {
            let solid = self.solid(body.number);
            out.push(Cone::of_sight(view, solid.centre(), solid.bounding_radius()));
            return;
        };
        let (mut capsules, mut balls) = (Vec::new(), Vec::new());
        view.capsules_when_shown(spin, self.around(body), &mut capsules);
        let longest = BALLS * turning.ball_around().1;
        for capsule in &capsules {
            capsule.add_balls(longest, &mut balls);
        }
        out.extend(balls.iter().map(|ball| Cone::of_sight(view, ball.from, ball.radius)));
    }
}

impl<'a> PictureDivision<'a> {
    fn new(scene: &'a PreparedScene, view: &View, views: &'a [GroupView]) -> Self {
        let (mut cones, mut others) = (Vec::new(), Vec::new());
        let mut add = |body: &PreparedBody| {
            scene.add_cones(body, &views[body.group], &mut cones);
            others.extend(cones.drain(..).map(|cone| (Cap::from(cone), body.number as u32)));
        };
        for (group, view) in scene.groups().iter().zip(views) {
            let bodies = group.bodies.clone();
            if !view.has_straight_rays() {
                scene.bodies()[bodies].iter().for_each(&mut add);
                continue;
            }
            scene.turning_in(bodies).for_each(|body| add(&scene.bodies()[body]));
        }
        Self { scene, views, lines_of_sight: view.camera.lines_of_sight(), others }
    }

    /// Has all least tiles of `tile` drawn, in which nothing but the `candidates` may be seen.
    fn divide(&self, tile: Tile, candidates: &Candidates<'_>, draw: &mut impl FnMut(&TileLook<'_>)) {
        let cap = (!candidates.groups.is_empty()).then(|| tile.cap(&self.lines_of_sight));
        let [width, height] = tile.size;
        let is_asked = width.max(height) > LEAST_ASKED;
        let shown = cap.map(|cap| self.among(candidates, &cap, is_asked)).unwrap_or_default();
        if tile.is_least() {
            let mut others: Vec<u32> = shown.others.iter().map(|&other| self.body(other)).collect();
            others.dedup();
            draw(&TileLook { tile, cap, groups: &shown.groups, others: &others });
            return;
        }
        for half in tile.halves() {
            self.divide(half, &shown, draw);
        }
    }

    /// Returns those of the `candidates` that may be seen in `cap`; groups are left out only if `is_asked`.
    fn among<'b>(&self, candidates: &'b Candidates<'_>, cap: &Cap, is_asked: bool) -> Candidates<'b> {
        let meets = |other: &u32| self.others[*other as usize].0.meets(cap);
        let others: Vec<u32> = candidates.others.iter().copied().filter(meets).collect();
        if !is_asked {
            return Candidates { groups: Cow::Borrowed(&candidates.groups), others };
        }
        let mut of_others: Vec<_> =
            others.iter().map(|&other| self.scene.group_of(self.body(other) as usize)).collect();
        of_others.dedup();
        let shows = |group: usize| of_others.binary_search(&group).is_ok() || self.shows_standing(group, cap);
        let groups = candidates.groups.iter().copied().filter(|&group| shows(group as usize)).collect();
        Candidates { groups, others }
    }

    /// The number of the body that this one of the others is of.
    fn body(&self, other: u32) -> u32 {
        self.others[other as usize].1
    }

    /// Whether anything in the hierarchy of the group of this number may be seen in `cap`.
    fn shows_standing(&self, group: usize, cap: &Cap) -> bool {
        let view = &self.views[group];
        let hierarchy = self.scene.hierarchy(group, view);
        let beam = self.scene.beam(group, view, cap);
        beam.map_or(!hierarchy.is_empty(), |beam| hierarchy.is_met(&beam))
    }
}
