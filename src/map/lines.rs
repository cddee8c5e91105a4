//! The outlines of a scene's bodies as the map draws them: bent as they are seen, in as many pieces as it
//! takes.

use std::ops::Range;

use glam::{DMat3, DVec2, DVec3};
use relativity_render::geometry::shape::strokes::{Onlooker, Path, Stroke};
use relativity_render::{Body, MaterialPoint, Spin};

use super::instant::{BodyPicture, MapInstant, Places};
use super::{Chart, MapProjection};
use crate::plot::{RefinementLimits, refined};
use crate::scene::{Scene, SceneGroup};
use crate::settings::MapFrame;

/// Greatest distance of a line from its curve, points.
const TOLERANCE: f64 = 0.25;
/// The bounds of a line.
const LIMITS: RefinementLimits = RefinementLimits { depth: 12, samples: 4000 };
/// Bodies smaller than this are left out, points.
const SMALLEST: f64 = 1.0;
/// Length over which a picture is taken for straight, units.
const SMALL: f64 = 1e-4;
/// Greatest number of bodies that are drawn of a group: of more, some that are evenly spread.
const MOST_BODIES: usize = 500;

/// A point of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Place at rest, in the scene's coordinates; at t' = 0, if it turns.
    pub rest: DVec3,
    /// Place on the map.
    pub place: DVec3,
}

/// A part of the outline of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineLine {
    /// The number of the body.
    pub body: usize,
    /// Whether the line rests on the ground.
    pub rests: bool,
    /// Picture that the line belongs to.
    pub picture: BodyPicture,
    /// Ball around the place: the radii along x, y and z of one as thick as the body, at rest and on the map.
    /// `None` for an edge.
    pub ball: Option<BallOutline>,
    /// The only projection that it is drawn in, if not in both: of a ball, whose outline in each is another.
    pub only: Option<MapProjection>,
    /// Radius of a ball around the body at rest.
    pub reach: f64,
    /// Range of the line's points among [`OutlineLines::vertices`].
    vertices: Range<usize>,
}

/// A ball, and what it becomes on the map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallOutline {
    /// Radius at rest.
    pub radius: f64,
    /// Radii along x, y and z on the map, from the middle.
    pub radii: [DVec3; 3],
}

impl BallOutline {
    /// Half its width in `projection` across the line `from` there `to` there.
    #[must_use]
    pub fn half_width(&self, projection: MapProjection, [from, to]: [[f64; 2]; 2]) -> f64 {
        let along = DVec2::from(to) - DVec2::from(from);
        let Some(across) = along.try_normalize().map(DVec2::perp) else { return 0.0 };
        // Where the tangent across is, of the ellipsoid that the ball becomes.
        let reach = self.radii.map(|radius| DVec2::from(projection.flat(radius)).dot(across));
        DVec3::from(reach).length()
    }
}

impl OutlineLine {
    /// Half its thickness in `projection` between two of its places there.
    #[must_use]
    pub fn half_width(&self, projection: MapProjection, ends: [[f64; 2]; 2]) -> f64 {
        self.ball.map_or(0.0, |ball| ball.half_width(projection, ends))
    }

    /// Whether the line is drawn in `projection`.
    #[must_use]
    pub fn is_in(&self, projection: MapProjection) -> bool {
        self.only.is_none_or(|only| only == projection)
    }
}

/// The outlines of all bodies.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OutlineLines {
    /// In the order in which they are drawn.
    pub all: Vec<OutlineLine>,
    vertices: Vec<Vertex>,
}

impl OutlineLines {
    /// The outlines of `scene` at `instant` for these charts, the plan and the view from the side.
    #[must_use]
    pub fn new(instant: &MapInstant, scene: &Scene, charts: &[Chart; 2]) -> Self {
        let mut lines = Self::default();
        let (street, riders): (Vec<_>, Vec<_>) =
            scene.passing().partition(|group| instant.rests(group.motion));
        for group in street {
            lines.add_group(&Sampler::new(instant, group, BodyPicture::Measured, charts), scene, group);
        }
        for &picture in pictures(instant.frame()) {
            for group in &riders {
                lines.add_group(&Sampler::new(instant, group, picture, charts), scene, group);
            }
        }
        lines
    }

    /// Adds the outlines of a group's bodies, leaving out those too small to be seen and more than can be
    /// distinguished.
    fn add_group(&mut self, sampler: &Sampler, scene: &Scene, group: &SceneGroup) {
        for body in group.bodies().step_by(group.count.div_ceil(MOST_BODIES).max(1)) {
            let reach = scene.bodies[body].shape.ball_around().1;
            if 2.0 * reach * sampler.charts[0].scale >= SMALLEST {
                self.add(
                    &Sampler { spin: scene.bodies[body].spin, ..*sampler },
                    body,
                    &scene.bodies[body],
                    reach,
                );
            }
        }
    }

    /// The points of `line`, one of these.
    #[must_use]
    pub fn vertices(&self, line: &OutlineLine) -> &[Vertex] {
        &self.vertices[line.vertices.clone()]
    }

