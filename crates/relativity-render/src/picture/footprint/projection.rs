//! The projection of a group into a view: the place of a piece with round ends, and the rectangle around it.

use glam::{DVec2, DVec3};
use relativity_core::math::hypot;

use crate::camera::Gauge;
use crate::camera::mercator::Mercator;
use crate::geometry::capsule::Capsule;
use crate::view::Geometry;
use crate::view::group_view::GroupView;

/// Space left around an outline, px: a pixel's samples lie up to 0.4 px from its centre, thin pieces are
/// drawn up to half a pixel wider than they are, and f32 rounds.
pub(super) const MARGIN_PX: f64 = 1.5;
/// In front is what lies deeper than this many times its own reach in depth: at 1 the outline runs off to
/// infinity, and just beyond it the quadratic for its extent has lost its digits.
const CLEAR_OF_APERTURE: f64 = 1.001;
/// Bulge up to which halves do not get rectangles of their own: this many radii and
/// this many pixels. Halves of a bulge are a quarter of it each.
pub(super) const LOOSE_RADII: f64 = 2.0;
pub(super) const LOOSE_PX: f64 = 4.0;

/// The place in the picture where a piece can appear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Footprint {
    /// Nowhere in the picture.
    Hidden,
    /// Inside this rectangle.
    Inside(Rectangle),
}

/// Anywhere in the picture.
pub(super) const EVERYWHERE: Footprint = Footprint::Inside(Rectangle::EVERYWHERE);

/// A rectangle in the picture, clip coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    pub middle: DVec2,
    pub half_axes: [DVec2; 2],
    /// Smallest radius of the piece in the picture, px.
    pub radius_px: f64,
    /// Whether the halves of the piece would have much smaller rectangles.
    pub is_loose: bool,
}

impl Rectangle {
    /// The footprint of the whole picture.
    pub const EVERYWHERE: Self = Self {
        middle: DVec2::ZERO,
        half_axes: [DVec2::X, DVec2::Y],
        radius_px: f64::INFINITY,
        is_loose: false,
    };
}

/// Maps capsules and blocks to footprints for one view of a group; all is in axes along its motion.
#[derive(Debug, Clone, Copy)]
pub struct FootprintMap {
    pub(super) gauge: Gauge,
    /// The bounds of a conformal picture.
    pub(super) mercator: Option<Mercator>,
    pub(super) focal_length_px: f64,
    pub(super) size: DVec2,
    pub(super) geometry: Geometry,
    pub(super) beta: f64,
    pub(super) gamma: f64,
    inverse_gamma_squared: f64,
    /// Ground distance per rest-frame distance is at least this.
    pub(super) least_scale: f64,
}

impl FootprintMap {
    pub fn new(view: &GroupView) -> Self {
        let speed = &view.velocity.speed;
        Self {
            gauge: view.camera.gauge().turned(|v| view.velocity.motion_from_camera(v)),
            mercator: view
                .camera
                .mercator()
                .map(|mercator| mercator.turned(|v| view.velocity.motion_from_camera(v))),
            focal_length_px: view.camera.focal_length_px(),
            size: DVec2::from(view.camera.size.map(f64::from)),
            geometry: view.geometry,
            beta: speed.beta(),
            gamma: speed.gamma(),
            inverse_gamma_squared: speed.inverse_gamma_squared(),
            least_scale: least_scale(view),
        }
    }

    /// Whether a rest-frame ball around `centre`, from the camera's event in axes along the motion, is surely
    /// not in the picture.
    pub fn hides(&self, centre: DVec3, radius: f64) -> bool {
        self.footprint(&Capsule::ball(centre, radius)) == Some(Footprint::Hidden)
    }

    /// Returns the least and the greatest length that a pixel spans where places of a rest-frame ball are
    /// seen, ground frame. `None` if the camera is in the ball or near it.
    ///
    /// From its value at the middle c the distance gamma (|c| - `beta c_x`) changes over the ball by at most
    /// its gradient, gamma |c/|c| - beta x|, times the radius r, and by gamma r^2/2(|c| - r) more; the place
    /// along x by the same of gamma (`c_x` - beta |c|).
    pub fn lengths_of_a_pixel(&self, centre: DVec3, radius: f64) -> Option<[f64; 2]> {
        let Self { beta, gamma, .. } = *self;
        let distance = centre.length();
        if distance <= 2.0 * radius {
            return None;
        }
        let seen = self.apparent_centre(centre, 0.0)?;
        let (from, px) = match &self.mercator {
            Some(mercator) => (seen.cross(mercator.axes.right).length(), mercator.px_per_unit),
            None => (seen.length(), self.focal_length_px),
        };
        let (sight, bend) = (centre / distance, 0.5 * radius / (distance - radius));
        let off = match (self.geometry.has_doppler_effect(), &self.mercator) {
            (false, _) => radius,
            (true, None) => gamma * radius * ((sight - DVec3::X * beta).length() + bend),
            (true, Some(_)) => {
                hypot(radius, gamma * radius * ((DVec3::X - sight * beta).length() + beta * bend))
            }
        };
        (from > off).then(|| [from - off, from + off].map(|distance| distance / px))
    }

