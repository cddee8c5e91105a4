//! report.md: what there is to find, the paper's numbers beside ours, its errata, and what cannot be
//! reproduced.

use std::fmt;

use super::figures::{CURVES, CurveFigure};
use super::fits::{self, ModelFits};
use super::numbers::PaperNumber;
use super::stereo::{Figure, StereoFrame};
use super::values::{WeightedMean, ratio_text, weighted, written};
use crate::estimate::{Attempt, CurvesFit, Parameters};
use crate::flags::words::Shell;

/// The contents of the report.
#[derive(Debug)]
pub struct PaperReport<'a> {
    /// The numbers of the paper's text.
    pub numbers: Vec<PaperNumber>,
    /// Fits of data of the published and of the exact model.
    pub fits: [ModelFits; 2],
    /// Uncertainties for each range of time in which samples were taken.
    pub errors: fits::Errors,
    /// Fits of exact curves by the published model.
    pub bias: [fits::Bias; 3],
    /// Stereo frames, figure by figure.
    pub frames: Vec<(&'a Figure, Vec<StereoFrame>)>,
}

const OPENING: &str = "\
# The paper, reproduced

E. A. Cryer-Jenkins and P. D. Stevenson, *Gamow's cyclist: a new look at relativistic measurements for a binocular
observer*, Proc. R. Soc. A 476 (2020), doi 10.1098/rspa.2019.0703. Made by `gamow paper`; c = 1, angles in radians.

## What was found
";

const MODELS: &str = "
No number of ours was tuned to the paper's. Where they differ, that is the result.

- **published** is the paper's binocular model as its Appendix A prints it: the right eye sees what the left eye saw
  Delta T earlier, and both angles are measured from the left eye.
- **text's sign** is the same with T + Delta T, as the paper's section 3(b) writes.
- **exact**: each eye solves its own light cone.

## Numbers

One value stands for all models where they agree.

| quantity | paper | published | text's sign | exact | remark |
|---|---|---|---|---|---|
";

const FITS: &str = "
## Fits

Table 1, the tracked point:

| beta | y | z | d |
|---|---|---|---|
| 0.9 | 3 | 2 | 0.1 |

Tables 2 (delta-phi) and 3 (delta-theta), with the means of both and a joint fit. The paper's uncertainties are not those of an experiment; it fits a
deterministic simulation and does not say what its residuals are. So we fit curves without noise, which give the truth back
(to nine digits; four are shown), and curves with normal noise of 2 % of their range (240 samples, 1,000 bootstrap replicates).
In parentheses: the uncertainty of the last digits.

| table, fit | | paper | published, no noise | published, 2 % noise | exact, no noise | exact, 2 % noise |
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
- **E7.** The two zeros of delta-theta do not tend to the same time as beta grows. In the published model they stay about
  d/(2 beta) apart, so that this gap alone would tell beta; the exact model has one zero.
- **E8.** The mean of the paper's two values of z is 2.01, not 2.00, and the ratios of its uncertainties are not those that noise
  over the whole passage gives: see *Fits*.
- **E9.** phi = arctan(y/x') needs the quadrant where x' < 0. D^2 is not the brightness of a surface, which is what a picture
  shows: of one wavelength that is D^4. After T0 the tracked point is received beyond 1,600 nm at 0.9 c, not at 1,000 nm.
- **Eq. (6)** gives T0 for the time at which the point is equidistant (t' = 0). The text calls this the zero of delta-phi. That holds
  in the published model only.

## Not reproducible

- The paper's 3-D model of the cyclist, and at which times its numbered frames are. The frames here show what it describes.
- The uncertainties of its fits, since the noise or the residuals behind them are not given.
- The extremes of E5.

## Figures

They have the paper's numbers. Each is an SVG file, with its numbers in a CSV file of the same name. In those of the bicycle x is measured from the eye, as
`gamow eval` does (in the published model from the left one), and in the drawings from the middle between the eyes.
";

impl fmt::Display for PaperReport<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(OPENING)?;
        self.write_findings(f)?;
        f.write_str(MODELS)?;
        for row in &self.numbers {
            let ours = match row.ours.as_slice() {
                [one] => format!("{one} | {one} | {one}"),
                each => each.join(" | "),
            };
            writeln!(f, "| {} | {} | {ours} | {} |", row.quantity, row.paper, row.remark)?;
        }
        f.write_str(FITS)?;
        self.write_fits(f)?;
        self.write_errors(f)?;
        self.write_bias(f)?;
        f.write_str(ERRATA)?;
        let first_frames = self.frames.first().map_or(0, |(figure, _)| figure.number);
        let (before, after) = CURVES.split_at(CURVES.partition_point(|figure| figure.number < first_frames));
        write_curves(f, before)?;
        self.write_frames(f)?;
        writeln!(f, "\n### Fitted curves")?;
        write_curves(f, after)
    }
}

