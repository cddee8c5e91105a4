//! The outline of a lesson's Markdown: the parts below its headings, its blocks between fences, its choices.

use std::ops::Range;

use gamow_platform::messages;
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Tag};

use super::wrong::Wrong;
use crate::formula::markdown::Markdown;
use crate::lesson::plan::{Options, Text};

/// The blocks that are no text.
pub const BLOCKS: [&str; 5] = ["state", "play", "number", "point", "curve"];
/// At most this many letters of a title are compared with those that are known.
const EXCERPT: usize = 40;

/// A lesson's Markdown, and what in it is no text.
pub struct Outline {
    markdown: Markdown,
    elements: Vec<Element>,
}

/// A heading, a block or a choice, in the order of the file.
struct Element {
    kind: ElementKind,
    /// The bytes of the file that the element takes.
    range: Range<usize>,
    /// The number of the element's first line, from 1.
    line: usize,
}

enum ElementKind {
    /// A heading of this level.
    Heading(HeadingLevel),
    /// A block of [`BLOCKS`].
    Fenced(FencedBlock),
    /// A choice, and whether it is the right one.
    Choice(Text, bool),
}

/// A block between two fences.
#[derive(Debug, Clone)]
pub struct FencedBlock {
    /// Kind of the block, from its first fence.
    pub kind: String,
    /// Number of the block's first line in the file, from 1.
    pub line: usize,
    /// Lines of the block.
    pub text: String,
}

impl Outline {
    /// Parses `text` after its `first` lines, in which steps may not have titles that nearly are one of
    /// `titles`.
    ///
    /// # Errors
    /// The line of the first block that is unknown or has no end, or of the first slip: a line that looks
    /// like a heading of a lesson and is none. It would otherwise pass in silence, as text.
    pub fn parse(text: &str, first: usize, titles: &[&str]) -> Result<Self, Wrong> {
        // Empty lines before it give each line its number in the file.
        let lines = text.lines().enumerate();
        let lines = lines.map(|(number, line)| if number < first { "" } else { line });
        let markdown = Markdown::new(lines.flat_map(|line| [line, "\n"]).collect::<String>());
        let elements = elements(&markdown)?;
        check_lines(&markdown, &elements, titles)?;
        Ok(Self { markdown, elements })
    }

    /// Returns the parts below the headings of steps; the first has no heading.
    pub fn parts(&self) -> Vec<Part<'_>> {
        let source = self.markdown.source();
        let all = Part {
            source,
            title: "",
            line: 1,
            begin: 0,
            end: source.len(),
            elements: &self.elements,
            is_asked: false,
        };
        all.parts(HeadingLevel::H2)
    }
}

/// Finds the headings, the blocks and the choices that are no parts of anything else.
fn elements(markdown: &Markdown) -> Result<Vec<Element>, Wrong> {
    let (source, events) = (markdown.source(), markdown.events());
    let mut elements = Vec::new();
    let (mut depth, mut line, mut counted) = (0_usize, 1, 0);
    for (number, (event, range)) in events.iter().enumerate() {
        let tag = match event {
            Event::Start(tag) => tag,
            Event::End(_) => {
                depth -= 1;
                continue;
            }
            _ => continue,
        };
        line += source.get(counted..range.start).map_or(0, |passed| passed.matches('\n').count());
        counted = range.start;
        let after = &events[number + 1..];
        let kind = match tag {
            Tag::Heading { level, .. } if depth == 0 => Some(ElementKind::Heading(*level)),
            Tag::CodeBlock(CodeBlockKind::Fenced(kind)) if depth == 0 => {
                let text = after.iter().map_while(|(event, _)| match event {
                    Event::Text(text) => Some(&**text),
                    _ => None,
                });
                let block =
                    FencedBlock { kind: kind.trim().to_owned(), line: line + 1, text: text.collect() };
                block.check(&source[range.clone()])?;
                (!block.kind.is_empty()).then_some(ElementKind::Fenced(block))
            }
            Tag::CodeBlock(CodeBlockKind::Fenced(kind)) if BLOCKS.contains(&kind.trim()) => {
                let problem =
                    format!("a block ```{} stands by itself, not in a list or a quote", kind.trim());
                return Err((line, problem));
            }
            Tag::Item if depth == 1 => after.first().and_then(|(_, first)| {
                let (text, is_right) = choice(source.get(first.start..range.end)?)?;
                Some(ElementKind::Choice(Text { markdown: text, line }, is_right))
            }),
            _ => None,
        };
        elements.extend(kind.map(|kind| Element { kind, range: range.clone(), line }));
        depth += 1;
    }
    Ok(elements)
}

