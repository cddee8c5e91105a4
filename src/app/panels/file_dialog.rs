//! The small window that asks which file to open or to write.

use std::path::Path;

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::{Context, Key, RichText, TextEdit, Ui};

use super::{Commands, OnClick as _, middle_window};
use crate::app::commands::WindowCommand;
use crate::app::commands::file_dialog::Chooser;
use crate::app::state::State;
use crate::app::state::files::purpose::{Product, Purpose};
use crate::app::widgets::focus;
use crate::flags::choices::{Form, Size};
use crate::number_text;
use crate::studio::film::{FRAMES_PER_SECOND, FilmKind};

/// Width of the path, and room beside it, points.
const PATH_WIDTH: f32 = 440.0;
const MARGIN: f32 = 60.0;
/// Width of the size of a picture, points.
const SIZE_WIDTH: f32 = 90.0;

/// Shows it while a file is being chosen.
pub fn show(ctx: &Context, state: &State, chooser: &mut Chooser, commands: &mut Commands) {
    let Some(purpose) = chooser.purpose else { return };
    let width = PATH_WIDTH.min(ctx.content_rect().width() - MARGIN);
    middle_window(purpose.title()).show(ctx, |ui| {
        ui.set_width(width);
        let is_entered = path(ui, chooser);
        if let Purpose::Save(product) = purpose {
            product_settings(ui, state, product, chooser);
        }
        if let Some(remark) = &chooser.remark {
            ui.colored_label(ui.visuals().error_fg_color, remark);
        }
        ui.add_space(4.0);
        if chooser.replaced.is_some() {
            replace(ui, chooser, commands);
        } else {
            buttons(ui, purpose, chooser, is_entered, commands);
        }
    });
}

/// The path that is typed; whether Enter was pressed in it.
fn path(ui: &mut Ui, chooser: &mut Chooser) -> bool {
    let [from, to] = chooser.stem();
    let mut output = TextEdit::singleline(&mut chooser.path).desired_width(f32::INFINITY).show(ui);
    let response = output.response.response.clone().accessible_name("Path");
    focus::note_words(&response);
    if std::mem::take(&mut chooser.wants_focus) {
        response.request_focus();
        // What is typed takes the place of the name, not of the folder or the ending.
        let name = CCursorRange::two(CCursor::new(from), CCursor::new(to));
        output.state.cursor.set_char_range(Some(name));
        output.state.store(ui.ctx(), response.id);
    }
    if response.changed() {
        chooser.edited();
    }
    response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter))
}

/// Shows settings and remarks for the product that is saved.
fn product_settings(ui: &mut Ui, state: &State, product: Product, chooser: &mut Chooser) {
    if product.has_size() {
        ui.horizontal(|ui| {
            let tip = "Width x height of each eye's picture, at first as in the window.";
            ui.label("Size of a picture").on_hover_text(tip);
            let field = TextEdit::singleline(&mut chooser.size).desired_width(SIZE_WIDTH);
            let field = ui.add(field).on_hover_text(tip).accessible_name("Size of a picture");
            focus::note_words(&field);
            if field.changed() {
                chooser.edited();
            }
            ui.label("pixels");
        });
    }
    let text = match product {
        Product::Film => {
            let (_, frames) = state.film(product);
            let seconds = f64::from(frames) / f64::from(FRAMES_PER_SECOND);
            format!(
                "T runs through its range once: {frames} frames, {seconds:.1} s, about {} MB. A name that \
                    ends in {} gives an animation; one without an ending, a folder of pictures.",
                expected_megabytes(state, frames, chooser),
                FilmKind::NAMED_ENDINGS
            )
        }
        Product::TenSeconds => {
            let ([from, to], frames) = state.film(product);
            let unit = state.measures().time;
            format!(
                "{} = {} to {} in 10 s: {frames} frames, about {} MB. The name ends in {}.",
                state.clock().symbol,
                unit.number(from, 1),
                unit.text(to, 1),
                expected_megabytes(state, frames, chooser),
                FilmKind::NAMED_ENDINGS
            )
        }
        Product::Picture => "The picture records its state: opening it restores that.".to_owned(),
        Product::PlotsSvg => "The curves of the shown tab, as a drawing.".to_owned(),
        Product::PlotsCsv => "The curves of the shown tab, as a table.".to_owned(),
        Product::State => {
            "All settings, T and the selected point. Opening the file restores them.".to_owned()
        }
        Product::Scene => {
            "The scene in which the model rides, as text to edit. Its file stays in the folder of the model, or in one around that."
                .to_owned()
        }
        Product::Report => {
            "What was predicted and seen in each step of the lesson, as a page to print from a browser."
                .to_owned()
        }
        Product::Worksheet | Product::LabSheet | Product::TeachersPage => {
            "A page to print from a browser, the same as by `gamow lesson`.".to_owned()
        }
        Product::ClassPage => {
            "How often each answer was given, beside the truth: a page to print from a browser.".to_owned()
        }
        Product::Fit => "The numbers of the Fit tab, as `gamow fit --json` writes them.".to_owned(),
    };
    ui.label(RichText::new(text).weak());
}

/// The size of a film of this many `frames`, of the kind and with the pictures that are typed.
fn expected_megabytes(state: &State, frames: u32, chooser: &Chooser) -> String {
    let kind = FilmKind::from_path(Path::new(chooser.path.trim()));
    let (Some(kind), Ok(Size([width, height]))) = (kind, chooser.size.trim().parse()) else {
        return number_text::NONE.to_owned();
    };
    let pictures = match state.document.settings.picture.layout.form() {
        Form::Beside | Form::Above => 2.0,
        Form::One(_) | Form::Composed(_) | Form::InTurn => 1.0,
    };
    let pixels = pictures * f64::from(width) * f64::from(height);
    number_text::significant(kind.typical_bytes(frames, pixels) / 1e6, 1)
}

fn buttons(ui: &mut Ui, purpose: Purpose, chooser: &mut Chooser, is_entered: bool, commands: &mut Commands) {
    ui.horizontal(|ui| {
        let name = if matches!(purpose, Purpose::Save(_)) { "Save" } else { "Open" };
        if ui.button(RichText::new(name).strong()).clicked() || is_entered {
            commands.extend(chooser.confirmed(None));
            chooser.wants_focus = chooser.remark.is_some();
        }
        let has_dialog = chooser.has_dialog();
        ui.add_enabled_ui(has_dialog && !chooser.is_browsing(), |ui| {
            if ui.button("Browse…").on_hover_text("Opens the system's file dialog.").clicked() {
                chooser.browse(ui.ctx());
            }
        });
        ui.button("Cancel").on_click(commands, WindowCommand::Close);
    });
}

/// Asks whether what is there already may be replaced.
fn replace(ui: &mut Ui, chooser: &mut Chooser, commands: &mut Commands) {
    let Some(path) = chooser.replaced.clone() else { return };
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    ui.label(format!("{name} exists already."));
    ui.horizontal(|ui| {
        let replace = ui.button(RichText::new("Replace it").strong());
        if ui.memory(|memory| memory.focused().is_none()) {
            replace.request_focus();
        }
        if replace.clicked() {
            commands.extend(chooser.confirmed(Some(&path)));
        }
        ui.button("Cancel").on_click(commands, WindowCommand::Close);
    });
}
