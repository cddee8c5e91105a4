//! The command palette: every command, found by words of its name.

use eframe::egui::{
    Align, Align2, Area, Context, Event, Frame, Id, Key, Layout, Margin, Modifiers, Order, Response,
    RichText, ScrollArea, TextEdit, TextStyle, Ui, vec2,
};

use super::Commands;
use crate::app::commands::actions::ACTIONS;
use crate::app::commands::{Command, PointsCommand, SettingsCommand, ShowCommand, WindowCommand};
use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::overlay::Overlay;
use crate::app::state::pointer::Select;
use crate::app::widgets::focus;
use crate::settings::{About, Preset, Settings, about_all};

/// Width, and the greatest height of the list, points.
const SIZE: [f32; 2] = [480.0, 340.0];
/// Room left around it in a small window.
const AROUND: f32 = 60.0;
/// Greatest number of entries in the list: with more, one types another word.
const MOST: usize = 200;

/// Something to ask for.
#[derive(Debug, Clone, PartialEq)]
struct PaletteEntry {
    name: String,
    keys: String,
    /// Tooltip of the entry: the sentence about a setting or its value; empty for the others.
    sentence: &'static str,
    command: Command,
}

/// The search: the text typed, and the chosen entry.
#[derive(Debug, Clone, Default)]
struct PaletteSearch {
    text: String,
    chosen: usize,
}

/// Shows the palette, if it is open.
pub fn show(ctx: &Context, state: &State, commands: &mut Commands) {
    let id = Id::unique("palette");
    if state.session.overlay != Some(Overlay::Palette) {
        return ctx.data_mut(|data| data.remove::<PaletteSearch>(id));
    }
    let before = ctx.data(|data| data.get_temp::<PaletteSearch>(id));
    let is_new = before.is_none();
    let mut search = before.unwrap_or_default();
    let entries = found(state, &search.text);
    search.chosen = moved(ctx, search.chosen, entries.len());
    let is_entered = ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
    let mut asked = entries.get(search.chosen).filter(|_| is_entered).cloned();
    let room = ctx.content_rect();
    let width = SIZE[0].min(room.width() - 40.0).max(1.0);
    let area = Area::new(id).order(Order::Foreground).anchor(Align2::CENTER_TOP, vec2(0.0, 0.5 * AROUND));
    let shown = area.show(ctx, |ui| {
        Frame::popup(ui.style()).inner_margin(Margin::same(10)).show(ui, |ui| {
            ui.set_width(width);
            let field =
                TextEdit::singleline(&mut search.text).hint_text("Action, body, or setting and value");
            let field = ui.add(field.desired_width(f32::INFINITY)).accessible_name("Command");
            focus::note_words(&field);
            if is_new {
                field.request_focus();
            }
            if field.changed() {
                search.chosen = 0;
            }
            let height = SIZE[1].min(room.height() - 2.0 * AROUND).max(1.0);
            ScrollArea::vertical().max_height(height).auto_shrink([false, true]).show(ui, |ui| {
                if let Some(clicked) = list(ui, &entries, &search) {
                    asked = Some(clicked);
                }
            });
        });
    });
    ctx.data_mut(|data| data.insert_temp(id, search));
    if is_new {
        // The first time it is only measured.
        ctx.request_repaint();
    } else if shown.response.clicked_elsewhere() {
        commands.push(WindowCommand::Toggle(Overlay::Palette).into());
    }
    if let Some(entry) = asked {
        commands.extend([Command::Window(WindowCommand::Toggle(Overlay::Palette)), entry.command]);
    }
}

/// Returns which of `count` entries is chosen after the arrow keys.
fn moved(ctx: &Context, chosen: usize, count: usize) -> usize {
    let pressed = |key| ctx.input_mut(|input| input.count_and_consume_key(Modifiers::NONE, key));
    let (up, down) = (pressed(Key::ArrowUp), pressed(Key::ArrowDown));
    (chosen + down).saturating_sub(up).min(count.saturating_sub(1))
}

/// Lists `entries`; the one that is clicked.
fn list(ui: &mut Ui, entries: &[PaletteEntry], search: &PaletteSearch) -> Option<PaletteEntry> {
    if entries.is_empty() {
        ui.label(RichText::new("Nothing has this name.").weak());
    }
    let mut clicked = None;
    for (index, entry) in entries.iter().enumerate() {
        let is_chosen = index == search.chosen;
        let response = row(ui, entry, is_chosen);
        if response.clicked() {
            clicked = Some(entry.clone());
        }
        let is_a_key = |event: &Event| matches!(event, Event::Key { .. });
        let has_moved = ui.input(|input| input.events.iter().any(is_a_key));
        if is_chosen && has_moved {
            response.scroll_to_me(None);
        }
    }
    clicked
}

/// The name of `entry`, and at the right end its keys.
fn row(ui: &mut Ui, entry: &PaletteEntry, is_chosen: bool) -> Response {
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.label(RichText::new(&entry.keys).text_style(TextStyle::Small).weak());
            ui.with_layout(Layout::left_to_right(Align::Center).with_main_justify(false), |ui| {
                let label = ui.selectable_label(is_chosen, &entry.name);
                if entry.sentence.is_empty() { label } else { label.on_hover_text(entry.sentence) }
            })
            .inner
        })
        .inner
    })
    .inner
}

