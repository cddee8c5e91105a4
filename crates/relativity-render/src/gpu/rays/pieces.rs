//! Bodies as what the GPU draws: pieces, each a bounding rectangle with the whole body's data.
//!
//! Every piece tests the ray against its whole body, so where the rectangles of one body overlap they
//! agree to the bit, and a strict depth test draws each pixel once.

use std::collections::BTreeMap;
use std::slice::{self, Iter};

use relativity_core::threads::prelude::*;

use super::crowd::{ClusterView, Crowd};
use super::piece::{Piece, THIN_PX};
use crate::geometry::capsule::Capsule;
use crate::geometry::kind::Kind;
use crate::gpu::drawing::{Shot, Trait};
use crate::picture::footprint::{Bound, Footprint, FootprintMap, Rectangle};
use crate::scene::prepared_body::PreparedBody;
use crate::scene::prepared_scene::PreparedScene;
use crate::scene::wheel::packed::Turns;
use crate::view::Geometry;
use crate::view::group_view::GroupView;

/// Number of halvings after which the bound of a piece is taken as it is: 32 rectangles follow the most bent
/// of tubes, and a looser bound only costs time.
const MAX_HALVINGS: u32 = 5;

/// Bodies that one thread places before it asks for more: 0.15 ms, beside which a thread costs little.
const PLACED_TOGETHER: usize = 64;

/// The bounds in which bodies are searched for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Bounds {
    /// Tight bounds around where they can appear.
    #[default]
    Tight,
    /// Everywhere: what tight bounds are measured against.
    None,
}

/// The pieces of a view, solid before thin, group by group, kind by kind, plain before patterned, bodies that
/// do not turn before turning ones, else in the order of the bodies: where surfaces of two coincide, the
/// first that is drawn stays. Kept from view to view, for its memory.
#[derive(Debug, Default)]
pub struct Pieces {
    lists: BTreeMap<Trait<()>, Vec<Piece>>,
    /// The numbers of bodies that may be in the picture.
    candidates: Vec<u32>,
    /// Results of the tasks that place the candidates, in the candidates' order.
    placed: Vec<PlacedPieces>,
}

impl Pieces {
    /// Replaces all by the pieces of `shot` in groups whose views are `meant`, but for those of bodies that
    /// join the `crowd`. In numbers nothing is faded, so none is thin there.
    pub fn refill(
        &mut self,
        crowd: &mut Crowd,
        shot: &Shot<'_>,
        bounds: Bounds,
        meant: impl Fn(&GroupView) -> bool,
    ) {
        let thin_px = if shot.appearance.is_some() { THIN_PX } else { 0.0 };
        self.lists.values_mut().for_each(Vec::clear);
        crowd.clear();
        for (number, view) in shot.views.iter().enumerate().filter(|(_, view)| meant(view)) {
            let projection = FootprintMap::new(view);
            self.candidates.clear();
            let decide = ClusterView::new(view, &projection, shot.appearance.is_some());
            match bounds {
                Bounds::Tight => crowd.divide(shot.scene, number, &decide, &mut self.candidates),
                Bounds::None => {
                    let bodies = shot.scene.groups()[number].bodies.clone();
                    self.candidates.extend(bodies.map(|body| body as u32));
                }
            }
            let place = |(placed, bodies): (&mut PlacedPieces, &[u32])| {
                placed.pieces.clear();
                for &body in bodies {
                    let body = &shot.scene.bodies()[body as usize];
                    match bounds {
                        Bounds::Tight => placed.bound(&projection, view, shot.scene, body),
                        Bounds::None => placed.bound_nowhere(),
                    }
                    placed.add(body, shot, thin_px);
                }
            };
            let bodies = self.candidates.par_chunks(PLACED_TOGETHER);
            let count = bodies.len();
            self.placed.resize_with(self.placed.len().max(count), PlacedPieces::default);
            let placed = &mut self.placed[..count];
            placed.par_iter_mut().zip(bodies).for_each(place);
            // In the order of the bodies, however many threads there are.
            for &(shared, piece) in placed.iter().flat_map(|placed| &placed.pieces) {
                self.lists.entry(shared).or_default().push(piece);
            }
        }
    }

