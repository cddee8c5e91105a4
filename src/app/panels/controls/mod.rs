//! The controls of motion, path and view, and the panel that holds them all.

mod compare;
mod light;
mod measuring;
mod projection;
mod quality;
mod ride;
mod screen;
mod speed;
mod two_eyes;

use eframe::egui::{self, ComboBox, RichText, ScrollArea, Ui, UiBuilder};
use relativity_render::Geometry;

use self::speed::SpeedControl;
use super::{Commands, OnClick as _, on_change};
use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, GazeCommand, SettingsCommand, Switch};
use crate::app::state::State;
use crate::app::state::defaults::Section;
use crate::app::views::dial;
use crate::app::views::layouts::{self, LAYOUTS};
use crate::app::views::panes::BESIDE;
use crate::app::widgets::theme;
use crate::app::widgets::{Edit, NumberRow, choice, choice_of, explained_lazily, row, section};
use crate::flags::choices::GazeChoice;
use crate::flags::{FieldOfView, SpeedSetting};
use crate::settings::{
    LookSettings, MAX_LENGTH, MotionSettings, PictureSettings, USUAL_FOV, WindowSettings, about, meaning,
};
use crate::units::Unit;

/// Room for the list of layouts before it scrolls, points.
const LAYOUTS_HEIGHT: f32 = 340.0;

/// Shows the rows of a section.
type SectionRows = fn(&mut Ui, &State, &mut Commands);

const MOTION: (Section, SectionRows) = (Section::Motion, motion);
const RIDE: (Section, SectionRows) = (Section::Ride, ride::show);
const OTHERS: [(Section, SectionRows); 3] =
    [(Section::Look, look), (Section::TwoEyes, two_eyes::show), (Section::Light, light::show)];

/// Returns the sections in their order: what moves first, which includes the ride of whoever rides.
fn sections(is_riding: bool) -> impl Iterator<Item = (Section, SectionRows)> {
    let [before, after] = if is_riding { [Some(RIDE), None] } else { [None, Some(RIDE)] };
    std::iter::once(MOTION).chain(before).chain(OTHERS).chain(after)
}

/// Height of a slider that a finger meets, points.
const FINGER: f32 = 28.0;

/// Shows the speed alone, for a window that has no room for the controls.
pub fn show_speed(ui: &mut Ui, state: &State, commands: &mut Commands) {
    ui.spacing_mut().item_spacing.y = 0.0;
    ui.spacing_mut().interact_size.y = FINGER;
    if state.document.settings.ride.is_on() {
        return ride::speed(ui, state, commands);
    }
    let motion = state.document.settings.motion;
    if let Some(speed) = bodies_speed(ui, state, motion, &[]) {
        commands.push(SettingsCommand::Motion(MotionSettings { speed, ..motion }).into());
    }
}

/// Height of the row below all controls.
const FOOT: f32 = 28.0;

/// Shows the controls in their sections, and below them the way to fewer.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    if state.document.settings.window.simple {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| few(ui, state, commands));
        return;
    }
    let whole = ui.max_rect();
    let middle = (whole.max.y - FOOT).max(whole.min.y);
    let above = UiBuilder::new().max_rect(whole.with_max_y(middle));
    ui.scope_builder(above, |ui| {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 3.0;
            for (part, rows) in sections(state.document.settings.ride.is_on()) {
                let tip = format!("Resets this section to its defaults, {}.", state.defaults_source());
                let reset = (!state.is_default_in(part)).then_some(tip.as_str());
                if section(ui, part.title(), reset, |ui| rows(ui, state, commands)) {
                    commands.push(SettingsCommand::ResetSection(part).into());
                }
            }
        });
    });
    let foot = UiBuilder::new().max_rect(whole.with_min_y(middle + 2.0));
    ui.scope_builder(foot, |ui| {
        let tip = "Shows speed, separation, time and one plot, and words in place of most numbers.";
        switch(ui, "Fewer controls", tip, commands);
    });
}

