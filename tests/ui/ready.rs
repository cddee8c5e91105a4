//! What draws is made in the background: the window goes on meanwhile, or T waits for it.

use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::Harness;
use gamow::app::commands::{Command, SettingsCommand, ShowCommand, Switch};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::flags::choices::RendererChoice;
use gamow::settings::Preset;

use super::support::{
    builder, cyclist, rest, settle, wait_for, wait_for_rest, window_of_size, window_without_pictures,
};
use super::{Test, device};

pub const TESTS: &[Test] = trials![
    packets_draw_until_the_rays_are_ready,
    t_waits_for_a_picture_that_nothing_else_draws,
    presses_of_a_clicker_show_each_preset,
    a_change_of_preset_or_layout_fades_for_a_moment_unless_nothing_is_to_move,
];

fn prepared_window(state: State) -> Harness<'static, App> {
    let mut window = builder([800.0, 600.0]).renderer(device::renderer()).build_eframe(|cc| {
        let app = App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state);
        app.without_refinement().preparing_in_background(&cc.egui_ctx)
    });
    window.step();
    window
}

fn time(window: &Harness<'_, App>) -> f64 {
    window.state().state().document.time
}

fn is_getting_ready(window: &Harness<'_, App>) -> bool {
    window.state().state().frame.is_getting_ready
}

fn packets_draw_until_the_rays_are_ready() {
    let mut state = cyclist(0.6);
    state.document.settings.quality.renderer = RendererChoice::Rays;
    let mut window = prepared_window(state);
    let start = time(&window);
    window.key_press(Key::Space);
    for _ in 0..4 {
        window.step();
        assert!(!is_getting_ready(&window), "nothing waits");
    }
    assert!(time(&window) > start, "it plays meanwhile: {} {start}", time(&window));
    window.key_press(Key::Space);
    settle(&mut window);
}

fn t_waits_for_a_picture_that_nothing_else_draws() {
    let mut state = cyclist(0.6);
    state.document.settings.quality.renderer = RendererChoice::Mesh;
    let mut window = prepared_window(state);
    settle(&mut window);
    let start = time(&window);
    // One light cone for both eyes.
    window.key_press(Key::Num4);
    window.key_press(Key::Space);
    window.run_steps(3);
    assert!(is_getting_ready(&window), "it is not made within three frames");
    wait_for(&mut window, "it is ready", |window| {
        assert!(time(window) == start || !is_getting_ready(window), "T waits");
        !is_getting_ready(window)
    });
    // The frame that was shown first has the moment that was waited with.
    assert_eq!(time(&window), start);
    assert!(window.state().state().scratch.playing, "the key that was pressed meanwhile counts");
    window.run_steps(3);
    assert!(time(&window) > start, "T goes on");
    window.key_press(Key::Space);
    settle(&mut window);
}

fn presses_of_a_clicker_show_each_preset() {
    let mut window = window_without_pictures(cyclist(0.6), [800.0, 600.0]);
    // All come in one frame, as after a long one.
    let press = |pressed| Event::Key {
        key: Key::PageDown,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    let presses = (0..3).flat_map(|_| [press(true), press(false)]);
    window.input_mut().events.extend(presses);
    let shown = |window: &Harness<'_, App>| window.state().state().document.preset.map(|preset| preset.name);
    for preset in &Preset::all()[..3] {
        window.step();
        assert_eq!(shown(&window), Some(preset.name));
    }
    window.run_steps(2);
    assert_eq!(shown(&window), Some(Preset::all()[2].name));
}

fn a_change_of_preset_or_layout_fades_for_a_moment_unless_nothing_is_to_move() {
    for animations in [true, false] {
        let mut state = cyclist(0.6);
        state.document.settings.window.animations = animations;
        let mut window = window_of_size(state, [800.0, 600.0], 1.0);
        assert!(!window.state().is_fading(), "nothing was there before");
        // A preset, and then a layout.
        for change in [Command::from(ShowCommand::Next(1)), SettingsCommand::Switch(Switch::Layout(1)).into()]
        {
            window.state_mut().run(change);
            window.step();
            assert_eq!(window.state().is_fading(), animations);
            // Frames are 1/16 s apart: of these the fourth is the first after the 200 ms of a fade.
            window.run_steps(4);
            assert!(!window.state().is_fading());
            settle(&mut window);
            rest(&mut window);
            wait_for_rest(&mut window);
        }
    }
}
