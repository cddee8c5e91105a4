//! What the user does next, and does.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, PointerButton, Pos2, Rect, Vec2, vec2};
use egui_kittest::kittest::NodeT as _;
use gamow::app::state::files::purpose::Purpose;

use super::dice::Dice;
use super::files::{Files, ODD_TEXTS};
use super::hands::{Window, click, drag, frame, press, turn_wheel, write};
use super::nodes::{Coverage, Found, all};

/// What opens a dialog of the system, which nobody here could close.
const SYSTEMS_OWN: &str = "Browse…";
const MODIFIERS: [Modifiers; 6] = [
    Modifiers::NONE,
    Modifiers::NONE,
    Modifiers::SHIFT,
    Modifiers::COMMAND,
    Modifiers::ALT,
    Modifiers { shift: true, ..Modifiers::COMMAND },
];
/// Sizes of the window, points.
const SIZES: [[f32; 2]; 7] = [
    [320.0, 240.0],
    [800.0, 600.0],
    [1280.0, 800.0],
    [1024.0, 600.0],
    [480.0, 900.0],
    [2560.0, 1440.0],
    [900.0, 320.0],
];
const SCALES: [f32; 5] = [1.0, 1.0, 1.25, 0.75, 2.0];
const VALUES: [f64; 7] = [0.0, -1.0, 1e300, -1e300, 1e-300, 0.5, 3.0];
/// What is typed into the palette.
const WANTED: &[&str] = &[
    "undo",
    "redo",
    "usual",
    "play",
    "seen",
    "contract",
    "rest",
    "cone",
    "frame",
    "follow",
    "zoom",
    "look",
    "layout",
    "swap",
    "map",
    "cursor",
    "pin",
    "unpin",
    "whole",
    "present",
    "projector",
    "lesson",
    "preset",
    "set up",
    "hands",
    "fold",
    "close",
    "start",
    "fit own",
    "simulated",
    "save the state",
    "save the picture",
    "save a film",
    "save the report",
    "save the plots",
    "save the fit",
    "copy",
    "help",
    "full",
    "count",
    "globe",
    "tyre",
];

/// The user, with what is in reach.
pub struct User<'a> {
    pub window: &'a mut Window,
    pub dice: Dice,
    pub files: &'a Files,
    pub coverage: &'a mut Coverage,
}

