//! The outlines of the letters in a line of text, for pictures.

use ratex_types::path_command::PathCommand;
use skrifa::outline::OutlinePen;

use super::{FontFace, flattened};

/// Height of capitals, em.
pub const CAPITALS: f64 = 0.686;
/// The size of a raised digit, em, and how far its baseline is raised, em.
const RAISED: (f64, f64) = (0.7, 0.3);

/// Returns the outlines of `text` in bold letters, and its width: closed polygons, around which the winding
/// is not zero, in em from the start of the baseline, y down. Characters that the font lacks are left out.
#[must_use]
pub fn outlines(text: &str) -> (Vec<Vec<[f64; 2]>>, f64) {
    let (mut outlines, mut end) = (Vec::new(), 0.0);
    for letter in text.chars() {
        let (letter, (size, rise)) = match letter {
            '²' => ('2', RAISED),
            '³' => ('3', RAISED),
            '⁴' => ('4', RAISED),
            _ => (letter, (1.0, 0.0)),
        };
        let mut path = Path::default();
        let Some((units, advance)) =
            FontFace::Bold.draw(letter, &mut path).zip(FontFace::Bold.advance(letter))
        else {
            continue;
        };
        let scale = size / f64::from(units);
        let place = |[x, y]: [f64; 2]| [end + scale * x, -scale * y - rise];
        outlines.extend(flattened(&path.0).into_iter().map(|one| one.into_iter().map(place).collect()));
        end += size * f64::from(advance);
    }
    (outlines, end)
}

/// The commands that draw a letter.
#[derive(Debug, Default)]
struct Path(Vec<PathCommand>);

impl OutlinePen for Path {
    fn move_to(&mut self, x: f32, y: f32) {
        let [x, y] = [x, y].map(f64::from);
        self.0.push(PathCommand::MoveTo { x, y });
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let [x, y] = [x, y].map(f64::from);
        self.0.push(PathCommand::LineTo { x, y });
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let [x1, y1, x, y] = [x1, y1, x, y].map(f64::from);
        self.0.push(PathCommand::QuadTo { x1, y1, x, y });
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let [x1, y1, x2, y2, x, y] = [x1, y1, x2, y2, x, y].map(f64::from);
        self.0.push(PathCommand::CubicTo { x1, y1, x2, y2, x, y });
    }

    fn close(&mut self) {
        self.0.push(PathCommand::Close);
    }
}
