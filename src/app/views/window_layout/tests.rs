//! Layouts of windows of every size: parts stay apart, inside, and large enough.

use eframe::egui::pos2;

use super::*;
use crate::app::state::stage::SidePanel;
use crate::settings::Settings;

fn layout(width: f32, height: f32) -> WindowLayout {
    sized([width, height], WindowSettings::default())
}

#[test]
fn the_smallest_supported_window_holds_every_part_but_the_wavelengths() {
    let layout = layout(800.0, 600.0);
    assert_eq!(layout.panes.len(), 2);
    assert!(layout.spectrum.is_none() && layout.sentence.is_some());
    // Pictures of nearly 4:3; what is left of the height goes to the plots, which have to be read.
    for pane in &layout.panes {
        assert!(pane.rect.width() >= 225.0 && pane.rect.height() >= 165.0, "{pane:?}");
    }
    for (part, least) in [(layout.controls, 300.0), (layout.readout, 200.0), (layout.plots, 210.0)] {
        let part = part.expect("shown");
        assert!(part.width() >= 320.0 && part.height() >= least, "{part:?}");
    }
    let taller = sized([1024.0, 700.0], WindowSettings::default());
    assert!(taller.spectrum.is_some() && taller.sentence.is_some());
}

/// Returns the share of the window's height that the pictures have, and the height of the plots.
fn shares(size: [f32; 2], window: WindowSettings) -> (f32, f32) {
    let layout = sized(size, window);
    assert_apart(&parts(&layout), size);
    let lowest = layout.panes.iter().map(|pane| pane.rect.height()).fold(f32::INFINITY, f32::min);
    (lowest / size[1], layout.plots.expect("shown").height())
}

#[test]
fn pictures_have_half_of_the_height_with_few_controls_and_with_all() {
    for (size, plots) in [
        ([1280.0, 800.0], 130.0),
        ([1366.0, 768.0], 130.0),
        ([1920.0, 1080.0], 200.0),
        ([1024.0, 600.0], 130.0),
    ] {
        let (few, below) = shares(size, WindowSettings::default().with_few(true));
        assert!(few >= 0.5 && below >= plots, "{size:?}: {few} {below}");
        let (all, below) = shares(size, WindowSettings::default());
        // Who has asked for all controls in a low window reads plots: two rows of tabs and a plot of 75
        // points below them leave a quarter to the pictures.
        let least = if size[1] < 700.0 { 0.25 } else { 0.5 };
        assert!(all >= least && below >= 140.0, "{size:?}: {all} {below}");
    }
}

#[test]
fn among_few_controls_the_map_stands_below_them_and_the_plots_have_the_strip() {
    let few = WindowSettings::default().with_few(true);
    for size in [[1024.0, 600.0], [1280.0, 800.0], [1920.0, 1080.0]] {
        let layout = sized(size, few);
        let [controls, map, readout] =
            [layout.controls, layout.map, layout.readout].map(|part| part.expect("shown"));
        assert!(controls.max.y <= map.min.y && map.max.y <= readout.min.y, "{size:?}");
        assert!(map.width() > 300.0 && map.height() > 170.0, "{size:?} {map:?}");
        assert!(layout.plots.expect("shown").max.x <= controls.min.x, "{size:?}");
        let hidden = sized(size, WindowSettings { map: Presence::Off, ..few });
        assert_eq!((hidden.map, hidden.plots), (None, layout.plots), "{size:?}");
    }
}

#[test]
fn pictures_give_way_to_a_fit_and_to_a_map_that_is_asked_for() {
    let area = Rect::from_min_size(pos2(0.0, 0.0), vec2(1280.0, 800.0));
    for window in [WindowSettings::default(), WindowSettings::default().with_few(true)] {
        let fit = layout_of(area, window, PlotTab::Fit).plots.expect("shown");
        assert!(fit.height() >= 290.0, "{fit:?}");
    }
    let map = WindowSettings { map: Presence::On, ..WindowSettings::default() };
    assert!(sized([1280.0, 800.0], map).map.is_some_and(|map| map.height() >= 270.0));
}

