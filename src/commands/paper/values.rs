//! Values and their uncertainties as text, and the mean of two of them.

use relativity_core::math;

/// Whole numbers, as in 1 : 10 : 14.
pub fn ratio_text(ratios: [f64; 3]) -> String {
    ratios.map(|ratio| format!("{ratio:.0}")).join(" : ")
}

/// Writes a value like 0.901(5), the uncertainty with two digits; plain where that is no more than rounding.
pub fn written(value: f64, uncertainty: f64) -> String {
    if uncertainty < 1e-9 {
        return format!("{value:.4}");
    }
    let decimals = (1.0 - math::log10(uncertainty).floor()).max(0.0);
    let digits = (uncertainty * math::powf(10.0, decimals)).round();
    let decimals = decimals as usize;
    format!("{value:.decimals$}({digits})")
}

/// A mean, and its error for independent and for wholly correlated estimates.
pub struct WeightedMean {
    pub mean: f64,
    pub independent: f64,
    pub correlated: f64,
}

/// Mean of two estimates (value, error), weighed by the inverse squares of their errors.
pub fn weighted([a, b]: [[f64; 2]; 2]) -> WeightedMean {
    let [weight_a, weight_b] = [a, b].map(|[_, error]| 1.0 / (error * error));
    let total = weight_a + weight_b;
    WeightedMean {
        mean: (weight_a * a[0] + weight_b * b[0]) / total,
        independent: 1.0 / total.sqrt(),
        correlated: (weight_a * a[1] + weight_b * b[1]) / total,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uncertainties_are_written_as_their_last_digits() {
        assert_eq!(written(0.9012, 0.0051), "0.9012(51)");
        assert_eq!(written(3.02, 0.6), "3.02(60)");
        assert_eq!(written(0.9, 1e-15), "0.9000");
    }

    #[test]
    fn ratios_are_whole_numbers() {
        assert_eq!(ratio_text([1.0, 9.8, 14.2]), "1 : 10 : 14");
    }

    #[test]
    fn equal_weights_average() {
        let WeightedMean { mean, independent, correlated } = weighted([[1.0, 0.2], [2.0, 0.2]]);
        assert!((mean - 1.5).abs() < 1e-12);
        assert!((independent - 0.2 / 2.0_f64.sqrt()).abs() < 1e-12 && (correlated - 0.2).abs() < 1e-12);
    }
}
