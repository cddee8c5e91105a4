//! What the fit says: each parameter with its uncertainty beside the truth, and a verdict.

use eframe::egui::{Grid, RichText, Ui};
use relativity_core::{DEFAULT_REPLICATES, Model, Parameter};

use crate::app::fitting::{FitOutcome, Fitted, Fitting};
use crate::app::widgets::named_text;
use crate::caption::capitalised;
use crate::estimate::{Estimate, decimals};
use crate::figures;
use crate::units::Unit;

/// Estimates further off than this many standard errors are not chance.
const CHANCE: f64 = 3.0;
/// Below this share of a parameter its uncertainty is rounding, and no measure of anything.
const ROUNDING: f64 = 1e-10;

/// Shows the newest outcome, its lengths in this unit, faintly if it is outdated.
pub fn show(ui: &mut Ui, fitting: &Fitting, length: Unit) {
    ui.spacing_mut().item_spacing.y = 4.0;
    let Some(outcome) = fitting.shown() else {
        ui.label(RichText::new("Fitting …").weak());
        return;
    };
    if fitting.is_outdated() {
        ui.multiply_opacity(0.5);
    }
    match &outcome.fitted {
        Ok(fitted) => {
            table(ui, fitted, length);
            ui.label(RichText::new(verdict(fitted)).strong());
            notes(ui, outcome, fitted);
        }
        Err(problem) => {
            ui.label(RichText::new("No fit").strong());
            ui.label(sentence(problem));
        }
    }
    if let Some(bias) = &outcome.bias {
        let neglect = Neglect::of(outcome.key.setup.model);
        let tip = format!("The same fit to samples without noise, minus the truth.\n{}", neglect.reason);
        ui.label(bias_note(&neglect, bias, length)).on_hover_text(tip);
    }
}

fn table(ui: &mut Ui, fitted: &Fitted, length: Unit) {
    Grid::new("fit").num_columns(6).spacing([6.0, 3.0]).min_col_width(12.0).show(ui, |ui| {
        let heads = [
            ("", "Parameter"),
            ("value", "The best fit: least sum of squared residuals."),
            ("±", "Standard error: standard deviation over the bootstrap's replicates, refits of samples drawn with replacement."),
            ("95 %", "Interval that holds 95 % of the replicates: from the 2.5th to the 97.5th percentile."),
            ("truth", "What the samples were made with."),
            ("off", "(value − truth) / standard error"),
        ];
        for (head, tip) in heads {
            ui.label(RichText::new(head).weak()).on_hover_text(tip);
        }
        ui.end_row();
        for (parameter, estimate, truth) in &fitted.estimates {
            let unit = if *parameter == Parameter::Beta { Unit::OWN } else { length };
            row(ui, *parameter, unit, &shown(estimate, unit), unit.shown(*truth));
        }
    });
}

/// `estimate` in this unit.
fn shown(estimate: &Estimate, unit: Unit) -> Estimate {
    Estimate {
        value: unit.shown(estimate.value),
        uncertainty: unit.shown(estimate.uncertainty),
        ci95: estimate.ci95.map(|end| unit.shown(end)),
        uncertainty_linear: unit.shown(estimate.uncertainty_linear),
    }
}

/// An estimate and the truth, both in this unit.
fn row(ui: &mut Ui, parameter: Parameter, unit: Unit, estimate: &Estimate, truth: f64) {
    let (symbol, tip) = named(parameter);
    let Estimate { value, uncertainty, ci95: [low, high], .. } = *estimate;
    let places = decimals(uncertainty) as u8;
    let number = |value| figures::fixed(value, places);
    ui.label(unit.label(symbol)).on_hover_text(tip);
    let value_text = RichText::new(number(value)).strong();
    named_text(ui, value_text, format!("Fitted {symbol}: {}", number(value)));
    named_text(ui, number(uncertainty), format!("Uncertainty of {symbol}: {}", number(uncertainty)));
    let interval = format!("{} … {}", number(low), number(high));
    named_text(ui, interval.as_str(), format!("95 % interval of {symbol}: {interval}"));
    let truth_text = figures::trimmed(truth, 4);
    named_text(ui, truth_text.as_str(), format!("True {symbol}: {truth_text}"));
    let off = off(estimate, truth);
    named_text(ui, off.as_str(), format!("{symbol} off by {off}"));
    ui.end_row();
}