fn layout_of(area: Rect, window: WindowSettings, tab: PlotTab) -> WindowLayout {
    let settings = Settings { window, ..Settings::default() };
    let arranged = Arrangement::new(&settings, 2.54 / 96.0, 1.0);
    WindowLayout::new(area, LessonPart::Nothing, window, &arranged, tab)
}

fn sized(size: [f32; 2], window: WindowSettings) -> WindowLayout {
    layout_of(Rect::from_min_size(pos2(0.0, 0.0), size.into()), window, PlotTab::Disparity)
}

#[test]
fn the_map_stands_beside_the_plots_where_there_is_room_and_leaves_the_views_as_large() {
    for size in [[1920.0, 1080.0], [3840.0, 2160.0]] {
        let with_map = sized(size, WindowSettings::default());
        let without = sized(size, WindowSettings { map: Presence::Off, ..WindowSettings::default() });
        let (map, plots) = (with_map.map.expect("shown"), with_map.plots.expect("shown"));
        assert!(map.width() >= 380.0 && map.height() >= 270.0 && plots.width() >= 530.0, "{size:?}");
        assert_eq!((with_map.panes, without.map), (without.panes, None));
    }
}

#[test]
fn the_fit_keeps_its_plots_unless_the_map_is_asked_for() {
    let area = Rect::from_min_size(pos2(0.0, 0.0), vec2(1280.0, 800.0));
    let layout = |map| layout_of(area, WindowSettings { map, ..WindowSettings::default() }, PlotTab::Fit);
    assert!(layout(Presence::Auto).map.is_none() && layout(Presence::On).map.is_some());
}

#[test]
fn a_small_window_has_a_map_in_place_of_the_plots_when_asked() {
    let size = [1024.0, 600.0];
    let unasked = sized(size, WindowSettings::default());
    assert!(unasked.map.is_none() && unasked.plots.is_some());
    let asked = sized(size, WindowSettings { map: Presence::On, ..WindowSettings::default() });
    // The pictures give way to a map that is asked for.
    let covers = |map: Rect| unasked.plots.is_some_and(|plots| map.contains_rect(plots));
    assert!(asked.map.is_some_and(covers) && asked.plots.is_none());
}

#[test]
fn without_views_the_map_has_their_place_and_alone_all_of_it() {
    let no_views = WindowSettings { views: false, ..WindowSettings::default() };
    let with_plots = sized([800.0, 600.0], no_views);
    assert!(with_plots.map.is_some() && with_plots.plots.is_some());
    let alone = sized([800.0, 600.0], WindowSettings { plots: false, controls: false, ..no_views });
    let map = alone.map.expect("shown");
    assert!(map.width() >= 780.0 && map.height() >= 470.0, "{map:?}");
}

/// Returns the places of the parts.
fn parts(layout: &WindowLayout) -> Vec<Rect> {
    let singles = [
        layout.controls,
        layout.readout,
        layout.map,
        layout.plots,
        layout.spectrum,
        layout.sentence,
        layout.speed,
    ];
    let always = [layout.bar, layout.timeline].into_iter();
    always.chain(singles.into_iter().flatten()).chain(layout.panes.iter().map(|pane| pane.rect)).collect()
}

fn assert_apart(parts: &[Rect], size: [f32; 2]) {
    let window = Rect::from_min_size(pos2(0.0, 0.0), size.into());
    for (i, a) in parts.iter().enumerate() {
        assert!(window.expand(1e-3).contains_rect(*a), "{size:?}: {a:?}");
        for b in &parts[i + 1..] {
            let overlap = a.intersect(*b);
            assert!(overlap.width() <= 1e-3 || overlap.height() <= 1e-3, "{size:?}: {a:?} {b:?}");
        }
    }
}

