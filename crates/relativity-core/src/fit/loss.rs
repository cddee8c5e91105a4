//! Loss functions: how much a reading counts as its residual grows.
//!
//! The fit minimises the sum of C^2 rho((r/C)^2) over the weighed residuals r, with the scale C. The names
//! and functions are those of `SciPy`'s `least_squares`, whose `f_scale` is C. With the defaults of C a fit
//! of normal noise without outliers scatters 1.026 times as much as the linear one (95 % efficiency).
//!
//! The solver minimises a sum of squares, and gets s = sign(r) C sqrt(rho), whose squares add up to the same.
//!
//! Reference: P. J. Huber and E. M. Ronchetti, *Robust Statistics* (2009), chapter 7.

use crate::math;

/// The function by which a residual counts.
///
/// Its [name](Self::name) stands for it as a flag's value and in files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum LossShape {
    /// By its square: least squares.
    #[default]
    Linear,
    /// By its square where it is small, by its magnitude where it is large, smoothly.
    #[cfg_attr(feature = "clap", value(name = "soft-l1", alias = "soft_l1"))]
    SoftL1,
    /// By its square up to the scale, by its magnitude from there on.
    Huber,
    /// By the logarithm of its square where it is large: a gross outlier counts for hardly anything.
    Cauchy,
}

impl LossShape {
    /// Returns the name of the loss on the command line and in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        ["linear", "soft-l1", "huber", "cauchy"][self as usize]
    }

    /// The scale at which a fit of normal noise has 95 % of the efficiency of least squares.
    const fn efficient_scale(self) -> f64 {
        [1.0, 1.287, 1.345, 2.385][self as usize]
    }
}

/// A loss function with its scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loss {
    /// The function by which the residual counts.
    pub shape: LossShape,
    /// C: the residual from which on a reading counts less, in sigmas; without sigmas in standard deviations
    /// of the curve's scatter.
    pub scale: f64,
}

impl Default for Loss {
    fn default() -> Self {
        Self::of(LossShape::default())
    }
}

impl Loss {
    /// The loss of this `shape` with its default scale.
    #[must_use]
    pub const fn of(shape: LossShape) -> Self {
        Self { shape, scale: shape.efficient_scale() }
    }

    /// Whether outliers count less than by their squares.
    #[must_use]
    pub fn is_robust(self) -> bool {
        self.shape != LossShape::Linear
    }

    /// C^2 rho of a weighed residual.
    #[inline]
    pub(super) fn cost(self, residual: f64) -> f64 {
        if !self.is_robust() {
            return residual * residual;
        }
        let (area, z) = (self.scale * self.scale, self.excess(residual));
        area * match self.shape {
            LossShape::Linear => z,
            // 2 (sqrt(1 + z) - 1), without the subtraction
            LossShape::SoftL1 => 2.0 * z / ((1.0 + z).sqrt() + 1.0),
            LossShape::Huber if z <= 1.0 => z,
            LossShape::Huber => 2.0 * z.sqrt() - 1.0,
            LossShape::Cauchy => math::ln_1p(z),
        }
    }

    /// rho': the weight that a reading has.
    #[inline]
    pub(super) fn weight(self, residual: f64) -> f64 {
        if !self.is_robust() {
            return 1.0;
        }
        let z = self.excess(residual);
        match self.shape {
            LossShape::Linear => 1.0,
            LossShape::SoftL1 => 1.0 / (1.0 + z).sqrt(),
            LossShape::Huber => 1.0 / z.sqrt().max(1.0),
            LossShape::Cauchy => 1.0 / (1.0 + z),
        }
    }

    /// The derivative of rho' r by r.
    pub(super) fn slope(self, residual: f64) -> f64 {
        let z = self.excess(residual);
        match self.shape {
            LossShape::Linear => 1.0,
            LossShape::SoftL1 => self.weight(residual).powi(3),
            LossShape::Huber => f64::from(u8::from(z <= 1.0)),
            LossShape::Cauchy => (1.0 - z) / (1.0 + z).powi(2),
        }
    }

    /// The solver's residual s, and its derivative by r.
    #[inline]
    pub(super) fn solver_residual(self, residual: f64) -> (f64, f64) {
        if !self.is_robust() || residual == 0.0 {
            return (residual, 1.0);
        }
        let root = self.cost(residual).sqrt();
        (root.copysign(residual), self.weight(residual) * residual.abs() / root)
    }

    /// Returns z = (r/C)^2, the square of a residual in scales.
    fn excess(self, residual: f64) -> f64 {
        (residual / self.scale).powi(2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By `SciPy` 1.17.1's own functions of these losses, at z = 0.09 and 16.
    #[test]
    fn losses_are_those_of_scipy() {
        for (shape, expected) in SCIPY {
            let loss = Loss { shape, scale: 2.0 };
            for (residual, [cost, weight, second]) in [0.6, -8.0].into_iter().zip(expected) {
                let z = (residual / 2.0_f64).powi(2);
                let slope = weight + 2.0 * z * second;
                let found = [loss.cost(residual), loss.weight(residual), loss.slope(residual)];
                for (found, expected) in found.into_iter().zip([4.0 * cost, weight, slope]) {
                    assert!((found - expected).abs() < 1e-12, "{shape:?} {residual}: {found} for {expected}");
                }
                let (solver, by) = loss.solver_residual(residual);
                assert!((solver * solver - 4.0 * cost).abs() < 1e-12 && solver * residual > 0.0);
                assert!((solver * by - weight * residual).abs() < 1e-12, "{shape:?}");
            }
        }
    }

    /// rho, rho' and rho''.
    const SCIPY: [(LossShape, [[f64; 3]; 2]); 4] = [
        (LossShape::Linear, [[0.09, 1.0, 0.0], [16.0, 1.0, 0.0]]),
        (
            LossShape::SoftL1,
            [
                [0.088_061_301_782_110_14, 0.957_826_285_221_151_3, -0.439_369_855_606_032_7],
                [6.246_211_251_235_321, 0.242_535_625_036_332_97, -0.007_133_400_736_362_734_5],
            ],
        ),
        (LossShape::Huber, [[0.09, 1.0, 0.0], [7.0, 0.25, -0.007_812_5]]),
        (
            LossShape::Cauchy,
            [
                [0.086_177_696_241_052_33, 0.917_431_192_660_550_4, -0.841_679_993_266_56],
                [2.833_213_344_056_216, 0.058_823_529_411_764_705, -0.003_460_207_612_456_747_5],
            ],
        ),
    ];
}
