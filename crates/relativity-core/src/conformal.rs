//! Conformal coordinates of lines of sight: Mercator's projection of the sky, with its poles at the ends of
//! the baseline.
//!
//! With the axes of the head ([`HeadAxes`]), X along the baseline, Y ahead and Z up, a line of sight has
//!
//! ```text
//! u = arsinh(X/rho)      to the right, in units of rapidity        rho = hypot(Y, Z)
//! v = atan2(Z, Y)        up, radians
//! ```
//!
//! u is the pseudorapidity of collider physics. Of a head along the motion, a point that moves at rapidity
//! eta is seen at u = arsinh(xi/rho) - eta, where xi is its place along x in its own rest frame, from the
//! event of the eye; v is that of the resting point. So motion slides the picture and keeps its shapes. The
//! slide is common to both eyes and drops out of their disparity: du of a moving point is that of a resting
//! one for eyes gamma d apart.
//!
//! References: J. Morava, arXiv:0804.4160; J. Baez, *Special Relativity and the Mercator Projection*, The
//! n-Category Café, 3 March 2023. The disparity is derived here.

use std::f64::consts::LN_2;

use crate::aperture::Aperture;
use crate::baseline::HeadAxes;
use crate::cone_pair::SightPair;
use crate::math;
use crate::model::{Model, PairError};
use crate::source::Source;
use crate::speed::Speed;
use crate::stereo::{cross, dot};

/// Conformal coordinates of a line of sight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conformal {
    /// To the right along the baseline, in units of rapidity.
    pub u: f64,
    /// Up about the baseline from straight ahead, radians, in [-pi, pi].
    pub v: f64,
}

impl Conformal {
    /// Returns the coordinates of what is seen at [X, Y, Z] along the axes of the head; `None` on the
    /// baseline, which is infinitely far aside, and for a place that is not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::Conformal;
    ///
    /// let seen = Conformal::from_direction([-3.0, 4.0, 0.0]).ok_or("on the baseline")?;
    /// assert!((seen.u + 2.0_f64.ln()).abs() < 1e-15 && seen.v == 0.0);
    /// assert_eq!(Conformal::from_direction([1.0, 0.0, 0.0]), None);
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn from_direction([x, y, z]: [f64; 3]) -> Option<Self> {
        let rho = math::hypot(y, z);
        let is_seen = rho > 0.0 && rho.is_finite() && x.is_finite();
        is_seen.then(|| Self { u: arsinh_of_ratio(x, rho), v: math::atan2(z, y) })
    }
}

/// arsinh(x/rho), also where the quotient overflows.
fn arsinh_of_ratio(x: f64, rho: f64) -> f64 {
    let ratio = x / rho;
    if ratio.is_finite() {
        math::asinh(ratio)
    } else {
        (LN_2 + math::ln(x.abs()) - math::ln(rho)).copysign(x)
    }
}

impl HeadAxes {
    /// Returns the conformal coordinates of what is seen at `position` from an aperture; `None` on the
    /// baseline.
    #[must_use]
    pub fn conformal(&self, position: [f64; 3]) -> Option<Conformal> {
        Conformal::from_direction(self.along(position))
    }
}

/// Conformal coordinates of one point for two apertures, and the differences between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConformalDisparity {
    /// The coordinates for the primary (left) aperture.
    pub primary: Conformal,
    /// The coordinates for the secondary (right) aperture.
    pub secondary: Conformal,
    /// Delta-u: primary minus secondary.
    pub du: f64,
    /// Delta-v: primary minus secondary, in [-pi, pi]; 0 for apertures along the motion, of a point that does
    /// not turn.
    pub dv: f64,
}

impl ConformalDisparity {
    /// Returns the disparity of two lines of sight, along the axes of the head; `None` where one is along the
    /// baseline.
    ///
    /// `u_l` and `u_r` on one side are not subtracted. With small letters for the unit vectors,
    ///
    /// ```text
    /// sinh(u_l - u_r) = ((X_l Y_r - X_r Y_l) y + (X_l Z_r - X_r Z_l) z)/(rho_l rho_r)
    /// y = (x_l y_r + x_r y_l)/(x_l + x_r),    z alike
    /// ```
    ///
    /// has parts of `P_l` x `P_r` in it, which is known without subtraction.
    fn new(axes: &HeadAxes, lines: &SightPair<f64>) -> Option<Self> {
        let HeadAxes { right, ahead, up } = *axes;
        let [left_place, right_place] = lines.each.map(|place| axes.along(place));
        let (primary, secondary) =
            (Conformal::from_direction(left_place)?, Conformal::from_direction(right_place)?);
        let [rho_left, rho_right] = [left_place, right_place].map(|[_, y, z]| math::hypot(y, z));
        let normal = |a, b| dot(lines.normal, cross(a, b)) / rho_left / rho_right;
        let ([xl, yl, zl], [xr, yr, zr]) = (unit(left_place), unit(right_place));
        let du = if xl * xr > 0.0 {
            let mean = |left: f64, right: f64| (xl * right + xr * left) / (xl + xr);
            math::asinh(normal(right, ahead) * mean(yl, yr) + normal(right, up) * mean(zl, zr))
        } else {
            primary.u - secondary.u
        };
        let [[_, yl, zl], [_, yr, zr]] = [(left_place, rho_left), (right_place, rho_right)]
            .map(|(place, rho)| place.map(|along| along / rho));
        let dv = math::atan2(normal(up, ahead), yl * yr + zl * zr);
        (du.is_finite() && dv.is_finite()).then_some(Self { primary, secondary, du, dv })
    }
}

fn unit(place: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = place;
    let length = math::hypot(math::hypot(x, y), z);
    place.map(|along| along / length)
}

impl Model {
    /// Returns the conformal disparity of `source` in this model for the `pair` of apertures of a head with
    /// these `axes`; `None` where the point is on the baseline of either aperture.
    ///
    /// # Accuracy
    ///
    /// As [`crate::disparity()`], however close the apertures are. Measured for the paper's pair
    /// (`tests/oracle`, 4,000 inputs): median 0.3, 99 % 2, worst 4 units.
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain; a pair that is not along x, in a published model.
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::{Baseline, Model, SourcePoint, Speed};
    ///
    /// let speed = Speed::from_beta(0.9)?;
    /// let point = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
    /// let head = Baseline::straight(0.1);
    /// let of = |speed: &Speed, point, head: Baseline, time| {
    ///     Model::Exact.conformal(speed, point, head.apertures(), &head.axes(), time)
    /// };
    /// let moving = of(&speed, point, head, 5.0)?.ok_or("on the baseline")?;
    /// // At rest, where the point is in its rest frame, for eyes gamma d apart.
    /// let xi = speed.gamma() * speed.beta() * 5.0;
    /// let wide = Baseline::straight(speed.gamma() * 0.1);
    /// let resting = of(&Speed::REST, SourcePoint { x0: xi, ..point }, wide, 5.0)?.ok_or("on the baseline")?;
    /// assert!((moving.du - resting.du).abs() < 1e-16 && moving.dv == 0.0);
    /// assert!((resting.primary.u - moving.primary.u - speed.rapidity()).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn conformal(
        self,
        speed: &Speed,
        source: impl Into<Source>,
        pair: [Aperture; 2],
        axes: &HeadAxes,
        observation_time: f64,
    ) -> Result<Option<ConformalDisparity>, PairError> {
        let lines = self.lines_of_sight(speed, source, pair, observation_time)?;
        Ok(lines.and_then(|lines| ConformalDisparity::new(axes, &lines)))
    }
}
