//! Bounds of a turning body in one view: capsules around the places where it is shown.
//!
//! At one camera event each material point has one place where it is shown, so a straight spoke is shown as a
//! bent tube that stands still in the rest frame. Where a point moves at v and the places shown at one time
//! lie across the slowness p (the direction n' of the light, or beta along the motion where a time of the
//! camera is shown), a step d of the body is shown as d - v (p.d)/(1 + v.p). That gives the axis its
//! tangents. And 1 + v.p changes no faster than the body turns and the direction of the light does, nor falls
//! below 1 - |v| |p|: that gives a ball around it a reach.

use glam::DVec3;
use relativity_core::math;

use crate::geometry::capsule::Capsule;
use crate::kinematics::spin::{MaterialPoint, Spin, about_y};
use crate::view::Geometry;
use crate::view::group_view::GroupView;

/// Greatest number of halvings of an axis.
const MAX_HALVINGS: u32 = 6;
/// A piece is halved that departs from its chord by more than the body's radius and this part of its length.
const LOOSE: f64 = 0.03;
/// The greatest value of t (1 - t)^2: how far a cubic departs from its chord, in parts of what its tangents
/// do.
const BULGE: f64 = 4.0 / 27.0;
/// Bulges are this much larger than those of cubics.
const BULGE_ROOM: f64 = 1.5;
/// Relative change of 1 + v.p up to which a piece is shown much like a cubic.
const STEADY: f64 = 0.5;

/// A place on the axis of a body.
#[derive(Debug, Clone, Copy)]
struct Station {
    /// From 0 at one end to 1 at the other.
    share: f64,
    /// Place where the point is shown.
    place: DVec3,
    /// Change of that place with the share along the axis.
    tangent: DVec3,
    /// Distance of the point from the axle.
    off_axle: f64,
    /// Angular speed, |omega|.
    omega: f64,
    /// |p|, and how near the camera comes to what [`Self::reach`] covers: infinite where p does not change.
    slowness: f64,
    nearest: f64,
    /// Rate 1 + v.p.
    rate: f64,
}

impl Station {
    /// Returns the greatest speed of everything within `radius`, and the greatest change of 1 + v.p per step
    /// from there.
    fn steepness(&self, radius: f64) -> [f64; 2] {
        let speed = self.omega * (self.off_axle + radius);
        [speed, self.omega * self.slowness + speed / self.nearest]
    }

    /// Returns the greatest distance at which the ball of this `radius` around it is shown; infinite where
    /// there is no bound.
    fn reach(&self, radius: f64) -> f64 {
        let [speed, steepness] = self.steepness(radius);
        let least = 1.0 - speed * self.slowness;
        if least <= 0.0 {
            return f64::INFINITY;
        }
        // The time in which what falls from `first` to `least` adds up to the `delay`.
        let first = (self.rate - steepness * radius).max(least);
        let bend = (speed * steepness).max(f64::MIN_POSITIVE);
        let delay = radius * self.slowness;
        let falling = (first - least) / bend;
        let fallen = 0.5 * (first + least) * falling;
        let time = if fallen < delay {
            falling + (delay - fallen) / least
        } else {
            2.0 * delay / (first + (first * first - 2.0 * bend * delay).max(0.0).sqrt())
        };
        let reach = radius + speed * time;
        if reach <= self.nearest { reach } else { f64::INFINITY }
    }

    /// Whether 1 + v.p is much the same at all that is within `radius`.
    fn is_steady(&self, radius: f64) -> bool {
        let [_, steepness] = self.steepness(radius);
        steepness * self.reach(radius) < STEADY * self.rate
    }
}

impl GroupView {
    /// Adds capsules to `out` that surely contain, in the rest frame, what this view shows of a body that is
    /// contained in `capsules` at t' = 0 and turns so; [`Geometry::Published`] and [`Geometry::OneCone`] as
    /// [`Geometry::Seen`] from its origin.
    pub(crate) fn capsules_when_shown(&self, spin: &Spin, capsules: &[Capsule], out: &mut Vec<Capsule>) {
        for capsule in capsules {
            let first = self.station(spin, capsule, 0.0);
            if capsule.from == capsule.to {
                out.push(bounded(spin, capsule, Capsule::ball(first.place, first.reach(capsule.radius))));
                continue;
            }
            self.add_piece(spin, capsule, [first, self.station(spin, capsule, 1.0)], MAX_HALVINGS, out);
        }
    }

