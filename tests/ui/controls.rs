//! Speed, separation, path, geometry and light.

use eframe::egui::accesskit::{Action, ActionData, ActionRequest, Role};
use eframe::egui::{Event, Key, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{By, NodeT as _, Queryable as _};
use gamow::app::commands::SettingsCommand;
use gamow::app::shell::App;
use gamow::app::shell::persistence::Keeper;
use gamow::app::state::State;
use gamow::settings::{PlotSettings, PlotTab, Settings};
use relativity_core::{Aperture, Sighting, Speed, equidistance_time, sighting};
use relativity_render::{Colour, Geometry, Shading};

use super::Test;
use super::support::{
    cyclist, drag, label_starting_with, seen, shown, slider, type_into, wide_window, window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    assistive_technology_reads_values_and_what_the_views_show,
    the_first_window_has_few_controls_and_a_button_for_all,
    dragging_beta_changes_the_readout_in_the_same_frame,
    marks_below_the_slider_set_the_speed_they_name,
    typed_gamma_and_rapidity_are_kept_exactly,
    a_decimal_comma_may_be_typed_wherever_a_number_is,
    a_bad_speed_is_explained_and_the_old_one_kept,
    the_readout_is_what_the_core_computes,
    separation_and_path_follow_their_fields,
    one_light_cone_for_both_eyes_is_one_click_away,
    each_effect_changes_the_picture,
    settings_survive_saving_and_loading,
    a_slider_is_set_by_an_aid_to_what_may_be_typed_at_most,
];

fn a_slider_is_set_by_an_aid_to_what_may_be_typed_at_most() {
    let mut window = window_of_size(cyclist(0.5), [1280.0, 1600.0], 1.0);
    for (name, value) in
        [("Separation d", 1e300), ("Distance y", -1e300), ("Head tilted", 1e300), ("Field of view", 1e300)]
    {
        window.get_by_role_and_label(Role::Slider, name).set_value_accesskit(value);
        window.run();
        let state = window.state().state();
        let read = Settings::default().with_toml(&state.shown().to_toml(), "settings");
        assert_eq!(read.expect("they can be read"), state.shown(), "{name} set to {value}");
    }
}

fn dragging_beta_changes_the_readout_in_the_same_frame() {
    let mut window = window(cyclist(0.5));
    let rail = slider(&window, "Speed β");
    let start = window.state().state().document.settings.motion.speed.slider_position();
    let x = |position: f64| rail.min.x + 8.0 + (rail.width() - 16.0) * position as f32;
    window.hover_at(pos2(x(start), rail.center().y));
    window.step();
    window.drag_at(pos2(x(start), rail.center().y));
    window.step();
    window.hover_at(pos2(x(0.6), rail.center().y));
    window.step();
    let state = window.state().state();
    let beta = state.speed().beta();
    assert!(beta > 0.98 && beta < 0.999, "beta = {beta}");
    let doppler = shown(&window, "Left eye, Doppler factor D");
    let expected = seen(beta, state.document.time, 0).doppler_factor;
    assert!((doppler - expected).abs() < 6e-5, "{doppler} for {expected}");
}

fn marks_below_the_slider_set_the_speed_they_name() {
    let mut window = window(cyclist(0.5));
    for (name, beta) in [("Set β to 0.99", 0.99), ("Set β to 0", 0.0), ("Set β to 0.9999", 0.9999)] {
        window.get_by_label(name).click();
        window.run();
        assert_eq!(window.state().state().speed().beta(), beta);
    }
    window.get_by_label("β = 0.999\u{2009}9");
}

fn typed_gamma_and_rapidity_are_kept_exactly() {
    let mut window = window(cyclist(0.9));
    type_into(&mut window, "Gamma, typed", "1e12");
    let speed = window.state().state().speed();
    assert_eq!(speed, Speed::from_gamma(1e12).expect("a speed"));
    window.get_by_label("β = 1 − 5.00e−25");
    type_into(&mut window, "Rapidity, typed", "2.5");
    assert_eq!(window.state().state().speed(), Speed::from_rapidity(2.5).expect("a speed"));
    type_into(&mut window, "Beta, typed", "0.123456789012345");
    assert_eq!(window.state().state().speed().beta(), 0.123_456_789_012_345);
}

fn a_decimal_comma_may_be_typed_wherever_a_number_is() {
    let mut window = window(cyclist(0.9));
    type_into(&mut window, "Beta, typed", "0,75");
    type_into(&mut window, "T, typed", "2,25");
    type_into(&mut window, "Separation d, typed", "0,5");
    type_into(&mut window, "Distance y, typed", "4,5");
    let state = window.state().state();
    assert_eq!(
        (state.speed().beta(), state.document.time, state.document.settings.motion.d),
        (0.75, 2.25, 0.5)
    );
    assert_eq!(state.document.settings.motion.depth_shift, 1.5);
    window
        .state_mut()
        .run(SettingsCommand::Plots(PlotSettings { plot: PlotTab::Fit, ..PlotSettings::default() }));
    window.run();
    type_into(&mut window, "Noise", "2,5");
    assert_eq!(window.state().state().document.settings.fit.noise_percent, 2.5);
}

fn a_bad_speed_is_explained_and_the_old_one_kept() {
    let mut window = window(cyclist(0.9));
    for (field, text, message) in [
        ("Gamma, typed", "0.5", "gamma = 0.5 is out of range: it must be between 1 and 1e30"),
        ("Beta, typed", "1", "beta = 1 is out of range: it must be at least 0 and below 1"),
        ("Beta, typed", "fast", "“fast” is not a number"),
    ] {
        type_into(&mut window, field, text);
        window.get_by_label(message);
        assert_eq!(window.state().state().speed().beta(), 0.9);
    }
    type_into(&mut window, "Beta, typed", "0.8");
    assert!(window.query_by_label("“fast” is not a number").is_none());
}

fn the_readout_is_what_the_core_computes() {
    for beta in [0.0, 0.3, 0.9, 0.999] {
        let state = cyclist(beta);
        let time = state.document.time;
        let window = window(state);
        for (eye, name) in ["Left eye", "Right eye"].into_iter().enumerate() {
            let expected = seen(beta, time, eye);
            let rows = [
                ("Doppler factor D", expected.doppler_factor, 6e-5),
                ("Received wavelength", 700.0 / expected.doppler_factor, 0.06),
                ("received T", time, 6e-5),
                ("happened t", expected.retarded_time, 6e-5),
                ("proper time τ", proper_time(beta, &expected), 6e-5),
                ("apparent X", expected.position[0], 6e-5),
                ("azimuth φ", expected.phi(), 6e-6),
                ("elevation θ", expected.theta(), 6e-6),
            ];
            for (quantity, value, rounding) in rows {
                let shown = shown(&window, &format!("{name}, {quantity}"));
                assert!((shown - value).abs() < rounding, "{name}, {quantity}: {shown} for {value}");
            }
        }
        let dphi = seen(beta, time, 0).phi() - seen(beta, time, 1).phi();
        assert!((shown(&window, "Disparity Δφ") - dphi).abs() < 6e-6);
        let dtheta = seen(beta, time, 0).theta() - seen(beta, time, 1).theta();
        assert!((shown(&window, "Disparity Δθ") - dtheta).abs() < 6e-6);
    }
}

/// What a clock at rest at (0, 3, 2) of what moves shows as it sends what is seen: gamma (t - beta x), there
/// gamma (1 - beta^2) t.
fn proper_time(beta: f64, seen: &Sighting) -> f64 {
    seen.retarded_time * (1.0 - beta * beta).sqrt()
}

fn separation_and_path_follow_their_fields() {
    let mut window = window(cyclist(0.9));
    let separation = slider(&window, "Separation d");
    drag(&mut window, separation.left_center() + [10.0, 0.0].into(), separation.center());
    let separation = window.state().state().document.settings.motion.d;
    assert!((separation - 1.0).abs() < 0.1, "d = {separation}");

    let distance = slider(&window, "Distance y");
    drag(&mut window, distance.left_center() + [20.0, 0.0].into(), distance.center());
    let state = window.state().state();
    let depth = state.document.settings.motion.depth_shift + 3.0;
    assert!((depth - 10.0).abs() < 0.7, "y = {depth}");
    let time = state.equidistance_time(state.document.points.selected()).expect("it moves");
    let expected = (separation / 2.0).hypot(depth).hypot(2.0);
    assert!((time - expected).abs() < 1e-12 * expected, "T0 = {time} for {expected}");
    let apparent = shown(&window, "Left eye, apparent Y");
    assert!((apparent - depth).abs() < 6e-5);

    let speed = Speed::from_beta(0.9).expect("a speed");
    let of_core = equidistance_time(&speed, state.selected_source(), Aperture::pair(separation))
        .expect("in the domain");
    assert_eq!(of_core, Some(time));
}

fn one_light_cone_for_both_eyes_is_one_click_away() {
    let mut state = cyclist(0.9);
    state.document.settings.motion.d = 1.0;
    let mut window = window_of_size(state, [1280.0, 1100.0], 1.0);
    let picture = |window: &mut Harness<'_, App>| {
        window.remove_cursor();
        window.run();
        window.render().expect("a picture").into_raw()
    };
    let two = picture(&mut window);
    let exact = shown(&window, "Disparity Δφ");
    window.get_by_label("One cone").click();
    window.run();
    assert_eq!(window.state().state().document.settings.look.geometry, Geometry::OneCone);
    assert!(picture(&mut window) != two);
    label_starting_with(&window, "As if both eyes received the same events");
    // The light that the middle receives, in one place, from two sides.
    let state = window.state().state();
    let middle = sighting(&state.speed(), state.selected_source(), Aperture::default(), state.document.time)
        .expect("in the domain");
    for (eye, half) in [("Left eye", 0.5), ("Right eye", -0.5)] {
        let x = shown(&window, &format!("{eye}, apparent X"));
        assert!((x - (middle.position[0] + half)).abs() < 6e-5, "{x}");
        let doppler = shown(&window, &format!("{eye}, Doppler factor D"));
        assert!((doppler - middle.doppler_factor).abs() < 6e-5, "{doppler}");
    }
    let [x, y, _] = middle.position;
    let parallax = y.atan2(x + 0.5) - y.atan2(x - 0.5);
    let dphi = shown(&window, "Disparity Δφ");
    assert!((dphi - parallax).abs() < 6e-6 && (dphi - exact).abs() > 0.01, "{dphi} for {parallax}, {exact}");
    window.get_by_label("Exact").click();
    window.run();
    assert_eq!(window.state().state().document.settings.look.geometry, Geometry::Seen);
}

