//! Velocity and place of a point in the frame of a moving observer.

use super::error::ObserverError;
use super::motion::Observer;
use super::relative_velocity::RelativeVelocity;
use crate::aperture::Aperture;
use crate::apparent::LightCone;
use crate::cone_pair::{ConePair, SightPair};
use crate::one_cone::middle;
use crate::source::SourcePoint;
use crate::speed::Speed;
use crate::stereo::{dot, smallest_terms};
use crate::wheel::baseline;

/// A point that moves along the first of three axes, as the observer measures it.
///
/// In these axes the formulas for an observer at rest hold, with the observer's proper time in place of T.
#[derive(Debug, Clone, Copy)]
pub(super) struct RelativeMotion {
    /// Speed of the point past the observer.
    pub speed: Speed,
    /// The point in these axes, when the observer's clock shows 0.
    pub point: SourcePoint,
    /// Unit vectors in the observer's axes: along the point's velocity, and two across it.
    axes: [[f64; 3]; 3],
    /// The point's place in the observer's axes is this, plus its proper velocity times its own time since
    /// the event at which the ground has it at the same time as the observer.
    apart: [f64; 3],
    proper: [f64; 3],
    /// Proper time of the point from that event until the observer's clock shows 0.
    own_delay: f64,
}

impl RelativeMotion {
    /// The motion of `point`, which moves along +x at `speed`, against `observer`.
    ///
    /// With W, V, e and h as in [`RelativeVelocity::new`], its place, from r = where it is on the ground at
    /// the event of the observer, is
    ///
    /// ```text
    /// along W:  -[gamma^2 Gamma r_x (v_x - beta) + Gamma V h r_e]/(gamma' |W|)
    /// across:    gamma Gamma [V h r_x - (v_x - beta) r_e]/|W|,     r_c
    /// ```
    pub fn new(speed: &Speed, observer: &Observer, point: SourcePoint) -> Result<Self, ObserverError> {
        let Observer { velocity, place: [ox, oy, oz], time } = *observer;
        let own = velocity.speed();
        let [rx, ry, rz] = [(point.x0 - ox) + speed.beta() * time, point.y - oy, point.z - oz];
        let r = [rx, ry, rz];
        let ahead = dot(r, velocity.direction());
        let stretch = own.gamma_minus_one() * ahead;
        let apart = std::array::from_fn(|i| r[i] + stretch * velocity.direction()[i]);

        let past = RelativeVelocity::new(speed, &velocity)?;
        let RelativeVelocity { speed: relative, axes, lead, proper, .. } = past;
        if proper == 0.0 {
            let point = SourcePoint { x0: speed.gamma() * rx, y: ry, z: rz };
            let apart = [point.x0, ry, rz];
            return Ok(Self { speed: relative, point, axes, apart, proper: [0.0; 3], own_delay: 0.0 });
        }
        let (sine, [ey, ez]) = (velocity.sine(), velocity.across_street());
        let (r_e, r_c) = (ry * ey + rz * ez, rz * ey - ry * ez);
        let swerve = own.beta() * sine;
        let point = SourcePoint {
            x0: -(speed.gamma() * speed.gamma() * own.gamma() * rx * lead.along_x
                + own.gamma() * swerve * r_e)
                / (relative.gamma() * proper),
            y: speed.gamma() * own.gamma() * (swerve * rx - lead.along_x * r_e) / proper,
            z: r_c,
        };
        Ok(Self {
            speed: relative,
            point,
            axes,
            apart,
            proper: axes[0].map(|part| proper * part),
            own_delay: own.proper() * ahead / relative.gamma(),
        })
    }

    /// An aperture in the observer's axes, in these.
    pub fn aperture(&self, Aperture { x, y, z }: Aperture) -> Aperture {
        let [x, y, z] = self.axes.map(|[ax, ay, az]| x * ax + y * ay + z * az);
        Aperture { x, y, z }
    }

    /// A vector in these axes, in the observer's.
    pub fn in_observer_axes(&self, vector: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| self.turned_terms(vector)[i].iter().sum())
    }

    /// The line of sight from the aperture at `eye`, in the observer's axes, by its `cone` in these at
    /// `proper_time` of the observer.
    pub fn line_of_sight(&self, eye: Aperture, cone: &LightCone<f64>, proper_time: f64) -> [f64; 3] {
        let turned = self.turned_terms([cone.solution.x, cone.y, cone.z]);
        let since = [self.own_delay, proper_time / self.speed.gamma(), -cone.solution.r / self.speed.gamma()];
        let eye = [eye.x, eye.y, eye.z];
        std::array::from_fn(|i| {
            let [delay, time, flight] = since.map(|own| self.proper[i] * own);
            smallest_terms(&turned[i], &[self.apart[i] - eye[i], delay, time, flight])
        })
    }

    /// Both lines of sight from the `pair` of apertures in the observer's axes, by their `cones` in these;
    /// none of a point inside both.
    ///
    /// A turn mixes all parts of a vector, so that a small one is only known to a rounding of the large.
    /// Where both velocities are low, or hardly differ, each part on its own is known better.
    pub fn lines_of_sight(
        &self,
        pair: [Aperture; 2],
        cones: &ConePair<f64>,
        proper_time: f64,
    ) -> Option<SightPair<f64>> {
        let lines = self.lines_of_sight_there(pair, cones)?;
        let [left, right] = pair;
        let each = [
            self.line_of_sight(left, &cones.left, proper_time),
            self.line_of_sight(right, &cones.right, proper_time),
        ];
        let excess = self.in_observer_axes(lines.excess);
        let baseline = baseline(pair);
        let [mean, difference, normal] =
            [lines.mean, lines.difference, lines.normal].map(|vector| self.turned_terms(vector));
        let mean = std::array::from_fn(|i| smallest_terms(&mean[i], &[0.5 * each[0][i], 0.5 * each[1][i]]));
        let difference = std::array::from_fn(|i| smallest_terms(&difference[i], &[baseline[i], excess[i]]));
        // P_l x P_r from the shorter of both, in which less cancels.
        let shorter = each[usize::from(cones.right.solution.r < cones.left.solution.r)];
        let normal = std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let crossed = [baseline, excess].map(|v| [v[j] * shorter[k], -v[k] * shorter[j]]);
            smallest_terms(&normal[i], crossed.as_flattened())
        });
        Some(SightPair { each, mean, difference, normal, excess })
    }

    /// Returns the lines of sight in these axes.
    pub fn lines_of_sight_there(&self, pair: [Aperture; 2], cones: &ConePair<f64>) -> Option<SightPair<f64>> {
        let middle = self.aperture(middle(pair));
        cones.lines_of_sight(self.point.y - middle.y, self.point.z - middle.z)
    }

    /// The terms of each part of a vector in these axes, in the observer's.
    fn turned_terms(&self, vector: [f64; 3]) -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|axis| vector[axis] * self.axes[axis][i]))
    }
}
