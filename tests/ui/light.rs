//! The Light tab: the spectrum of the selected point, against Doppler factors of the core.

use egui_kittest::Harness;
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::settings::PlotTab;
use relativity_render::Colour;

use super::Test;
use super::support::{cyclist, labels, seen, window};

pub const TESTS: &[Test] = trials![
    the_light_tab_slides_a_spectrum_by_the_doppler_factor_of_each_eye,
    what_moves_in_the_streets_daylight_is_emitted_as_it_is_lit,
    light_of_one_wavelength_is_a_line_at_the_wavelengths_of_the_core,
    false_colours_have_no_spectrum,
];

const BETA: f64 = 0.6;

fn showing(colour: Colour) -> State {
    let mut state = cyclist(BETA);
    state.document.settings.light.colour = colour;
    state.document.settings.plots.plot = PlotTab::Light;
    state
}

fn assert_label(window: &Harness<'_, App>, beginning: &str) {
    let found = labels(window);
    assert!(found.iter().any(|label| label.starts_with(beginning)), "{beginning}: {found:?}");
}

/// Head and rows of a table.
fn table(text: &str) -> (String, Vec<Vec<f64>>) {
    let (head, rows) = text.split_once('\n').expect("a head");
    let row = |row: &str| row.split(',').map(|cell| cell.parse().expect("a number")).collect();
    (head.to_owned(), rows.lines().map(row).collect())
}

/// The value of this column at `nm`, between rows.
fn at(rows: &[Vec<f64>], column: usize, nm: f64) -> f64 {
    let next = rows.partition_point(|row| row[0] < nm).clamp(1, rows.len() - 1);
    let (low, high) = (&rows[next - 1], &rows[next]);
    low[column] + (high[column] - low[column]) * (nm - low[0]) / (high[0] - low[0])
}

/// The sum of this column between two wavelengths, nm.
fn sum(rows: &[Vec<f64>], column: usize, [from, to]: [f64; 2]) -> f64 {
    let steps = 4000;
    let nm = |step: i32| from + (to - from) * (f64::from(step) + 0.5) / f64::from(steps);
    (0..steps).map(|step| at(rows, column, nm(step))).sum::<f64>() * (to - from) / f64::from(steps)
}

fn the_light_tab_slides_a_spectrum_by_the_doppler_factor_of_each_eye() {
    let mut window = window(showing(Colour::White));
    let time = window.state().state().document.time;
    let (head, rows) = table(&window.state_mut().plots_csv());
    assert_eq!(head, "wavelength / nm,emitted,left eye,right eye");
    for (eye, name) in ["Left eye", "Right eye"].into_iter().enumerate() {
        let factor = seen(BETA, time, eye).doppler_factor;
        assert_label(&window, &format!("{name}: D = {factor:.3}, D⁵ = "));
        // Light of all wavelengths is D^4 times as bright, as its intensity over the fourth power of its
        // frequency is the same for all observers.
        let received = sum(&rows, 2 + eye, [400.0, 700.0]);
        let emitted = sum(&rows, 1, [400.0 * factor, 700.0 * factor]) * factor.powi(4);
        assert!((received / emitted - 1.0).abs() < 0.01, "{received} {emitted}");
    }
    let svg = window.state_mut().plots_svg();
    assert!(svg.contains(">wavelength / nm<") && svg.contains("Spectrum of front tyre"), "{svg}");
}

fn what_moves_in_the_streets_daylight_is_emitted_as_it_is_lit() {
    let mut window = window(showing(Colour::StreetDaylight));
    let time = window.state().state().document.time;
    let (head, rows) = table(&window.state_mut().plots_csv());
    assert_eq!(head, "wavelength / nm,emitted at rest,emitted,left eye,right eye");
    assert_label(&window, "Emitted: lit with D = ");
    let [at_rest, emitted] = [1, 2].map(|column| sum(&rows, column, [400.0, 700.0]));
    assert!((emitted / at_rest - 1.0).abs() > 0.05, "{emitted} {at_rest}");
    for eye in [0, 1] {
        let factor = seen(BETA, time, eye).doppler_factor;
        let received = sum(&rows, 3 + eye, [400.0, 700.0]);
        let emitted = sum(&rows, 2, [400.0 * factor, 700.0 * factor]) * factor.powi(4);
        assert!((received / emitted - 1.0).abs() < 0.01, "{received} {emitted}");
    }
}

fn light_of_one_wavelength_is_a_line_at_the_wavelengths_of_the_core() {
    let mut window = window(showing(Colour::OneWavelength));
    let time = window.state().state().document.time;
    let (head, rows) = table(&window.state_mut().plots_csv());
    assert_eq!(head, "emitted / nm,left eye / nm,right eye / nm");
    let [emitted, left, right] = rows[0][..] else { panic!("three columns: {rows:?}") };
    for (eye, found) in [left, right].into_iter().enumerate() {
        let expected = emitted / seen(BETA, time, eye).doppler_factor;
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
}

fn false_colours_have_no_spectrum() {
    let mut window = window(showing(Colour::False));
    assert_label(&window, "False colours show Doppler factors");
    assert!(window.state_mut().plots_svg().contains("Spectrum of"));
}
