//! Entries of straight rays into bodies, in the rest frame and in f64.
//!
//! Every test first moves the ray's start to the point nearest to the body's centre: what is left has the
//! size of the body. Only entries count: an aperture inside a body does not see that body's inner surface.

pub(crate) mod flat;

use glam::{DMat3, DVec3};
use relativity_core::math;

use crate::polynomial::first_descent;
use crate::ray::Ray;
use crate::shape::Shape;
use crate::triangles::point::TrianglePoint;
use crate::turn::turn_of;

/// The entry of a ray into a body. Rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// Along the ray, from its start.
    pub distance: f64,
    /// Place on the surface.
    pub position: DVec3,
    /// Outward unit normal at that place.
    pub normal: DVec3,
    /// Point of the triangle, if the body is made of these.
    pub triangle: Option<TrianglePoint>,
}

/// A shape prepared for ray tests.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solid {
    pub(crate) center: DVec3,
    bounding_radius: f64,
    pub(crate) form: Form,
}

/// A shape about the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Form {
    Ball {
        radius: f64,
    },
    Capsule {
        axis: DVec3,
        half_length: f64,
        radius: f64,
    },
    Torus {
        axis: DVec3,
        radius: f64,
        tube_radius: f64,
    },
    /// The columns of `axes` are its own axes.
    Block {
        axes: DMat3,
        half: DVec3,
    },
    Cylinder {
        axis: DVec3,
        half_length: f64,
        radius: f64,
    },
}

impl Solid {
    /// Prepares `shape` for rays.
    #[must_use]
    pub fn new(shape: &Shape) -> Self {
        match *shape {
            Shape::Sphere { center, radius } => Self::ball(center.into(), radius),
            Shape::Tube { from, to, radius } => {
                let (from, to) = (DVec3::from(from), DVec3::from(to));
                let half_length = 0.5 * (to - from).length();
                if half_length == 0.0 {
                    return Self::ball(from, radius);
                }
                let axis = (to - from) / (2.0 * half_length);
                Self {
                    center: 0.5 * (from + to),
                    bounding_radius: half_length + radius,
                    form: Form::Capsule { axis, half_length, radius },
                }
            }
            Shape::Ring { center, axis, radius, tube_radius } => Self {
                center: center.into(),
                bounding_radius: radius + tube_radius,
                form: Form::Torus { axis: axis.into(), radius, tube_radius },
            },
            Shape::Box { center, half, .. } => {
                let half = DVec3::from(half);
                Self {
                    center: center.into(),
                    bounding_radius: half.length(),
                    form: Form::Block { axes: DMat3::from_quat(turn_of(shape)), half },
                }
            }
            Shape::Cylinder { from, to, radius } => {
                let (from, to) = (DVec3::from(from), DVec3::from(to));
                let half_length = 0.5 * (to - from).length();
                Self {
                    center: 0.5 * (from + to),
                    bounding_radius: math::hypot(half_length, radius),
                    form: Form::Cylinder { axis: (to - from).normalize(), half_length, radius },
                }
            }
        }
    }

    fn ball(center: DVec3, radius: f64) -> Self {
        Self { center, bounding_radius: radius, form: Form::Ball { radius } }
    }

    /// Centre of the shape.
    #[must_use]
    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// Outward unit normal at a `position` on the surface.
    pub(crate) fn normal(&self, position: DVec3) -> DVec3 {
        self.form.normal(position - self.center)
    }

    /// Returns a vector along the axes of a box in those of the rest frame.
    pub(crate) fn rest_from_box(&self, vector: DVec3) -> DVec3 {
        if let Form::Block { axes, .. } = self.form { axes * vector } else { vector }
    }

    /// Half the least width it is seen with along the unit vector `direction` from afar.
    pub(crate) fn half_width(&self, direction: DVec3) -> f64 {
        self.form.half_width(direction)
    }

    /// Radius of a ball about the centre that holds it.
    pub(crate) fn bounding_radius(&self) -> f64 {
        self.bounding_radius
    }

    /// The lowest and highest corner of a box that holds it.
    pub(crate) fn bounds(&self) -> [DVec3; 2] {
        [-1.0, 1.0].map(|side| self.center + side * self.bounding_radius)
    }

    /// Both ends of a line, and a radius, within which of that line it lies.
    pub(crate) fn core(&self) -> ([DVec3; 2], f64) {
        let about = |half: DVec3, radius| ([self.center - half, self.center + half], radius);
        match self.form {
            Form::Capsule { axis, half_length, radius } | Form::Cylinder { axis, half_length, radius } => {
                about(axis * half_length, radius)
            }
            Form::Ball { .. } | Form::Torus { .. } | Form::Block { .. } => {
                about(DVec3::ZERO, self.bounding_radius)
            }
        }
    }

