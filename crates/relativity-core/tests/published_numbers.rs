//! The paper's numbers, and what the exact model gives in their place.
//!
//! Reference: the paper, section 3 (figures of the disparities for y = z = 0.5, d = 0.3, beta = 0.9) and
//! eq. (6). The paper quotes -0.34 and 0.06 for dphi, -0.015 and 0.19 for dtheta, which no printed variant of
//! its formulas gives; the extremes below are what a direct scan of each variant gives.

use relativity_core::{
    Aperture, Disparity, PublishedVariant, SourcePoint, Speed, disparity, equidistance_time,
    published_disparity, sighting,
};

const SEPARATION: f64 = 0.3;
const POINT: SourcePoint = SourcePoint { x0: 0.0, y: 0.5, z: 0.5 };

fn speed() -> Speed {
    Speed::from_beta(0.9).expect("0.9 is a speed")
}

fn exact(time: f64) -> Disparity {
    let [left, right] = Aperture::pair(SEPARATION);
    disparity(&speed(), POINT, left, right, time).expect("inside the domain")
}

fn published(time: f64, variant: PublishedVariant) -> Disparity {
    published_disparity(&speed(), POINT, SEPARATION, time, variant).expect("inside the domain")
}

/// Observation times over the whole passage, close together where the curves turn.
fn times() -> impl Iterator<Item = f64> {
    (-40_000..40_000).map(|i| 0.5 + f64::from(i) * 5e-4)
}

/// Minimum, maximum, and times of sign changes of a curve.
struct Curve {
    min: f64,
    max: f64,
    zeros: Vec<f64>,
}

impl Curve {
    fn sample(f: impl Fn(f64) -> f64) -> Self {
        let values: Vec<f64> = times().map(&f).collect();
        let crossings = times().zip(values.windows(2)).filter(|(_, w)| w[0] * w[1] < 0.0);
        Self {
            min: values.iter().copied().fold(f64::INFINITY, f64::min),
            max: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            zeros: crossings.map(|(t, _)| t).collect(),
        }
    }

    #[track_caller]
    fn assert(&self, min: f64, max: f64, zeros: &[f64]) {
        assert!((self.min - min).abs() < 6e-5, "minimum {} instead of {min}", self.min);
        assert!((self.max - max).abs() < 6e-5, "maximum {} instead of {max}", self.max);
        assert_eq!(self.zeros.len(), zeros.len(), "zeros at {:?}", self.zeros);
        for (zero, expected) in self.zeros.iter().zip(zeros) {
            assert!((zero - expected).abs() < 1e-3, "zero at {zero} instead of {expected}");
        }
    }
}

#[test]
fn appendix_a_has_its_extremes_and_zeros() {
    let variant = PublishedVariant::AppendixA;
    Curve::sample(|t| published(t, variant).dphi).assert(-0.3295, 0.0712, &[0.723]);
    Curve::sample(|t| published(t, variant).dtheta).assert(-0.0032, 0.2240, &[0.567, 0.723]);
}

#[test]
fn the_texts_sign_turns_the_curves_over() {
    let variant = PublishedVariant::TextSign;
    Curve::sample(|t| published(t, variant).dphi).assert(-0.0858, 0.4394, &[0.723]);
    Curve::sample(|t| published(t, variant).dtheta).assert(-0.2694, 0.0045, &[0.504, 0.723]);
}

#[test]
fn exactly_dphi_never_crosses_zero_and_dtheta_does_at_equidistance() {
    let dphi = Curve::sample(|t| exact(t).dphi);
    assert!((dphi.min + 0.6678).abs() < 6e-5, "minimum {}", dphi.min);
    assert!(dphi.max < 0.0 && dphi.zeros.is_empty());
    Curve::sample(|t| exact(t).dtheta).assert(-0.0973, 0.3219, &[0.723]);
}

#[test]
fn equidistance_times_are_the_papers() {
    let t0 = |point, separation| {
        equidistance_time(&speed(), point, Aperture::pair(separation))
            .expect("inside the domain")
            .expect("moving")
    };
    assert!((t0(POINT, SEPARATION) - 0.7228).abs() < 5e-5);
    let tracked = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
    assert!((t0(tracked, 0.1) - 13.0025_f64.sqrt()).abs() < 1e-14);
    assert!((t0(tracked, 0.1) - 3.605_90).abs() < 5e-6);
}

#[test]
fn a_point_is_equally_far_from_both_eyes_at_equidistance() {
    for x0 in [-2.0, 0.0, 0.7] {
        let point = SourcePoint { x0, ..POINT };
        let t0 =
            equidistance_time(&speed(), point, Aperture::pair(SEPARATION)).expect("inside").expect("moving");
        let [left, right] = Aperture::pair(SEPARATION);
        let both = disparity(&speed(), point, left, right, t0).expect("inside");
        assert!((both.primary.distance - both.secondary.distance).abs() < 1e-14);
        assert!(both.dtheta.abs() < 1e-14);
    }
}

/// Returns the x at which an aperture at the origin sees the point at rest coordinates (`xr`, 0, 0) at time
/// `time`.
fn apparent_x(xr: f64, time: f64) -> f64 {
    let point = SourcePoint::from_rest([xr, 0.0, 0.0], &speed());
    sighting(&speed(), point, Aperture::default(), time).expect("inside the domain").position[0]
}

#[test]
fn a_rod_looks_longer_ahead_and_shorter_behind() {
    let stretch = (1.9_f64 / 0.1).sqrt();
    let approaching = apparent_x(0.5, -1e3) - apparent_x(-0.5, -1e3);
    let receding = apparent_x(0.5, 1e3) - apparent_x(-0.5, 1e3);
    assert!((approaching / stretch - 1.0).abs() < 1e-10, "{approaching}");
    assert!((receding * stretch - 1.0).abs() < 1e-10, "{receding}");
}

#[test]
fn apparent_speeds_are_faster_than_light_ahead_and_below_half_behind() {
    let apparent_speed = |time: f64| apparent_x(0.0, time + 0.5) - apparent_x(0.0, time - 0.5);
    assert!((apparent_speed(-1e3) - 9.0).abs() < 1e-10);
    assert!((apparent_speed(1e3) - 0.9 / 1.9).abs() < 1e-10);
}

#[test]
fn doppler_factors_at_the_landmarks_are_the_textbooks() {
    let doppler = |point: SourcePoint, time: f64| {
        sighting(&speed(), point, Aperture::default(), time).expect("inside the domain").doppler_factor
    };
    let head_on = doppler(SourcePoint { x0: 0.0, y: 0.0, z: 0.0 }, -10.0);
    assert!((head_on - 19.0_f64.sqrt()).abs() < 1e-14, "{head_on}");
    assert!((head_on - 4.3589).abs() < 5e-5);
    assert!((speed().head_on_doppler_factor() - head_on).abs() < 1e-14);
    // The point is seen at X = 0 at T = rho, since it was there at t = 0.
    let abeam = doppler(POINT, 0.5_f64.sqrt());
    assert!((abeam - 0.19_f64.sqrt()).abs() < 1e-14, "{abeam}");
}
