//! Markdown as paragraphs, lists and tables.

use std::ops::Range;
use std::slice;
use std::sync::Arc;

use pulldown_cmark::{Alignment, Event, HeadingLevel, Tag, TagEnd};

use crate::formula::markdown::Markdown;
use crate::formula::{Formula, Style};

/// The kind of words.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum WordKind {
    #[default]
    Words,
    Code,
    /// A formula that cannot be drawn, as it is in the text.
    Wrong,
}

/// The look of words.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct WordStyle {
    pub is_strong: bool,
    pub is_slanted: bool,
    pub kind: WordKind,
    /// The number of the link that they are part of, among those of the text.
    pub link: Option<usize>,
}

/// A part of a paragraph.
#[derive(Debug, Clone)]
pub enum InlineItem {
    /// A word that is not divided, without spaces.
    Word(String, WordStyle),
    Space(WordStyle),
    /// A place where a line may end without a space.
    Chance,
    Formula(Arc<Formula>, WordStyle),
    /// A formula on a line of its own, or its parts on a line each.
    Displayed(Arc<Formula>, Vec<Arc<Formula>>, WordStyle),
    /// The end of a line.
    Break,
}

/// A part of a text.
#[derive(Debug)]
pub enum TextBlock {
    Paragraph(Vec<InlineItem>),
    /// A title, from level 1.
    Title(usize, Vec<InlineItem>),
    /// Items, and the number of the first if they are numbered.
    List(Option<u64>, Vec<Vec<TextBlock>>),
    /// Rows of cells, the first of titles.
    Table(Vec<Alignment>, Vec<Vec<Vec<InlineItem>>>),
    /// Code, as it is.
    Code(String),
    Quote(Vec<TextBlock>),
    Rule,
}

/// A text, and the addresses of its links.
#[derive(Debug, Default)]
pub struct Blocks {
    pub blocks: Vec<TextBlock>,
    pub links: Vec<String>,
}

impl Blocks {
    /// The blocks of this Markdown.
    pub fn new(text: &Markdown) -> Self {
        let mut reader = BlockReader { events: text.events().iter(), links: Vec::new() };
        let blocks = reader.blocks();
        Self { blocks, links: reader.links }
    }
}

struct BlockReader<'a> {
    events: slice::Iter<'a, (Event<'static>, Range<usize>)>,
    links: Vec<String>,
}

impl<'a> BlockReader<'a> {
    fn next(&mut self) -> Option<&'a Event<'static>> {
        self.events.next().map(|(event, _)| event)
    }

    /// The blocks to the end of what holds them.
    fn blocks(&mut self) -> Vec<TextBlock> {
        let mut blocks = Vec::new();
        // Items of a list without blank lines hold their words without a paragraph.
        let mut loose = Vec::new();
        while let Some(event) = self.next() {
            let block = match event {
                Event::End(_) => break,
                Event::Start(Tag::Paragraph) => TextBlock::Paragraph(self.pieces()),
                Event::Start(Tag::Heading { level, .. }) => TextBlock::Title(number(*level), self.pieces()),
                Event::Start(Tag::List(first)) => TextBlock::List(*first, self.items()),
                Event::Start(Tag::Table(alignments)) => TextBlock::Table(alignments.clone(), self.rows()),
                Event::Start(Tag::CodeBlock(_) | Tag::HtmlBlock) => TextBlock::Code(self.code()),
                Event::Start(Tag::BlockQuote(_)) => TextBlock::Quote(self.blocks()),
                Event::Rule => TextBlock::Rule,
                event => {
                    self.add(event, WordStyle::default(), &mut loose);
                    continue;
                }
            };
            if !loose.is_empty() {
                blocks.push(TextBlock::Paragraph(std::mem::take(&mut loose)));
            }
            blocks.push(block);
        }
        if !loose.is_empty() {
            blocks.push(TextBlock::Paragraph(loose));
        }
        blocks
    }

    fn items(&mut self) -> Vec<Vec<TextBlock>> {
        let mut items = Vec::new();
        while let Some(Event::Start(_)) = self.next() {
            items.push(self.blocks());
        }
        items
    }

