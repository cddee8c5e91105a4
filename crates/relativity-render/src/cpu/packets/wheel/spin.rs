//! The turning of a body about an axle along y, and its angle at the moment that a ray shows:
//! `shaders/turning.wgsl`.

use crate::cpu::packets::body::PacketGroup;
use crate::scene::wheel::packed::TurningStart;
use crate::simd::lanes::{F, Simd, SimdFloat, V3, all, select};
use crate::view::Geometry;

/// The axle of a turning body, and its speed.
#[derive(Debug, Clone, Copy)]
pub struct PacketSpin<S: Simd> {
    /// The middle of the axle, from the group's.
    pub hub: V3<S>,
    /// The angular velocity about +y.
    pub omega: F<S>,
    /// 1 less the speed of the rim, and the rim's speed less that of a ring's outermost circle, along the
    /// group's motion.
    pub below_light: F<S>,
    pub lag: F<S>,
}

/// The time by which places are shown later than the hub, and earlier per step from there.
#[derive(Clone, Copy)]
pub struct Later<S: Simd> {
    pub time: F<S>,
    pub slowness: V3<S>,
}

/// Sine and cosine of an angle.
#[derive(Clone, Copy)]
pub struct SineCosine<S: Simd> {
    pub sine: F<S>,
    pub cosine: F<S>,
}

impl<S: Simd> PacketSpin<S> {
    /// Unpacks the uniforms of the shaders.
    #[inline(always)]
    pub fn new(simd: S, shown: &TurningStart) -> Self {
        let TurningStart { spin, rim: [below_light, lag], .. } = *shown;
        Self {
            hub: V3::of_four(simd, spin),
            omega: all(simd, spin[3]),
            below_light: all(simd, below_light),
            lag: all(simd, lag),
        }
    }
}

/// Returns how much later the place `q`, from the hub, is shown than the hub.
#[inline(always)]
pub fn later<S: Simd>(simd: S, group: &PacketGroup, q: V3<S>, spin: &PacketSpin<S>) -> Later<S> {
    let frame = group.frame;
    if group.geometry == Geometry::Contracted {
        // One time of the camera's.
        let beta = frame.speed[0];
        if frame.is_oblique() {
            let slowness = V3::of_four(simd, frame.group_axes[0]) * beta;
            return Later { time: -slowness.dot(q), slowness };
        }
        let slowness = V3::all(simd, [frame.motion[0] * beta, 0.0, 0.0]);
        return Later { time: -slowness.x * q.x, slowness };
    }
    let fine = V3::of_four(simd, frame.middle_fine) + spin.hub;
    later_from(V3::of_four(simd, frame.middle) + fine, q)
}

/// Returns the delay of places for the light to a camera event from which the hub is at `hub`.
#[inline(always)]
fn later_from<S: Simd>(hub: V3<S>, q: V3<S>) -> Later<S> {
    let largest = hub.abs().max_part().max(1e-12);
    let scaled = hub / largest;
    let reach = scaled.length();
    let towards = scaled / reach;
    let step = q / (largest * reach);
    let there = towards + step;
    let distance = there.length().max(1e-12);
    Later { time: -q.dot(towards + there) / (1.0 + distance), slowness: there / distance }
}

/// Sine and cosine within 2e-7 for moderate angles. Polynomials of S. L. Moshier's Cephes library (1989).
#[expect(clippy::excessive_precision, reason = "as they are published")]
#[inline(always)]
pub fn sine_cosine<S: Simd>(angle: F<S>) -> SineCosine<S> {
    let quarters = (angle * std::f32::consts::FRAC_2_PI).round_ties_even();
    let x = (angle - quarters * 1.570_312_5) - quarters * 4.838_267_9e-4;
    let xx = x * x;
    let sine = x + x * xx * (-0.166_666_546_11 + xx * (0.008_332_160_873_6 - xx * 0.000_195_152_958_91));
    let cosine = 1.0 - 0.5 * xx
        + xx * xx * (0.041_666_645_683 + xx * (-0.001_388_731_625_5 + xx * 0.000_024_433_157_118));
    let quarter = quarters - 4.0 * (0.25 * quarters).floor();
    let is_odd = quarter.simd_eq(1.0) | quarter.simd_eq(3.0);
    let is_reversed = quarter.simd_ge(2.0);
    let along = SineCosine { sine: select(is_odd, cosine, sine), cosine: select(is_odd, -sine, cosine) };
    SineCosine {
        sine: select(is_reversed, -along.sine, along.sine),
        cosine: select(is_reversed, -along.cosine, along.cosine),
    }
}

/// `v` turned about +y: from z towards x.
#[inline(always)]
pub fn about_y<S: Simd>(v: V3<S>, turn: SineCosine<S>) -> V3<S> {
    let SineCosine { sine, cosine } = turn;
    V3::new(v.x * cosine + v.z * sine, v.y, v.z * cosine - v.x * sine)
}

/// The velocity of what turns so at `q` from the hub.
#[inline(always)]
pub fn velocity_at<S: Simd>(simd: S, q: V3<S>, spin: &PacketSpin<S>) -> V3<S> {
    V3::new(q.z, all(simd, 0.0), -q.x) * spin.omega
}