    /// Returns the first entry of `ray`, in front of the camera.
    ///
    /// # Accuracy
    ///
    /// `tests/reference_intersect.rs`: the position lies on the surface within 1e-14 of the body's size, for
    /// cameras up to 1e9 sizes away and down to grazing incidence.
    #[must_use]
    pub fn entry(&self, ray: &Ray) -> Option<Entry> {
        let (start, from_start) = ray.nearest_to(self.center);
        if start.length_squared() >= self.bounding_radius * self.bounding_radius {
            return None;
        }
        let direction = ray.direction;
        let local = LocalRay { start, direction, behind: -ray.from_camera - from_start };
        let t = match self.form {
            Form::Ball { radius } => local.ball_entry(radius),
            Form::Capsule { axis, half_length, radius } => local.capsule_entry(axis, half_length, radius),
            Form::Torus { axis, radius, tube_radius } => local.torus_entry(axis, radius, tube_radius),
            Form::Block { axes, half } => local.block_entry(axes, half),
            Form::Cylinder { axis, half_length, radius } => local.cylinder_entry(axis, half_length, radius),
        }?;
        let position = start + direction * t;
        Some(Entry {
            distance: from_start + t,
            position: self.center + position,
            normal: self.form.normal(position),
            triangle: None,
        })
    }
}

impl Form {
    /// The point of the shape's skeleton (centre, segment or circle) nearest to `position`.
    fn nearest_skeleton_point(&self, position: DVec3) -> DVec3 {
        match *self {
            Self::Ball { .. } => DVec3::ZERO,
            Self::Capsule { axis, half_length, .. } => {
                axis * axis.dot(position).clamp(-half_length, half_length)
            }
            Self::Torus { axis, radius, .. } => {
                (position - axis * axis.dot(position)).normalize_or(axis.any_orthonormal_vector()) * radius
            }
            // Flat ones have none.
            Self::Block { .. } | Self::Cylinder { .. } => position,
        }
    }

    /// Returns the distance of `position` from the surface, below 0 inside; and the unit vector away from the nearest place on the surface.
    pub(crate) fn distance(&self, position: DVec3) -> (f64, DVec3) {
        match *self {
            Self::Ball { radius }
            | Self::Capsule { radius, .. }
            | Self::Torus { tube_radius: radius, .. } => {
                let off = position - self.nearest_skeleton_point(position);
                (off.length() - radius, off.normalize_or_zero())
            }
            Self::Block { axes, half } => {
                let own = axes.transpose() * position;
                let (distance, outward) = flat::block_distance(own, half);
                (distance, axes * outward)
            }
            Self::Cylinder { axis, half_length, radius } => {
                let along = axis.dot(position);
                let off_axis = position - axis * along;
                let own = DVec3::new(off_axis.length(), along, 0.0);
                let (distance, outward) =
                    flat::block_distance(own, DVec3::new(radius, half_length, f64::INFINITY));
                (distance, off_axis.normalize_or_zero() * outward.x + axis * outward.y)
            }
        }
    }

    pub(crate) fn normal(&self, position: DVec3) -> DVec3 {
        match *self {
            Self::Block { axes, half } => {
                let own = axes.transpose() * position;
                let face = (own.abs() - half).max_position();
                axes.col(face) * own[face].signum()
            }
            Self::Cylinder { axis, half_length, radius } => {
                let along = axis.dot(position);
                let off_axis = position - axis * along;
                if along.abs() - half_length > off_axis.length() - radius {
                    axis * along.signum()
                } else {
                    off_axis.normalize()
                }
            }
            Self::Ball { .. } | Self::Capsule { .. } | Self::Torus { .. } => {
                (position - self.nearest_skeleton_point(position)).normalize()
            }
        }
    }

    /// Half its least width, seen along the unit vector `direction` from afar.
    fn half_width(&self, direction: DVec3) -> f64 {
        match *self {
            Self::Ball { radius } | Self::Capsule { radius, .. } => radius,
            Self::Torus { tube_radius, .. } => tube_radius,
            Self::Block { axes, half } => flat::block_half_width(axes, half, direction),
            Self::Cylinder { axis, half_length, radius } => {
                let cosine = axis.dot(direction).abs();
                let sine = axis.cross(direction).length();
                radius.min(half_length * sine + radius * cosine)
            }
        }
    }
}

/// A ray from a start near the body's centre, which lies at the origin.
pub(crate) struct LocalRay {
    pub start: DVec3,
    pub direction: DVec3,
    /// Parameter of the camera: what lies before it is behind the camera.
    pub behind: f64,
}

impl LocalRay {
    fn in_front(&self, t: f64) -> Option<f64> {
        (t > self.behind).then_some(t)
    }

    fn ball_entry(&self, radius: f64) -> Option<f64> {
        self.in_front(ball_entry(self.start, self.direction, radius)?)
    }

