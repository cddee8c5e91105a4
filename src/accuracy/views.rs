//! The views in which methods are measured: a point of the scene seen to come, to pass and to go.

use relativity_core::{Aperture, DomainError, SourcePoint, Speed, sighting};
use relativity_render::{Camera, Gaze, Geometry, View};
use serde::Serialize;

use crate::time_range::time_seen_at;

/// The place where the tracked point is seen. Its distance as it passes x = 0 is the unit of length here.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum TrackedPlace {
    /// At x = -3, coming.
    Approaching,
    /// At x = 0, passing.
    Abreast,
    /// At x = +3, going.
    Receding,
}

impl TrackedPlace {
    /// Every place, in the order of a ride.
    pub const ALL: [Self; 3] = [Self::Approaching, Self::Abreast, Self::Receding];

    /// Returns the name of the place.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Approaching => "approaching",
            Self::Abreast => "abreast",
            Self::Receding => "receding",
        }
    }

    /// The observation time at which `point` is seen there from the origin; 0 at rest, where it never moves,
    /// and outside the domain of the core.
    #[must_use]
    pub fn observation_time(self, speed: &Speed, point: SourcePoint) -> f64 {
        let ratio = match self {
            Self::Approaching => -3.0,
            Self::Abreast => 0.0,
            Self::Receding => 3.0,
        };
        time_seen_at(ratio, speed, point, Aperture::pair(0.0)).ok().flatten().unwrap_or_default()
    }
}

/// Returns the view of the left eye of a pair, `separation` apart, that looks at the rest-frame point
/// `tracked`.
///
/// # Errors
///
/// A place outside the domain of the core.
pub fn view_at(
    place: TrackedPlace,
    speed: Speed,
    tracked: [f64; 3],
    separation: f64,
    horizontal_fov: f64,
    size: [u32; 2],
) -> Result<View, DomainError> {
    let point = SourcePoint::from_rest(tracked, &speed);
    let [aperture, _] = Aperture::pair(separation);
    let observation_time = place.observation_time(&speed, point);
    let gaze = Gaze::along(sighting(&speed, point, aperture, observation_time)?.position);
    Ok(View {
        camera: Camera::new(aperture, gaze, horizontal_fov, size),
        speed,
        observation_time,
        geometry: Geometry::Seen,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_point_is_seen_where_it_is_said_to_be() {
        let point = SourcePoint { x0: 0.3, y: 3.0, z: -4.0 };
        for gamma in [1.01, 2.3, 70.7, 1000.0] {
            let speed = Speed::from_gamma(gamma).expect("it is a speed");
            for (place, x) in TrackedPlace::ALL.into_iter().zip([-15.0, 0.0, 15.0]) {
                let time = place.observation_time(&speed, point);
                let seen = sighting(&speed, point, Aperture::default(), time).expect("inside the domain");
                assert!((seen.position[0] - x).abs() < 1e-7, "{place:?} at gamma {gamma}: {seen:?}");
            }
        }
    }
}
