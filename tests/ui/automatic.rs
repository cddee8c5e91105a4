//! Automatic quality in the window: what it says, what it is told, and pictures that get smoother while
//! nothing changes.

use std::time::Duration;

use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{Command, PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::eye::Eye;
use gamow::flags::choices::RendererChoice;
use gamow::flags::{BUDGET_MS, ERROR_PX, Goal};

use super::support::{
    assert_sane, builder, cyclist, label_starting_with, labels, pane, repaint_delay, rest, settle, type_into,
    wait_for, wait_for_rest, window_of_size,
};
use super::{Test, device};

pub const TESTS: &[Test] = trials![
    a_still_view_gets_as_smooth_as_the_reference_and_then_costs_nothing,
    what_changes_is_drawn_plainly_at_once,
    what_was_chosen_and_why_is_said,
    a_goal_that_cannot_be_is_refused,
    what_a_gpu_in_software_draws_is_whole_at_rest,
];

/// A small window whose pictures may get smoother.
fn refined_window() -> Harness<'static, App> {
    window(|app| app)
}

/// A small window, changed so when it is made.
fn window(changed: fn(App) -> App) -> Harness<'static, App> {
    let mut state = cyclist(0.6);
    (state.document.settings.window.dials, state.document.settings.window.ruler) = (false, false);
    let mut harness = builder([800.0, 600.0])
        .renderer(device::renderer())
        .build_eframe(|cc| changed(App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state)));
    harness.run_steps(3);
    harness
}

/// Frames until pictures are as smooth as they get.
fn refine(window: &mut Harness<'_, App>) {
    wait_for(window, "it is smooth", |window| window.state().is_refined());
    window.run();
}

/// Height of the notes at the bottom of a pane, pixels.
const NOTE: u32 = 40;

/// The mean difference of a level in the left pane to the reference with `samples` times `samples` rays per
/// pixel, and the share of pixels that differ by more than 2 levels.
fn differences(window: &mut Harness<'_, App>, samples: u32) -> [f64; 2] {
    let pane = pane(window, 0);
    let size = [pane.width() as u32, pane.height() as u32];
    let state = window.state().state();
    let view = state.view(Eye::Left, size);
    let reference = state.document.prepared.picture(&view, &state.appearance(true), samples);
    let shown = window.render().expect("a picture");
    let (mut sum, mut differing) = (0, 0);
    let compared = size[0] * (size[1] - NOTE);
    for (i, expected) in (0..compared).zip(&reference.rgba) {
        let (u, v) = (i % size[0], i / size[0]);
        let found = shown.get_pixel(pane.min.x as u32 + u, pane.min.y as u32 + v).0;
        let off: u32 = (0..3).map(|part| u32::from(found[part].abs_diff(expected[part]))).max().unwrap_or(0);
        sum += off;
        differing += u32::from(off > 2);
    }
    [f64::from(sum), f64::from(differing)].map(|sum| sum / f64::from(compared))
}

fn a_still_view_gets_as_smooth_as_the_reference_and_then_costs_nothing() {
    let mut window = refined_window();
    assert!(!window.state().is_refined());
    let [_, plain] = differences(&mut window, 8);
    refine(&mut window);
    let [_, smooth] = differences(&mut window, 8);
    println!("{smooth} of the pixels differ; before {plain}");
    // The marker and the hint cover the rest.
    assert!(smooth < 0.5 * plain && smooth < 0.02, "{smooth} of the pixels differ; before {plain}");
    rest(&mut window);
    wait_for_rest(&mut window);
    // What was made is kept: the next frame makes nothing.
    window.step();
    assert!(window.state().is_refined());
    assert_eq!(repaint_delay(&window), Duration::MAX);
}