    /// Returns the runs of pieces that one draw draws, in order.
    pub fn runs(&self) -> impl Iterator<Item = (Trait<()>, Iter<'_, Piece>)> {
        let filled = self.lists.iter().filter(|(_, list)| !list.is_empty());
        filled.map(|(&shared, list)| (shared, list.iter()))
    }
}

/// The pieces of some bodies, and what they are found with.
#[derive(Debug, Default)]
struct PlacedPieces {
    pieces: Vec<(Trait<()>, Piece)>,
    /// Rectangles in which the last body is.
    rectangles: Vec<Rectangle>,
    /// Capsules that contain the last body that turns.
    shown: Vec<Capsule>,
}

impl PlacedPieces {
    /// The pieces of `body` in the rectangles just found.
    fn add(&mut self, body: &PreparedBody, shot: &Shot<'_>, thin_px: f64) {
        let &PreparedBody { group, kind, is_patterned, .. } = body;
        let (piece, turns) = (Piece::new(body, shot), shot.views[group].turns(body));
        for rectangle in &self.rectangles {
            // Each sample of a model looks for itself, however thin that is.
            let is_thin = rectangle.radius_px < thin_px && kind != Kind::Model;
            let shared = Trait { is_thin, group, kind, is_patterned, turns, template: () };
            self.pieces.push((shared, piece.placed(rectangle)));
        }
    }

    fn bound(
        &mut self,
        projection: &FootprintMap,
        view: &GroupView,
        scene: &PreparedScene,
        body: &PreparedBody,
    ) {
        self.rectangles.clear();
        match (body.spin, &body.block) {
            (Some(spin), _) if view.turns(body) == Turns::About => {
                self.shown.clear();
                view.capsules_when_shown(&spin, scene.around(body), &mut self.shown);
                let radius = least_shown(body.placement.place_radius[3].into(), view);
                for capsule in &self.shown {
                    let first = self.rectangles.len();
                    add_capsules(projection, view, slice::from_ref(capsule), &mut self.rectangles);
                    for rectangle in &mut self.rectangles[first..] {
                        rectangle.radius_px *= radius / capsule.radius;
                    }
                }
            }
            (_, Some(block)) => {
                let block = block.along_motion_from_camera(view);
                add_rectangles(projection, &block, MAX_HALVINGS, &mut self.rectangles);
            }
            _ => add_capsules(projection, view, scene.capsules(body), &mut self.rectangles),
        }
        if self.rectangles.contains(&Rectangle::EVERYWHERE) {
            self.bound_nowhere();
        }
    }

    fn bound_nowhere(&mut self) {
        self.rectangles.clear();
        self.rectangles.push(Rectangle::EVERYWHERE);
    }
}

/// Half the width that a body of this `radius` which turns is shown with at least: light stretches it, and at
/// one time of the ground it is sheared by what moves at less than 1.
fn least_shown(radius: f64, view: &GroupView) -> f64 {
    if view.geometry == Geometry::Contracted { 0.5 * radius } else { radius }
}

fn add_capsules(projection: &FootprintMap, view: &GroupView, capsules: &[Capsule], out: &mut Vec<Rectangle>) {
    for capsule in capsules {
        add_rectangles(projection, &capsule.along_motion_from_camera(view), MAX_HALVINGS, out);
    }
}

fn add_rectangles<B: Bound>(projection: &FootprintMap, bound: &B, halvings: u32, out: &mut Vec<Rectangle>) {
    let is_whole = halvings == 0 || bound.is_point();
    match bound.footprint(projection) {
        Some(Footprint::Hidden) => {}
        Some(Footprint::Inside(rectangle)) if is_whole || !rectangle.is_loose => out.push(rectangle),
        None if is_whole => out.push(Rectangle::EVERYWHERE),
        Some(Footprint::Inside(_)) | None => {
            for half in bound.halves() {
                add_rectangles(projection, &half, halvings - 1, out);
            }
        }
    }
}