/// Returns the entries that have every word of `text` in their names, in any order.
fn found(state: &State, text: &str) -> Vec<PaletteEntry> {
    let text = text.to_lowercase();
    let words: Vec<&str> = text.split_whitespace().collect();
    let fits = |entry: &PaletteEntry| {
        let name = entry.name.to_lowercase();
        words.iter().all(|word| name.contains(word))
    };
    let actions = ACTIONS.iter().map(|action| PaletteEntry {
        name: action.name.to_owned(),
        keys: action.keys_text(),
        sentence: "",
        command: action.command.clone(),
    });
    let entry = |name: String, command| PaletteEntry { name, keys: String::new(), sentence: "", command };
    let presets = Preset::all()
        .iter()
        .map(|preset| entry(format!("preset: {}", preset.title), Command::Show(ShowCommand::Preset(preset))));
    let library = state.library();
    let lessons = library.all().iter().filter(|lesson| !lesson.is_a_preset()).map(|lesson| {
        let open = LessonCommand::Open(lesson.name.clone());
        entry(format!("lesson: {}", lesson.title), Command::Lesson(open))
    });
    let scene = &state.document.scene;
    let bodies = (0..scene.bodies.len()).filter_map(|body| {
        let track = scene.track_on(body)?;
        let command = Command::Points(PointsCommand::Choose(Select { track, body, add: false }));
        Some(entry(format!("follow: {}", scene.name_of(body)), command))
    });
    let words_of = |about: &'static About| {
        about.words.iter().map(move |word| setting(about, &word.name, &word.sentence))
    };
    let listed = actions.chain(lessons).chain(presets).chain(bodies).chain(settings().flat_map(words_of));
    typed(state, &words).into_iter().chain(listed.filter(fits)).take(MOST).collect()
}

/// Returns the settings that are set by their names: all but those that belong to a scene, which are in no
/// section.
fn settings() -> impl Iterator<Item = &'static About> {
    about_all().iter().filter(|about| !about.section.is_empty())
}

/// The entry that gives a setting this value, with the sentence about the value if there is one.
fn setting(about: &'static About, value: &str, meaning: &'static str) -> PaletteEntry {
    let name = format!("{}: {value}", about.name.replace('-', " "));
    let sentence = if meaning.is_empty() { &about.sentence } else { meaning };
    let command = Command::Settings(SettingsCommand::Value { name: about.name, value: value.to_owned() });
    PaletteEntry { name, keys: String::new(), sentence, command }
}

/// Returns an entry where `words` are those of a setting's name and then a value that it can have.
fn typed(state: &State, words: &[&str]) -> Option<PaletteEntry> {
    let (value, name) = words.split_last()?;
    let name = name.join("-");
    let about = settings().find(|about| about.name == name && about.is_open)?;
    let can_be = Settings::clone(&state.document.settings).with_value(about.name, value).is_ok();
    can_be.then(|| setting(about, value, ""))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(text: &str) -> Vec<String> {
        found(&State::open(Settings::default()).expect("a preset"), text)
            .into_iter()
            .map(|entry| entry.name)
            .collect()
    }

    #[test]
    fn all_words_are_found_in_any_order() {
        assert_eq!(names("rear TYRE"), names("tyre rear"));
        assert_eq!(names("rear tyre"), ["follow: rear tyre"]);
        assert!(names("no such thing").is_empty());
    }

    #[test]
    fn every_lesson_is_begun_by_its_title() {
        let state = State::open(Settings::default()).expect("a preset");
        let found = found(&state, "lesson: rods");
        let open = LessonCommand::Open("rods".to_owned());
        assert_eq!(found.into_iter().map(|entry| entry.command).collect::<Vec<_>>(), [Command::Lesson(open)]);
    }

    #[test]
    fn a_setting_is_found_by_its_name_and_a_value() {
        assert_eq!(names("sky off"), ["sky: off"]);
        assert_eq!(names("beta 0.99"), ["beta: 0.99"]);
        assert_eq!(names("depth shift 2"), ["depth shift: 2"]);
        assert!(names("beta 1.5").is_empty(), "no body is that fast");
    }

    #[test]
    fn a_setting_is_set_as_by_its_control() {
        let mut state = State::open(Settings::default()).expect("a preset");
        let set = |state: &mut State, name, value: &str| {
            state.perform(Command::Settings(SettingsCommand::Value { name, value: value.to_owned() }));
        };
        set(&mut state, "gamma", "7");
        set(&mut state, "sky", "off");
        let settings = &state.document.settings;
        assert_eq!((settings.motion.speed.speed().gamma(), settings.light.sky), (7.0, false));
        // A light window shows light pictures, as after its button.
        set(&mut state, "theme", "dark");
        state.document.settings.light.light = crate::settings::Daylight::Off;
        set(&mut state, "theme", "light");
        assert_eq!(state.document.settings.light.light, crate::settings::Daylight::Theme);
        set(&mut state, "gamma", "0.5");
        assert!(state.scratch.notice.is_some(), "a value that cannot be had is refused in words");
        assert_eq!(state.document.settings.motion.speed.speed().gamma(), 7.0);
    }

    #[test]
    fn every_action_is_listed() {
        let all = names("");
        assert!(ACTIONS.iter().all(|action| all.iter().any(|name| name == action.name)));
    }
}