impl FencedBlock {
    /// Whether it has an end and is known; `source` is the block with its fences.
    fn check(&self, source: &str) -> Result<(), Wrong> {
        let (source, line) = (source.trim_start(), self.line - 1);
        let rest = source.trim_start_matches(|sign| source.starts_with(sign));
        let (fence, kind) = (&source[..source.len() - rest.len()], messages::excerpt(&self.kind));
        let endless =
            |place: &str| (line, format!("the block {fence}{kind} has no end: a line {fence}{place}"));
        if let Some(inside) = self.text.lines().position(|line| line.starts_with(fence)) {
            return Err(endless(&format!(" before line {}", self.line + inside)));
        }
        if !source.lines().skip(1).last().is_some_and(|last| last.trim_start().starts_with(fence)) {
            return Err(endless(""));
        }
        if !self.kind.is_empty() && !BLOCKS.contains(&&*self.kind) {
            let known = BLOCKS.join(", ```");
            return Err((
                line,
                format!("unknown block ```{kind}: there are ```{known}, and ``` alone for text"),
            ));
        }
        Ok(())
    }
}

/// Returns the choice that an item of a list is, and whether it is the right one.
fn choice(item: &str) -> Option<(Markdown, bool)> {
    let marks = [("[ ]", false), ("[x]", true), ("[X]", true)];
    let (text, is_right) =
        marks.into_iter().find_map(|(mark, is_right)| Some((item.strip_prefix(mark)?, is_right)))?;
    let lines = text.trim().lines().map(str::trim).collect::<Vec<_>>();
    Some((Markdown::new(lines.join("\n")), is_right))
}

/// Checks that every line outside fenced code that looks like a heading or like the fence of a block is one,
/// and that no title is nearly one of `titles`.
fn check_lines(markdown: &Markdown, elements: &[Element], titles: &[&str]) -> Result<(), Wrong> {
    let code = markdown.events().iter().filter_map(|(event, range)| match event {
        Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(_))) => Some(range),
        _ => None,
    });
    let text = without(markdown.source(), 0..markdown.source().len(), code);
    for (number, line) in text.lines().enumerate() {
        let element = elements.binary_search_by_key(&(number + 1), |element| element.line);
        let is_heading = element.is_ok_and(|index| matches!(elements[index].kind, ElementKind::Heading(_)));
        let kind = line.trim_start().trim_start_matches(['`', '~']);
        if line.trim_start().len() >= kind.len() + 3 && BLOCKS.contains(&kind.trim()) {
            let problem = format!("a block ```{} cannot stand in HTML or behind four spaces", kind.trim());
            return Err((number + 1, problem));
        }
        let marks = line.trim_start().chars().take_while(|c| *c == '#').count();
        if is_heading || (1..=6).contains(&marks) {
            let slip = slip(line, marks, is_heading, titles);
            slip.map_or(Ok(()), |problem| Err((number + 1, problem)))?;
        }
    }
    Ok(())
}

/// Returns the title in the line of a heading, without the marks before it and behind it.
fn title_of(line: &str) -> &str {
    let title = line.trim().trim_start_matches('#').trim();
    let opened = title.trim_end_matches('#');
    if opened.is_empty() || opened.ends_with([' ', '\t']) { opened.trim_end() } else { title }
}

/// Finds what is wrong with a `line` that begins with this many `marks` of a heading, or is one.
fn slip(line: &str, marks: usize, is_heading: bool, titles: &[&str]) -> Option<String> {
    let after = &line.trim_start()[marks..];
    let title = title_of(line);
    let right = format!("{} {}", "#".repeat(marks.clamp(2, 3)), messages::excerpt(title));
    let (is_indented, line) = (line.starts_with([' ', '\t']), messages::excerpt(line));
    if marks == 0 {
        return Some(format!(
            "`{line}`: a line of `-` or `=` below makes it a heading, which is written `{right}`; a rule has an empty line before it"
        ));
    }
    if !after.is_empty() && !after.starts_with([' ', '\t']) {
        return Some(format!("`{line}`: a heading has a space behind its marks: `{right}`"));
    }
    if is_indented || !(2..=3).contains(&marks) {
        return Some(format!(
            "`{line}`: a heading begins its line, with `## ` for a step or `### ` for a part of it: `{right}`"
        ));
    }
    if !is_heading {
        return Some(format!("`{line}`: in HTML there is no heading; an empty line ends the HTML"));
    }
    let sought: String = title.to_lowercase().chars().take(EXCERPT).collect();
    let near = titles.iter().find(|known| {
        title != **known && strsim::damerau_levenshtein(&known.to_lowercase(), &sought) <= known.len() / 6
    });
    let near = near.filter(|_| marks == 2)?;
    Some(format!("a heading `## {}`: it would be a step; write `## {near}`", messages::excerpt(title)))
}

