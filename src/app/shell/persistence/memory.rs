//! The memory of the window beside its settings and answers: its place, zoom, folded sections, recent files,
//! and which hints its user no longer needs.

use std::collections::BTreeSet;

use eframe::egui::{Context, ViewportBuilder, ViewportCommand, pos2};
use serde::{Deserialize, Serialize};
use toml::{Table, Value};

use crate::app::state::State;
use crate::app::state::defaults::Section;
use crate::app::state::files::recent::Recent;
use crate::app::tools::folded;

/// Smallest and largest zoom factor: those of the keys that change it.
const ZOOM: [f32; 2] = [0.2, 5.0];
/// Furthest that a window can lie on any screen, and largest, points: X11 has 16 bits for it.
const FURTHEST: f32 = 32_767.0;

/// The sections that are folded until a user opens them: all but *Motion*.
const FOLDED_AT_FIRST: [&str; 3] = [Section::Look.title(), Section::TwoEyes.title(), Section::Light.title()];

/// The contents of the file `window.toml`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Memory {
    /// Whether the user has ever followed a point by a click.
    pub clicked: bool,
    /// The name of the lesson to go on with, once one was begun.
    pub lesson: Option<String>,
    /// The zoom factor of the whole window.
    zoom: f32,
    /// The titles of the sections that are folded.
    folded: BTreeSet<String>,
    /// The files that were opened, the latest first.
    recent: Vec<String>,
    place: Option<WindowPlace>,
}

impl Default for Memory {
    fn default() -> Self {
        Self {
            clicked: false,
            lesson: None,
            zoom: 1.0,
            folded: FOLDED_AT_FIRST.map(str::to_owned).into(),
            recent: Vec::new(),
            place: None,
        }
    }
}

/// The place of a window, in points of the system, which the zoom does not change.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct WindowPlace {
    /// The upper left corner with its frame, on systems that report it.
    position: Option<[f32; 2]>,
    /// The inner size of the window while it is not maximised.
    size: [f32; 2],
    maximised: bool,
}

impl Memory {
    /// Reads the text of its file; what is wrong there is left out, with a line for each.
    pub fn of_text(text: &str) -> Result<(Self, Vec<String>), String> {
        let mut table: Table = text.parse().map_err(|error: toml::de::Error| error.message().to_owned())?;
        let mut problems = Vec::new();
        let default = Self::default();
        let memory = Self {
            clicked: taken(&mut table, "clicked", |_| true, &mut problems).unwrap_or_default(),
            lesson: taken(&mut table, "lesson", |_| true, &mut problems),
            zoom: taken(&mut table, "zoom", |zoom| (ZOOM[0]..=ZOOM[1]).contains(zoom), &mut problems)
                .unwrap_or(default.zoom),
            folded: taken(&mut table, "folded", |_| true, &mut problems).unwrap_or(default.folded),
            recent: taken(&mut table, "recent", |_| true, &mut problems).unwrap_or_default(),
            place: taken(&mut table, "place", WindowPlace::can_be, &mut problems),
        };
        Ok((memory, problems))
    }

    /// Writes the text of the file.
    #[must_use]
    pub fn to_text(&self) -> String {
        toml::to_string(self).unwrap_or_default()
    }

    /// The files that were opened.
    #[must_use]
    pub fn recent(&self) -> Recent {
        Recent::of_text(&self.recent.join("\n"))
    }

    /// Notes what of `state` is remembered here.
    pub fn note(&mut self, state: &State) {
        self.clicked |= !state.session.hint;
        self.lesson = state.session.next_lesson.clone().or(self.lesson.take());
        self.recent = state.session.recent.to_text().lines().map(str::to_owned).collect();
    }

