//! A link as a QR code (ISO/IEC 18004).

use std::fmt::Write as _;

use qrcodegen::{QrCode as Code, QrCodeEcc, QrSegment, Version};

/// Modules of the quiet zone on each side.
const QUIET: u8 = 4;
/// The largest version: 117 modules a side, which a telephone's camera still reads from a screen or a page.
const LARGEST: u8 = 25;

/// A QR code: black and white modules in a square, with the quiet zone around them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct QrCode {
    /// Number of modules of a side, with the quiet zone.
    pub side: usize,
    /// Row by row from the top left.
    modules: Vec<bool>,
}

impl QrCode {
    /// The code of `text`; `None` if that is longer than a code of 117 modules holds, 1273 bytes.
    #[must_use]
    pub fn new(text: &str) -> Option<Self> {
        let segments = QrSegment::make_segments(text);
        let [least, most] = [Version::MIN, Version::new(LARGEST)];
        let code = Code::encode_segments_advanced(&segments, QrCodeEcc::Low, least, most, None, true).ok()?;
        let quiet = i32::from(QUIET);
        let side = code.size() + 2 * quiet;
        let places = (0..side).flat_map(|row| (0..side).map(move |column| (column - quiet, row - quiet)));
        let modules = places.map(|(column, row)| code.get_module(column, row)).collect();
        Some(Self { side: side as usize, modules })
    }

    /// Returns the black parts of all rows: row, first column, and the column behind the last, from 0.
    pub fn runs(&self) -> impl Iterator<Item = [usize; 3]> {
        self.modules.chunks(self.side.max(1)).enumerate().flat_map(|(row, modules)| {
            let runs = modules.chunk_by(|a, b| a == b).scan(0, move |column, run| {
                let first = *column;
                *column += run.len();
                Some((run[0], [row, first, *column]))
            });
            runs.filter(|(is_black, _)| *is_black).map(|(_, run)| run)
        })
    }

    /// Returns the code as an element of a page, with modules of this width in millimetres; `what` describes
    /// it.
    #[must_use]
    pub fn svg(&self, what: &str, module: f64) -> String {
        let (side, width) = (self.side, self.side as f64 * module);
        let mut path = String::new();
        for [row, first, end] in self.runs() {
            let _ = write!(path, "M{first} {row}h{}v1h-{}z", end - first, end - first);
        }
        let what = crate::markup::escaped(what);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{what}\" width=\"{width:.1}mm\" \
             height=\"{width:.1}mm\" viewBox=\"0 0 {side} {side}\" shape-rendering=\"crispEdges\">\
             <rect width=\"{side}\" height=\"{side}\" fill=\"white\"/><path d=\"{path}\"/></svg>\n"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The three finders and the quiet zone stand where the standard has them.
    #[test]
    fn a_code_has_its_finders_inside_a_quiet_zone() {
        let quiet = usize::from(QUIET);
        let code = QrCode::new("gamow:?answers=AQRyb2Rz").expect("it is short");
        let side = code.side;
        let black: std::collections::BTreeSet<[usize; 2]> =
            code.runs().flat_map(|[row, first, end]| (first..end).map(move |column| [row, column])).collect();
        let inside = quiet..side - quiet;
        assert!(black.iter().flatten().all(|place| inside.contains(place)));
        for [top, left] in [[quiet, quiet], [quiet, side - quiet - 7], [side - quiet - 7, quiet]] {
            for row in 0..7_usize {
                for column in 0..7_usize {
                    let ring = row.abs_diff(3).max(column.abs_diff(3));
                    assert_eq!(black.contains(&[top + row, left + column]), ring != 2, "{row} {column}");
                }
            }
        }
    }

    #[test]
    fn a_text_that_is_too_long_has_none() {
        assert!(QrCode::new(&"a".repeat(1273)).is_some());
        assert_eq!(QrCode::new(&"a".repeat(1274)), None);
    }
}
