//! Where formulas stand in Markdown: `$..$` in a line, `$$..$$` on lines of their own.

use pulldown_cmark::{Event, Options, Parser};

use super::{Formula, FormulaError, Style};

/// What Markdown is here: `CommonMark` with tables and formulas.
pub const OPTIONS: Options = Options::ENABLE_TABLES.union(Options::ENABLE_MATH);

/// The first formula in `markdown` that cannot be drawn, and its line, from 1.
#[must_use]
pub fn first_fault(markdown: &str) -> Option<(usize, FormulaError)> {
    Parser::new_ext(markdown, OPTIONS).into_offset_iter().find_map(|(event, range)| {
        let formula = match event {
            Event::InlineMath(tex) => Formula::new(&tex, Style::Inline),
            Event::DisplayMath(tex) => Formula::new(&tex, Style::Displayed),
            _ => return None,
        };
        Some((1 + markdown[..range.start].matches('\n').count(), formula.err()?))
    })
}
