//! Actions of the keys and of the command palette: one table, by which they act and from which the help is
//! written.

use eframe::egui::text_selection::LabelSelectionState;
use eframe::egui::{Context, Event, Key, KeyboardShortcut, Modifiers};
use relativity_render::Geometry;

use crate::app::commands::choice_keys;
use crate::app::commands::riding::keys;
use crate::app::commands::{
    Command, FileCommand, GazeCommand, LOOK_STEP, PlaybackCommand, PointsCommand, SettingsCommand,
    ShowCommand, Switch, WindowCommand,
};
use crate::app::state::State;
use crate::app::state::files::purpose::{Product, Purpose};
use crate::app::state::lesson::LessonCommand;
use crate::app::state::measuring::angle_ruler::RulerCommand;
use crate::app::state::measuring::stopwatch::StopwatchCommand;
use crate::app::state::orders::Copied;
use crate::app::state::overlay::Overlay;
use crate::app::state::plots::look::PlotCommand;
use crate::app::state::riding::saddle::RideCommand;
use crate::app::widgets::focus;

/// An action, by name or by key.
#[derive(Debug)]
pub struct Action {
    /// Name of the action.
    pub name: &'static str,
    /// The keys for the action, if any.
    pub keys: &'static [KeyboardShortcut],
    /// Command of the action.
    pub command: Command,
}

const fn key(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

const fn with_shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::SHIFT, key)
}

const fn with_control(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND, key)
}

const fn with_control_and_shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key)
}

const fn switch(switch: Switch) -> Command {
    Command::Settings(SettingsCommand::Switch(switch))
}

const fn nudge_speed(steps: i32) -> Command {
    Command::Settings(SettingsCommand::NudgeSpeed(steps))
}

const fn geometry(geometry: Geometry) -> Command {
    Command::Settings(SettingsCommand::Geometry(geometry))
}

const fn step(steps: i32) -> Command {
    Command::Playback(PlaybackCommand::Step(steps))
}

const fn window(command: WindowCommand) -> Command {
    Command::Window(command)
}

const fn toggle(page: Overlay) -> Command {
    window(WindowCommand::Toggle(page))
}

const fn next(steps: i32) -> Command {
    Command::Show(ShowCommand::Next(steps))
}

const fn save(product: Product) -> Command {
    Command::File(FileCommand::Choose(Purpose::Save(product)))
}

const fn action(name: &'static str, keys: &'static [KeyboardShortcut], command: Command) -> Action {
    Action { name, keys, command }
}

/// Factor of the field of view for a press of a key.
pub const ZOOM_STEP: f64 = 0.9;

