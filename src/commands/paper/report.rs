//! report.md: the paper's numbers beside ours, its errata, and what cannot be reproduced.

use std::fmt;

use relativity_core::math;

use super::fits::{self, ModelFits};
use super::numbers::Row;
use super::stereo::{Figure, Frame};
use crate::estimate::{Attempt, CurvesFit, Parameters};

/// Everything the report tells.
#[derive(Debug)]
pub struct PaperReport<'a> {
    /// The numbers of the paper's text.
    pub numbers: Vec<Row>,
    /// Fits of data of the published and of the exact model.
    pub fits: [ModelFits; 2],
    /// Fits of exact curves by the published model.
    pub bias: [fits::Bias; 3],
    /// The stereo frames.
    pub frames: Vec<(&'a Figure, Vec<Frame>)>,
}

const OPENING: &str = "\
# The paper, reproduced

E. A. Cryer-Jenkins and P. D. Stevenson, *Gamow's cyclist: a new look at relativistic measurements for a binocular
observer*, Proc. R. Soc. A 476 (2020), doi 10.1098/rspa.2019.0703. Made by `gamow paper`; c = 1, angles in radians.

- **published** is the paper's binocular model as its Appendix A prints it: the right eye sees what the left eye saw
  Delta T earlier, and both angles are measured from the left eye.
- **text's sign** is the same with T + Delta T, as the paper's section 3(b) writes.
- **exact**: each eye solves its own light cone.

No number of ours was tuned to the paper's. Where they differ, that is the result.

## Numbers

One value stands for all models where they agree.

| quantity | paper | published | text's sign | exact | remark |
|---|---|---|---|---|---|
";

const FITS: &str = "
## Fits

The tracked point: beta = 0.9, y = 3, z = 2, d = 0.1. The paper's uncertainties are not those of an experiment; it fits a
deterministic simulation and does not say what its residuals are. So we fit curves without noise, which give the truth back,
and curves with normal noise of 2 % of their range (240 samples, 1,000 bootstrap replicates). In parentheses: the uncertainty
of the last digits.

| fit | | paper | published, no noise | published, 2 % noise | exact, no noise | exact, 2 % noise |
|---|---|---|---|---|---|---|
";

/// The paper's fits of beta, y and z: value and error from delta-phi, and from delta-theta.
const PAPER_FITS: [[[f64; 2]; 2]; 3] =
    [[[0.901, 0.005], [0.90, 0.01]], [[2.99, 0.05], [3.02, 0.06]], [[2.02, 0.07], [1.99, 0.09]]];

const ERRATA: &str = "
## Errata

- **E1.** Eq. (1), its copy in section 3(b) and the unnumbered shifted form print gamma/c before the root. The light cone gives
  gamma beta, as Appendix A prints. With gamma/c even a resting point would not appear where it is. We use gamma beta throughout.
- **E2.** The text writes X(T + Delta T); Appendix A's expression is X(T - Delta T) in terms of eq. (5). Light that reaches the
  right eye at T was seen by the left eye Delta T earlier, so the minus sign is right to first order. It also gives the signs that
  the figures describe: compare the columns *published* and *text's sign*.
- **E3.** Both angles are measured from the left eye, so that ordinary parallax is left out. It is not small: exactly, delta-phi is
  negative at all times, and delta-theta has one zero instead of two.
- **E4.** Delta T is evaluated at the emission that the left eye sees, not at the one that the right eye sees: right to first order
  in d.
- **E5.** The extremes quoted in the text are not those of any printed variant. Appendix A comes nearest.
- **E6.** Section 3(b) calls the right eye's image before the passage \"later\", section 3(c) \"older\". It is older.
- **Eq. (6)** gives T0 for the time at which the point is equidistant (t' = 0). The text calls this the zero of delta-phi. That holds
  in the published model only.

## Not reproducible

- The paper's 3-D model of the cyclist, and at which times its numbered frames are. The frames here show what it describes.
- The uncertainties of its fits, since the noise or the residuals behind them are not given. Above stands the noise that would cause
  the one of beta.
- The extremes of E5.
";

const CURVE_FIGURES: &str = "
## Figures

Each is an SVG file, with its numbers in a CSV file of the same name.

| file | the paper's figure |
|---|---|
| phi | azimuth seen by each eye, y = z = 0.5, d = 0.3, beta = 0.9 |
| phi-difference | delta-phi at beta = 0.9, 0.7, 0.5 |
| theta | elevation seen by each eye |
| theta-difference | delta-theta at beta = 0.9, 0.7, 0.5 |
| bicycle-2d | the two-dimensional bicycle |
| bicycle-2d-one-eye | as one eye sees it, beta = 0.9 |
| bicycle-2d-two-eyes | as two eyes see it, beta = 0.9, d = 0.3 |
| fit-phi | delta-phi of the tracked point and its fit |
| fit-theta | delta-theta of the tracked point and its fit |
";

impl fmt::Display for PaperReport<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(OPENING)?;
        for row in &self.numbers {
            let ours = match row.ours.as_slice() {
                [one] => format!("{one} | {one} | {one}"),
                each => each.join(" | "),
            };
            writeln!(f, "| {} | {} | {ours} | {} |", row.quantity, row.paper, row.remark)?;
        }
        f.write_str(FITS)?;
        self.write_fits(f)?;
        self.write_bias(f)?;
        f.write_str(ERRATA)?;
        f.write_str(CURVE_FIGURES)?;
        self.write_frames(f)
    }
}