fn each_effect_changes_the_picture() {
    // High enough that every control is in view.
    let mut window = window_of_size(cyclist(0.9), [1280.0, 1660.0], 1.0);
    let mut last = window.render().expect("a picture").into_raw();
    for effect in ["As at rest", "Off", "False", "Plain", "Sky", "Contracted", "At rest"] {
        window.get_by_label(effect).click();
        window.run();
        window.remove_cursor();
        window.run();
        let picture = window.render().expect("a picture").into_raw();
        assert!(picture != last, "{effect} changes nothing");
        last = picture;
    }
    let state = window.state().state();
    let light = state.document.settings.light;
    assert_eq!(light.colour, Colour::False);
    assert_eq!((light.doppler_shift, light.intensity_exponent.0, light.sky), (false, None, false));
    assert_eq!((light.shading, state.document.settings.look.geometry), (Shading::Emission, Geometry::Rest));
    label_starting_with(&window, "Plot of Δφ of front tyre");
    window.key_press(Key::Num1);
    window.run();
    assert_eq!(window.state().state().document.settings.look.geometry, Geometry::Seen);
}

fn settings_survive_saving_and_loading() {
    let mut window = wide_window(cyclist(0.9));
    type_into(&mut window, "Gamma, typed", "1e12");
    for choice in ["D³ photons", "False", "Published", "Angles", "Contracted", "Fixed", "Theme"] {
        window.get_by_role_and_label(Role::Button, choice).click();
        window.run();
    }
    let folder = tempfile::tempdir().expect("a folder");
    Keeper::in_folder(folder.path()).keep(window.state().state()).expect("it is written");
    let loaded = Keeper::in_folder(folder.path()).load().settings;
    assert_eq!(loaded, window.state().state().shown());
    assert_ne!(loaded, *cyclist(0.9).document.settings);
}

