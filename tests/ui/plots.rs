//! The plots against T: words and units, zoom, cursors, pinned curves, what is told at the pointer, and the
//! same as files.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Rect, TouchPhase, Vec2, pos2, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::SettingsCommand;
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::plots::curves::PUBLISHED;
use gamow::app::state::plots::look::{MAX_PINS, PlotCommand, Ranges};
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::quantity::Quantity;
use gamow::settings::{Coordinates, PlotSettings, PlotTab};
use gamow::units::Units;
use relativity_core::{Aperture, Disparity, Model, SourcePoint, Speed};
use relativity_render::Geometry;

use super::Test;
use super::support::{
    SEPARATION, TRACKED, cyclist, drag, label_starting_with, labels, seen, shown, window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    a_plot_says_in_words_and_units_what_it_is_of,
    the_plots_as_files_hold_what_the_core_says,
    the_plots_as_files_have_the_units_that_are_shown,
    the_plots_as_files_are_whole_at_the_extremes,
    the_disparity_has_a_choice_of_coordinates,
    a_constant_is_a_line_in_the_middle,
    scrolling_in_a_plot_zooms_about_the_pointer_and_a_double_click_resets,
    a_drag_with_the_right_button_moves_a_plot_and_leaves_T,
    a_plot_tells_the_values_at_the_pointer_anywhere,
    two_cursors_tell_the_difference_and_the_slope,
    pinned_curves_stay_while_the_speed_changes,
    as_many_curves_are_pinned_as_there_are_dashes,
    the_published_value_stands_beside_the_exact_one,
    several_points_have_a_legend_that_fits,
];

const DPHI: &str = "Plot of Δφ of front tyre against T";

fn at_speed(state: &mut State, beta: f64) {
    let mut motion = state.document.settings.motion;
    motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).expect("a speed");
    state.run(SettingsCommand::Motion(motion));
}

/// What the core says of the tracked point.
fn disparity(model: Model, beta: f64, time: f64) -> Disparity {
    let speed = Speed::from_beta(beta).expect("a speed");
    let point = SourcePoint::from_rest(TRACKED, &speed);
    model.disparity(&speed, point, Aperture::pair(SEPARATION), time).expect("in the domain")
}

fn showing(plot: PlotTab, beta: f64) -> Harness<'static, App> {
    let mut state = cyclist(beta);
    state.document.settings.plots.plot = plot;
    window(state)
}

/// The head of a CSV, and its rows; none where a cell is empty.
fn table(text: &str) -> (Vec<String>, Vec<Vec<Option<f64>>>) {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head = reader.headers().expect("a head").iter().map(str::to_owned).collect();
    let number = |cell: &str| (!cell.is_empty()).then(|| cell.parse().expect("a number"));
    let rows = reader.records().map(|row| row.expect("a row").iter().map(number).collect());
    (head, rows.collect())
}

fn a_plot_says_in_words_and_units_what_it_is_of() {
    for (plot, headings) in [
        (PlotTab::Disparity, ["Δφ, left − right / 10⁻³ rad", "Δθ, left − right / 10⁻³ rad"]),
        (PlotTab::Angles, ["azimuth φ / rad", "elevation θ / rad"]),
        (PlotTab::Stereo, ["stereo gain", "distance / units"]),
        (PlotTab::Doppler, ["Doppler factor D"; 2]),
    ] {
        let mut window = showing(plot, 0.9);
        let found = labels(&window);
        for heading in headings {
            assert!(found.iter().any(|label| label == heading), "{heading}: {found:?}");
        }
        let svg = window.state_mut().plots_svg();
        for text in headings.into_iter().chain(["observation time T / units", "T₀, seen abreast"]) {
            assert!(svg.contains(&format!(">{text}<")), "{text}: {svg}");
        }
    }
}

