//! The command that fits readings as a window, or a search for what is wrong with them, does.

use relativity_core::{Curves, FitOptions, Loss, Model, Passage, Rolling};

use crate::flags::words::Shell;

/// The command that fits a file with these options.
#[must_use]
pub fn command(file: &str, options: &FitOptions) -> String {
    let FitOptions { model, curves, passage, rolling, loss } = *options;
    let passage = match passage {
        Passage::Fitted => " --fit-x0".to_owned(),
        Passage::Known(0.0) => String::new(),
        Passage::Known(x0) => format!(" --x0={x0}"),
    };
    let model = if model == Model::default() { String::new() } else { format!(" --model {}", model.name()) };
    let used = if curves == Curves::Both { String::new() } else { format!(" --use {}", curves.name()) };
    let wheel = rolling.map_or_else(String::new, |Rolling { radius, rho, angle }| {
        format!(" --wheel-radius {radius} --rho {rho} --angle={angle}")
    });
    let file = if file == "-" { file.to_owned() } else { Shell::here().file(file) };
    format!("gamow fit {file}{passage}{model}{used}{wheel}{}", loss_flags(loss))
}

/// The flags for a robust loss, a blank before each; none for the linear one.
fn loss_flags(loss: Loss) -> String {
    let scale =
        if loss == Loss::of(loss.shape) { String::new() } else { format!(" --loss-scale {}", loss.scale) };
    if loss.is_robust() { format!(" --loss {}{scale}", loss.shape.name()) } else { String::new() }
}