    /// Adds what contains `capsule` between two stations: one capsule, or those of its halves if they are
    /// smaller.
    fn add_piece(
        &self,
        spin: &Spin,
        capsule: &Capsule,
        [first, last]: [Station; 2],
        halvings: u32,
        out: &mut Vec<Capsule>,
    ) {
        let chord = last.place - first.place;
        let along = chord.normalize_or_zero();
        let departure = |station: Station| {
            let tangent = station.tangent * (last.share - first.share);
            // One that doubles back goes beyond the end.
            let is_ahead = tangent.dot(along) > 0.0;
            if is_ahead { tangent.reject_from(along).length() } else { (tangent - chord).length() }
        };
        let bulge = BULGE_ROOM * BULGE * (departure(first) + departure(last));
        let [from, to] = [first, last].map(|station| capsule.from.lerp(capsule.to, station.share));
        let half = 0.5 * from.distance(to);
        // The tangents at the ends of a whole axis could hide that it is bent to both sides.
        let is_cubic = halvings < MAX_HALVINGS && [first, last].iter().all(|station| station.is_steady(half));
        let radius = [first, last].map(|station| {
            if is_cubic {
                station.reach(capsule.radius) + bulge
            } else {
                station.reach(capsule.radius + half)
            }
        });
        let shown = Capsule { from: first.place, to: last.place, radius: radius[0].max(radius[1]) };
        let whole = bounded(spin, &Capsule { from, to, ..*capsule }, shown);
        let before = out.len();
        if halvings > 0 && !(is_cubic && bulge <= capsule.radius + LOOSE * chord.length()) {
            let middle = self.station(spin, capsule, 0.5 * (first.share + last.share));
            self.add_piece(spin, capsule, [first, middle], halvings - 1, out);
            self.add_piece(spin, capsule, [middle, last], halvings - 1, out);
            if out[before..].iter().map(area).sum::<f64>() < area(&whole) {
                return;
            }
            out.truncate(before);
        }
        out.push(whole);
    }

    /// The place on the axis of `capsule` at this `share`.
    fn station(&self, spin: &Spin, capsule: &Capsule, share: f64) -> Station {
        let rest = capsule.from.lerp(capsule.to, share);
        let place = self.place_when_shown(MaterialPoint { rest, spin: Some(*spin) });
        let omega = spin.omega(self.on_ground.beta());
        let off_axle = spin.off_axle(place);
        let velocity = DVec3::Y.cross(off_axle) * omega;
        let slowness = self.slowness(place);
        let rate = 1.0 + velocity.dot(slowness);
        let step = about_y(capsule.to - capsule.from, self.turn_at(spin, place));
        let tangent = step - velocity * (slowness.dot(step) / rate);
        let is_fixed = self.geometry == Geometry::Contracted;
        Station {
            share,
            place,
            tangent,
            off_axle: off_axle.length(),
            omega: omega.abs(),
            slowness: slowness.length(),
            nearest: if is_fixed { f64::INFINITY } else { 0.5 * place.distance(self.origin) },
            rate,
        }
    }

    /// The time by which what is shown happens earlier, per step from `place`.
    fn slowness(&self, place: DVec3) -> DVec3 {
        if self.geometry == Geometry::Contracted {
            self.slowness_when_measured()
        } else {
            (place - self.origin).normalize_or_zero()
        }
    }
}

/// Returns the area of the rectangle around its image from the side.
fn area(capsule: &Capsule) -> f64 {
    2.0 * capsule.radius * (capsule.from.distance(capsule.to) + 2.0 * capsule.radius)
}

/// The smaller of `shown` and the ball that `capsule` never leaves, however it turns.
fn bounded(spin: &Spin, capsule: &Capsule, shown: Capsule) -> Capsule {
    let [from, to] = [capsule.from, capsule.to].map(|end| spin.off_axle(end));
    let off_axle = from.length().max(to.length()) + capsule.radius;
    let (low, high) = (capsule.from.y.min(capsule.to.y), capsule.from.y.max(capsule.to.y));
    let half_width = 0.5 * (high - low) + capsule.radius;
    let [x, _, z] = spin.hub;
    let ball = Capsule::ball(DVec3::new(x, 0.5 * (low + high), z), math::hypot(off_axle, half_width));
    if area(&shown) < area(&ball) { shown } else { ball }
}