/// Every action, in the order of the help.
pub static ACTIONS: &[Action] = &[
    action("undo the last step", &[with_control(Key::Z)], Command::Undo),
    action("redo what was undone", &[with_control_and_shift(Key::Z), with_control(Key::Y)], Command::Redo),
    action("reset to the defaults", &[], Command::Settings(SettingsCommand::Reset)),
    action("open a file", &[with_control(Key::O)], Command::File(FileCommand::Choose(Purpose::Open))),
    action("play or pause", &[key(Key::Space)], Command::Playback(PlaybackCommand::Toggle)),
    action("go a step forwards in time", &[key(Key::ArrowRight)], step(1)),
    action("go a step back in time", &[key(Key::ArrowLeft)], step(-1)),
    action("go ten steps forwards in time", &[with_shift(Key::ArrowRight)], step(10)),
    action("go ten steps back in time", &[with_shift(Key::ArrowLeft)], step(-10)),
    action("go to the start", &[key(Key::Home)], Command::Playback(PlaybackCommand::GoToPart(0.0))),
    action("go to the end", &[key(Key::End)], Command::Playback(PlaybackCommand::GoToPart(1.0))),
    action("go faster", &[key(Key::ArrowUp)], nudge_speed(1)),
    action("go slower", &[key(Key::ArrowDown)], nudge_speed(-1)),
    action("go much faster", &[with_shift(Key::ArrowUp)], nudge_speed(10)),
    action("go much slower", &[with_shift(Key::ArrowDown)], nudge_speed(-10)),
    action("get on the bicycle and ride, or get off", &[key(Key::I)], Command::Ride(RideCommand::Toggle)),
    action("open the street and ride", &[], Command::Show(ShowCommand::Ride)),
    action("face where you ride", &[with_shift(Key::I)], Command::Ride(RideCommand::Face)),
    action("show how to ride, and how far you rode", &[key(Key::H)], Command::Ride(RideCommand::Remind)),
    action("show the scene as seen", &[key(Key::Num1)], geometry(Geometry::Seen)),
    action("show the scene contracted only", &[key(Key::Num2)], geometry(Geometry::Contracted)),
    action("show the scene at rest", &[key(Key::Num3)], geometry(Geometry::Rest)),
    action("give both eyes one light cone", &[key(Key::Num4)], geometry(Geometry::OneCone)),
    action(
        "compare two pictures of one eye: as seen, contracted, at rest, D²; on a ride, standing",
        &[with_shift(Key::B)],
        switch(Switch::Comparison),
    ),
    action("show what is seen standing where you ride, or not", &[], switch(Switch::Standing)),
    action("show one eye's picture, or both eyes'", &[key(Key::B)], switch(Switch::BothEyes)),
    action("frame the whole scene in the views", &[key(Key::F)], Command::Gaze(GazeCommand::Whole)),
    action("follow the next body", &[key(Key::J)], Command::Points(PointsCommand::FollowNext(1))),
    action("follow the body before", &[with_shift(Key::J)], Command::Points(PointsCommand::FollowNext(-1))),
    action("zoom in", &[key(Key::Plus), key(Key::Equals)], Command::Gaze(GazeCommand::Magnify(ZOOM_STEP))),
    action("zoom out", &[key(Key::Minus)], Command::Gaze(GazeCommand::Magnify(1.0 / ZOOM_STEP))),
    action("look to the left", &[], Command::Gaze(GazeCommand::Aside([-LOOK_STEP, 0.0]))),
    action("look to the right", &[], Command::Gaze(GazeCommand::Aside([LOOK_STEP, 0.0]))),
    action("look up", &[], Command::Gaze(GazeCommand::Aside([0.0, LOOK_STEP]))),
    action("look down", &[], Command::Gaze(GazeCommand::Aside([0.0, -LOOK_STEP]))),
    action(
        "lay a ruler for angles by the next drag in a view, or remove it",
        &[key(Key::R)],
        Command::Ruler(RulerCommand::Toggle),
    ),
    action(
        "start or stop the stopwatch in the first view",
        &[key(Key::T)],
        Command::Stopwatch(StopwatchCommand::Press),
    ),
    action("show or hide the stopwatch", &[with_shift(Key::T)], Command::Stopwatch(StopwatchCommand::Toggle)),
    action("choose the next layout of the two pictures", &[key(Key::L)], switch(Switch::Layout(1))),
    action("choose the layout before", &[with_shift(Key::L)], switch(Switch::Layout(-1))),
    action("change between conformal and camera pictures", &[key(Key::V)], switch(Switch::Projection)),
    action("show the panorama of the whole passage, or two views", &[key(Key::U)], switch(Switch::Panorama)),
    action("show few controls, or all", &[], switch(Switch::Simple)),
    action("show or hide the resting outline in conformal views", &[key(Key::O)], switch(Switch::Resting)),
    action("swap the eyes", &[key(Key::X)], switch(Switch::Eyes)),
    action("show or hide the map", &[key(Key::M)], switch(Switch::Map)),
    action("show or hide the plots", &[key(Key::N)], switch(Switch::Plots)),
    action("show or hide the moment in words", &[], switch(Switch::Sentence)),
    action("draw the map in the ground's or the bicycle's frame", &[key(Key::G)], switch(Switch::Frame)),
    action(
        "set a cursor in the plots at T: the first, the second, none",
        &[key(Key::C)],
        Command::Plots(PlotCommand::Cursor(None)),
    ),
    action(
        "pin the curves of the selected point in the plots",
        &[key(Key::K)],
        Command::Plots(PlotCommand::Pin),
    ),
    action("unpin all curves", &[with_shift(Key::K)], Command::Plots(PlotCommand::Unpin)),
    action("show the whole of every plot", &[], Command::Plots(PlotCommand::Whole)),
    action("take the whole screen, or leave it", &[key(Key::F11)], window(WindowCommand::ToggleFullScreen)),
    action(
        "present: large writing, and no controls",
        &[key(Key::P)],
        window(WindowCommand::TogglePresenting),
    ),
    action(
        "open or close a window for a projector: the views and a lesson's words",
        &[key(Key::W)],
        window(WindowCommand::ToggleProjector),
    ),
    action(
        "make the window a stereoscope: a phone in a viewer with two lenses",
        &[],
        window(WindowCommand::ToggleStereoscope),
    ),
    action("go back in the lesson or to the preset before", &[key(Key::PageUp)], next(-1)),
    action("go on in the lesson or to the next preset", &[key(Key::PageDown)], next(1)),
    action("set up the step of the lesson again", &[], Command::Lesson(LessonCommand::SetUp)),
    action("count hands in the lesson, or no longer", &[], Command::Lesson(LessonCommand::ToggleClass)),
    action("fold the lesson, or unfold it", &[], Command::Lesson(LessonCommand::ToggleFolded)),
    action("start the lesson over, without its answers", &[], Command::Lesson(LessonCommand::BeginAnew)),
    action("close the lesson", &[], Command::Lesson(LessonCommand::Close)),
    action("end the sequence of your own", &[], Command::Show(ShowCommand::EndSequence)),
    action("open or close the start page: lessons and presets", &[key(Key::S)], toggle(Overlay::Start)),
    action("show all presets to choose from", &[with_shift(Key::S)], toggle(Overlay::Presets)),
    action("find an action by its name", &[with_control(Key::P)], toggle(Overlay::Palette)),
    action("fit own data", &[], Command::File(FileCommand::Choose(Purpose::OpenData))),
    action("fit simulated data", &[], Command::File(FileCommand::Simulate)),
    action("save the picture", &[with_control(Key::S)], save(Product::Picture)),
    action("save the state", &[with_control_and_shift(Key::S)], save(Product::State)),
    action("save the scene of the model", &[], save(Product::Scene)),
    action("save the plots as a drawing", &[], save(Product::PlotsSvg)),
    action("save the plots as a table", &[], save(Product::PlotsCsv)),
    action("save a film", &[], save(Product::Film)),
    action("save a film of 10 s of what was just shown", &[with_control(Key::F)], save(Product::TenSeconds)),
    action("save the fit", &[], save(Product::Fit)),
    action("save the report of the lesson", &[], save(Product::Report)),
    action("save the worksheet of the lesson", &[], save(Product::Worksheet)),
    action("save the lab of the lesson", &[], save(Product::LabSheet)),
    action("save the teacher’s page of the lesson", &[], save(Product::TeachersPage)),
    action("hand in my answers in the lesson", &[], toggle(Overlay::Answers)),
    action("collect the answers of a class", &[], toggle(Overlay::Class)),
    action(
        "copy the command of this window",
        &[with_control(Key::C)],
        Command::File(FileCommand::Copy(Copied::Command)),
    ),
    action("copy a link to what is shown", &[], Command::File(FileCommand::Copy(Copied::Link))),
    action("copy the picture", &[], Command::File(FileCommand::Copy(Copied::Picture))),
    action("copy the command of the picture", &[], Command::File(FileCommand::Copy(Copied::RenderCommand))),
    action("copy the command of the curves", &[], Command::File(FileCommand::Copy(Copied::CurveCommand))),
    action("copy the values at T", &[], Command::File(FileCommand::Copy(Copied::Values))),
    action("show this help", &[key(Key::Questionmark), key(Key::F1)], toggle(Overlay::Help)),
    action("close what is on top, or leave", &[key(Key::Escape)], window(WindowCommand::Close)),
];

