//! The least-squares problem: weighed rows of data, and free parameters without bounds.
//!
//! beta in (0, 1) is varied as the logarithm of the rapidity and y > 0 as its logarithm, so that no step
//! leaves the domain; z has a sign and is varied as it is.

use std::f64::consts::TAU;

use levenberg_marquardt::LeastSquaresProblem;
use nalgebra::storage::Owned;
use nalgebra::{Dyn, Matrix4, OMatrix, OVector, U4, Vector4};

use crate::aperture::Aperture;
use crate::fit::gradients::{Gradient, Slopes};
use crate::fit::loss::Loss;
use crate::fit::trial::Rolling;
use crate::fit::trial::Trial;
use crate::math;
use crate::model::Model;
use crate::speed::Speed;

/// Largest rapidity tried (gamma = 1e26): it keeps a wild step inside the domain of [`Speed`].
const MAX_RAPIDITY: f64 = 60.0;
/// Likewise for lengths and times.
const MAX_LENGTH: f64 = 1e50;
/// Least mean derivative of psi.
const LEAST_SLOPE: f64 = 1e-3;

/// A sample that is ready to be fitted.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PreparedSample {
    pub time: f64,
    pub pair: usize,
    /// Delta-phi and Delta-theta; 0 where there is no reading.
    pub values: [f64; 2],
    /// 1/sigma of each reading; 0 where it is not fitted.
    pub weights: [f64; 2],
}

impl PreparedSample {
    /// Delta-phi and Delta-theta: whether each is fitted.
    pub fn is_read(&self) -> [bool; 2] {
        self.weights.map(|weight| weight > 0.0)
    }

    /// The curves that are fitted: 0, 1 or both.
    fn curves(&self) -> impl Iterator<Item = usize> {
        let is_read = self.is_read();
        (0..2).filter(move |&curve| is_read[curve])
    }
}

/// The free parameters: ln(rapidity), ln(y), z and the time of passage t0.
pub(crate) type Free = Vector4<f64>;

/// A weighed residual, and its derivatives by the free or the regular parameters.
pub(crate) type Residual = (f64, Vector4<f64>);

/// The data and the model.
#[derive(Debug, Clone)]
pub(crate) struct Problem {
    pub model: Model,
    pub pairs: Vec<[Aperture; 2]>,
    pub rows: Vec<PreparedSample>,
    /// Objective x at t0.
    pub passage_x: f64,
    /// Whether t0 is fitted; else it is 0.
    pub fits_passage: bool,
    /// The wheel whose hub the object is.
    pub rolling: Option<Rolling>,
    pub loss: Loss,
}

/// Sums over rows: J^T W J, J^T W r and the cost, r^T W r by the linear loss. By another the weights have its
/// rho', so that the gradient is right, and a step of these equations lowers the cost.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct NormalEquations {
    pub hessian: Matrix4<f64>,
    pub gradient: Vector4<f64>,
    pub cost: f64,
}

impl Problem {
    /// The object that `free` describes; `None` if it is not a number.
    pub fn trial(&self, free: &Free) -> Option<Trial> {
        let rapidity = math::exp(free[0]).min(MAX_RAPIDITY);
        let bounded = |value: f64| value.clamp(-MAX_LENGTH, MAX_LENGTH);
        let [y, z, passage_time] = [math::exp(free[1]).min(MAX_LENGTH), bounded(free[2]), bounded(free[3])];
        if y.is_nan() || z.is_nan() || passage_time.is_nan() {
            return None;
        }
        let speed = Speed::from_rapidity(rapidity).ok()?;
        Some(Trial { speed, y, z, passage_time, passage_x: self.passage_x, rolling: self.rolling })
    }

    /// The object that passes as that of `free` does, but whose wheel has turned by some `turns` more since
    /// t' = 0: as the hub passes x = 0 it is at the angle at t' = 0 plus gamma x0/W. `None` if it is not a
    /// wheel, or no such object: where x0 = 0 is known, the wheel has turned as it has.
    pub fn turned(&self, free: &Free, turns: f64) -> Option<Free> {
        let (rolling, trial) = (self.rolling?, self.trial(free)?);
        if turns == 0.0 {
            return Some(*free);
        }
        let by = TAU * turns * rolling.radius;
        let mut turned = *free;
        if self.fits_passage {
            turned[3] += by / (trial.speed.gamma() * trial.speed.beta());
        } else {
            let speed = Speed::from_gamma(trial.speed.gamma() + by / self.passage_x).ok()?;
            turned[0] = math::ln(speed.rapidity());
        }
        turned.iter().all(|value| value.is_finite()).then_some(turned)
    }

    /// The change of t0 for which the wheel has turned once more as it passes.
    pub fn passage_of_turn(&self, trial: &Trial) -> f64 {
        self.rolling.map_or(0.0, |rolling| TAU * rolling.radius / (trial.speed.gamma() * trial.speed.beta()))
    }

    /// Number of fitted parameters.
    pub fn parameters(&self) -> usize {
        3 + usize::from(self.fits_passage)
    }

    /// Number of readings that are fitted.
    pub fn readings(&self) -> usize {
        self.rows.iter().flat_map(PreparedSample::curves).count()
    }

    /// Whether only |z| matters: Delta-phi alone, seen by apertures that all lie at z = 0, of what does not
    /// turn.
    pub fn is_even_in_z(&self) -> bool {
        self.rolling.is_none()
            && self.rows.iter().all(|row| row.weights[1] == 0.0)
            && self.pairs.iter().flatten().all(|aperture| aperture.z == 0.0)
    }