fn what_changes_is_drawn_plainly_at_once() {
    let mut window = refined_window();
    refine(&mut window);
    window.state_mut().run(PlaybackCommand::GoTo(2.0));
    window.step();
    assert!(!window.state().is_refined());
    let [changed, _] = differences(&mut window, 8);
    assert!(changed < 3.0, "it is a picture of the new time: {changed}");
    let mut quality = window.state().state().document.settings.quality;
    quality.refine = false;
    window.state_mut().run(SettingsCommand::Quality(quality));
    window.step();
    assert!(window.state().is_refined(), "nothing is begun");
    let before = differences(&mut window, 8);
    std::thread::sleep(Duration::from_millis(300));
    window.run();
    assert_eq!(differences(&mut window, 8), before);
    // The mesh's errors are to be seen.
    quality.refine = true;
    quality.renderer = RendererChoice::Mesh;
    window.state_mut().run(SettingsCommand::Quality(quality));
    window.run();
    assert!(window.state().is_refined());
}

fn what_was_chosen_and_why_is_said() {
    let mut window = window_of_size(cyclist(0.9), [1280.0, 1000.0], 1.0);
    assert!(label_starting_with(&window, "Chosen: ").ends_with(", within 0.002 px"));
    for (goal, end) in [
        (Goal::Error(1e-4), ", exact"),
        (Goal::Budget(0.01), "; no method keeps 0.01 ms"),
        (Goal::Error(0.05), ", within 0.002 px"),
    ] {
        let mut quality = window.state().state().document.settings.quality;
        quality.goal = goal;
        window.state_mut().run(SettingsCommand::Quality(quality));
        window.run_steps(3);
        let said = label_starting_with(&window, "Chosen: ");
        assert!(said.ends_with(end), "{goal:?}: {said}");
    }
    window.get_by_label("Rays").click();
    window.run();
    assert_eq!(window.state().state().document.settings.quality.renderer, RendererChoice::Rays);
    assert!(!labels(&window).iter().any(|label| label.starts_with("Chosen: ")));
    window.get_by_label("Automatic").click();
    window.run();
    assert!(label_starting_with(&window, "Chosen: ").ends_with(", within 0.002 px"));
    // One undoes the other.
    window.state_mut().run(Command::Undo);
    window.run();
    assert_eq!(window.state().state().document.settings.quality.renderer, RendererChoice::Rays);
}

/// What is no number changes nothing; what is out of range becomes the nearest that is inside.
fn a_goal_that_cannot_be_is_refused() {
    let mut window = window_of_size(cyclist(0.9), [1280.0, 1300.0], 1.0);
    let goal = |window: &Harness<'_, App>| window.state().state().document.settings.quality.goal;
    for (text, expected) in [
        ("0.25", 0.25),
        ("nan", 0.25),
        ("px", 0.25),
        ("inf", 0.25),
        ("0,5", 0.5),
        ("-1", *ERROR_PX.start()),
        ("1e300", *ERROR_PX.end()),
        ("0", *ERROR_PX.start()),
    ] {
        type_into(&mut window, "Error bound, typed", text);
        assert_eq!(goal(&window), Goal::Error(expected), "{text}");
        assert_sane(window.state().state());
    }
    window.get_by_label("Max time").click();
    window.run();
    assert_eq!(goal(&window), Goal::Budget(Goal::USUAL_BUDGET_MS));
    for (text, expected) in
        [("nan", 16.0), ("40", 40.0), ("0", *BUDGET_MS.start()), ("1e300", *BUDGET_MS.end())]
    {
        type_into(&mut window, "Frame budget, typed", text);
        assert_eq!(goal(&window), Goal::Budget(expected), "{text}");
    }
    assert_sane(window.state().state());
    assert!(label_starting_with(&window, "Chosen: ").contains("exact"));
}

fn what_a_gpu_in_software_draws_is_whole_at_rest() {
    let at_rest = |mut window: Harness<'_, App>| {
        let mut quality = window.state().state().document.settings.quality;
        quality.renderer = RendererChoice::Mesh;
        window.state_mut().run(SettingsCommand::Quality(quality));
        for time in [0.5, 1.0] {
            window.state_mut().run(PlaybackCommand::GoTo(time));
            window.step();
        }
        settle(&mut window);
        assert!(!labels(&window).iter().any(|label| label.contains("coarse")));
        differences(&mut window, 1)
    };
    assert_eq!(at_rest(refined_window()), at_rest(window(App::without_refinement)));
}