    /// Stores the window's zoom and folded sections, and if it `keeps_place` its place: a size that a flag
    /// asked for is no habit.
    pub fn note_window(&mut self, ctx: &Context, keeps_place: bool) {
        self.zoom = ctx.zoom_factor().clamp(ZOOM[0], ZOOM[1]);
        if let Some(folded) = folded::noted(ctx).filter(|folded| *folded != self.folded) {
            self.folded = folded;
        }
        if keeps_place {
            let place = WindowPlace::from_context(ctx, self.place);
            self.place = place.filter(WindowPlace::can_be).or(self.place);
        }
    }

    /// Gives the zoom and the folded sections to a new window, which may have its `place` too.
    pub fn restore_in(&self, ctx: &Context, place: bool) {
        ctx.set_zoom_factor(self.zoom);
        folded::set(ctx, self.folded.clone());
        if place && self.place.is_some_and(|place| place.maximised) {
            // Where windows are shown before they can be maximised, it has to be asked for again.
            ctx.send_viewport_cmd(ViewportCommand::Maximized(true));
        }
    }

    /// Whether it is known where the last window was.
    #[must_use]
    pub const fn has_place(&self) -> bool {
        self.place.is_some()
    }

    /// Has a window open where the last one was.
    #[must_use]
    pub fn placed(&self, window: ViewportBuilder) -> ViewportBuilder {
        let Some(WindowPlace { position, size, maximised }) = self.place else { return window };
        let window = window.with_inner_size(size).with_maximized(maximised);
        match position {
            Some(position) => window.with_position(position),
            None => window,
        }
    }

    /// Has a new window that would be on none of the `monitors` (position and size of each, points) on the
    /// first of them.
    pub fn bring_back(&self, ctx: &Context, mut monitors: impl Iterator<Item = [[f32; 2]; 2]>) {
        /// The part of the window, points, that must be on a monitor to be grasped.
        const GRASP: f32 = 40.0;
        let Some([x, y]) = self.place.and_then(|place| place.position) else { return };
        let is_on = |[[left, top], [width, height]]: [[f32; 2]; 2]| {
            (left - GRASP..left + width - GRASP).contains(&x)
                && (top - GRASP..top + height - GRASP).contains(&y)
        };
        let Some(first) = monitors.next() else { return };
        if !is_on(first) && !monitors.any(is_on) {
            let [left, top] = first[0];
            ctx.send_viewport_cmd(ViewportCommand::OuterPosition(pos2(left + GRASP, top + GRASP)));
        }
    }
}

impl WindowPlace {
    /// The place of the window; while it is maximised or has the whole screen, its size is the `last` one.
    fn from_context(ctx: &Context, last: Option<Self>) -> Option<Self> {
        let zoom = ctx.zoom_factor();
        ctx.input(|input| {
            let viewport = input.viewport();
            let maximised = viewport.maximized.unwrap_or_default();
            if maximised || viewport.fullscreen.unwrap_or_default() || viewport.minimized.unwrap_or_default()
            {
                return last.map(|last| Self { maximised, ..last });
            }
            let position = viewport.outer_rect.map(|rect| (rect.min * zoom).into());
            Some(Self { position, size: (input.content_rect().size() * zoom).into(), maximised })
        })
    }

    fn can_be(&self) -> bool {
        let is_near = |position: [f32; 2]| position.iter().all(|x| x.abs() <= FURTHEST);
        self.size.iter().all(|side| (1.0..=FURTHEST).contains(side)) && self.position.is_none_or(is_near)
    }
}

/// Takes the value called `key` out of `table`. One that is of another kind, or is not `right`, is a problem.
fn taken<T: for<'de> Deserialize<'de>>(
    table: &mut Table,
    key: &str,
    right: impl FnOnce(&T) -> bool,
    problems: &mut Vec<String>,
) -> Option<T> {
    let value: Value = table.remove(key)?;
    let shown = value.to_string();
    let found = value.try_into::<T>().ok().filter(right);
    if found.is_none() {
        problems.push(format!("{key} = {shown}"));
    }
    found
}
