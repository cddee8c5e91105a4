//! The layout of the window: a pure function of its size, so that the parts can be run in the
//! order in which they depend on each other: controls first, then what follows them in the same frame.

pub mod border;
mod heights;
mod presentation;
mod rects;
mod side;

use eframe::egui::{Pos2, Rect, Vec2, vec2};

use self::heights::{Heights, LOWEST, StripNeeds, height_of_views};
pub use self::presentation::Presentation;
use self::rects::{large_enough, split_left, split_right, split_top};
use self::side::SideParts;
use crate::app::state::stage::WindowPart;
use crate::app::views::panes::{Arrangement, Pane, PaneContent};
use crate::app::views::window_layout::border::{Border, BorderParts};
use crate::app::widgets::theme::{GAP, TITLE_HEIGHT};
use crate::flags::Share;
use crate::settings::{PlotTab, Presence, WindowSettings};

/// The parts of the window. A part without room (or switched off) has no rectangle.
#[derive(Debug, Clone, PartialEq)]
pub struct WindowLayout {
    /// Bar with scene, theme and help.
    pub bar: Rect,
    /// The lesson that is gone through: on the left, in an upright window as narrow as a phone's at the
    /// bottom.
    pub lesson: Option<Rect>,
    /// Speed, path, view, light.
    pub controls: Option<Rect>,
    /// The numbers for each eye.
    pub readout: Option<Rect>,
    /// The views: the two eyes', and what is shown beside them.
    pub panes: Vec<Pane>,
    /// Strip of wavelengths below the views.
    pub spectrum: Option<Rect>,
    /// The moment in a sentence, below that.
    pub sentence: Option<Rect>,
    /// Speed slider of a window as narrow as a phone's, which has no room for the controls.
    pub speed: Option<Rect>,
    /// Timeline with play, pause and scrubber.
    pub timeline: Rect,
    /// The map: beside the plots, or in their place, or in that of the views.
    pub map: Option<Rect>,
    /// Plots of curves over T.
    pub plots: Option<Rect>,
    /// Borders that can be dragged to make one part larger and another smaller.
    pub borders: Vec<Border>,
}

/// The part of a lesson that is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LessonPart {
    /// No lesson is shown.
    #[default]
    Nothing,
    /// The strip of a folded panel.
    Strip,
    /// The panel with its text.
    Panel,
}

const BAR_HEIGHT: f32 = 38.0;
/// Widths of the panel of a lesson and of the strip that it is folded to, and how much of a window the panel
/// takes at most.
const LESSON_WIDTH: f32 = 308.0;
const LESSON_STRIP_WIDTH: f32 = 40.0;
const LESSON_SHARE: f32 = 0.5;
/// Height that plots or a map have above a lesson at the bottom that asks about them.
const HEIGHT_ASKED_FOR: f32 = 190.0;
/// Least share of an upright window that the panel of a lesson at its bottom leaves to the rest.
const LEAST_ABOVE_LESSON: f32 = 0.38;
/// Narrower windows than this have no room for the panel of a lesson and the controls.
const NARROWEST_WITH_LESSON_AND_CONTROLS: f32 = 1180.0;
/// Heights of the timeline: in one row, and with its scrubber below the rest.
const TIMELINE_HEIGHTS: [f32; 2] = [48.0, 76.0];
/// A narrower timeline has no room for all in one row.
const NARROWEST_ROW: f32 = 440.0;
/// Height of the speed with its slider and marks.
const SPEED_HEIGHT: f32 = 80.0;
/// Width of the controls, of which all is in sight, and the least that a share of theirs leaves to the rest.
const SIDE_WIDTH: f32 = 334.0;
const CENTRE_WIDTH: f32 = 280.0;
/// Narrower windows than this have no room for the controls beside the views.
const NARROWEST_WITH_CONTROLS: f32 = 560.0;
/// The smallest strip below the views that the map shares with the plots, and the smallest that it takes
/// unasked where there are none.
const SHARED_STRIP: Vec2 = vec2(900.0, 280.0);
const SMALLEST_MAP: Vec2 = vec2(440.0, 240.0);
/// Least width of a tab that has a table beside its plots.
const TABLE_AND_PLOTS_WIDTH: f32 = 660.0;
/// Share of a common strip that the map takes, and the least width of it and of the plots beside it.
const MAP_SHARE: f32 = 0.42;
const NARROWEST_IN_STRIP: f32 = 240.0;
/// Width of what of a border can be grabbed.
const BORDER_WIDTH: f32 = 7.0;

