//! The state of the window that runs: all may read it, and it changes by the functions here alone.

use std::ops::Deref;

use eframe::egui::{Context, InputState};

use crate::app::commands::Command;
use crate::app::shell::persistence::Keeper;
use crate::app::state::State;
use crate::app::state::frame::Frame;
use crate::app::state::notice::Notice;
use crate::app::state::orders::Order;
use crate::app::state::shared::Shared;
use crate::settings::Settings;

/// The state of the running window. It is in a private field, so that what lasts changes by commands and by
/// time, never by an assignment while the window is drawn.
pub struct WindowState(State);

impl Deref for WindowState {
    type Target = State;

    fn deref(&self) -> &State {
        &self.0
    }
}

impl WindowState {
    /// Returns the state of a window that begins with `state`.
    pub const fn new(state: State) -> Self {
        Self(state)
    }

    /// Runs a command, so that it can be undone.
    pub fn run(&mut self, command: Command) {
        self.0.run(command);
    }

    /// Lets T run by a `step` of the wall clock, seconds; while the pedals are pushed, the push moves T in
    /// its place.
    pub fn advance(&mut self, step: f64, is_pushed: bool) {
        self.0.advance(step, is_pushed);
    }

    /// Lets exposure and vignette follow a ride for this many `seconds`; returns whether they are still on
    /// their way.
    pub fn follow_for_comfort(&mut self, seconds: f64) -> bool {
        self.0.follow_for_comfort(seconds)
    }

    /// Notes from what `input` the next commands come.
    pub fn hear(&mut self, input: &InputState) {
        self.0.hear(input);
    }

    /// Leaves a message, in place of the one before.
    pub fn tell(&mut self, notice: Notice) {
        self.0.tell(notice);
    }

    /// Takes the requests that need more than the state.
    pub fn take_orders(&mut self) -> Vec<Order> {
        self.0.take_orders()
    }

    /// Closes the file dialog.
    pub fn close_chooser(&mut self) {
        self.0.close_chooser();
    }

    /// Notes what the system makes of the window: whether it has the whole screen, and the size of a pixel,
    /// cm.
    pub fn note_screen(&mut self, full_screen: bool, cm_per_pixel: f64) {
        self.0.note_screen(full_screen, cm_per_pixel);
    }

    /// The frame, which the window measures.
    pub const fn frame_mut(&mut self) -> &mut Frame {
        &mut self.0.frame
    }

    /// Works out how the eyes look in this frame, unless that is known.
    pub fn note_looks(&mut self) {
        self.0.note_looks();
    }

    /// Brings up to date how the eyes look, where views are shown.
    pub fn renew_looks(&mut self) {
        self.0.renew_looks();
    }

    /// Replaces the settings while a picture is drawn, and returns those before, which the caller puts back.
    pub fn exchange(&mut self, settings: Shared<Settings>) -> Shared<Settings> {
        self.0.exchange(settings)
    }

    /// Puts the settings of the second of two pictures of one eye in place of its own, if it `is_second` and
    /// there is one; returns its own.
    pub fn enter(&mut self, is_second: bool) -> Option<Shared<Settings>> {
        self.0.enter(is_second)
    }

    /// Puts back the settings that [`Self::enter`] returned, if any.
    pub fn leave(&mut self, kept: Option<Shared<Settings>>) {
        self.0.leave(kept);
    }

    /// Calls `query` with the settings of one picture of a comparison: of the second, which has changes, if
    /// it `is_second`.
    pub fn of_picture<R>(&mut self, is_second: bool, query: impl FnOnce(&State) -> R) -> R {
        self.0.of_picture(is_second, |state| query(state))
    }

    /// Has the `keeper` note that something was done.
    pub fn note_in(&mut self, keeper: &Keeper) {
        keeper.note(&mut self.0);
    }

    /// Has the `keeper` write what is due.
    pub fn keep_in(&mut self, keeper: &Keeper, ctx: &Context) {
        keeper.keep_on(&mut self.0, ctx);
    }
}