/// Symbol and meaning.
fn named(parameter: Parameter) -> (&'static str, &'static str) {
    match parameter {
        Parameter::Beta => ("β", "Speed over c."),
        Parameter::Y => ("y", "Distance in front of the eyes."),
        Parameter::Z => ("z", "Height above the eyes."),
        Parameter::X0 => ("x₀", "Where the point is at t = 0, along the motion."),
    }
}

fn is_rounding(estimate: &Estimate, truth: f64) -> bool {
    estimate.uncertainty <= ROUNDING * truth.abs().max(ROUNDING)
}

fn deviation(estimate: &Estimate, truth: f64) -> f64 {
    (estimate.value - truth) / estimate.uncertainty
}

/// How far off an estimate is: in standard errors, or by how much if those mean nothing.
fn off(estimate: &Estimate, truth: f64) -> String {
    if is_rounding(estimate, truth) {
        return signed(estimate.value - truth, 9);
    }
    format!("{}σ", signed(deviation(estimate, truth), 1))
}

fn signed(value: f64, decimals: u8) -> String {
    let sign = if value > 0.0 { "+" } else { "" };
    format!("{sign}{}", figures::fixed(value, decimals))
}

fn verdict(fitted: &Fitted) -> String {
    let uncertain = fitted.estimates.iter().filter(|(_, estimate, truth)| !is_rounding(estimate, *truth));
    let deviations =
        uncertain.map(|(parameter, estimate, truth)| (*parameter, deviation(estimate, *truth).abs()));
    let Some((parameter, worst)) = deviations.max_by(|a, b| a.1.total_cmp(&b.1)) else {
        let errors = fitted.estimates.iter().map(|(_, estimate, truth)| (estimate.value - truth).abs());
        return format!("Recovered to {}.", figures::fixed(errors.fold(0.0, f64::max), 9));
    };
    let errors = figures::fixed(worst, 1);
    if worst <= CHANCE {
        return format!("Agrees with the truth: at most {errors} σ off.");
    }
    format!("Wrong: {} is {errors} σ off.", named(parameter).0)
}

fn notes(ui: &mut Ui, outcome: &FitOutcome, fitted: &Fitted) {
    let milliseconds = figures::fixed(1e3 * outcome.elapsed.as_secs_f64(), 0);
    let rms = figures::significant(fitted.rms, 3).replace('-', "−");
    let uncertainties = match &fitted.no_bootstrap {
        None => format!("{DEFAULT_REPLICATES} replicates"),
        Some(_) => "no bootstrap".to_owned(),
    };
    let text = format!("rms {rms} rad  ·  {} readings  ·  {uncertainties}", fitted.readings);
    // The time is no part of the picture: the same state is drawn the same.
    let tip = format!("Root mean square of sample minus fit. Fit and bootstrap took {milliseconds} ms.");
    ui.label(RichText::new(text).weak().small()).on_hover_text(tip);
    if let Some(problem) = &fitted.no_bootstrap {
        ui.label(RichText::new(format!("± by linearisation: {problem}.")).small());
    }
}

/// What a fit by a model that did not make the data leaves out.
struct Neglect {
    doing: &'static str,
    it_does: &'static str,
    reason: &'static str,
}

impl Neglect {
    const fn of(model: Model) -> Self {
        match model {
            Model::Published(_) => Self {
                doing: "Leaving out parallax",
                it_does: "It leaves out parallax",
                reason: "The published model measures both angles from the left eye; what the eyes see has parallax.",
            },
            Model::OneCone => Self {
                doing: "Taking one light cone for both eyes",
                it_does: "It takes one light cone for both eyes",
                reason: "Each eye receives events of its own: as far as the curves differ by that, it is taken for distance \
                    and speed.",
            },
            Model::Exact => Self {
                doing: "Taking two light cones where the views show one",
                it_does: "It takes two light cones where the views show one",
                reason: "The samples are those of the views: as if both eyes received the same events.",
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
