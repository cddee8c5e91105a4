//! Outlines of scenes, and the gaze that has an outline in the middle.
//!
//! A ball at rest in the moving frame looks as a ball of the same radius at another place on the ground looks
//! at rest, since aberration maps cones of directions to cones (Penrose 1959); a tube looks as one swept
//! along a curve, which is halved until it is as good as straight, but only where it may reach further than
//! what is known already. So the outline is exact for balls; what is added for other bodies is below a
//! ten-thousandth of their distance. In the contracted geometry a ball is flattened, and the outline is that
//! of the ball around it.

mod reach;

use std::cell::OnceCell;
use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use relativity_core::math::{asinh, sin_cos, tan};

use crate::camera::outline::{Ball, Framing, Outline, Range};
use crate::camera::{Axes, Gaze, MAX_ELEVATION, Projection as PictureProjection};
use crate::geometry::block::Block;
use crate::geometry::capsule::Capsule;
use crate::geometry::shape::Shape;
use crate::picture::footprint::FootprintMap;
use crate::scene::one_cone;
use crate::scene::prepared_body::PreparedBody;
use crate::scene::prepared_scene::{PreparedGroup, PreparedScene};
use crate::view::group_view::GroupView;
use crate::view::{Geometry, View};
use reach::{Across, Reach, Ruled};

/// Bulge of a piece, as it is seen, that is not worth halving it: radians, or units of u.
const SLIGHT_BULGE: f64 = 1e-4;
/// Greatest number of halvings of a piece.
const HALVINGS: u32 = 12;
/// Stride of the bodies that are examined before all others.
const SAMPLED: usize = 23;
/// Number of turns of the gaze to the middle of its outline.
const TURNS: u32 = 2;

impl PreparedScene {
    /// Returns the outline of its [`Self::subject`] in these `views` together, whatever their gazes and
    /// fields.
    #[must_use]
    pub fn outline(&self, views: &[View]) -> Outline {
        let sights = sights(self, views);
        let surrounds = sights.iter().flat_map(|sight| &sight.bodies).any(|body| body.ball.is_none());
        Outline { balls: sights.iter().flat_map(GroupSight::balls).collect(), surrounds }
    }

    /// Returns the framing that holds all of its [`Self::subject`] in these `views`, in their projection;
    /// `None` where there is nothing. Pictures parallel to a baseline have no image shift in it:
    /// [`Framing::shifted`] gives them one. It costs much more than an outline, since it asks each body how
    /// far it reaches.
    #[must_use]
    pub fn framing(&self, views: &[View]) -> Option<Framing> {
        let sights = sights(self, views);
        let balls = sights.iter().flat_map(GroupSight::balls);
        let sum: DVec3 = balls.map(|ball| ball.centre.normalize_or_zero()).sum();
        // From within the balls around all bodies, such as that around a long one nearby, their middles tell
        // where they are.
        let middles = || sights.iter().map(GroupSight::middles).sum::<DVec3>().try_normalize();
        let towards = sum.try_normalize().or_else(middles)?;
        Some(match views[0].camera.projection {
            PictureProjection::Parallel { right, .. } => framed_parallel_to(right, &sights, towards),
            PictureProjection::Mercator { right, .. } => framed_about(right, &sights, towards),
            PictureProjection::Gaze | PictureProjection::Vr180 { .. } => framed(&sights, towards),
        })
    }
}

/// A group, as one view sees it; everything is in axes along its motion.
struct GroupSight<'a> {
    /// The number of the view.
    eye: usize,
    view: GroupView,
    projection: FootprintMap,
    bodies: Vec<SeenBody<'a>>,
}

/// A body of the group, as it is seen.
struct SeenBody<'a> {
    /// Image of the ball around the body; `None` from inside.
    ball: Option<Ball>,
    /// Image of the middle of that ball, from inside.
    middle: Option<DVec3>,
    bounds: BodyBounds<'a>,
    /// Images of its pieces, once they were needed.
    images: OnceCell<Vec<Option<Image>>>,
}

/// The bounds of a body.
enum BodyBounds<'a> {
    Capsules(&'a [Capsule]),
    Block(Block),
    /// The hull of a ring, whatever the time: what is seen stays framed alike while wheels turn.
    Turning(Shape),
}

/// The image of a tube.
#[derive(Debug, Clone, Copy)]
struct Image {
    piece: Capsule,
    /// The centres of the balls that its ends look like.
    ends: [DVec3; 2],
    /// Greatest distance from the straight tube between the ends.
    bulge: DVec3,
}

