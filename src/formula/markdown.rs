//! Markdown as this program takes it: `CommonMark` with tables and formulas, `$..$` in a line and `$$..$$` on
//! lines of their own. What a file may not do is kept out here, for the window and for pages alike.

use std::fmt;
use std::ops::Range;
use std::sync::OnceLock;

use gamow_platform::sizes;
use pulldown_cmark::{CowStr, Event, LinkType, OffsetIter, Options, Parser, Tag, TagEnd};
use serde::{Deserialize, Serialize};

use super::{Formula, FormulaError, Style};

/// The extensions of Markdown.
const OPTIONS: Options = Options::ENABLE_TABLES.union(Options::ENABLE_MATH);

/// A text in Markdown. The first call of [`Self::events`] parses it; what checks it, shows it in the window
/// or writes it to a page goes over the same events. Texts are equal if their sources are; only these are
/// stored.
#[derive(Clone, Default, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
pub struct Markdown {
    source: String,
    parsed: OnceLock<Parsed>,
}

/// The events of a text, with their places in its source.
#[derive(Clone)]
struct Parsed {
    events: Vec<(Event<'static>, Range<usize>)>,
    /// The place of the first element that is nested too deeply.
    too_deep: Option<usize>,
}

impl Markdown {
    /// Returns the text that `source` is.
    #[must_use]
    pub fn new(source: impl Into<String>) -> Self {
        Self { source: source.into(), parsed: OnceLock::new() }
    }

    /// Returns the text as it is written.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// Returns the events with their places in the source. Links to other addresses than [`is_link`] permits
    /// are left out, and so is what is nested deeper than [`sizes::NESTED`]: their words stay.
    #[must_use]
    pub fn events(&self) -> &[(Event<'static>, Range<usize>)] {
        &self.parsed().events
    }

    /// Returns the events that are not inside a block of code.
    pub fn events_outside_code(&self) -> impl Iterator<Item = &(Event<'static>, Range<usize>)> {
        let mut is_code = false;
        self.events().iter().filter(move |(event, _)| {
            match event {
                Event::Start(Tag::CodeBlock(_)) => is_code = true,
                Event::End(TagEnd::CodeBlock) => is_code = false,
                _ => {}
            }
            !is_code
        })
    }

    /// Returns the line of a place in the source, from 0.
    #[must_use]
    pub fn line(&self, place: usize) -> usize {
        self.source[..place].matches('\n').count()
    }

    /// Returns the first part that cannot be shown, and its line, from 0.
    #[must_use]
    pub fn first_fault(&self) -> Option<(usize, Fault)> {
        let mut formulas = 0_usize;
        let mut drawn = |tex: &str, style: Style| {
            formulas += 1;
            if formulas > sizes::FORMULAS {
                return Some(Fault::Formulas);
            }
            Formula::new(tex, style).err().map(Fault::Formula)
        };
        let fault = self.events_outside_code().find_map(|(event, range)| match event {
            Event::InlineMath(tex) => Some((range.start, drawn(tex, Style::Inline)?)),
            Event::DisplayMath(tex) => Some((range.start, drawn(tex, Style::Displayed)?)),
            Event::Text(_) => {
                let place = range.start + self.source[range.clone()].find('$')?;
                (!self.is_escaped(place)).then_some((place, Fault::Dollar))
            }
            _ => None,
        });
        let too_deep = self.parsed().too_deep.map(|place| (place, Fault::Nested));
        let (place, fault) = [too_deep, fault].into_iter().flatten().min_by_key(|(place, _)| *place)?;
        Some((self.line(place), fault))
    }

    /// Returns whether the sign at a place of the source has a backslash before it.
    #[must_use]
    pub fn is_escaped(&self, place: usize) -> bool {
        self.source[..place].ends_with('\\')
    }

    fn parsed(&self) -> &Parsed {
        self.parsed.get_or_init(|| {
            let parser = Parser::new_ext(&self.source, OPTIONS).into_offset_iter();
            let mut events = Events { parser, open: Vec::new(), depth: 0, too_deep: None };
            let kept = events.by_ref().map(|(event, place)| (event.into_static(), place)).collect();
            Parsed { events: kept, too_deep: events.too_deep }
        })
    }
}

impl From<String> for Markdown {
    fn from(source: String) -> Self {
        Self::new(source)
    }
}

impl From<Markdown> for String {
    fn from(text: Markdown) -> Self {
        text.source
    }
}

impl PartialEq for Markdown {
    fn eq(&self, other: &Self) -> bool {
        self.source == other.source
    }
}

impl Eq for Markdown {}

impl fmt::Debug for Markdown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.source.fmt(f)
    }
}

/// Iterator over the events of a Markdown text that are kept.
struct Events<'a> {
    parser: OffsetIter<'a>,
    /// The elements that are open.
    open: Vec<OpenElement>,
    /// Number of open elements that count towards [`sizes::NESTED`].
    depth: usize,
    /// The place of the first element that is nested deeper.
    too_deep: Option<usize>,
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
                    let element = self.element(&tag, place.start);
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
    /// Returns how to treat the element that begins at `place`.
    fn element(&mut self, tag: &Tag<'_>, place: usize) -> OpenElement {
        match tag {
            Tag::Link { dest_url, .. } if !is_link(dest_url) => OpenElement::Dropped,
            // The items go with their list.
            Tag::Item if self.open.last() == Some(&OpenElement::Dropped) => OpenElement::Dropped,
            tag if !can_nest(tag.to_end()) => OpenElement::Simple,
            _ if self.depth >= sizes::NESTED => {
                self.too_deep.get_or_insert(place);
                OpenElement::Dropped
            }
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

/// Whether a text may link to `address`: to a page of the web, to somebody's mail, or to a place in the same
/// text.
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
    /// A dollar sign that begins no formula.
    Dollar,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Formula(error) => error.fmt(f),
            Self::Formulas => write!(f, "a text has at most {} formulas", sizes::FORMULAS),
            Self::Nested => {
                write!(f, "quotes, lists and emphasis may be nested at most {} deep", sizes::NESTED)
            }
            Self::Dollar => f.write_str(
                "a `$` without another one that ends its formula in the same paragraph; `\\$` is a dollar sign",
            ),
        }
    }
}