/// The controls of who sees the window for the first time, and the way to all others.
fn few(ui: &mut Ui, state: &State, commands: &mut Commands) {
    ui.spacing_mut().item_spacing.y = 3.0;
    motion(ui, state, commands);
    ride::button(ui, state, commands);
    ui.add_space(theme::GAP / 2.0);
    let tip = "Shows all controls (path, look, light, quality), all plots and all numbers.";
    switch(ui, "More controls", tip, commands);
}

/// The button that changes from few controls to all and back.
fn switch(ui: &mut Ui, name: &str, tip: &str, commands: &mut Commands) {
    ui.button(name).on_hover_text(tip).on_click(commands, SettingsCommand::Switch(Switch::Simple));
}

fn motion(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let mut motion = state.document.settings.motion;
    let measures = state.measures();
    let default = state.defaults().motion;
    let is_simple = state.document.settings.window.simple;
    let fields: &[speed::Field] = if is_simple { &[] } else { &speed::FIELDS };
    let is_riding = state.document.settings.ride.is_on();
    if is_riding {
        ride::speeds(ui, state, commands);
    }
    // With few controls a rider has one speed to set: their own.
    let sets_bodies = !(is_simple && is_riding);
    if let Some(speed) = sets_bodies.then(|| bodies_speed(ui, state, motion, fields)).flatten() {
        motion.speed = speed;
    }
    let separation = NumberRow::new("Separation d", about("d"), 0.0..=2.0, 0.0..=MAX_LENGTH);
    separation.show_in(ui, measures.length, &mut motion.d, default.d);
    if !is_simple {
        path_rows(ui, measures.length, state.document.scene.tracked, &mut motion, default);
    }
    on_change(commands, &state.document.settings.motion, motion, SettingsCommand::Motion);
}

/// Shows the speed of the bodies, large unless the observer's own is; on a ride none where nothing moves at
/// it.
fn bodies_speed(
    ui: &mut Ui,
    state: &State,
    motion: MotionSettings,
    fields: &[speed::Field],
) -> Option<SpeedSetting> {
    let is_large = !state.document.settings.ride.is_on();
    let told = if is_large { state.told_speed_text() } else { state.bodies_speed_text()? };
    let (current, default) = (motion.speed, state.defaults().motion.speed);
    let control = SpeedControl { current, default, told: &told, is_own: false, is_large, fields };
    if is_large {
        return speed::show(ui, control);
    }
    // Below the rider's own, whose parts have the same names.
    ui.push_id("bodies", |ui| speed::show(ui, control)).inner
}

fn path_rows(
    ui: &mut Ui,
    unit: Unit,
    [_, scene_depth, scene_height]: [f64; 3],
    motion: &mut MotionSettings,
    default: MotionSettings,
) {
    let lengths = -MAX_LENGTH..=MAX_LENGTH;
    let distance_tip = "Sets how far in front of the eyes the path runs: y of the scene's tracked point. The \
        whole scene moves with it.";
    let distance = NumberRow::new("Distance y", distance_tip, 0.0..=20.0, lengths.clone());
    let height_tip = "Sets how high above the eyes the path runs: z of the scene's tracked point. The whole \
        scene moves with it.";
    let height = NumberRow::new("Height z", height_tip, -5.0..=5.0, lengths);
    let mut depth = scene_depth + motion.depth_shift;
    if distance.show_in(ui, unit, &mut depth, scene_depth + default.depth_shift) {
        motion.depth_shift = shift(depth - scene_depth);
    }
    let mut altitude = scene_height + motion.height_shift;
    if height.show_in(ui, unit, &mut altitude, scene_height + default.height_shift) {
        motion.height_shift = shift(altitude - scene_height);
    }
}

/// A shift that settings can have: only a place at the very end of its range may ask for more.
fn shift(distance: f64) -> f64 {
    distance.clamp(-MAX_LENGTH, MAX_LENGTH)
}

fn look(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let mut look = state.document.settings.look;
    layout_row(ui, state.document.settings.picture, commands);
    geometry_row(ui, &mut look.geometry);
    light_cones_row(ui, &mut look.geometry, state.document.settings.baseline().is_along_motion());
    compare::show(ui, state, &mut look);
    gaze_row(ui, state, &mut look);
    field_of_view_rows(ui, state, &mut look, commands);
    more_rows(ui, state.document.settings.window, state.measures().time, commands);
    quality::show(ui, state, commands);
    measuring::show(ui, state, commands);
    on_change(commands, &state.document.settings.look, look, SettingsCommand::Look);
}

