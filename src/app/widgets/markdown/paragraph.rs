//! Words and formulas in lines, on common baselines.

use std::sync::Arc;

use eframe::egui::{
    Color32, FontId, Rect, Shape, TextFormat, Vec2,
    epaint::text::{FontsView, LayoutJob},
    pos2, vec2,
};

use super::blocks::{Kind, Look, Piece};
use crate::app::widgets::formula::{self, Pixels};
use crate::formula::{EM, Formula};

/// Room between lines, and above and below displayed formulas, in sizes of the text.
const LEADING: f32 = 0.25;
const DISPLAYED_GAP: f32 = 0.5;

/// What words are written with.
#[derive(Debug, Clone, PartialEq)]
pub struct Ink {
    pub font: FontId,
    pub code_font: FontId,
    pub text: Color32,
    pub strong: Color32,
    pub link: Color32,
    pub wrong: Color32,
    pub code_background: Color32,
}

impl Ink {
    fn format(&self, look: Look) -> TextFormat {
        let color = match look {
            Look { kind: Kind::Wrong, .. } => self.wrong,
            Look { link: Some(_), .. } => self.link,
            Look { is_strong: true, .. } => self.strong,
            _ => self.text,
        };
        let (font_id, background) = match look.kind {
            Kind::Words => (self.font.clone(), Color32::TRANSPARENT),
            Kind::Code | Kind::Wrong => (self.code_font.clone(), self.code_background),
        };
        TextFormat { italics: look.is_slanted, background, ..TextFormat::simple(font_id, color) }
    }
}

/// Where lines stand in their room.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    Left,
    Middle,
    Right,
}

/// Lines, from their upper left corner.
#[derive(Debug)]
pub struct Paragraph {
    pub size: Vec2,
    /// Height of the first line's baseline below the top.
    pub baseline: f32,
    pub shapes: Vec<Shape>,
    /// Where links are, and their numbers.
    pub links: Vec<(Rect, usize)>,
    /// All that it says.
    pub text: String,
}

/// `pieces` in lines no wider than `room`.
pub fn lay_out(
    fonts: &mut FontsView<'_>,
    pixels: Pixels,
    ink: &Ink,
    pieces: &[Piece],
    (room, side): (f32, Side),
) -> Paragraph {
    let mut setter = Setter { fonts, ink, room, lines: Vec::new(), line: Line::default() };
    let mut cluster = Vec::new();
    for piece in pieces {
        match piece {
            Piece::Word(word, look) => cluster.push(setter.word(word, *look)),
            Piece::Formula(formula, look) => cluster.push(setter.formula(formula, *look)),
            Piece::Space(look) => {
                setter.place(&mut cluster);
                let space = setter.word(" ", *look);
                setter.line.spaces.push(space);
            }
            Piece::Chance => setter.place(&mut cluster),
            Piece::Break => {
                setter.place(&mut cluster);
                setter.end_line();
            }
            Piece::Displayed(formula, look) => {
                setter.place(&mut cluster);
                setter.end_line_if_any();
                let formula = setter.formula(formula, *look);
                setter.line.is_displayed = true;
                setter.line.put(formula);
                setter.end_line();
            }
        }
    }
    setter.place(&mut cluster);
    setter.end_line_if_any();
    let (lines, text) = (setter.lines, said(pieces));
    drawn(fonts, pixels, ink, lines, text, (room, side))
}

