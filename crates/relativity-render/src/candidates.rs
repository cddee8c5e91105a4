//! A picture in tiles, and those bodies that each of them may show which no hierarchy knows: what turns, and what is seen
//! along rays that curve.

use relativity_core::threads::prelude::*;

use crate::camera::LinesOfSight;
use crate::cone::Cone;
use crate::group_view::GroupView;
use crate::prepared_body::PreparedBody;
use crate::scene::PreparedScene;
use crate::tiles::{TILE_SIDE, Tile, bands};
use crate::view::View;

/// How long the balls are that follow what turns, in parts of how far that reaches from its axle.
const BALLS: f64 = 0.15;

/// A tile of a picture.
pub(crate) struct TileLook {
    /// Its pixels.
    pub tile: Tile,
    /// Around its lines of sight.
    pub cone: Cone,
    /// The numbers, which ascend, of bodies that may be seen there, of those in no hierarchy of their group.
    pub others: Vec<u32>,
}

impl PreparedScene {
    /// One value per pixel of `view`, row by row: `draw` is given each tile, and all the rows of pixels that it is in.
    pub(crate) fn tiles<T: Clone + Default + Send>(
        &self,
        view: &View,
        group_views: &[GroupView],
        draw: impl Fn(TileLook, &mut [T]) + Sync,
    ) -> Vec<T> {
        let (mut cones, mut owners) = (Vec::new(), Vec::new());
        let keeps_place = |body: &PreparedBody| {
            self.turning(body.number).is_none() && group_views[body.group].has_straight_rays()
        };
        for body in self.bodies().iter().filter(|body| !keeps_place(body)) {
            self.add_cones(body, &group_views[body.group], &mut cones);
            owners.resize(cones.len(), body.number as u32);
        }
        let lines_of_sight = LinesOfSight::new(&view.camera);
        let bands = bands(&view.camera, &cones);
        let [width, height] = view.camera.size.map(|side| side as usize);
        let mut image = vec![T::default(); width * height];
        let rows = image.par_chunks_mut((width * TILE_SIDE as usize).max(1));
        rows.zip(bands).for_each(|(rows, band)| {
            for (tile, cones) in band {
                let mut others: Vec<u32> = cones.iter().map(|&cone| owners[cone as usize]).collect();
                others.dedup();
                draw(TileLook { tile, cone: tile.cone(&lines_of_sight), others }, rows);
            }
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
