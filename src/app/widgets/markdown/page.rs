//! Blocks below each other.

use eframe::egui::{
    Color32, FontId, Pos2, Rect, Shape, epaint::CornerRadius, epaint::text::FontsView, pos2, vec2,
};

use super::blocks::{Blocks, InlineItem, TextBlock, WordKind, WordStyle};
use super::ink::TextInk;
use super::paragraph::{Paragraph, Side, lay_out};
use crate::app::widgets::formula::Pixels;

/// The setting of a page: its fonts, and its width.
#[derive(Debug, Clone, PartialEq)]
pub struct PageSetting {
    pub width: f32,
    pub pixels_per_point: f32,
    pub ink: TextInk,
    pub title_size: f32,
    pub line: Color32,
    pub background: Color32,
}

/// A paragraph, a title or a row of a table on a page.
#[derive(Debug)]
pub struct PageItem {
    pub rect: Rect,
    pub shapes: Vec<Shape>,
    pub links: Vec<(Rect, usize)>,
    pub text: String,
    pub is_title: bool,
}

/// Parts of the page, from its upper left corner.
#[derive(Debug)]
pub struct Page {
    pub height: f32,
    pub parts: Vec<PageItem>,
}

/// `blocks` on a page.
pub fn lay_out_page(fonts: &mut FontsView<'_>, setting: &PageSetting, blocks: &Blocks) -> Page {
    let pixels = Pixels { per_point: setting.pixels_per_point };
    let mut writer = Writer { fonts, pixels, setting, parts: Vec::new(), y: 0.0 };
    writer.blocks(&blocks.blocks, 0.0, false);
    Page { height: writer.y, parts: writer.parts }
}

/// A page that is being written.
pub struct Writer<'a, 'f> {
    pub fonts: &'a mut FontsView<'f>,
    pub pixels: Pixels,
    pub setting: &'a PageSetting,
    parts: Vec<PageItem>,
    /// Top of the next block.
    y: f32,
}

impl Writer<'_, '_> {
    pub fn size(&self) -> f32 {
        self.setting.ink.font.size
    }

    fn gap(&mut self, sizes: f32) {
        self.y += self.pixels.nearest(sizes * self.size());
    }

    fn blocks(&mut self, blocks: &[TextBlock], left: f32, is_tight: bool) {
        for (index, block) in blocks.iter().enumerate() {
            if index > 0 {
                self.gap(match block {
                    TextBlock::Title(..) => 1.0,
                    _ if is_tight => 0.25,
                    _ => 0.6,
                });
            }
            self.block(block, left);
        }
    }

    fn block(&mut self, block: &TextBlock, left: f32) {
        match block {
            TextBlock::Paragraph(pieces) => {
                let ink = self.setting.ink.clone();
                self.paragraph(pieces, &ink, left, None);
            }
            TextBlock::Title(level, pieces) => {
                let scale = [1.25, 1.0][(*level).clamp(1, 2) - 1];
                let size = if *level > 2 { self.size() } else { scale * self.setting.title_size };
                let ink = &self.setting.ink;
                let font = FontId::new(size, ink.font.family.clone());
                let ink = TextInk { font, text: ink.strong, ..ink.clone() };
                let strong = strong(pieces);
                self.paragraph(&strong, &ink, left, None);
                if let Some(part) = self.parts.last_mut() {
                    part.is_title = true;
                }
            }
            TextBlock::List(first, items) => self.list(*first, items, left),
            TextBlock::Table(alignments, rows) => self.table(alignments, rows, left),
            TextBlock::Code(code) => self.code(code, left),
            TextBlock::Quote(blocks) => {
                let top = self.y;
                let inner = self.pixels.nearest(left + self.size());
                self.blocks(blocks, inner, false);
                let bar = Rect::from_min_max(pos2(left, top), pos2(left + 2.0, self.y));
                self.push_shape(Shape::rect_filled(bar, CornerRadius::ZERO, self.setting.line));
            }
            TextBlock::Rule => {
                self.rule(left, self.room(left));
            }
        }
    }

    /// Adds a shape without words to the last part.
    fn push_shape(&mut self, shape: Shape) {
        let rect = shape.visual_bounding_rect();
        match self.parts.last_mut() {
            Some(part) => {
                part.rect |= rect;
                part.shapes.push(shape);
            }
            None => self.parts.push(PageItem {
                rect,
                shapes: vec![shape],
                links: Vec::new(),
                text: String::new(),
                is_title: false,
            }),
        }
    }

