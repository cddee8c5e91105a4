//! The street and the way of whoever rides, as the map has them.

use glam::DVec3;
use relativity_render::{Motion, Velocity};

use super::{MapInstant, MapProjection};
use crate::scene::Scene;
use crate::settings::{MapFrame, Settings};
use crate::time_range;

/// Distance along the street between the two places that a line is given by.
const STEP: f64 = 10.0;
/// Pieces of a drawn way.
const PIECES: i32 = 128;

/// A straight line of the street on a chart: two places on it, right and up, and its name.
type StreetLine = ([[f64; 2]; 2], &'static str);

/// Returns the kerbs and the foot of the house fronts from above, and the ground from the side, as `instant`
/// measures them: of a ground that leans towards the eyes or away from them, where it is straight below them.
#[must_use]
pub fn street_lines(instant: &MapInstant, scene: &Scene, projection: MapProjection) -> Vec<StreetLine> {
    let places = instant.places(Motion::Own(Velocity::REST));
    let near = instant.observer().place[0];
    let ground = scene.ground_z.unwrap_or_default();
    let flat = |y: &dyn Fn(f64) -> f64| {
        [near, near + STEP].map(|x| projection.flat(places.measured(DVec3::new(x, y(x), ground))))
    };
    match projection {
        MapProjection::Plan => {
            let names = ["kerb", "kerb", "house fronts"];
            let lines = scene.street.into_iter().flatten().zip(names);
            lines.map(|(y, name)| (flat(&|_| y), name)).collect()
        }
        MapProjection::Side => {
            let eyes = instant.middle();
            // What is measured is linear in where it rests.
            let below = |x: f64| {
                let [here, next] = [0.0, 1.0].map(|y| places.measured(DVec3::new(x, y, ground)).y);
                (eyes.y - here) / (next - here)
            };
            scene.ground_z.map(|_| (flat(&below), "ground")).into_iter().collect()
        }
    }
}

/// Returns the places of the middle between the eyes at evenly spread times of the clock in this range, on
/// the map of `settings` at `time`; none in the frame of whoever rides, and none of who keeps to the street.
#[must_use]
pub fn way_of_rider(settings: &Settings, time: f64, range: [f64; 2]) -> Vec<DVec3> {
    if !settings.ride.leaves_street() || settings.map_frame() == MapFrame::Rider {
        return Vec::new();
    }
    let frame = settings.frame(time);
    let place = |piece: i32| {
        let observer =
            settings.rider(time_range::time_within(range, f64::from(piece) / f64::from(PIECES))).observer();
        let place = DVec3::from(observer.place);
        DVec3 { x: frame.event_at(observer.place, observer.time).x, ..place }
    };
    (0..=PIECES).map(place).collect()
}
