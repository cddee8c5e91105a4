//! The curves of a point on a wheel that rolls, with their derivatives.
//!
//! The point is seen where one is that rests at C + q, and that tells the time t' of its light, of which the
//! angle a = angle - omega t' depends in turn. With u for the direction in which a point of the wheel moves,
//! n' that towards it, and r its distance from the axle,
//!
//! ```text
//! dq = -r u da,    da = d(angle) - t' d(omega) - omega dt',
//! dt' (1 + omega r u.n') = dt' at a fixed q + r u.n' (d(angle) - t' d(omega))
//! ```

use crate::aperture::Aperture;
use crate::apparent::LightCone;
use crate::fit::gradients::{D_Y, D_Z, Gradient, Slopes, angle_gradients, delay_gradient, x_gradient};
use crate::fit::trial::{Rolling, Trial};
use crate::math;
use crate::model::Model;
use crate::one_cone::{self, middle};
use crate::source::WheelPoint;
use crate::wheel::{SeenWheelPoint, baseline};

impl Rolling {
    /// Delta-phi and Delta-theta, with 0 for what is not `wanted`, of the wheel whose hub is the trial
    /// object; `time` counts from its passage.
    pub(crate) fn angles(
        &self,
        trial: &Trial,
        model: Model,
        pair: &[Aperture; 2],
        time: f64,
        wanted: [bool; 2],
    ) -> [f64; 2] {
        let (wheel, speed) = (self.point(trial), &trial.speed);
        let (dphi, dtheta) = match model {
            Model::Exact => wheel.seen_by_pair(speed, *pair, time, baseline(*pair)).angle_differences(),
            Model::OneCone => {
                let seen = wheel.seen(speed, middle(*pair), time);
                one_cone::cone_pair(&seen.cone, *pair).angle_differences()
            }
            Model::Published(variant) => {
                wheel.seen_as_published(speed, *pair, time, variant).0.angle_differences()
            }
        };
        [if wanted[0] { dphi } else { 0.0 }, if wanted[1] { dtheta } else { 0.0 }]
    }

    /// Delta-phi and Delta-theta of the point, with their gradients.
    pub(crate) fn slopes(
        &self,
        trial: &Trial,
        model: Model,
        pair: &[Aperture; 2],
        time: f64,
        wanted: [bool; 2],
    ) -> Slopes {
        let (wheel, speed) = (self.point(trial), &trial.speed);
        let sight = |time: f64, dtime: Gradient| ApertureSight { trial, wheel: &wheel, time, dtime };
        let dtime = [0.0, 0.0, 0.0, -1.0];
        let ((dphi, dtheta), gradients) = match model {
            Model::Exact => {
                let both = wheel.seen_by_pair(speed, *pair, time, baseline(*pair));
                let gradients = both.each.map(|seen| sight(time, dtime).angle_gradients(&seen));
                (both.angle_differences(), gradients)
            }
            Model::OneCone => {
                let seen = wheel.seen(speed, middle(*pair), time);
                let [dx, dz] = sight(time, dtime).place_gradients(&seen);
                let cones = one_cone::cone_pair(&seen.cone, *pair);
                let gradients = [cones.left, cones.right].map(|cone| angle_gradients(&cone, dx, dz));
                (cones.angle_differences(), gradients)
            }
            Model::Published(variant) => {
                let (both, shift) = wheel.seen_as_published(speed, *pair, time, variant);
                let [first, second] = &both.each;
                let [dx, dz] = sight(time, dtime).place_gradients(first);
                let to_secondary = first.cone.solution.x - (pair[1].x - pair[0].x);
                let ddelay = delay_gradient(&first.cone, to_secondary, dx, dz);
                let dtime = std::array::from_fn(|i| dtime[i] + variant.delay_sign() * ddelay[i]);
                let shifted = sight(time + shift, dtime);
                let gradients = [angle_gradients(&first.cone, dx, dz), shifted.angle_gradients(second)];
                (both.angle_differences(), gradients)
            }
        };
        let [[dphi_left, dtheta_left], [dphi_right, dtheta_right]] = gradients;
        Slopes {
            angles: [if wanted[0] { dphi } else { 0.0 }, if wanted[1] { dtheta } else { 0.0 }],
            gradients: [
                std::array::from_fn(|i| dphi_left[i] - dphi_right[i]),
                std::array::from_fn(|i| dtheta_left[i] - dtheta_right[i]),
            ],
        }
    }
}

/// A view by one aperture at one time, which may depend on the parameters.
struct ApertureSight<'a> {
    trial: &'a Trial,
    wheel: &'a WheelPoint,
    time: f64,
    dtime: Gradient,
}

impl ApertureSight<'_> {
    /// Returns the gradients of phi and theta.
    fn angle_gradients(&self, seen: &SeenWheelPoint<f64>) -> [Gradient; 2] {
        let [dx, dz] = self.place_gradients(seen);
        angle_gradients(&seen.cone, dx, dz)
    }

    /// Returns the gradients of the apparent X and Z.
    fn place_gradients(&self, seen: &SeenWheelPoint<f64>) -> [Gradient; 2] {
        let Self { trial, wheel, time, dtime } = *self;
        let (beta, gamma) = (trial.speed.beta(), trial.speed.gamma());
        let LightCone { s, y, z, ref solution } = seen.cone;
        let (q, r) = (solution.q, wheel.rho * wheel.radius);
        let omega = wheel.omega(&trial.speed);
        let (sine, cosine) = math::sin_cos(seen.angle);
        let along = r * cosine / gamma;
        let dbeta: Gradient = [1.0, 0.0, 0.0, 0.0];
        let x0 = trial.passage_x + along;
        let rho_squared = y * y + z * z;
        // Of a point that rests there: S, and the time by its own clock.
        let ds: Gradient =
            std::array::from_fn(|i| beta * dtime[i] + dbeta[i] * (time - along * beta * gamma * gamma));
        let dtime_at_rest: Gradient = std::array::from_fn(|i| {
            let across = (y * D_Y[i] + z * D_Z[i]) * trial.speed.inverse_gamma_squared();
            let dq = (s * ds[i] + across - rho_squared * beta * dbeta[i]) / q;
            gamma * (dtime[i] - dq + solution.x * dbeta[i]) - gamma * gamma * gamma * x0 * dbeta[i]
        });
        // Of the angle at t' = 0, and of omega.
        let turning = gamma / wheel.radius;
        let dangle = [-turning * gamma * gamma * trial.passage_time, 0.0, 0.0, -turning * beta];
        let domega = 1.0 / wheel.radius;
        let towards = r * (gamma * s * sine - z * cosine) / (gamma * q);
        let dturn: Gradient = std::array::from_fn(|i| {
            let dangle = dangle[i] - seen.proper_time * domega * dbeta[i];
            dangle - omega * (dtime_at_rest[i] + towards * dangle) / seen.slope
        });
        let ds = std::array::from_fn(|i| ds[i] - r * sine / gamma * dturn[i]);
        let dz = std::array::from_fn(|i| D_Z[i] + r * cosine * dturn[i]);
        [x_gradient(beta, &seen.cone, ds, dz), dz]
    }
}