    /// Returns the footprint of `capsule`; `None` if it has none as a whole.
    pub fn footprint(&self, capsule: &Capsule) -> Option<Footprint> {
        let balls = self.hull(capsule)?;
        if let Some(mercator) = &self.mercator {
            return self.conformal_footprint(mercator, &balls, capsule.radius, capsule.radius);
        }
        let depth = self.depth(balls[0], capsule.radius);
        if depth == Depth::Across || balls.iter().any(|ball| self.depth(*ball, capsule.radius) != depth) {
            return None;
        }
        if depth == Depth::Behind {
            return Some(Footprint::Hidden);
        }
        Some(self.rectangle(&balls, capsule.radius))
    }

    pub(super) fn radius_px(&self, radius: f64, hull: &[DVec3]) -> f64 {
        let furthest = hull.iter().map(|place| place.length()).fold(0.0, f64::max);
        radius * self.focal_length_px / furthest
    }

    /// Four balls (of the capsule's radius) in whose convex hull its image lies.
    fn hull(&self, capsule: &Capsule) -> Option<[DVec3; 4]> {
        let first = self.apparent_centre(capsule.from, capsule.radius)?;
        let last = self.apparent_centre(capsule.to, capsule.radius)?;
        let bulge = self.bulge(capsule)?;
        Some([first, last, first + bulge, last + bulge])
    }

    /// The centre of the ground ball that looks as the rest-frame ball around `c` does. `None` if the
    /// aperture is inside it, or its outline is wider than a half space.
    pub fn apparent_centre(&self, c: DVec3, radius: f64) -> Option<DVec3> {
        let outside_squared = c.length_squared() - radius * radius;
        if outside_squared <= 0.0 {
            return None;
        }
        match self.geometry {
            Geometry::Rest => Some(c),
            Geometry::Contracted => Some(DVec3::new(c.x / self.gamma, c.y, c.z)),
            Geometry::Seen | Geometry::Published | Geometry::OneCone => {
                let h = outside_squared.sqrt();
                let (x, height) = self.boosted(c, h, radius);
                (height > 0.0).then(|| DVec3::new(x, c.y, c.z))
            }
        }
    }

    /// `gamma (c_x - beta h)` and `gamma (h - beta c_x)`; for `c_x > 0` as quotients of what does not cancel.
    fn boosted(&self, c: DVec3, h: f64, radius: f64) -> (f64, f64) {
        let Self { beta, gamma, inverse_gamma_squared, .. } = *self;
        if c.x <= 0.0 {
            return (gamma * (c.x - beta * h), gamma * (h - beta * c.x));
        }
        let along = c.x * c.x * inverse_gamma_squared;
        let transverse = c.y * c.y + c.z * c.z - radius * radius;
        (
            gamma * (along - beta * beta * transverse) / (c.x + beta * h),
            gamma * (along + transverse) / (h + beta * c.x),
        )
    }

    /// Returns the greatest distance of C(t) from its chord. `None` if the aperture looks along the axis from
    /// inside the tube.
    ///
    /// Only the part -gamma beta h(t) of C is curved. Between the ends, h^2 and the square of the chord L(t)
    /// of h differ by t (1 - t) (|span|^2 - slope^2), so L - h is that over L + h, with nothing left to
    /// cancel.
    pub fn bulge(&self, capsule: &Capsule) -> Option<DVec3> {
        let Capsule { from, to, radius } = *capsule;
        let span = to - from;
        let a = span.length_squared();
        if !self.geometry.has_doppler_effect() || a == 0.0 {
            return Some(DVec3::ZERO);
        }
        let height_squared = |t: f64| (from + span * t).length_squared() - radius * radius;
        let least_squared = height_squared((-from.dot(span) / a).clamp(0.0, 1.0));
        if least_squared <= 0.0 {
            return None;
        }
        let ends = height_squared(0.0).sqrt() + height_squared(1.0).sqrt();
        let slope = (a + 2.0 * from.dot(span)) / ends;
        let departure = (a - slope * slope) / (8.0 * least_squared.sqrt());
        Some(DVec3::X * (self.gamma * self.beta * departure))
    }

    /// r^2 times the metric in which the apparent ball is one: contracted along x if it is.
    fn metric(&self, p: DVec3, q: DVec3, radius: f64) -> f64 {
        let along = if self.geometry == Geometry::Contracted { self.inverse_gamma_squared } else { 1.0 };
        radius * radius * (along * p.x * q.x + p.y * q.y + p.z * q.z)
    }

