//! The verdict on a minimum: whether it determines an object.

use nalgebra::Matrix4;

use crate::fit::error::FitError;
use crate::fit::loss::Loss;
use crate::fit::options::Parameter;
use crate::fit::prepare::PreparedData;
use crate::fit::problem::{NormalEquations, Problem};
use crate::fit::regular::RegularProblem;
use crate::fit::trial::Trial;

/// Least ratio of the variance that each parameter explains to that which is left: about the 99.9 % point
/// of the F distribution for three parameters and many samples.
const LEAST_F: f64 = 5.5;
/// Least eigenvalue of the normal equations scaled to a diagonal of ones: sums over hundreds of rows are
/// known to some 1e-14 of that, so that below, rounding decides.
const LEAST_EIGENVALUE: f64 = 1e-13;

/// Refuses a fit that describes the data no better than a constant.
pub(super) fn check_explained(data: &PreparedData, cost: f64) -> Result<(), FitError> {
    let variation = data.variation();
    let per_parameter = (variation - cost) / data.problem.parameters() as f64;
    if per_parameter >= LEAST_F * cost / data.degrees_of_freedom() {
        return Ok(());
    }
    Err(FitError::Unexplained { share: (cost / variation).min(1.0) })
}

/// Covariance of the free parameters, and the rise of the cost that is one variance: of the linear loss
/// `scatter`, the variance of a weighed residual. Of a robust loss the slopes count as in least squares,
/// times the mean derivative of its psi = rho' r, and the rise is the mean of psi^2 over that (Huber and
/// Ronchetti, section 7.6).
///
/// # Errors
///
/// [`FitError::Indistinguishable`] if a standard error exceeds the parameter itself (for z: the distance).
pub(super) fn covariance(
    problem: &Problem,
    trial: &Trial,
    scatter: f64,
) -> Result<(Matrix4<f64>, f64), FitError> {
    let regular = RegularProblem::new(problem, trial);
    let NormalEquations { mut hessian, gradient, .. } = regular.equations(trial, std::iter::repeat(1.0));
    let mut rise = scatter;
    if problem.loss.is_robust() {
        let (slope, squares) = problem.influence(trial);
        let linear = Problem { loss: Loss::default(), ..problem.clone() };
        let linear = RegularProblem::new(&linear, trial).equations(trial, std::iter::repeat(1.0));
        (hessian, rise) = (linear.hessian * slope, squares / slope);
    }
    let fitted = problem.parameters();
    let scale = hessian.diagonal().map(|diagonal| 1.0 / diagonal.sqrt());
    if let Some(index) = (0..fitted).find(|&index| !scale[index].is_finite()) {
        let (parameter, value) = (Parameter::ALL[index].name(), trial.reported()[index]);
        return Err(FitError::Insensitive { parameter, value });
    }
    let outer = scale * scale.transpose();
    let eigen = hessian.component_mul(&outer).symmetric_eigen();
    let (least, eigenvalue) = eigen.eigenvalues.argmin();
    if eigenvalue < LEAST_EIGENVALUE {
        let direction = eigen.eigenvectors.column(least).abs();
        let index = direction.imax();
        let partner = (0..fitted)
            .filter(|&i| i != index)
            .max_by(|&a, &b| direction[a].total_cmp(&direction[b]))
            .unwrap_or(index);
        return Err(indistinguishable(trial, index, partner, f64::INFINITY, 1.0));
    }
    let inverse = eigen.eigenvectors
        * Matrix4::from_diagonal(&eigen.eigenvalues.map(f64::recip))
        * eigen.eigenvectors.transpose();
    let inverse = inverse.component_mul(&outer);
    let mut covariance = inverse * rise;
    if !problem.fits_passage {
        covariance[(3, 3)] = 0.0;
    }
    let step = -(inverse * gradient)[2];
    let height_error = regular.height_error(trial.z, step, covariance[(2, 2)].sqrt());
    covariance.row_mut(2).scale_mut(height_error);
    covariance.column_mut(2).scale_mut(height_error);
    check_determined(problem, trial, &covariance)?;
    Ok((covariance, rise))
}

fn check_determined(problem: &Problem, trial: &Trial, covariance: &Matrix4<f64>) -> Result<(), FitError> {
    let fitted = problem.parameters();
    let sizes = problem.sizes(trial);
    let error = |i: usize| covariance[(i, i)].sqrt();
    let relative = |i: &usize| error(*i) / sizes[*i];
    let Some(worst) = (0..fitted).max_by(|a, b| relative(a).total_cmp(&relative(b))) else { return Ok(()) };
    if relative(&worst) <= 1.0 {
        return Ok(());
    }
    let correlation = |i: usize| covariance[(i, worst)] / (error(i) * error(worst));
    let others = (0..fitted).filter(|&i| i != worst);
    let partner =
        others.max_by(|&a, &b| correlation(a).abs().total_cmp(&correlation(b).abs())).unwrap_or(worst);
    let standard_error = error(worst) * problem.chain(trial)[worst];
    Err(indistinguishable(trial, worst, partner, standard_error, correlation(partner)))
}

fn indistinguishable(
    trial: &Trial,
    index: usize,
    partner: usize,
    standard_error: f64,
    correlation: f64,
) -> FitError {
    let value = trial.reported()[index];
    let [parameter, partner] = [index, partner].map(|i| Parameter::ALL[i].name());
    FitError::Indistinguishable { parameter, value, standard_error, partner, correlation }
}
