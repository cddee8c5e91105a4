//! A formula as an inline SVG, which is part of a line of text and has its colour.

use std::fmt::Write as _;

use skrifa::outline::OutlinePen;

use super::{EM, Formula, Mark};
use crate::markup::escaped;

/// Units of the drawing in an em: those of the fonts.
const UNITS: f32 = 1000.0;

impl Formula {
    /// Returns the formula as an element of a page: as large as the text around, its baseline on that of the
    /// text, named by its words.
    #[must_use]
    pub fn svg(&self) -> String {
        let units = |em: f32| (em * UNITS).round();
        let mut body = String::new();
        for mark in &self.marks {
            write_mark(&mut body, mark);
        }
        format!(
            "<svg class=\"formula\" role=\"img\" aria-label=\"{}\" viewBox=\"0 {} {} {}\" \
             style=\"width:{:.3}em;height:{:.3}em;vertical-align:{:.3}em\" fill=\"currentColor\">{body}</svg>",
            escaped(&self.words),
            units(-self.ascent),
            units(self.width),
            units(self.ascent + self.descent),
            EM * self.width,
            EM * (self.ascent + self.descent),
            -EM * self.descent,
        )
    }
}

fn write_mark(svg: &mut String, mark: &Mark) {
    // Writing to a string cannot fail.
    let _ = match mark {
        Mark::Glyph { face, character, at: [x, y], size } => {
            let mut path = PathData::default();
            let Some(units) = face.draw(*character, &mut path) else { return };
            let scale = size * UNITS / units;
            let (x, y) = (x * UNITS, y * UNITS);
            write!(
                svg,
                "<path transform=\"translate({x:.1} {y:.1}) scale({scale:.3} {:.3})\" d=\"{}\"/>",
                -scale, path.0
            )
        }
        Mark::Rule { min: [x, y], size: [width, height] } => {
            let [x, y, width, height] = [x, y, width, height].map(|length| length * UNITS);
            write!(svg, "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\"/>")
        }
        Mark::Area(contours) => {
            let mut path = PathData::default();
            for contour in contours {
                for (index, [x, y]) in contour.iter().enumerate() {
                    path.add(if index == 0 { 'M' } else { 'L' }, &[x * UNITS, y * UNITS]);
                }
                path.add('Z', &[]);
            }
            write!(svg, "<path d=\"{}\"/>", path.0)
        }
    };
}

/// The `d` of a path.
#[derive(Debug, Default)]
struct PathData(String);

impl PathData {
    fn add(&mut self, letter: char, numbers: &[f32]) {
        self.0.push(letter);
        for (index, number) in numbers.iter().enumerate() {
            let _ = write!(self.0, "{}{}", if index == 0 { "" } else { " " }, number.round());
        }
    }
}

impl OutlinePen for PathData {
    fn move_to(&mut self, x: f32, y: f32) {
        self.add('M', &[x, y]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.add('L', &[x, y]);
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        self.add('Q', &[cx, cy, x, y]);
    }

    fn curve_to(&mut self, cx0: f32, cy0: f32, cx1: f32, cy1: f32, x: f32, y: f32) {
        self.add('C', &[cx0, cy0, cx1, cy1, x, y]);
    }

    fn close(&mut self) {
        self.add('Z', &[]);
    }
}
