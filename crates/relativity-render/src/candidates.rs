//! A picture in tiles, and those bodies that each of them may show which no hierarchy knows: what turns, and what is seen
//! along rays that curve.

use relativity_core::threads::prelude::*;

use crate::camera::LinesOfSight;
use crate::cap::Cap;
use crate::cone::Cone;
use crate::group_view::GroupView;
use crate::prepared_body::PreparedBody;
use crate::scene::PreparedScene;
use crate::tiles::{TILE_SIDE, Tile};
use crate::view::View;

/// How long the balls are that follow what turns, in parts of how far that reaches from its axle.
const BALLS: f64 = 0.15;

/// Smaller parts of a picture, px, are not asked whether they show anything: that would cost what it spares.
const LEAST_ASKED: u32 = 2 * TILE_SIDE;

/// Rows of pixels that one thread draws at a time.
const BAND: u32 = 2 * TILE_SIDE;

/// A tile of a picture, and what may be seen in it.
pub(crate) struct TileLook<'a> {
    /// Its pixels.
    pub tile: Tile,
    /// Around its lines of sight; `None` far from all bodies.
    pub cap: Option<Cap>,
    /// The numbers, which ascend, of bodies that may be seen there, of those in no hierarchy of their group.
    pub others: &'a [u32],
}

/// Rows of pixels, from the first of a tile's on or before it.
pub(crate) struct Rows<'a, T> {
    values: &'a mut [T],
    width: usize,
    top: u32,
}

impl<T> Rows<'_, T> {
    /// Writes a pixel.
    pub fn put(&mut self, [u, v]: [u32; 2], value: T) {
        self.values[(v - self.top) as usize * self.width + u as usize] = value;
    }
}

/// What is asked while a picture is divided.
struct Division<'a> {
    scene: &'a PreparedScene,
    views: &'a [GroupView],
    lines_of_sight: LinesOfSight,
    /// Where in the sky those are that no hierarchy knows, and their numbers, which ascend.
    others: Vec<(Cap, u32)>,
}

impl PreparedScene {
    /// One value per pixel of `view`, row by row: `draw` is given each tile, and the rows of pixels to write it into. The
    /// default is in rows that would begin when it no longer `goes_on`.
    pub(crate) fn tiles<T: Clone + Default + Send>(
        &self,
        view: &View,
        group_views: &[GroupView],
        goes_on: &(dyn Fn() -> bool + Sync),
        draw: impl Fn(&TileLook<'_>, &mut Rows<'_, T>) + Sync,
    ) -> Vec<T> {
        let [width, height] = view.camera.size;
        // By all threads: the first touch of so much memory takes its time.
        let count = width as usize * height as usize;
        let mut image: Vec<_> = (0..count).into_par_iter().map(|_| T::default()).collect();
        if image.is_empty() {
            return image;
        }
        let division = Division::new(self, view, group_views);
        let bands = image.par_chunks_mut(width as usize * BAND as usize).enumerate();
        bands.filter(|_| goes_on()).for_each(|(number, values)| {
            let top = number as u32 * BAND;
            let tile = Tile { corner: [0, top], size: [width, BAND.min(height - top)] };
            let mut rows = Rows { values, width: width as usize, top };
            let all: Vec<u32> = (0..division.others.len() as u32).collect();
            division.divide(tile, true, &all, &mut |look| draw(look, &mut rows));
        });
        image
    }

    /// Adds cones to `out` in one of which `view` shows what it shows of `body`.
    fn add_cones(&self, body: &PreparedBody, view: &GroupView, out: &mut Vec<Cone>) {
        let (Some(turning), Some(spin)) = (self.turning(body.number), &body.spin) else {
            let solid = self.solid(body.number);
            out.push(Cone::of_sight(view, solid.center(), solid.bounding_radius()));
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

impl<'a> Division<'a> {
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
            let turning = scene.spinning_in(bodies).filter(|&body| scene.turning(body).is_some());
            turning.for_each(|body| add(&scene.bodies()[body]));
        }
        Self { scene, views, lines_of_sight: LinesOfSight::new(&view.camera), others }
    }

    /// Has all least tiles of `tile` drawn, in which of the others only `candidates` may be seen (numbers into the list), and
    /// bodies at all only if it `may_show` some.
    fn divide(&self, tile: Tile, may_show: bool, candidates: &[u32], draw: &mut impl FnMut(&TileLook<'_>)) {
        let cap = may_show.then(|| tile.cap(&self.lines_of_sight));
        let others: Vec<u32> = match &cap {
            Some(cap) => {
                let meets = |number: &u32| self.others[*number as usize].0.meets(cap);
                candidates.iter().copied().filter(meets).collect()
            }
            None => Vec::new(),
        };
        if tile.is_least() {
            let mut numbers: Vec<u32> = others.iter().map(|&number| self.others[number as usize].1).collect();
            numbers.dedup();
            draw(&TileLook { tile, cap, others: &numbers });
            return;
        }
        let [width, height] = tile.size;
        let is_asked = width.max(height) > LEAST_ASKED;
        let shows = |cap: &Cap| !is_asked || !others.is_empty() || self.shows_standing(cap);
        let may_show = cap.as_ref().is_some_and(shows);
        for half in tile.halves() {
            self.divide(half, may_show, &others, draw);
        }
    }

    /// Whether anything in the hierarchies may be seen in `cap`.
    fn shows_standing(&self, cap: &Cap) -> bool {
        self.views.iter().enumerate().any(|(group, view)| {
            let hierarchy = self.scene.hierarchy(group);
            self.scene.beam(group, view, cap).map_or(!hierarchy.is_empty(), |beam| hierarchy.is_met(&beam))
        })
    }
}
