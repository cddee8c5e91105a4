//! When the light that a moving eye receives was emitted.

use super::eye::{EyeOnGround, Terms};
use super::point::PointView;
use crate::aperture::Aperture;
use crate::apparent::{LightCone, sighting_inside_domain};
use crate::stereo::smallest_terms;

/// Emission as an eye receives it: t by the ground's clocks, and tau by the point's own.
#[derive(Debug, Clone, Copy)]
pub(super) struct EmissionTimes {
    pub retarded_time: f64,
    pub proper_time: f64,
}

/// The point as the middle between the eyes sees it: a start for both eyes' times.
#[derive(Debug, Clone, Copy)]
pub(super) struct Middle {
    cone: LightCone<f64>,
    /// Line of sight of the middle, in the observer's axes.
    line: [f64; 3],
    retarded_time: f64,
    proper_time: f64,
}

impl Middle {
    /// The middle of `observer`, who is at its event: a resting aperture there receives the same light.
    pub fn new(view: &PointView) -> Self {
        let PointView { speed, point, observer, .. } = *view;
        let [x, y, z] = observer.place;
        let seen = sighting_inside_domain(speed, point, Aperture { x, y, z }, observer.time);
        let (cone, line) = view.line_of_sight(Aperture::default());
        Self { cone, line, retarded_time: seen.retarded_time, proper_time: seen.proper_time }
    }

    /// The times of what `eye` receives through its `cone`, at the event of `observer`.
    ///
    /// The eye's clock of the point is ahead of the middle's by b.(P + `P_m`)/(r + `r_m`), with b from the
    /// middle to the eye, P the places where both see it and r its distances in the point's rest frame. Of
    /// three sums for t the one with the smallest terms is taken.
    pub fn times_of_eye(
        &self,
        view: &PointView,
        eye: Aperture,
        cone: &LightCone<f64>,
        line: [f64; 3],
    ) -> EmissionTimes {
        let PointView { speed, point, observer, relative, .. } = view;
        let there = relative.aperture(eye);
        let (seen, middle) = (&cone.solution, &self.cone.solution);
        let rest_distances = relative.speed.gamma() * (seen.q + middle.q);
        let sum = [seen.x + middle.x, cone.y + self.cone.y, cone.z + self.cone.z];
        let along = [there.x * sum[0], there.y * sum[1], there.z * sum[2]];
        let sum: [f64; 3] = std::array::from_fn(|i| line[i] + self.line[i]);
        let along = smallest_terms(&along, &[eye.x * sum[0], eye.y * sum[1], eye.z * sum[2]]);
        let ahead = if rest_distances > 0.0 { along / rest_distances } else { 0.0 };
        let from_middle = [self.retarded_time, speed.gamma() * ahead, 0.0, 0.0, 0.0];
        let on_ground = EyeOnGround::new(speed, observer, eye);
        let [t_by_cone, own_by_cone] = on_ground.by_light_cone(speed, observer, *point);
        let by_distance = on_ground.by_distance(observer, line, seen.r);
        let own_from_middle = [self.proper_time, ahead, 0.0, 0.0, 0.0];
        EmissionTimes {
            retarded_time: sum_that_cancels_least(t_by_cone, &[from_middle, by_distance]),
            proper_time: sum_that_cancels_least(own_by_cone, &[own_from_middle]),
        }
    }
}

/// Chooses among several sums for the same number: `direct`, unless another has far smaller terms. (The
/// others start from what the middle between the eyes sees, which may be known less well.)
fn sum_that_cancels_least(direct: Terms, others: &[Terms]) -> f64 {
    let size = |terms: &Terms| terms.iter().map(|term| term.abs()).sum::<f64>();
    let smaller = |a, b| if FAR_SMALLER * size(b) < size(a) { b } else { a };
    others.iter().fold(&direct, smaller).iter().sum()
}

/// Factor by which terms have to be smaller: what is gained must be more than what the middle may be known
/// less well.
const FAR_SMALLER: f64 = 4.0;
