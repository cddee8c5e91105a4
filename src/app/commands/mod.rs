//! Everything that a user can do, by what it is done to: [`Command`] has an arm for each owner, in a file of
//! its own.

pub(in crate::app) mod actions;
mod by_name;
pub(in crate::app) mod choice_keys;
pub(in crate::app) mod class;
pub mod file_dialog;
mod files;
mod gaze;
mod lesson;
mod playback;
mod plots;
mod points;
pub mod riding;
mod ruler;
pub(in crate::app) mod saving;
mod sequence;
mod settings;
mod show;
mod stopwatch;
mod switch;
mod undo;
mod window;

use crate::app::state::State;
use crate::app::state::class::ClassCommand;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::measuring::angle_ruler::RulerCommand;
use crate::app::state::measuring::stopwatch::StopwatchCommand;
use crate::app::state::overlay::Overlay;
use crate::app::state::plots::look::PlotCommand;
use crate::app::state::riding::saddle::RideCommand;
use crate::map::Viewpoint;

pub use files::FileCommand;
pub use gaze::{GazeCommand, LOOK_STEP};
pub use playback::PlaybackCommand;
pub use points::PointsCommand;
pub use settings::SettingsCommand;
pub use show::ShowCommand;
pub use switch::Switch;
pub use window::WindowCommand;

/// A command of the user.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// Changes the settings.
    Settings(SettingsCommand),
    /// Turns or widens what the views show.
    Gaze(GazeCommand),
    /// Goes to another T, plays or pauses.
    Playback(PlaybackCommand),
    /// Selects, follows or forgets a point.
    Points(PointsCommand),
    /// Gets on the bicycle, rides, or gets off.
    Ride(RideCommand),
    /// Lays a ruler into a view, or removes it.
    Ruler(RulerCommand),
    /// Starts, stops, shows or hides the stopwatch.
    Stopwatch(StopwatchCommand),
    /// Looks at another part of the plots, or marks or keeps something in them.
    Plots(PlotCommand),
    /// Looks at another part of the map.
    MapView(Viewpoint),
    /// Begins a lesson, or does something in the one that is gone through.
    Lesson(LessonCommand),
    /// Collects answers of a class.
    Class(ClassCommand),
    /// Shows something else.
    Show(ShowCommand),
    /// Reads, writes or copies.
    File(FileCommand),
    /// Changes the window itself.
    Window(WindowCommand),
    /// Undoes the last step.
    Undo,
    /// Makes the step again that was undone.
    Redo,
}

/// Makes a command of that of each owner.
macro_rules! commands_of {
    ($($owner:ident: $command:ty,)*) => {
        $(impl From<$command> for Command {
            fn from(command: $command) -> Self {
                Self::$owner(command)
            }
        })*
    };
}

commands_of! {
    Settings: SettingsCommand,
    Gaze: GazeCommand,
    Playback: PlaybackCommand,
    Points: PointsCommand,
    Ride: RideCommand,
    Ruler: RulerCommand,
    Stopwatch: StopwatchCommand,
    Plots: PlotCommand,
    Lesson: LessonCommand,
    Class: ClassCommand,
    Show: ShowCommand,
    File: FileCommand,
    Window: WindowCommand,
}

impl Command {
    /// Whether the command sets T or the speed, which a lesson may be playing.
    const fn sets_what_runs(&self) -> bool {
        match self {
            Self::Ride(RideCommand::Remind) => false,
            Self::Settings(SettingsCommand::Motion(_) | SettingsCommand::NudgeSpeed(_))
            | Self::Ride(_)
            | Self::Playback(_) => true,
            _ => false,
        }
    }

    /// Whether the command changes what is shown, so that a page over the window must close.
    const fn shows_another(&self) -> bool {
        matches!(
            self,
            Self::Show(_)
                | Self::File(FileCommand::Open(_) | FileCommand::OpenData(_))
                | Self::Settings(SettingsCommand::Reset)
                | Self::Undo
                | Self::Redo
        )
    }
}

impl State {
    /// Performs a command.
    pub(super) fn perform(&mut self, command: Command) {
        self.make_way_for(&command);
        match command {
            Command::Settings(command) => self.perform_settings(command),
            Command::Gaze(command) => self.perform_gaze(command),
            Command::Playback(command) => self.perform_playback(command),
            Command::Points(command) => self.perform_points(command),
            Command::Ride(command) => self.perform_ride(command),
            Command::Ruler(command) => self.perform_ruler(command),
            Command::Stopwatch(command) => self.perform_stopwatch(command),
            Command::Plots(command) => self.perform_plots(command),
            Command::MapView(viewpoint) => self.scratch.map_view = viewpoint,
            Command::Lesson(command) => self.perform_lesson(command),
            Command::Class(command) => self.perform_class(command),
            Command::Show(command) => self.perform_show(command),
            Command::File(command) => self.perform_file(command),
            Command::Window(command) => self.perform_window(command),
            // Done by who goes through the steps.
            Command::Undo | Command::Redo => {}
        }
    }

    /// Ends what a command ends besides what it does.
    fn make_way_for(&mut self, command: &Command) {
        self.scratch.missed = None;
        if command.sets_what_runs() {
            self.stop_run();
        }
        if command.shows_another() && self.session.overlay.is_some_and(Overlay::is_page) {
            self.session.overlay = None;
        }
    }
}