const SIZES: [[f32; 2]; 10] = [
    [1.0, 1.0],
    [100.0, 50.0],
    [320.0, 480.0],
    [360.0, 740.0],
    [400.0, 300.0],
    [561.0, 321.0],
    [800.0, 600.0],
    [1024.0, 600.0],
    [1920.0, 1080.0],
    [3840.0, 2160.0],
];

#[test]
fn parts_stay_inside_the_window_and_do_not_overlap() {
    for size in SIZES {
        assert_apart(&parts(&layout(size[0], size[1])), size);
    }
}

#[test]
fn a_phone_has_views_then_speed_then_time_then_its_lesson() {
    let area = Rect::from_min_size(pos2(0.0, 0.0), vec2(360.0, 740.0));
    let settings = Settings::default();
    let arranged = Arrangement::new(&settings, 2.54 / 96.0, 1.0);
    for plots in [false, true] {
        let window = WindowSettings { plots, ..settings.window };
        let layout = WindowLayout::new(area, LessonPart::Panel, window, &arranged, PlotTab::Disparity);
        let lesson = layout.lesson.expect("shown");
        assert_eq!((lesson.width(), lesson.max.y), (360.0, 740.0));
        assert!(lesson.height() >= 300.0, "{lesson:?}");
        // Plots that a lesson switches on are what it asks about: the pictures give way to them, and show
        // all that they show without at about half the height.
        assert_eq!((layout.panes.len(), layout.plots.is_some()), (2, plots));
        let least = if plots { 0.35 } else { 0.75 };
        for pane in &layout.panes {
            assert!(pane.rect.height() >= least * pane.rect.width(), "{pane:?}");
        }
        let alone = layout.clone().with_only(area, Some(WindowPart::Pane(0)));
        for layout in [layout, alone] {
            assert_apart(&[parts(&layout), vec![lesson]].concat(), [360.0, 740.0]);
            let (speed, timeline) = (layout.speed.expect("shown"), layout.timeline);
            assert!(layout.panes.iter().all(|pane| pane.rect.max.y <= speed.min.y));
            assert!(speed.max.y <= timeline.min.y && timeline.max.y <= lesson.min.y);
            assert_eq!([speed.width(), timeline.width()], [360.0; 2]);
        }
    }
}

#[test]
fn only_a_window_without_room_for_the_controls_has_a_speed_slider_of_its_own() {
    for size in SIZES {
        let layout = sized(size, WindowSettings::default());
        assert!(layout.speed.is_none() || layout.controls.is_none(), "{size:?}");
        let is_phone = (320.0..560.0).contains(&size[0]) && size[1] >= 480.0;
        assert!(!is_phone || layout.speed.is_some() && !layout.panes.is_empty(), "{size:?}");
    }
    assert_eq!(
        sized([360.0, 740.0], WindowSettings { controls: false, ..WindowSettings::default() }).speed,
        None
    );
    // Without a lesson there is room for the plots too.
    assert!(sized([360.0, 740.0], WindowSettings::default()).plots.is_some());
}