impl PaperReport<'_> {
    fn write_fits(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let paper = [
            ("delta-phi", ["0.901(5)", "2.99(5)", "2.02(7)"]),
            ("delta-theta", ["0.90(1)", "3.02(6)", "1.99(9)"]),
            ("weighted mean", ["0.90(1)", "3.00(5)", "2.00(8)"]),
            ("joint", ["-", "-", "-"]),
        ];
        for (fit, (name, stated)) in paper.into_iter().enumerate() {
            for (parameter, stated) in stated.into_iter().enumerate() {
                let symbol = ["beta", "y", "z"][parameter];
                write!(f, "| {name} | {symbol} | {stated} |")?;
                for model in &self.fits {
                    let noisy = cell(&model.noisy, fit, parameter);
                    write!(f, " {} | {noisy} |", cell(&model.clean, fit, parameter))?;
                }
                writeln!(f)?;
            }
        }
        for model in &self.fits {
            let (name, percent) = (model.model.name(), 100.0 * model.noise_of_paper);
            writeln!(
                f,
                "\nIn the {name} model, noise of {percent:.1} % of the range would give beta from delta-phi the paper's uncertainty of 0.005."
            )?;
        }
        writeln!(f, "\nThe paper's own two fits, weighed by the inverse squares of their uncertainties:\n")?;
        writeln!(f, "| | mean | uncertainty if independent | if wholly correlated | as the paper states |")?;
        writeln!(f, "|---|---|---|---|---|")?;
        let stated = ["0.01", "0.05", "0.08"];
        for ((symbol, fits), stated) in ["beta", "y", "z"].into_iter().zip(PAPER_FITS).zip(stated) {
            let WeightedMean { mean, independent, correlated } = weighted(fits);
            writeln!(f, "| {symbol} | {mean:.4} | {independent:.4} | {correlated:.4} | {stated} |")?;
        }
        writeln!(
            f,
            "\nSo the paper's means have the uncertainties of wholly correlated fits. We measure the correlation, over \
             bootstrap replicates of the same samples; with normal noise of its own in each curve it is near zero."
        )
    }

    fn write_bias(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "\n### What leaving out parallax does\n\nExact curves without noise (truth: beta 0.9, y 3, z 2), fitted by the \
             published model:\n"
        )?;
        for (curves, outcome) in &self.bias {
            match outcome {
                Ok([beta, y, z]) => {
                    writeln!(f, "- {}: beta = {beta:.4}, y = {y:.3}, z = {z:.3}", curves.name())?;
                }
                Err(error) => writeln!(f, "- {}: no fit: {error}", curves.name())?,
            }
        }
        Ok(())
    }

    fn write_frames(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "\n## Stereo frames\n\nLeft eye on the left. Each figure is an SVG file that shows its PNG files."
        )?;
        for (figure, frames) in &self.frames {
            writeln!(f, "\n**{}.svg**: {}\n", figure.name, figure.caption)?;
            for frame in frames {
                writeln!(f, "- {}: T = {:.3}; `{}`", frame.file, frame.time, frame.settings.command())?;
            }
        }
        Ok(())
    }
}

/// Value and uncertainty of a parameter in fit 0 (azimuthal), 1 (polar), 2 (their mean) or 3 (joint).
fn cell(report: &crate::estimate::FitReport, fit: usize, parameter: usize) -> String {
    let of_outcome = |outcome: &CurvesFit| {
        let estimate = pick(&outcome.parameters, parameter);
        written(estimate.value, estimate.uncertainty)
    };
    let of_attempt = |attempt: &Option<Attempt>| match attempt {
        Some(Attempt::Fit(outcome)) => of_outcome(outcome),
        Some(Attempt::Failure { problem }) => problem.clone(),
        None => "none".to_owned(),
    };
    match fit {
        0 => of_attempt(&report.fits.dphi),
        1 => of_attempt(&report.fits.dtheta),
        2 => report.fits.combined.as_ref().map_or_else(
            || "none".to_owned(),
            |means| {
                let mean = pick(means, parameter);
                written(mean.value, mean.uncertainty)
            },
        ),
        _ => of_outcome(&report.fit),
    }
}

fn pick<T>(parameters: &Parameters<T>, index: usize) -> &T {
    [&parameters.beta, &parameters.y, &parameters.z][index]
}

/// As in 0.901(5), the uncertainty with two digits; plain where it is no more than rounding.
fn written(value: f64, uncertainty: f64) -> String {
    if uncertainty < 1e-9 {
        return format!("{value:.10}");
    }
    let decimals = (1.0 - math::log10(uncertainty).floor()).max(0.0);
    let digits = (uncertainty * math::powf(10.0, decimals)).round();
    let decimals = decimals as usize;
    format!("{value:.decimals$}({digits})")
}

/// A mean, and its error for independent and for wholly correlated estimates.
struct WeightedMean {
    mean: f64,
    independent: f64,
    correlated: f64,
}

/// Mean of two estimates (value, error), weighed by the inverse squares of their errors.
fn weighted([a, b]: [[f64; 2]; 2]) -> WeightedMean {
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
        assert_eq!(written(0.9, 1e-15), "0.9000000000");
    }

    #[test]
    fn equal_weights_average() {
        let WeightedMean { mean, independent, correlated } = weighted([[1.0, 0.2], [2.0, 0.2]]);
        assert!((mean - 1.5).abs() < 1e-12);
        assert!((independent - 0.2 / 2.0_f64.sqrt()).abs() < 1e-12 && (correlated - 0.2).abs() < 1e-12);
    }
}