impl Action {
    /// Returns the keys of the action as they are labelled on a keyboard; empty if it has none.
    #[must_use]
    pub fn keys_text(&self) -> String {
        self.keys.iter().copied().map(keys_text).collect::<Vec<_>>().join(", ")
    }
}

/// Returns the keys of these commands as they are labelled on a keyboard; empty if they have none.
#[must_use]
pub fn keys_of(commands: &[Command]) -> String {
    let of =
        |command: &Command| ACTIONS.iter().find(|action| action.command == *command).map(Action::keys_text);
    commands.iter().filter_map(of).filter(|keys| !keys.is_empty()).collect::<Vec<_>>().join(", ")
}

/// Returns `tip`, and behind it the keys of these commands.
#[must_use]
pub fn with_keys(tip: &str, commands: &[Command]) -> String {
    let keys = keys_of(commands);
    let heading = if keys.contains(", ") { "Keys" } else { "Key" };
    match (tip, keys.as_str()) {
        (_, "") => tip.to_owned(),
        ("", _) => format!("{heading}: {keys}"),
        _ => format!("{tip}   {heading}: {keys}"),
    }
}

/// A key as it is written on a keyboard, after those held with it.
fn keys_text(keys: KeyboardShortcut) -> String {
    let name = match keys.logical_key {
        Key::ArrowLeft => "←",
        Key::ArrowRight => "→",
        Key::ArrowUp => "↑",
        Key::ArrowDown => "↓",
        key => key.symbol_or_name(),
    };
    let held = [(keys.modifiers.command, "Ctrl+"), (keys.modifiers.shift, "Shift+")];
    let held: String = held.into_iter().filter(|(is_held, _)| *is_held).map(|(_, name)| name).collect();
    format!("{held}{name}")
}

