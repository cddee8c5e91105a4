//! The outline of what a scene is about, as one or several apertures see it, and the gaze and field of view that hold
//! all of it.
//!
//! A ball at rest in the moving frame looks as a ball of the same radius at another place on the ground looks at rest,
//! since aberration maps cones of directions to cones (Penrose 1959); a tube looks as one swept along a curve, which is
//! halved until it is as good as straight, but only where it may reach further than what is known already. So the
//! outline is exact for balls; what is added for other bodies is below a ten-thousandth of their distance. In the
//! contracted geometry a ball is flattened, and the outline is that of the ball around it.

use glam::DVec3;
use relativity_core::math::{atan, sin_cos, tan};

use crate::camera::{Axes, Camera, Gaze, MAX_ELEVATION};
use crate::capsule::{Block, Capsule};
use crate::footprint::Projection;
use crate::group_view::GroupView;
use crate::prepared_body::PreparedBody;
use crate::scene::{PreparedGroup, PreparedScene};
use crate::view::{Geometry, View};

/// The part of the picture that is left free on each side of what is framed.
const MARGIN: f64 = 0.1;
/// Narrowest horizontal field of view that frames, radians: something small or far is shown with what is around it.
const NARROWEST: f64 = 42.0 * DEGREE;
/// Widest horizontal field of view that frames, radians. What reaches further is cropped.
const WIDEST: f64 = 150.0 * DEGREE;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Bulge of a piece, in parts of its distance, that is not worth halving it.
const SLIGHT_BULGE: f64 = 1e-4;
/// How often a piece is halved at most.
const HALVINGS: u32 = 12;
/// How often the gaze is turned to the middle of what it frames.
const TURNS: u32 = 2;

/// What a scene is about ([`PreparedScene::subject`]), from one or several parallel apertures.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Balls at rest on the ground, each from its aperture, that look like balls around its bodies.
    balls: Vec<Ball>,
    /// Whether an aperture is inside one of these, or as good as inside.
    surrounds: bool,
    framing: Option<Framing>,
}

/// The gaze that has an outline in the middle of the picture, both ways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Framing {
    /// It.
    pub gaze: Gaze,
    /// How far the outline reaches from there, radians: across and up, as angles between planes through the picture's
    /// upright and level lines.
    reach: [f64; 2],
}

/// A ball, from the aperture.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ball {
    center: DVec3,
    radius: f64,
}

/// One group, as one view sees it; all is reflected so that the group moves along +x.
struct Sight<'a> {
    view: GroupView,
    projection: Projection,
    bodies: Vec<Seen<'a>>,
}

/// A body.
struct Seen<'a> {
    /// What the ball around it looks like; `None` from inside.
    ball: Option<Ball>,
    capsules: &'a [Capsule],
    block: Option<Block>,
}

impl Seen<'_> {
    /// Tubes that reach as far as it does. Of a block its edges do, wherever they are seen.
    fn pieces(&self) -> impl Iterator<Item = Capsule> {
        let edges = self.block.iter().flat_map(Block::edges);
        self.capsules.iter().copied().chain(edges)
    }
}

impl Outline {
    /// That of `scene` in all `views` together, whatever their gazes and fields.
    pub(crate) fn new(scene: &PreparedScene, views: &[View]) -> Self {
        let groups = || scene.subject().collect::<Vec<_>>();
        let sights = views.iter().flat_map(as_seen).flat_map(|view| {
            groups().into_iter().map(move |group| Sight::new(scene, group, view.of_group(group.motion)))
        });
        let sights: Vec<_> = sights.collect();
        let balls = |sight: &Sight| sight.balls().collect::<Vec<_>>();
        let balls: Vec<_> = sights.iter().flat_map(balls).collect();
        let surrounds = sights.iter().flat_map(|sight| &sight.bodies).any(|body| body.ball.is_none());
        let sum = balls.iter().map(|ball| ball.center.normalize_or_zero()).sum();
        Self { balls, surrounds, framing: framed(&sights, sum) }
    }

    /// How to hold all of it in a picture; `None` where there is nothing.
    #[must_use]
    pub const fn framing(&self) -> Option<Framing> {
        self.framing
    }

