//! Markdown as this program takes it: `CommonMark` with tables and formulas, `$..$` in a line and `$$..$$` on lines of
//! their own. What a file may not do is kept out here, for the window and for pages alike.

use std::fmt;
use std::ops::Range;

use gamow_platform::sizes;
use pulldown_cmark::{CowStr, Event, LinkType, OffsetIter, Options, Parser, Tag, TagEnd};

use super::{Formula, FormulaError, Style};

/// The extensions of Markdown.
pub const OPTIONS: Options = Options::ENABLE_TABLES.union(Options::ENABLE_MATH);

/// The events of a Markdown text with their places. Links to other addresses than [`is_link`] permits are left out, and so
/// is what is nested deeper than [`sizes::NESTED`]: their words stay.
#[must_use]
pub fn events(markdown: &str) -> Events<'_> {
    Events { parser: Parser::new_ext(markdown, OPTIONS).into_offset_iter(), open: Vec::new(), depth: 0 }
}

/// Iterator over the events of a Markdown text.
#[derive(Debug)]
pub struct Events<'a> {
    parser: OffsetIter<'a>,
    /// The elements that are open.
    open: Vec<OpenElement>,
    /// Number of open elements that count towards [`sizes::NESTED`].
    depth: usize,
}

/// An open element of a Markdown text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum OpenElement {
    /// An element that can contain another of its kind, and counts towards the depth.
    Nested,
    /// An element that cannot contain another of its kind.
    Simple,
    /// An element whose tags are dropped, and only its words are kept.
    Dropped,
}

impl<'a> Iterator for Events<'a> {
    type Item = (Event<'a>, Range<usize>);

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let (event, place) = self.parser.next()?;
            let (event, element) = match event {
                Event::Start(tag) => {
                    let tag = with_scheme(tag);
                    let element = self.element(&tag);
                    self.open.push(element);
                    self.depth += usize::from(element == OpenElement::Nested);
                    (Event::Start(tag), element)
                }
                Event::End(tag) => {
                    let element = self.open.pop().unwrap_or(OpenElement::Simple);
                    self.depth -= usize::from(element == OpenElement::Nested);
                    (Event::End(tag), element)
                }
                event => (event, OpenElement::Simple),
            };
            if element != OpenElement::Dropped {
                return Some((event, place));
            }
        }
    }
}

impl Events<'_> {
    fn element(&self, tag: &Tag<'_>) -> OpenElement {
        match tag {
            Tag::Link { dest_url, .. } if !is_link(dest_url) => OpenElement::Dropped,
            // The items go with their list.
            Tag::Item if self.open.last() == Some(&OpenElement::Dropped) => OpenElement::Dropped,
            tag if !can_nest(tag.to_end()) => OpenElement::Simple,
            _ if self.depth >= sizes::NESTED => OpenElement::Dropped,
            _ => OpenElement::Nested,
        }
    }
}

/// Whether an element can hold another one of its kind.
const fn can_nest(tag: TagEnd) -> bool {
    use TagEnd::{BlockQuote, Emphasis, Image, Link, List, Strong};
    matches!(tag, BlockQuote(_) | List(_) | Emphasis | Strong | Link | Image)
}

/// A link to an address of mail with `mailto:` before it.
fn with_scheme(tag: Tag<'_>) -> Tag<'_> {
    match tag {
        Tag::Link { link_type: LinkType::Email, dest_url, title, id } => {
            let dest_url = CowStr::from(format!("mailto:{dest_url}"));
            Tag::Link { link_type: LinkType::Inline, dest_url, title, id }
        }
        tag => tag,
    }
}

/// Whether a text may link to `address`: to a page of the web, to somebody's mail, or to a place in the same text.
#[must_use]
pub fn is_link(address: &str) -> bool {
    let begins =
        |scheme: &str| address.get(..scheme.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(scheme));
    let is_plain = !address.chars().any(|letter| letter.is_control() || letter.is_whitespace());
    is_plain && ["https://", "http://", "mailto:", "#"].into_iter().any(begins)
}

/// A part of a Markdown text that cannot be shown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fault {
    /// A formula that cannot be drawn.
    Formula(FormulaError),
    /// More formulas than a text may have.
    Formulas,
    /// Quotes, lists or emphasis that are nested too deeply.
    Nested,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Formula(error) => error.fmt(f),
            Self::Formulas => write!(f, "a text has at most {} formulas", sizes::FORMULAS),
            Self::Nested => {
                write!(f, "quotes, lists and emphasis may be nested at most {} deep", sizes::NESTED)
            }
        }
    }
}

/// The first part of `markdown` that cannot be shown, and its line, from 1.
#[must_use]
pub fn first_fault(markdown: &str) -> Option<(usize, Fault)> {
    let (mut depth, mut formulas) = (0_usize, 0_usize);
    let mut drawn = |tex: &str, style: Style| {
        formulas += 1;
        if formulas > sizes::FORMULAS {
            return Some(Fault::Formulas);
        }
        Formula::new(tex, style).err().map(Fault::Formula)
    };
    Parser::new_ext(markdown, OPTIONS).into_offset_iter().find_map(|(event, range)| {
        let fault = match event {
            Event::InlineMath(tex) => drawn(&tex, Style::Inline),
            Event::DisplayMath(tex) => drawn(&tex, Style::Displayed),
            Event::Start(tag) if can_nest(tag.to_end()) => {
                depth += 1;
                (depth > sizes::NESTED).then_some(Fault::Nested)
            }
            Event::End(tag) if can_nest(tag) => {
                depth -= 1;
                None
            }
            _ => None,
        };
        Some((1 + markdown[..range.start].matches('\n').count(), fault?))
    })
}