fn the_plots_as_files_hold_what_the_core_says() {
    let mut window = showing(PlotTab::Disparity, 0.9);
    window.get_by_role_and_label(Role::CheckBox, "Published").click();
    window.run();
    let (head, rows) = table(&window.state_mut().plots_csv());
    assert_eq!(
        head,
        [
            "T / units",
            "Δφ / rad: front tyre",
            "Δφ / rad: front tyre, published",
            "Δθ / rad: front tyre",
            "Δθ / rad: front tyre, published",
            "T",
            "d",
            "dphi",
            "dtheta",
        ]
    );
    assert!(rows.len() > 100 && rows.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    for row in &rows {
        let numbers: Vec<f64> = row.iter().map(|cell| cell.expect("everywhere there")).collect();
        let [exact, published] = [Model::Exact, PUBLISHED].map(|model| disparity(model, 0.9, numbers[0]));
        assert_eq!(numbers[1..5], [exact.dphi, published.dphi, exact.dtheta, published.dtheta]);
        assert_eq!(numbers[5..], [numbers[0], SEPARATION, exact.dphi, exact.dtheta]);
    }
    // The drawing has the same curve: its lowest place is where the table has its least value.
    let svg = window.state_mut().plots_svg();
    let lines: Vec<Vec<Pos2>> = svg.split("<polyline").skip(1).map(polyline).collect();
    let drawn = &lines[0];
    let lowest = drawn.iter().max_by(|a, b| a.y.total_cmp(&b.y)).expect("points");
    let share = (lowest.x - drawn[0].x) / (drawn[drawn.len() - 1].x - drawn[0].x);
    let least = rows.iter().min_by(|a, b| a[1].partial_cmp(&b[1]).expect("numbers")).expect("rows");
    let time = |row: &Vec<Option<f64>>| row[0].expect("T");
    let expected = (time(least) - time(&rows[0])) / (time(&rows[rows.len() - 1]) - time(&rows[0]));
    assert!((f64::from(share) - expected).abs() < 0.01, "{share} for {expected}");
}

/// The places of a line, pixels.
fn polyline(text: &str) -> Vec<Pos2> {
    let points = text.split("points=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("points");
    let number = |text: &str| text.parse::<f32>().expect("a number");
    let place = |pair: &str| pair.split_once(',').map(|(x, y)| pos2(number(x), number(y))).expect("a pair");
    points.split_whitespace().map(place).collect()
}

fn the_plots_as_files_have_the_units_that_are_shown() {
    let mut state = cyclist(0.9);
    state.document.settings.window.units = Units::Metric;
    state.document.settings.plots.plot = PlotTab::Stereo;
    let mut window = window(state);
    let (head, rows) = table(&window.state_mut().plots_csv());
    assert_eq!(head[0], "T / ns");
    assert_eq!(head[3], "distance / m: Where the left eye sees it");
    let time = window.state().state().measures().time;
    for row in rows.iter().step_by(50) {
        let seen = seen(0.9, time.in_scene(row[0].expect("T")), 0);
        let distance = row[3].expect("a distance");
        assert!((distance / (0.65 * seen.distance) - 1.0).abs() < 1e-9, "{row:?}");
    }
    let svg = window.state_mut().plots_svg();
    assert!(svg.contains(">observation time T / ns<") && svg.contains(">distance / m<"));
}

fn the_plots_as_files_are_whole_at_the_extremes() {
    for (beta, d, geometry) in [
        (0.0, 0.1, Geometry::Seen),
        (0.9, 0.0, Geometry::OneCone),
        (0.999_999_999_999, 0.1, Geometry::OneCone),
        (1e-9, 1000.0, Geometry::Seen),
    ] {
        let mut state = cyclist(beta);
        state.document.settings.motion.d = d;
        state.document.settings.look.geometry = geometry;
        state.run(PlotCommand::Pin);
        state.run(PlotCommand::Cursor(None));
        let mut window = window(state);
        let tabs = [PlotTab::Disparity, PlotTab::Angles, PlotTab::Doppler, PlotTab::Stereo];
        let tabs = tabs.map(|plot| PlotSettings { plot, published: true, ..PlotSettings::default() });
        let conformal = PlotSettings { coordinates: Coordinates::Conformal, ..tabs[0] };
        for plots in tabs.into_iter().chain([conformal]) {
            window.state_mut().run(SettingsCommand::Plots(plots));
            window.run();
            let texts = [window.state_mut().plots_svg(), window.state_mut().plots_csv()];
            for text in texts.into_iter().chain(labels(&window)) {
                let mut words = text.split(|letter: char| !letter.is_alphabetic());
                assert!(words.all(|word| word != "NaN" && word != "inf"), "{beta} {d} {plots:?}: {text}");
            }
        }
    }
}

fn the_disparity_has_a_choice_of_coordinates() {
    let mut window = showing(PlotTab::Disparity, 0.9);
    window.get_by_role_and_label(Role::ComboBox, "Coordinates of the disparities").click();
    window.run();
    window.get_by_label("u and v (conformal)").click();
    window.run();
    assert_eq!(window.state().state().document.settings.plots.coordinates, Coordinates::Conformal);
    let (head, rows) = table(&window.state_mut().plots_csv());
    assert_eq!(head, ["T / units", "Δu: front tyre", "Δu: at rest, eyes γd apart", "Δv / rad: front tyre"]);
    let speed = Speed::from_beta(0.9).expect("a speed");
    let point = SourcePoint::from_rest(TRACKED, &speed);
    let rho = point.y.hypot(point.z);
    assert!(rows.len() > 100);
    for row in &rows {
        let numbers: Vec<f64> = row.iter().map(|cell| cell.expect("everywhere there")).collect();
        let u = |eye: f64| (speed.gamma() * (point.x0 + 0.9 * numbers[0] - eye) / rho).asinh();
        let expected = u(-0.5 * SEPARATION) - u(0.5 * SEPARATION);
        assert!(
            (numbers[1] - expected).abs() < 1e-14 && (numbers[2] - expected).abs() < 1e-14,
            "{numbers:?}"
        );
        assert_eq!(numbers[3], 0.0);
    }
    let svg = window.state_mut().plots_svg();
    assert!(svg.contains(">Δu, left − right / 10⁻³<") && svg.contains(">at rest, eyes γd apart<"), "{svg}");
    let command = window.state().state().curve_command().expect("a command");
    assert!(command.contains(" --conformal "), "{command}");
}

fn a_constant_is_a_line_in_the_middle() {
    let mut window = showing(PlotTab::Disparity, 0.0);
    let svg = window.state_mut().plots_svg();
    let frames: Vec<[f32; 2]> = svg
        .split("<rect x=\"")
        .filter_map(|text| text.split('>').next())
        .filter(|frame| frame.contains("fill=\"none\""))
        .map(|text| {
            let number = |name: &str| -> f32 {
                let rest = text.split(&format!(" {name}=\"")).nth(1).expect("an attribute");
                rest.split('"').next().expect("a value").parse().expect("a number")
            };
            [number("y"), number("height")]
        })
        .collect();
    let lines: Vec<Vec<Pos2>> =
        svg.split("<polyline").skip(1).map(polyline).filter(|line| line.len() > 2).collect();
    assert_eq!((frames.len(), lines.len()), (2, 2));
    for (line, [top, height]) in lines.iter().zip(frames) {
        for place in line {
            let share = (place.y - top) / height;
            assert!((0.25..0.75).contains(&share) && (place.y - line[0].y).abs() < 0.02, "{share}");
        }
    }
}

fn scroll(window: &mut Harness<'_, App>, at: Pos2, lines: f32) {
    window.hover_at(at);
    window.step();
    window.event(Event::MouseWheel {
        source: eframe::egui::MouseWheelSource::Wheel,
        unit: MouseWheelUnit::Line,
        delta: vec2(0.0, lines),
        phase: TouchPhase::Move,
        modifiers: Modifiers::default(),
    });
    window.run();
}

fn zoom(window: &Harness<'_, App>) -> Option<Ranges> {
    window.state().state().scratch.plotting.zoom(Quantity::DeltaPhi)
}

fn plot(window: &Harness<'_, App>) -> Rect {
    window.get_by_label(DPHI).rect()
}

/// T that is told at the pointer.
fn pointed_time(window: &Harness<'_, App>) -> f64 {
    let text = label_starting_with(window, "T = ");
    text.trim_start_matches("T = ").replace('−', "-").parse().expect("a number")
}

fn scrolling_in_a_plot_zooms_about_the_pointer_and_a_double_click_resets() {
    let mut window = showing(PlotTab::Disparity, 0.9);
    let place = plot(&window).center() + vec2(20.0, -10.0);
    window.hover_at(place);
    window.run();
    let before = pointed_time(&window);
    let [from, to] = window.state().state().plotted_times(Quantity::DeltaPhi);
    for _ in 0..3 {
        scroll(&mut window, place, 1.0);
    }
    let zoomed = zoom(&window).expect("a part");
    assert!(zoomed.times[1] - zoomed.times[0] < 0.5 * (to - from), "{zoomed:?}");
    assert!((pointed_time(&window) - before).abs() < 0.01 * (to - from));
    // The curves are sampled over the part.
    let (_, rows) = table(&window.state_mut().plots_csv());
    let times = rows.iter().filter_map(|row| row[0]);
    assert!(times.filter(|time| (zoomed.times[0]..=zoomed.times[1]).contains(time)).count() > 60);
    scroll(&mut window, place, -1.0);
    assert!(
        zoom(&window)
            .is_some_and(|wider| wider.times[1] - wider.times[0] > zoomed.times[1] - zoomed.times[0])
    );
    for _ in 0..2 {
        window.drag_at(place);
        window.drop_at(place);
    }
    window.run();
    assert_eq!(zoom(&window), None);
    // Out of the whole there is nothing more to see.
    scroll(&mut window, place, -1.0);
    assert_eq!(zoom(&window), None);
}

#[expect(non_snake_case, reason = "T is the time of reception; t is another")]
fn a_drag_with_the_right_button_moves_a_plot_and_leaves_T() {
    let mut window = showing(PlotTab::Disparity, 0.9);
    let time = window.state().state().document.time;
    let place = plot(&window).center();
    let before = window.state().state().plotted_times(Quantity::DeltaPhi);
    window.hover_at(place);
    window.step();
    let button = |pos: Pos2, pressed: bool| Event::PointerButton {
        pos,
        button: PointerButton::Secondary,
        pressed,
        modifiers: Modifiers::default(),
    };
    window.event(button(place, true));
    for i in 1..=4 {
        window.hover_at(place + Vec2::new(-10.0 * i as f32, 5.0));
        window.step();
    }
    window.event(button(place + vec2(-40.0, 5.0), false));
    window.run();
    let moved = zoom(&window).expect("a part").times;
    assert!(moved[0] > before[0] && ((moved[1] - moved[0]) / (before[1] - before[0]) - 1.0).abs() < 1e-9);
    assert_eq!(window.state().state().document.time, time);
    window.get_by_label("Whole plots").click();
    window.run();
    assert_eq!(zoom(&window), None);
    drag(&mut window, place, place + vec2(30.0, 0.0));
    assert!(zoom(&window).is_none() && window.state().state().document.time != time);
}

fn a_plot_tells_the_values_at_the_pointer_anywhere() {
    let mut window = showing(PlotTab::Disparity, 0.9);
    let frame = plot(&window);
    for share in [0.3, 0.5, 0.9] {
        // Near the top, where no curve is.
        window.hover_at(pos2(frame.min.x + share * frame.width(), frame.min.y + 30.0));
        window.run();
        let (time, told) = (pointed_time(&window), value_told(&window, "front tyre: Δφ = "));
        // T is told as precisely as there are pixels.
        let off = [-0.05, 0.0, 0.05].map(|off| disparity(Model::Exact, 0.9, time + off).dphi);
        let [low, high] =
            [off.iter().copied().fold(f64::MAX, f64::min), off.iter().copied().fold(f64::MIN, f64::max)];
        assert!((low - 1e-4..=high + 1e-4).contains(&told), "T = {time}: {told} in {low}, {high}");
    }
}

fn value_told(window: &Harness<'_, App>, name: &str) -> f64 {
    let text = label_starting_with(window, name);
    let number = text.split(" = ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a value");
    number.replace('−', "-").parse().expect("a number")
}

fn two_cursors_tell_the_difference_and_the_slope() {
    let mut window = showing(PlotTab::Disparity, 0.9);
    let legend = |window: &Harness<'_, App>| {
        labels(window).into_iter().find(|label| label.starts_with("Legend of Δφ: "))
    };
    let frame = plot(&window);
    assert_eq!(legend(&window), None);
    let click = |window: &mut Harness<'_, App>, share: f32| {
        let place = pos2(frame.min.x + share * frame.width(), frame.center().y);
        window.hover_at(place);
        window.step();
        for pressed in [true, false] {
            let (button, modifiers) = (PointerButton::Primary, Modifiers::SHIFT);
            window
                .event_modifiers(Event::PointerButton { pos: place, button, pressed, modifiers }, modifiers);
            window.step();
        }
        window.run();
    };
    let time = window.state().state().document.time;
    click(&mut window, 0.4);
    let &[a] = window.state().state().scratch.plotting.cursors.as_slice() else { panic!("one cursor") };
    assert!(legend(&window).is_some_and(|text| text.contains("A: T = ")));
    click(&mut window, 0.7);
    let &[_, b] = window.state().state().scratch.plotting.cursors.as_slice() else { panic!("two cursors") };
    assert_eq!(window.state().state().document.time, time, "a cursor is not T");
    let text = legend(&window).expect("a legend");
    let value = |name: &str| -> f64 {
        let rest = text.split(name).nth(1).unwrap_or_else(|| panic!("{name} in {text}"));
        let number = rest.split([' ', ',', ';']).next().expect("a number");
        number.replace('−', "-").parse().unwrap_or_else(|_| panic!("{name} in {text}"))
    };
    let [first, second] = [a, b].map(|time| disparity(Model::Exact, 0.9, time).dphi);
    assert!((value("ΔT = ") - (b - a)).abs() < 0.1, "{text}");
    assert!((value("Δ = ") - (second - first)).abs() < 6e-3 * (second - first).abs(), "{text}");
    let slope = (second - first) / (b - a);
    assert!((value("slope = ") - slope).abs() < 6e-3 * slope.abs(), "{text}");
    assert!(window.state_mut().plots_svg().contains(">B<"));
    click(&mut window, 0.5);
    assert!(window.state().state().scratch.plotting.cursors.is_empty() && legend(&window).is_none());
    window.key_press(Key::C);
    window.run();
    assert_eq!(window.state().state().scratch.plotting.cursors, [time]);
    window.get_by_label("Cursor B").click();
    window.run();
    window.get_by_label("No cursors").click();
    window.run();
    assert!(window.state().state().scratch.plotting.cursors.is_empty());
}

