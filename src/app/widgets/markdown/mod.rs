//! Markdown with formulas in the window.

mod blocks;
mod ink;
mod lines;
mod page;
mod paragraph;
mod table;
#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::sync::Arc;

use eframe::egui::{
    self, CursorIcon, Galley, Id, OpenUrl, Pos2, Rect, Sense, TextStyle, Ui, WidgetInfo, accesskit::Role,
    cache::CacheTrait, vec2,
};

use self::blocks::Blocks;
use self::ink::TextInk;
use self::page::{Page, PageSetting, lay_out_page, translated};

use crate::app::widgets::formula::Pixels;
use crate::formula::markdown::Markdown;

/// Draws Markdown in the width there is. Each paragraph and each row of a table is a label for assistive
/// technology, with its formulas in words.
pub fn show(ui: &mut Ui, text: &Markdown) {
    let setting = setting(ui);
    let pixels = Pixels { per_point: setting.pixels_per_point };
    let written = written(ui.ctx(), text, &setting);
    let (id, rect) = ui.allocate_space(vec2(setting.width, written.page.height));
    let corner = Pos2::new(pixels.nearest(rect.min.x), pixels.nearest(rect.min.y)).to_vec2();
    for (index, part) in written.page.parts.iter().enumerate() {
        let rect = part.rect.translate(corner);
        if !part.text.is_empty() {
            let role = if part.is_title { Role::Heading } else { Role::Label };
            let response = ui.interact(rect, id.with(index), Sense::hover());
            response.widget_info(|| WidgetInfo::labeled(role, ui.is_enabled(), &part.text));
        }
        if ui.is_rect_visible(rect) {
            ui.painter().extend(part.shapes.iter().map(|shape| translated(shape.clone(), corner)));
        }
        for (number, (rect, link)) in part.links.iter().enumerate() {
            let address = &written.links[*link];
            show_link(ui, rect.translate(corner), id.with((index, number)), address);
        }
    }
}

/// Returns the words of the Markdown, with its formulas spoken: a name for assistive technology.
#[must_use]
pub fn said(ui: &Ui, text: &Markdown) -> String {
    let written = written(ui.ctx(), text, &setting(ui));
    let parts = written.page.parts.iter().map(|part| part.text.as_str());
    parts.filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" ")
}

fn show_link(ui: &Ui, rect: Rect, id: Id, address: &str) {
    let response = ui.interact(rect, id, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Link, ui.is_enabled(), address));
    if response.hovered() || response.has_focus() {
        ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
        let colour = ui.visuals().hyperlink_color;
        ui.painter().hline(rect.x_range(), rect.max.y - 1.0, (1.0, colour));
    }
    if response.clicked() {
        ui.ctx().open_url(OpenUrl::new_tab(address));
    }
    response.on_hover_text(address);
}

fn setting(ui: &Ui) -> PageSetting {
    let (style, visuals) = (ui.style(), ui.visuals());
    let ink = TextInk {
        font: TextStyle::Body.resolve(style),
        code_font: TextStyle::Monospace.resolve(style),
        text: visuals.text_color(),
        strong: visuals.strong_text_color(),
        link: visuals.hyperlink_color,
        wrong: visuals.error_fg_color,
        code_background: visuals.code_bg_color,
    };
    PageSetting {
        width: ui.available_width(),
        pixels_per_point: ui.ctx().pixels_per_point(),
        ink,
        title_size: TextStyle::Heading.resolve(style).size,
        line: visuals.widgets.noninteractive.bg_stroke.color,
        background: visuals.code_bg_color,
    }
}

/// A text on a page.
#[derive(Debug)]
struct WrittenText {
    page: Page,
    links: Vec<String>,
    setting: PageSetting,
    /// A word as the fonts first laid it out: another layout of it means that they have been replaced.
    word: Arc<Galley>,
}

/// Pages that were shown in this frame or the last, by their texts and widths.
#[derive(Debug, Default)]
struct Pages {
    pages: HashMap<Id, (u64, Arc<WrittenText>)>,
    frame: u64,
}

impl CacheTrait for Pages {
    fn update(&mut self) {
        let frame = self.frame;
        self.pages.retain(|_, (used, _)| *used == frame);
        self.frame += 1;
    }

    fn len(&self) -> usize {
        self.pages.len()
    }
}

/// `text` on a page, as it was written before if it can be.
fn written(ctx: &egui::Context, text: &Markdown, setting: &PageSetting) -> Arc<WrittenText> {
    let id = Id::unique((text.source(), setting.width.to_bits()));
    let word = ctx
        .fonts_mut(|fonts| fonts.layout_no_wrap("x".to_owned(), setting.ink.font.clone(), setting.ink.text));
    let known = ctx.memory_mut(|memory| {
        let pages = memory.caches.cache::<Pages>();
        let frame = pages.frame;
        pages.pages.get_mut(&id).map(|(used, written)| {
            *used = frame;
            written.clone()
        })
    });
    if let Some(known) = known
        && known.setting == *setting
        && Arc::ptr_eq(&known.word, &word)
    {
        return known;
    }
    let blocks = Blocks::new(text);
    let page = ctx.fonts_mut(|fonts| lay_out_page(fonts, setting, &blocks));
    let written = Arc::new(WrittenText { page, links: blocks.links, setting: setting.clone(), word });
    ctx.memory_mut(|memory| {
        let pages = memory.caches.cache::<Pages>();
        pages.pages.insert(id, (pages.frame, written.clone()));
    });
    written
}