    /// Whether nothing of it is in the picture of a `camera` at its apertures, taking each body for the ball around it.
    #[must_use]
    pub fn is_out_of(&self, camera: &Camera) -> bool {
        let axes = camera.gaze.axes();
        let half_width = tan(0.5 * camera.horizontal_fov);
        let half_height = half_width * f64::from(camera.size[1]) / f64::from(camera.size[0]);
        let is_in = |ball: &Ball| {
            let depth = ball.center.dot(axes.forward);
            let inside = |side: DVec3, half: f64| {
                // In front of the picture's edge, a plane through the aperture, or by less than the radius behind it.
                half * depth - ball.center.dot(side).abs() >= -ball.radius * (1.0 + half * half).sqrt()
            };
            depth > -ball.radius && inside(axes.right, half_width) && inside(axes.up, half_height)
        };
        !self.surrounds && !self.balls.iter().any(is_in)
    }
}

/// How to hold all that is seen; `towards` is somewhere in the midst of it.
fn framed(sights: &[Sight], towards: DVec3) -> Option<Framing> {
    let reach = |gaze: &Gaze| reach(sights, &gaze.axes());
    let mut gaze = Gaze { elevation: 0.0, ..Gaze::along(towards.try_normalize()?.to_array()) };
    // First level, so that azimuths are exact however wide it is.
    gaze.azimuth -= middle(reach(&gaze)[0]);
    gaze.elevation = tilted(middle(reach(&gaze)[1]));
    for _ in 0..TURNS {
        let [across, up] = reach(&gaze).map(middle);
        gaze.azimuth -= across / sin_cos(gaze.elevation).1.max(0.1);
        gaze.elevation = tilted(gaze.elevation + up);
    }
    Some(Framing { gaze, reach: reach(&gaze).map(|[low, high]| (-low).max(high)) })
}

fn middle([low, high]: Range) -> f64 {
    0.5 * (low + high)
}

fn tilted(elevation: f64) -> f64 {
    elevation.clamp(-MAX_ELEVATION, MAX_ELEVATION)
}

/// Between which angles from the optical axis, across and up, all that is seen lies.
fn reach(sights: &[Sight], axes: &Axes) -> [Range; 2] {
    let mut found = Reach::NOWHERE;
    for sight in sights {
        sight.widen(axes, &mut found);
    }
    [found.across, found.up].map(|range| range.map(|tangent| 2.0 * atan(tangent)))
}

/// The views whose rays show what `view` shows. In the published model the right eye sees of each point what the left
/// eye saw at most the eyes' separation earlier or later; in between a body moves along a straight line.
fn as_seen(view: &View) -> impl Iterator<Item = View> + use<> {
    let delay = 2.0 * view.camera.aperture.x;
    let (geometry, delays) = match view.geometry {
        Geometry::Published => (Geometry::Seen, [Some(-delay), Some(delay)]),
        geometry => (geometry, [Some(0.0), None]),
    };
    let view = *view;
    let at = move |delay| View { geometry, observation_time: view.observation_time + delay, ..view };
    delays.into_iter().flatten().map(at)
}

impl<'a> Sight<'a> {
    fn new(scene: &'a PreparedScene, group: &PreparedGroup, view: GroupView) -> Self {
        let projection = Projection::new(&view);
        let seen = |body: &PreparedBody| {
            let around = scene.ball_around(body);
            let center = projection.apparent_centre(view.reflected_from_camera(around.from), around.radius);
            let ball = center.map(|center| Ball { center, radius: around.radius });
            Seen { ball, capsules: scene.capsules(body), block: body.block }
        };
        let bodies = scene.bodies()[group.bodies.clone()].iter().map(seen).collect();
        Self { view, projection, bodies }
    }

    /// The balls that look like those around the bodies, on the ground.
    fn balls(&self) -> impl Iterator<Item = Ball> {
        let balls = self.bodies.iter().filter_map(|body| body.ball);
        balls.map(|ball| Ball { center: self.view.velocity.reflected(ball.center), ..ball })
    }

    /// Widens `found` so that it holds every body.
    fn widen(&self, axes: &Axes, found: &mut Reach) {
        let reflected = |v| self.view.velocity.reflected(v);
        let axes =
            &Axes { right: reflected(axes.right), up: reflected(axes.up), forward: reflected(axes.forward) };
        let whole = |body: &Seen| body.ball.map_or(Reach::EVERYWHERE, |ball| Reach::of(&ball, axes));
        let wholes: Vec<_> = self.bodies.iter().map(whole).collect();
        // Those that may reach furthest come first: few of the others need a closer look then.
        for number in furthest(&wholes).into_iter().chain(0..wholes.len()) {
            if !found.holds(&wholes[number]) {
                for capsule in self.bodies[number].pieces() {
                    self.widen_by(&capsule.reflected_from_camera(&self.view), HALVINGS, axes, found);
                }
            }
        }
    }