    fn capsule_entry(&self, axis: DVec3, half_length: f64, radius: f64) -> Option<f64> {
        let Self { start, direction, .. } = *self;
        let across = direction.cross(axis);
        let sine_squared = across.length_squared();
        // Distance of ray and axis is |start . across| / |across|: no difference of large squares.
        let offset = start.dot(across);
        let discriminant = radius * radius * sine_squared - offset * offset;
        if discriminant < 0.0 {
            return None;
        }
        let along_slope = direction.dot(axis);
        let cap = |end: f64| self.in_front(end_entry(start, direction, axis * end, radius)?);
        if sine_squared == 0.0 {
            return cap(-half_length.copysign(along_slope));
        }
        let t = -(start.cross(axis).dot(across) + discriminant.sqrt()) / sine_squared;
        let along = axis.dot(start) + along_slope * t;
        if along.abs() <= half_length { self.in_front(t) } else { cap(half_length.copysign(along)) }
    }

    fn block_entry(&self, axes: DMat3, half: DVec3) -> Option<f64> {
        self.in_front(flat::block_entry(self.start, self.direction, axes, half)?)
    }

    fn cylinder_entry(&self, axis: DVec3, half_length: f64, radius: f64) -> Option<f64> {
        self.in_front(flat::cylinder_entry(self.start, self.direction, axis, half_length, radius)?)
    }

    fn torus_entry(&self, axis: DVec3, radius: f64, tube_radius: f64) -> Option<f64> {
        let Self { start, direction, .. } = *self;
        let interval = self.torus_interval(axis, radius, tube_radius)?;
        let quartic = torus_quartic(start, direction, axis, radius, tube_radius);
        let t = first_descent(&quartic, interval)?;
        Some(self.polished_torus_entry(t, axis, radius, tube_radius))
    }

    /// The part of the ray between the two planes that touch the ring and inside the ball around it, in front
    /// of the camera; `None` if there is none, or if it lies in the hole. Spares most rays the quartic.
    fn torus_interval(&self, axis: DVec3, radius: f64, tube_radius: f64) -> Option<[f64; 2]> {
        let Self { start, direction, .. } = *self;
        // Beyond the surface, which the ball touches where the ring is widest.
        let size = (radius + tube_radius) * (1.0 + 1e-9);
        let half_chord = (size * size - start.length_squared()).max(0.0).sqrt();
        let [along, along_slope] = [start.dot(axis), direction.dot(axis)];
        let thickness = tube_radius * (1.0 + 1e-9);
        // A ray in the planes' direction gives infinities of both signs, or of one if it lies outside.
        let planes = [-thickness, thickness].map(|plane| (plane - along) / along_slope);
        let low = planes[0].min(planes[1]).max(-half_chord).max(self.behind);
        let high = planes[0].max(planes[1]).min(half_chord);
        let hole = (radius - tube_radius) * (1.0 - 1e-9);
        let in_hole = |t: f64| (start + direction * t).cross(axis).length_squared() < hole * hole;
        // The distance from the axis is convex along a ray: both ends in the hole, all of it in the hole.
        (low < high && !(in_hole(low) && in_hole(high))).then_some([low, high])
    }

    /// Improves an entry by one step of Newton's method on the distance from the surface: the quartic of a thin ring resolves
    /// its tube to only R^2 / r units of rounding. Left out where the ray grazes so closely that the
    /// step would cross to the way out.
    fn polished_torus_entry(&self, t: f64, axis: DVec3, radius: f64, tube_radius: f64) -> f64 {
        let from_skeleton = {
            let position = self.start + self.direction * t;
            position - Form::Torus { axis, radius, tube_radius }.nearest_skeleton_point(position)
        };
        let distance = from_skeleton.length();
        let excess = distance - tube_radius;
        let slope = from_skeleton.dot(self.direction) / distance;
        if excess.abs() < 0.25 * slope * slope * tube_radius { t - excess / slope } else { t }
    }
}

/// Entry into a ball at the origin, by the discriminant r^2 - |start x direction|^2.
fn ball_entry(start: DVec3, direction: DVec3, radius: f64) -> Option<f64> {
    let discriminant = radius * radius - start.cross(direction).length_squared();
    (discriminant >= 0.0).then(|| -start.dot(direction) - discriminant.sqrt())
}

/// Entry into a ball at `center`.
fn end_entry(start: DVec3, direction: DVec3, center: DVec3, radius: f64) -> Option<f64> {
    ball_entry(start - center, direction, radius)
}

/// (|p|^2 + R^2 - r^2)^2 - 4 R^2 (|p|^2 - (p . axis)^2) along p = start + t direction, constant first.
fn torus_quartic(start: DVec3, direction: DVec3, axis: DVec3, radius: f64, tube_radius: f64) -> [f64; 5] {
    let half_slope = start.dot(direction);
    let [along, along_slope] = [start.dot(axis), direction.dot(axis)];
    let square = start.length_squared();
    let k = square + (radius - tube_radius) * (radius + tube_radius);
    let four_r2 = 4.0 * radius * radius;
    [
        k * k - four_r2 * (square - along * along),
        4.0 * half_slope * k - 2.0 * four_r2 * (half_slope - along * along_slope),
        2.0 * k + 4.0 * half_slope * half_slope - four_r2 * (1.0 - along_slope * along_slope),
        4.0 * half_slope,
        1.0,
    ]
}
