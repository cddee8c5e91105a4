//! The curves that are fitted, with their derivatives: Delta-phi and Delta-theta of a trial object.
//!
//! The derivatives follow from the light cone itself. With R^2 = X^2 + rho^2 and X = S - beta R, and
//! since R + beta X = q and q - beta X = R,
//!
//! ```text
//! dX = (R dS - R^2 dbeta - beta (y dy + z dz))/q,    dS = (T - t0) dbeta - beta dt0
//! ```
//!
//! where t0 is the time of passage, at which the object is objectively at x = 0 (or at a known x0).

use crate::aperture::Aperture;
use crate::apparent::LightCone;
use crate::cone_pair::ConePair;
use crate::fit::gradients::{D_Z, Slopes, angle_gradients, delay_gradient, x_gradient};
use crate::fit::trial::Trial;
use crate::model::Model;
use crate::one_cone;

impl Trial {
    /// Delta-phi and Delta-theta at `time`.
    pub fn angles(&self, model: Model, pair: &[Aperture; 2], time: f64) -> [f64; 2] {
        self.wanted_angles(model, pair, time, [true, true])
    }

    /// Delta-phi and Delta-theta at `time`, with 0 for a difference that is not `wanted`.
    pub fn wanted_angles(
        &self,
        model: Model,
        pair: &[Aperture; 2],
        time: f64,
        wanted: [bool; 2],
    ) -> [f64; 2] {
        if let Some(rolling) = &self.rolling {
            return rolling.angles(self, model, pair, time - self.passage_time, wanted);
        }
        self.cone_pair(model, pair, time).0.wanted_angle_differences(wanted).into()
    }

    /// Delta-phi and Delta-theta at `time`, with their gradients.
    pub fn slopes(&self, model: Model, pair: &[Aperture; 2], time: f64, wanted: [bool; 2]) -> Slopes {
        if let Some(rolling) = &self.rolling {
            return rolling.slopes(self, model, pair, time - self.passage_time, wanted);
        }
        let (cones, shift) = self.cone_pair(model, pair, time);
        let ConePair { left, right, .. } = &cones;
        let beta = self.speed.beta();
        let ds = [time - self.passage_time, 0.0, 0.0, -beta];
        let [dx_left, dx_right] = match model {
            Model::Exact => [left, right].map(|cone| x_gradient(beta, cone, ds, D_Z)),
            Model::OneCone => [x_gradient(beta, &self.middle_cone(pair, time), ds, D_Z); 2],
            Model::Published(variant) => {
                let dx = x_gradient(beta, left, ds, D_Z);
                let to_secondary = left.solution.x - (pair[1].x - pair[0].x);
                let ddelay = delay_gradient(left, to_secondary, dx, D_Z);
                let sign = variant.delay_sign();
                let ds_right = std::array::from_fn(|i| {
                    let dbeta = if i == 0 { shift } else { 0.0 };
                    ds[i] + dbeta + beta * (sign * ddelay[i])
                });
                [dx, x_gradient(beta, right, ds_right, D_Z)]
            }
        };
        let [dphi_left, dtheta_left] = angle_gradients(left, dx_left, D_Z);
        let [dphi_right, dtheta_right] = angle_gradients(right, dx_right, D_Z);
        Slopes {
            angles: cones.wanted_angle_differences(wanted).into(),
            gradients: [
                std::array::from_fn(|i| dphi_left[i] - dphi_right[i]),
                std::array::from_fn(|i| dtheta_left[i] - dtheta_right[i]),
            ],
        }
    }

    #[inline]
    fn cone_pair(&self, model: Model, pair: &[Aperture; 2], time: f64) -> (ConePair<f64>, f64) {
        model.cone_pair(&self.speed, self.point(), *pair, time - self.passage_time)
    }

    /// The light cone of the middle between the apertures.
    fn middle_cone(&self, pair: &[Aperture; 2], time: f64) -> LightCone<f64> {
        one_cone::middle_cone(&self.speed, self.point(), *pair, time - self.passage_time)
    }