/// What `pieces` say.
fn said(pieces: &[Piece]) -> String {
    let mut text = String::new();
    for piece in pieces {
        match piece {
            Piece::Word(word, _) => text.push_str(word),
            Piece::Formula(formula, _) => text.push_str(&formula.words),
            Piece::Space(_) | Piece::Break => text.push(' '),
            Piece::Displayed(formula, _) => {
                text.push(' ');
                text.push_str(&formula.words);
                text.push(' ');
            }
            Piece::Chance => {}
        }
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What stands in a line.
#[derive(Debug, Clone)]
enum Part {
    Word { text: String, look: Look, width: f32 },
    Formula { formula: Arc<Formula>, look: Look, em: f32 },
}

impl Part {
    fn width(&self) -> f32 {
        match self {
            Self::Word { width, .. } => *width,
            Self::Formula { formula, em, .. } => em * formula.width,
        }
    }
}

#[derive(Debug, Default)]
struct Line {
    parts: Vec<Part>,
    /// Spaces that are there only if something follows.
    spaces: Vec<Part>,
    width: f32,
    is_displayed: bool,
}

impl Line {
    fn put(&mut self, part: Part) {
        for space in self.spaces.drain(..).chain([part]) {
            self.width += space.width();
            self.parts.push(space);
        }
    }
}

struct Setter<'a, 'f> {
    fonts: &'a mut FontsView<'f>,
    ink: &'a Ink,
    room: f32,
    lines: Vec<Line>,
    line: Line,
}

impl Setter<'_, '_> {
    fn word(&mut self, text: &str, look: Look) -> Part {
        let width = width(self.fonts, text, self.ink.format(look));
        Part::Word { text: text.to_owned(), look, width }
    }

    /// A formula, smaller if it would not fit into a line.
    fn formula(&self, formula: &Arc<Formula>, look: Look) -> Part {
        let em = EM * self.ink.font.size;
        let fitting = if em * formula.width > self.room { self.room / formula.width } else { em };
        Part::Formula { formula: formula.clone(), look, em: fitting }
    }

    /// Puts what belongs together into this line if it fits, else into the next.
    fn place(&mut self, cluster: &mut Vec<Part>) {
        let width: f32 = cluster.iter().map(Part::width).sum();
        let spaces: f32 = self.line.spaces.iter().map(Part::width).sum();
        if self.line.width + spaces + width <= self.room || cluster.is_empty() {
            cluster.drain(..).for_each(|part| self.line.put(part));
            return;
        }
        self.end_line_if_any();
        if width <= self.room {
            cluster.drain(..).for_each(|part| self.line.put(part));
            return;
        }
        for part in cluster.drain(..) {
            if self.line.width + part.width() <= self.room {
                self.line.put(part);
                continue;
            }
            match part {
                Part::Word { text, look, .. } => self.part(&text, look),
                Part::Formula { .. } => {
                    self.end_line_if_any();
                    self.line.put(part);
                }
            }
        }
    }

    /// Puts a word that no line can hold into as many as it takes.
    fn part(&mut self, text: &str, look: Look) {
        for character in text.chars() {
            let part = self.word(character.encode_utf8(&mut [0; 4]), look);
            if self.line.width + part.width() > self.room {
                self.end_line_if_any();
            }
            self.line.put(part);
        }
    }

    fn end_line(&mut self) {
        self.lines.push(std::mem::take(&mut self.line));
    }

    fn end_line_if_any(&mut self) {
        self.line.spaces.clear();
        if !self.line.parts.is_empty() {
            self.end_line();
        }
    }
}

fn job(text: &str, format: TextFormat) -> LayoutJob {
    LayoutJob {
        break_on_newline: false,
        round_output_to_gui: false,
        ..LayoutJob::single_section(text.to_owned(), format)
    }
}

fn width(fonts: &mut FontsView<'_>, text: &str, format: TextFormat) -> f32 {
    fonts.layout_job(job(text, format)).intrinsic_size().x
}

/// The parts of a line, neighbours that look alike as one.
fn joined(parts: Vec<Part>) -> Vec<Part> {
    let mut joined: Vec<Part> = Vec::new();
    for part in parts {
        match (joined.last_mut(), part) {
            (Some(Part::Word { text, look, width }), Part::Word { text: next, look: same, width: more })
                if *look == same =>
            {
                text.push_str(&next);
                *width += more;
            }
            (_, part) => joined.push(part),
        }
    }
    joined
}

fn drawn(
    fonts: &mut FontsView<'_>,
    pixels: Pixels,
    ink: &Ink,
    lines: Vec<Line>,
    text: String,
    (room, side): (f32, Side),
) -> Paragraph {
    let row = fonts.row_height(&ink.font);
    let galley = fonts.layout_job(job("x", ink.format(Look::default())));
    let glyph = galley.rows.first().and_then(|row| row.glyphs.first());
    let ascent = pixels.nearest(glyph.map_or(0.8 * row, |glyph| glyph.font_ascent));
    let descent = pixels.at_least(row - ascent);
    let size = ink.font.size;
    let mut paragraph =
        Paragraph { size: Vec2::ZERO, baseline: ascent, shapes: Vec::new(), links: Vec::new(), text };
    let mut y = 0.0;
    let mut is_after_displayed = false;
    for (index, line) in lines.into_iter().enumerate() {
        let mut reach = if line.is_displayed { [0.0; 2] } else { [ascent, descent] };
        for part in &line.parts {
            if let Part::Formula { formula, em, .. } = part {
                reach = [reach[0].max(em * formula.ascent), reach[1].max(em * formula.descent)];
            }
        }
        let gap = if line.is_displayed || is_after_displayed { DISPLAYED_GAP } else { LEADING };
        if index > 0 {
            y += pixels.nearest(gap * size);
        }
        is_after_displayed = line.is_displayed;
        let baseline = pixels.at_least(y + reach[0]);
        if index == 0 {
            paragraph.baseline = baseline;
        }
        let left = match (line.is_displayed, side) {
            (true, _) | (_, Side::Middle) => (room - line.width).max(0.0) / 2.0,
            (false, Side::Left) => 0.0,
            (false, Side::Right) => (room - line.width).max(0.0),
        };
        let left = if left.is_finite() { left } else { 0.0 };
        paragraph.size.x = paragraph.size.x.max(left + line.width);
        let bottom = pixels.at_least(baseline + reach[1]);
        let mut x = left;
        for part in joined(line.parts) {
            let width = part.width();
            let look = match part {
                Part::Word { text, look, .. } => {
                    let format = ink.format(look);
                    let bolder = if look.is_strong { 0.035 * size } else { 0.0 };
                    let at = pos2(x, baseline);
                    paragraph.shapes.extend(formula::text(fonts, pixels, &text, at, format.clone()));
                    if look.is_strong {
                        let at = at + vec2(bolder, 0.0);
                        paragraph.shapes.extend(formula::text(fonts, pixels, &text, at, format));
                    }
                    look
                }
                Part::Formula { formula, look, em } => {
                    let colour = ink.format(look).color;
                    formula::draw(fonts, pixels, &formula, [em, x, baseline], colour, &mut paragraph.shapes);
                    look
                }
            };
            if let Some(link) = look.link {
                let rect = Rect::from_min_max(pos2(x, baseline - reach[0]), pos2(x + width, bottom));
                paragraph.links.push((rect, link));
            }
            x += width;
        }
        y = bottom;
    }
    paragraph.size.y = y;
    paragraph
}
