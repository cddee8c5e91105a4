//! The definitions: speed, light cone, angles, aberration, and the published model as printed.

use crate::arithmetic::{Big, atan2, big, sqrt, square};

/// The parameter that gives the speed: it is the input, everything else follows from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Parameter {
    Beta,
    Gamma,
    Rapidity,
}

/// (beta, gamma) from the parameter.
pub fn speed(parameter: Parameter, value: &Big) -> (Big, Big) {
    match parameter {
        Parameter::Beta => (value.clone(), big(1.0) / sqrt(&(big(1.0) - square(value)))),
        Parameter::Gamma => (sqrt(&(big(1.0) - big(1.0) / square(value))), value.clone()),
        Parameter::Rapidity => {
            let (sinh, cosh) = value.sinh_cosh();
            (sinh / &cosh, cosh)
        }
    }
}

/// beta, gamma, gamma - 1, 1 - beta, 1/gamma^2, rapidity, head-on Doppler factor.
pub fn accessors(parameter: Parameter, value: &Big) -> [Big; 7] {
    let (beta, gamma) = speed(parameter, value);
    let ratio = (big(1.0) + &beta) / (big(1.0) - &beta);
    let rapidity = ratio.ln() / big(2.0);
    let gamma_minus_one = &gamma - big(1.0);
    [beta.clone(), gamma, gamma_minus_one, big(1.0) - &beta, big(1.0) - square(&beta), rapidity, sqrt(&ratio)]
}

/// The view of an aperture, from the definition of the light cone.
#[derive(Clone)]
pub struct View {
    pub x: Big,
    pub y: Big,
    pub z: Big,
    pub r: Big,
    pub t: Big,
    pub doppler: Big,
}

impl View {
    /// Solves |(s0 + beta t, y, z)| = time - t for the earlier t, s0 being the x at t = 0.
    pub fn new((beta, gamma): &(Big, Big), [s0, y, z]: [Big; 3], time: &Big) -> Self {
        let b = time + beta * &s0;
        let c = square(time) - square(&s0) - square(&y) - square(&z);
        let root = sqrt(&(square(&b) - (big(1.0) - square(beta)) * c));
        let t = square(gamma) * (b - root);
        let x = s0 + beta * &t;
        let r = sqrt(&(square(&x) + square(&y) + square(&z)));
        let doppler =
            if r == Big::ZERO { gamma.clone() } else { big(1.0) / (gamma * (big(1.0) + beta * &x / &r)) };
        Self { x, y, z, r, t, doppler }
    }

    /// gamma (t - beta x) of the event of emission, the point being at `x0` at t = 0.
    pub fn proper_time(&self, (beta, gamma): &(Big, Big), x0: &Big) -> Big {
        gamma * (&self.t - beta * (x0 + beta * &self.t))
    }

    pub fn phi(&self) -> Big {
        atan2(&self.y, &self.x)
    }

    pub fn theta(&self) -> Big {
        atan2(&self.z, &sqrt(&(square(&self.x) + square(&self.y))))
    }
}

/// X, t, tau, R, D, D^2, D^3, D^4, the received wavelength of `wavelength`, phi, theta.
///
/// `inputs`: speed parameter, x0, y, z, aperture x, y, z, T, wavelength.
pub fn sighting(parameter: Parameter, inputs: &[Big]) -> [Big; 11] {
    let speed = speed(parameter, &inputs[0]);
    let view = View::new(&speed, difference(&inputs[1..4], &inputs[4..7]), &inputs[7]);
    let proper_time = view.proper_time(&speed, &inputs[1]);
    let squared = square(&view.doppler);
    let (phi, theta) = (view.phi(), view.theta());
    [
        view.x,
        view.t,
        proper_time,
        view.r,
        view.doppler.clone(),
        squared.clone(),
        &squared * &view.doppler,
        square(&squared),
        &inputs[8] / view.doppler,
        phi,
        theta,
    ]
}

pub fn difference(a: &[Big], b: &[Big]) -> [Big; 3] {
    std::array::from_fn(|i| &a[i] - &b[i])
}

/// dphi, dtheta. `inputs`: speed parameter, x0, y, z, T, primary x, y, z, secondary x, y, z.
pub fn disparity(parameter: Parameter, inputs: &[Big]) -> [Big; 2] {
    let speed = speed(parameter, &inputs[0]);
    let view = |aperture: &[Big]| View::new(&speed, difference(&inputs[1..4], aperture), &inputs[4]);
    angle_differences(&view(&inputs[5..8]), &view(&inputs[8..11]))
}