/// Returns a `range` of `source` with empty lines in the places of these `gaps` in it: its lines keep their
/// numbers.
fn without<'a>(source: &str, range: Range<usize>, gaps: impl Iterator<Item = &'a Range<usize>>) -> String {
    let (mut text, mut from) = (String::new(), range.start);
    for gap in gaps {
        text += &source[from..gap.start];
        text.extend(source[gap.clone()].matches('\n'));
        from = gap.end;
    }
    text + &source[from..range.end]
}

/// A part of a lesson: the text below a heading.
#[derive(Clone, Copy)]
pub struct Part<'a> {
    source: &'a str,
    /// Heading of the part; empty for the text before the first.
    pub title: &'a str,
    /// The line of its heading, from 1; the first line of all, if it has none.
    pub line: usize,
    /// The place behind its heading.
    begin: usize,
    end: usize,
    elements: &'a [Element],
    /// Whether its choices are no text.
    is_asked: bool,
}

impl Part<'_> {
    /// Returns the parts of it below the headings of this `level`; the first is what comes before these.
    pub fn parts(self, level: HeadingLevel) -> Vec<Self> {
        let is_heading =
            |element: &Element| matches!(element.kind, ElementKind::Heading(found) if found == level);
        let (mut parts, mut part) = (Vec::new(), self);
        while let Some(index) = part.elements.iter().position(is_heading) {
            let (heading, end) = (&part.elements[index], part.end);
            parts.push(Part { end: heading.range.start, elements: &part.elements[..index], ..part });
            let title = title_of(&self.source[heading.range.clone()]);
            let elements = &part.elements[index + 1..];
            part = Part { title, line: heading.line, begin: heading.range.end, end, elements, ..part };
        }
        parts.push(part);
        parts
    }

    /// Returns its blocks of the kinds that are `allowed` here, one of each at most; and the rest of its
    /// text.
    pub fn blocks(&self, allowed: &[&str]) -> Result<(Vec<FencedBlock>, Text), Wrong> {
        let (mut blocks, mut gaps): (Vec<FencedBlock>, Vec<&Range<usize>>) = (Vec::new(), Vec::new());
        for Element { kind, range, line } in self.elements {
            match kind {
                ElementKind::Fenced(block) => {
                    let kind = &block.kind;
                    if !allowed.contains(&&**kind) {
                        let allowed = allowed.join(", ```");
                        let problem = format!("a block ```{kind} cannot stand here; these can: ```{allowed}");
                        return Err((*line, problem));
                    }
                    if blocks.iter().any(|known| known.kind == *kind) {
                        return Err((*line, format!("a second block ```{kind}: there can be one here")));
                    }
                    blocks.push(block.clone());
                }
                ElementKind::Choice(..) if self.is_asked => {}
                _ => continue,
            }
            gaps.push(range);
        }
        // The empty lines at both ends are none of the text.
        let text = without(self.source, self.begin..self.end, gaps.into_iter());
        let blank = text.len() - text.trim_start().len();
        if blank == text.len() {
            return Ok((blocks, Text::default()));
        }
        let first = text[..blank].rfind('\n').map_or(0, |end| end + 1);
        let lines = [&self.source[..self.begin], &text[..first]].map(|before| before.matches('\n').count());
        let markdown = Markdown::new(text[first..].trim_end());
        Ok((blocks, Text { markdown, line: lines[0] + lines[1] + 1 }))
    }

    /// Returns its choices, if it has any, and the part without them.
    pub fn options(self) -> Result<(Option<Options>, Self), Wrong> {
        let choices = self.elements.iter().filter_map(|element| match &element.kind {
            ElementKind::Choice(text, is_right) => Some((text.clone(), *is_right)),
            _ => None,
        });
        let (texts, marks): (Vec<_>, Vec<_>) = choices.unzip();
        let right: Vec<_> = (0..marks.len()).filter(|number| marks[*number]).collect();
        let rest = Self { is_asked: true, ..self };
        match right[..] {
            _ if texts.is_empty() => Ok((None, rest)),
            [right] if texts.len() >= 2 => Ok((Some(Options { texts, right }), rest)),
            _ => {
                let problem = "a list of choices has at least two, of which just one is right: `- [x] …`";
                Err((self.line, problem.to_owned()))
            }
        }
    }
}
