//! Exact special-relativistic optics for any number of apertures.
//!
//! A point moves along +x at a constant speed, or turns on a wheel that does; apertures at rest on the
//! ground, or of an [`observer`] who moves, each solve their own light cone for it. Pure numerics: no I/O, no
//! logging, no graphics.
//!
//! # Conventions
//!
//! - c = 1; lengths and times share one unit; angles are radians.
//! - Ground frame: x to the right (the direction of motion), y forward, z up.
//! - Rest frame: the moving object's own. Its origin passes the ground's origin at t = 0. A point at
//!   rest coordinates (xr, y, z) is *objectively* at x0 = xr / gamma at t = 0 (contracted).
//! - `T` (`observation_time`) is when light is received, `t` (`retarded_time`) when it was emitted.
//! - tau (`proper_time`) is the time of emission on the point's own clock, gamma (t - beta x): all clocks of
//!   the rest frame are set alike in that frame, and the one at its origin shows 0 at t = 0.
//! - phi is the azimuth from +x towards +y, theta the elevation from the x-y plane. (Much of the
//!   literature measures a polar angle from +z; we follow the paper.)
//! - Doppler factor D = received / rest frequency: above 1 is a blueshift. (Some authors call its
//!   inverse the Doppler factor.)
//! - Disparity = primary (left) minus secondary (right).
//!
//! # Domain
//!
//! Coordinates and times up to [`MAX_COORDINATE`] in magnitude, gamma up to [`MAX_GAMMA`]. Inside it every
//! result is finite, but for powers of D. Functions of a coordinate or a time return an error outside it;
//! those of a direction ([`aberration`]) or of D alone ([`doppler`]) have nothing to refuse. Lengths whose
//! squares underflow (rho/gamma below 1e-150) count as zero. The batch forms in f32 have a smaller domain
//! ([`batch::Real`]), and there lengths below 1e-19 count as zero.
//!
//! # From formula to function
//!
//! Of a point at x = x0 + beta t, y, z, seen at T by an aperture at A; n is the unit vector from there to
//! where it is seen, and R how far away that is.
//!
//! | formula | function |
//! |---|---|
//! | T - t = R = \|r(t) - A\|: where and when its light left | [`sighting`] |
//! | D = 1/(gamma (1 + beta `n_x`)) | [`Sighting::doppler_factor`], [`aberration::doppler_factor`] |
//! | n' = (`n_x` + beta, `n_y`/gamma, `n_z`/gamma)/(1 + beta `n_x`) | [`aberration::rest_from_ground`] |
//! | tau = gamma (t - beta x) | [`Sighting::proper_time`] |
//! | phi = atan2(Y, X), theta = atan2(Z, hypot(X, Y)) | [`Sighting::phi`], [`Sighting::theta`] |
//! | lambda = `lambda_rest`/D | [`doppler::received_wavelength`] |
//! | I = `I_rest` D^n | [`doppler::intensity_factor`] |
//! | Delta-phi = `phi_left` - `phi_right`, Delta-theta likewise | [`disparity()`], [`disparities`] |
//! | gain = (`X_left` - `X_right`)/d, and where lines of sight meet | [`stereo()`] |
//! | u = arsinh(X/hypot(Y, Z)), v = atan2(Z, Y) | [`Conformal::from_direction`] |
//! | T0: equally far from both apertures | [`equidistance_time`] |
//! | T = (x - x0)/beta + hypot(x, y, z): when it is seen at x | [`observation_time_when_seen_at`] |
//! | gamma = 1/sqrt(1 - beta^2) | [`Speed::from_beta`], [`Speed::from_gamma`] |
//! | eta = artanh(beta) | [`Speed::from_rapidity`] |
//! | proper acceleration a for tau: eta + a tau | [`Ride`], [`RideMoment::after`] |
//! | the light cone of a point of a rolling wheel | [`wheel`], [`sighting`] of a [`WheelPoint`] |
//! | the paper's binocular model | [`published_disparity`] |
//! | least squares in beta, y, z, x0, and its bootstrap | `fit`, `bootstrap` (feature `fit`) |
//!
//! # Features
//!
//! - `fit` (default): `fit`, `bootstrap` and `combined`, with their libraries of linear algebra and of random
//!   numbers.
//! - `clap`, `serde`: what a user chooses, as values of flags and of files.
//!
//! # Versions
//!
//! [Semantic versioning](https://semver.org): until 1.0 the second number counts what may break code that
//! uses this crate. A change of a result within its stated error breaks nothing.
//!
//! # Examples
//!
//! ```
//! use relativity_core::{Aperture, SourcePoint, Speed, disparity, equidistance_time, sighting};
//!
//! // The paper's cyclist passes 3 ahead of two eyes that are 0.1 apart, and 2 higher than they.
//! let speed = Speed::from_beta(0.9)?;
//! let point = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
//! let [left, right] = Aperture::pair(0.1);
//!
//! // At T = 0 it is objectively abreast, but seen where it was at t = -8.27, blueshifted by gamma = 2.29.
//! let seen = sighting(&speed, point, Aperture::default(), 0.0)?;
//! assert!((seen.position[0] + 7.4445).abs() < 1e-4 && (seen.retarded_time + 8.2717).abs() < 1e-4);
//! assert!((seen.doppler_factor - 2.2942).abs() < 1e-4);
//!
//! // Both eyes see it equally far, and in the same elevation, at T0 = sqrt(3^2 + 2^2 + 0.05^2).
//! let t0 = equidistance_time(&speed, point, [left, right])?.ok_or("at rest")?;
//! assert!((t0 - 13.0025_f64.sqrt()).abs() < 1e-15);
//! let both = disparity(&speed, point, left, right, t0)?;
//! assert!(both.dtheta.abs() < 1e-15 && both.dphi < 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Out of scope
//!
//! Acceleration of the moving body (that of the observer is a [`ride`]), and its rotation but for wheels that
//! turn evenly about an axle along y ([`wheel`]), gravity, apertures of finite size or exposure.
//!
//! # References
//!
//! - E. A. Cryer-Jenkins and P. D. Stevenson, *Gamow's cyclist: a new look at relativistic
//!   measurements for a binocular observer*, Proc. R. Soc. A 476 (2020), 10.1098/rspa.2019.0703;
//!   "the paper" throughout.
//! - P. M. Mathews and M. Lakshmanan, *On the apparent visual forms of relativistically moving
//!   objects*, Nuovo Cimento B 12 (1972).
#![cfg_attr(
    not(test),
    warn(clippy::disallowed_methods, clippy::disallowed_types, clippy::print_stdout, clippy::print_stderr)
)]