impl SeenBody<'_> {
    /// Tubes that reach as far as it does. Of a block its edges do, wherever they are seen.
    fn pieces(&self) -> Vec<Capsule> {
        match &self.bounds {
            BodyBounds::Capsules(capsules) => capsules.to_vec(),
            BodyBounds::Block(block) => block.edges().collect(),
            BodyBounds::Turning(ring) => ring.capsules(),
        }
    }
}

/// The subject of `scene` as each of the `views` sees it.
fn sights<'a>(scene: &'a PreparedScene, views: &[View]) -> Vec<GroupSight<'a>> {
    let of_view = |eye, view: View| {
        scene.subject().map(move |group| GroupSight::new(eye, scene, group, &view.of_group(group.motion)))
    };
    let as_seen =
        views.iter().enumerate().flat_map(|(eye, view)| as_seen(scene, view).map(move |view| (eye, view)));
    as_seen.flat_map(|(eye, view)| of_view(eye, view)).collect()
}

/// Returns the framing of everything seen in pictures parallel to the `baseline`; `towards` is somewhere in
/// the midst of it.
fn framed_parallel_to(baseline: DVec3, sights: &[GroupSight], towards: DVec3) -> Framing {
    let axes = Axes::across(baseline, towards);
    // Angles up are about the baseline, the same from every axis.
    let (sine, cosine) = sin_cos(middle(reach(sights, &axes)[1]));
    let axes = Axes::upright(axes.right, axes.forward * cosine + axes.up * sine);
    let last = sights.last().map_or(0, |sight| sight.eye);
    let of_eye = |eye| reach(sights.iter().filter(|sight| sight.eye == eye), &axes)[0];
    Framing::sheared(axes, [of_eye(0), of_eye(last)], |turned| reach(sights, turned)[1])
}

/// Frames all that is seen in conformal pictures with their poles at the ends of the `baseline`; `towards` is
/// somewhere in the midst of it.
fn framed_about(baseline: DVec3, sights: &[GroupSight], towards: DVec3) -> Framing {
    let axes = Axes::across(baseline, towards);
    let last = sights.last().map_or(0, |sight| sight.eye);
    let [left, right] = [0, last].map(|eye| {
        let mut found = Reach::NOWHERE;
        for sight in sights.iter().filter(|sight| sight.eye == eye) {
            sight.widen(&axes, Across::Baseline, &mut found);
        }
        found
    });
    let column = |angle: f64| {
        if angle.abs() < FRAC_PI_2 { asinh(tan(angle)) } else { f64::INFINITY.copysign(angle) }
    };
    let columns = [left, right].map(|reach| reach.across.angles().map(column));
    let [low, high] = left.up.union(&right.up).angles();
    let (sine, cosine) = sin_cos(0.5 * (low + high));
    let axes = Axes::upright(axes.right, axes.forward * cosine + axes.up * sine);
    Framing::slid(axes, columns, 0.5 * (high - low))
}

/// Returns the framing of everything seen in pictures across the gaze; `towards` is somewhere in the midst of
/// it.
fn framed(sights: &[GroupSight], towards: DVec3) -> Framing {
    let reach = |gaze: &Gaze| reach(sights, &gaze.axes());
    let mut gaze = Gaze { elevation: 0.0, ..Gaze::along(towards.to_array()) };
    // Level at first, so that azimuths are exact however wide it is.
    for _ in 0..TURNS {
        let [across, up] = reach(&gaze).map(middle);
        gaze.azimuth -= across / sin_cos(gaze.elevation).1.max(0.1);
        gaze.elevation = tilted(gaze.elevation + up);
    }
    Framing::level(gaze, reach(&gaze).map(|[low, high]| (-low).max(high)))
}

fn middle([low, high]: Range) -> f64 {
    0.5 * (low + high)
}

fn tilted(elevation: f64) -> f64 {
    elevation.clamp(-MAX_ELEVATION, MAX_ELEVATION)
}

/// Between which angles from the optical axis, across and up, all that is seen lies.
fn reach<'a>(sights: impl IntoIterator<Item = &'a GroupSight<'a>>, axes: &Axes) -> [Range; 2] {
    let mut found = Reach::NOWHERE;
    for sight in sights {
        sight.widen(axes, Across::Upright, &mut found);
    }
    [found.across, found.up].map(|wedge| wedge.angles())
}