/// Returns the commands of the keys pressed since the last frame, except keys that the focused widget takes.
/// Letters and digits answer the lesson while it shows choices.
pub fn asked(ctx: &Context, state: &State) -> Vec<Command> {
    let is_copying_text = ctx.plugin::<LabelSelectionState>().lock().has_selection();
    let is_meant =
        |event: &&Event| !(choice_keys::counts(state, event) || is_copying_text && **event == Event::Copy);
    let answered =
        |event: &Event| choice_keys::answered(state, event).map(|(asked, command)| (key(asked), command));
    let meaning = |event: &Event| match (answered(event), keys::taken(state, event)) {
        (Some(answered), _) => Some(answered),
        (None, Some(asked)) => asked.map(|(asked, command)| (key(asked), command)),
        (None, None) => bound(event),
    };
    let pressed: Vec<_> =
        ctx.input(|input| input.events.iter().filter(is_meant).filter_map(meaning).collect());
    let meant: Vec<_> = pressed.into_iter().filter(|(keys, _)| !focus::takes(ctx, *keys)).collect();
    let perform = |(keys, command)| {
        focus::leave_for(ctx, keys);
        command
    };
    meant.into_iter().map(perform).collect()
}

/// The keys of an action that `event` presses, and what that asks for.
fn bound(event: &Event) -> Option<(KeyboardShortcut, Command)> {
    let (key, modifiers) = match event {
        Event::Key { key, pressed: true, modifiers, .. } => (key, modifiers),
        // The system's own name for Ctrl+C.
        Event::Copy => (&Key::C, &Modifiers::COMMAND),
        _ => return None,
    };
    let all = ACTIONS.iter().flat_map(|action| action.keys.iter().map(move |keys| (*keys, action)));
    let found = |shift: bool| {
        all.clone().find(|(keys, _)| {
            let held = keys.modifiers;
            keys.logical_key == *key
                && (held.command, held.alt, held.shift) == (modifiers.command, modifiers.alt, shift)
        })
    };
    // Some keyboards need shift for a key that others have by itself.
    let found = found(modifiers.shift).or_else(|| found(false));
    found.map(|(keys, action)| (keys, action.command.clone()))
}