/// dphi, dtheta of the paper's pair. `inputs`: speed parameter, x0, y, z, T, d.
pub fn pair_disparity(parameter: Parameter, inputs: &[Big]) -> [Big; 2] {
    let [.., dphi, dtheta] = pair_views(parameter, inputs);
    [dphi, dtheta]
}

/// X, t, D of the left eye, dphi, dtheta, for the paper's pair; `inputs` as for [`pair_disparity`].
pub fn pair_views(parameter: Parameter, inputs: &[Big]) -> [Big; 5] {
    let half = &inputs[5] / big(2.0);
    let speed = speed(parameter, &inputs[0]);
    let view = |s0: Big| View::new(&speed, [s0, inputs[2].clone(), inputs[3].clone()], &inputs[4]);
    let (left, right) = (view(&inputs[1] + &half), view(&inputs[1] - &half));
    let [dphi, dtheta] = angle_differences(&left, &right);
    [left.x, left.t, left.doppler, dphi, dtheta]
}

/// Gain and position from the crossing of two lines of sight.
///
/// The lines from (-+d/2, 0, 0) along (X, y, z) of each eye meet where both are at lambda = d/(`X_l` -
/// `X_r`). At d = 0 that is the limit, of which the gain is gamma D. `inputs` as for [`pair_disparity`].
pub fn stereo(parameter: Parameter, inputs: &[Big]) -> [Big; 4] {
    let half = &inputs[5] / big(2.0);
    let speed = speed(parameter, &inputs[0]);
    let view = |s0: Big| View::new(&speed, [s0, inputs[2].clone(), inputs[3].clone()], &inputs[4]);
    let (left, right) = (view(&inputs[1] + &half), view(&inputs[1] - &half));
    let gain =
        if inputs[5] == Big::ZERO { &speed.1 * &left.doppler } else { (&left.x - &right.x) / &inputs[5] };
    let [x, y, z] = [&left.x / &gain - half, left.y / &gain, left.z / &gain];
    [gain, x, y, z]
}

/// Gain, middle of the shortest connection of two lines of sight, and its length, for any two apertures; the
/// place from as far to the left of the left one as the right one is to its right.
///
/// The connection runs from one line, at a multiple of it, to the other: b = l `P_l` - r `P_r` - c n with n
/// across both, solved by Cramer's rule. The gain is the part of the parallax, across the mean line of sight,
/// that is along a resting point's, over that. `inputs`: speed parameter, x0, y, z, T, left x, y, z, right x,
/// y, z.
pub fn stereo_of_pair(parameter: Parameter, inputs: &[Big]) -> [Big; 5] {
    let speed = speed(parameter, &inputs[0]);
    let baseline = difference(&inputs[8..11], &inputs[5..8]);
    let view = |aperture: &[Big]| {
        let View { x, y, z, .. } = View::new(&speed, difference(&inputs[1..4], aperture), &inputs[4]);
        [x, y, z]
    };
    meeting(&view(&inputs[5..8]), &view(&inputs[8..11]), &baseline)
}

/// The same from both lines of sight, and from the left to the right aperture.
pub fn meeting(left: &[Big; 3], right: &[Big; 3], baseline: &[Big; 3]) -> [Big; 5] {
    let normal = cross(left, right);
    let volume = dot(&normal, &normal);
    let fraction = |other: &[Big; 3]| dot(&cross(baseline, other), &normal) / &volume;
    let (l, r) = (fraction(right), fraction(left));
    let [x, y, z] =
        std::array::from_fn(|i| (&l * &left[i] + &r * &right[i] + big(3.0) * &baseline[i]) / big(2.0));
    let miss = dot(baseline, &normal) / sqrt(&volume);
    let miss = if miss < big(0.0) { -miss } else { miss };
    let mean: [Big; 3] = std::array::from_fn(|i| &left[i] + &right[i]);
    let across = |v: &[Big; 3]| -> [Big; 3] {
        let along = dot(v, &mean) / dot(&mean, &mean);
        std::array::from_fn(|i| &v[i] - &along * &mean[i])
    };
    let (seen, at_rest) = (across(&difference(left, right)), across(baseline));
    let gain = dot(&seen, &at_rest) / dot(&at_rest, &at_rest);
    [gain, x, y, z, miss]
}

