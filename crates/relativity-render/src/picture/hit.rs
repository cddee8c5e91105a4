//! Hits of rays: what each pixel's centre shows.

use glam::DVec3;

use crate::geometry::triangle_point::TrianglePoint;
use crate::kinematics::spin::{Spin, about_y};
use crate::view::group_view::GroupView;

/// The hit of one ray.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Number of the body, in the order given.
    pub body: usize,
    /// Place of the hit, in the rest frame of its group.
    pub rest_position: DVec3,
    /// Outward unit normal in the rest frame.
    pub rest_normal: DVec3,
    /// From the aperture to the event of emission in the ground frame (in the rest frame for
    /// [`Geometry::Rest`](crate::Geometry::Rest)).
    pub distance: f64,
    /// Ground time of emission; the observation time itself for
    /// [`Geometry::Contracted`](crate::Geometry::Contracted), whose light is instantaneous.
    pub emission_time: f64,
    /// When the light left, by the clocks of the rest frame.
    pub proper_time: f64,
    /// The angle by which the body had turned then since t' = 0, about +y, radians; 0 if it does not turn.
    pub turn: f64,
    /// Point of the body that was hit: its place at t' = 0, in the body as it was placed. Bodies that stand
    /// still in their group have it where they were hit.
    pub material_position: DVec3,
    /// Doppler factor, 1 unless light is received in the geometry.
    pub doppler_factor: f64,
    /// Point of the triangle that was hit, of a body made of these.
    pub triangle: Option<TrianglePoint>,
}

impl Hit {
    /// Returns the normal as it is on the body at t' = 0.
    pub(crate) fn material_normal(&self) -> DVec3 {
        about_y(self.rest_normal, -self.turn)
    }
}

/// The turning of a hit: the angle that `body` had turned by, the point that was hit, and its own Doppler
/// factor.
pub(crate) struct Turned {
    pub proper_time: f64,
    pub turn: f64,
    pub material_position: DVec3,
    pub own_doppler: f64,
}

impl Turned {
    /// Returns the turning of a hit at `place` of a body with this `spin`, which `group_view` shows.
    pub fn new(spin: Option<Spin>, group_view: &GroupView, place: DVec3) -> Self {
        let proper_time = group_view.time_at(place);
        let Some(spin) = spin else {
            return Self { proper_time, turn: 0.0, material_position: place, own_doppler: 1.0 };
        };
        let turn = group_view.turn_at(&spin, place);
        let own_doppler = group_view.own_doppler(&spin, place);
        Self { proper_time, turn, material_position: spin.turned(place, -turn), own_doppler }
    }
}

/// The hits of a picture, row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub struct HitImage {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Hit at each pixel's centre, `None` where nothing is seen.
    pub hits: Vec<Option<Hit>>,
}