fn pinned_curves_stay_while_the_speed_changes() {
    let mut window = showing(PlotTab::Disparity, 0.9);
    for beta in [0.7, 0.5] {
        window.get_by_label("Pin").click();
        window.run();
        let mut motion = window.state().state().document.settings.motion;
        motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).expect("a speed");
        window.state_mut().run(SettingsCommand::Motion(motion));
        window.run();
    }
    let legend = label_starting_with(&window, "Legend of Δφ: ");
    for name in ["β 0.9", "β 0.7", "β 0.5"] {
        assert!(legend.contains(name), "{legend}");
    }
    let (head, rows) = table(&window.state_mut().plots_csv());
    let names = ["β 0.9", "β 0.7", "front tyre, β 0.5"];
    assert_eq!(head[1..4], names.map(|name| format!("Δφ / rad: {name}")));
    for row in rows.iter().step_by(20) {
        let time = row[0].expect("T");
        for (column, beta) in [(1, 0.9), (2, 0.7), (3, 0.5)] {
            assert_eq!(row[column], Some(disparity(Model::Exact, beta, time).dphi), "{beta} {time}");
        }
    }
    assert!(window.state_mut().plots_svg().contains(">β 0.7<"));
    for tab in [PlotTab::Angles, PlotTab::Doppler, PlotTab::Stereo] {
        window.state_mut().run(SettingsCommand::Plots(PlotSettings { plot: tab, ..PlotSettings::default() }));
        window.run();
        assert!(window.state_mut().plots_csv().contains("β 0.9"), "{tab:?}");
    }
    window.get_by_label("Unpin all").click();
    window.run();
    assert!(window.state().state().scratch.plotting.pins.is_empty());
    assert!(window.query_by_label("Unpin all").is_none());
}