/// Returns the labels of all that can be clicked, dragged or typed into, besides plots, views, borders and
/// titles.
pub fn controls(window: &Harness<'_, App>) -> Vec<String> {
    let is_control = |role: Role| {
        matches!(
            role,
            Role::Button
                | Role::CheckBox
                | Role::ComboBox
                | Role::DisclosureTriangle
                | Role::RadioButton
                | Role::Slider
                | Role::SpinButton
                | Role::TextInput
        )
    };
    let nodes = window.query_all(By::new().recursive(true)).map(|node| node.accesskit_node());
    nodes.filter(|node| is_control(node.role())).map(|node| node.label().unwrap_or_default()).collect()
}

fn the_first_window_has_few_controls_and_a_button_for_all() {
    let folder = tempfile::tempdir().expect("a folder");
    let keeper = || Keeper::in_folder(folder.path());
    let opened = || super::support::window(State::open(keeper().load().settings).expect("a preset"));
    let mut window = opened();
    let few = controls(&window);
    assert!(few.len() <= 20, "{}: {few:?}", few.len());
    for name in ["Speed β", "Separation d", "Observation time T", "Play", "More controls"] {
        assert!(few.iter().any(|control| control == name), "{name}: {few:?}");
    }
    // A point is clicked, and its disparity is plotted and told.
    window.get_by_label_contains("Plot of Δφ");
    assert!(window.query_by_label_contains("Plot of Δθ").is_none());
    keeper().load().memory.restore_in(&window.ctx, false);
    window.get_by_label("More controls").click();
    window.run();
    // Sections are folded but for the first, and open one by one: the last first, so that each is in sight.
    let more = controls(&window);
    assert!(more.len() <= 75 && !more.iter().any(|name| name == "Contracted"), "{}: {more:?}", more.len());
    for (title, of_it) in [("Light", "Daylight"), ("Two eyes", "Head tilted"), ("Look", "Contracted")] {
        assert!(!controls(&window).iter().any(|name| name == of_it), "{of_it}");
        window.get_by_role_and_label(Role::DisclosureTriangle, title).click();
        window.run();
        assert!(controls(&window).iter().any(|name| name == of_it), "{of_it}");
    }
    assert!(controls(&window).len() > 100);
    window.get_by_label_contains("Plot of Δθ");
    // What one opens stays open.
    keeper().keep(window.state().state()).expect("it is written");
    assert!(!keeper().load().settings.window.simple);
    assert!(controls(&opened()).len() > 100);
}

fn assistive_technology_reads_values_and_what_the_views_show() {
    let mut window = super::support::window(super::support::cyclist(0.9));
    assert_eq!(window.root().accesskit_node().label().as_deref(), Some("Gamow"));
    let speed = window.get_by_role_and_label(Role::Slider, "Speed β").accesskit_node();
    assert_eq!((speed.value().as_deref(), speed.numeric_value()), (Some("0.900"), Some(0.9)));
    let sentence = window.state().state().moment().sentence();
    for eye in ["Left eye view", "Right eye view"] {
        let view = window.get_by_label(eye).accesskit_node();
        assert_eq!(view.description().as_deref(), Some(sentence.as_str()));
    }
    let (target_node, target_tree) = speed.locate();
    let data = Some(ActionData::NumericValue(0.123));
    let request = ActionRequest { action: Action::SetValue, target_tree, target_node, data };
    window.event(Event::AccessKitActionRequest(request));
    window.run_steps(2);
    assert_eq!(window.state().state().speed().beta(), 0.123);
}