impl WindowLayout {
    /// Whether `content` has a pane.
    #[must_use]
    pub fn shows(&self, content: PaneContent) -> bool {
        self.panes.iter().any(|pane| pane.content == content)
    }

    /// Returns the room for a message, at the top: over the views, else below the bar of a window with this
    /// inner `area`.
    #[must_use]
    pub fn message_room(&self, area: Rect) -> Rect {
        let views = self.panes.iter().map(|pane| pane.rect).reduce(Rect::union);
        views.unwrap_or(area.with_min_y(self.bar.max.y))
    }

    /// The layout of a window with the inner area `whole` and as much of a `lesson`, whose views are
    /// `arranged` and whose plots are those of `tab`.
    #[must_use]
    pub fn new(
        whole: Rect,
        lesson: LessonPart,
        window: WindowSettings,
        arranged: &Arrangement,
        tab: PlotTab,
    ) -> Self {
        let (bar, below) = below_bar(whole);
        let with_side = window.controls && whole.width() >= lesson.narrowest_with_controls();
        let is_narrow = is_narrow(whole);
        let speed_height = if is_narrow && window.controls { SPEED_HEIGHT } else { 0.0 };
        // What a lesson switches on it asks about.
        let is_asked_for = lesson == LessonPart::Panel && (window.plots || window.map == Presence::On);
        let asked_for = if is_asked_for { HEIGHT_ASKED_FOR } else { 0.0 };
        let (lesson, below) =
            lesson.split_off(below, arranged, speed_height + TIMELINE_HEIGHTS[1] + asked_for);
        let area = whole.with_min_x(below.min.x);
        let (centre, side) = if with_side { split_side(below, area, window) } else { (below, None) };
        let SideParts { controls, map: map_aside, readout } =
            side.map_or_else(SideParts::default, |side| SideParts::new(side, window));
        let map_below = if map_aside.is_some() { Presence::Off } else { window.map };
        let timeline_height = TIMELINE_HEIGHTS[usize::from(!has_timeline_in_a_row(window, centre.width()))];
        let height = centre.height() - speed_height - timeline_height;
        let is_high = is_asked_for || has_table(tab) || map_below == Presence::On;
        let needs = StripNeeds { window: whole.height(), is_narrow, is_high };
        let Heights { words, free, lowest, strip } =
            Heights::new(needs, vec2(centre.width(), height.max(0.0)), window, arranged);
        let lowest = if is_asked_for { lowest.min(LOWEST) } else { lowest };
        let strip_height = part(window.strip_share, free, strip, [LOWEST; 2]);
        // What stands in a strip stays while its border is dragged, until it is too low for any of it.
        let room = if strip_height >= 1.5 * LOWEST { strip_height.max(strip) } else { strip_height };
        let below = Below::new(vec2(centre.width(), room), WindowSettings { map: map_below, ..window }, tab);
        let map_above = !window.views && window.map != Presence::Off;
        let has_room_for_strip = below != Below::Nothing && free >= lowest + LOWEST;
        let (upper, rest) = match window.views || map_above {
            true if has_room_for_strip => split_top(centre, free - strip_height),
            is_there => split_top(centre, if is_there { free } else { 0.0 }),
        };
        let (spectrum, rest) = split_top(rest, words[0]);
        let (sentence, rest) = split_top(rest, words[1]);
        let (speed, rest) = split_top(rest, speed_height);
        let (timeline, lower) = split_top(rest, timeline_height);
        let [map, plots] = below.parts(lower, window.map_share);
        let strip = (upper.height() > 0.0 && lower.height() > 0.0).then_some((lower, free));
        let borders = borders(area, side, strip, map.and(plots));
        let views = large_enough(upper).filter(|_| window.views);
        Self {
            bar,
            lesson,
            controls,
            readout,
            panes: views.map_or_else(Vec::new, |views| arranged.panes(views)),
            spectrum: shown(spectrum),
            sentence: shown(sentence),
            speed: large_enough(speed).map(|_| speed),
            timeline,
            map: if map_above { Some(upper) } else { map.or(map_aside) }.and_then(large_enough),
            plots: plots.and_then(large_enough),
            borders,
        }
    }