/// The views whose rays show what `view` shows of `scene`. In the published model the right eye sees of each
/// point what the left eye saw at most the eyes' separation earlier or later; with one light cone each eye
/// what it sees a little earlier or later. In between a body moves along a straight line.
fn as_seen(scene: &PreparedScene, view: &View) -> impl Iterator<Item = View> + use<> {
    let delay = 2.0 * view.camera.aperture.x;
    let (geometry, delays) = match view.geometry {
        Geometry::Published => (Geometry::Seen, [Some(-delay), Some(delay)]),
        Geometry::OneCone => (Geometry::Seen, one_cone::delays(scene, view).map(Some)),
        geometry => (geometry, [Some(0.0), None]),
    };
    let view = *view;
    let at = move |delay| View { geometry, observation_time: view.observation_time + delay, ..view };
    delays.into_iter().flatten().map(at)
}

impl<'a> GroupSight<'a> {
    fn new(eye: usize, scene: &'a PreparedScene, group: &PreparedGroup, view: &GroupView) -> Self {
        let projection = FootprintMap::new(view);
        let seen = |body: &PreparedBody| {
            let around = scene.ball_around(body);
            let centre =
                projection.apparent_centre(view.along_motion_from_camera(around.from), around.radius);
            let ball = centre.map(|centre| Ball { centre, radius: around.radius });
            let point = || projection.apparent_centre(view.along_motion_from_camera(around.from), 0.0);
            let middle = if ball.is_none() { point() } else { None };
            let bounds = match (scene.turning(body.number), &body.block) {
                (Some(turning), _) => BodyBounds::Turning(turning.ring_around()),
                (None, Some(block)) => BodyBounds::Block(**block),
                (None, None) => BodyBounds::Capsules(scene.capsules(body)),
            };
            SeenBody { ball, middle, bounds, images: OnceCell::new() }
        };
        let bodies = scene.bodies()[group.bodies.clone()].iter().map(seen).collect();
        Self { eye, view: *view, projection, bodies }
    }

    /// The balls that look like those around the bodies, on the ground.
    fn balls(&self) -> impl Iterator<Item = Ball> {
        let balls = self.bodies.iter().filter_map(|body| body.ball);
        balls.map(|ball| Ball { centre: self.view.velocity.camera_from_motion(ball.centre), ..ball })
    }

    /// The sum of the directions in which the middles of the bodies are seen, on the ground.
    fn middles(&self) -> DVec3 {
        let middles = self.bodies.iter().filter_map(|body| body.middle);
        middles.map(|middle| self.view.velocity.camera_from_motion(middle).normalize_or_zero()).sum()
    }

    /// Widens `found` so that it holds every body.
    fn widen(&self, axes: &Axes, across: Across, found: &mut Reach) {
        let [right, up, forward] =
            [axes.right, axes.up, axes.forward].map(|v| self.view.velocity.motion_from_camera(v));
        let axes = Axes { right, up, forward };
        let axes = &Ruled { axes, across };
        // A sample comes first: few of the others reach further then.
        for number in (0..self.bodies.len()).step_by(SAMPLED).chain(0..self.bodies.len()) {
            let body = &self.bodies[number];
            if body.ball.is_some_and(|ball| found.holds(&ball, axes)) {
                continue;
            }
            let image = |piece: &Capsule| self.image(&piece.along_motion_from_camera(&self.view));
            for image in body.images.get_or_init(|| body.pieces().iter().map(image).collect()) {
                self.widen_by(image.as_ref(), HALVINGS, axes, found);
            }
        }
    }

    /// Widens `found` so that it holds a piece with this image.
    fn widen_by(&self, image: Option<&Image>, halvings: u32, axes: &Ruled, found: &mut Reach) {
        let Some(&Image { piece, ends, bulge }) = image else {
            *found = Reach::EVERYWHERE;
            return;
        };
        let ball = |centre| Ball { centre, radius: piece.radius };
        for end in ends {
            found.widen(&ball(end), axes);
        }
        let beyond = ends.map(|end| ball(end + bulge));
        let sag = axes.sag(ends.map(|end| end + 0.5 * bulge));
        if beyond.iter().all(|ball| found.holds_nearer(ball, sag, axes)) {
            return;
        }
        let seen_bulge = ends.iter().map(|&end| axes.seen_size(bulge, sag, end)).fold(0.0, f64::max);
        if halvings == 0 || seen_bulge <= SLIGHT_BULGE {
            for ball in &beyond {
                found.widen_nearer(ball, sag, axes);
            }
            return;
        }
        for half in piece.halves() {
            self.widen_by(self.image(&half).as_ref(), halvings - 1, axes, found);
        }
    }

    /// Returns the image of a piece, from the camera's event; `None` where it has none.
    fn image(&self, piece: &Capsule) -> Option<Image> {
        let first = self.projection.apparent_centre(piece.from, piece.radius)?;
        let last = self.projection.apparent_centre(piece.to, piece.radius)?;
        Some(Image { piece: *piece, ends: [first, last], bulge: self.projection.bulge(piece)? })
    }
}
