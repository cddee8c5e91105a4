//! The f64 renderer on the CPU: the truth the other renderers are held against.
//!
//! Each ray is boosted into the rest frame of the bodies, where it is straight (see `View::rest_ray`), and the
//! nearest entry into a body is what the aperture sees.

use glam::DVec3;
use relativity_core::aberration;

use crate::body::Body;
use crate::intersect::Solid;
use crate::view::{Geometry, RestRay, View};

/// What one ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Number of the body, in the order given.
    pub body: usize,
    /// On its surface, in the rest frame.
    pub rest_position: DVec3,
    /// Outward unit normal in the rest frame.
    pub rest_normal: DVec3,
    /// From the aperture to the event of emission in the ground frame (in the rest frame for
    /// [`Geometry::Rest`]).
    pub distance: f64,
    /// Ground time of emission; the observation time itself for [`Geometry::Contracted`], whose light is
    /// instantaneous.
    pub emission_time: f64,
    /// Doppler factor, 1 unless the geometry is [`Geometry::Seen`].
    pub doppler_factor: f64,
}

/// Bodies prepared for tracing. Bodies may overlap; the nearest surface is seen.
#[derive(Debug, Clone)]
pub struct ReferenceScene {
    solids: Vec<Solid>,
}

impl ReferenceScene {
    /// Prepares `bodies`, numbered from 0 in this order.
    #[must_use]
    pub fn new(bodies: &[Body]) -> Self {
        Self { solids: bodies.iter().map(|body| Solid::new(&body.shape)).collect() }
    }

    /// What is seen along `line_of_sight` (unit vector, ground frame).
    #[must_use]
    pub fn first_hit(&self, view: &View, line_of_sight: DVec3) -> Option<Hit> {
        let ray = view.rest_ray(line_of_sight);
        let (body, entry) = self
            .solids
            .iter()
            .enumerate()
            .filter_map(|(body, solid)| Some((body, solid.entry(ray.origin, ray.direction)?)))
            .min_by(|a, b| a.1.distance.total_cmp(&b.1.distance))?;
        Some(Hit {
            body,
            rest_position: entry.position,
            rest_normal: entry.normal,
            distance: entry.distance * ray.ground_per_rest,
            emission_time: emission_time(view, line_of_sight, &ray, entry.distance),
            doppler_factor: ray.doppler_factor,
        })
    }
}

/// Ground time of the event at `rest_distance` along `ray`.
fn emission_time(view: &View, line_of_sight: DVec3, ray: &RestRay, rest_distance: f64) -> f64 {
    let received = view.observation_time;
    match view.geometry {
        Geometry::Seen => received - rest_distance * ray.ground_per_rest,
        Geometry::Contracted => received,
        // The inverse boost of (-s, s n) is -gamma s (1 - beta n_x).
        Geometry::Rest => {
            let [x, y, z] = line_of_sight.to_array();
            received - rest_distance / aberration::doppler_factor([-x, y, z], &view.speed)
        }
    }
}