    pub fn rule(&mut self, left: f32, width: f32) {
        let corner = pos2(left, self.y + self.pixels.nearest(0.2 * self.size()));
        let rect = Rect::from_min_size(corner, vec2(width, self.pixels.at_least(0.75)));
        self.push_shape(Shape::rect_filled(rect, CornerRadius::ZERO, self.setting.line));
        self.gap(0.4);
    }

    pub fn room(&self, left: f32) -> f32 {
        (self.setting.width - left).max(1.0)
    }

    /// Adds pieces in lines, with the text before them at the same height, if there is one, and where it
    /// ends.
    fn paragraph(&mut self, pieces: &[InlineItem], ink: &TextInk, left: f32, before: Option<(&str, f32)>) {
        let room = self.room(left);
        let mut laid = lay_out(self.fonts, self.pixels, ink, pieces, (room, Side::Left));
        if let Some((text, end)) = before {
            let mark = [InlineItem::Word(text.to_owned(), WordStyle::default())];
            let mark = lay_out(self.fonts, self.pixels, ink, &mark, (f32::INFINITY, Side::Left));
            let at = vec2(end - mark.size.x - left, laid.baseline - mark.baseline);
            let at = vec2(self.pixels.nearest(at.x), at.y);
            laid.shapes.extend(mark.shapes.into_iter().map(|shape| translated(shape, at)));
            if text != BULLET {
                laid.text = format!("{text} {}", laid.text);
            }
        }
        self.add(laid, left);
    }

    pub fn add(&mut self, laid: Paragraph, left: f32) {
        let at = pos2(left, self.y);
        let by = at.to_vec2();
        self.y += laid.size.y;
        self.parts.push(PageItem {
            rect: Rect::from_min_size(at, laid.size),
            shapes: laid.shapes.into_iter().map(|shape| translated(shape, by)).collect(),
            links: laid.links.into_iter().map(|(rect, link)| (rect.translate(by), link)).collect(),
            text: laid.text,
            is_title: false,
        });
    }

    fn list(&mut self, first: Option<u64>, items: &[Vec<TextBlock>], left: f32) {
        let end = left + 1.1 * self.size();
        let inner = self.pixels.nearest(left + 1.6 * self.size());
        for (index, item) in items.iter().enumerate() {
            if index > 0 {
                self.gap(0.3);
            }
            let mark = first.map_or_else(|| BULLET.to_owned(), |first| format!("{}.", first + index as u64));
            let mut rest = item.as_slice();
            let ink = self.setting.ink.clone();
            match item.split_first() {
                Some((TextBlock::Paragraph(pieces), others)) => {
                    self.paragraph(pieces, &ink, inner, Some((&mark, end)));
                    rest = others;
                }
                _ => self.paragraph(&[], &ink, inner, Some((&mark, end))),
            }
            if !rest.is_empty() {
                self.gap(0.3);
                self.blocks(rest, inner, true);
            }
        }
    }

    fn code(&mut self, code: &str, left: f32) {
        let look = WordStyle { kind: WordKind::Code, ..WordStyle::default() };
        let ink = TextInk { code_background: Color32::TRANSPARENT, ..self.setting.ink.clone() };
        let margin = self.pixels.nearest(0.5 * self.size());
        let pieces: Vec<InlineItem> = code
            .lines()
            .flat_map(|line| [InlineItem::Word(line.replace(' ', "\u{a0}"), look), InlineItem::Break])
            .collect();
        let room = self.room(left + 2.0 * margin);
        let mut laid = lay_out(self.fonts, self.pixels, &ink, &pieces, (room, Side::Left));
        let size = vec2(self.room(left), laid.size.y + 2.0 * margin);
        let inside = vec2(margin, margin);
        let paper = Shape::rect_filled(
            Rect::from_min_size(Pos2::ZERO, size),
            CornerRadius::same(4),
            self.setting.background,
        );
        let words = laid.shapes.into_iter().map(|shape| translated(shape, inside));
        laid.shapes = [paper].into_iter().chain(words).collect();
        laid.size = size;
        code.clone_into(&mut laid.text);
        self.add(laid, left);
    }
}

const BULLET: &str = "•";

/// `pieces` as a title has them.
fn strong(pieces: &[InlineItem]) -> Vec<InlineItem> {
    let mut pieces = pieces.to_vec();
    for piece in &mut pieces {
        if let InlineItem::Word(_, look) | InlineItem::Space(look) | InlineItem::Formula(_, look) = piece {
            look.is_strong = true;
        }
    }
    pieces
}

pub fn translated(mut shape: Shape, by: eframe::egui::Vec2) -> Shape {
    shape.translate(by);
    shape
}