    /// Returns this layout without the readout; the controls take its place.
    #[must_use]
    pub fn without_readout(self) -> Self {
        let controls =
            self.controls.map(|controls| self.readout.map_or(controls, |readout| controls.union(readout)));
        Self { controls, readout: None, ..self }
    }

    /// Returns the layout of a window with this inner `area` that shows only `part` between the bar and the
    /// timeline; this layout unchanged where it does not have that part.
    #[must_use]
    pub fn with_only(self, area: Rect, part: Option<WindowPart>) -> Self {
        let (bar, below) = split_top(area, BAR_HEIGHT);
        let lesson = self.lesson;
        let below = match lesson {
            Some(lesson) if lesson.min.y > below.min.y => below.with_max_y(lesson.min.y),
            Some(lesson) => below.with_min_x(lesson.max.x),
            None => below,
        };
        let (rest, timeline) = split_top(below, below.height() - self.timeline.height());
        let speed_height = self.speed.map_or(0.0, |speed| speed.height());
        let (middle, speed) = split_top(rest, rest.height() - speed_height);
        let speed = self.speed.map(|_| speed);
        let pane = |number: usize, rect: Rect| {
            let rect = rect.with_min_y((rect.min.y + TITLE_HEIGHT).min(rect.max.y));
            self.panes
                .get(number)
                .map(|pane| Pane { rect: rect.with_max_y((rect.max.y - pane.band).max(rect.min.y)), ..*pane })
        };
        let alone = |rect: Rect| {
            let (panes, map, plots) = match part? {
                WindowPart::Pane(number) => (vec![pane(number, rect)?], None, None),
                WindowPart::Map => (Vec::new(), self.map.map(|_| rect), None),
                WindowPart::Plots => (Vec::new(), None, self.plots.map(|_| rect)),
            };
            let is_there = !panes.is_empty() || map.is_some() || plots.is_some();
            is_there.then_some((panes, map, plots))
        };
        let Some((panes, map, plots)) = large_enough(middle).and_then(alone) else { return self };
        let (controls, readout, spectrum, sentence) = (None, None, None, None);
        let borders = Vec::new();
        Self {
            bar,
            lesson,
            controls,
            readout,
            panes,
            spectrum,
            sentence,
            speed,
            timeline,
            map,
            plots,
            borders,
        }
    }
}

impl LessonPart {
    const fn narrowest_with_controls(self) -> f32 {
        match self {
            Self::Nothing | Self::Strip => NARROWEST_WITH_CONTROLS,
            Self::Panel => NARROWEST_WITH_LESSON_AND_CONTROLS,
        }
    }

    /// Returns the part on the left of `rect`, or at the bottom of one that is narrow and upright, and the
    /// rest of it, of which that at the bottom leaves as much as views `arranged` need with other parts of
    /// this height.
    fn split_off(self, rect: Rect, arranged: &Arrangement, others: f32) -> (Option<Rect>, Rect) {
        if self == Self::Panel && rect.width() < NARROWEST_WITH_CONTROLS.min(rect.height()) {
            let half = vec2(rect.width(), LESSON_SHARE * rect.height());
            let needed = height_of_views(arranged, half) + others;
            let rest = needed.clamp(LEAST_ABOVE_LESSON * rect.height(), (1.0 - LESSON_SHARE) * rect.height());
            let (rest, lesson) = split_top(rect, rest);
            return (Some(lesson), rest);
        }
        let width = match self {
            Self::Nothing => return (None, rect),
            Self::Strip => LESSON_STRIP_WIDTH,
            Self::Panel => LESSON_WIDTH,
        };
        let (lesson, rest) = split_left(rect, width.min(LESSON_SHARE * rect.width()));
        (lesson.is_positive().then_some(lesson), rest)
    }
}

/// Whether a window with this inner `area` is as narrow as a phone's: the controls have no room beside the
/// views.
#[must_use]
pub fn is_narrow(area: Rect) -> bool {
    area.width() < NARROWEST_WITH_CONTROLS
}

/// Returns the place of a row of words in `rect`, unless it has no height.
fn shown(rect: Rect) -> Option<Rect> {
    (rect.height() > 0.0).then(|| rect.shrink2(vec2(GAP / 2.0, 0.0)))
}

