//! Words and formulas in lines, on common baselines.

use eframe::egui::{Rect, Shape, Vec2, epaint::text::FontsView, pos2, vec2};

use super::blocks::{InlineItem, WordStyle};
use super::ink::{TextInk, job};
use super::lines::{LineFragment, TextLine, joined, lines};
use crate::app::widgets::formula::{self, Pixels};

/// Room between lines, and above and below displayed formulas, in sizes of the text.
const LEADING: f32 = 0.25;
const DISPLAYED_GAP: f32 = 0.5;

/// The alignment of lines in their room.
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
    /// Places of links, and their numbers.
    pub links: Vec<(Rect, usize)>,
    /// Words of the paragraph.
    pub text: String,
}

/// `pieces` in lines no wider than `room`.
pub fn lay_out(
    fonts: &mut FontsView<'_>,
    pixels: Pixels,
    ink: &TextInk,
    pieces: &[InlineItem],
    (room, side): (f32, Side),
) -> Paragraph {
    let lines = lines(fonts, ink, pieces, room);
    drawn(fonts, pixels, ink, lines, said(pieces), (room, side))
}

/// Returns the words of `pieces`.
fn said(pieces: &[InlineItem]) -> String {
    let mut text = String::new();
    for piece in pieces {
        match piece {
            InlineItem::Word(word, _) => text.push_str(word),
            InlineItem::Formula(formula, _) => text.push_str(&formula.words),
            InlineItem::Space(_) | InlineItem::Break => text.push(' '),
            InlineItem::Displayed(formula, ..) => {
                text.push(' ');
                text.push_str(&formula.words);
                text.push(' ');
            }
            InlineItem::Chance => {}
        }
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn drawn(
    fonts: &mut FontsView<'_>,
    pixels: Pixels,
    ink: &TextInk,
    lines: Vec<TextLine>,
    text: String,
    (room, side): (f32, Side),
) -> Paragraph {
    let row = fonts.row_height(&ink.font);
    let galley = fonts.layout_job(job("x", ink.format(WordStyle::default())));
    let glyph = galley.rows.first().and_then(|row| row.glyphs.first());
    let ascent = pixels.nearest(glyph.map_or(0.8 * row, |glyph| glyph.font_ascent));
    let descent = pixels.at_least(row - ascent);
    let size = ink.font.size;
    let mut paragraph =
        Paragraph { size: Vec2::ZERO, baseline: ascent, shapes: Vec::new(), links: Vec::new(), text };
    let mut y = 0.0;
    let mut is_after_displayed = false;
    for (index, line) in lines.into_iter().enumerate() {
        let reach = reach_of(&line, [ascent, descent]);
        let gap = if line.is_displayed || is_after_displayed { DISPLAYED_GAP } else { LEADING };
        if index > 0 {
            y += pixels.nearest(gap * size);
        }
        is_after_displayed = line.is_displayed;
        let baseline = pixels.at_least(y + reach[0]);
        if index == 0 {
            paragraph.baseline = baseline;
        }
        let left = inset(&line, room, side);
        paragraph.size.x = paragraph.size.x.max(left + line.width);
        let bottom = pixels.at_least(baseline + reach[1]);
        let mut x = left;
        for part in joined(line.parts) {
            let width = part.width();
            let look = draw(fonts, pixels, ink, part, [x, baseline], &mut paragraph.shapes);
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

/// Returns the reach of a line above and below its baseline; text has this one.
fn reach_of(line: &TextLine, of_text: [f32; 2]) -> [f32; 2] {
    let mut reach = if line.is_displayed { [0.0; 2] } else { of_text };
    for part in &line.parts {
        if let LineFragment::Formula { formula, em, .. } = part {
            reach = [reach[0].max(em * formula.ascent), reach[1].max(em * formula.descent)];
        }
    }
    reach
}

/// Returns the room to the left of a line.
fn inset(line: &TextLine, room: f32, side: Side) -> f32 {
    let left = match (line.is_displayed, side) {
        (true, _) | (_, Side::Middle) => (room - line.width).max(0.0) / 2.0,
        (false, Side::Left) => 0.0,
        (false, Side::Right) => (room - line.width).max(0.0),
    };
    if left.is_finite() { left } else { 0.0 }
}

/// Adds a part of a line to `shapes`, from `x` on; returns its style.
fn draw(
    fonts: &mut FontsView<'_>,
    pixels: Pixels,
    ink: &TextInk,
    part: LineFragment,
    [x, baseline]: [f32; 2],
    shapes: &mut Vec<Shape>,
) -> WordStyle {
    match part {
        LineFragment::Word { text, look, .. } => {
            let format = ink.format(look);
            let at = pos2(x, baseline);
            shapes.extend(formula::text(fonts, pixels, &text, at, format.clone()));
            if look.is_strong {
                let at = at + vec2(0.035 * ink.font.size, 0.0);
                shapes.extend(formula::text(fonts, pixels, &text, at, format));
            }
            look
        }
        LineFragment::Formula { formula, look, em } => {
            let colour = ink.format(look).color;
            formula::draw(fonts, pixels, &formula, [em, x, baseline], colour, shapes);
            look
        }
    }
}