fn as_many_curves_are_pinned_as_there_are_dashes() {
    let mut state = cyclist(0.9);
    for beta in [0.1, 0.2, 0.3, 0.3, 0.4, 0.5, 0.6] {
        at_speed(&mut state, beta);
        state.run(PlotCommand::Pin);
    }
    let pins = &state.scratch.plotting.pins;
    let speeds: Vec<f64> = pins.iter().map(|pin| pin.seen.velocity.speed.beta()).collect();
    assert_eq!((speeds.as_slice(), pins.len()), ([0.3, 0.4, 0.5, 0.6].as_slice(), MAX_PINS));
    // All are in the plot, and the present one.
    let mut window = window(state);
    let (head, _) = table(&window.state_mut().plots_csv());
    assert_eq!(head.iter().filter(|name| name.starts_with("Δφ")).count(), MAX_PINS + 1);
}

fn the_published_value_stands_beside_the_exact_one() {
    let mut window = showing(PlotTab::Disparity, 0.9);
    assert!(!labels(&window).iter().any(|label| label.starts_with("Published Δφ")));
    window.get_by_role_and_label(Role::CheckBox, "Published").click();
    window.run();
    let time = window.state().state().document.time;
    for (name, model) in [("Exact", Model::Exact), ("Published", PUBLISHED)] {
        let expected = disparity(model, 0.9, time);
        for (symbol, value) in [("Δφ", expected.dphi), ("Δθ", expected.dtheta)] {
            let told = shown(&window, &format!("{name} {symbol} at T"));
            assert!((told - value).abs() < 6e-6, "{name} {symbol}: {told} for {value}");
        }
    }
}

fn several_points_have_a_legend_that_fits() {
    for size in [[1280.0, 800.0], [800.0, 600.0], [1920.0, 1080.0]] {
        let mut state = cyclist(0.9);
        let mut point = state.document.points.selected().track;
        for (i, body) in [2, 5].into_iter().enumerate() {
            point.rest[0] += 0.5 + i as f64;
            state.document.points.choose(point, body, true);
        }
        let names: Vec<String> =
            state.document.points.all().iter().map(|point| state.name_of(point)).collect();
        let window = window_of_size(state, size, 1.0);
        let legend = label_starting_with(&window, "Legend of Δφ: ");
        for name in &names {
            assert!(legend.contains(name), "{size:?}: {legend}");
        }
        let place = window.get_by_label(&legend).rect();
        let plot = window.get_by_label_contains(&format!("Plot of Δφ of {}", names[2])).rect();
        assert!(plot.contains_rect(place), "{size:?}: {place:?} in {plot:?}");
    }
}