/// Returns the room `below` the bar without the side, and the side, which has its share of `area`.
fn split_side(below: Rect, area: Rect, window: WindowSettings) -> (Rect, Option<Rect>) {
    split_right(below, part(window.side_share, area.width(), SIDE_WIDTH, [SIDE_WIDTH, CENTRE_WIDTH]))
}

/// Returns the size of a part with this `share` of a `whole`, else the `default`: at least `least`, and as
/// long as there is room leaving `rest`.
fn part(share: Share, whole: f32, default: f32, [least, rest]: [f32; 2]) -> f32 {
    let Some(share) = share.0 else { return default };
    (share as f32 * whole).clamp(least, (whole - rest).max(least))
}

/// The borders in `area`: of the `side`, of the strip below the views with the height that both share, and of
/// the `plots` that have the map beside them.
fn borders(area: Rect, side: Option<Rect>, strip: Option<(Rect, f32)>, plots: Option<Rect>) -> Vec<Border> {
    let lower = strip.map_or(area, |(lower, _)| lower);
    let borders = [
        side.map(|side| upright(BorderParts::Side, side.left_top(), side.height(), [area.max.x, area.min.x])),
        strip.map(|(lower, free)| level(BorderParts::Strip, lower, [lower.max.y, lower.max.y - free])),
        plots.map(|plots| {
            upright(BorderParts::Map, plots.left_top(), plots.height(), [lower.min.x, lower.max.x])
        }),
    ];
    borders.into_iter().flatten().collect()
}

/// An upright border that begins at `top`; the share is 0 and 1 where x is at the `ends`.
fn upright(split: BorderParts, top: Pos2, height: f32, ends: [f32; 2]) -> Border {
    let middle = top + vec2(0.0, 0.5 * height);
    Border { split, rect: Rect::from_center_size(middle, vec2(BORDER_WIDTH, height)), ends }
}

/// The border above `lower`; the share is 0 and 1 where y is at the `ends`.
fn level(split: BorderParts, lower: Rect, ends: [f32; 2]) -> Border {
    Border {
        split,
        rect: Rect::from_center_size(lower.center_top(), vec2(lower.width(), BORDER_WIDTH)),
        ends,
    }
}

/// The contents below the timeline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Below {
    Nothing,
    Plots,
    Map,
    Both,
}

impl Below {
    /// Returns the contents of a strip of this `size`. Beside a table and plots there is a map where they
    /// have room too, or where it is asked for.
    fn new(size: Vec2, window: WindowSettings, tab: PlotTab) -> Self {
        let has_room = |least: Vec2| size.x >= least.x && size.y >= least.y;
        let suits = !has_table(tab) || (1.0 - MAP_SHARE) * size.x >= TABLE_AND_PLOTS_WIDTH;
        let map = window.views && window.map != Presence::Off;
        let is_asked_for = window.map == Presence::On;
        match (map, window.plots) {
            (true, true) if has_room(SHARED_STRIP) && (suits || is_asked_for) => Self::Both,
            (true, true) if is_asked_for => Self::Map,
            (true, false) if is_asked_for || has_room(SMALLEST_MAP) => Self::Map,
            (_, true) => Self::Plots,
            (_, false) => Self::Nothing,
        }
    }

    /// Returns the places of the map and the plots in `strip`, of which the map takes this `share`.
    fn parts(self, strip: Rect, share: Share) -> [Option<Rect>; 2] {
        let width = part(share, strip.width(), MAP_SHARE * strip.width(), [NARROWEST_IN_STRIP; 2]);
        let (left, right) = split_left(strip, width);
        match self {
            Self::Nothing => [None, None],
            Self::Plots => [None, Some(strip)],
            Self::Map => [Some(strip), None],
            Self::Both => [Some(left), Some(right)],
        }
    }
}

/// Whether the `tab` has a table beside its plots.
const fn has_table(tab: PlotTab) -> bool {
    matches!(tab, PlotTab::Fit | PlotTab::Accuracy)
}

/// Whether a timeline of this `width` has its scrubber in one row with the rest: among few controls.
#[must_use]
pub fn has_timeline_in_a_row(window: WindowSettings, width: f32) -> bool {
    window.simple && width >= NARROWEST_ROW
}

/// The bar of a window with this inner `area`, and what is below it.
#[must_use]
pub fn below_bar(area: Rect) -> (Rect, Rect) {
    split_top(area, BAR_HEIGHT)
}

#[cfg(test)]
mod tests;