/// The accuracy of every output: its error is at most this many units of
/// `2^-53 (|f| + sum |x_i df/dx_i|)`, the `x_i` being the inputs; 2^-24 in f32. One unit is what rounding the
/// result and the inputs once each can do.
///
/// `tests/oracle` holds every public function to this, against 115-digit arithmetic that solves the light
/// cone from its definition: beta from 1e-14 to 1 - 1e-15, gamma to 1e12, rapidity to 30, lengths to 1e6,
/// times to 1e10, inputs drawn towards trouble. Next to a jump (phi at X = 0, close to the x-z plane) the
/// derivatives are replaced by the chords over this many roundings of the inputs.
pub const MAX_ERROR_UNITS: f64 = 8.0;

pub mod aberration;
pub mod aperture;
pub mod apparent;
pub mod baseline;
pub mod batch;
mod batch_error;
#[cfg(feature = "fit")]
pub mod bootstrap;
#[cfg(feature = "fit")]
pub mod combined;
mod cone_pair;
pub mod conformal;
pub mod disparity;
pub mod domain;
pub mod doppler;
#[cfg(feature = "fit")]
pub mod fit;
pub mod math;
mod model;
mod observation_batch;
pub mod observer;
pub mod one_cone;
pub mod passage;
pub mod published;
mod real;
pub mod reception;
pub mod ride;
pub mod source;
pub mod speed;
pub mod stereo;
pub mod threads;
pub mod wheel;
pub mod worldline;

pub use aperture::Aperture;
pub use apparent::{Sighting, sighting};
pub use baseline::{Baseline, HeadAxes};
#[cfg(feature = "fit")]
pub use bootstrap::{Bootstrap, DEFAULT_REPLICATES, bootstrap};
#[cfg(feature = "fit")]
pub use combined::{Combined, combined};
pub use conformal::{Conformal, ConformalDisparity};
pub use disparity::{Disparity, disparities, disparity};
pub use domain::{DomainError, MAX_COORDINATE};
#[cfg(feature = "fit")]
pub use fit::{
    Curves, Fit, FitError, FitOptions, Loss, LossShape, NotConverged, Observations, OtherSide, Parameter,
    Passage, Reading, Rolling, Sample, SerialCorrelation, Simulation, fit, fit_from,
};
pub use model::{Model, PairError};
pub use observer::{Observer, ObserverError, ObserverVelocity, RelativeVelocity};
pub use one_cone::one_cone_disparity;
pub use passage::{equidistance_time, observation_time_when_seen_at};
pub use published::{PublishedVariant, printed_apparent_x, published_disparity};
pub use reception::Reception;
pub use ride::{Leg, Odometers, Ride, RideMoment, RiderVelocity};
pub use source::{Source, SourcePoint, Turning, WheelPoint};
pub use speed::{MAX_GAMMA, Speed, SpeedError};
pub use stereo::{Stereo, StereoError, stereo};
pub use worldline::{Boost, Event, Worldline};

/// The example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
