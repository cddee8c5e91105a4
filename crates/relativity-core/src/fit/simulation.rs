//! Simulated observations: what a known object would show, with noise.

use rand::SeedableRng as _;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution as _, StandardNormal};

use crate::aperture::Aperture;
use crate::fit::error::FitError;
use crate::fit::observations::{Observations, Reading, Sample};
use crate::fit::prepare::check_pairs;
use crate::fit::trial::Rolling;
use crate::fit::trial::Trial;
use crate::model::Model;
use crate::source::SourcePoint;
use crate::speed::Speed;

/// A known object, and how it is observed by a pair of apertures.
///
/// # Examples
///
/// ```
/// use relativity_core::{Model, Simulation, SourcePoint, Speed, disparity, Aperture};
///
/// let simulation = Simulation {
///     speed: Speed::from_beta(0.9)?,
///     point: SourcePoint { x0: 0.0, y: 3.0, z: 2.0 },
///     rolling: None,
///     pair: Aperture::pair(0.1),
///     model: Model::Exact,
///     times: vec![0.0, 4.0],
///     noise: 0.0,
///     seed: 1,
/// };
/// let observed = simulation.observations()?;
/// let [left, right] = simulation.pair;
/// let seen = disparity(&simulation.speed, simulation.point, left, right, 4.0)?;
/// let reading = observed.samples()[1].dphi.ok_or("no reading")?;
/// assert!((reading.value - seen.dphi).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Simulation {
    /// The object's speed, above 0.
    pub speed: Speed,
    /// The object; of a wheel its hub.
    pub point: SourcePoint,
    /// The point that is seen on a wheel that rolls.
    pub rolling: Option<Rolling>,
    /// The apertures, primary and secondary.
    pub pair: [Aperture; 2],
    /// The binocular model that the curves follow.
    pub model: Model,
    /// Observation times T.
    pub times: Vec<f64>,
    /// Standard deviation of the normal noise, as a share of each curve's range.
    pub noise: f64,
    /// Seed of the noise: a `ChaCha8` generator, the same numbers on every machine.
    pub seed: u64,
}

impl Simulation {
    /// Both curves, sample by sample; without sigmas, as if the noise were unknown.
    ///
    /// # Errors
    ///
    /// [`FitError::Domain`], [`FitError::Sample`] or [`FitError::Pair`] if a number is out of range, or the
    /// model does not know such a pair.
    pub fn observations(&self) -> Result<Observations, FitError> {
        let &Self { speed, point, rolling, pair, model, ref times, noise, seed } = self;
        check_pairs(&Observations::new(vec![pair], Vec::new())?, model)?;
        if let Some(rolling) = rolling {
            rolling.check()?;
        }
        let (passage_time, passage_x) = (0.0, point.x0);
        let object = Trial { speed, y: point.y, z: point.z, passage_time, passage_x, rolling };
        let curves: Vec<[f64; 2]> = times.iter().map(|&time| object.angles(model, &pair, time)).collect();
        let sigmas = [0, 1].map(|curve| noise * range(curves.iter().map(|angles| angles[curve])));
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut reading = |angles: [f64; 2], curve: usize| {
            let deviate: f64 = StandardNormal.sample(&mut random);
            Some(Reading { value: angles[curve] + sigmas[curve] * deviate, sigma: None })
        };
        let samples = times.iter().zip(curves).map(|(&time, angles)| Sample {
            time,
            pair: 0,
            dphi: reading(angles, 0),
            dtheta: reading(angles, 1),
        });
        Observations::new(vec![pair], samples.collect())
    }
}

fn range(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let low = values.clone().fold(f64::INFINITY, f64::min);
    let high = values.fold(f64::NEG_INFINITY, f64::max);
    (high - low).max(0.0)
}