#[test]
fn no_share_pushes_a_part_out_or_into_another() {
    let shares = [None, Some(0.0), Some(1e-9), Some(0.1), Some(0.5), Some(0.9), Some(1.0)].map(Share);
    for size in SIZES {
        for side_share in shares {
            for strip_share in shares {
                for map_share in shares {
                    let window = WindowSettings {
                        side_share,
                        strip_share,
                        map_share,
                        map: Presence::On,
                        ..WindowSettings::default()
                    };
                    let layout = sized(size, window);
                    assert_apart(&parts(&layout), size);
                    let default =
                        sized(size, WindowSettings { map: Presence::On, ..WindowSettings::default() });
                    assert!(layout.panes.is_empty() == default.panes.is_empty(), "{size:?}");
                    for border in &layout.borders {
                        assert!(border.rect.is_finite(), "{border:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_border_that_is_dragged_stands_at_the_pointer() {
    let size = [1920.0, 1080.0];
    let all = sized(size, WindowSettings::default()).borders;
    assert_eq!(
        all.iter().map(|border| border.split).collect::<Vec<_>>(),
        [BorderParts::Side, BorderParts::Strip, BorderParts::Map]
    );
    for border in all {
        let there = border.rect.center() + vec2(-40.0, 30.0);
        let dragged = sized(size, border.split.with(WindowSettings::default(), border.share_at(there)));
        let now = dragged.borders.into_iter().find(|now| now.split == border.split).expect("still there");
        let off = now.rect.center() - there;
        let off = if border.split.is_upright() { off.x } else { off.y };
        assert!(off.abs() < 1.0, "{border:?} {now:?}");
    }
}

#[test]
fn one_part_alone_has_all_between_bar_and_timeline() {
    for size in SIZES {
        let area = Rect::from_min_size(pos2(0.0, 0.0), size.into());
        for part in [
            WindowPart::Pane(0),
            WindowPart::Pane(1),
            WindowPart::Map,
            WindowPart::Plots,
            WindowPart::Pane(9),
        ] {
            let default = sized(size, WindowSettings { map: Presence::On, ..WindowSettings::default() });
            let alone = default.clone().with_only(area, Some(part));
            assert_apart(&parts(&alone), size);
            if alone == default {
                continue;
            }
            let shown = [alone.map, alone.plots]
                .into_iter()
                .flatten()
                .chain(alone.panes.iter().map(|pane| pane.rect.with_max_y(pane.rect.max.y + pane.band)));
            let [shown] = shown.collect::<Vec<_>>()[..] else { panic!("{part:?}") };
            let least = size[1] - 160.0 - alone.speed.map_or(0.0, |speed| speed.height());
            assert!(shown.width() > size[0] - 20.0 && shown.height() > least, "{size:?} {part:?}");
        }
    }
    assert_ne!(
        layout(800.0, 600.0)
            .with_only(Rect::from_min_size(Pos2::ZERO, vec2(800.0, 600.0)), Some(WindowPart::Plots)),
        layout(800.0, 600.0)
    );
}

#[test]
fn an_audience_has_all_parts_apart_and_the_picture_large_in_one_place() {
    for size in SIZES {
        let area = Rect::from_min_size(Pos2::ZERO, size.into());
        let scale = 0.03 * size[1].min(0.75 * size[0]) / 11.5;
        for has_both in [false, true] {
            let arranged = Arrangement::new(&Settings::default(), 2.54 / 96.0, scale).for_audience(has_both);
            for is_lesson in [false, true] {
                let mut heights = Vec::new();
                for panel in [SidePanel::Nothing, SidePanel::Plot, SidePanel::Map, SidePanel::Fit] {
                    let shown = Presentation::new(area, &arranged, is_lesson, panel);
                    let with_band = |pane: &Pane| pane.rect.with_max_y(pane.rect.max.y + pane.band);
                    let parts = shown.words.into_iter().chain(shown.panel);
                    let all: Vec<Rect> = parts.chain(shown.panes.iter().map(with_band)).collect();
                    assert_apart(&all, size);
                    if size[0] < 800.0 {
                        continue;
                    }
                    let words = shown.words.expect("words");
                    let counts = (shown.panes.len(), shown.panel.is_some());
                    assert_eq!(counts, (1 + usize::from(has_both), panel != SidePanel::Nothing));
                    assert!(words.width() > 0.9 * size[0] && words.height() > 0.2 * size[1], "{words:?}");
                    heights.extend(shown.panes.iter().map(|pane| pane.rect.y_range()));
                }
                assert!(heights.iter().all(|range| *range == heights[0] && range.span() >= 0.65 * size[1]));
            }
        }
    }
}
