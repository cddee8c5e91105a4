//! Where one view shows a body that turns: capsules around it.
//!
//! At one camera event each material point has one place where it is shown, so a straight spoke is shown as a bent tube
//! that stands still in the rest frame. Where a point moves at v and the places shown at one time lie across the
//! slowness p (the direction n' of the light, or beta along x where a time of the ground is shown), a step d of the
//! body is shown as d - v (p.d)/(1 + v.p). That gives the axis its tangents, and a ball around it a reach.

use glam::DVec3;
use relativity_core::math;

use crate::capsule::Capsule;
use crate::group_view::GroupView;
use crate::view::Geometry;
use crate::wheel::spin::{MaterialPoint, Spin, about_y};

/// How many pieces an axis has at least.
const PIECES: u32 = 2;
/// How often a piece is halved at most.
const MAX_HALVINGS: u32 = 5;
/// A piece is halved that departs from its chord by more than the body's radius and this part of its length.
const LOOSE: f64 = 0.03;
/// The greatest value of t (1 - t)^2: how far a cubic departs from its chord, in parts of what its tangents do.
const BULGE: f64 = 4.0 / 27.0;
/// Bulges are this much larger than those of cubics.
const BULGE_ROOM: f64 = 1.5;
/// 1 + v.p may change within a ball by this part of itself; its reach is then this much larger at most.
const STEADY: f64 = 0.2;
const REACH_ROOM: f64 = 1.35;

/// A place on the axis of a body.
#[derive(Debug, Clone, Copy)]
struct Station {
    /// From 0 at one end to 1 at the other.
    share: f64,
    /// Where it is shown.
    place: DVec3,
    /// How fast that moves with the share.
    tangent: DVec3,
    /// How far the ball around it is shown at most; infinite where that cannot be said.
    reach: f64,
}

impl GroupView {
    /// Adds capsules to `out` that surely contain, in the rest frame, what this view shows of a body that is contained in
    /// `capsules` at t' = 0 and turns so; [`Geometry::Published`] and [`Geometry::OneCone`] as [`Geometry::Seen`] from
    /// its origin.
    pub(crate) fn capsules_when_shown(&self, spin: &Spin, capsules: &[Capsule], out: &mut Vec<Capsule>) {
        for capsule in capsules {
            let station = |share| self.station(spin, capsule, share);
            let mut first = station(0.0);
            if capsule.from == capsule.to {
                out.push(bounded(spin, capsule, Capsule::ball(first.place, first.reach)));
                continue;
            }
            for piece in 1..=PIECES {
                let last = station(f64::from(piece) / f64::from(PIECES));
                self.add_piece(spin, capsule, [first, last], MAX_HALVINGS, out);
                first = last;
            }
        }
    }

    /// Adds what contains `capsule` between two stations.
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
        let bulge = if chord == DVec3::ZERO {
            f64::INFINITY
        } else {
            BULGE_ROOM * BULGE * (departure(first) + departure(last))
        };
        let reach = first.reach.max(last.reach);
        let is_loose = bulge > capsule.radius + LOOSE * chord.length() || reach == f64::INFINITY;
        if is_loose && halvings > 0 {
            let middle = self.station(spin, capsule, 0.5 * (first.share + last.share));
            self.add_piece(spin, capsule, [first, middle], halvings - 1, out);
            self.add_piece(spin, capsule, [middle, last], halvings - 1, out);
            return;
        }
        let [from, to] = [first, last].map(|station| capsule.from.lerp(capsule.to, station.share));
        let piece = Capsule { from, to, ..*capsule };
        out.push(bounded(spin, &piece, Capsule { from: first.place, to: last.place, radius: reach + bulge }));
    }

    /// The place on the axis of `capsule` at this `share`.
    fn station(&self, spin: &Spin, capsule: &Capsule, share: f64) -> Station {
        let rest = capsule.from.lerp(capsule.to, share);
        let place = self.place_when_shown(MaterialPoint { rest, spin: Some(*spin) });
        let omega = spin.omega(self.on_ground.beta());
        let velocity = DVec3::Y.cross(spin.off_axle(place)) * omega;
        let slowness = self.slowness(place);
        let g = 1.0 + velocity.dot(slowness);
        let shear = velocity / g;
        let step = about_y(capsule.to - capsule.from, self.turn_at(spin, place));
        let tangent = step - shear * slowness.dot(step);
        // The greatest that a unit step is shown: the largest singular value of 1 - shear slowness^T.
        let trace = 2.0 - 2.0 * shear.dot(slowness) + shear.length_squared() * slowness.length_squared();
        let determinant = 1.0 - shear.dot(slowness);
        let spread = (0.25 * trace * trace - determinant * determinant).max(0.0);
        let reach = (0.5 * trace + spread.sqrt()).sqrt() * capsule.radius;
        // How fast 1 + v.p changes at most: by turning, and by the direction of the light.
        let nearest = place.distance(self.origin) - 2.0 * reach;
        let turning = if self.geometry == Geometry::Contracted { 0.0 } else { velocity.length() / nearest };
        let is_steady = nearest > 0.0 && (omega.abs() * slowness.length() + turning) * reach < STEADY * g;
        Station { share, place, tangent, reach: if is_steady { REACH_ROOM * reach } else { f64::INFINITY } }
    }

    /// By how much earlier what is shown happens, per step from `place`.
    fn slowness(&self, place: DVec3) -> DVec3 {
        if self.geometry == Geometry::Contracted {
            DVec3::X * self.on_ground.beta()
        } else {
            (place - self.origin).normalize_or_zero()
        }
    }
}

/// The smaller of `shown` and the ball that `capsule` never leaves, however it turns.
fn bounded(spin: &Spin, capsule: &Capsule, shown: Capsule) -> Capsule {
    let [from, to] = [capsule.from, capsule.to].map(|end| spin.off_axle(end));
    let off_axle = from.length().max(to.length()) + capsule.radius;
    let (low, high) = (capsule.from.y.min(capsule.to.y), capsule.from.y.max(capsule.to.y));
    let half_width = 0.5 * (high - low) + capsule.radius;
    let [x, _, z] = spin.hub;
    let ball = Capsule::ball(DVec3::new(x, 0.5 * (low + high), z), math::hypot(off_axle, half_width));
    if shown.radius + 0.5 * shown.from.distance(shown.to) < ball.radius { shown } else { ball }
}

#[cfg(test)]
mod tests {
    use relativity_core::{Aperture, Speed, Turning};

    use super::*;
    use crate::camera::{Camera, Gaze};
    use crate::velocity::{Motion, Velocity};
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
        let (mut volume, mut count) = (0.0, 0);
        for view in views() {
            for (number, spoke) in (0..).zip(spokes()) {
                let mut capsules = Vec::new();
                view.capsules_when_shown(&SPIN, &[spoke], &mut capsules);
                volume += capsules.iter().map(|capsule| capsule.radius).fold(0.0, f64::max) / spoke.radius;
                count += 1;
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
        let mean = volume / f64::from(count);

        assert!(mean < 10.0, "capsules are {mean} times as thick as spokes");
    }

    fn outside(capsule: &Capsule, place: DVec3) -> f64 {
        let axis = capsule.to - capsule.from;
        let along = (place - capsule.from).dot(axis) / axis.length_squared().max(1e-300);
        place.distance(capsule.from + axis * along.clamp(0.0, 1.0)) - capsule.radius
    }
}