impl User<'_> {
    /// Does something; what it was.
    pub fn act(&mut self) -> String {
        let found = all(self.window);
        self.coverage.see(&found);
        if self.would_save_elsewhere(&found) {
            return self.type_a_path(&found);
        }
        match self.dice.below(100) {
            0..38 => self.click_something(&found),
            38..45 => self.set_something(&found),
            45..54 => self.type_somewhere(&found),
            54..64 => self.drag_somewhere(&found),
            64..68 => self.turn_the_wheel(&found),
            68..71 => self.click_anywhere(&found),
            71..82 => self.press_a_key(),
            82..86 => self.ask_by_name(),
            86..88 => self.open_the_chooser(),
            88..92 => self.drop_a_file(),
            92..94 => self.resize(),
            94..96 => self.wait(),
            _ => self.go_on_in_the_lesson(&found),
        }
    }

    /// Whether what is asked for a file to write names one outside of the folder of the test, or a large one:
    /// nothing may confirm that.
    fn would_save_elsewhere(&self, found: &[Found]) -> bool {
        let purpose = self.window.state().state().scratch.chooser;
        let value =
            |name: &str| found.iter().find(|found| found.role == Role::TextInput && found.name == name);
        let folder = self.files.folder().to_string_lossy();
        matches!(purpose, Some(Purpose::Save(_)))
            && (!value("Path").is_some_and(|path| path.value.starts_with(&*folder))
                || value("Size of a picture").is_some_and(|size| size.value.len() > 5))
    }

    fn type_a_path(&mut self, found: &[Found]) -> String {
        if self.dice.happens(15) {
            press(self.window, Key::Escape, Modifiers::NONE);
            return "leaves the chooser".to_owned();
        }
        let path = match self.window.state().state().scratch.chooser {
            Some(Purpose::Save(_)) => self.files.to_write(&mut self.dice),
            _ => self.files.any(&mut self.dice),
        };
        if let Some(size) =
            found.iter().find(|found| found.name == "Size of a picture" && found.role == Role::TextInput)
        {
            let text = *self.dice.one_of(&["16x12", "32x8", "1x1", "0x9", "x"]);
            self.replace_text(size, text);
        }
        let text = path.to_string_lossy().into_owned();
        if let Some(field) = found.iter().find(|found| found.name == "Path") {
            self.replace_text(field, &text);
            press(self.window, Key::Enter, Modifiers::NONE);
        }
        format!("types the path {text:?}")
    }

    fn replace_text(&mut self, field: &Found, text: &str) {
        click(self.window, field.rect.center(), PointerButton::Primary, Modifiers::NONE, 1);
        press(self.window, Key::A, Modifiers::COMMAND);
        press(self.window, Key::Delete, Modifiers::NONE);
        write(self.window, text);
    }

    fn is_usable(found: &Found) -> bool {
        found.is_enabled && found.name != SYSTEMS_OWN
    }

    fn click_something(&mut self, found: &[Found]) -> String {
        let room = self.window.ctx.content_rect();
        let controls = found.iter().filter(|found| {
            Self::is_usable(found) && found.is_control() && room.contains(found.rect.center())
        });
        let Some(control) = self.coverage.choose(controls, &mut self.dice).cloned() else {
            return "finds nothing to click".to_owned();
        };
        self.coverage.used(&control);
        if self.dice.happens(20) {
            let id = control.number;
            if let Some(node) = self.window.root().children_recursive().nth(id) {
                node.click_accesskit();
            }
            frame(self.window, []);
            return format!("activates {:?} {:?}", control.role, control.name);
        }
        let button = if self.dice.happens(8) { PointerButton::Secondary } else { PointerButton::Primary };
        let times = if self.dice.happens(8) { 2 } else { 1 };
        let modifiers = if self.dice.happens(10) { *self.dice.one_of(&MODIFIERS) } else { Modifiers::NONE };
        click(self.window, control.rect.center(), button, modifiers, times);
        format!("clicks {:?} {:?} ({button:?}, {times}x, {modifiers:?})", control.role, control.name)
    }

    fn set_something(&mut self, found: &[Found]) -> String {
        let takes = |found: &&Found| {
            Self::is_usable(found)
                && matches!(found.role, Role::Slider | Role::SpinButton)
                && found.takes_values
        };
        let Some(control) = self.coverage.choose(found.iter().filter(takes), &mut self.dice).cloned() else {
            return "finds nothing to set".to_owned();
        };
        self.coverage.used(&control);
        if self.dice.happens(40) {
            let value = *self.dice.one_of(&VALUES);
            if let Some(node) = self.window.root().children_recursive().nth(control.number) {
                node.set_value_accesskit(value);
            }
            frame(self.window, []);
            return format!("sets {:?} to {value}", control.name);
        }
        if let Some(node) = self.window.root().children_recursive().nth(control.number) {
            node.focus();
        }
        frame(self.window, []);
        let keys =
            [Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown, Key::Home, Key::End, Key::PageUp];
        let key = *self.dice.one_of(&keys);
        let times = 1 + self.dice.below(4);
        for _ in 0..times {
            press(self.window, key, Modifiers::NONE);
        }
        format!("presses {key:?} {times}x on {:?}", control.name)
    }

    fn type_somewhere(&mut self, found: &[Found]) -> String {
        if self.window.state().state().scratch.chooser.is_some() && self.dice.happens(60) {
            return self.type_a_path(found);
        }
        let is_field = |found: &&Found| {
            let is_field =
                matches!(found.role, Role::TextInput | Role::SpinButton | Role::MultilineTextInput);
            Self::is_usable(found) && is_field && found.name != "Path" && found.name != "Size of a picture"
        };
        let Some(field) = self.coverage.choose(found.iter().filter(is_field), &mut self.dice).cloned() else {
            return "finds no field".to_owned();
        };
        self.coverage.used(&field);
        let long;
        let text = match self.dice.below(12) {
            0 => {
                long = "9".repeat(400 + self.dice.below(3000));
                &*long
            }
            _ => self.dice.one_of(ODD_TEXTS),
        };
        self.replace_text(&field, text);
        let end = *self.dice.one_of(&[Key::Enter, Key::Enter, Key::Enter, Key::Tab, Key::Escape]);
        press(self.window, end, Modifiers::NONE);
        let text: String = text.chars().take(30).collect();
        format!("types {text:?} into {:?}, then {end:?}", field.name)
    }

    /// Somewhere in a part of the window that is large enough for it, or anywhere.
    fn region(&mut self, found: &[Found]) -> (Rect, String) {
        let room = self.window.ctx.content_rect();
        let named = |found: &&Found| {
            let is_large = found.rect.width() > 60.0 && found.rect.height() > 60.0;
            is_large && !found.name.is_empty() && room.contains(found.rect.center())
        };
        match self.coverage.choose(found.iter().filter(named), &mut self.dice).cloned() {
            Some(part) if self.dice.happens(80) => {
                self.coverage.used(&part);
                (part.rect, part.name)
            }
            _ => (room, "the window".to_owned()),
        }
    }

    fn place(&mut self, rect: Rect) -> Pos2 {
        rect.lerp_inside(vec2(self.dice.between(0.0, 1.0), self.dice.between(0.0, 1.0)))
    }

    fn button(&mut self) -> PointerButton {
        let buttons =
            [PointerButton::Primary, PointerButton::Primary, PointerButton::Secondary, PointerButton::Middle];
        *self.dice.one_of(&buttons)
    }

    fn drag_somewhere(&mut self, found: &[Found]) -> String {
        let sliders = found.iter().filter(|found| Self::is_usable(found) && found.role == Role::Slider);
        let (rect, name) = match self.coverage.choose(sliders, &mut self.dice).cloned() {
            Some(slider) if self.dice.happens(25) => (slider.rect, slider.name),
            _ => self.region(found),
        };
        let (button, modifiers) = (self.button(), *self.dice.one_of(&MODIFIERS));
        let mut places: Vec<Pos2> = (0..2 + self.dice.below(3)).map(|_| self.place(rect)).collect();
        if self.dice.happens(10) {
            places.push(Pos2::new(-50.0, 4000.0));
        }
        drag(self.window, &places, button, modifiers);
        format!("drags in {name:?} from {:?} ({button:?}, {modifiers:?})", places[0])
    }

    fn turn_the_wheel(&mut self, found: &[Found]) -> String {
        let (rect, name) = self.region(found);
        let (place, modifiers) = (self.place(rect), *self.dice.one_of(&MODIFIERS));
        let size = [20.0, 200.0, 1e4][self.dice.below(3)];
        let delta: Vec2 = vec2(self.dice.between(-0.2, 0.2), self.dice.between(-1.0, 1.0)) * size;
        let times = 1 + self.dice.below(4);
        for _ in 0..times {
            turn_wheel(self.window, place, delta, modifiers);
        }
        format!("turns the wheel in {name:?} at {place:?} by {delta:?} {times}x ({modifiers:?})")
    }

    fn click_anywhere(&mut self, found: &[Found]) -> String {
        let browse =
            found.iter().find(|found| found.name == SYSTEMS_OWN).map_or(Rect::NOTHING, |found| found.rect);
        let (rect, name) = self.region(found);
        let (place, button, modifiers) = (self.place(rect), self.button(), *self.dice.one_of(&MODIFIERS));
        if browse.expand(3.0).contains(place) {
            return "clicks nothing".to_owned();
        }
        let times = 1 + self.dice.below(3);
        click(self.window, place, button, modifiers, times);
        format!("clicks in {name:?} at {place:?} {times}x ({button:?}, {modifiers:?})")
    }

    fn press_a_key(&mut self) -> String {
        let browsing = self.window.state().state().scratch.chooser.is_some();
        // The keyboard could give the focus to what opens a dialog of the system.
        let keys: Vec<Key> = Key::ALL
            .iter()
            .copied()
            .filter(|key| !browsing || !matches!(key, Key::Enter | Key::Space | Key::Tab))
            .collect();
        let ours = [
            Key::Z,
            Key::Y,
            Key::Space,
            Key::ArrowLeft,
            Key::ArrowRight,
            Key::Home,
            Key::End,
            Key::ArrowUp,
            Key::ArrowDown,
            Key::Num1,
            Key::Num2,
            Key::Num3,
            Key::Num4,
            Key::F,
            Key::N,
            Key::B,
            Key::J,
            Key::Plus,
            Key::Minus,
            Key::L,
            Key::X,
            Key::M,
            Key::G,
            Key::C,
            Key::K,
            Key::F11,
            Key::P,
            Key::W,
            Key::I,
            Key::PageUp,
            Key::PageDown,
            Key::S,
            Key::Questionmark,
            Key::Escape,
        ];
        let ours: Vec<Key> = ours.into_iter().filter(|key| keys.contains(key)).collect();
        let is_ours = self.dice.happens(75);
        let key = *self.dice.one_of(if is_ours { &ours } else { &keys });
        let modifiers = *self.dice.one_of(&MODIFIERS);
        press(self.window, key, modifiers);
        format!("presses {key:?} ({modifiers:?})")
    }

    fn ask_by_name(&mut self) -> String {
        if self.window.state().state().scratch.chooser.is_some() {
            press(self.window, Key::Escape, Modifiers::NONE);
            return "leaves the chooser".to_owned();
        }
        let text = *self.dice.one_of(WANTED);
        press(self.window, Key::P, Modifiers::COMMAND);
        frame(self.window, []);
        write(self.window, text);
        for _ in 0..self.dice.below(4) {
            press(self.window, Key::ArrowDown, Modifiers::NONE);
        }
        press(self.window, Key::Enter, Modifiers::NONE);
        format!("asks for {text:?} by name")
    }

    fn open_the_chooser(&mut self) -> String {
        press(self.window, Key::Escape, Modifiers::NONE);
        press(self.window, Key::O, Modifiers::COMMAND);
        frame(self.window, []);
        let found = all(self.window);
        self.type_a_path(&found)
    }

    fn drop_a_file(&mut self) -> String {
        let path = self.files.any(&mut self.dice);
        let said = format!("drops {}", path.display());
        self.window.input_mut().dropped_files = vec![Files::dropped(path)];
        frame(self.window, []);
        said
    }

    fn resize(&mut self) -> String {
        // Most of the time small: what is drawn costs time.
        let size = if self.dice.happens(50) { SIZES[1] } else { *self.dice.one_of(&SIZES) };
        let scale = *self.dice.one_of(&SCALES);
        self.window.set_pixels_per_point(scale);
        self.window.set_size(Vec2::from(size));
        frame(self.window, []);
        format!("resizes the window to {size:?}, scale {scale}")
    }

    fn wait(&mut self) -> String {
        let frames = 1 + self.dice.below(10);
        for _ in 0..frames {
            frame(self.window, []);
        }
        format!("waits for {frames} frames")
    }

    fn go_on_in_the_lesson(&mut self, found: &[Found]) -> String {
        if self.window.state().state().course().is_none() {
            press(self.window, Key::S, Modifiers::NONE);
            return "asks for the start page".to_owned();
        }
        let leads_on = |found: &&Found| {
            ["Predict", "Skip", "Next", "Show the end", "Again"].contains(&found.name.as_str())
                && found.is_enabled
        };
        match self.coverage.choose(found.iter().filter(leads_on), &mut self.dice).cloned() {
            Some(control) => {
                self.coverage.used(&control);
                click(self.window, control.rect.center(), PointerButton::Primary, Modifiers::NONE, 1);
                format!("clicks {:?} in the lesson", control.name)
            }
            None => "looks at the lesson".to_owned(),
        }
    }
}