impl PaperReport<'_> {
    /// Writes what a reader should know first, in numbers of this report.
    fn write_findings(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [least, largest, zeros] =
            ["least delta-phi, rad", "largest delta-phi, rad", "zeros of delta-phi, T"]
                .map(|name| self.ours(name));
        write!(
            f,
            "\n1. **Parallax is left out of the paper's model.** It measures both eyes' angles from the left eye. For y = z = \
             0.5, d = 0.3 and beta = 0.9 its delta-phi goes from {} to {} and is zero at T = {}; what two eyes see goes down to \
             {} and is never zero (E3). Fitted to what two eyes see, the published model ",
            least[0], largest[0], zeros[0], least[2]
        )?;
        match &self.bias[0].1 {
            Ok([beta, y, _]) => {
                writeln!(f, "finds beta = {beta:.4} and y = {y:.1} from delta-phi; the truth is 0.9 and 3.")?;
            }
            Err(error) => writeln!(f, "finds nothing: {error}.")?,
        }
        let joint: Vec<String> = (0..3).map(|parameter| cell(&self.fits[1].noisy, 3, parameter)).collect();
        writeln!(
            f,
            "2. **The method works, with the exact model.** From both curves with noise of 2 % of their range it finds beta = {}, \
             y = {} and z = {}; the truth is 0.9, 3 and 2. The paper's own fits are right for data of its own model.",
            joint[0], joint[1], joint[2]
        )?;
        let ratios = |errors: [f64; 3]| ratio_text(errors.map(|error| error / errors[0]));
        writeln!(
            f,
            "3. **The paper's uncertainties are not those of a passage.** From delta-phi they stand as {}; noise over the whole \
             passage gives {}, however large it is, and samples about T0 alone {} (E8). Those of its means are those of wholly \
             correlated fits.",
            ratios(paper_errors()),
            ratios(self.errors.passage),
            ratios(self.errors.window)
        )
    }

    /// Our values of a quantity, by model.
    fn ours(&self, quantity: &str) -> &[String] {
        self.numbers.iter().find(|row| row.quantity == quantity).map_or(&[], |row| &row.ours)
    }

    fn write_fits(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let paper = [
            ("2, delta-phi", ["0.901(5)", "2.99(5)", "2.02(7)"]),
            ("3, delta-theta", ["0.90(1)", "3.02(6)", "1.99(9)"]),
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
        Ok(())
    }

    fn write_errors(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "\nUncertainties of beta, y and z from delta-phi, in the published model. Noise scales all three alike, so that none \
             over the whole passage gives the paper's; when the samples were taken decides their ratio.\n"
        )?;
        writeln!(f, "| | beta | y | z | ratio |")?;
        writeln!(f, "|---|---|---|---|---|")?;
        for (name, errors) in [
            ("paper", paper_errors()),
            ("whole passage, 2 % noise", self.errors.passage),
            ("T0 - 1.25 to T0 + 0.75, 1.6 % noise", self.errors.window),
        ] {
            let [beta, y, z] = errors;
            writeln!(
                f,
                "| {name} | {beta:.4} | {y:.3} | {z:.3} | {} |",
                ratio_text(errors.map(|error| error / beta))
            )?;
        }
        writeln!(f, "\nThe paper's own two fits, weighed by the inverse squares of their uncertainties:\n")?;
        writeln!(f, "| | mean | uncertainty if independent | if wholly correlated | as the paper states |")?;
        writeln!(f, "|---|---|---|---|---|")?;
        let stated = ["0.90(1)", "3.00(5)", "2.00(8)"];
        let decimals = [3, 2, 2];
        for (((symbol, fits), stated), decimals) in
            ["beta", "y", "z"].into_iter().zip(PAPER_FITS).zip(stated).zip(decimals)
        {
            let WeightedMean { mean, independent, correlated } = weighted(fits);
            writeln!(
                f,
                "| {symbol} | {mean:.decimals$} | {independent:.decimals$} | {correlated:.decimals$} | {stated} |"
            )?;
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
        for ((_, outcome), name) in self.bias.iter().zip(["delta-phi", "delta-theta", "both"]) {
            match outcome {
                Ok([beta, y, z]) => writeln!(f, "- {name}: beta = {beta:.4}, y = {y:.2}, z = {z:.2}")?,
                Err(error) => writeln!(f, "- {name}: no fit: {error}")?,
            }
        }
        Ok(())
    }

    fn write_frames(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "\n### Stereo frames\n\nLeft eye on the left. Each picture is a PNG file, too, made by the command below it."
        )?;
        for (figure, frames) in &self.frames {
            writeln!(f, "\n![Fig. {}. {}]({}.svg)\n", figure.number, figure.caption, figure.name)?;
            for frame in frames {
                writeln!(
                    f,
                    "- {}: T = {:.3}; `{}`",
                    frame.file,
                    frame.time,
                    frame.settings.command(Shell::RECORDED)
                )?;
            }
        }
        Ok(())
    }
}

fn write_curves(f: &mut fmt::Formatter<'_>, figures: &[CurveFigure]) -> fmt::Result {
    figures.iter().try_for_each(|figure| {
        writeln!(f, "\n![Fig. {}. {}]({}.svg)", figure.number, figure.caption, figure.name)
    })
}

/// The paper's uncertainties of beta, y and z from delta-phi.
fn paper_errors() -> [f64; 3] {
    PAPER_FITS.map(|[[_, error], _]| error)
}

/// Value and uncertainty of a parameter in fit 0 (azimuthal), 1 (polar), 2 (their mean) or 3 (joint).
fn cell(report: &crate::estimate::FitReport, fit: usize, parameter: usize) -> String {
    let of_outcome = |outcome: &CurvesFit| {
        let estimate = pick(&outcome.parameters, parameter);
        written(estimate.value, estimate.scatter)
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
                match (mean.value, mean.uncertainty) {
                    (Some(value), Some(uncertainty)) => written(value, uncertainty),
                    (Some(value), None) => crate::number_text::significant(value, 3),
                    _ => "none".to_owned(),
                }
            },
        ),
        _ => of_outcome(&report.fit),
    }
}

fn pick<T>(parameters: &Parameters<T>, index: usize) -> &T {
    [&parameters.beta, &parameters.y, &parameters.z][index]
}
