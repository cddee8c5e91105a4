//! The ride of the settings, worked out once: where each leg ends is kept, so that any moment of it is found
//! by bisection.

use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use relativity_core::{Leg, Ride, RideMoment};

use crate::flags::StreetVelocity;

/// A ride that is worked out.
#[derive(Debug)]
pub struct Course {
    legs: Arc<[Leg]>,
    start: RideStart,
    /// Whether no leg pushes aside.
    pub is_straight: bool,
    /// The ride, with its line as x unless it is all along the street.
    pub ride: Ride,
}

/// The settings that a ride starts with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RideStart {
    /// Speed with which the ride starts.
    pub speed: StreetVelocity,
    /// Place, azimuth and elevation, as they are set.
    pub numbers: [f64; 3],
}

/// The course of the last settings that asked for it. It is no setting: all are equal.
#[derive(Default)]
pub struct KeptCourse(Arc<Mutex<Option<Arc<Course>>>>);

impl Course {
    fn is_of(&self, start: RideStart, legs: &Arc<[Leg]>) -> bool {
        Arc::ptr_eq(&self.legs, legs) && self.start == start
    }
}

impl KeptCourse {
    /// Returns the course of `legs` from this `start`, whose `moment` it is if all is straight, or if not.
    pub fn of(
        &self,
        start: RideStart,
        legs: &Arc<[Leg]>,
        moment: impl FnOnce(bool) -> RideMoment,
    ) -> Arc<Course> {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let course = kept.take().filter(|course| course.is_of(start, legs)).unwrap_or_else(|| {
            let is_aside = |Leg { acceleration: [_, left, up], .. }: &Leg| [*left, *up] != [0.0; 2];
            let is_straight = !legs.iter().any(is_aside);
            let ride = Ride::new(moment(is_straight), Arc::clone(legs));
            Arc::new(Course { legs: Arc::clone(legs), start, is_straight, ride })
        });
        Arc::clone(kept.insert(course))
    }
}

impl Clone for KeptCourse {
    fn clone(&self) -> Self {
        // Each has its own: settings that differ would displace each other's.
        Self(Arc::new(Mutex::new(self.0.lock().unwrap_or_else(PoisonError::into_inner).clone())))
    }
}

impl PartialEq for KeptCourse {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl fmt::Debug for KeptCourse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("KeptCourse")
    }
}
