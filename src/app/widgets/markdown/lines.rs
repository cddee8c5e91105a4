//! Words and formulas parted into lines.

use std::sync::Arc;

use eframe::egui::epaint::text::FontsView;

use super::blocks::{InlineItem, WordStyle};
use super::ink::{TextInk, width};
use crate::formula::{EM, Formula};

/// `pieces` in lines no wider than `room`.
pub fn lines(fonts: &mut FontsView<'_>, ink: &TextInk, pieces: &[InlineItem], room: f32) -> Vec<TextLine> {
    let mut setter = Setter { fonts, ink, room, lines: Vec::new(), line: TextLine::default() };
    let mut cluster = Vec::new();
    for piece in pieces {
        match piece {
            InlineItem::Word(word, look) => cluster.push(setter.word(word, *look)),
            InlineItem::Formula(formula, look) => cluster.push(formula_part(ink, room, formula, *look)),
            InlineItem::Space(look) => {
                setter.place(&mut cluster);
                let space = setter.word(" ", *look);
                setter.line.spaces.push(space);
            }
            InlineItem::Chance => setter.place(&mut cluster),
            InlineItem::Break => {
                setter.place(&mut cluster);
                setter.end_line();
            }
            InlineItem::Displayed(whole, parts, look) => {
                setter.place(&mut cluster);
                setter.end_line_if_any();
                let fits = EM * ink.font.size * whole.width <= room;
                for formula in if fits { std::slice::from_ref(whole) } else { parts } {
                    setter.line.is_displayed = true;
                    setter.line.put(formula_part(ink, room, formula, *look));
                    setter.end_line();
                }
            }
        }
    }
    setter.place(&mut cluster);
    setter.end_line_if_any();
    setter.lines
}

/// The least room in which no word and no formula is parted or shrinks.
pub fn least_room(fonts: &mut FontsView<'_>, ink: &TextInk, pieces: &[InlineItem]) -> f32 {
    let (mut widest, mut cluster) = (0.0_f32, 0.0);
    for piece in pieces {
        match piece {
            InlineItem::Word(word, look) => cluster += width(fonts, word, ink.format(*look)),
            InlineItem::Formula(formula, _) => cluster += EM * ink.font.size * formula.width,
            InlineItem::Displayed(..) | InlineItem::Space(_) | InlineItem::Chance | InlineItem::Break => {
                cluster = 0.0;
            }
        }
        widest = widest.max(cluster);
    }
    widest
}

/// A part of a line.
#[derive(Debug, Clone)]
pub enum LineFragment {
    Word { text: String, look: WordStyle, width: f32 },
    Formula { formula: Arc<Formula>, look: WordStyle, em: f32 },
}

impl LineFragment {
    pub fn width(&self) -> f32 {
        match self {
            Self::Word { width, .. } => *width,
            Self::Formula { formula, em, .. } => em * formula.width,
        }
    }
}

/// A formula, smaller if it would not fit into a line.
fn formula_part(ink: &TextInk, room: f32, formula: &Arc<Formula>, look: WordStyle) -> LineFragment {
    let em = EM * ink.font.size;
    let fitting = if em * formula.width > room { room / formula.width } else { em };
    LineFragment::Formula { formula: formula.clone(), look, em: fitting }
}

/// A line, before it is drawn.
#[derive(Debug, Default)]
pub struct TextLine {
    pub parts: Vec<LineFragment>,
    /// Spaces that are there only if something follows.
    spaces: Vec<LineFragment>,
    pub width: f32,
    /// Whether the line is a displayed formula, alone and in the middle.
    pub is_displayed: bool,
}

impl TextLine {
    fn put(&mut self, part: LineFragment) {
        for space in self.spaces.drain(..).chain([part]) {
            self.width += space.width();
            self.parts.push(space);
        }
    }
}

struct Setter<'a, 'f> {
    fonts: &'a mut FontsView<'f>,
    ink: &'a TextInk,
    room: f32,
    lines: Vec<TextLine>,
    line: TextLine,
}

impl Setter<'_, '_> {
    fn word(&mut self, text: &str, look: WordStyle) -> LineFragment {
        let width = width(self.fonts, text, self.ink.format(look));
        LineFragment::Word { text: text.to_owned(), look, width }
    }

    /// Puts what belongs together into this line if it fits, else into the next.
    fn place(&mut self, cluster: &mut Vec<LineFragment>) {
        let width: f32 = cluster.iter().map(LineFragment::width).sum();
        let spaces: f32 = self.line.spaces.iter().map(LineFragment::width).sum();
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
                LineFragment::Word { text, look, .. } => self.part(&text, look),
                LineFragment::Formula { .. } => {
                    self.end_line_if_any();
                    self.line.put(part);
                }
            }
        }
    }

    /// Puts a word that no line can hold into as many as it takes.
    fn part(&mut self, text: &str, look: WordStyle) {
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

/// The parts of a line, neighbours that look alike as one.
pub fn joined(parts: Vec<LineFragment>) -> Vec<LineFragment> {
    let mut joined: Vec<LineFragment> = Vec::new();
    for part in parts {
        match (joined.last_mut(), part) {
            (
                Some(LineFragment::Word { text, look, width }),
                LineFragment::Word { text: next, look: same, width: more },
            ) if *look == same => {
                text.push_str(&next);
                *width += more;
            }
            (_, part) => joined.push(part),
        }
    }
    joined
}