    fn add(&mut self, sampler: &Sampler, number: usize, body: &Body, reach: f64) {
        for (Stroke { path, radius }, only) in sampler.outline(body) {
            let first = self.vertices.len();
            sampler.sample(&path, &mut self.vertices);
            let vertices = first..self.vertices.len();
            if vertices.len() > 1 {
                let Sampler { picture, rests, places, .. } = *sampler;
                let radii =
                    (radius > 0.0).then(|| places.ball(picture, sampler.thickest(&path, body), radius));
                let ball = radii.flatten().map(|radii| BallOutline { radius, radii });
                self.all.push(OutlineLine { body: number, rests, picture, ball, only, reach, vertices });
            }
        }
    }
}

/// The pictures of a body in `frame`, in the order in which they are drawn: a thin line on top, where two
/// eyes place it, which lies on what one eye sees when the head is tilted. On board of the bicycle nothing is
/// seen elsewhere: the light left where it rests.
const fn pictures(frame: MapFrame) -> &'static [BodyPicture] {
    match frame {
        MapFrame::Ground | MapFrame::Rider => {
            &[BodyPicture::Seen(1), BodyPicture::Seen(0), BodyPicture::Measured, BodyPicture::Stereo]
        }
        MapFrame::Bicycle => &[BodyPicture::Measured],
    }
}

/// Divides paths into pieces that are straight on the map.
struct Sampler<'a> {
    places: Places,
    picture: BodyPicture,
    rests: bool,
    charts: &'a [Chart; 2],
    /// Turning of the outlined body.
    spin: Option<Spin>,
}

impl<'a> Sampler<'a> {
    fn new(instant: &MapInstant, group: &SceneGroup, picture: BodyPicture, charts: &'a [Chart; 2]) -> Self {
        let rests = instant.rests(group.motion);
        Self { places: instant.places(group.motion), picture, rests, charts, spin: None }
    }

    /// The outline of `body` at rest, with the only projection that each part is drawn in, if not in both.
    fn outline(&self, body: &Body) -> Vec<(Stroke, Option<MapProjection>)> {
        let mut strokes: Vec<_> = body.strokes().into_iter().map(|stroke| (stroke, None)).collect();
        for projection in MapProjection::BOTH {
            // In the middle the map looks along it as it does everywhere, nearly.
            let silhouette = body.silhouette(|middle| Onlooker::Afar(self.line_of_sight(middle, projection)));
            strokes.extend(silhouette.into_iter().map(|stroke| (stroke, Some(projection))));
        }
        strokes
    }

    /// Adds the points of `path` to `vertices`: none if it has a part that is nowhere.
    fn sample(&self, path: &Path, vertices: &mut Vec<Vertex>) {
        // What turns may be bent both ways.
        let parts = path.parts() * if self.spin.is_some() { 2 } else { 1 };
        let at = |s: f64| Some((s, self.vertex(path, s)?));
        let first: Option<Vec<_>> = (0..=parts).map(|i| at(f64::from(i) / f64::from(parts))).collect();
        let Some(first) = first else { return };
        let all = refined(first, LIMITS, |[(from, start), (to, end)]| {
            at(0.5 * (from + to)).filter(|(_, middle)| self.is_bent([start, end], middle))
        });
        vertices.extend(all.into_iter().map(|(_, vertex)| vertex));
    }

    /// The direction at `rest` that the map looks along in `projection`, a unit vector at rest.
    fn line_of_sight(&self, rest: DVec3, projection: MapProjection) -> DVec3 {
        let straight = projection.line_of_sight();
        let map = self.places.ball(self.picture, rest, SMALL).map(|[x, y, z]| DMat3::from_cols(x, y, z));
        let turned = map.and_then(|map| (map.inverse() * straight).try_normalize());
        turned.unwrap_or(straight)
    }

    fn vertex(&self, path: &Path, s: f64) -> Option<Vertex> {
        let rest = path.at(s);
        let point = MaterialPoint { rest, spin: self.spin };
        Some(Vertex { rest, place: self.places.place(self.picture, point)? })
    }

    /// Returns the point that the thickness of a `path` of `body` is taken from: a body that turns in itself
    /// is as thick as if it did not.
    fn thickest(&self, path: &Path, body: &Body) -> MaterialPoint {
        let spin = self.spin.and(body.displacing_spin());
        MaterialPoint { rest: path.at(0.5), spin }
    }

    /// Whether the line from one of `ends` to the other is off the `middle` of a curve where that can be
    /// seen.
    fn is_bent(&self, ends: [Vertex; 2], middle: &Vertex) -> bool {
        let off = (middle.place - 0.5 * (ends[0].place + ends[1].place)).length();
        off * self.charts[0].scale > TOLERANCE && self.is_near(ends, off)
    }

    /// Whether what is between `ends`, as far as `off` from the straight line, comes into a chart.
    fn is_near(&self, ends: [Vertex; 2], off: f64) -> bool {
        MapProjection::BOTH.into_iter().zip(self.charts).any(|(projection, chart)| {
            let [a, b] = ends.map(|end| projection.flat(end.place));
            chart.range().into_iter().enumerate().all(|(axis, [low, high])| {
                a[axis].min(b[axis]) - off <= high && a[axis].max(b[axis]) + off >= low
            })
        })
    }
}
