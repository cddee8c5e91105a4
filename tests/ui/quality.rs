//! The choice of what draws the views, and the Accuracy tab: what each costs, and how far it is off.

use std::sync::OnceLock;

use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::views::examination::Examination;
use gamow::eye::Eye;
use gamow::flags::choices::RendererChoice;
use gamow::settings::{PlotSettings, PlotTab};
use relativity_render::Method;

use super::Test;
use super::support::{
    cyclist, labels, pane, rest, settle, type_into, wait_for_rest, wide_window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    the_reference_draws_the_views_if_chosen,
    the_accuracy_tab_measures_every_renderer,
    the_accuracy_tab_begins_with_what_its_figures_come_to,
    figures_are_of_the_views_that_are_shown,
    hidden_figures_are_not_measured,
    clicking_a_renderer_in_the_table_or_the_plot_chooses_it,
    the_heat_map_marks_what_the_mesh_gets_wrong,
];

/// The default scene at this beta, with the Accuracy tab in view.
fn examined(beta: f64) -> State {
    let mut state = cyclist(beta);
    state.run(SettingsCommand::Plots(PlotSettings { plot: PlotTab::Accuracy, ..PlotSettings::default() }));
    state
}

/// A window whose small views are measured soon.
fn small_window(state: State) -> Harness<'static, App> {
    window_of_size(state, [800.0, 600.0], 1.0)
}

/// Height of the note at the bottom of a pane, pixels.
const NOTE: u32 = 32;

/// Share of the pixels of the left eye's pane, above the note, for which `differs` is true of the red, green
/// and blue in the window and in the reference's picture.
fn share_in_pane(window: &mut Harness<'_, App>, differs: fn([u8; 3], [u8; 3]) -> bool) -> f64 {
    let pane = pane(window, 0);
    let size = [pane.width() as u32, pane.height() as u32];
    let state = window.state().state();
    let view = state.view(Eye::Left, size);
    let reference = state.document.prepared.picture(&view, &state.appearance(true), 2);
    let shown = window.render().expect("a picture");
    let compared = size[0] * (size[1] - NOTE);
    let differing = (0..compared).filter(|i| {
        let (u, v) = (i % size[0], i / size[0]);
        let [r, g, b, _] = shown.get_pixel(pane.min.x as u32 + u, pane.min.y as u32 + v).0;
        let [red, green, blue, _] = reference.rgba[*i as usize];
        differs([r, g, b], [red, green, blue])
    });
    differing.count() as f64 / f64::from(compared)
}

fn the_reference_draws_the_views_if_chosen() {
    let mut state = cyclist(0.6);
    (state.document.settings.window.dials, state.document.settings.window.ruler) = (false, false);
    // High enough that the choice is in sight.
    let mut window = window_of_size(state, [1280.0, 1000.0], 1.0);
    let any =
        |shown: [u8; 3], reference: [u8; 3]| shown.into_iter().zip(reference).any(|(a, b)| a.abs_diff(b) > 2);
    settle(&mut window);
    // Sampled elsewhere inside the pixels of outlines.
    let exact = share_in_pane(&mut window, any);
    window.get_by_label("Reference").click();
    window.run_steps(2);
    settle(&mut window);
    // The marker covers the rest.
    let reference = share_in_pane(&mut window, any);
    assert!(
        reference < 0.01 && reference < 0.7 * exact,
        "{reference} of the pixels differ, of exact {exact}"
    );
    rest(&mut window);
    wait_for_rest(&mut window);
    // While something moves, the rays stand in.
    window.state_mut().run(PlaybackCommand::GoTo(2.0));
    window.step();
    assert!(!window.state().is_settled());
    let stand_in = share_in_pane(&mut window, any);
    window.get_by_label("Rays").click();
    window.run();
    assert_eq!(stand_in, share_in_pane(&mut window, any));
}

/// The contents of the Accuracy tab of the default scene at beta 0.9, once everything is measured.
struct Measured {
    labels: Vec<String>,
    csv: String,
}

/// Measured once for all tests that only read it.
fn measured() -> &'static Measured {
    static MEASURED: OnceLock<Measured> = OnceLock::new();
    MEASURED.get_or_init(|| {
        let mut window = small_window(cyclist(0.9));
        window.get_by_label("Accuracy").click();
        window.run_steps(2);
        settle(&mut window);
        wait_for_rest(&mut window);
        Measured { labels: labels(&window), csv: window.state_mut().plots_csv() }
    })
}

/// The number in the table of the Accuracy tab, in a window with these labels.
fn figure(all: &[String], renderer: &str, column: &str) -> f64 {
    let start = format!("{renderer}, {column}: ");
    let text = all.iter().find_map(|label| label.strip_prefix(&start));
    let text = text.unwrap_or_else(|| panic!("no {start:?} in {all:?}"));
    let text = text.trim_start_matches("< ").trim_end_matches(" %").replace('−', "-");
    text.parse().unwrap_or_else(|_| panic!("{text:?} is a number"))
}