#[cfg(test)]
mod tests {
    use relativity_core::{Aperture, Speed, Turning};

    use super::*;
    use crate::camera::{Camera, Gaze};
    use crate::kinematics::velocity::{Motion, Velocity};
    use crate::view::View;

    const HUB: [f64; 3] = [0.4, 3.0, 0.5];
    const SPIN: Spin = Spin { hub: HUB, radius: 0.5, turning: Turning::Rolling };

    /// The `i`-th number of a sequence that fills [0, 1).
    fn spread(i: u32, prime: f64) -> f64 {
        (f64::from(i) * prime.sqrt()).fract()
    }

    fn spokes() -> impl Iterator<Item = Capsule> {
        (0..7).map(|i| {
            let (sine, cosine) = math::sin_cos(f64::from(i));
            let at = |share: f64, y: f64| {
                DVec3::from(HUB) + DVec3::new(cosine, 0.0, sine) * share * 0.5 + DVec3::Y * y
            };
            let radius = [0.002, 0.02][i as usize % 2];
            Capsule { from: at(0.06, 0.04), to: at(0.97, 0.0), radius }
        })
    }

    fn views() -> impl Iterator<Item = GroupView> {
        let betas = [0.1, 0.5, 0.9, 0.99, 0.999];
        let geometries = [Geometry::Seen, Geometry::Contracted, Geometry::Rest];
        let motions = [1.0, -1.0];
        betas.into_iter().flat_map(move |beta| {
            geometries.into_iter().flat_map(move |geometry| {
                motions.into_iter().flat_map(move |sign| {
                    (0..12).map(move |i| {
                        let aperture = Aperture { x: 0.05, y: [0.0, 2.98][i % 2], z: 0.3 };
                        let view = View {
                            camera: Camera::new(aperture, Gaze::STRAIGHT_AHEAD, 1.0, [8, 8]),
                            speed: Speed::from_beta(beta).expect("below 1"),
                            observation_time: 0.9 * i as f64 - 4.0,
                            geometry,
                        };
                        let velocity = Velocity::from_beta(sign * beta).expect("below 1");
                        view.of_group(if sign > 0.0 { Motion::Scene } else { Motion::Own(velocity) })
                    })
                })
            })
        })
    }

    #[test]
    fn what_is_shown_of_a_spoke_lies_in_its_capsules() {
        let mut excess = Vec::new();
        for view in views() {
            for (number, spoke) in (0..).zip(spokes()) {
                let mut capsules = Vec::new();
                view.capsules_when_shown(&SPIN, &[spoke], &mut capsules);
                excess.push(capsules.iter().map(area).sum::<f64>() / area(&spoke));
                for i in 100 * number..100 * (number + 1) {
                    let direction = DVec3::new(spread(i, 2.0), spread(i, 3.0), spread(i, 5.0)) * 2.0 - 1.0;
                    let off_axis = direction.normalize() * spoke.radius * spread(i, 7.0).cbrt();
                    let rest = spoke.from.lerp(spoke.to, spread(i, 11.0)) + off_axis;
                    let shown = view.place_when_shown(MaterialPoint { rest, spin: Some(SPIN) });
                    let outside = capsules.iter().map(|capsule| outside(capsule, shown));
                    let outside = outside.fold(f64::INFINITY, f64::min);
                    assert!(outside <= 0.0, "{view:?}: {rest} is shown {outside} outside");
                }
            }
        }
        let mean = excess.iter().sum::<f64>() / excess.len() as f64;

        assert!(mean < 10.0, "the images of capsules are {mean} times as large as those of spokes");
    }

    fn outside(capsule: &Capsule, place: DVec3) -> f64 {
        let axis = capsule.to - capsule.from;
        let along = (place - capsule.from).dot(axis) / axis.length_squared().max(1e-300);
        place.distance(capsule.from + axis * along.clamp(0.0, 1.0)) - capsule.radius
    }
}
