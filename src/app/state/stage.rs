//! Temporary modes of the window: the whole screen, a show for an audience, one part alone in it. None of it
//! is remembered.

use crate::settings::Preset;

/// A part that can have the window to itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum WindowPart {
    /// The view with this number, from the left.
    Pane(usize),
    /// The map alone in the window.
    Map,
    /// The plots alone in the window.
    Plots,
}

/// The panel beside the picture for an audience, the widest last.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SidePanel {
    /// Nothing: the picture has all the width.
    Nothing,
    /// A single plot beside the picture.
    Plot,
    /// The map beside the picture.
    Map,
    /// The fit: readings, residuals and a table.
    Fit,
}

/// The choices of a presenter for the audience.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Audience {
    /// Whether it has both eyes' pictures, where one alone could stand for them.
    pub both_eyes: bool,
    /// The panel beside the picture, if one was chosen: else what a preset or the step of a lesson is about.
    pub panel: Option<SidePanel>,
    /// Whether the sentence of the moment replaces the caption.
    pub tells_moment: bool,
}

/// The temporary modes of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stage {
    /// Whether the window has the whole screen.
    pub full_screen: bool,
    /// The part of the window that is shown alone.
    pub maximised: Option<WindowPart>,
    /// Whether the views have a window of their own besides, for a projector.
    pub projector: bool,
    /// Whether the window is the screen of a stereoscope.
    pub stereoscope: bool,
    /// The choices of a presenter for the audience.
    pub audience: Audience,
    /// While it is presented: whether it had the whole screen before.
    before: Option<bool>,
}

impl Stage {
    /// Returns the stage of a window that is presented from the start.
    #[must_use]
    pub const fn presented() -> Self {
        Self {
            full_screen: true,
            maximised: None,
            projector: false,
            stereoscope: false,
            audience: Audience { both_eyes: false, panel: None, tells_moment: false },
            before: Some(false),
        }
    }

    /// Whether the window is shown to an audience: large writing, and no controls.
    #[must_use]
    pub const fn is_presented(&self) -> bool {
        self.before.is_some()
    }

    /// Whether somebody besides the user looks on: here, or in the projector's window.
    #[must_use]
    pub const fn has_audience(&self) -> bool {
        self.is_presented() || self.projector
    }

    /// Begins to present, on the whole screen, or ends it; then all is as it was before.
    pub const fn toggle_presenting(&mut self) {
        match self.before.take() {
            Some(full_screen) => self.full_screen = full_screen,
            None => *self = Self { before: Some(self.full_screen), full_screen: true, ..*self },
        }
    }

    /// Has `part` alone in the window, or all others again.
    pub fn toggle_maximised(&mut self, part: WindowPart) {
        self.maximised = if self.maximised == Some(part) { None } else { Some(part) };
    }

    /// Has the window as the screen of a stereoscope, or no longer.
    pub const fn toggle_stereoscope(&mut self) {
        self.stereoscope = !self.stereoscope;
    }

    /// The number of the view that is shown alone.
    #[must_use]
    pub const fn maximised_pane(&self) -> Option<usize> {
        match self.maximised {
            Some(WindowPart::Pane(number)) => Some(number),
            _ => None,
        }
    }

    /// Leaves the last that was entered of these, if there is one.
    pub const fn leave(&mut self) {
        if self.stereoscope {
            self.stereoscope = false;
        } else if self.is_presented() {
            self.toggle_presenting();
        } else if self.maximised.is_some() {
            self.maximised = None;
        } else {
            self.full_screen = false;
        }
    }
}

/// Returns the preset `steps` after the one `shown`, before it if below 0: the one list that a presenter goes
/// through. It ends at both ends; whoever shows none of it begins with the first.
#[must_use]
pub fn next_to_show(shown: Option<&Preset>, steps: i32) -> Option<&'static Preset> {
    let all = Preset::all();
    let present = shown.and_then(|shown| all.iter().position(|preset| preset.name == shown.name));
    let next = present.map_or(0, |present| {
        let last = all.len().saturating_sub(1);
        present.saturating_add_signed(steps as isize).min(last)
    });
    all.get(next)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presenting_gives_back_what_was_there_before() {
        for full_screen in [false, true] {
            for maximised in [None, Some(WindowPart::Map)] {
                let before = Stage { full_screen, maximised, ..Stage::default() };
                let mut stage = before;
                stage.toggle_presenting();
                assert!(stage.is_presented() && stage.full_screen);
                stage.leave();
                assert_eq!(stage, before);
            }
        }
        let mut stage = Stage::presented();
        stage.leave();
        assert_eq!(stage, Stage::default());
    }

    #[test]
    fn a_clicker_goes_through_the_presets_and_stops_at_the_ends() {
        let all = Preset::all();
        assert_eq!(next_to_show(None, 1), all.first());
        let mut shown = next_to_show(None, 1);
        for preset in all.iter().skip(1).chain(all.last()) {
            shown = next_to_show(shown, 1);
            assert_eq!(shown, Some(preset));
        }
        for preset in all.iter().rev().skip(1).chain(all.first()) {
            shown = next_to_show(shown, -1);
            assert_eq!(shown, Some(preset));
        }
    }
}