/// Shows the choice of the layout.
fn layout_row(ui: &mut Ui, picture: PictureSettings, commands: &mut Commands) {
    let tip = with_keys(about("layout"), &[Command::Settings(SettingsCommand::Switch(Switch::Layout(1)))]);
    row(ui, "Layout", &tip, |ui| {
        ComboBox::from_id_salt("layout")
            .selected_text(layouts::name(picture.layout))
            .width(118.0)
            .height(LAYOUTS_HEIGHT)
            .show_ui(ui, |ui| {
                for (layout, name) in LAYOUTS {
                    let choice = ui.selectable_label(layout == picture.layout, name);
                    explained_lazily(choice, || meaning(&layout))
                        .on_click(commands, SettingsCommand::Picture(PictureSettings { layout, ..picture }));
                }
            })
            .response
            .on_hover_text(&tip)
            .accessible_name("Layout of the pictures");
        let mut is_swapped = picture.swapped.has(picture.layout);
        let swap = egui::Checkbox::new(&mut is_swapped, "swap eyes");
        let response = ui.add_enabled(picture.layout.has_both(), swap);
        let tip = with_keys(about("swapped"), &[Command::Settings(SettingsCommand::Switch(Switch::Eyes))]);
        if response.on_hover_text(tip).on_disabled_hover_text("This layout shows one eye.").changed() {
            commands.push(SettingsCommand::Switch(Switch::Eyes).into());
        }
    });
}

fn geometry_row(ui: &mut Ui, geometry: &mut Geometry) {
    let mut chosen = if is_as_seen(*geometry) { Geometry::Seen } else { *geometry };
    let keys = GEOMETRIES.map(|(geometry, _)| Command::Settings(SettingsCommand::Geometry(geometry)));
    row(ui, "Geometry", &with_keys(about("geometry"), &keys), |ui| {
        if choice(ui, &mut chosen, &GEOMETRIES) {
            *geometry = chosen;
        }
    });
}

/// Whether the geometry is what two eyes see, in some binocular model.
const fn is_as_seen(geometry: Geometry) -> bool {
    matches!(geometry, Geometry::Seen | Geometry::OneCone | Geometry::Published)
}

const GEOMETRIES: [(Geometry, &str); 3] =
    [(Geometry::Seen, "As seen"), (Geometry::Contracted, "Contracted"), (Geometry::Rest, "At rest")];

/// Remark where the published geometry cannot be shown.
const UNPUBLISHED: &str = "The published model has the eyes along the motion, so the views are as seen.";

fn light_cones_row(ui: &mut Ui, geometry: &mut Geometry, is_along_motion: bool) {
    let tip = "Chooses which events the two eyes receive, with the geometry as seen.";
    let tip = with_keys(tip, &[Command::Settings(SettingsCommand::Geometry(Geometry::OneCone))]);
    let is_seen = is_as_seen(*geometry);
    let mut chosen = if is_seen { *geometry } else { Geometry::Seen };
    row(ui, "Eyes receive", &tip, |ui| {
        if ui.add_enabled_ui(is_seen, |ui| choice(ui, &mut chosen, &LIGHT_CONES)).inner {
            *geometry = chosen;
        }
    });
    if *geometry == Geometry::Published && !is_along_motion {
        row(ui, "", "", |ui| _ = ui.label(RichText::new(UNPUBLISHED).small()));
    }
}

const LIGHT_CONES: [(Geometry, &str); 3] =
    [(Geometry::Seen, "Exact"), (Geometry::OneCone, "One cone"), (Geometry::Published, "Published")];