    /// Widens `found` so that it holds the `piece`.
    fn widen_by(&self, piece: &Capsule, halvings: u32, axes: &Axes, found: &mut Reach) {
        let Some((ends, bulge)) = self.image(piece) else {
            *found = Reach::EVERYWHERE;
            return;
        };
        let reach = |offset: DVec3| {
            let [first, last] =
                ends.map(|end| Reach::of(&Ball { center: end + offset, radius: piece.radius }, axes));
            first.joined(&last)
        };
        *found = found.joined(&reach(DVec3::ZERO));
        if bulge == DVec3::ZERO {
            return;
        }
        let all = reach(bulge);
        if found.holds(&all) {
            return;
        }
        let slight = SLIGHT_BULGE * SLIGHT_BULGE * ends[0].length_squared().min(ends[1].length_squared());
        if halvings == 0 || bulge.length_squared() <= slight {
            *found = found.joined(&all);
            return;
        }
        piece.halves().iter().for_each(|half| self.widen_by(half, halvings - 1, axes, found));
    }

    /// The centres of the balls that its ends look like, and how far it departs at most from the straight tube between
    /// them. `None` where that cannot be said.
    fn image(&self, piece: &Capsule) -> Option<([DVec3; 2], DVec3)> {
        let first = self.projection.apparent_centre(piece.from, piece.radius)?;
        let last = self.projection.apparent_centre(piece.to, piece.radius)?;
        Some(([first, last], self.projection.bulge(piece)?))
    }
}

/// The numbers of those that reach furthest to each side.
fn furthest(all: &[Reach]) -> Vec<usize> {
    let sides: [fn(&Reach) -> f64; 4] = [|r| -r.across[0], |r| r.across[1], |r| -r.up[0], |r| r.up[1]];
    let by =
        |side: &fn(&Reach) -> f64| (0..all.len()).max_by(|&a, &b| side(&all[a]).total_cmp(&side(&all[b])));
    sides.iter().filter_map(by).collect()
}

/// Least and greatest.
type Range = [f64; 2];

/// Between which planes through the picture's upright, and between which through its level line something lies, as
/// tangents of half their angles from the optical axis.
#[derive(Debug, Clone, Copy)]
struct Reach {
    across: Range,
    up: Range,
}

impl Reach {
    const NOWHERE: Self = Self::both([f64::INFINITY, f64::NEG_INFINITY]);
    const EVERYWHERE: Self = Self::both([f64::NEG_INFINITY, f64::INFINITY]);

    const fn both(range: Range) -> Self {
        Self { across: range, up: range }
    }

    fn of(ball: &Ball, axes: &Axes) -> Self {
        let depth = ball.center.dot(axes.forward);
        let range = |side: DVec3| tangents(ball.center.dot(side), depth, ball.radius);
        Self { across: range(axes.right), up: range(axes.up) }
    }

    fn joined(&self, other: &Self) -> Self {
        let joined = |[a, b]: Range, [c, d]: Range| [a.min(c), b.max(d)];
        Self { across: joined(self.across, other.across), up: joined(self.up, other.up) }
    }

    fn holds(&self, other: &Self) -> bool {
        let holds = |[a, b]: Range, [c, d]: Range| a <= c && d <= b;
        holds(self.across, other.across) && holds(self.up, other.up)
    }
}

/// Of half the angles at which a ball this far `aside` and this deep begins and ends.
fn tangents(aside: f64, depth: f64, radius: f64) -> Range {
    let squared = aside * aside + depth * depth;
    let outside_squared = squared - radius * radius;
    if outside_squared <= 0.0 {
        return [f64::NEG_INFINITY, f64::INFINITY];
    }
    // The tangents from the aperture lie asin(radius/distance) to both sides of the centre.
    let tangent = outside_squared.sqrt();
    let ahead = squared + depth * tangent;
    let end = |radius: f64| (aside * tangent + depth * radius) / (ahead - aside * radius);
    [end(-radius), end(radius)]
}

impl Framing {
    /// Horizontal field of view that holds the outline with a margin, radians, in a picture of this `size` (width and
    /// height): 42 to 150 degrees.
    #[must_use]
    pub fn horizontal_fov(&self, size: [u32; 2]) -> f64 {
        let [width, height] = size.map(f64::from);
        let [across, up] =
            self.reach.map(|reach| if reach < 0.5 * WIDEST { tan(reach) } else { f64::INFINITY });
        let half_width = across.max(up * width / height) / (1.0 - 2.0 * MARGIN);
        (2.0 * atan(half_width)).clamp(NARROWEST, WIDEST)
    }
}
