//! Settings that a key or a button gives their next value.

use crate::app::state::State;
use crate::flags::choices::further;
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
    /// The next other picture of the left eye that can be shown, compared with its own.
    Comparison,
    /// The layout this many further in the list of them, or back.
    Layout(isize),
    /// The map, shown or hidden.
    Map,
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
            Switch::Comparison => settings.compare_next(),
            Switch::Layout(steps) => settings.picture.layout = further(&settings.picture.layout, steps),
            Switch::Map => {
                let is_shown = self.frame.shows_map;
                settings.window.map = if is_shown { Presence::Off } else { Presence::On };
            }
            Switch::Frame => self.toggle_frame(),
        }
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