    fn depth(&self, ball: DVec3, radius: f64) -> Depth {
        let forward = self.gauge.forward;
        let depth = ball.dot(forward);
        let reach = self.metric(forward, forward, radius).sqrt();
        if depth > CLEAR_OF_APERTURE * reach {
            Depth::InFront
        } else if depth < -reach {
            Depth::Behind
        } else {
            Depth::Across
        }
    }

    /// The rectangle along the piece's image around the four balls (all in front).
    fn rectangle(&self, balls: &[DVec3; 4], radius: f64) -> Footprint {
        let image = |ball: DVec3| {
            let depth = ball.dot(self.gauge.forward);
            DVec2::new(ball.dot(self.gauge.right), ball.dot(self.gauge.up)) / depth
        };
        let along = (image(balls[1]) - image(balls[0])).try_normalize().unwrap_or(DVec2::X);
        let across = along.perp();
        let (along_low, along_high) = self.extent(balls, along, radius);
        let (across_low, across_high) = self.extent(balls, across, radius);
        let radius_px = self.radius_px(radius, balls);
        let distance = balls[0].length().min(balls[1].length());
        let bulge = (balls[2].x - balls[0].x).abs();
        let is_loose = bulge > LOOSE_RADII * radius + LOOSE_PX * distance / self.focal_length_px;
        let [low, high] = [DVec2::new(along_low, across_low), DVec2::new(along_high, across_high)];
        ImageExtent { along, low, high }.footprint(self, radius_px, is_loose)
    }

    /// Least and greatest u/f of the balls' outlines, u being the picture coordinate along `direction`.
    ///
    /// The plane through the aperture and the line u = const touches the ball of centre C where
    /// (p.C)^2 = m(p, p), p = e - (u/f) forward; the discriminant is written without cancellation.
    fn extent(&self, balls: &[DVec3; 4], direction: DVec2, radius: f64) -> (f64, f64) {
        let forward = self.gauge.forward;
        let e = self.gauge.right * direction.x + self.gauge.up * direction.y;
        let (ee, ef, ff) = (
            self.metric(e, e, radius),
            self.metric(e, forward, radius),
            self.metric(forward, forward, radius),
        );
        balls.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), ball| {
            let (along, depth) = (ball.dot(e), ball.dot(forward));
            let a = depth * depth - ff;
            let b = along * depth - ef;
            let discriminant =
                ee * depth * depth - 2.0 * ef * along * depth + ff * along * along - (ee * ff - ef * ef);
            let root = discriminant.max(0.0).sqrt();
            (low.min((b - root) / a), high.max((b + root) / a))
        })
    }
}

/// The least that ground distances are of those in the rest frame, along any line of sight of `view`.
fn least_scale(view: &GroupView) -> f64 {
    let speed = &view.velocity.speed;
    match view.geometry {
        Geometry::Rest => 1.0,
        Geometry::Contracted => 1.0 / speed.gamma(),
        Geometry::Seen | Geometry::Published | Geometry::OneCone => 1.0 / speed.head_on_doppler_factor(),
    }
}

/// The extent of images along a direction of the picture, and across it.
#[derive(Debug, Clone, Copy)]
pub(super) struct ImageExtent {
    along: DVec2,
    pub low: DVec2,
    pub high: DVec2,
}

impl ImageExtent {
    pub fn new(places: &[DVec2], along: DVec2) -> Self {
        let own = places.iter().map(|place| DVec2::new(place.dot(along), place.dot(along.perp())));
        let nothing = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (low, high) = own.fold(nothing, |(low, high), place| (low.min(place), high.max(place)));
        Self { along, low, high }
    }

    pub fn area(&self) -> f64 {
        (self.high - self.low).element_product()
    }

    /// Returns the part of an upright extent that is not farther than `limit` from the middle of the picture.
    pub fn within(self, limit: DVec2) -> Self {
        Self { low: self.low.max(-limit), high: self.high.min(limit), ..self }
    }

    /// The area with this much room around it.
    pub fn area_with(&self, room: f64) -> f64 {
        (self.high - self.low + 2.0 * room).element_product()
    }

    pub fn widened(self, room: f64) -> Self {
        Self { low: self.low - room, high: self.high + room, ..self }
    }

    pub fn footprint(&self, projection: &FootprintMap, radius_px: f64, is_loose: bool) -> Footprint {
        let to_clip = 2.0 * projection.focal_length_px / projection.size;
        let margin = MARGIN_PX / projection.focal_length_px;
        let across = self.along.perp();
        let [middle, half] = [0.5 * (self.low + self.high), 0.5 * (self.high - self.low) + margin];
        let middle = (self.along * middle.x + across * middle.y) * to_clip;
        let half_axes = [self.along * half.x * to_clip, across * half.y * to_clip];
        let reach = half_axes[0].abs() + half_axes[1].abs();
        if half.min_element() < 0.0 || (middle.abs() - reach).max_element() > 1.0 {
            return Footprint::Hidden;
        }
        Footprint::Inside(Rectangle { middle, half_axes, radius_px, is_loose })
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Depth {
    InFront,
    Across,
    Behind,
}