    fn rows(&mut self) -> Vec<Vec<Vec<InlineItem>>> {
        let mut rows: Vec<Vec<Vec<InlineItem>>> = Vec::new();
        while let Some(event) = self.next() {
            match event {
                Event::End(TagEnd::Table) => break,
                Event::Start(Tag::TableHead | Tag::TableRow) => rows.push(Vec::new()),
                Event::Start(Tag::TableCell) => {
                    let look = WordStyle { is_strong: rows.len() == 1, ..WordStyle::default() };
                    let cell = self.pieces_with(look);
                    if let Some(row) = rows.last_mut() {
                        row.push(cell);
                    }
                }
                _ => {}
            }
        }
        rows
    }

    fn code(&mut self) -> String {
        let mut code = String::new();
        while let Some(event) = self.next() {
            match event {
                Event::Text(text) | Event::Html(text) => code.push_str(text),
                Event::End(_) => break,
                _ => {}
            }
        }
        code.trim_end().to_owned()
    }

    /// The pieces to the end of what holds them.
    fn pieces(&mut self) -> Vec<InlineItem> {
        self.pieces_with(WordStyle::default())
    }

    fn pieces_with(&mut self, look: WordStyle) -> Vec<InlineItem> {
        let mut pieces = Vec::new();
        while let Some(event) = self.next() {
            if matches!(event, Event::End(_)) {
                break;
            }
            self.add(event, look, &mut pieces);
        }
        pieces
    }

    fn add(&mut self, event: &Event<'_>, look: WordStyle, pieces: &mut Vec<InlineItem>) {
        match event {
            Event::Text(text) | Event::InlineHtml(text) | Event::Html(text) => add_words(text, look, pieces),
            Event::Code(code) => add_words(code, WordStyle { kind: WordKind::Code, ..look }, pieces),
            Event::InlineMath(tex) => add_formula(tex, Style::Inline, look, pieces),
            Event::DisplayMath(tex) => add_formula(tex, Style::Displayed, look, pieces),
            Event::SoftBreak => pieces.push(InlineItem::Space(look)),
            Event::HardBreak => pieces.push(InlineItem::Break),
            Event::Start(Tag::Strong) => {
                pieces.extend(self.pieces_with(WordStyle { is_strong: true, ..look }));
            }
            // A page has places to go to; a window has not.
            Event::Start(Tag::Link { dest_url, .. }) if dest_url.starts_with('#') => {
                pieces.extend(self.pieces_with(look));
            }
            Event::Start(Tag::Link { dest_url, .. }) => {
                self.links.push(dest_url.to_string());
                let link = Some(self.links.len() - 1);
                pieces.extend(self.pieces_with(WordStyle { link, ..look }));
            }
            // A picture is what it is called.
            Event::Start(_) => pieces.extend(self.pieces_with(WordStyle { is_slanted: true, ..look })),
            _ => {}
        }
    }
}

const fn number(level: HeadingLevel) -> usize {
    level as usize
}

fn add_formula(tex: &str, style: Style, look: WordStyle, pieces: &mut Vec<InlineItem>) {
    let piece = match style {
        Style::Inline => Formula::new(tex, style).map(|formula| InlineItem::Formula(Arc::new(formula), look)),
        Style::Displayed => Formula::new(tex, style).and_then(|whole| {
            let parts = Formula::parts(tex, style)?.into_iter().map(Arc::new).collect();
            Ok(InlineItem::Displayed(Arc::new(whole), parts, look))
        }),
    };
    match piece {
        Ok(piece) => pieces.push(piece),
        Err(_) => add_words(&format!("${tex}$"), WordStyle { kind: WordKind::Wrong, ..look }, pieces),
    }
}

fn add_words(text: &str, look: WordStyle, pieces: &mut Vec<InlineItem>) {
    let mut word = String::new();
    let mut characters = text.chars().peekable();
    let mut last = ' ';
    while let Some(character) = characters.next() {
        if character.is_whitespace() && character != '\u{a0}' {
            end_word(&mut word, look, pieces);
            pieces.push(InlineItem::Space(look));
        } else {
            word.push(character);
            let is_between =
                last.is_alphabetic() && characters.peek().is_some_and(|next| next.is_alphabetic());
            if matches!(character, '-' | '–' | '—' | '/') && is_between {
                end_word(&mut word, look, pieces);
                pieces.push(InlineItem::Chance);
            }
        }
        last = character;
    }
    end_word(&mut word, look, pieces);
}

fn end_word(word: &mut String, look: WordStyle, pieces: &mut Vec<InlineItem>) {
    if !word.is_empty() {
        pieces.push(InlineItem::Word(std::mem::take(word), look));
    }
}
