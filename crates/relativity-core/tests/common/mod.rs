//! Synthetic observations of a known object, for the tests, the experiment and the benchmark of the fit.

#![allow(dead_code, reason = "each program that includes this module uses its own part")]
#![allow(clippy::allow_attributes, reason = "an expectation would fail in the programs that use every part")]

use rand::{Rng, RngExt as _};
use relativity_core::{Aperture, Model, Observations, Rolling, Sample, Simulation, SourcePoint, Speed};

/// An object and how it is observed.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    pub beta: f64,
    pub y: f64,
    pub z: f64,
    pub x0: f64,
    pub separation: f64,
    pub samples: usize,
    /// Standard deviation of the noise over the range of its curve.
    pub noise: f64,
    /// The samples cover the passage from -extent to +extent, in units of the distance.
    pub extent: f64,
    /// The wheel whose hub the object is.
    pub rolling: Option<Rolling>,
}

/// The paper's tracked point.
pub const PAPER: Case = Case {
    beta: 0.9,
    y: 3.0,
    z: 2.0,
    x0: 0.0,
    separation: 0.1,
    samples: 240,
    noise: 0.0,
    extent: 3.0,
    rolling: None,
};

impl Case {
    /// A case from the domain that the fit is held against: beta 0.1 to 0.99, y and |z| 0.3 to 10,
    /// d 0.05 to 0.5, 120 to 500 samples, noise 0.1 to 2 % of each curve's range.
    pub fn drawn(random: &mut impl Rng) -> Self {
        let mut between = |low: f64, high: f64| random.random_range(low..high);
        let log = |value: f64| value.exp();
        Self {
            beta: between(0.1_f64.atanh(), 0.99_f64.atanh()).tanh(),
            y: log(between(0.3_f64.ln(), 10.0_f64.ln())),
            z: log(between(0.3_f64.ln(), 10.0_f64.ln())) * between(-1.0, 1.0).signum(),
            x0: between(-5.0, 5.0),
            separation: log(between(0.05_f64.ln(), 0.5_f64.ln())),
            samples: between(120.0, 501.0) as usize,
            noise: between(0.001, 0.02),
            extent: between(1.5, 4.0),
            rolling: None,
        }
    }

    pub fn truth(&self) -> [f64; 4] {
        [self.beta, self.y, self.z, self.x0]
    }

    pub fn times(&self) -> Vec<f64> {
        let distance = self.y.hypot(self.z);
        let received = |k: f64| (k * distance - self.x0) / self.beta + distance * k.hypot(1.0);
        let (from, to) = (received(-self.extent), received(self.extent));
        let last = (self.samples - 1) as f64;
        (0..self.samples).map(|i| from + (to - from) * i as f64 / last).collect()
    }

    pub fn observations(&self, model: Model, seed: u64) -> Observations {
        let simulation = Simulation {
            speed: Speed::from_beta(self.beta).expect("a speed"),
            point: SourcePoint { x0: self.x0, y: self.y, z: self.z },
            rolling: self.rolling,
            pair: Aperture::pair(self.separation),
            model,
            times: self.times(),
            noise: self.noise,
            seed,
        };
        simulation.observations().expect("usable samples")
    }

    /// Samples of this case, with noise from `seed`.
    pub fn samples(&self, model: Model, seed: u64) -> Vec<Sample> {
        self.observations(model, seed).samples().to_vec()
    }
}
