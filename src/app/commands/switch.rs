//! Settings that a key or a button gives their next value.

use crate::app::state::State;
use crate::app::state::stage::SidePanel;
use crate::flags::choices::{Layout, further};
use crate::settings::{MapFrame, MapSettings, Presence};

/// A setting that is given its next value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Switch {
    /// Conformal pictures, or if these are shown camera pictures, which look at the same.
    Projection,
    /// The whole passage in one strip for each eye, or if that is shown two views.
    Panorama,
    /// The outline in conformal views of what moves where it would be seen at rest, or none.
    Resting,
    /// Few controls, or all.
    Simple,
    /// The eyes of the present layout, swapped or not.
    Eyes,
    /// Switches between one eye's picture and those of both eyes.
    BothEyes,
    /// The next other picture of the left eye that can be shown, compared with its own.
    Comparison,
    /// A second picture of what is seen standing where one rides, or none.
    Standing,
    /// The layout this many further in the list of them, or back.
    Layout(isize),
    /// The map, shown or hidden.
    Map,
    /// The plots, shown or hidden.
    Plots,
    /// The moment in words, shown or hidden.
    Sentence,
    /// The other frame of the map.
    Frame,
}

impl State {
    /// Gives a setting its next value.
    pub(super) fn perform_switch(&mut self, switch: Switch) {
        let settings = &mut self.document.settings;
        match switch {
            Switch::Projection => settings.look.projection = settings.look.projection.toggled(),
            Switch::Panorama => {
                let default = self.defaults();
                self.document.settings.toggle_panorama(&default);
            }
            Switch::Resting => settings.window.resting = !settings.window.resting,
            Switch::Simple => settings.window = settings.window.with_few(!settings.window.simple),
            Switch::Eyes => {
                let picture = &mut settings.picture;
                picture.swapped = picture.swapped.toggled(picture.layout);
            }
            Switch::BothEyes => self.switch_eyes(),
            Switch::Comparison => settings.compare_next(),
            Switch::Standing => settings.compare_standing(),
            Switch::Layout(steps) => settings.picture.layout = further(&settings.picture.layout, steps),
            Switch::Map if self.session.stage.is_presented() => self.switch_panel(SidePanel::Map),
            Switch::Plots if self.session.stage.is_presented() => self.switch_panel(SidePanel::Plot),
            Switch::Sentence if self.session.stage.is_presented() => {
                self.session.stage.audience.tells_moment = !self.session.stage.audience.tells_moment;
            }
            Switch::Sentence => settings.window.sentence = !settings.window.sentence,
            Switch::Plots => settings.window.plots = !settings.window.plots,
            Switch::Map => {
                let is_shown = self.frame.shows_map;
                settings.window.map = if is_shown { Presence::Off } else { Presence::On };
            }
            Switch::Frame => self.toggle_frame(),
        }
    }

    /// Shows one eye's picture in place of both eyes', or both.
    fn switch_eyes(&mut self) {
        let has_both = self.has_both_eyes();
        let leaves_one_out = self.may_leave_an_eye_out() && self.session.stage.audience.both_eyes;
        let picture = &mut self.document.settings.picture;
        picture.layout = match (has_both, picture.layout) {
            (true, layout) if leaves_one_out => layout,
            (true, _) => Layout::Left,
            (false, layout) if layout.has_both() => layout,
            (false, _) => Layout::SideBySide,
        };
        self.session.stage.audience.both_eyes = !has_both;
    }

    /// Shows this panel beside the picture for an audience, or if it is shown none.
    fn switch_panel(&mut self, panel: SidePanel) {
        let shown = match self.side_panel() {
            SidePanel::Fit => SidePanel::Plot,
            shown => shown,
        };
        self.session.stage.audience.panel = Some(if shown == panel { SidePanel::Nothing } else { panel });
    }

    fn toggle_frame(&mut self) {
        let frame = match self.document.settings.map.frame {
            MapFrame::Ground => MapFrame::Bicycle,
            MapFrame::Bicycle if self.document.settings.ride.is_on() => MapFrame::Rider,
            MapFrame::Bicycle | MapFrame::Rider => MapFrame::Ground,
        };
        self.set_map(MapSettings { frame, ..self.document.settings.map });
    }
}
