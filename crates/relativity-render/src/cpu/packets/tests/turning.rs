//! Meetings of rays with bodies that turn, against the reference.

use glam::{DQuat, DVec3};

use super::{Case, Found, Random, cases_of_wheels};
use crate::geometry::intersect::Entry;
use crate::geometry::kind::Kind;
use crate::kinematics::spin::about_y;
use crate::scene::wheel::packed::Turns;

/// Error in f32, relative to the wheel's radius, and error after the last round, relative to the body's.
const PART: f64 = 2e-6;
const SETTLED: f64 = 1.5e-4;

/// Error of the Doppler factor, relative to itself times gamma.
const DOPPLER: f64 = 2e-4;

impl Case {
    fn entry_as_shown(&self, found: &Found) -> Option<Entry> {
        let ray = self.ray(found, DVec3::ZERO);
        match self.scene.turning(0) {
            Some(turning) => turning.entry(&ray, &self.group_view, None).0,
            None => self.scene.solid(0).entry(&ray),
        }
    }
}

#[test]
fn what_turns_is_met_where_it_is_shown() {
    let mut random = Random(5);
    let (mut hits, mut rays, mut wrong) = (0, 0, 0);
    let [mut most_clear, mut most_off, mut most_apart, mut most_doppler] = [0.0f64; 4];
    for (context, case) in cases_of_wheels() {
        let prepared = &case.scene.bodies()[0];
        let spin = prepared.spin.expect("it turns");
        let (solid, turns) = (case.scene.solid(0), case.group_view.turns(prepared));
        if turns == Turns::About && prepared.kind == Kind::Ring {
            // The tangents of a ray may meet the other side of what has a hole than the ray itself does.
            continue;
        }
        let radius = f64::from(prepared.placement.place_radius[3]);
        let allowed = SETTLED * radius + PART * spin.radius;
        for _ in 0..12 {
            let pixels = case.pixels(&mut random, 1.2);
            for (lane, found) in case.found_best(&pixels).into_iter().enumerate() {
                rays += 1;
                let entry = case.entry_as_shown(&found);
                let clearance = found.clearance.abs();
                if entry.is_some() != (found.clearance > 0.0) {
                    if clearance > 2.0 * allowed {
                        // Tangents may pass a corner that the ray meets, and of stout bodies the rounds may
                        // not settle.
                        assert!(prepared.kind != Kind::Tube, "{context}: {entry:?} but {found:?}");
                        wrong += 1;
                        continue;
                    }
                    most_clear = most_clear.max(clearance / allowed);
                }
                let Some(entry) = entry.filter(|_| clearance > 2.0 * allowed) else { continue };
                let place = case.middle() + found.place;
                let turn = case.group_view.turn_at(&spin, place);
                let cosine = entry.normal.dot(found.direction).abs();
                if cosine < 0.05 {
                    continue;
                }
                hits += 1;
                // The body is met where it is when that is shown, and where it first is.
                let hub = DVec3::from(spin.hub);
                let own = hub + about_y(place - hub, -turn) - solid.centre();
                let off = solid.form.answers().distance(own).0.abs() / allowed;
                let apart = place.distance(entry.position) * cosine / allowed;
                if off >= 1.0 || apart >= 4.0 {
                    assert!(prepared.kind != Kind::Tube, "{context}: {off} {apart} {entry:?} but {found:?}");
                    wrong += 1;
                    continue;
                }
                most_off = most_off.max(off);
                most_apart = most_apart.max(apart);

                let line = case.line_of_sight(pixels[0][lane], pixels[1][lane]);
                let truth = case.group_view.rest_ray(line).doppler_factor
                    * case.group_view.own_doppler(&spin, entry.position);
                let gamma = case.view.speed.gamma();
                let doppler = (found.own_doppler / truth - 1.0).abs() / gamma;
                most_doppler = most_doppler.max(doppler);
                assert!(doppler < DOPPLER, "{context}: D = {} for {truth}", found.own_doppler);

                if turns == Turns::Not {
                    continue;
                }
                let whole = DQuat::from_rotation_y(turn) * prepared.turn;
                let tilt = found.turn.dot(whole).abs();
                assert!((tilt - 1.0).abs() < 1e-6, "{context}: {} for {whole}", found.turn);
                let centre = solid.centre();
                let there = if turns == Turns::About {
                    assert!(found.from_hub.distance(place - hub) < 1e-6, "{context}");
                    place - (hub + about_y(centre - hub, turn))
                } else {
                    place - centre
                };
                assert!(found.there.distance(there) < 2e-6, "{context}: {} for {there}", found.there);
            }
        }
    }
    println!(
        "{hits} hits of {rays}, {wrong} wrong; {most_off} of what may be off, {most_apart} apart, wrong within {most_clear} of it, D {most_doppler:e} gamma"
    );
    assert!(hits > 5_000 && 200 * wrong < hits);
}
