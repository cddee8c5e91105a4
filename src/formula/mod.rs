//! Formulas in TeX: what they are made of, as window and page draw them, and what is wrong with them.
//!
//! `RaTeX`, a port of `KaTeX`, reads and lays out. Lengths are in em of the formula; x is to the right, y
//! down, from the start of the baseline.

mod faces;
pub mod markdown;
pub mod outlines;
mod svg;
#[cfg(test)]
mod tests;
mod words;

use gamow_platform::{messages, sizes};
use ratex_layout::LayoutOptions;
use ratex_parser::ParseNode;
use ratex_types::MathStyle;
use ratex_types::display_item::DisplayItem;
use ratex_types::path_command::PathCommand;

pub use self::faces::FontFace;

/// Size of a formula's em in that of the text around it: TeX's letters are small beside those of screens.
pub const EM: f32 = 1.1;

/// The style of a formula, by the room it has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Style {
    /// In a line of text.
    Inline,
    /// On lines of its own.
    Displayed,
}

/// An error in a formula, in one line.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the formula ${tex}$ cannot be drawn: {reason}")]
pub struct FormulaError {
    tex: String,
    reason: String,
}

/// A formula, laid out.
#[derive(Debug, Clone, PartialEq)]
pub struct Formula {
    /// Formula in words and characters, for assistive technology.
    pub words: String,
    /// Width of the formula, em.
    pub width: f32,
    /// Reach above the baseline, em.
    pub ascent: f32,
    /// Reach below the baseline, em.
    pub descent: f32,
    /// Marks that draw the formula.
    pub marks: Vec<Mark>,
}

/// A mark of a formula.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A character of a font.
    Glyph {
        /// Font of the character.
        face: FontFace,
        /// Character that is drawn.
        character: char,
        /// The start of its baseline.
        at: [f32; 2],
        /// Size of the character, em.
        size: f32,
    },
    /// A filled rectangle.
    Rule {
        /// Least x and y of the rectangle.
        min: [f32; 2],
        /// Width and height of the rectangle.
        size: [f32; 2],
    },
    /// Closed curves, as polygons: what is inside is filled (nonzero winding).
    Area(Vec<Vec<[f32; 2]>>),
}

impl Formula {
    /// The formula in `tex`, without dollar signs.
    ///
    /// # Errors
    ///
    /// What `tex` has that is no TeX, or is not among the fonts.
    pub fn new(tex: &str, style: Style) -> Result<Self, FormulaError> {
        let nodes = nodes(tex)?;
        Self::from_nodes(&nodes, tex, style).map_err(|reason| FormulaError::new(tex, &reason))
    }

    /// Returns the formulas between the wide spaces (`\quad`, `\qquad`) in `tex`, which are put below each
    /// other if there is no room for all of them beside each other.
    ///
    /// # Errors
    ///
    /// As [`Formula::new`].
    pub fn parts(tex: &str, style: Style) -> Result<Vec<Self>, FormulaError> {
        let nodes = nodes(tex)?;
        let is_wide = |node: &ParseNode| match node {
            ParseNode::Kern { dimension, .. } => dimension.unit == "em" && dimension.number >= 1.0,
            _ => false,
        };
        let parts = nodes.split(is_wide).filter(|part| !part.is_empty());
        let parts: Result<_, _> = parts.map(|part| Self::from_nodes(part, tex, style)).collect();
        parts.map_err(|reason| FormulaError::new(tex, &reason))
    }

    fn from_nodes(nodes: &[ParseNode], tex: &str, style: Style) -> Result<Self, String> {
        let style = match style {
            Style::Inline => MathStyle::Text,
            Style::Displayed => MathStyle::Display,
        };
        let laid_out = ratex_layout::layout(nodes, &LayoutOptions { style, ..LayoutOptions::default() });
        ratex_layout::validate_layout(&laid_out)?;
        let list = ratex_layout::to_display_list(&laid_out);
        let formula = Self {
            words: words::in_words(nodes).unwrap_or_else(|| on_one_line(tex)),
            width: list.width as f32,
            ascent: list.height as f32,
            descent: list.depth as f32,
            marks: list.items.iter().map(|item| mark(item, list.height)).collect::<Result<_, _>>()?,
        };
        if formula.is_drawable() {
            Ok(formula)
        } else {
            Err(format!("it reaches further than {} em from where it begins", sizes::FORMULA_EM))
        }
    }

