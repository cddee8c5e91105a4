//! A ball.

use glam::{DQuat, DVec2, DVec3};

use super::questions::{CentredShape, Foot, LocalRay, PackedForm, PackedShape, PlacedShape};
use super::round::{Arc, ball_entry, closing};
use super::strokes::{Onlooker, Path, Stroke};
use super::tube::along_tube;
use crate::geometry::capsule::Capsule;
use crate::geometry::kind::Kind;
use crate::kinematics::spin::Spin;

/// Half the width of a ball's shadow on the ground, in parts of its radius.
const SHADOW: f64 = 1.2;

/// A ball where it is placed.
pub(super) struct Sphere {
    pub centre: DVec3,
    pub radius: f64,
}

impl PlacedShape for Sphere {
    fn name(&self) -> &'static str {
        "sphere"
    }

    fn kind(&self) -> Kind {
        Kind::Tube
    }

    fn numbers(&self) -> Vec<f64> {
        [&self.centre.to_array()[..], &[self.radius]].concat()
    }

    fn is_round_about(&self, spin: &Spin) -> bool {
        spin.is_on_axle(self.centre)
    }

    fn turn(&self) -> DQuat {
        DQuat::IDENTITY
    }

    fn distance(&self, place: DVec3) -> f64 {
        place.distance(self.centre) - self.radius
    }

    fn ball_around(&self) -> ([f64; 3], f64) {
        (self.centre.to_array(), self.radius)
    }

    fn forward_most(&self) -> DVec3 {
        self.centre + self.radius * DVec3::X
    }

    /// Returns the ends of the diameters along x, y and z.
    fn samples(&self) -> Vec<DVec3> {
        let ends = DVec3::AXES.into_iter().flat_map(|axis| [-axis, axis]);
        ends.map(|end| self.centre + self.radius * end).collect()
    }

    /// None: its outline depends on who looks.
    fn strokes(&self) -> Vec<Stroke> {
        Vec::new()
    }

    /// A circle, nearer than the centre and smaller than the ball where the eye is near; a point for an eye
    /// inside.
    fn silhouette(&self, onlooker_at: &dyn Fn(DVec3) -> Onlooker) -> Option<Path> {
        let Self { centre, radius } = *self;
        let onlooker = onlooker_at(centre);
        let sight = onlooker.line_of_sight(centre);
        let nearer = match onlooker {
            Onlooker::At(_) => (radius * radius / sight.length_squared()).min(1.0),
            Onlooker::Afar(_) => 0.0,
        };
        let axis = sight.normalize_or(DVec3::Z);
        Some(Path::circle(centre - sight * nearer, axis, radius * (1.0 - nearer).sqrt()))
    }

    fn capsules(&self) -> Vec<Capsule> {
        vec![Capsule::ball(self.centre, self.radius)]
    }

    fn foot(&self) -> Option<Foot> {
        let place = self.centre - DVec3::Z * self.radius;
        Some(Foot { place, radius: self.radius, half: DVec2::splat(SHADOW * self.radius) })
    }

    /// A tube whose ends are in one place.
    fn packed(&self) -> PackedShape {
        PackedShape { place: self.centre, radius: self.radius, form: PackedForm::Place(self.centre) }
    }
}

/// A ball about its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SphereForm {
    pub radius: f64,
}

impl CentredShape for SphereForm {
    fn entry(&self, ray: &LocalRay) -> Option<f64> {
        ray.in_front(ball_entry(ray.start, ray.direction, self.radius)?)
    }

    fn distance(&self, position: DVec3) -> (f64, DVec3) {
        (position.length() - self.radius, position.normalize_or_zero())
    }

    fn normal(&self, position: DVec3) -> DVec3 {
        position.normalize()
    }

    fn bounding_radius(&self) -> f64 {
        self.radius
    }

    fn half_sides(&self) -> DVec3 {
        DVec3::splat(self.radius)
    }

    fn squares(&self, step: f64) -> [f64; 2] {
        let around = closing(self.radius, step);
        [around * self.radius, around]
    }

    fn along(&self, off_axis: f64, outward: DVec3, z: f64, _: f64) -> Arc {
        along_tube(0.0, self.radius, off_axis, outward, z)
    }

    /// Visits one place, which stands for all of the surface.
    fn visit_farthest(&self, visit: &mut dyn FnMut(DVec3)) {
        visit(DVec3::X * self.radius);
    }
}
