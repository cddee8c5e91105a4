//! Points of a wheel: they turn about an axle along y that moves along +x.
//!
//! Assembled while it turns, a wheel is in its own rest frame a rigid circle of radius W with straight, even
//! spokes. A point at rho W from the hub C is at P(t') = C + rho W (cos a, 0, sin a), a = `angle` - omega t',
//! in that frame: it turns as a wheel does that rolls towards +x. A camera event o at t0' sees it at the one
//! t' at which t0' - t' = |P(t') - o|: since |dP/dt'| = v < 1, the difference falls, and once only it is 0.
//! What is seen is what would be of a point that rests there, but for the Doppler factor: times sqrt(1 -
//! v^2)/(1 + v.n'), n' being the unit vector from o to P. A point of a rolling wheel on the road rests on the
//! ground: D = 1.
//!
//! # Accuracy
//!
//! As [`crate::sighting`]: X, z, t, t', R, D, phi and theta of points of rolling wheels, for beta from 0.01
//! to 1 - 1e-9, every rho and angle, wheels seen from 0.01 to 1,000 radii away; and disparities however close
//! the apertures are. Measured (`tests/oracle`, 2,000 inputs): median 0.2, 99 % 1.8, worst 3.6 units.
//!
//! Units grow with what the inputs tell: a rounding of the angle or of T moves t' by 1/(1 + v.n') times as
//! much as at rest, at most 1/(1 - v). So the colour of a point that rests on the road, D = 1, comes out
//! within 1e-12 up to gamma = 20, and within 1e-12 at every gamma up to 1e4 where its place is given.
//!
//! Derived here; not in the paper.

mod events;
mod pair;
mod root;
mod seen;

pub(crate) use pair::{EventStep, baseline, between_events};
pub use root::{MAX_STEPS, NEWTON_STEPS, measured_later, seen_later};
#[cfg(feature = "fit")]
pub(crate) use seen::SeenWheelPoint;
