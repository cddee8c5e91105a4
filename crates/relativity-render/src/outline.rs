//! The outline of what a scene is about, as one or several apertures see it, and the gaze and field of view that hold
//! all of it.
//!
//! A ball at rest in the moving frame looks as a ball of the same radius at another place on the ground looks at rest,
//! since aberration maps cones of directions to cones (Penrose 1959); a tube looks as one swept along a curve. The
//! outline is that of balls at both ends of short pieces, each larger by as much as its piece bulges. It is exact for
//! balls; what is added for other bodies is below a thousandth of their distance. In the contracted geometry a ball is
//! flattened, and the outline is that of the ball around it.

use glam::DVec3;
use relativity_core::math::{atan, sin_cos, tan};

use crate::camera::{Axes, Camera, Gaze, MAX_ELEVATION};
use crate::capsule::Capsule;
use crate::footprint::Projection;
use crate::group_view::GroupView;
use crate::scene::PreparedScene;
use crate::view::{Geometry, View};

/// The part of the picture that is left free on each side of what is framed.
const MARGIN: f64 = 0.1;
/// Narrowest horizontal field of view that frames, radians: something small or far is shown with what is around it.
const NARROWEST: f64 = 42.0 * DEGREE;
/// Widest horizontal field of view that frames, radians. What reaches further is cropped.
const WIDEST: f64 = 150.0 * DEGREE;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Bulge of a piece, in parts of its distance, that is not worth halving it.
const SLIGHT_BULGE: f64 = 1e-3;
/// How often a piece is halved at most.
const HALVINGS: u32 = 8;
/// How often the gaze is turned to the middle of what it frames. The next turn would be below a thousandth of a
/// degree for anything that fits the widest field of view.
const TURNS: u32 = 4;

/// What a scene is about ([`PreparedScene::subject`]), from one or several parallel apertures.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Balls at rest on the ground that look like it, each from its aperture.
    balls: Vec<Ball>,
    /// Whether an aperture is inside it, or as good as inside.
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

/// Least and greatest angle, radians.
type Range = [f64; 2];

impl Outline {
    /// That of `scene` in all `views` together, whatever their gazes and fields.
    pub(crate) fn new(scene: &PreparedScene, views: &[View]) -> Self {
        let mut outline = Self { balls: Vec::new(), surrounds: false, framing: None };
        for view in views.iter().flat_map(as_seen) {
            for group in scene.subject() {
                let bodies = &scene.bodies()[group.bodies.clone()];
                let capsules = bodies.iter().flat_map(|body| scene.capsules(body));
                outline.add(&view.of_group(group.motion), capsules);
            }
        }
        outline.framing = outline.framed();
        outline
    }

    fn add<'a>(&mut self, view: &GroupView, capsules: impl Iterator<Item = &'a Capsule>) {
        let projection = Projection::new(view);
        let first = self.balls.len();
        for capsule in capsules {
            let found =
                add_balls(&projection, &capsule.reflected_from_camera(view), HALVINGS, &mut self.balls);
            self.surrounds |= found.is_none();
        }
        for ball in &mut self.balls[first..] {
            ball.center = view.velocity.reflected(ball.center);
        }
    }

    /// How to hold all of it in a picture; `None` where there is nothing.
    #[must_use]
    pub const fn framing(&self) -> Option<Framing> {
        self.framing
    }

    fn framed(&self) -> Option<Framing> {
        let sum: DVec3 = self.balls.iter().map(|ball| ball.center.normalize_or_zero()).sum();
        let mut gaze = Gaze { elevation: 0.0, ..Gaze::along(sum.try_normalize()?.to_array()) };
        // First level, so that azimuths are exact however wide it is.
        gaze.azimuth -= middle(self.reach(&gaze.axes())[0]);
        gaze.elevation = tilted(middle(self.reach(&gaze.axes())[1]));
        for _ in 0..TURNS {
            let [across, up] = self.reach(&gaze.axes()).map(middle);
            gaze.azimuth -= across / sin_cos(gaze.elevation).1.max(0.1);
            gaze.elevation = tilted(gaze.elevation + up);
        }
        let reach = self.reach(&gaze.axes()).map(|[low, high]| (-low).max(high));
        Some(Framing { gaze, reach: if self.surrounds { [WIDEST; 2] } else { reach } })
    }

    /// Whether nothing of it is in the picture of a `camera` at its apertures.
    #[must_use]
    pub fn is_out_of(&self, camera: &Camera) -> bool {
        let axes = camera.gaze.axes();
        let half_width = tan(0.5 * camera.horizontal_fov);
        let half_height = half_width * f64::from(camera.size[1]) / f64::from(camera.size[0]);
        let is_in = |ball: &Ball| {
            let depth = ball.center.dot(axes.forward);
            let inside = |side: DVec3, half: f64| {
                // In front of the picture's edge, a plane through the aperture, by less than the radius behind it.
                half * depth - ball.center.dot(side).abs() >= -ball.radius * (1.0 + half * half).sqrt()
            };
            depth > -ball.radius && inside(axes.right, half_width) && inside(axes.up, half_height)
        };
        !self.surrounds && !self.balls.iter().any(is_in)
    }

    /// Between which planes through the upright, and between which through the level axis, all of it lies.
    fn reach(&self, axes: &Axes) -> [Range; 2] {
        let nowhere = [f64::INFINITY, f64::NEG_INFINITY];
        let tangents = self.balls.iter().fold([nowhere; 2], |[across, up], ball| {
            let depth = ball.center.dot(axes.forward);
            [
                widened(across, ball.center.dot(axes.right), depth, ball.radius),
                widened(up, ball.center.dot(axes.up), depth, ball.radius),
            ]
        });
        tangents.map(|range| range.map(|tangent| 2.0 * atan(tangent)))
    }
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

/// Adds balls in whose convex hull the image of `capsule` lies, that from the camera's event, the group moving along
/// +x. `None` where that cannot be said.
fn add_balls(projection: &Projection, capsule: &Capsule, halvings: u32, balls: &mut Vec<Ball>) -> Option<()> {
    let Capsule { from, to, radius } = *capsule;
    let first = projection.apparent_centre(from, radius)?;
    if from == to {
        balls.push(Ball { center: first, radius });
        return Some(());
    }
    let last = projection.apparent_centre(to, radius)?;
    let bulge = projection.bulge(capsule)?.length();
    if halvings > 0 && bulge > SLIGHT_BULGE * first.length().min(last.length()) {
        let halves = capsule.halves();
        return halves.iter().try_for_each(|half| add_balls(projection, half, halvings - 1, balls));
    }
    balls.extend([first, last].map(|center| Ball { center, radius: radius + bulge }));
    Some(())
}

/// `range`, of tangents of half the angle from the optical axis, with a ball that is this far `aside` and this deep.
fn widened([low, high]: Range, aside: f64, depth: f64, radius: f64) -> Range {
    let squared = aside * aside + depth * depth;
    let outside_squared = squared - radius * radius;
    if outside_squared <= 0.0 {
        return [-f64::INFINITY, f64::INFINITY];
    }
    // The tangents from the aperture lie asin(radius/distance) to both sides.
    let tangent = outside_squared.sqrt();
    let ahead = squared + depth * tangent;
    [
        low.min((aside * tangent - depth * radius) / (ahead + aside * radius)),
        high.max((aside * tangent + depth * radius) / (ahead - aside * radius)),
    ]
}

fn middle([low, high]: Range) -> f64 {
    0.5 * (low + high)
}

fn tilted(elevation: f64) -> f64 {
    elevation.clamp(-MAX_ELEVATION, MAX_ELEVATION)
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
