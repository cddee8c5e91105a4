//! The table of a fit: each parameter with its uncertainty beside the truth, and a verdict.

use eframe::egui::{Grid, RichText, Ui};
use relativity_core::{DEFAULT_REPLICATES, Model, Parameter};

use crate::app::state::fitting::{FitOutcome, Fitted, Fitting};
use crate::app::widgets::named_text;
use crate::app::widgets::theme;
use crate::caption::capitalised;
use crate::estimate::samples::Samples;
use crate::estimate::{Estimate, left_out, sigmas};
use crate::number_text;
use crate::units::Unit;

/// Estimates further off than this many standard errors are not chance.
const CHANCE: f64 = 3.0;
/// Below this share of a parameter its uncertainty is rounding, and no measure of anything.
const ROUNDING: f64 = 1e-10;
/// Shown for an uncertainty that there is none of.
const NOT_STATED: &str = "—";
/// The number of the interval's column.
const INTERVAL: usize = 3;

/// Shows the newest outcome, its lengths in this unit, faintly if it is outdated.
pub fn show(ui: &mut Ui, fitting: &Fitting, length: Unit) {
    ui.spacing_mut().item_spacing.y = 4.0;
    let Some(outcome) = newest(ui, fitting, length, TableColumns::All) else { return };
    if let Some(bias) = &outcome.bias {
        let made = outcome.key.simulated().map(|simulated| simulated.model);
        let neglect = Neglect::new(outcome.key.setup.model, made);
        let tip = format!("The same fit to samples without noise, minus the truth.\n{}", neglect.reason);
        ui.label(bias_note(&neglect, bias, length)).on_hover_text(tip);
    }
    if let Some(file) = outcome.key.file() {
        let told = left_out::remark(&file.left_out).as_deref().map_or_else(
            || "A click on a reading in the plots leaves it out.".to_owned(),
            |left_out| format!("{} A click on a reading takes it back.", sentence(left_out)),
        );
        ui.label(RichText::new(told).weak().small());
    }
    if let Ok(fitted) = &outcome.fitted {
        notes(ui, outcome, fitted);
    }
}

/// Shows an audience the newest outcome: the numbers, and whether they are right.
pub fn show_presented(ui: &mut Ui, fitting: &Fitting, length: Unit) {
    newest(ui, fitting, length, TableColumns::Few);
}

/// Shows the numbers of the newest outcome and whether they are right, or why there is no fit; returns the
/// outcome.
fn newest<'a>(
    ui: &mut Ui,
    fitting: &'a Fitting,
    length: Unit,
    columns: TableColumns,
) -> Option<&'a FitOutcome> {
    let Some(outcome) = fitting.shown() else {
        ui.label(RichText::new("Fitting …").weak());
        return None;
    };
    if fitting.is_outdated() {
        ui.multiply_opacity(0.5);
    }
    match &outcome.fitted {
        Ok(fitted) => {
            table(ui, fitted, length, columns);
            if let Some(verdict) = verdict(fitted) {
                ui.label(RichText::new(verdict).strong());
            }
            if fitted.warning.is_some() {
                ui.label(RichText::new("The residuals follow one another: no uncertainty.").strong());
            }
        }
        Err(problem) => {
            ui.label(RichText::new("No fit").strong());
            ui.label(sentence(problem));
        }
    }
    Some(outcome)
}

/// The columns of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum TableColumns {
    /// Every column, the interval included.
    All,
    /// Every column but the interval, for an audience.
    Few,
}

fn table(ui: &mut Ui, fitted: &Fitted, length: Unit, columns: TableColumns) {
    let apart = 6.0 * theme::text_scale(ui.style());
    Grid::new("fit").num_columns(6).spacing([apart, 3.0]).min_col_width(12.0).show(ui, |ui| {
        let mut heads = vec![
            ("", "Parameter"),
            ("value", "The best fit: least sum of squared residuals."),
            ("±", "Standard error: standard deviation over the bootstrap's replicates, refits of samples drawn with replacement. — where the residuals follow one another: none follows then."),
            ("95 %", "Interval that holds the truth in 95 of 100 measurements: the 2.5th to the 97.5th percentile of the replicates, drawn apart where few readings count for most."),
        ];
        if columns == TableColumns::Few {
            heads.truncate(INTERVAL);
        }
        if fitted.estimates.iter().any(|(.., truth)| truth.is_some()) {
            heads.extend([
                ("truth", "What the samples were made with."),
                ("off", "(value − truth) / standard deviation over the replicates"),
            ]);
        }
        for (head, tip) in heads {
            ui.label(RichText::new(head).weak()).on_hover_text(tip);
        }
        ui.end_row();
        for (parameter, estimate, truth) in &fitted.estimates {
            let unit = if *parameter == Parameter::Beta { Unit::OWN } else { length };
            let truth = truth.map(|truth| unit.shown(truth));
            row(ui, *parameter, unit, &shown(estimate, unit), truth, columns);
        }
    });
}