/// The sentence is of the figures in the table: the cheapest, and what is not worth its time.
fn the_accuracy_tab_begins_with_what_its_figures_come_to() {
    let Measured { labels: all, csv, .. } = measured();
    let sentence = all.iter().find(|label| label.contains("cheapest here")).expect("a sentence");
    let renderers = ["rays", "packets", "reference"];
    let ms = |renderer: &&str| figure(all, renderer, "ms");
    let cheapest = renderers.iter().min_by(|a, b| ms(a).total_cmp(&ms(b))).expect("some");
    assert!(sentence.to_lowercase().starts_with(&format!("{cheapest}: error ")), "{sentence}");
    assert!(sentence.contains("the reference has none, in "), "{sentence}");
    assert_eq!(csv.lines().count(), 1 + renderers.len(), "{csv}");
}

fn the_accuracy_tab_measures_every_renderer() {
    let Measured { labels: all, .. } = measured();
    for renderer in ["rays", "packets", "reference"] {
        assert!(figure(all, renderer, "ms") > 0.0, "{renderer}");
    }
    assert!(figure(all, "rays", "outlines / px") <= 0.05);
    let direction = |renderer| figure(all, renderer, "direction / ″");
    assert!(direction("reference") < 1e-6 && direction("rays") < 1.0);
    assert!(figure(all, "rays", "D") < 1e-5);
    assert!(figure(all, "rays", "other body") < 0.1);
    assert_eq!(figure(all, "reference", "other body"), 0.0);
}

fn current(window: &Harness<'_, App>) -> usize {
    let examination = window.state().examination().expect("it is shown");
    examination.rows().filter(|row| row.is_current).count()
}

fn figures_are_of_the_views_that_are_shown() {
    let mut window = small_window(examined(0.9));
    settle(&mut window);
    let figures = |window: &Harness<'_, App>| {
        ["direction / ″", "D"].map(|column| figure(&labels(window), "rays", column))
    };
    let slow = figures(&window);
    assert_eq!(current(&window), 3);
    type_into(&mut window, "Gamma, typed", "1000");
    assert!(!window.state().is_settled());
    assert!(current(&window) < 3, "what was measured before counts as outdated");
    settle(&mut window);
    assert_eq!(current(&window), 3);
    assert!(figures(&window) != slow);
    window.get_by_label("Views").click();
    window.run();
    window.get_by_label("There is nothing to measure: the views are hidden.");
    assert!(window.state().is_settled());
}

fn hidden_figures_are_not_measured() {
    let is_pending =
        |window: &Harness<'_, App>| window.state().examination().is_some_and(Examination::is_pending);
    let mut window = small_window(examined(0.9));
    assert!(is_pending(&window));
    for (hide, show) in [("Disparity", "Accuracy"), ("Plots", "Plots")] {
        window.get_by_label(hide).click();
        window.run();
        assert!(!is_pending(&window));
        window.get_by_label(show).click();
        window.run();
        assert!(is_pending(&window));
    }
}

fn clicking_a_renderer_in_the_table_or_the_plot_chooses_it() {
    // Large enough for the plot beside the table.
    let mut window = window_of_size(examined(0.9), [1000.0, 720.0], 1.0);
    settle(&mut window);
    window.get_by_label("packets").click();
    window.run();
    assert_eq!(window.state().state().document.settings.quality.method(), Some(Method::Packets));
    settle(&mut window);
    // The mesh is a row where it draws.
    let mut quality = window.state().state().document.settings.quality;
    quality.renderer = RendererChoice::Mesh;
    window.state_mut().run(SettingsCommand::Quality(quality));
    settle(&mut window);
    let outlines_px = figure(&labels(&window), "mesh", "outlines / px");
    assert!(outlines_px > 0.0 && outlines_px <= Method::MESH_ERROR_PX, "{outlines_px} px");
    let plot = window.get_by_label("Plot of error against cost").rect();
    // The reference has by far the least error.
    let near_reference = [0.5, 0.55, 0.6, 0.45, 0.4, 0.65, 0.7, 0.75, 0.35, 0.8]
        .map(|x| plot.min + eframe::egui::vec2(x * plot.width(), 0.92 * plot.height()));
    for place in near_reference {
        window.hover_at(place);
        window.step();
        window.drag_at(place);
        window.drop_at(place);
        window.run_steps(2);
    }
    assert_eq!(window.state().state().document.settings.quality.renderer, RendererChoice::Reference);
}

fn the_heat_map_marks_what_the_mesh_gets_wrong() {
    let mut state = examined(0.9);
    state.document.settings.quality.renderer = RendererChoice::Mesh;
    // Without the ruler the lower tag is within the note, which is not compared.
    state.document.settings.window.ruler = false;
    let mut window = wide_window(state);
    settle(&mut window);
    let red = |[r, g, b]: [u8; 3], _: [u8; 3]| r == 0xFF && g == 0x38 && b == 0x60;
    let darker = |shown: [u8; 3], reference: [u8; 3]| {
        shown.into_iter().zip(reference).all(|(a, b)| u32::from(a) < u32::from(b) / 2)
    };
    assert_eq!(
        [share_in_pane(&mut window, red), share_in_pane(&mut window, darker)].map(|share| share < 0.05),
        [true; 2]
    );
    window.get_by_label("Heat map").click();
    window.run();
    assert!(share_in_pane(&mut window, red) > 1e-4);
    assert!(share_in_pane(&mut window, darker) > 0.5, "what surrounds the scene is dimmed");
    window.get_by_label("rays").click();
    window.run();
    assert!(share_in_pane(&mut window, red) < 1e-4);
    window.get_by_label("Plots").click();
    window.run();
    assert!(share_in_pane(&mut window, darker) < 0.05, "without its scale there is no map");
}