/// Shows the switches of what is shown besides the eyes' pictures.
fn more_rows(ui: &mut Ui, before: WindowSettings, unit: Unit, commands: &mut Commands) {
    let mut window = before;
    row(ui, "Also show", "Chooses what stands beside the views, and what is drawn into them.", |ui| {
        for pane in &BESIDE {
            ui.checkbox((pane.switch)(&mut window), pane.name).on_hover_text(about(pane.name));
        }
        ui.checkbox(&mut window.dials, "clocks").on_hover_text(dial::tip(unit, false));
        let resting =
            with_keys(about("resting"), &[Command::Settings(SettingsCommand::Switch(Switch::Resting))]);
        ui.checkbox(&mut window.resting, "outline").on_hover_text(resting);
    });
    row(ui, "Below views", "Chooses what stands below the views.", |ui| {
        (ui.spacing_mut().item_spacing.x, ui.spacing_mut().icon_spacing) = (4.0, 2.0);
        ui.checkbox(&mut window.spectrum, "spectrum").on_hover_text(about("spectrum"));
        ui.checkbox(&mut window.sentence, "sentence").on_hover_text(about("sentence"));
        ui.checkbox(&mut window.ruler, "ruler").on_hover_text(about("ruler"));
    });
    on_change(commands, &before, window, SettingsCommand::Window);
}

fn gaze_row(ui: &mut Ui, state: &State, look: &mut LookSettings) {
    let tip = format!("{} Drag in a view to look around.", about("gaze"));
    let mut mode = GazeMode::from_choice(look.gaze);
    row(ui, "Gaze", &tip, |ui| {
        if choice_of(ui, &mut mode, &GAZES, &tip) {
            *look = mode.chosen(state);
        }
    });
}

/// The mode of a gaze.
#[derive(Debug, Clone, Copy, PartialEq)]
enum GazeMode {
    Whole,
    Point,
    Ahead,
    /// The gaze of a panorama, which has a button of its own.
    Passage,
    Fixed,
}

const GAZES: [(GazeMode, &str); 4] = [
    (GazeMode::Whole, "Whole"),
    (GazeMode::Point, "Point"),
    (GazeMode::Ahead, "Ahead"),
    (GazeMode::Fixed, "Fixed"),
];

impl GazeMode {
    const fn from_choice(gaze: GazeChoice) -> Self {
        match gaze {
            GazeChoice::Whole => Self::Whole,
            GazeChoice::Point => Self::Point,
            GazeChoice::Ahead => Self::Ahead,
            GazeChoice::Passage => Self::Passage,
            GazeChoice::Fixed(_) => Self::Fixed,
        }
    }

    /// The look of who chooses it.
    fn chosen(self, state: &State) -> LookSettings {
        let look = state.document.settings.look;
        match self {
            Self::Whole => LookSettings { gaze: GazeChoice::Whole, ..look },
            Self::Point => LookSettings { gaze: GazeChoice::Point, ..look },
            Self::Ahead => LookSettings { gaze: GazeChoice::Ahead, ..look },
            Self::Passage => LookSettings { gaze: GazeChoice::Passage, ..look },
            // The present field of view stays too.
            Self::Fixed => LookSettings { zero_parallax: look.zero_parallax, ..state.look() },
        }
    }
}

fn field_of_view_rows(ui: &mut Ui, state: &State, look: &mut LookSettings, commands: &mut Commands) {
    let tip = format!("{} Scroll over a view to zoom there.", about("fov"));
    let slider = 10.0..=*look.fov_range().end();
    let degrees = NumberRow::new("Field of view", &tip, slider, look.fov_range()).decimals(1).suffix("°");
    // Hidden views compute nothing, not even what would fit them.
    let shown = if state.document.settings.window.views { state.look().set_fov() } else { look.set_fov() };
    let mut fov = shown.unwrap_or(USUAL_FOV);
    match degrees.edit(ui, &mut fov) {
        Edit::Kept => {}
        Edit::Changed => look.fov = FieldOfView(Some(fov)),
        Edit::Restored => look.fov = state.defaults().look.fov,
    }
    row(ui, "", "", |ui| {
        let mut is_auto = look.fov.0.is_none();
        if ui.checkbox(&mut is_auto, "auto").on_hover_text(&tip).changed() {
            look.fov = FieldOfView(Some(fov).filter(|_| !is_auto));
        }
        let tip = "Holds the whole scene in the views, with an automatic field of view, as a double click in a view does.";
        let tip = with_keys(tip, &[Command::Gaze(GazeCommand::Whole)]);
        ui.button("Frame").on_hover_text(tip).on_click(commands, GazeCommand::Whole);
    });
}
