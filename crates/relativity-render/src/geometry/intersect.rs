//! Entries of straight rays into bodies, in the rest frame and in f64.
//!
//! Every test first moves the ray's start to the point nearest to the body's centre: what is left has the
//! size of the body. Only entries count: an aperture inside a body does not see that body's inner surface.

use glam::DVec3;

use super::ray::Ray;
use super::shape::questions::LocalRay;
use super::shape::{PreparedShape, Shape};
use super::triangle_point::TrianglePoint;

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
    pub(crate) centre: DVec3,
    bounding_radius: f64,
    pub(crate) form: PreparedShape,
}

impl Solid {
    /// Prepares `shape` for rays.
    #[must_use]
    pub fn new(shape: &Shape) -> Self {
        let (centre, form) = shape.about_centre();
        Self { centre, bounding_radius: form.answers().bounding_radius(), form }
    }

    /// Centre of the shape.
    #[must_use]
    pub fn centre(&self) -> DVec3 {
        self.centre
    }

    /// Outward unit normal at a `position` on the surface.
    pub(crate) fn normal(&self, position: DVec3) -> DVec3 {
        self.form.answers().normal(position - self.centre)
    }

    /// Returns a vector along the axes of a box in those of the rest frame.
    pub(crate) fn rest_from_box(&self, vector: DVec3) -> DVec3 {
        if let PreparedShape::Box(cuboid) = self.form { cuboid.axes * vector } else { vector }
    }

    /// Half the least width it is seen with along the unit vector `direction` from afar.
    pub(crate) fn half_width(&self, direction: DVec3) -> f64 {
        self.form.answers().half_width(direction)
    }

    /// Radius of a ball about the centre that holds it.
    pub(crate) fn bounding_radius(&self) -> f64 {
        self.bounding_radius
    }

    /// The lowest and highest corner of a box that holds it.
    pub(crate) fn bounds(&self) -> [DVec3; 2] {
        [-1.0, 1.0].map(|side| self.centre + side * self.bounding_radius)
    }

    /// Both ends of a line, and a radius, within which of that line it lies.
    pub(crate) fn core(&self) -> ([DVec3; 2], f64) {
        let (half, radius) = self.form.answers().core();
        ([self.centre - half, self.centre + half], radius)
    }

    /// Returns the first entry of `ray`, in front of the camera.
    ///
    /// # Accuracy
    ///
    /// `tests/reference_intersect.rs`: the position lies on the surface within 1e-14 of the body's size, for
    /// cameras up to 1e9 sizes away and down to grazing incidence.
    #[must_use]
    pub fn entry(&self, ray: &Ray) -> Option<Entry> {
        let (start, from_start) = ray.nearest_to(self.centre);
        if start.length_squared() >= self.bounding_radius * self.bounding_radius {
            return None;
        }
        let direction = ray.direction;
        let local = LocalRay { start, direction, behind: -ray.from_camera - from_start };
        let form = self.form.answers();
        let t = form.entry(&local)?;
        let position = start + direction * t;
        Some(Entry {
            distance: from_start + t,
            position: self.centre + position,
            normal: form.normal(position),
            triangle: None,
        })
    }
}
