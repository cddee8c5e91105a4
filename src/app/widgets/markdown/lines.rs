//! Words and formulas parted into lines.

use std::sync::Arc;

use eframe::egui::epaint::text::FontsView;

use super::blocks::{Piece, WordStyle};
use super::ink::{Ink, width};
use crate::formula::{EM, Formula};

/// `pieces` in lines no wider than `room`.
pub fn lines(fonts: &mut FontsView<'_>, ink: &Ink, pieces: &[Piece], room: f32) -> Vec<Line> {
    let mut setter = Setter { fonts, ink, room, lines: Vec::new(), line: Line::default() };
    let mut cluster = Vec::new();
    for piece in pieces {
        match piece {
            Piece::Word(word, look) => cluster.push(setter.word(word, *look)),
            Piece::Formula(formula, look) => cluster.push(formula_part(ink, room, formula, *look)),
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
            Piece::Displayed(whole, parts, look) => {
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
pub fn least_room(fonts: &mut FontsView<'_>, ink: &Ink, pieces: &[Piece]) -> f32 {
    let (mut widest, mut cluster) = (0.0_f32, 0.0);
    for piece in pieces {
        match piece {
            Piece::Word(word, look) => cluster += width(fonts, word, ink.format(*look)),
            Piece::Formula(formula, _) => cluster += EM * ink.font.size * formula.width,
            Piece::Displayed(..) | Piece::Space(_) | Piece::Chance | Piece::Break => cluster = 0.0,
        }
        widest = widest.max(cluster);
    }
    widest
}

/// A part of a line.
#[derive(Debug, Clone)]
pub enum Part {
    Word { text: String, look: WordStyle, width: f32 },
    Formula { formula: Arc<Formula>, look: WordStyle, em: f32 },
}

impl Part {
    pub fn width(&self) -> f32 {
        match self {
            Self::Word { width, .. } => *width,
            Self::Formula { formula, em, .. } => em * formula.width,
        }
    }
}

/// A formula, smaller if it would not fit into a line.
fn formula_part(ink: &Ink, room: f32, formula: &Arc<Formula>, look: WordStyle) -> Part {
    let em = EM * ink.font.size;
    let fitting = if em * formula.width > room { room / formula.width } else { em };
    Part::Formula { formula: formula.clone(), look, em: fitting }
}

/// A line, before it is drawn.
#[derive(Debug, Default)]
pub struct Line {
    pub parts: Vec<Part>,
    /// Spaces that are there only if something follows.
    spaces: Vec<Part>,
    pub width: f32,
    /// Whether the line is a displayed formula, alone and in the middle.
    pub is_displayed: bool,
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
    fn word(&mut self, text: &str, look: WordStyle) -> Part {
        let width = width(self.fonts, text, self.ink.format(look));
        Part::Word { text: text.to_owned(), look, width }
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
pub fn joined(parts: Vec<Part>) -> Vec<Part> {
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