/// `estimate` in this unit.
fn shown(estimate: &Estimate, unit: Unit) -> Estimate {
    Estimate {
        value: unit.shown(estimate.value),
        uncertainty: estimate.uncertainty.map(|value| unit.shown(value)),
        ci95: estimate.ci95.map(|ends| ends.map(|end| unit.shown(end))),
        uncertainty_linear: estimate.uncertainty_linear.map(|value| unit.shown(value)),
        scatter: unit.shown(estimate.scatter),
    }
}

/// An estimate and the truth if that is known, both in this unit.
fn row(
    ui: &mut Ui,
    parameter: Parameter,
    unit: Unit,
    estimate: &Estimate,
    truth: Option<f64>,
    columns: TableColumns,
) {
    let (symbol, tip) = named(parameter);
    let Estimate { value, uncertainty, ci95, .. } = *estimate;
    let places = estimate.decimals() as u8;
    let number = |value| number_text::fixed(value, places);
    ui.label(unit.label(symbol)).on_hover_text(tip);
    let value_text = RichText::new(number(value)).strong();
    named_text(ui, value_text, format!("Fitted {symbol}: {}", number(value)));
    let uncertainty = uncertainty.map_or_else(|| NOT_STATED.to_owned(), number);
    named_text(ui, uncertainty.as_str(), format!("Uncertainty of {symbol}: {uncertainty}"));
    if columns == TableColumns::All {
        let interval = ci95.map_or_else(
            || NOT_STATED.to_owned(),
            |[low, high]| format!("{} … {}", number(low), number(high)),
        );
        named_text(ui, interval.as_str(), format!("95 % interval of {symbol}: {interval}"));
    }
    if let Some(truth) = truth {
        let truth_text = number_text::trimmed(truth, 4);
        named_text(ui, truth_text.as_str(), format!("True {symbol}: {truth_text}"));
        let off = off(estimate, truth);
        named_text(ui, off.as_str(), format!("{symbol} off by {off}"));
    }
    ui.end_row();
}

/// Returns the symbol and the meaning of a parameter.
fn named(parameter: Parameter) -> (&'static str, &'static str) {
    match parameter {
        Parameter::Beta => ("β", "Speed over c."),
        Parameter::Y => ("y", "Distance in front of the eyes."),
        Parameter::Z => ("z", "Height above the eyes."),
        Parameter::X0 => ("x₀", "Where the point is at t = 0, along the motion."),
    }
}

fn is_rounding(estimate: &Estimate, truth: f64) -> bool {
    estimate.scatter <= ROUNDING * truth.abs().max(ROUNDING)
}

fn deviation(estimate: &Estimate, truth: f64) -> f64 {
    (estimate.value - truth) / estimate.scatter
}

/// Writes the error of an estimate: in standard errors, or itself if those mean nothing.
fn off(estimate: &Estimate, truth: f64) -> String {
    if is_rounding(estimate, truth) {
        return signed(estimate.value - truth, 9);
    }
    format!("{}σ", signed(deviation(estimate, truth), 1))
}

fn signed(value: f64, decimals: u8) -> String {
    let sign = if value > 0.0 { "+" } else { "" };
    format!("{sign}{}", number_text::fixed(value, decimals))
}

/// Returns the verdict on the estimates by the truth; `None` where that is not known.
fn verdict(fitted: &Fitted) -> Option<String> {
    let known = || {
        let all = fitted.estimates.iter();
        all.filter_map(|(parameter, estimate, truth)| Some((*parameter, estimate, (*truth)?)))
    };
    known().next()?;
    let deviations = known()
        .filter(|(_, estimate, truth)| !is_rounding(estimate, *truth))
        .map(|(parameter, estimate, truth)| (parameter, deviation(estimate, truth).abs()));
    let Some((parameter, worst)) = deviations.max_by(|a, b| a.1.total_cmp(&b.1)) else {
        let errors = known().map(|(_, estimate, truth)| (estimate.value - truth).abs());
        return Some(format!("Recovered to {}.", number_text::fixed(errors.fold(0.0, f64::max), 9)));
    };
    let errors = number_text::fixed(worst, 1);
    Some(if worst <= CHANCE {
        format!("Agrees with the truth to within {errors} σ.")
    } else {
        format!("Wrong: {} is {errors} σ off.", named(parameter).0)
    })
}

