//! The exposure of a scene that leaves in sight what matters: found from the speeds and the lights in it
//! alone, so that it does not change while time runs.

use relativity_core::math::{exp2, log2};

use super::screen_light::log2_glow;
use crate::colour::sunlit;
use crate::kinematics::velocity::Velocity;
use crate::scene::body::Emission;
use crate::view::{Appearance, Colour, Geometry};

/// Between these light of one wavelength is at least half as bright as its colour can be, nm.
const SEEN_NM: [f64; 2] = [400.0, 745.0];
/// Brightness, abreast, of bodies that glow or are white, relative to the brightest that is shown unchanged:
/// a middle grey.
const ABREAST: f64 = 0.18;
/// The most that automatic exposure brightens, factors of 2: beyond, a picture is all shoulder.
const MOST_EV: f64 = 6.0;

/// The exposure (factors of 2) for what moves with these velocities and shines so, as `geometry` shows it.
///
/// For one wavelength, with the exponent n, it lies midway between the light nearest to rest that can be seen
/// and the brightest D^n that can, both over all D that the speeds reach and that leave a body's light
/// visible. For what glows and for white light it is such that what passes abreast, at D = 1/gamma, comes out
/// a middle grey, but at least 0 and at most 6.
///
/// # Examples
///
/// ```
/// use relativity_render::light::exposure::automatic_ev;
/// use relativity_render::{Appearance, Emission, Geometry, Velocity};
///
/// let rider = [(Velocity::from_beta(0.9)?, Emission::Wavelength(700.0))];
/// let appearance = Appearance { intensity_exponent: Some(4.0), ..Appearance::default() };
/// let ev = automatic_ev(rider, Geometry::Seen, &appearance);
/// // It is seen up to 400 nm, which is D = 1.75.
/// assert!((ev + 2.0 * 1.75f64.log2()).abs() < 1e-12);
/// # Ok::<(), relativity_core::SpeedError>(())
/// ```
#[must_use]
pub fn automatic_ev(
    lights: impl IntoIterator<Item = (Velocity, Emission)>,
    geometry: Geometry,
    appearance: &Appearance,
) -> f64 {
    if !geometry.has_doppler_effect() {
        return 0.0;
    }
    let mut lines: Option<[f64; 2]> = None;
    let mut slowest_clock: f64 = 1.0;
    for (velocity, emission) in lights {
        slowest_clock = slowest_clock.min(1.0 / velocity.speed.gamma());
        if let Some([near, bright]) = seen_line(velocity, emission, appearance) {
            let [nearest, brightest] = lines.unwrap_or([near, bright]);
            lines = Some([nearest.min(near), brightest.max(bright)]);
        }
    }
    match (appearance.colour, lines) {
        (Colour::OneWavelength, Some([near, bright])) => -0.5 * (near + bright),
        (Colour::Glowing, _) => {
            for_abreast(|clock| log2_glow(appearance.temperature_k, clock), slowest_clock, appearance)
        }
        (Colour::OneWavelength | Colour::White | Colour::StreetDaylight, _) => {
            for_abreast(|clock| sunlit::log2_level(log2(clock)), slowest_clock, appearance)
        }
        (Colour::False, _) => 0.0,
    }
}

/// log2 of how bright light of one wavelength is where it is visible: at the D nearest to 1, and at the
/// brightest.
fn seen_line(velocity: Velocity, emission: Emission, appearance: &Appearance) -> Option<[f64; 2]> {
    let rest_nm = emission.wavelength_nm()?;
    let fastest = log2(velocity.speed.head_on_doppler_factor());
    let [shortest, longest] = SEEN_NM.map(|nm| log2(rest_nm / nm));
    // Without a shift all D are as visible as light at rest.
    let is_seen = longest <= 0.0 && shortest >= 0.0;
    let [low, high] = match (appearance.doppler_shift, is_seen) {
        (true, _) => [longest.max(-fastest), shortest.min(fastest)],
        (false, true) => [-fastest, fastest],
        (false, false) => return None,
    };
    let exponent = appearance.intensity_exponent.unwrap_or(0.0);
    let near = exponent * 0.0_f64.clamp(low, high.max(low));
    (low <= high).then_some([near, (exponent * low).max(exponent * high)])
}

/// For light whose brightness has the logarithm `log2_level` at a Doppler factor, coming from clocks that go
/// `slowest_clock` times as fast.
fn for_abreast(log2_level: impl Fn(f64) -> f64, slowest_clock: f64, appearance: &Appearance) -> f64 {
    if !appearance.doppler_shift {
        return 0.0;
    }
    // Far below what can be made visible the logarithm has no use.
    let level = log2_level(slowest_clock.max(exp2(-10.0)));
    (log2(ABREAST) - level).clamp(0.0, MOST_EV)
}