    /// Returns the angle, radians, through which the wheel is seen to have turned at `time`, as the pair sees
    /// its hub; 0 for a point that does not turn.
    pub fn turn(&self, pair: &[Aperture; 2], time: f64) -> f64 {
        let Some(rolling) = &self.rolling else { return 0.0 };
        let (beta, gamma) = (self.speed.beta(), self.speed.gamma());
        let solution = self.middle_cone(pair, time).solution;
        let x = one_cone::middle(*pair).x + solution.x;
        beta / rolling.radius * gamma * (time - solution.r - beta * x)
    }
}

/// Gradient of the apparent X, from those of S and z.
#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::gradients::Gradient;
    use crate::fit::trial::Rolling;
    use crate::speed::Speed;

    fn shifted(trial: &Trial, parameter: usize, by: f64) -> Trial {
        let mut shifted = *trial;
        match parameter {
            0 => shifted.speed = Speed::from_beta(trial.speed.beta() + by).expect("a speed"),
            1 => shifted.y += by,
            2 => shifted.z += by,
            _ => shifted.passage_time += by,
        }
        shifted
    }

    /// Six-point central difference: its truncation error is of the order of h^6.
    fn difference(at: impl Fn(f64) -> [f64; 2], h: f64) -> [f64; 2] {
        let weighted = |k: f64, weight: f64| {
            let (above, below) = (at(k * h), at(-k * h));
            [0, 1].map(|i| weight * (above[i] - below[i]) / (60.0 * h))
        };
        let parts = [weighted(1.0, 45.0), weighted(2.0, -9.0), weighted(3.0, 1.0)];
        [0, 1].map(|i| parts.iter().map(|part| part[i]).sum())
    }

    #[test]
    fn gradients_are_the_slopes_of_the_curves() {
        let oblique = [Aperture { x: 0.3, y: -0.2, z: 0.1 }, Aperture { x: -0.1, y: 0.15, z: -0.3 }];
        let along_x = [Aperture { x: 0.4, y: 0.1, z: 0.2 }, Aperture { x: 0.9, y: 0.1, z: 0.2 }];
        let [exact, one_cone, appendix_a, text_sign] = Model::ALL;
        let cases = [
            (exact, Aperture::pair(0.1)),
            (exact, oblique),
            (one_cone, Aperture::pair(0.1)),
            (one_cone, oblique),
            (appendix_a, Aperture::pair(0.3)),
            (appendix_a, along_x),
            (text_sign, Aperture::pair(0.3)),
            (text_sign, along_x),
        ];
        for (model, pair) in cases {
            for beta in [0.1, 0.6, 0.9, 0.99] {
                for time in [-3.0, 0.1, 1.2, 2.4, 9.0] {
                    let speed = Speed::from_beta(beta).expect("a speed");
                    for rolling in [None, Some(Rolling { radius: 0.9, rho: 0.7, angle: 0.6 })] {
                        let (passage_time, passage_x) = (0.4, 0.2);
                        let trial = Trial { speed, y: 1.3, z: -0.8, passage_time, passage_x, rolling };
                        check_gradients(&trial, model, &pair, time);
                    }
                }
            }
        }
    }

    fn check_gradients(trial: &Trial, model: Model, pair: &[Aperture; 2], time: f64) {
        let gradients = trial.slopes(model, pair, time, [true, true]).gradients;
        for (parameter, gradient) in transposed(gradients).into_iter().enumerate() {
            // A wheel turns many times while its hub passes.
            let finer = if trial.rolling.is_some() { 0.2 } else { 1.0 };
            let h = finer * if parameter == 0 { 2e-3 * trial.speed.one_minus_beta() } else { 1e-3 };
            let slopes = difference(|by| shifted(trial, parameter, by).angles(model, pair, time), h);
            for (slope, gradient) in slopes.into_iter().zip(gradient) {
                let error = (gradient - slope).abs();
                let context = (model, trial, time, parameter);
                assert!(error < 1e-9 * (1.0 + gradient.abs()), "{error:e} of {gradient:e}: {context:?}");
            }
        }
    }

    fn transposed([dphi, dtheta]: [Gradient; 2]) -> [[f64; 2]; 4] {
        std::array::from_fn(|i| [dphi[i], dtheta[i]])
    }
}