pub fn dot(a: &[Big; 3], b: &[Big; 3]) -> Big {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub fn cross(a: &[Big; 3], b: &[Big; 3]) -> [Big; 3] {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

/// X from each eye, t, D, dphi and dtheta where both receive what the middle between them does; `inputs` as
/// for [`pair_disparity`].
pub fn one_cone(parameter: Parameter, inputs: &[Big]) -> [Big; 6] {
    let half = &inputs[5] / big(2.0);
    let place = std::array::from_fn(|i| inputs[i + 1].clone());
    let middle = View::new(&speed(parameter, &inputs[0]), place, &inputs[4]);
    // The event from an aperture: its distance plays no part in the angles.
    let from = |x: Big| View { x, y: middle.y.clone(), z: middle.z.clone(), ..middle.clone() };
    let (left, right) = (from(&middle.x + &half), from(&middle.x - &half));
    let [dphi, dtheta] = angle_differences(&left, &right);
    [left.x, right.x, middle.t, middle.doppler, dphi, dtheta]
}

pub fn angle_differences(left: &View, right: &View) -> [Big; 2] {
    let dphi = left.phi() - right.phi();
    let pi = atan2(&big(0.0), &big(-1.0));
    let turn = &pi + &pi;
    let dphi = if dphi > pi {
        dphi - turn
    } else if dphi < -pi {
        dphi + turn
    } else {
        dphi
    };
    [dphi, left.theta() - right.theta()]
}

/// When the point was at x, and the root mean square of the distances from there.
///
/// `inputs`: speed parameter, x0, y, z, d, x.
pub fn observation_time_when_seen_at(parameter: Parameter, inputs: &[Big]) -> [Big; 1] {
    let (beta, _) = speed(parameter, &inputs[0]);
    let [x0, y, z, d, x] = [1, 2, 3, 4, 5].map(|i| &inputs[i]);
    let distance = sqrt(&(square(&(d / big(2.0))) + square(x) + square(y) + square(z)));
    [distance + (x - x0) / beta]
}

/// The time at which the two distances are equal: the point is then at x = 0.
///
/// `inputs`: speed parameter, x0, y, z, d.
pub fn equidistance_time(parameter: Parameter, inputs: &[Big]) -> [Big; 1] {
    observation_time_when_seen_at(parameter, &[inputs, &[big(0.0)]].concat())
}

/// The time at which light of an event as far from apertures at -b/2 and +b/2 arrives at both.
///
/// `inputs`: speed parameter, x0, y, z, b.
pub fn equidistance_time_of_pair(parameter: Parameter, inputs: &[Big]) -> [Big; 1] {
    let (beta, _) = speed(parameter, &inputs[0]);
    let [x0, y, z, bx, by, bz] = [1, 2, 3, 4, 5, 6].map(|i| &inputs[i]);
    let x = -(by * y + bz * z) / bx;
    let part = |place: &Big, along: &Big| square(&(place - along / big(2.0)));
    [(&x - x0) / beta + sqrt(&(part(&x, bx) + part(y, by) + part(z, bz)))]
}

/// dphi, dtheta, `X_S`, `t_S`, `tau_S`, `D_S` of the published model, by Appendix A's sequence of formulas,
/// the delay entering with `sign`. `inputs`: speed parameter, x0, y, z, T, d.
pub fn published(parameter: Parameter, sign: f64, inputs: &[Big]) -> [Big; 6] {
    let speed = speed(parameter, &inputs[0]);
    let half = &inputs[5] / big(2.0);
    let [x0, y, z, time] = [&inputs[1], &inputs[2], &inputs[3], &inputs[4]];
    let view = |time: &Big| View::new(&speed, [x0 + &half, y.clone(), z.clone()], time);
    let left = view(time);
    let event = x0 + &speed.0 * &left.t;
    let distance = |x: Big| sqrt(&(square(y) + square(z) + square(&x)));
    let delay = distance(&event - &half) - distance(&event + &half);
    let right = view(&(time + big(sign) * delay));
    let [dphi, dtheta] = angle_differences(&left, &right);
    let proper_time = right.proper_time(&speed, x0);
    [dphi, dtheta, right.x, right.t, proper_time, right.doppler]
}

/// Eq. (1) as printed. `inputs`: speed parameter, x0, y, z, aperture x, y, z, T.
pub fn printed_x(parameter: Parameter, inputs: &[Big]) -> [Big; 1] {
    let (beta, gamma) = speed(parameter, &inputs[0]);
    let [s0, y, z] = difference(&inputs[1..4], &inputs[4..7]);
    let s = s0 + beta * &inputs[7];
    let gamma_s = &gamma * s;
    let root = sqrt(&(square(&gamma_s) + square(&y) + square(&z)));
    [&gamma * (gamma_s - root)]
}

/// The line of sight seen from the other frame (`sign` = 1: the rest frame's from the ground's), and the
/// Doppler factor along it. The vector is brought to unit length first.
///
/// `inputs`: speed parameter, n.
pub fn aberration(parameter: Parameter, sign: f64, inputs: &[Big]) -> [Big; 4] {
    let (beta, gamma) = speed(parameter, &inputs[0]);
    let beta = beta * big(sign);
    let norm = sqrt(&(square(&inputs[1]) + square(&inputs[2]) + square(&inputs[3])));
    let [x, y, z] = std::array::from_fn(|i| &inputs[i + 1] / &norm);
    let factor = big(1.0) + &beta * &x;
    let transverse = &gamma * &factor;
    [(x + beta) / factor, y / &transverse, z / &transverse, big(1.0) / transverse]
}

/// arsinh, of magnitudes: nothing cancels.
fn arsinh(x: &Big) -> Big {
    if *x < big(0.0) {
        return -arsinh(&-x);
    }
    (x + sqrt(&(square(x) + big(1.0)))).ln()
}

/// u and v of a place, for a head tilted by `roll` and turned by `turn`.
fn conformal([x, y, z]: [&Big; 3], [roll, turn]: [&Big; 2]) -> [Big; 2] {
    let ((sin_roll, cos_roll), (sin_turn, cos_turn)) = (roll.sin_cos(), turn.sin_cos());
    // The turn is undone first, then the tilt.
    let [along, ahead] = [x * &cos_turn + y * &sin_turn, y * &cos_turn - x * &sin_turn];
    let [right, up] = [&along * &cos_roll + z * &sin_roll, z * &cos_roll - &along * &sin_roll];
    [arsinh(&(right / sqrt(&(square(&ahead) + square(&up))))), atan2(&up, &ahead)]
}

/// u and v of one aperture's view. `inputs`: speed parameter, x0, y, z, aperture x, y, z, T, roll, turn.
pub fn conformal_view(parameter: Parameter, inputs: &[Big]) -> [Big; 2] {
    let speed = speed(parameter, &inputs[0]);
    let View { x, y, z, .. } = View::new(&speed, difference(&inputs[1..4], &inputs[4..7]), &inputs[7]);
    conformal([&x, &y, &z], [&inputs[8], &inputs[9]])
}

/// `u_l` - `u_r` of the paper's pair; `inputs` as for [`pair_disparity`].
pub fn conformal_disparity(parameter: Parameter, inputs: &[Big]) -> [Big; 1] {
    let half = &inputs[5] / big(2.0);
    let speed = speed(parameter, &inputs[0]);
    let u = |s0: Big| {
        let View { x, y, z, .. } = View::new(&speed, [s0, inputs[2].clone(), inputs[3].clone()], &inputs[4]);
        let [u, _] = conformal([&x, &y, &z], [&big(0.0), &big(0.0)]);
        u
    };
    [u(&inputs[1] + &half) - u(&inputs[1] - &half)]
}

/// `u_l` - `u_r` and `v_l` - `v_r` for two apertures of a tilted and turned head. `inputs`: speed parameter,
/// x0, y, z, T, left x, y, z, right x, y, z, roll, turn.
pub fn conformal_disparity_of_head(parameter: Parameter, inputs: &[Big]) -> [Big; 2] {
    let speed = speed(parameter, &inputs[0]);
    let seen = |aperture: &[Big]| {
        let View { x, y, z, .. } = View::new(&speed, difference(&inputs[1..4], aperture), &inputs[4]);
        conformal([&x, &y, &z], [&inputs[11], &inputs[12]])
    };
    let ([ul, vl], [ur, vr]) = (seen(&inputs[5..8]), seen(&inputs[8..11]));
    let pi = atan2(&big(0.0), &big(-1.0));
    let turn = &pi + &pi;
    let dv = vl - vr;
    let dv = if dv > pi {
        dv - turn
    } else if dv < -pi {
        dv + turn
    } else {
        dv
    };
    [ul - ur, dv]
}