    /// Changes of the free parameters by which beta and y change by themselves, and z and t0 by as much as
    /// the distance.
    pub fn sizes(&self, trial: &Trial) -> Free {
        let distance = math::hypot(trial.y, trial.z);
        let beta = trial.speed.beta();
        Free::new(beta / self.chain(trial)[0], 1.0, distance, distance / beta)
    }

    pub fn slopes(&self, trial: &Trial, row: &PreparedSample) -> Slopes {
        trial.slopes(self.model, &self.pairs[row.pair], row.time, row.is_read())
    }

    /// Delta-phi and Delta-theta, those that `row` reads.
    pub fn angles(&self, trial: &Trial, row: &PreparedSample) -> [f64; 2] {
        trial.wanted_angles(self.model, &self.pairs[row.pair], row.time, row.is_read())
    }

    /// The mean derivative of psi = rho' r at `trial`, and the mean of psi^2 per degree of freedom. A loss by
    /// which most readings are outliers has hardly any slope, and no certainty.
    pub fn influence(&self, trial: &Trial) -> (f64, f64) {
        let (mut slope, mut squares, mut count) = (0.0, 0.0, 0.0);
        for row in &self.rows {
            let residuals = weighed(&self.angles(trial, row), row);
            for residual in row.curves().map(|curve| residuals[curve]) {
                slope += self.loss.slope(residual);
                squares += (self.loss.weight(residual) * residual).powi(2);
                count += 1.0;
            }
        }
        (f64::max(slope / count, LEAST_SLOPE), squares / (count - self.parameters() as f64))
    }

    /// d(beta, y, z, t0)/d(free parameters): it is diagonal. 0 for a parameter that is not fitted.
    pub fn chain(&self, trial: &Trial) -> Gradient {
        let dbeta = trial.speed.rapidity() * trial.speed.inverse_gamma_squared();
        [dbeta, trial.y, 1.0, if self.fits_passage { 1.0 } else { 0.0 }]
    }
}

fn weighed(angles: &[f64; 2], row: &PreparedSample) -> [f64; 2] {
    std::array::from_fn(|curve| row.weights[curve] * (angles[curve] - row.values[curve]))
}

impl NormalEquations {
    /// Adds the row at which the model has `slopes`, `count` times.
    #[inline]
    pub fn add(&mut self, slopes: &Slopes, row: &PreparedSample, count: f64, loss: Loss) {
        let residuals = weighed(&slopes.angles, row);
        for curve in row.curves() {
            let g = slopes.gradients[curve];
            let weight = count * row.weights[curve] * loss.weight(residuals[curve]);
            let scaled = row.weights[curve] * weight;
            for i in 0..4 {
                // Only the lower triangle: the matrix is symmetric, and its factorisation reads no more.
                for j in 0..=i {
                    self.hessian[(i, j)] += scaled * g[i] * g[j];
                }
                self.gradient[i] += weight * residuals[curve] * g[i];
            }
            self.cost += count * loss.cost(residuals[curve]);
        }
    }

    /// In the free parameters, whose `chain` is d(parameter)/d(free parameter). One that is not fitted
    /// gets a unit row, so that its step is 0.
    pub fn in_free_parameters(&self, chain: Gradient) -> Self {
        let scale = Vector4::from(chain);
        let mut hessian = self.hessian;
        for i in 0..4 {
            for j in 0..i {
                hessian[(j, i)] = hessian[(i, j)];
            }
        }
        hessian = hessian.component_mul(&(scale * scale.transpose()));
        for i in 0..4 {
            if chain[i] == 0.0 {
                hessian[(i, i)] = 1.0;
            }
        }
        Self { hessian, gradient: self.gradient.component_mul(&scale), cost: self.cost }
    }
}

/// The problem at one point, for the solver.
pub(crate) struct At<'a> {
    pub problem: &'a Problem,
    pub free: Free,
    /// Whether the speed is kept.
    pub keeps_speed: bool,
}

impl LeastSquaresProblem<f64, Dyn, U4> for At<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, U4>;
    type ParameterStorage = Owned<f64, U4>;

    fn set_params(&mut self, free: &Free) {
        self.free = *free;
    }

    fn params(&self) -> Free {
        self.free
    }

    fn residuals(&self) -> Option<OVector<f64, Dyn>> {
        let trial = self.problem.trial(&self.free)?;
        let residuals = self.problem.rows.iter().flat_map(|row| {
            let residuals = weighed(&self.problem.angles(&trial, row), row);
            let loss = self.problem.loss;
            row.curves().map(move |curve| loss.solver_residual(residuals[curve]).0)
        });
        Some(OVector::<f64, Dyn>::from_iterator(self.problem.readings(), residuals))
    }

    fn jacobian(&self) -> Option<OMatrix<f64, Dyn, U4>> {
        let trial = self.problem.trial(&self.free)?;
        let mut chain = self.problem.chain(&trial);
        if self.keeps_speed {
            chain[0] = 0.0;
        }
        let mut jacobian = OMatrix::<f64, Dyn, U4>::zeros(self.problem.readings());
        let mut index = 0;
        for row in &self.problem.rows {
            let slopes = self.problem.slopes(&trial, row);
            let residuals = weighed(&slopes.angles, row);
            for curve in row.curves() {
                let weight = row.weights[curve] * self.problem.loss.solver_residual(residuals[curve]).1;
                for parameter in 0..4 {
                    jacobian[(index, parameter)] =
                        weight * slopes.gradients[curve][parameter] * chain[parameter];
                }
                index += 1;
            }
        }
        Some(jacobian)
    }
}