/// Returns the assumptions about the samples, a sentence each.
fn assumptions(outcome: &FitOutcome, fitted: &Fitted) -> Vec<String> {
    let other_side = fitted.other_side.as_deref().map(sentence);
    let (file, baseline) = match &outcome.key.samples {
        Samples::Simulated(simulated) => {
            let on_a_wheel = simulated.rolling().map(|_| ON_A_WHEEL.to_owned());
            return on_a_wheel.into_iter().chain(other_side).collect();
        }
        Samples::Measured(file, baseline) => (file, baseline),
    };
    let mut told: Vec<String> = file.treatment.as_deref().map(sentence).into_iter().collect();
    if !file.has_separation {
        let d = number_text::trimmed(baseline.separation, 4);
        told.push(format!("The file has no column d: the eyes are d = {d} apart, as set."));
    }
    match fitted.reduced_chi_squared {
        Some(chi) => {
            told.push(format!("χ² per degree of freedom: {}", number_text::fixed(chi, 2)));
            let parameters = fitted.estimates.len();
            let remark = sigmas::remark(Some(chi), fitted.readings, parameters);
            told.extend(remark.as_deref().map(sentence));
        }
        None if file.has_sigmas => {
            told.push("Some readings have no sigma: all readings of a curve count alike.".to_owned());
        }
        None => told.push(
            "The file has no sigmas: each reading is assumed as uncertain as the residuals suggest."
                .to_owned(),
        ),
    }
    if !outcome.key.setup.fit_x0 {
        told.push("x₀ is fixed at 0: the point is level with you at t = 0.".to_owned());
    }
    told.extend(other_side);
    told
}

const ON_A_WHEEL: &str = "The point is on a wheel that rolls: y, z and x₀ are its hub's, and the point's \
    place on the wheel is taken as known.";

fn notes(ui: &mut Ui, outcome: &FitOutcome, fitted: &Fitted) {
    let milliseconds = number_text::fixed(1e3 * outcome.elapsed.as_secs_f64(), 0);
    let rms = number_text::with_minus(&number_text::significant(fitted.rms, 3));
    let uncertainties = match &fitted.no_bootstrap {
        None => format!("{DEFAULT_REPLICATES} replicates"),
        Some(_) => "no bootstrap".to_owned(),
    };
    let serial = fitted.residuals.map_or_else(String::new, |residuals| {
        format!("  ·  Durbin-Watson {}", number_text::fixed(residuals.durbin_watson, 2))
    });
    let text = format!("rms {rms} rad{serial}  ·  {} readings  ·  {uncertainties}", fitted.readings);
    // The time is no part of the picture: the same state is drawn the same.
    let tip = format!(
        "Root mean square of sample minus fit. Durbin-Watson is near 2 if residuals are chance, and near 0 if they follow one another, as where the model is wrong. Fit and bootstrap took {milliseconds} ms."
    );
    ui.label(RichText::new(text).weak().small()).on_hover_text(tip);
    let wrong = [&fitted.warning, &fitted.cause, &fitted.outliers]
        .into_iter()
        .filter_map(|told| told.as_deref().map(sentence));
    for told in wrong.chain(assumptions(outcome, fitted)) {
        ui.label(RichText::new(told).weak().small());
    }
    if let Some(problem) = &fitted.no_bootstrap {
        ui.label(RichText::new(format!("± by linearisation: {problem}.")).small());
    }
}

/// The neglect of a fit by a model that did not make the data.
struct Neglect {
    doing: &'static str,
    it_does: &'static str,
    reason: &'static str,
}

impl Neglect {
    /// Returns the neglect of `fitted`, for data that were `made` by another model.
    const fn new(fitted: Model, made: Option<Model>) -> Self {
        match (fitted, made) {
            (Model::Published(_), _) => Self {
                doing: "Leaving out parallax",
                it_does: "It leaves out parallax",
                reason: "The published model measures both angles from the left eye; what the eyes see has parallax.",
            },
            (Model::OneCone, _) => Self {
                doing: "Taking one light cone for both eyes",
                it_does: "It takes one light cone for both eyes",
                reason: "Each eye receives events of its own; the fit puts the difference that this makes \
                    down to distance and speed.",
            },
            (Model::Exact, Some(Model::Published(_))) => Self {
                doing: "Having parallax where the data leave it out",
                it_does: "It has parallax where the data leave it out",
                reason: "The samples are those of the published model, which measures both angles from the left eye.",
            },
            (Model::Exact, _) => Self {
                doing: "Taking two light cones where the data have one",
                it_does: "It takes two light cones where the data have one",
                reason: "The samples are made as if both eyes received the same events.",
            },
        }
    }
}

fn bias_note(neglect: &Neglect, bias: &Result<[f64; 3], String>, length: Unit) -> String {
    let by = |value: f64| signed(length.shown(value), length.decimals(2)) + &length.suffix();
    match bias {
        Ok([beta, y, z]) => format!(
            "{} biases it, even without noise: β by {}, y by {}, z by {}.",
            neglect.doing,
            signed(*beta, 3),
            by(*y),
            by(*z)
        ),
        Err(problem) => format!("{}. Even without noise: {problem}.", neglect.it_does),
    }
}

/// An error's words as a sentence.
fn sentence(words: &str) -> String {
    capitalised(words) + "."
}