    /// Whether all that is drawn is near enough for numbers of a page.
    fn is_drawable(&self) -> bool {
        let is_near = |lengths: &[f32]| lengths.iter().all(|length| length.abs() <= sizes::FORMULA_EM);
        is_near(&[self.width, self.ascent, self.descent])
            && self.marks.iter().all(|mark| match mark {
                Mark::Glyph { at, size, .. } => is_near(at) && is_near(&[*size]),
                Mark::Rule { min, size } => is_near(min) && is_near(size),
                Mark::Area(contours) => contours.iter().flatten().all(|point| is_near(point)),
            })
    }
}

fn nodes(tex: &str) -> Result<Vec<ParseNode>, FormulaError> {
    if tex.len() > sizes::FORMULA_BYTES {
        let reason = format!("it is longer than {} bytes", sizes::FORMULA_BYTES);
        return Err(FormulaError::new(tex, &reason));
    }
    ratex_parser::parse(tex).map_err(|error| FormulaError::new(tex, &error.message))
}

impl FormulaError {
    fn new(tex: &str, reason: &str) -> Self {
        Self { tex: messages::excerpt(&on_one_line(tex)), reason: messages::excerpt(&on_one_line(reason)) }
    }
}

fn on_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// `item` with y from the baseline, which is at `baseline`.
fn mark(item: &DisplayItem, baseline: f64) -> Result<Mark, String> {
    let point = |x: f64, y: f64| [x as f32, (y - baseline) as f32];
    match item {
        DisplayItem::GlyphPath { x, y, scale, font, char_code, .. } => {
            let (face, character) = faces::glyph(font, *char_code)?;
            Ok(Mark::Glyph { face, character, at: point(*x, *y), size: *scale as f32 })
        }
        DisplayItem::Line { x, y, width, thickness, .. } => {
            let size = [*width as f32, *thickness as f32];
            Ok(Mark::Rule { min: point(*x, y - thickness / 2.0), size })
        }
        DisplayItem::Rect { x, y, width, height, .. } => {
            Ok(Mark::Rule { min: point(*x, *y), size: [*width as f32, *height as f32] })
        }
        DisplayItem::Path { fill: false, .. } => Err("it has lines that are not filled".to_owned()),
        DisplayItem::Path { x, y, commands, .. } => {
            let place = |[dx, dy]: [f64; 2]| point(x + dx, y + dy);
            let contours = flattened(commands);
            Ok(Mark::Area(contours.into_iter().map(|one| one.into_iter().map(place).collect()).collect()))
        }
    }
}

/// The polygons along `commands`.
fn flattened(commands: &[PathCommand]) -> Vec<Vec<[f64; 2]>> {
    /// Pieces of a curve: none is longer than a pixel is wide in a formula of usual size.
    const PIECES: u32 = 12;
    let mut contours: Vec<Vec<[f64; 2]>> = Vec::new();
    let add = |contours: &mut Vec<Vec<[f64; 2]>>, curve: &[[f64; 2]]| {
        let Some(contour) = contours.last_mut() else { return };
        let Some(&start) = contour.last() else { return };
        let curve = [&[start], curve].concat();
        let pieces = if curve.len() == 2 { 1 } else { PIECES };
        contour.extend((1..=pieces).map(|piece| on_curve(&curve, f64::from(piece) / f64::from(pieces))));
    };
    for command in commands {
        match *command {
            PathCommand::MoveTo { x, y } => contours.push(vec![[x, y]]),
            PathCommand::LineTo { x, y } => add(&mut contours, &[[x, y]]),
            PathCommand::QuadTo { x1, y1, x, y } => add(&mut contours, &[[x1, y1], [x, y]]),
            PathCommand::CubicTo { x1, y1, x2, y2, x, y } => {
                add(&mut contours, &[[x1, y1], [x2, y2], [x, y]]);
            }
            PathCommand::Close => {
                let start = contours.last().and_then(|contour| contour.first().copied());
                contours.extend(start.map(|start| vec![start]));
            }
        }
    }
    contours.retain(|contour| contour.len() > 2);
    contours
}

/// The point at `part` of the Bezier curve of these points, by de Casteljau's steps.
fn on_curve(points: &[[f64; 2]], part: f64) -> [f64; 2] {
    let mut points = points.to_vec();
    while points.len() > 1 {
        let between =
            |pair: &[[f64; 2]]| [0, 1].map(|axis| pair[0][axis] + part * (pair[1][axis] - pair[0][axis]));
        points = points.windows(2).map(between).collect();
    }
    points[0]
}
