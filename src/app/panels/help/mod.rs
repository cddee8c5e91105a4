//! The help: what is shown, the glossary of the documentation, and what keys and mouse do, from the same
//! table that the keys act by.

mod words;

use std::sync::OnceLock;

use eframe::egui::{Context, Grid, Id, Label, RichText, ScrollArea, TextStyle, TextWrapMode, Ui, vec2};

use super::{Commands, show_overlay};
use crate::app::commands::actions::{ACTIONS, keys_of};
use crate::app::commands::{Command, WindowCommand};
use crate::app::state::State;
use crate::app::state::overlay::Overlay;
use crate::app::widgets::markdown;
use crate::settings::about_all;
use words::{GLOSSARY, NOTICES, OWN_LICENCE, PAPER, PAPER_ADDRESS, WHAT};

/// Width and height of what scrolls, and how much of the window is left around it; points.
const SIZE: [f32; 2] = [600.0, 440.0];
const AROUND: [f32; 2] = [60.0, 150.0];
/// Width of the first column of tables.
const CAUSES: f32 = 170.0;

/// The parts of the help.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum HelpSection {
    What,
    Words,
    Settings,
    Keys,
    Mouse,
    Paper,
    Licences,
}

const SECTIONS: [(HelpSection, &str); 7] = [
    (HelpSection::What, "What is this?"),
    (HelpSection::Words, "Words"),
    (HelpSection::Settings, "Settings"),
    (HelpSection::Keys, "Keys"),
    (HelpSection::Mouse, "Mouse"),
    (HelpSection::Paper, "Paper"),
    (HelpSection::Licences, "Licences"),
];

const MOUSE: [(&str, &str); 12] = [
    ("Point at something in a view", "read what it is, where and when"),
    ("Click in a view", "follow that point"),
    ("Shift-click", "compare one more point"),
    ("Drag in a view", "look around"),
    ("Scroll over a view", "zoom"),
    ("Double-click in a view", "frame the whole scene again"),
    ("Click or drag in a plot, on a worldline", "go to that T"),
    ("Scroll, right-drag, double-click in a plot", "zoom, move, show all of it"),
    ("Shift-click in a plot", "set a cursor; two show the difference"),
    ("Point at a plot", "read the curves there"),
    ("Click in the map", "follow that point"),
    ("Drag, scroll, double-click in the map", "move, zoom, fit it"),
];

/// Keys in a view that was reached with the tabulator.
const IN_A_VIEW: [(&str, &str); 4] = [
    ("Tab, Shift+Tab", "to the next control or view, or the one before"),
    ("← → ↑ ↓ in a view", "look around"),
    ("Enter in a view", "follow the next body; with Shift the one before"),
    ("Space on a control", "press it; arrows move a slider"),
];

/// Shows the help, if it is open.
pub fn show(ctx: &Context, state: &State, commands: &mut Commands) {
    if state.session.overlay != Some(Overlay::Help) {
        return;
    }
    let id = Id::unique("help");
    let mut shown = ctx.data(|data| data.get_temp(id)).unwrap_or(HelpSection::What);
    let room = ctx.content_rect().size() - AROUND.into();
    let size = vec2(SIZE[0].min(room.x), SIZE[1].min(room.y)).max(vec2(1.0, 1.0));
    show_overlay(ctx, "Help", Overlay::Help, commands, |ui, _| {
        ui.set_width(size.x);
        ui.horizontal_wrapped(|ui| {
            for (section, name) in SECTIONS {
                ui.selectable_value(&mut shown, section, name);
            }
        });
        ui.separator();
        let area = ScrollArea::both().id_salt(shown as usize).max_height(size.y).auto_shrink([false, false]);
        if shown == HelpSection::Licences {
            licences(ui, area);
        } else {
            area.scroll([false, true]).show(ui, |ui| section(ui, shown));
        }
    });
    ctx.data_mut(|data| data.insert_temp(id, shown));
}

fn section(ui: &mut Ui, section: HelpSection) {
    match section {
        HelpSection::What => paragraphs(ui, &WHAT),
        HelpSection::Words => markdown::show(ui, &GLOSSARY),
        HelpSection::Settings => settings(ui),
        HelpSection::Keys => {
            let with_keys = ACTIONS.iter().filter(|action| !action.keys.is_empty());
            table(ui, "keys", with_keys.map(|action| (action.keys_text(), action.name)));
            ui.separator();
            table(ui, "in a view", IN_A_VIEW.into_iter());
        }
        HelpSection::Mouse => table(ui, "mouse", MOUSE.into_iter()),
        HelpSection::Paper => {
            paragraphs(ui, &PAPER);
            ui.hyperlink(PAPER_ADDRESS);
        }
        HelpSection::Licences => {}
    }
}

/// Shows the lines of the notice of licences that are in sight.
fn licences(ui: &mut Ui, area: ScrollArea) {
    static LINES: OnceLock<Vec<&str>> = OnceLock::new();
    let then = ui.ctx().clone();
    let Some(notices) = NOTICES.bytes(move || then.request_repaint()) else {
        ui.label(OWN_LICENCE);
        ui.label(format!("The licences of what it is made of are beside the page, in {}.", NOTICES.place));
        return;
    };
    let lines = LINES.get_or_init(|| {
        [OWN_LICENCE, ""].into_iter().chain(str::from_utf8(notices).unwrap_or_default().lines()).collect()
    });
    let height = ui.text_style_height(&TextStyle::Body);
    area.show_rows(ui, height, lines.len(), |ui, rows| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        for line in &lines[rows] {
            ui.label(*line);
        }
    });
}

/// Shows every setting by its name, which the palette, the command line and files have in common.
fn settings(ui: &mut Ui) {
    let key = keys_of(&[Command::Window(WindowCommand::Toggle(Overlay::Palette))]);
    ui.label(format!(
        "The palette ({key}) sets them: type a name and a value, such as “beta 0.99” or “sky off”. On the command line they \
        are flags (--beta 0.99), and in a state's file the same words (beta = 0.99). Scene, time and points are chosen in the \
        window itself."
    ));
    for headed in about_all().chunk_by(|before, after| before.section == after.section) {
        let section = headed[0].section;
        ui.add_space(6.0);
        ui.label(RichText::new(if section.is_empty() { "Scene and points" } else { section }).weak());
        table(ui, section, headed.iter().map(|about| (about.name, about.sentence.as_str())));
    }
}

fn paragraphs(ui: &mut Ui, texts: &[&str]) {
    for text in texts {
        ui.label(*text);
        ui.add_space(6.0);
    }
}

fn table(ui: &mut Ui, id: &str, rows: impl Iterator<Item = (impl Into<String>, &'static str)>) {
    let width = (ui.available_width() - CAUSES - 16.0).max(1.0);
    Grid::new(id).num_columns(2).spacing([16.0, 6.0]).show(ui, |ui| {
        for (cause, effect) in rows {
            cell(ui, CAUSES, RichText::new(cause).strong());
            cell(ui, width, RichText::new(effect));
            ui.end_row();
        }
    });
}

/// `text`, wrapped to a `width`.
fn cell(ui: &mut Ui, width: f32, text: RichText) {
    ui.scope(|ui| {
        ui.set_width(width);
        ui.add(Label::new(text).wrap());
    });
}
